// SPDX-License-Identifier: Apache-2.0
// Recognises files of the three formats by their beginning.
#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

#include "readers.hpp"

namespace occt {

bool is_step(std::string_view first_bytes) {
  // Comments and spaces may precede it.
  return first_bytes.find("ISO-10303-21") != std::string_view::npos;
}

/// Lines have 80 columns; column 73 has the letter of the section, which is S (start) for the first one.
bool is_iges(std::string_view first_bytes) {
  constexpr std::size_t section = 72, width = 80;
  if (first_bytes.size() < width || first_bytes[section] != 'S') return false;
  const std::string_view number = first_bytes.substr(section + 1, width - section - 1);
  return first_bytes.substr(0, section).find_first_of("\r\n") == std::string_view::npos &&
         number.find_first_not_of(" 0123456789") == std::string_view::npos;
}

bool is_brep(std::string_view first_bytes) {
  constexpr std::size_t preamble = 200;
  const std::string_view start = first_bytes.substr(0, preamble);
  return start.find("DBRep_DrawableShape") != std::string_view::npos ||
         start.find("CASCADE Topology") != std::string_view::npos;
}

void expect_kind(const std::string& path, bool (*recognises)(std::string_view), const std::string& what) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot be opened");
  std::array<char, 4096> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view start(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (start.empty()) throw std::runtime_error("the file is empty");
  if (!recognises(start)) throw std::runtime_error("is not " + what);
}

std::string end_of(const std::string& path) {
  constexpr std::streamoff tail = 65536;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  const std::streamoff start = std::max<std::streamoff>(0, size - tail);
  std::string bytes(static_cast<std::size_t>(size - start), '\0');
  file.seekg(start);
  file.read(bytes.data(), size - start);
  if (!file) throw std::runtime_error("cannot be read to its end");
  return bytes;
}

std::runtime_error cut_off(const std::string& path, const std::string& missing) {
  std::ifstream file(path, std::ios::binary);
  std::size_t lines = 0;
  for (std::string line; std::getline(file, line);) ++lines;
  return std::runtime_error("the file is cut off: it ends in line " + std::to_string(lines) + " without " + missing);
}

}  // namespace occt
