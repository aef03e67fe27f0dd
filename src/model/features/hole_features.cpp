// SPDX-License-Identifier: Apache-2.0
#include "features/hole_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/portable_math.hpp"
#include "features/tolerances.hpp"
#include "surfaces/holes.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

/// A face of a hole: heights are along the axis of the hole.
struct Piece {
  SurfaceKind kind;
  double begin, end;            ///< begin is nearer to the mouth once the pieces are in order
  double wide_begin, wide_end;  ///< radii there
  double slope;

  [[nodiscard]] Piece reversed() const { return {kind, -end, -begin, wide_end, wide_begin, slope}; }
};

class HoleReader {
 public:
  HoleReader(const world::World& world, int model, const world::PlacedPart& part)
      : world_(world), model_(model), part_(part) {}

  void read(const surfaces::Hole& hole, DescribedHoles& described) const {
    const surfaces::PartSurface& first = part_.faces[hole.faces.front()].surface;
    Vec3 axis = first.axis;
    std::vector<Piece> pieces = pieces_of(hole, first);
    const double low = pieces.front().begin, high = end_of(pieces);
    const int body = part_.faces[static_cast<std::size_t>(hole.faces.front())].body;
    const auto [closed_low, closed_high] = closed_ends(hole);
    const bool shut_low = closed_low || is_closed(first, body, low) || ends_in_tip(pieces.front().wide_begin, pieces);
    const bool shut_high = closed_high || is_closed(first, body, high) || ends_in_tip(radius_at_end(pieces), pieces);
    const bool mouth_is_low = shut_high || (!shut_low && is_rather_low(pieces, first, body));
    if (!mouth_is_low) {
      for (Piece& piece : pieces) piece = piece.reversed();
      std::reverse(pieces.begin(), pieces.end());
    } else {
      axis = -axis;
    }
    const double mouth = pieces.front().begin;
    HoleFeature design{model_, first.origin - mouth * axis, axis, 0, !shut_low && !shut_high};
    design.reach = end_of(pieces) - mouth;
    const bool certain = !(shut_low && shut_high);
    if (certain && interpret(pieces, design)) {
      if (const auto above = design.through ? std::nullopt : face_above_mouth(design, body))
        design.depth = end_of_bore(pieces) - mouth + *above;
      described.holes.push_back(design);
      return;
    }
    for (const Piece& piece : pieces)
      if (piece.kind == SurfaceKind::cylinder)
        described.bores.push_back(
            {model_, first.origin - piece.begin * axis, first.origin - piece.end * axis, axis, piece.wide_begin, true});
  }

