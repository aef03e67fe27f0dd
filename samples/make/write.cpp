// SPDX-License-Identifier: Apache-2.0
#include "write.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace samples {

namespace {

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

void append_little_endian(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(value >> shift & 0xff);
  }
}

void append(std::string& bytes, const Point& p) {
  for (const double x : p) {
    append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  }
}

}  // namespace

std::string to_obj(const Model& model) {
  std::string text = "# millimetres, z up\n";
  std::size_t first = 1;
  for (const Solid& solid : model) {
    text.append("o ").append(solid.name()).append("\n");
    for (const Point& p : solid.points()) {
      text += 'v';
      for (const double x : p) {
        text.append(" ").append(number(x));
      }
      text += '\n';
    }
    for (const std::vector<int>& face : solid.faces()) {
      text += 'f';
      for (const int corner : face) {
        text.append(" ").append(std::to_string(first + static_cast<std::size_t>(corner)));
      }
      text += '\n';
    }
    first += solid.points().size();
  }
  return text;
}

std::string to_stl(const Model& model) {
  std::string triangles;
  std::uint32_t count = 0;
  for (const Solid& solid : model) {
    for (const std::vector<int>& face : solid.faces()) {
      const Loop p = solid.corners(face);
      const Point normal = area_vector(p);
      for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        append(triangles, (1 / std::sqrt(dot(normal, normal))) * normal);
        append(triangles, p[0]);
        append(triangles, p[i]);
        append(triangles, p[i + 1]);
        triangles += std::string(2, '\0');
        ++count;
      }
    }
  }
  std::string bytes = "millimetres, z up";
  bytes.resize(80, ' ');
  append_little_endian(bytes, count);
  return bytes + triangles;
}

}  // namespace samples
