// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: compressed parts of another shape than those before, and data that lie.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "gltf_file.hpp"

namespace epura::test::gltf::gltf_draco_test {
namespace {

// A cube with places that no grid of 2^n - 1 steps has.
std::vector<float> bent_corners() {
  std::vector<float> bent = corners;
  bent[0] = 0.3F;
  bent[23] = 0.7F;
  return bent;
}

/// How a cube is compressed. As in most files, normals may come first: they tear it into faces of their own points.
struct Compression {
  draco::MeshEncoderMethod method = draco::MESH_EDGEBREAKER_ENCODING;
  bool has_normals = false;
  int bits = 0;  ///< of positions; 0: all
  [[nodiscard]] int points() const { return has_normals ? 24 : 8; }
  [[nodiscard]] int id() const { return has_normals ? 1 : 0; }
};

std::string encoded(const draco::Mesh& mesh, const Compression& how) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(how.method);
  if (how.bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, how.bits);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

std::string compressed(const std::vector<float>& points, const Compression& how) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(cube.size() / 3));
  const int normals =
      how.has_normals ? builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32) : -1;
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t t = 0; t < cube.size() / 3; ++t) {
    const draco::FaceIndex face(static_cast<std::uint32_t>(t));
    // Two triangles a side.
    std::array<float, 3> normal{};
    normal[t / 2 % 3] = t < 6 ? -1.F : 1.F;
    if (how.has_normals) builder.SetAttributeValuesForFace(normals, face, &normal, &normal, &normal);
    const auto corner = [&](std::size_t k) { return &points[3 * std::size_t{cube[3 * t + k]}]; };
    builder.SetAttributeValuesForFace(positions, face, corner(0), corner(1), corner(2));
  }
  return encoded(*builder.Finalize(), how);
}

File two_cubes(File file) {
  file.nodes =
      R"({"name":"left","mesh":0},{"name":"mirrored","mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 9,0,0,1]})";
  file.rest = R"(,"scene":0,"scenes":[{"nodes":[0,1]}])";
  return file;
}

/// A compressed cube whose accessors have no views.
File file_of(const std::string& data, const Compression& how) {
  File file;
  file.buffer.view(std::vector<char>(data.begin(), data.end()));
  file.accessors = R"({"componentType":5126,"count":)" + std::to_string(how.points()) +
                   R"(,"type":"VEC3"},{"componentType":5123,"count":36,"type":"SCALAR"})";
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":)"
                    R"({"bufferView":0,"attributes":{"POSITION":)" +
                    std::to_string(how.id()) + "}}}}";
  file = two_cubes(file);
  file.rest +=
      R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])";
  return file;
}

File plain_file(const std::vector<float>& points) {
  File file;
  file.accessors = accessor(file.buffer.view(points), 5126, points.size() / 3, "VEC3");
  file.accessors += "," + accessor(file.buffer.view(cube), 5123, cube.size(), "SCALAR");
  return two_cubes(file);
}

// In an order of their own, since compression has another one.
std::vector<std::array<Vec3, 3>> triangles_of(const mesh::Mesh& mesh) {
  const auto is_less = [](const Vec3& a, const Vec3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  };
  std::vector<std::array<Vec3, 3>> triangles;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::array<Vec3, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = mesh.point(mesh.triangle(t)[k]);
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end(), is_less), triangle.end());
    triangles.push_back(triangle);
  }
  std::sort(triangles.begin(), triangles.end(), [&](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_less);
  });
  return triangles;
}

void expect_same(const importer::ReadModel& model, const importer::ReadModel& expected) {
  EXPECT_EQ(triangles_of(model.mesh), triangles_of(expected.mesh));
  EXPECT_EQ(model.mesh.report.body_names, expected.mesh.report.body_names);
  EXPECT_EQ(model.mesh.report.open_edges, 0);
  EXPECT_EQ(model.mesh.report.misoriented_edges, 0);
}

const std::array<Compression, 4> lossless{
    Compression{draco::MESH_EDGEBREAKER_ENCODING, false}, Compression{draco::MESH_EDGEBREAKER_ENCODING, true},
    Compression{draco::MESH_SEQUENTIAL_ENCODING, false}, Compression{draco::MESH_SEQUENTIAL_ENCODING, true}};

