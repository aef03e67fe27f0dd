// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: coordinates rounded to floats, faces that were deleted, and damaged files, whose
// numbers OpenMesh believes.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "at_length.hpp"
#include "support.hpp"

namespace epura::test::om_test {
namespace {

struct Doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using DoubleMesh = OpenMesh::PolyMesh_ArrayKernelT<Doubles>;
using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// A box of six quadrangles, from the origin to (1.1, 2.3, 3.7).
template <class Surface>
Surface box() {
  Surface surface;
  std::vector<OpenMesh::VertexHandle> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(surface.add_vertex(typename Surface::Point(1.1 * (i & 1), 2.3 * (i >> 1 & 1), 3.7 * (i >> 2))));
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    surface.add_face(std::vector<OpenMesh::VertexHandle>{v[a], v[b], v[c], v[d]});
  return surface;
}

template <class Surface>
std::string bytes_of(Surface surface, OpenMesh::IO::Options options = OpenMesh::IO::Options::Default) {
  std::ostringstream file;
  omlog().disable();
  EXPECT_TRUE(OpenMesh::IO::write_mesh(surface, file, ".om", options));
  return file.str();
}

importer::ReadModel read(const std::string& bytes) {
  const Folder folder;
  return read_by_importer(folder.file("m.om", bytes));
}

std::string refusal(const std::string& bytes) {
  const Folder folder;
  return refusal_of(folder.file("m.om", bytes));
}

TEST(Om, KeepsDoublesAndPolygons) {
  const importer::ReadModel model = read(bytes_of(box<DoubleMesh>()));
  EXPECT_EQ(model.mesh.report.format, "om");
  EXPECT_EQ(model.mesh.report.faces, 6);
  EXPECT_FALSE(model.mesh.report.single_precision);
  EXPECT_EQ(model.unit, std::nullopt) << "the format has none";
  expect_extent(model.mesh, Vec3(0), Vec3(1.1, 2.3, 3.7));
  EXPECT_NEAR(volume_of(model.mesh), 1.1 * 2.3 * 3.7, 1e-12);
}

TEST(Om, KnowsWhereFloatsWereWritten) {
  const importer::ReadModel model = read(bytes_of(box<FloatMesh>()));
  EXPECT_TRUE(model.mesh.report.single_precision);
  expect_extent(model.mesh, Vec3(0), Vec3(1.1F, 2.3F, 3.7F));
}

TEST(Om, LeavesOutDeletedFaces) {
  auto surface = box<DoubleMesh>();
  surface.request_face_status();
  surface.request_edge_status();
  surface.request_vertex_status();
  surface.delete_face(OpenMesh::FaceHandle(1), false);
  const mesh::MeshReport report = read(bytes_of(surface, OpenMesh::IO::Options::Status)).mesh.report;
  EXPECT_EQ(report.faces, 5);
  EXPECT_EQ(report.open_edges, 4);
}

// Before version 2, faces were lists of vertices. The second face follows its edges to 1 and 0 in the directions of the
// first and the third, which half-edges cannot: OpenMesh gives it vertices of its own, which are joined again.
TEST(Om, ReadsFilesWithoutHalfEdges) {
  std::string bytes("OMT\x22\4\0\0\0\3\0\0\0\0\0\0\0\0\x16", 18);
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F})
    bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
  bytes += std::string("\xe8\6\0\1\2\0\1\3\0\2\3", 11);
  const mesh::MeshReport report = read(bytes).mesh.report;
  EXPECT_EQ(report.faces, 3);
  EXPECT_EQ(report.welded_vertices, 3);
  EXPECT_EQ(report.misoriented_edges, 2);
}

// A box with texture, states and a property, which are read past: as is, then with each bit of the first header of a
// chunk turned, at some of which OpenMesh ends the process.
TEST(Om, DamagedHeadersAreRefusedByName) {
  auto surface = box<FloatMesh>();
  surface.request_face_status();
  OpenMesh::VPropHandleT<double> property;
  surface.add_property(property, "temperature");
  surface.property(property).set_persistent(true);
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Status;
  options += OpenMesh::IO::Options::Custom;
  std::string whole = bytes_of(surface, options);
  constexpr std::size_t header = 16, chunk = 2;
  whole.insert(header + chunk + 8 * 3 * sizeof(float), "\x40\x0E" + std::string(8 * 2 * sizeof(float), 'x'));
  EXPECT_EQ(read(whole).mesh.report.faces, 6);
  for (std::size_t bit = 8 * header; bit < 8 * (header + chunk); ++bit) {
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    try {
      read(bytes);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << "bit " << bit << ": " << error.what();
    }
  }
  std::string flat = bytes_of(box<FloatMesh>());
  flat[header + 1] = 0x0E;
  EXPECT_EQ(refusal(flat), "is damaged: chunk 1 has 2 numbers for each point, colour or direction instead of 3");
  std::string random = flat;
  random[header] = 0x14;
  random[header + 1] = 0x16;
  EXPECT_EQ(refusal(random), "is damaged: chunk 1 is of a kind that OpenMesh does not write");
}

TEST(Om, DamagedFilesAreRefused) {
  const std::string whole = bytes_of(box<DoubleMesh>());
  EXPECT_EQ(refusal(whole.substr(0, 100)), "ends too early");
  EXPECT_EQ(refusal(bytes_of(DoubleMesh())), "has no faces");
  int refused = 0, step = at_length() ? 1 : 3;  // which meets each of the four bytes of numbers
  for (std::size_t at = 16 + 2 + 8 * 3 * 8; at < whole.size(); at += static_cast<std::size_t>(step)) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x40);
    try {
      read(bytes);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << "byte " << at << ": " << error.what();
      ++refused;
    }
  }
  EXPECT_GE(refused, 54 / step) << "next and end of each of 24 half-edges, and first of each of 6 faces";
}

}  // namespace
}  // namespace epura::test::om_test