 private:
  [[nodiscard]] std::vector<Piece> pieces_of(const surfaces::Hole& hole, const surfaces::PartSurface& first) const {
    std::vector<Piece> pieces;
    for (const int f : hole.faces) {
      const surfaces::PartFace& face = part_.faces[f];
      const double middle = glm::dot(face.surface.origin - first.origin, first.axis);
      const bool same_way = glm::dot(face.surface.axis, first.axis) > 0;
      const auto radius = [&face](double height) {
        return std::max(face.surface.radius + face.surface.slope * height, 0.0);
      };
      Piece piece{face.surface.kind, middle + face.from, middle + face.to,
                  radius(face.from), radius(face.to),    std::abs(face.surface.slope)};
      if (!same_way)
        piece = {face.surface.kind, middle - face.to,  middle - face.from,
                 radius(face.to),   radius(face.from), std::abs(face.surface.slope)};
      pieces.push_back(piece);
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.begin < b.begin; });
    return pieces;
  }

  static double end_of(const std::vector<Piece>& pieces) {
    double end = pieces.front().end;
    for (const Piece& piece : pieces) end = std::max(end, piece.end);
    return end;
  }
  static double radius_at_end(const std::vector<Piece>& pieces) {
    const auto last =
        std::max_element(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.end < b.end; });
    return last->wide_end;
  }
  // Whether the lower one of two open ends is the mouth: the wider one, or the one that a face square to the axis ends.
  [[nodiscard]] bool is_rather_low(const std::vector<Piece>& pieces, const surfaces::PartSurface& first,
                                   int body) const {
    const double low = pieces.front().wide_begin, high = radius_at_end(pieces);
    if (!are_same(low, high)) return low > high;
    const auto is_square = [&](double height) {
      const double at = glm::dot(first.origin, first.axis) + height;
      return std::any_of(part_.faces.begin(), part_.faces.end(), [&](const surfaces::PartFace& face) {
        return face.body == body && is_plane_at(face.surface, first.axis, at);
      });
    };
    return is_square(pieces.front().begin) && !is_square(end_of(pieces));
  }
  static bool ends_in_tip(double radius, const std::vector<Piece>& pieces) {
    double largest = 0;
    for (const Piece& piece : pieces) largest = std::max(largest, piece.wide_begin);
    return radius <= on_axis * largest;
  }
  static double end_of_bore(const std::vector<Piece>& pieces) {
    double end = -HUGE_VAL;
    for (const Piece& piece : pieces)
      if (piece.kind == SurfaceKind::cylinder) end = std::max(end, piece.end);
    return end;
  }

  // In the direction of the axis of its first face.
  [[nodiscard]] std::array<bool, 2> closed_ends(const surfaces::Hole& hole) const {
    const surfaces::PartFaces& part = *world_.models[static_cast<std::size_t>(model_)].part;
    const Vec3& axis = part.faces[static_cast<std::size_t>(hole.faces.front())].surface.axis;
    const bool same_way = glm::dot(hole.to - hole.from, axis) > 0;
    return same_way ? hole.closed : std::array{hole.closed[1], hole.closed[0]};
  }

  [[nodiscard]] double slack() const {
    return std::max(together * part_.tolerance, together_in_world * glm::length(world_.box.size()));
  }

  // How far above its mouth, along its axis, a hole begins, in a plane face or a round one that are perpendicular to
  // the axis there: where facets of a round face are cut, the mouth lies below it. Nothing if there is no such face.
  [[nodiscard]] std::optional<double> face_above_mouth(const HoleFeature& hole, int body) const {
    const double at = glm::dot(hole.mouth, hole.axis);
    for (const surfaces::PartFace& face : part_.faces) {
      if (is_plane_at(face.surface, hole.axis, at)) return 0;
      if (face.body != body || !world::is_round(face.surface.kind)) continue;
      const surfaces::Nearness near = surfaces::nearness_of(face.surface, hole.mouth);
      if (std::abs(near.distance) <= 2 * face.sagitta + 10 * slack() && are_parallel(near.normal, hole.axis) &&
          near.normal != Vec3(0))
        return glm::dot(near.normal, hole.axis) > 0 ? -near.distance : near.distance;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool is_plane_at(const surfaces::PartSurface& surface, const Vec3& axis, double at) const {
    return surface.kind == SurfaceKind::plane && are_parallel(surface.axis, axis) &&
           std::abs(glm::dot(surface.origin, axis) - at) <= 10 * slack();
  }

  // Whether a plane face of the same body closes the end at this height.
  [[nodiscard]] bool is_closed(const surfaces::PartSurface& bore, int body, double height) const {
    const world::Placed& placed = world_.models[model_];
    const mesh::Mesh& mesh = placed.mesh->whole();
    const Vec3 end = bore.origin + height * bore.axis;
    const double at = glm::dot(end, bore.axis);
    std::vector<char> wanted(part_.faces.size(), 0);
    for (std::size_t f = 0; f < wanted.size(); ++f)
      wanted[f] = part_.faces[f].body == body && is_plane_at(part_.faces[f].surface, bore.axis, at) ? 1 : 0;
    if (std::count(wanted.begin(), wanted.end(), 1) == 0) return false;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int face = placed.part->face_of_triangle[t];
      if (face >= 0 && wanted[face] != 0 && holds(mesh, t, end, bore.axis)) return true;
    }
    return false;
  }

  [[nodiscard]] bool holds(const mesh::Mesh& mesh, int triangle, const Vec3& point, const Vec3& axis) const {
    const Mat4& to_world = world_.models[model_].to_world;
    std::array<Vec3, 3> p;
    const auto corners = mesh.triangle(triangle);
    for (int k = 0; k < 3; ++k) p[k] = Vec3(to_world * Vec4(mesh.point(corners[k]), 1)) - point;
    return surfaces::height_on_axis(p, axis, slack()).has_value();
  }

  // Sets the sizes of a hole whose pieces are in order from the mouth; false if it has another shape.
  [[nodiscard]] bool interpret(std::vector<Piece> pieces, HoleFeature& hole) const {
    for (std::size_t i = 1; i < pieces.size(); ++i)
      if (std::abs(pieces[i].begin - pieces[i - 1].end) > 100 * slack()) return false;
    if (!hole.through && pieces.back().kind == SurfaceKind::cone && ends_in_tip(pieces.back().wide_end, pieces))
      pieces.pop_back();
    if (pieces.empty() || pieces.back().kind != SurfaceKind::cylinder) return false;
    hole.diameter = 2 * pieces.back().wide_begin;
    if (pieces.size() == 1) return true;
    const Piece& first = pieces.front();
    if (pieces.size() > 2 || 2 * first.wide_begin <= hole.diameter * (1 + same_size)) return false;
    if (first.kind == SurfaceKind::cylinder) {
      hole.counterbore = Recess{2 * first.wide_begin, first.end - first.begin};
      return true;
    }
    if (first.kind != SurfaceKind::cone) return false;
    const double half_angle = portable_atan2(first.slope, 1) * 180 / std::numbers::pi;
    hole.countersink = Recess{2 * first.wide_begin, 2 * half_angle};
    return true;
  }

  const world::World& world_;
  int model_;
  const world::PlacedPart& part_;
};

}  // namespace

DescribedHoles describe_holes(const world::World& world, int model, const world::PlacedPart& part) {
  const world::Placed& placed = world.models[model];
  const HoleReader reader(world, model, part);
  DescribedHoles described;
  for (const surfaces::Hole& hole : surfaces::find_holes(placed.mesh->whole(), *placed.part))
    reader.read(hole, described);
  return described;
}

}  // namespace epura::features