TEST(GltfDraco, WhatWasCompressedIsAsBefore) {
  const Folder folder;
  const importer::ReadModel expected = read(plain_file(bent_corners()));
  EXPECT_EQ(expected.mesh.report.triangles, 24);
  for (const Compression& how : lossless) {
    const File file = file_of(compressed(bent_corners(), how), how);
    expect_same(read(file), expected);
    expect_same(read_by_importer(folder.file("m.glb", file.binary())), expected);
  }
}

// A grid of 2^14 places across the longest side rounds by half of its step at most.
TEST(GltfDraco, QuantisationRoundsByHalfAStep) {
  constexpr double half_a_step = 0.5 / ((1 << 14) - 1), of_singles = 1e-6;
  const Compression how{draco::MESH_EDGEBREAKER_ENCODING, false, 14};
  const mesh::Mesh mesh = read(file_of(compressed(bent_corners(), how), how)).mesh;
  const mesh::Mesh expected = read(plain_file(bent_corners())).mesh;
  EXPECT_NEAR(volume_of(mesh), volume_of(expected), 4 * half_a_step);
  double largest = 0;
  ASSERT_EQ(mesh.report.vertices, expected.report.vertices);
  for (int v = 0; v < mesh.report.vertices; ++v) {
    double nearest = 1;
    for (int w = 0; w < expected.report.vertices; ++w)
      nearest = std::min(nearest, glm::length(mesh.point(v) - expected.point(w)));
    largest = std::max(largest, nearest);
  }
  EXPECT_LT(largest, half_a_step + of_singles);
  EXPECT_GT(largest, 0) << "nothing was rounded";
}

TEST(GltfDraco, QuantisationIsTheResolution) {
  for (const int bits : {8, 11, 14}) {
    const Compression how{.bits = bits};
    const double step = read(file_of(compressed(corners, how), how)).mesh.report.resolution;
    EXPECT_NEAR(step, 1 / (std::pow(2, bits) - 1), 1e-6 * step) << bits;
  }
  const Compression whole{};
  EXPECT_EQ(read(file_of(compressed(corners, whole), whole)).mesh.report.resolution, 0);
}

TEST(GltfDraco, ACopyForReadersWithoutDracoIsNotReadTwice) {
  const Compression how;
  File file = file_of(compressed(bent_corners(), how), how);
  file.accessors = accessor(file.buffer.view(bent_corners()), 5126, 8, "VEC3");
  file.accessors += "," + accessor(file.buffer.view(cube), 5123, cube.size(), "SCALAR");
  replace(file.rest, R"(,"extensionsRequired":["KHR_draco_mesh_compression"])", "");
  expect_same(read(file), read(plain_file(bent_corners())));
}

// After KHR_mesh_quantization.
TEST(GltfDraco, IntegersAreScaledAsTheirAccessorSays) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(cube.size() / 3));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_INT16);
  for (std::size_t t = 0; t < cube.size() / 3; ++t) {
    std::array<std::array<std::int16_t, 3>, 3> places{};
    for (std::size_t k = 0; k < 9; ++k)
      places[k / 3][k % 3] = corners[3 * std::size_t{cube[3 * t + k / 3]} + k % 3] > 0 ? 32767 : -32768;
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(static_cast<std::uint32_t>(t)), &places[0],
                                      &places[1], &places[2]);
  }
  File file = file_of(encoded(*builder.Finalize(), {}), {});
  file.rest = R"(,"scene":0,"scenes":[{"nodes":[0]}])";
  replace(file.accessors, "5126", "5122");
  expect_extent(read(file).mesh, Vec3(-32768), Vec3(32767));
  replace(file.accessors, "\"count\"", "\"normalized\":true,\"count\"");
  expect_extent(read(file).mesh, Vec3(-1), Vec3(1));
}

// However a primitive is written, and whatever stands beside it.
TEST(GltfDraco, PrimitivesOfBothKindsAreInOneFile) {
  const Compression how;
  File file = file_of(compressed(corners, how), how);
  const std::string above = accessor(file.buffer.view(std::vector<float>{0, 0, 9, 1, 0, 9, 0, 1, 9}), 5126, 3, "VEC3");
  file.accessors +=
      "," + above + "," + accessor(file.buffer.view(std::vector<std::uint8_t>{0, 1, 2}), 5121, 3, "SCALAR");
  file.primitives = R"({"attributes":{"POSITION":2},"indices":3},
    {"extras":{"\"indices\":{[":"extensions"}, "extensions" : { "A":{}, "KHR_draco_mesh_compression" : {
      "attributes":{"POSITION":0}, "bufferView":0 } },
     "indices" : 1 , "attributes":{"POSITION":0}})";
  file.nodes = R"({"mesh":0,"extras":{"indices":1,"KHR_draco_mesh_compression":{"indices":1}}})";
  replace(file.rest, "[0,1]", "[0]");
  const mesh::Mesh mesh = read(file).mesh;
  EXPECT_EQ(mesh.report.triangles, 13);
  expect_extent(mesh, {0, 0, 0}, {1, 1, 9});
  EXPECT_NEAR(volume_of(mesh), 1 + 9 * 0.5 / 3, 1e-12) << "with the cone below the triangle";
}

