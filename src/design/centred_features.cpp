// SPDX-License-Identifier: Apache-2.0
#include "design/centred_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/portable_math.hpp"
#include "design/hexagons.hpp"
#include "design/pitch_circles.hpp"
#include "design/round_faces.hpp"
#include "design/tolerances.hpp"
#include "world/placed_circles.hpp"

namespace epura::design {

namespace {

using features::SurfaceKind;

constexpr double half_turn = 179.5;  // degrees
constexpr double half_turn_slack = 2;
constexpr double least_side = 90;         // degrees, of a groove
constexpr double nearly_parallel = 1e-3;  // sine
constexpr double opposite = 0.99;         // cosine

/// Finds round features of a model whose faces are recognised.
class FeatureFinder {
 public:
  FeatureFinder(const world::World& world, int model, world::PlacedPart part)
      : world_(world),
        model_(model),
        part_(std::move(part)),
        faces_(find_round_faces(world, model, part_)),
        used_(faces_.size(), 0),
        place_of_face_(part_.faces.size(), -1) {
    for (std::size_t i = 0; i < faces_.size(); ++i) place_of_face_[faces_[i].number] = static_cast<int>(i);
    find_vertices();
  }

  void add_to(CentredFeatures& found, std::vector<HoleSize>& sizes) {
    add_slots(found.slots);
    for (const std::vector<int>& group : coaxial_groups()) {
      const std::vector<int> faces = with_axis(group);
      if (faces.empty()) continue;
      sizes.push_back({static_cast<int>(found.round.size()), bores_of(faces)});
      found.round.push_back(feature_of(faces));
    }
    add_rims(found.round);
    for (const DesignHexagon& hexagon : find_hexagons(model_, find_plane_faces(world_, model_, part_)))
      add_hexagon(hexagon, found.round);
  }

 private:
  // Uses the uncut mesh: rims that a cut has shortened are still edges of the file.
  void find_vertices() {
    const world::Placed& placed = world_.models[model_];
    const mesh::Mesh& mesh = placed.mesh->whole();
    vertices_.resize(faces_.size());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      const int face = placed.part->face_of_triangle[t];
      if (face < 0 || place_of_face_[face] < 0) continue;
      const auto corners = mesh.triangle(t);
      std::vector<int>& vertices = vertices_[place_of_face_[face]];
      vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
  }

  [[nodiscard]] static bool is_straight(const RoundFace& round) {
    return round.face.surface.kind == SurfaceKind::cylinder || round.face.surface.kind == SurfaceKind::cone;
  }
  [[nodiscard]] bool is_half_cylinder(int i) const {
    const RoundFace& round = faces_[i];
    return round.face.surface.kind == SurfaceKind::cylinder && std::abs(round.face.sweep - 180) <= half_turn_slack &&
           round.has_its_axis();
  }
  [[nodiscard]] Vec3 middle_of(const RoundFace& round) const { return round.at(0.5 * (round.from + round.to)); }

  static double aside(const RoundFace& from, const Vec3& point) {
    return glm::length(glm::cross(point - from.face.surface.origin, from.face.surface.axis));
  }
  [[nodiscard]] bool are_coaxial(const RoundFace& a, const RoundFace& b) const {
    if (glm::length(glm::cross(a.face.surface.axis, b.face.surface.axis)) > nearly_parallel) return false;
    const double slack = std::max(32 * part_.tolerance, same_size * std::max(a.reach, b.reach));
    return std::min(aside(a, middle_of(b)), aside(b, middle_of(a))) <= slack;
  }

  // For each plane the half cylinders that are tangent to it.
  [[nodiscard]] std::map<int, std::vector<int>> half_cylinders_at_planes() const {
    std::map<int, std::vector<int>> at_planes;
    const auto add = [&](int plane, int face) {
      const int i = place_of_face_[face];
      if (part_.faces[plane].surface.kind != SurfaceKind::plane || i < 0 || !is_half_cylinder(i)) return;
      std::vector<int>& list = at_planes[plane];
      if (std::find(list.begin(), list.end(), i) == list.end()) list.push_back(i);
    };
    for (const features::PartBorder& border : world_.models[model_].part->borders) {
      if (border.kind != features::BorderKind::tangent || border.faces[0] < 0) continue;
      add(border.faces[0], border.faces[1]);
      add(border.faces[1], border.faces[0]);
    }
    return at_planes;
  }

