// SPDX-License-Identifier: Apache-2.0
#include "draco.hpp"

#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

using Bytes = std::span<const unsigned char>;

// Points and triangles. A plane of equal squares has 27 triangles for each byte where it is compressed best.
constexpr std::uint64_t max_per_byte = 100, always_allowed = 4'000'000;

int number_in(const tinygltf::Value& object, const char* name) {
  return object.Has(name) && object.Get(name).IsInt() ? object.Get(name).GetNumberAsInt() : -1;
}

draco::DecoderBuffer buffer_of(Bytes bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return buffer;
}

struct Counts {
  std::uint64_t points = 0, triangles = 0;
};

std::string text_of(Counts counts) {
  return std::to_string(counts.points) + " points and " + std::to_string(counts.triangles) + " triangles";
}

// What the decoder makes room for before it looks whether there are data for it. The places are those of version 2.2,
// to which the extension keeps: https://google.github.io/draco/spec
Counts announced(Bytes bytes, const std::string& what) {
  draco::DecoderBuffer buffer = buffer_of(bytes);
  draco::DracoHeader header{};
  refuse_if(!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok(), what + " has no header");
  refuse_if(header.encoder_type != draco::TRIANGULAR_MESH, what + " holds no mesh");
  refuse_if(header.version_major != 2 || header.version_minor != 2,
            what + " is of version " + std::to_string(header.version_major) + "." +
                std::to_string(header.version_minor) + "; version 2.2 is read");
  buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
  draco::GeometryMetadata metadata;
  const bool has_metadata = (header.flags & METADATA_FLAG_MASK) != 0;
  std::uint8_t traversal = 0;
  std::uint32_t points = 0, triangles = 0;
  const auto decode_counts = [&] {
    if (has_metadata && !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) return false;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
      return buffer.Decode(&traversal) && draco::DecodeVarint(&points, &buffer) &&
             draco::DecodeVarint(&triangles, &buffer);
    return draco::DecodeVarint(&triangles, &buffer) && draco::DecodeVarint(&points, &buffer);
  };
  refuse_if(!decode_counts(), what + " is damaged");
  return {points, triangles};
}

std::unique_ptr<draco::Mesh> mesh_in(Bytes bytes, Counts expected, const std::string& what) {
  const auto expect = [&](Counts counts) {
    refuse_if(counts.points != expected.points || counts.triangles != expected.triangles,
              what + " has " + text_of(counts) + ", its accessors have " + text_of(expected));
  };
  const Counts counts = announced(bytes, what);
  refuse_if(std::max(counts.points, counts.triangles) > max_per_byte * bytes.size() + always_allowed,
            what + " claims to have " + text_of(counts) + " in " + std::to_string(bytes.size()) + " bytes");
  // Seams of other attributes make more points of those that are announced.
  expect({std::max(counts.points, expected.points), counts.triangles});
  const auto decode = [&](bool keeps_grid) {
    draco::DecoderBuffer buffer = buffer_of(bytes);
    draco::Decoder decoder;
    if (keeps_grid) decoder.SetSkipAttributeTransform(draco::GeometryAttribute::POSITION);  // see Grid
    draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = decoder.DecodeMeshFromBuffer(&buffer);
    refuse_if(!decoded.ok(), what + " is damaged");
    return std::move(decoded).value();
  };
  std::unique_ptr<draco::Mesh> mesh = decode(true);
  // Without a grid, numbers have the type of their accessor only if they are transformed.
  const draco::PointAttribute* positions = mesh->GetNamedAttribute(draco::GeometryAttribute::POSITION);
  if (positions != nullptr && positions->GetAttributeTransformData() == nullptr) mesh = decode(false);
  expect({mesh->num_points(), mesh->num_faces()});
  return mesh;
}

