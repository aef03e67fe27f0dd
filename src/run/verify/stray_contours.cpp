// SPDX-License-Identifier: Apache-2.0
#include "verify/stray_contours.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "base/groups.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "verify/confidence.hpp"
#include "verify/sample.hpp"

namespace epura::verify {

namespace {

// Places along a contour that has left its facets, by which the part that has is measured.
constexpr int steps_of_contour = 256;
// A surface rises over a facet by an eighth of the facet's height times its turn to the next one; facets of unequal
// height, and two directions in which it bends, take less than the rest.
constexpr double max_rises = 8;
constexpr std::size_t max_listed = 10;

using Shape = std::array<Vec2, 3>;

bool contains(const Shape& shape, const Vec2& p) {
  const auto side = [&](std::size_t i) { return cross(shape[(i + 1) % 3] - shape[i], p - shape[i]); };
  const double a = side(0), b = side(1), c = side(2);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

double distance(const Shape& shape, const Vec2& p) {
  if (contains(shape, p)) return 0;
  return std::min({distance_to_segment(p, shape[0], shape[1]), distance_to_segment(p, shape[1], shape[2]),
                   distance_to_segment(p, shape[2], shape[0])});
}

/// The facets around edges of one model.
class Facets {
 public:
  Facets(const VerifyInput& input, int model)
      : input_(input),
        model_(model),
        mesh_(*input.world.models[model].mesh),
        part_(*input.world.models[model].part),
        at_vertex_(mesh_.points.size(), [&](const auto& visit) {
          for (std::size_t i = 0; i < mesh_.corners.size(); ++i)
            visit(static_cast<std::size_t>(mesh_.corners[i]), static_cast<int>(i / 3));
        }) {
    for (const surfaces::PartBorder& border : part_.borders)
      if (border.kind == surfaces::BorderKind::tangent) tangent_.insert(border.faces);
  }

  /// Where on the page a contour of an edge may be.
  struct Room {
    std::vector<Shape> shapes;
    double beside = 0;  ///< mm
  };

  // The facets of the faces of the edge at its ends and one facet farther, and those of faces that continue them
  // smoothly at its ends. Nothing if one of them reaches behind the viewer.
  [[nodiscard]] std::optional<Room> room_around(const mesh::MeshEdge& edge) const {
    std::set<int> faces, near, all;
    for (const int t : mesh_.triangles_of(edge)) faces.insert(face_of(t));
    const auto continues = [&](int face) {
      return std::ranges::any_of(faces, [&](int own) {
        return own == face || tangent_.contains({std::min(own, face), std::max(own, face)});
      });
    };
    for (const int v : edge.vertex)
      for (const int t : at_vertex_[static_cast<std::size_t>(v)])
        if (continues(face_of(t))) near.insert(t);
    for (const int t : near)
      for (const int v : mesh_.triangle(t))
        for (const int other : at_vertex_[static_cast<std::size_t>(v)])
          if (faces.contains(face_of(other))) all.insert(other);
    all.insert(near.begin(), near.end());
    Room room;
    double rise = 0;
    for (const int t : all) {
      const auto shape = on_page(t);
      if (!shape) return std::nullopt;
      room.shapes.push_back(*shape);
      rise = std::max(rise, rise_over(t));
    }
    room.beside = max_rises * rise * page_per_length(point(edge.vertex[0]));
    return room;
  }

  [[nodiscard]] const mesh::MeshEdge* edge_between(const std::array<int, 2>& ends) const {
    return mesh_.edge_between({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
  }

 private:
  [[nodiscard]] int face_of(int triangle) const { return part_.face_of_triangle[static_cast<std::size_t>(triangle)]; }

  [[nodiscard]] Vec3 point(int vertex) const {
    return input_.world.points[static_cast<std::size_t>(input_.world.first_vertex[model_] + vertex)];
  }

  [[nodiscard]] std::optional<Shape> on_page(int triangle) const {
    Shape shape;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec4 page = input_.drawing.world_to_page * Vec4(point(mesh_.triangle(triangle)[i]), 1);
      if (!(page.w > 0)) return std::nullopt;
      shape[i] = Vec2(page) / page.w;
    }
    return shape;
  }

  // At most so many mm of the page show a unit of length at a point: the norm of the derivative of the map.
  [[nodiscard]] double page_per_length(const Vec3& place) const {
    const Mat4 rows = glm::transpose(input_.drawing.world_to_page);
    const Vec4 page = input_.drawing.world_to_page * Vec4(place, 1);
    double squares = 0;
    for (int i = 0; i < 2; ++i) {
      const Vec3 gradient = (Vec3(rows[i]) - page[i] / page.w * Vec3(rows[3])) / page.w;
      squares += glm::dot(gradient, gradient);
    }
    return std::sqrt(squares);
  }

  // The greatest height of a surface over a facet that turns to its neighbours in the face as the facets do.
  [[nodiscard]] double rise_over(int triangle) const {
    const std::array<int, 3> corners = mesh_.triangle(triangle);
    double rise = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const mesh::MeshEdge* side = edge_between({corners[i], corners[(i + 1) % 3]});
      if (side == nullptr || side->count != 2) continue;
      const auto both = mesh_.triangles_of(*side);
      if (face_of(both[0]) != face_of(both[1])) continue;
      const Vec3 from = point(side->vertex[0]), along = glm::normalize(point(side->vertex[1]) - from);
      const auto away = [&](int t) {
        Vec3 farthest(0);
        for (const int v : mesh_.triangle(t)) {
          const Vec3 to = point(v) - from, beside = to - glm::dot(to, along) * along;
          if (glm::length(beside) > glm::length(farthest)) farthest = beside;
        }
        return farthest;
      };
      const Vec3 one = away(both[0]), two = -away(both[1]);
      const double turn = std::atan2(glm::length(glm::cross(one, two)), glm::dot(one, two));
      rise = std::max(rise, turn * std::max(glm::length(one), glm::length(two)) / 8);
    }
    return rise;
  }

  const VerifyInput& input_;
  int model_;
  const mesh::Mesh& mesh_;
  const surfaces::PartFaces& part_;
  Groups<int> at_vertex_;
  std::set<std::array<int, 2>> tangent_;  ///< faces that continue each other
};

// The part of a contour that has left the room for it: its length, and the place farthest away.
std::optional<report::OutlineFault> stray_part(const drawing::Segment& segment, const Facets::Room& room,
                                               double beside) {
  const auto away = [&](double s) {
    const Vec2 place = segment.from + s * (segment.to - segment.from);
    double nearest = HUGE_VAL;
    for (const Shape& shape : room.shapes) nearest = std::min(nearest, distance(shape, place));
    return nearest - beside;
  };
  if (std::ranges::none_of(std::array{0.0, 0.5, 1.0}, [&](double s) { return away(s) > 0; })) return std::nullopt;
  int outside = 0;
  double farthest = 0, at = 0;
  for (int i = 0; i < steps_of_contour; ++i) {
    const double s = (i + 0.5) / steps_of_contour, beyond = away(s);
    if (!(beyond > 0)) continue;
    ++outside;
    if (beyond <= farthest) continue;
    farthest = beyond;
    at = s;
  }
  const double length = glm::distance(segment.from, segment.to) * outside / steps_of_contour;
  const Vec2 place = segment.from + at * (segment.to - segment.from);
  return report::OutlineFault{"unfounded", place, length, segment.model, segment.edge, {}};
}

}  // namespace

void add_stray_contours(const VerifyInput& input, const Tolerance& tolerance, report::OutlineCheck& check,
                        const Progress& progress) {
  const double reach = std::max(guaranteed * tolerance.size, 16 * tolerance.contact);
  std::vector<std::optional<Facets>> facets(input.world.models.size());
  for (std::size_t m = 0; m < facets.size(); ++m) {
    const world::Placed& placed = input.world.models[m];
    if (placed.part != nullptr && placed.mesh->uncut == nullptr) facets[m].emplace(input, static_cast<int>(m));
  }
  const auto& segments = input.drawing.segments;
  std::vector<std::optional<report::OutlineFault>> found(segments.size());
  parallel_for(segments.size(), 256, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const drawing::Segment& segment = segments[i];
      if (segment.kind != EdgeKind::contour || segment.edge[0] < 0 || drawing::is_link(segment)) continue;
      if (!facets[static_cast<std::size_t>(segment.model)]) continue;
      const Facets& around = *facets[static_cast<std::size_t>(segment.model)];
      const mesh::MeshEdge* edge = around.edge_between(segment.edge);
      const auto room = edge == nullptr ? std::nullopt : around.room_around(*edge);
      if (room) found[i] = stray_part(segment, *room, room->beside + reach + input.drawing.distances.joined_within);
    }
  });
  for (std::optional<report::OutlineFault>& fault : found) {
    if (!fault || !(fault->length > reach)) continue;
    const int places = check.length > 0 ? static_cast<int>(std::max(1.0, fault->length / check.length)) : 1;
    check.ink += places;
    check.unfounded += places;
    fault->model = input.world.number_in_scene(fault->model);
    check.worst.push_back(*fault);
  }
  std::ranges::stable_sort(check.worst, std::greater{}, &report::OutlineFault::length);
  check.worst.resize(std::min(check.worst.size(), max_listed));
  if (check.wrong() > 0) check.at_most = greatest_share(check.wrong(), check.asked + check.ink, stated_confidence);
}

}  // namespace epura::verify