  [[nodiscard]] bool face_each_other(const RoundFace& a, const RoundFace& b) const {
    const features::PartSurface &s = a.face.surface, &t = b.face.surface;
    if (a.face.inwards != b.face.inwards || std::abs(s.radius - t.radius) > same_size * s.radius ||
        glm::length(glm::cross(s.axis, t.axis)) > nearly_parallel)
      return false;
    const Vec3 d = middle_of(b) - middle_of(a), across = d - glm::dot(d, s.axis) * s.axis;
    const double length = glm::length(across);
    return length > same_size * s.radius && glm::dot(across, a.middle) < -opposite * length &&
           glm::dot(across, b.middle) > opposite * length;
  }

  void add_slots(std::vector<SlotFeature>& slots) {
    std::map<std::array<int, 2>, int> planes_between;
    for (const auto& at_plane : half_cylinders_at_planes()) {
      const std::vector<int>& faces = at_plane.second;
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
          const auto [low, high] = std::minmax(faces[i], faces[j]);
          ++planes_between[{low, high}];
        }
    }
    for (const auto& [pair, planes] : planes_between) {
      const auto [one, other] = pair;
      if (planes < 2 || used_[one] != 0 || used_[other] != 0 || !face_each_other(faces_[one], faces_[other])) continue;
      used_[one] = used_[other] = 1;
      SlotFeature slot{{feature_of({one}), feature_of({other})}};
      for (RoundFeature& end : slot.ends)
        end.enclosed = faces_[one].face.inwards && !faces_[one].cut && !faces_[other].cut;
      slots.push_back(std::move(slot));
    }
  }

  // Groups of faces about one axis, found by a sweep along a direction in which holes of a pattern do not line up.
  [[nodiscard]] std::vector<std::vector<int>> coaxial_groups() const {
    const Vec3 along = glm::normalize(Vec3(0.5377, 0.7236, 0.4326)), centre = world_.box.centre();
    const double window = same_size * glm::length(world_.box.size());
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < static_cast<int>(faces_.size()); ++i) {
      const RoundFace& round = faces_[i];
      const bool ring = round.face.surface.kind == SurfaceKind::torus && round.is_whole();
      if (used_[i] != 0 || !round.has_its_axis() || !(is_straight(round) || ring)) continue;
      const Vec3 d = round.face.surface.origin - centre;
      order.emplace_back(glm::dot(d - glm::dot(d, round.face.surface.axis) * round.face.surface.axis, along), i);
    }
    std::sort(order.begin(), order.end());
    DisjointSets sets(faces_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= window; ++j)
        if (are_coaxial(faces_[order[i].second], faces_[order[j].second])) sets.join(order[i].second, order[j].second);
    std::map<int, std::vector<int>> by_root;
    for (const auto& [place, i] : order) by_root[sets.root(i)].push_back(i);
    std::vector<std::vector<int>> groups;
    for (auto& [root, group] : by_root) {
      std::sort(group.begin(), group.end());
      groups.push_back(std::move(group));
    }
    return groups;
  }

  // Whether two arcs, one within the other, are the sides of a groove, or of a stroke of a letter.
  [[nodiscard]] bool are_sides_of_groove(const RoundFace& outer, const RoundFace& inner) const {
    const Vec3& axis = outer.face.surface.axis;
    if (!outer.face.inwards || inner.face.inwards ||
        glm::length(glm::cross(axis, inner.face.surface.axis)) > nearly_parallel)
      return false;
    const double depth = outer.to - outer.from, slack = 0.01 * depth;
    const Vec3 apart = middle_of(inner) - middle_of(outer);
    return std::abs(inner.to - inner.from - depth) <= slack && std::abs(glm::dot(apart, axis)) <= slack &&
           aside(outer, middle_of(inner)) < outer.reach - inner.reach;
  }
  [[nodiscard]] bool is_side_of_groove(const RoundFace& round) const {
    const auto is_arc = [](const RoundFace& face) {
      return face.face.surface.kind == SurfaceKind::cylinder && face.face.sweep >= least_side && !face.is_whole();
    };
    return is_arc(round) && std::any_of(faces_.begin(), faces_.end(), [&](const RoundFace& other) {
             return is_arc(other) && (are_sides_of_groove(round, other) || are_sides_of_groove(other, round));
           });
  }

