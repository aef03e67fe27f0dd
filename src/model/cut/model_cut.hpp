// SPDX-License-Identifier: Apache-2.0
// The cut of one model of a world.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "cut/cut_gaps.hpp"
#include "cut/cut_mesh.hpp"
#include "cut/cut_outline.hpp"
#include "cut/cut_world.hpp"
#include "cut/cutting_surface.hpp"
#include "cut/split_world.hpp"

namespace epura::cut {

/// A region of a split world, in which a cut ends.
struct RegionOfCut {
  const SplitWorld& split;
  const CutRegion& region;
  int number;

  [[nodiscard]] bool has_triangle(int triangle) const { return split.region_of_triangle[triangle] == number; }
  [[nodiscard]] bool has_point(const Vec3& point) const {
    return std::all_of(region.borders.begin(), region.borders.end(),
                       [&](const CutBorder& border) { return side_of(border, point, split.slack) <= 0; });
  }
};

/// The cut of one model, by one plane or in one region of a surface; then all of them together.
struct ModelCut {
  const world::World& world;
  int model;
  const PlaneFrame& frame;
  CutMesh cut;
  const RegionOfCut* region = nullptr;
  std::size_t of_surface = 0;  ///< number of triangles before those of cut faces
  std::vector<WorldCutFace> faces{};
  std::vector<std::array<int, 2>> divided{};  ///< in the plane, of bodies that others overlap; lower vertex first
  std::vector<CutSegment> loose{};            ///< of outlines that are open, or that bound no certain area
  std::vector<OpenOutline> open{};
  std::vector<BridgedGaps> bridged{};
  double moved = 0;  ///< largest distance at which vertices were moved to surfaces

  [[nodiscard]] const mesh::Mesh& mesh() const { return *world.models[model].mesh; }
  [[nodiscard]] int file_vertices() const { return world.first_vertex[model + 1] - world.first_vertex[model]; }
  [[nodiscard]] CutPlaces places() const {
    const auto first = static_cast<std::size_t>(world.first_vertex[model]);
    return {{world.points.data() + first, static_cast<std::size_t>(file_vertices())}, cut.points};
  }

  void close();
  [[nodiscard]] GapLimits gap_limits() const;
  void tell_outlines_apart();
  void say_bridged(int body, const std::vector<Bridge>& bridges);
  void leave_out_doubtful();
  void take_faces_in_plane(const std::vector<int>& material, const std::vector<char>& is_open);
  void keep_triangle(int triangle, int body, std::vector<CutSegment>& segments);
  /// Divides triangles and sides in the plane into the parts of `chains`, vertices by the ends of a side, lower one
  /// first. Parts that are in no outline afterwards are not drawn.
  void divide_sides(const std::map<std::array<int, 2>, std::vector<int>>& chains);
  void finish();
  void add_face(int body, std::span<const CutSegment> segments);
  void keep_region();
  void clip_outlines_to_region();
  void append(ModelCut&& other);
  void drop_surface();
  [[nodiscard]] mesh::Mesh make_mesh() const;
};

}  // namespace epura::cut
