// SPDX-License-Identifier: Apache-2.0
#include "accessors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

using tinygltf::Accessor;
using tinygltf::Model;

/// Position of the elements of an accessor.
struct Elements {
  const unsigned char* first = nullptr;
  std::size_t stride = 0;
};

// Numbers in files are little-endian.
template <class T>
T number_at(const unsigned char* bytes) {
  using Bits = std::conditional_t<sizeof(T) == 1, std::uint8_t,
                                  std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint32_t>>;
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bits = static_cast<Bits>(bits | static_cast<Bits>(Bits{bytes[i]} << (8 * i)));
  return std::bit_cast<T>(bits);
}

template <class T>
double coordinate_at(const unsigned char* bytes, bool is_normalized) {
  const auto value = static_cast<double>(number_at<T>(bytes));
  if constexpr (std::is_integral_v<T>)
    return is_normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0) : value;
  else
    return value;
}

template <class T>
double step_between(bool is_normalized) {
  if constexpr (std::is_integral_v<T>)
    return is_normalized ? 1.0 / std::numeric_limits<T>::max() : 1;
  else
    return 0;
}

using ReadCoordinate = double (*)(const unsigned char*, bool);
using ReadIndex = std::uint32_t (*)(const unsigned char*);

struct Kind {
  int component_type;
  std::size_t bytes;
  ReadCoordinate coordinate;
  double (*step)(bool);
};
template <class T>
constexpr Kind kind_for(int component_type) {
  return {component_type, sizeof(T), coordinate_at<T>, step_between<T>};
}
constexpr std::array coordinate_kinds{kind_for<float>(TINYGLTF_COMPONENT_TYPE_FLOAT),
                                      kind_for<std::int8_t>(TINYGLTF_COMPONENT_TYPE_BYTE),
                                      kind_for<std::uint8_t>(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE),
                                      kind_for<std::int16_t>(TINYGLTF_COMPONENT_TYPE_SHORT),
                                      kind_for<std::uint16_t>(TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)};

template <class T>
std::uint32_t index_at(const unsigned char* bytes) {
  return number_at<T>(bytes);
}

struct IndexKind {
  int component_type;
  std::size_t bytes;
  ReadIndex index;
};
constexpr std::array index_kinds{IndexKind{TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 1, index_at<std::uint8_t>},
                                 IndexKind{TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 2, index_at<std::uint16_t>},
                                 IndexKind{TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, 4, index_at<std::uint32_t>}};

template <class Kinds>
const auto& kind_of(const Kinds& kinds, int component_type, const std::string& what) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.component_type == component_type; });
  refuse_if(found == kinds.end(), what + " of component type " + std::to_string(component_type));
  return *found;
}

// `count` elements of `size` bytes each; `what` is "accessor 3".
Elements elements_in(const Model& model, int view, std::size_t offset, std::size_t count, std::size_t size,
                     const std::string& what) {
  const std::span<const unsigned char> bytes = bytes_of(model, view);
  const std::size_t told = model.bufferViews[static_cast<std::size_t>(view)].byteStride;
  const std::size_t stride = told == 0 ? size : told;
  refuse_if(stride < size, what + ": its elements overlap");
  const bool fits = count == 0 || (offset <= bytes.size() && bytes.size() - offset >= size &&
                                   (bytes.size() - offset - size) / stride >= count - 1);
  refuse_if(!fits, what + " reaches beyond the end of " + numbered("bufferView", static_cast<std::size_t>(view)));
  return {count == 0 ? nullptr : bytes.data() + offset, stride};
}

std::string name_of(int accessor) { return "accessor " + std::to_string(accessor); }

const Accessor& uncompressed(const Model& model, int number, int type) {
  const Accessor& accessor = accessor_at(model, number, type);
  std::size_t bytes = 0;
  for (const tinygltf::Buffer& buffer : model.buffers) bytes += buffer.data.size();
  // Accessors without data are filled with zeros, but no file needs that many.
  refuse_if(accessor.count > bytes, name_of(number) + " claims to have " + std::to_string(accessor.count) +
                                        " elements, more than there are bytes");
  return accessor;
}

template <class Replace>
void replace_sparse(const Model& model, const Accessor& accessor, std::size_t value_bytes, const std::string& what,
                    const Replace& replace) {
  if (!accessor.sparse.isSparse) return;
  const auto& sparse = accessor.sparse;
  refuse_if(sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0,
            what + ": its sparse part has negative places");
  const auto count = static_cast<std::size_t>(sparse.count);
  const IndexKind& kind = kind_of(index_kinds, sparse.indices.componentType, what + " has sparse indices");
  const Elements places = elements_in(model, sparse.indices.bufferView,
                                      static_cast<std::size_t>(sparse.indices.byteOffset), count, kind.bytes, what);
  const Elements values = elements_in(model, sparse.values.bufferView,
                                      static_cast<std::size_t>(sparse.values.byteOffset), count, value_bytes, what);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t place = kind.index(places.first + i * places.stride);
    refuse_if(place >= accessor.count, what + ": its sparse part replaces element " + std::to_string(place) + " of " +
                                           std::to_string(accessor.count));
    replace(place, values.first + i * values.stride);
  }
}

