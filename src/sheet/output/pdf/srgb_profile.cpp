// SPDX-License-Identifier: Apache-2.0
// A profile of sRGB (IEC 61966-2-1) in the form of ICC.1:2010 (4.3), of this program's own.
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "output/pdf/archive.hpp"

namespace epura::output {

namespace {

void append_number(std::string& bytes, std::uint32_t number, int size = 4) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255);
}

// s15Fixed16Number, 4.6.
void append_fixed(std::string& bytes, double number) {
  append_number(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(number * 65536))));
}

template <std::size_t count>
std::string numbers(const char* type, const std::array<double, count>& values) {
  std::string bytes = type + std::string(4, '\0');
  for (const double value : values) append_fixed(bytes, value);
  return bytes;
}

// 10.13: one text, in English of the United States.
std::string text(const std::string& words) {
  std::string bytes = "mluc" + std::string(4, '\0');
  append_number(bytes, 1);
  append_number(bytes, 12);
  bytes += "enUS";
  append_number(bytes, static_cast<std::uint32_t>(2 * words.size()));
  append_number(bytes, 28);
  for (const char c : words) bytes += std::string(1, '\0') + c;
  return bytes;
}

// 10.16, function type 3: linear below a limit.
std::string curve() {
  std::string bytes = "para" + std::string(4, '\0');
  append_number(bytes, 3, 2);
  append_number(bytes, 0, 2);
  for (const double value : {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045}) append_fixed(bytes, value);
  return bytes;
}

// 7.2. No date but a fixed one: the same bytes each time.
std::string header(std::size_t size) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(size));
  append_number(bytes, 0);
  append_number(bytes, 0x04300000);
  bytes += "mntrRGB XYZ ";
  for (const std::uint32_t part : {2026, 1, 1, 0, 0, 0}) append_number(bytes, part, 2);
  bytes += "acsp";
  bytes += std::string(28, '\0');
  for (const double value : {0.9642, 1.0, 0.8249}) append_fixed(bytes, value);
  return bytes + std::string(48, '\0');
}

}  // namespace

std::string srgb_profile() {
  using Triple = std::array<double, 3>;
  // Colorants and white are those of D65 adapted to D50 by the linear Bradford transform, `chad`.
  const std::vector<std::pair<std::string, std::string>> tags{
      {"desc", text("sRGB")},
      {"cprt", text("No copyright, use freely")},
      {"wtpt", numbers("XYZ ", Triple{0.9642, 1, 0.8249})},
      {"chad", numbers("sf32", std::array<double, 9>{1.04788, 0.02292, -0.05022, 0.02959, 0.99048, -0.01707, -0.00925,
                                                     0.01508, 0.75168})},
      {"rXYZ", numbers("XYZ ", Triple{0.43607, 0.22249, 0.01392})},
      {"gXYZ", numbers("XYZ ", Triple{0.38515, 0.71687, 0.09708})},
      {"bXYZ", numbers("XYZ ", Triple{0.14307, 0.06061, 0.7141})},
      {"rTRC", curve()},
      {"gTRC", curve()},
      {"bTRC", curve()}};
  constexpr std::size_t header_bytes = 128;
  std::string table, data;
  append_number(table, static_cast<std::uint32_t>(tags.size()));
  for (const auto& [name, content] : tags) {
    const std::size_t begin = header_bytes + 4 + 12 * tags.size() + data.size();
    table += name;
    append_number(table, static_cast<std::uint32_t>(begin));
    append_number(table, static_cast<std::uint32_t>(content.size()));
    data += content;
    while (data.size() % 4 != 0) data += '\0';
  }
  return header(header_bytes + table.size() + data.size()) + table + data;
}

}  // namespace epura::output
