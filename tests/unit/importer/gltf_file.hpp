// SPDX-License-Identifier: Apache-2.0
// Files of glTF that tests write.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "support.hpp"

namespace epura::test::gltf {

inline void append(std::string& bytes, auto value) {
  auto raw = std::bit_cast<std::array<char, sizeof(value)>>(value);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.begin(), raw.end());
}

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : std::uint32_t{0});
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The numbers of a buffer one after the other, and the views of it.
struct Buffer {
  std::string bytes, views;

  template <class T>
  int view(const std::vector<T>& numbers, const std::string& more = "") {
    const std::size_t begin = bytes.size();
    for (const T number : numbers) append(bytes, number);
    views += std::string(views.empty() ? "" : ",") + "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
             ",\"byteLength\":" + std::to_string(bytes.size() - begin) + more + "}";
    while (bytes.size() % 4 != 0) bytes += '\0';
    return count++;
  }
  int count = 0;
};

inline const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
inline const std::vector<std::uint16_t> cube{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                             2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

inline std::string accessor(int view, int component, std::size_t count, const std::string& type,
                            const std::string& more = "") {
  return "{\"bufferView\":" + std::to_string(view) + ",\"componentType\":" + std::to_string(component) +
         ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" + more + "}";
}

/// A file with all of its parts; what is not said is that of a cube with a unit of a metre.
struct File {
  Buffer buffer{};
  std::string accessors{}, primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  std::string nodes = R"({"mesh":0})", rest = R"(,"scene":0,"scenes":[{"nodes":[0]}])";
  std::string uri{};  ///< of the buffer; empty: it is in the file

  [[nodiscard]] std::string json(bool has_data) const {
    const std::string data = uri.empty() ? "data:application/octet-stream;base64," + base64(buffer.bytes) : uri;
    return R"({"asset":{"version":"2.0"},"buffers":[{)" + (has_data ? "\"uri\":\"" + data + "\"," : "") +
           "\"byteLength\":" + std::to_string(buffer.bytes.size()) + "}],\"bufferViews\":[" + buffer.views +
           "],\"accessors\":[" + accessors + "],\"meshes\":[{\"name\":\"cube\",\"primitives\":[" + primitives +
           "]}],\"nodes\":[" + nodes + "]" + rest + "}";
  }

  [[nodiscard]] std::string binary() const {
    std::string text = json(false), bytes = "glTF";
    while (text.size() % 4 != 0) text += ' ';
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(28 + text.size() + buffer.bytes.size()));
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON" + text;
    append(bytes, static_cast<std::uint32_t>(buffer.bytes.size()));
    return bytes + std::string("BIN\0", 4) + buffer.bytes;
  }
};

inline File cube_file() {
  File file;
  file.accessors = accessor(file.buffer.view(corners), 5126, 8, "VEC3");
  file.accessors += "," + accessor(file.buffer.view(cube), 5123, cube.size(), "SCALAR");
  return file;
}

inline importer::ReadModel read(const File& file) {
  const Folder folder;
  return read_by_importer(folder.file("m.gltf", file.json(true)));
}

inline std::string refusal(const File& file) {
  const Folder folder;
  return refusal_of(folder.file("m.gltf", file.json(true)));
}

inline void replace(std::string& text, std::string_view what, std::string_view by) {
  const std::size_t place = text.find(what);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, what.size(), by);
}

}  // namespace epura::test::gltf