  // The total sweep in degrees of the arcs of one cylinder that is interrupted, for example by flats.
  [[nodiscard]] double sweep_with_others(const RoundFace& round, const std::vector<int>& group) const {
    if (round.face.surface.kind != SurfaceKind::cylinder || round.is_whole()) return round.face.sweep;
    std::vector<std::array<double, 2>> arcs;
    for (const int i : group) {
      const RoundFace& other = faces_[i];
      if (other.face.surface.kind != SurfaceKind::cylinder || other.face.inwards != round.face.inwards ||
          other.is_whole() ||
          std::abs(other.face.surface.radius - round.face.surface.radius) > same_size * round.face.surface.radius)
        continue;
      // Angles relative to the middle of this arc; full turns are added so that arcs across 180 degrees are included.
      const double sine = glm::dot(round.face.surface.axis, glm::cross(round.middle, other.middle));
      const double middle = portable_atan2(sine, glm::dot(round.middle, other.middle)) * 180 / std::numbers::pi;
      for (const double turn : {-360, 0, 360})
        arcs.push_back({middle + turn - other.face.sweep / 2, middle + turn + other.face.sweep / 2});
    }
    std::sort(arcs.begin(), arcs.end());
    double sweep = 0, end = -180;
    for (const auto& [from, to] : arcs) {
      const double begin = std::max(from, end), stop = std::min(to, 180.0);
      sweep += std::max(stop - begin, 0.0);
      end = std::max(end, to);
    }
    return sweep;
  }

