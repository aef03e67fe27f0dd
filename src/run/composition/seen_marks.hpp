// SPDX-License-Identifier: Apache-2.0
// Where views show faces of the part: the points at which leaders and datums may end.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "composition/page_triangle.hpp"
#include "projection/projection.hpp"
#include "search/bounds_tree.hpp"
#include "surfaces/recognise.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Sine of the tilt up to which faces are seen edge-on and lengths are true: it shortens by half a millionth.
inline constexpr double max_tilt = 1e-3;

/// Numbers of the triangles of the world on each face of a model; none without recognised faces.
using TrianglesByFace = std::vector<std::vector<std::size_t>>;
TrianglesByFace triangles_by_face(const world::World& world, std::size_t model);

/// A face of a model, by their numbers.
struct FaceName {
  int model, face;

  bool operator==(const FaceName&) const = default;
};

/// A point of a face that a view shows.
struct SeenMark {
  Vec3 point;
  bool on_line;  ///< the face is seen from the side there
  double worth;  ///< length of the line around it, or width of the area; in the world
};

/// An orthographic view of the models before it is drawn, or of what sections leave of them.
class FaceView {
 public:
  /// `world` must outlive it.
  FaceView(std::string name, projection::Projection projection, const world::World& world);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const projection::Projection& projection() const { return projection_; }
  /// Along and up the page, and towards the viewer.
  [[nodiscard]] Vec3 on_page(const Vec3& point) const {
    return {glm::dot(point, projection_.u), glm::dot(point, projection_.v), glm::dot(point, projection_.n)};
  }
  /// The point of the world.
  [[nodiscard]] Vec3 in_world(const Vec3& page) const {
    return page.x * projection_.u + page.y * projection_.v + page.z * projection_.n;
  }
  /// Whether nothing hides a point of the models.
  [[nodiscard]] bool shows(const Vec3& point) const { return is_nearest(on_page(point)); }
  /// Marks on a face, whose surface is in the world; the one with the greatest worth first.
  [[nodiscard]] std::vector<SeenMark> marks_on(const FaceName& name, const surfaces::PartFace& face) const;

 private:
  using Corners = std::array<Vec3, 3>;

  [[nodiscard]] Corners corners_of(std::size_t triangle) const;
  [[nodiscard]] bool has_face_between(const Vec2& place, double from, double to) const;
  [[nodiscard]] bool is_nearest(const Vec3& page) const;
  [[nodiscard]] double clarity_of_edge(const Vec3& page, const Vec2& across) const;
  void add_line(std::vector<SeenMark>& marks, const Vec3& from, const Vec3& to) const;
  void add_outlines(std::vector<SeenMark>& marks, const surfaces::PartFace& face) const;
  void add_areas(std::vector<SeenMark>& marks, const std::vector<std::size_t>& triangles) const;

  std::string name_;
  projection::Projection projection_;
  const world::World& world_;
  std::vector<std::size_t> order_;          ///< of triangles: beside one another on the page
  search::BoundsTree<3> tree_;              ///< of these on the page, with their depth
  double slack_;                            ///< by which depths of one place may differ
  std::vector<TrianglesByFace> triangles_;  ///< by model
};

}  // namespace epura::pipeline
