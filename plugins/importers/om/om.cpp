// SPDX-License-Identifier: Apache-2.0
// Reads OM, the files of OpenMesh, by OpenMesh itself.
#include <OpenMesh/Core/IO/importer/ImporterT.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chunks.hpp"

namespace epura::plugin {

namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  FaceAttributes(OpenMesh::Attributes::Status);  // which faces are deleted
};
using Surface = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
using Importer = OpenMesh::IO::ImporterT<Surface>;

/// OpenMesh's reader neither heeds the end of a file nor tests the numbers that it passes on; this does.
class Receiver : public Importer {
 public:
  Receiver(Surface& surface, const std::istream& file) : Importer(surface), surface_(surface), file_(file) {}

  using Importer::set_status;

  VertexHandle add_vertex() override { throw std::runtime_error("has a vertex without a place"); }
  VertexHandle add_vertex(const OpenMesh::Vec3f& point) override {
    is_single_ = true;
    return add_vertex(OpenMesh::Vec3d(point[0], point[1], point[2]));
  }
  VertexHandle add_vertex(const OpenMesh::Vec3d& point) override {
    expect_more();
    return Importer::add_vertex(point);
  }
  HalfedgeHandle add_edge(VertexHandle from, VertexHandle to) override {
    expect_more();
    expect(surface_.is_valid_handle(from) && surface_.is_valid_handle(to), "edge", surface_.n_edges());
    return Importer::add_edge(from, to);
  }
  FaceHandle add_face(const VHandles& corners) override {
    expect_more();
    const FaceHandle face = Importer::add_face(corners);
    expect(face.is_valid(), "face", surface_.n_faces());
    return face;
  }
  FaceHandle add_face(HalfedgeHandle first) override {
    expect_more();
    return Importer::add_face(first);
  }
  void set_halfedge(VertexHandle, HalfedgeHandle) override { expect_more(); }
  void set_next(HalfedgeHandle halfedge, HalfedgeHandle next) override {
    expect(surface_.is_valid_handle(halfedge) && surface_.is_valid_handle(next), "half-edge", halfedge.idx());
    Importer::set_next(halfedge, next);
  }
  void set_status(FaceHandle face, const OpenMesh::Attributes::StatusInfo& status) override {
    expect(surface_.is_valid_handle(face), "state of face", face.idx());
    Importer::set_status(face, status);
  }
  // Not needed, and of what may not exist yet.
  void set_status(VertexHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}

  [[nodiscard]] bool is_single() const { return is_single_; }

 private:
  void expect_more() const {
    if (!file_) throw std::runtime_error("ends too early");
  }
  static void expect(bool is_so, const std::string& what, std::size_t number) {
    if (!is_so)
      throw std::runtime_error(what + " " + std::to_string(number) + " refers to something that is not there");
  }

  Surface& surface_;
  const std::istream& file_;
  bool is_single_ = false;
};

struct Faces {
  std::vector<std::uint64_t> ends;
  std::vector<std::uint32_t> corners;
};

// The corners of all faces that are not deleted. Every half-edge is met once, so that the links of a damaged file end.
Faces faces_of(const Surface& surface) {
  Faces faces;
  std::vector<char> is_met(surface.n_halfedges(), 0);
  for (const FaceHandle face : surface.faces()) {
    if (surface.status(face).deleted()) continue;
    const HalfedgeHandle first = surface.halfedge_handle(face);
    HalfedgeHandle at = first;
    do {
      if (!surface.is_valid_handle(at) || std::exchange(is_met[static_cast<std::size_t>(at.idx())], 1) != 0)
        throw std::runtime_error("the half-edges of face " + std::to_string(face.idx()) + " do not surround it");
      faces.corners.push_back(static_cast<std::uint32_t>(surface.to_vertex_handle(at).idx()));
      at = surface.next_halfedge_handle(at);
    } while (at != first);
    faces.ends.push_back(faces.corners.size());
  }
  return faces;
}

struct Om {
  static constexpr auto name = "om", summary = "OM, the files of OpenMesh: polygons", extensions = "om";

  static bool recognises(std::string_view first_bytes) {
    return first_bytes.size() > 3 && first_bytes.starts_with("OM") &&
           std::string_view("TQP").find(first_bytes[2]) != std::string_view::npos;
  }

  static void read(const Source& source, Sink& sink) {
    std::ifstream whole(source.path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(whole), std::istreambuf_iterator<char>()};
    std::istringstream file(om::needed_chunks(bytes));
    file.unsetf(std::ios::skipws);
    Surface surface;
    Receiver receiver(surface, file);
    OpenMesh::IO::Options options = OpenMesh::IO::Options::Status;
    omerr().disable();
    if (!OpenMesh::IO::OMReader().read(file, receiver, options))
      throw std::runtime_error("is damaged, or was written by a later version of OpenMesh than reads it");
    const Faces faces = faces_of(surface);
    if (faces.ends.empty()) throw std::runtime_error("has no faces");

    sink.rounding(receiver.is_single() ? EPURA_SINGLE : 0);
    sink.shape("");
    std::vector<Point> points;
    points.reserve(surface.n_vertices());
    for (const VertexHandle vertex : surface.all_vertices()) {
      const OpenMesh::Vec3d& p = surface.point(vertex);
      points.push_back({p[0], p[1], p[2]});
    }
    sink.points(points);
    sink.polygons(faces.ends, faces.corners);
  }
};

}  // namespace

}  // namespace epura::plugin

EPURA_IMPORTER(epura::plugin::Om)
