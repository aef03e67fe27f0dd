// SPDX-License-Identifier: Apache-2.0
#include "meshopt.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

// A block of equal vertices takes a byte for every sixteen of each of their bytes; triangles take a byte at least.
constexpr std::size_t max_per_byte = 256, always_allowed = std::size_t{4} << 20;

/// The extension's table of one view.
struct Compressed {
  std::span<const unsigned char> bytes;
  std::size_t count, stride;
  std::string mode, filter;
};

std::size_t number_in(const tinygltf::Value& table, const char* name, const std::string& what) {
  if (!table.Has(name)) return 0;
  const double number = table.Get(name).IsNumber() ? table.Get(name).GetNumberAsDouble() : -1;
  refuse_if(!(number >= 0 && number < 4294967296.0), what + " has a '" + name + "' that is no count");
  return static_cast<std::size_t>(number);
}

std::string text_in(const tinygltf::Value& table, const char* name) {
  return table.Has(name) && table.Get(name).IsString() ? table.Get(name).Get<std::string>() : std::string();
}

Compressed compressed_in(const tinygltf::Model& model, const tinygltf::Value& table, const std::string& what) {
  const std::size_t buffer = number_in(table, "buffer", what), begin = number_in(table, "byteOffset", what),
                    length = number_in(table, "byteLength", what);
  refuse_if(buffer >= model.buffers.size(), what + " is of a buffer that is not there");
  const std::vector<unsigned char>& bytes = model.buffers[buffer].data;
  refuse_if(begin > bytes.size() || length > bytes.size() - begin, what + " reaches beyond the end of its buffer");
  return {std::span(bytes).subspan(begin, length), number_in(table, "count", what),
          number_in(table, "byteStride", what), text_in(table, "mode"), text_in(table, "filter")};
}

// Returns what meshoptimizer returns: 0 if all is well.
int decode(const Compressed& from, std::vector<unsigned char>& to, const std::string& what) {
  const bool is_of_indices = from.mode == "TRIANGLES" || from.mode == "INDICES";
  const bool is_of_vertices = from.mode == "ATTRIBUTES";
  refuse_if(!is_of_indices && !is_of_vertices, what + " is of unknown mode '" + shortened(from.mode) + "'");
  refuse_if(is_of_indices && from.stride != 2 && from.stride != 4,
            what + " has indices of " + std::to_string(from.stride) + " bytes");
  refuse_if(is_of_vertices && (from.stride == 0 || from.stride > 256 || from.stride % 4 != 0),
            what + " has elements of " + std::to_string(from.stride) + " bytes");
  refuse_if(from.mode == "TRIANGLES" && from.count % 3 != 0, what + " holds no whole triangles");
  if (is_of_vertices)
    return meshopt_decodeVertexBuffer(to.data(), from.count, from.stride, from.bytes.data(), from.bytes.size());
  if (from.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(to.data(), from.count, from.stride, from.bytes.data(), from.bytes.size());
  return meshopt_decodeIndexSequence(to.data(), from.count, from.stride, from.bytes.data(), from.bytes.size());
}

void unfilter(const Compressed& from, std::vector<unsigned char>& bytes, const std::string& what) {
  if (from.filter.empty() || from.filter == "NONE") return;
  struct Row {
    const char* name;
    void (*undo)(void*, std::size_t, std::size_t);
    std::array<std::size_t, 2> strides;  ///< those that it takes; 0: any
  };
  constexpr std::array<Row, 3> rows{{{"OCTAHEDRAL", meshopt_decodeFilterOct, {4, 8}},
                                     {"QUATERNION", meshopt_decodeFilterQuat, {8, 8}},
                                     {"EXPONENTIAL", meshopt_decodeFilterExp, {0, 0}}}};
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& one) { return one.name == from.filter; });
  refuse_if(row == rows.end(), what + " has an unknown filter '" + shortened(from.filter) + "'");
  refuse_if(row->strides[0] != 0 && from.stride != row->strides[0] && from.stride != row->strides[1],
            what + " has a filter that is not for elements of " + std::to_string(from.stride) + " bytes");
  row->undo(bytes.data(), from.count, from.stride);
}

std::vector<unsigned char> decompressed(const Compressed& from, const std::string& what) {
  refuse_if(from.count * from.stride > max_per_byte * from.bytes.size() + always_allowed,
            what + " claims to have " + std::to_string(from.count) + " elements in " +
                std::to_string(from.bytes.size()) + " bytes");
  std::vector<unsigned char> bytes(from.count * from.stride);
  refuse_if(decode(from, bytes, what) != 0,
            what + " is damaged, or compressed by a later version of meshoptimizer; " + undoing_meshopt);
  unfilter(from, bytes, what);
  return bytes;
}

}  // namespace

bool reads_meshopt() { return true; }

void decompress_views(tinygltf::Model& model) {
  for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
    const auto found = model.bufferViews[i].extensions.find(meshopt_extension);
    if (found == model.bufferViews[i].extensions.end()) continue;
    const std::string what = numbered("bufferView", i) + ": its compressed data";
    tinygltf::Buffer buffer;
    buffer.data = decompressed(compressed_in(model, found->second, what), what);
    tinygltf::BufferView& view = model.bufferViews[i];
    view.buffer = static_cast<int>(model.buffers.size());
    view.byteOffset = 0;
    view.byteLength = buffer.data.size();
    model.buffers.push_back(std::move(buffer));
  }
}

}  // namespace epura::plugin::gltf