TEST(GltfDraco, DataCutShortAreRefused) {
  for (const Compression& how : lossless) {
    const std::string data = compressed(bent_corners(), how);
    for (std::size_t size = 1; size < data.size(); size += data.size() / 5)
      EXPECT_TRUE(contains(refusal(file_of(data.substr(0, size), how)), "mesh 0, primitive 0: its Draco data "))
          << size;
  }
}

TEST(GltfDraco, WhatDoesNotFitIsNamed) {
  const Compression how;
  const std::string data = compressed(corners, how), primitive = "mesh 0, primitive 0",
                    draco = primitive + ": its Draco data ";
  const auto refusal_with = [&](const std::string& what, const std::string& by) {
    const Folder folder;
    std::string json = file_of(data, how).json(true);
    replace(json, what, by);
    return refusal_of(folder.file("m.gltf", json));
  };
  const std::string attributes = R"("attributes":{"POSITION":0}}})";
  EXPECT_EQ(refusal_with(attributes, R"("attributes":{"POSITION":7}}})"), draco + "has no attribute 7");
  EXPECT_EQ(refusal_with(attributes, R"("attributes":{"POSITION":-7}}})"), draco + "has no attribute -7");
  EXPECT_EQ(refusal_with(attributes, R"("attributes":[0]}})"), draco + "has no attribute -1");
  EXPECT_EQ(refusal_with("\"bufferView\":0", "\"bufferView\":3"), "bufferView 3 is not there");
  EXPECT_EQ(refusal_with("\"bufferView\":0", "\"bufferView\":\"0\""), "bufferView -1 is not there");
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":9"),
            draco + "has 8 points and 12 triangles, its accessors have 9 points and 12 triangles");
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":7"),
            draco + "has 8 points and 12 triangles, its accessors have 7 points and 12 triangles");
  EXPECT_EQ(refusal_with("\"count\":36", "\"count\":4000000002"),
            draco + "has 8 points and 12 triangles, its accessors have 8 points and 1333333334 triangles");
  EXPECT_EQ(refusal_with("\"count\":36", "\"count\":35"), primitive + " has 35 corners, which make no triangles");
  EXPECT_EQ(refusal_with("\"indices\":1", "\"indices\":5"), "accessor 5 is not there");
  EXPECT_EQ(refusal_with("\"indices\":1,", ""), primitive + " is compressed by Draco and has no indices");
  EXPECT_EQ(refusal_with("\"indices\":1,", "\"indices\":1,\"mode\":5,"),
            primitive + " is compressed by Draco and of mode 5; mode 4 is read");
}

// Room for them would be made before the data turn out to be missing.
TEST(GltfDraco, HugeCountsAreRefusedBeforeThereIsRoomForThem) {
  const Compression how{draco::MESH_SEQUENTIAL_ENCODING, false};
  constexpr std::size_t place_of_counts = 11, place_of_version = 6;
  std::string data = compressed(corners, how);
  ASSERT_EQ(data[place_of_counts], 12);
  // 10^9 in groups of seven bits, the lowest first.
  data.replace(place_of_counts, 1, "\x80\x94\xeb\xdc\x03");
  File file = file_of(data, how);
  replace(file.accessors, "\"count\":36", "\"count\":3000000000");
  EXPECT_EQ(refusal(file), "mesh 0, primitive 0: its Draco data claims to have 8 points and 1000000000 triangles in " +
                               std::to_string(data.size()) + " bytes");
  data = compressed(corners, how);
  data[place_of_version] = 1;
  EXPECT_EQ(refusal(file_of(data, how)), "mesh 0, primitive 0: its Draco data is of version 2.1; version 2.2 is read");
}

}  // namespace
}  // namespace epura::test::gltf::gltf_draco_test
