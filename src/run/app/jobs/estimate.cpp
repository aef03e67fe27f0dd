// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/estimate.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>

#include "base/text.hpp"
#include "importer/read_model.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

// Measured with 47 models on sheets of three views: docs/scale.md.
constexpr double start = 2000, microseconds_of_triangle = 20;
constexpr double start_of_tessellation = 100'000, microseconds_of_exact_byte = 1.2;

std::string head_of(const fs::path& file) {
  constexpr std::streamsize size = 4096;
  std::string head(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), size);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

double triangles_of_stl(const std::string& head, std::uintmax_t size) {
  constexpr std::size_t header = 80, count_size = 4, facet_size = 50, text_size = 250;
  if (head.size() < header + count_size) return 0;
  std::uintmax_t count = 0;
  for (std::size_t i = header + count_size; i-- > header;) count = 256 * count + static_cast<unsigned char>(head[i]);
  const bool is_binary = size == header + count_size + facet_size * count;
  return static_cast<double>(is_binary ? count : size / text_size);
}

double triangles_of_ply(const std::string& head) {
  constexpr std::string_view element = "element face ";
  const std::size_t at = head.find(element);
  if (at == std::string::npos) return 0;
  const std::size_t begin = at + element.size();
  const std::size_t end = head.find_first_of("\r\n", begin);
  return static_cast<double>(parse_integer(std::string_view(head).substr(begin, end - begin)).value_or(0));
}

// OFF, the number of vertices, and that of faces; comments may stand between them.
double triangles_of_off(const std::string& head) {
  int words = 0;
  for (std::string_view line : split(head, '\n')) {
    line = line.substr(0, line.find_first_of("#\r"));
    for (const std::string_view word : split(line, ' '))
      if (!word.empty() && ++words == 3) return static_cast<double>(parse_integer(word).value_or(0));
  }
  return 0;
}

double triangles_of(const fs::path& file, const std::string& extension, std::uintmax_t size) {
  if (extension == ".stl") return triangles_of_stl(head_of(file), size);
  if (extension == ".ply") return triangles_of_ply(head_of(file));
  if (extension == ".off") return triangles_of_off(head_of(file));
  static const std::map<std::string, double> bytes_of_triangle{{".glb", 30}, {".gltf", 30}, {".3mf", 10}};
  constexpr double bytes_of_text = 35;
  const auto known = bytes_of_triangle.find(extension);
  return static_cast<double>(size) / (known != bytes_of_triangle.end() ? known->second : bytes_of_text);
}

bool is_exact(const std::string& extension) {
  return extension == ".step" || extension == ".stp" || extension == ".iges" || extension == ".igs" ||
         extension == ".brep";
}

}  // namespace

double estimated_time(const std::vector<std::string>& models) {
  double sum = start;
  for (const std::string& model : models) {
    const fs::path file(importer::parse_model_request(model).path);
    const std::string extension = to_lower(file.extension().string());
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(file, missing);
    if (missing) continue;
    sum += is_exact(extension) ? start_of_tessellation + microseconds_of_exact_byte * static_cast<double>(size)
                               : microseconds_of_triangle * triangles_of(file, extension, size);
  }
  return sum;
}

}  // namespace epura
