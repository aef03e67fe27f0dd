// SPDX-License-Identifier: Apache-2.0
#include "drawing/part_edges.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace epura::drawing {

PartEdges::PartEdges(const world::World& world) : world_(&world) {
  for (const world::Placed& placed : world.models) {
    parts_.push_back(world::place_part(placed));
    face_of_polygon_.push_back(parts_.back() ? world::faces_of_polygons(placed) : std::vector<int>());
  }
}

const mesh::MeshEdge* PartEdges::edge_of(const Segment& segment) const {
  if (!part(segment.model) || segment.edge[0] < 0) return nullptr;
  const auto [low, high] = std::minmax(segment.edge[0], segment.edge[1]);
  return placed(segment.model).mesh->whole().edge_between({low, high});
}

int PartEdges::border_of(const Segment& segment) const {
  const mesh::MeshEdge* edge = edge_of(segment);
  if (edge == nullptr) return -1;
  const world::Placed& model = placed(segment.model);
  return model.part->border_of_edge[static_cast<std::size_t>(edge - model.mesh->whole().edges.data())];
}

const surfaces::PartFace* PartEdges::face_around(const Segment& segment) const {
  const mesh::MeshEdge* edge = edge_of(segment);
  if (edge == nullptr) return nullptr;
  const world::Placed& model = placed(segment.model);
  const std::span<const int> beside = model.mesh->whole().triangles_of(*edge);
  const auto face = [&](std::size_t i) { return model.part->face_of_triangle[static_cast<std::size_t>(beside[i])]; };
  if (beside.size() != 2 || face(0) < 0 || face(0) != face(1)) return nullptr;
  return &part(segment.model)->faces[static_cast<std::size_t>(face(0))];
}

const surfaces::PartFace* PartEdges::face_of(const std::array<int, 2>& in_file) const {
  const auto [model, polygon] = in_file;
  if (model < 0 || polygon < 0 || !part(model)) return nullptr;
  const std::vector<int>& faces = face_of_polygon_[static_cast<std::size_t>(model)];
  const int face = polygon < static_cast<int>(faces.size()) ? faces[static_cast<std::size_t>(polygon)] : -1;
  return face < 0 ? nullptr : &part(model)->faces[static_cast<std::size_t>(face)];
}

Vec3 PartEdges::place_on(const Segment& segment, double t) const {
  const world::Placed& model = placed(segment.model);
  const auto end = [&](std::size_t i) {
    return Vec3(model.to_world * Vec4(model.mesh->whole().point(segment.edge[i]), 1));
  };
  return end(0) + t * (end(1) - end(0));
}

}  // namespace epura::drawing
