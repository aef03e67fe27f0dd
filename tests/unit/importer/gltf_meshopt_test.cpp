// SPDX-License-Identifier: Apache-2.0
// Views of glTF that meshoptimizer compresses here.
#include <meshoptimizer.h>

#include "gltf_file.hpp"

namespace epura::test::gltf::gltf_meshopt_test {
namespace {

std::vector<unsigned char> packed_points() {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(8, 12));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), corners.data(), 8, 12));
  return bytes;
}

std::vector<unsigned char> packed_triangles() {
  const std::vector<unsigned> numbers(cube.begin(), cube.end());
  std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(numbers.size(), 8));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), numbers.data(), numbers.size()));
  return bytes;
}

std::string view_of(std::size_t begin, std::size_t length, const std::string& rest) {
  return R"({"buffer":1,"byteOffset":0,"byteLength":96,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" +
         std::to_string(begin) + ",\"byteLength\":" + std::to_string(length) + rest + "}}}";
}

/// A cube whose second buffer, which stands for the bytes without compression, is empty as the extension allows.
std::string compressed_cube() {
  const std::vector<unsigned char> points = packed_points(), triangles = packed_triangles();
  std::string bytes(points.begin(), points.end());
  bytes.append(triangles.begin(), triangles.end());
  return R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_meshopt_compression"],)"
         R"("extensionsRequired":["EXT_meshopt_compression"],"buffers":[{"uri":"data:application/octet-stream;base64,)" +
         base64(bytes) + R"(","byteLength":)" + std::to_string(bytes.size()) +
         R"(},{"byteLength":168,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}],"bufferViews":[)" +
         view_of(0, points.size(), R"(,"byteStride":12,"count":8,"mode":"ATTRIBUTES")") + "," +
         view_of(points.size(), triangles.size(), R"(,"byteStride":2,"count":36,"mode":"TRIANGLES")") +
         R"(],"accessors":[)" + accessor(0, 5126, 8, "VEC3") + "," + accessor(1, 5123, 36, "SCALAR") +
         R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":[{"mesh":0}]})";
}

TEST(GltfMeshopt, ViewsAreDecompressed) {
  const Folder folder;
  const importer::ReadModel model = read_by_importer(folder.file("m.gltf", compressed_cube()));
  EXPECT_EQ(volume_of(model.mesh), 1);
  expect_extent(model.mesh, {0, 0, 0}, {1, 1, 1});
}

TEST(GltfMeshopt, WhatIsWrongIsTold) {
  const Folder folder;
  const auto refusal_with = [&](const std::string& what, const std::string& by) {
    std::string json = compressed_cube();
    replace(json, what, by);
    return refusal_of(folder.file("m.gltf", json));
  };
  const std::string data = "bufferView 0: its compressed data";
  EXPECT_EQ(refusal_with("\"ATTRIBUTES\"", "\"OTHER\""), data + " is of unknown mode 'OTHER'");
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":800000000"),
            data + " claims to have 800000000 elements in " + std::to_string(packed_points().size()) + " bytes");
  EXPECT_TRUE(contains(refusal_with("\"count\":8", "\"count\":80"), "'gltfpack -i IN.glb -o OUT.glb -noq' undoes it"));
}

}  // namespace
}  // namespace epura::test::gltf::gltf_meshopt_test