template <std::size_t size>
std::vector<std::array<double, size>> vectors(const Model& model, int number, int type) {
  const std::string what = name_of(number);
  const Accessor& accessor = uncompressed(model, number, type);
  const Kind& kind = kind_of(coordinate_kinds, accessor.componentType, what + " has positions");
  const auto point_at = [&](const unsigned char* bytes) {
    std::array<double, size> point{};
    for (std::size_t k = 0; k < point.size(); ++k)
      point[k] = kind.coordinate(bytes + k * kind.bytes, accessor.normalized);
    return point;
  };
  const std::size_t bytes_of_one = size * kind.bytes;
  std::vector<std::array<double, size>> points(accessor.count);
  if (accessor.bufferView >= 0) {
    const Elements elements =
        elements_in(model, accessor.bufferView, accessor.byteOffset, accessor.count, bytes_of_one, what);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = point_at(elements.first + i * elements.stride);
  }
  replace_sparse(model, accessor, bytes_of_one, what,
                 [&](std::uint32_t place, const unsigned char* bytes) { points[place] = point_at(bytes); });
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double coordinate : points[i])
      refuse_if(!std::isfinite(coordinate), what + ": position " + std::to_string(i) + " is not finite");
  return points;
}

}  // namespace

std::span<const unsigned char> bytes_of(const Model& model, int view) {
  const std::string what = "bufferView " + std::to_string(view);
  refuse_if(view < 0 || static_cast<std::size_t>(view) >= model.bufferViews.size(), what + " is not there");
  const tinygltf::BufferView& found = model.bufferViews[static_cast<std::size_t>(view)];
  refuse_if(found.buffer < 0 || static_cast<std::size_t>(found.buffer) >= model.buffers.size(),
            what + " is of a buffer that is not there");
  const std::vector<unsigned char>& bytes = model.buffers[static_cast<std::size_t>(found.buffer)].data;
  refuse_if(found.byteOffset > bytes.size() || found.byteLength > bytes.size() - found.byteOffset,
            what + " reaches beyond the end of its buffer");
  return std::span(bytes).subspan(found.byteOffset, found.byteLength);
}

const Accessor& accessor_at(const Model& model, int number, int type) {
  const std::string what = name_of(number);
  refuse_if(number < 0 || static_cast<std::size_t>(number) >= model.accessors.size(), what + " is not there");
  const Accessor& accessor = model.accessors[static_cast<std::size_t>(number)];
  refuse_if(accessor.type != type, what + (type == TINYGLTF_TYPE_VEC3   ? " holds no points"
                                           : type == TINYGLTF_TYPE_VEC4 ? " holds no rotations"
                                                                        : " holds no single numbers"));
  return accessor;
}

int position_of(const tinygltf::Primitive& primitive, const std::string& what) {
  const auto position = primitive.attributes.find("POSITION");
  refuse_if(position == primitive.attributes.end(), what + " has no positions");
  return position->second;
}

std::vector<Point> positions(const Model& model, int number) { return vectors<3>(model, number, TINYGLTF_TYPE_VEC3); }

std::vector<std::array<double, 4>> quaternions(const Model& model, int number) {
  return vectors<4>(model, number, TINYGLTF_TYPE_VEC4);
}

double step_of(const Accessor& positions) {
  for (const Kind& kind : coordinate_kinds)
    if (kind.component_type == positions.componentType) return kind.step(positions.normalized);
  return 0;
}

std::vector<std::uint32_t> indices(const Model& model, int number) {
  const std::string what = name_of(number);
  const Accessor& accessor = uncompressed(model, number, TINYGLTF_TYPE_SCALAR);
  const IndexKind& kind = kind_of(index_kinds, accessor.componentType, what + " has indices");
  std::vector<std::uint32_t> found(accessor.count);
  if (accessor.bufferView >= 0) {
    const Elements elements =
        elements_in(model, accessor.bufferView, accessor.byteOffset, accessor.count, kind.bytes, what);
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = kind.index(elements.first + i * elements.stride);
  }
  replace_sparse(model, accessor, kind.bytes, what,
                 [&](std::uint32_t place, const unsigned char* bytes) { found[place] = kind.index(bytes); });
  return found;
}

}  // namespace epura::plugin::gltf