draco::PointAttribute& positions_in(draco::Mesh& mesh, int id, const std::string& what) {
  const int number = id < 0 ? -1 : mesh.GetAttributeIdByUniqueId(static_cast<std::uint32_t>(id));
  refuse_if(number < 0, what + " has no attribute " + std::to_string(id));
  draco::PointAttribute& attribute = *mesh.attribute(number);
  refuse_if(attribute.num_components() != 3, what + " has no points in attribute " + std::to_string(id));
  refuse_if(!attribute.is_mapping_identity() && attribute.indices_map_size() < mesh.num_points(), what + " is damaged");
  return attribute;
}

/// The grid to which positions were rounded. Draco forgets it where it turns them into floats, as is done here.
class Grid {
 public:
  explicit Grid(const draco::PointAttribute& attribute) {
    if (attribute.GetAttributeTransformData() == nullptr || !transform_.InitFromAttribute(attribute)) return;
    step_ = transform_.range() / static_cast<float>((std::uint32_t{1} << transform_.quantization_bits()) - 1);
  }
  /// 0 if positions were not rounded.
  [[nodiscard]] double step() const { return static_cast<double>(step_); }
  [[nodiscard]] Point place(const Point& numbers) const {
    if (step_ == 0) return numbers;
    Point place{};
    for (int axis = 0; axis < 3; ++axis) {
      const float along = static_cast<float>(numbers[static_cast<std::size_t>(axis)]) * step_;
      place[static_cast<std::size_t>(axis)] = static_cast<double>(along + transform_.min_value(axis));
    }
    return place;
  }

 private:
  draco::AttributeQuantizationTransform transform_;
  float step_ = 0;
};

std::vector<Point> points_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute, const Grid& grid,
                             const std::string& what) {
  const bool is_normalized = attribute.normalized() && attribute.data_type() != draco::DT_FLOAT32;
  std::vector<Point> points(mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(i));
    refuse_if(value.value() >= attribute.size() || !attribute.ConvertValue<double, 3>(value, points[i].data()),
              what + " is damaged");
    points[i] = grid.place(points[i]);
    for (double& coordinate : points[i]) {
      refuse_if(!std::isfinite(coordinate), what + ": position " + std::to_string(i) + " is not finite");
      if (is_normalized) coordinate = std::max(coordinate, -1.0);
    }
  }
  return points;
}

std::vector<std::uint32_t> corners_of(const draco::Mesh& mesh) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(3 * std::size_t{mesh.num_faces()});
  for (std::uint32_t i = 0; i < mesh.num_faces(); ++i)
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(i))) numbers.push_back(corner.value());
  return numbers;
}

}  // namespace

bool reads_draco() { return true; }

Corners decompressed(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& what) {
  refuse_if(primitive.mode != TINYGLTF_MODE_TRIANGLES,
            what + " is compressed by Draco and of mode " + std::to_string(primitive.mode) + "; mode 4 is read");
  const tinygltf::Value& extension = primitive.extensions.at(draco_extension);
  const int number = number_in(extension, "indices");
  refuse_if(number < 0, what + " is compressed by Draco and has no indices");
  const tinygltf::Accessor& points = accessor_at(model, position_of(primitive, what), TINYGLTF_TYPE_VEC3);
  const tinygltf::Accessor& indices = accessor_at(model, number, TINYGLTF_TYPE_SCALAR);
  refuse_if(indices.count % 3 != 0,
            what + " has " + std::to_string(indices.count) + " corners, which make no triangles");
  const std::string data = what + ": its Draco data";
  const Bytes bytes = bytes_of(model, number_in(extension, "bufferView"));
  const std::unique_ptr<draco::Mesh> mesh = mesh_in(bytes, {points.count, indices.count / 3}, data);
  draco::PointAttribute& attribute = positions_in(*mesh, number_in(extension.Get("attributes"), "POSITION"), data);
  // The accessor tells, not the data.
  const Grid grid(attribute);
  attribute.set_normalized(points.normalized && grid.step() == 0);
  return {points_of(*mesh, attribute, grid, data), corners_of(*mesh), grid.step() > 0 ? grid.step() : step_of(points)};
}

}  // namespace epura::plugin::gltf