  // The faces of a group whose axis is drawn, with the spherical ends adjacent to them.
  [[nodiscard]] std::vector<int> with_axis(const std::vector<int>& group) const {
    std::vector<int> faces;
    for (const int i : group)
      if (sweep_with_others(faces_[i], group) >= half_turn && !is_side_of_groove(faces_[i])) faces.push_back(i);
    if (faces.empty()) return {};
    const std::set<int> of_group(faces.begin(), faces.end());
    for (const features::PartBorder& border : world_.models[model_].part->borders)
      for (const int side : {0, 1}) {
        if (border.faces[0] < 0) continue;
        const int ball = place_of_face_[border.faces[side]], next = place_of_face_[border.faces[1 - side]];
        if (ball >= 0 && of_group.count(next) > 0 && is_ball_on(ball, faces_[next])) faces.push_back(ball);
      }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  [[nodiscard]] bool is_ball_on(int ball, const RoundFace& shaft) const {
    const features::PartSurface& surface = faces_[ball].face.surface;
    return surface.kind == SurfaceKind::sphere &&
           aside(shaft, surface.origin) <= std::max(32 * part_.tolerance, same_size * shaft.reach);
  }

  [[nodiscard]] std::vector<double> bores_of(const std::vector<int>& faces) const {
    std::vector<double> radii;
    for (const int i : faces)
      if (faces_[i].face.surface.kind == SurfaceKind::cylinder && faces_[i].face.inwards && faces_[i].is_whole())
        radii.push_back(faces_[i].face.surface.radius);
    std::sort(radii.begin(), radii.end());
    return radii;
  }

  // Uses the axis of the largest face, which is the most accurate one.
  [[nodiscard]] RoundFeature feature_of(const std::vector<int>& faces) const {
    const RoundFace* best = nullptr;
    for (const int i : faces)
      if (faces_[i].face.surface.kind != SurfaceKind::sphere &&
          (best == nullptr || faces_[i].face.area > best->face.area))
        best = &faces_[i];
    RoundFeature feature{model_, best->face.surface.axis};
    feature.enclosed = true;
    std::vector<std::pair<double, double>> rings;
    for (const int i : faces) {
      const RoundFace& round = faces_[i];
      add_rings(rings, round, *best);
      feature.vertices.insert(feature.vertices.end(), vertices_[i].begin(), vertices_[i].end());
      feature.enclosed = feature.enclosed && round.face.inwards && round.is_whole() && !round.cut;
      feature.cut = feature.cut || round.cut;
    }
    std::sort(rings.begin(), rings.end());
    for (const auto& [height, radius] : rings) feature.rings.push_back({best->at(height), radius});
    std::sort(feature.vertices.begin(), feature.vertices.end());
    feature.vertices.erase(std::unique(feature.vertices.begin(), feature.vertices.end()), feature.vertices.end());
    return feature;
  }

  // Adds pairs of a height on the axis and a radius.
  void add_rings(std::vector<std::pair<double, double>>& rings, const RoundFace& round, const RoundFace& best) const {
    const auto height_of = [&](const Vec3& p) {
      return glm::dot(p - best.face.surface.origin, best.face.surface.axis);
    };
    if (round.face.surface.kind != SurfaceKind::sphere) {
      for (const double height : {round.from, round.to})
        rings.emplace_back(height_of(round.at(height)), round.radius_at(height));
      return;
    }
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (const int v : round.vertices) {
      from = std::min(from, height_of(world_.points[v]));
      to = std::max(to, height_of(world_.points[v]));
    }
    const double centre = height_of(round.face.surface.origin), radius = round.face.surface.radius;
    for (const double height : {from, to})
      rings.emplace_back(height, std::sqrt(std::max(radius * radius - (height - centre) * (height - centre), 0.0)));
  }

  // Adds whole circles around free-form faces that belong to no round face.
  void add_rims(std::vector<RoundFeature>& features) const {
    const bool free = std::any_of(part_.faces.begin(), part_.faces.end(), [](const features::PartFace& face) {
      return face.surface.kind == SurfaceKind::free_form;
    });
    if (!free) return;
    const std::vector<int> kinds = kinds_at_vertices();
    for (const mesh::MeshCircle& circle : world::find_circles(world_, model_)) {
      if (!circle.whole) continue;
      const bool unknown = std::all_of(circle.vertices.begin(), circle.vertices.end(), [&](int v) {
        return (kinds[v] & at_free_form) != 0 && (kinds[v] & at_round_face) == 0;
      });
      if (!unknown) continue;
      RoundFeature feature{model_, circle.axis, {{circle.centre, circle.radius}}, circle.vertices};
      std::sort(feature.vertices.begin(), feature.vertices.end());
      features.push_back(std::move(feature));
    }
  }

  // Its axis is that of round faces, which it continues, or its own.
  void add_hexagon(const DesignHexagon& hexagon, std::vector<RoundFeature>& features) const {
    const double slack = std::max(32 * part_.tolerance, same_size * hexagon.across_flats);
    const auto is_about = [&](const RoundFeature& feature) {
      return feature.model == model_ && glm::length(glm::cross(feature.axis, hexagon.axis)) <= nearly_parallel &&
             glm::length(glm::cross(feature.rings.front().centre - hexagon.centre, hexagon.axis)) <= slack;
    };
    auto feature = std::find_if(features.begin(), features.end(), is_about);
    if (feature == features.end()) {
      features.push_back({model_, hexagon.axis, {}, {}, hexagon.inwards});
      feature = std::prev(features.end());
    }
    feature->enclosed = feature->enclosed && hexagon.inwards;
    for (const double end : {-hexagon.half_height, hexagon.half_height})
      feature->rings.push_back({hexagon.centre + end * hexagon.axis, hexagon.across_flats / std::numbers::sqrt3});
    const Vec3 along = feature->axis;
    std::stable_sort(feature->rings.begin(), feature->rings.end(),
                     [&](const Ring& a, const Ring& b) { return glm::dot(a.centre - b.centre, along) < 0; });
    std::vector<int>& vertices = feature->vertices;
    vertices.insert(vertices.end(), hexagon.vertices.begin(), hexagon.vertices.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

  static constexpr int at_free_form = 1, at_round_face = 2;
  [[nodiscard]] std::vector<int> kinds_at_vertices() const {
    std::vector<int> kinds(world_.models[model_].mesh->points.size(), 0);
    const int first = world_.first_triangle[model_];
    for (int t = first; t < world_.first_triangle[model_ + 1]; ++t) {
      const int face = part_.face_of_triangle[t - first];
      const SurfaceKind kind = face < 0 ? SurfaceKind::free_form : part_.faces[face].surface.kind;
      for (const int v : world_.triangles[t])
        kinds[v - world_.first_vertex[model_]] |= kind == SurfaceKind::free_form ? at_free_form
                                                  : world::is_round(kind)        ? at_round_face
                                                                                 : 0;
    }
    return kinds;
  }

  const world::World& world_;
  int model_;
  world::PlacedPart part_;
  std::vector<RoundFace> faces_;
  std::vector<char> used_;                  ///< by face: whether it belongs to a slot
  std::vector<int> place_of_face_;          ///< index of each face among the round faces, -1 for others
  std::vector<std::vector<int>> vertices_;  ///< in the file, by round face
};

}  // namespace

CentredFeatures find_centred_features(const world::World& world, double crease_angle, const Progress& progress) {
  progress.begin("finding axes", world.models.size());
  CentredFeatures found;
  std::vector<HoleSize> sizes;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    if (auto part = world::place_part(world.models[model])) {
      FeatureFinder(world, model, std::move(*part)).add_to(found, sizes);
    } else {
      for (const mesh::MeshCircle& circle : world::find_round_rims(world, model, crease_angle)) {
        found.round.push_back({model, circle.axis, {{circle.centre, circle.radius}}, circle.vertices});
        std::sort(found.round.back().vertices.begin(), found.round.back().vertices.end());
      }
    }
    progress.advance(1);
  }
  found.pitch_circles = find_pitch_circles(found.round, sizes, progress);
  return found;
}

}  // namespace epura::design
