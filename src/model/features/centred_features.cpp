// SPDX-License-Identifier: Apache-2.0
#include "features/centred_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "features/coaxial_faces.hpp"
#include "features/hexagons.hpp"
#include "features/pitch_circles.hpp"
#include "features/tolerances.hpp"
#include "features/turned_part.hpp"
#include "world/placed_circles.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

bool is_half_cylinder(const RoundFace& round) {
  return round.face.surface.kind == SurfaceKind::cylinder && std::abs(round.face.sweep - 180) <= half_slack &&
         round.has_its_axis();
}

// For each face the round faces that touch it at borders that are tangent, or at those that are not.
std::map<int, std::vector<int>> round_faces_beside(const RoundPart& of, bool tangent) {
  std::map<int, std::vector<int>> beside;
  const auto add = [&](int face, int other) {
    const int i = of.place_of_face[other];
    if (i < 0) return;
    std::vector<int>& list = beside[face];
    if (std::find(list.begin(), list.end(), i) == list.end()) list.push_back(i);
  };
  for (const surfaces::PartBorder& border : of.borders()) {
    if ((border.kind == surfaces::BorderKind::tangent) != tangent || border.faces[0] < 0 || border.faces[1] < 0)
      continue;
    add(border.faces[0], border.faces[1]);
    add(border.faces[1], border.faces[0]);
  }
  return beside;
}

bool is_plane(const RoundPart& of, int face) { return of.part.faces[face].surface.kind == SurfaceKind::plane; }

bool face_each_other(const RoundFace& a, const RoundFace& b) {
  const surfaces::PartSurface &s = a.face.surface, &t = b.face.surface;
  if (a.face.inwards != b.face.inwards || std::abs(s.radius - t.radius) > same_size * s.radius ||
      glm::length(glm::cross(s.axis, t.axis)) > told_apart_sine)
    return false;
  const Vec3 d = middle_of(b) - middle_of(a), across = d - glm::dot(d, s.axis) * s.axis;
  const double length = glm::length(across);
  return length > same_size * s.radius && glm::dot(across, a.middle) < -opposite_cosine * length &&
         glm::dot(across, b.middle) > opposite_cosine * length;
}

std::vector<double> bores_of(const RoundPart& of, const std::vector<int>& faces) {
  std::vector<double> radii;
  for (const int i : faces)
    if (of.faces[i].face.surface.kind == SurfaceKind::cylinder && of.faces[i].face.inwards && of.faces[i].is_whole())
      radii.push_back(of.faces[i].face.surface.radius);
  std::sort(radii.begin(), radii.end());
  return radii;
}

// Heights on the axis of the best face, and radii there, of both ends of a face.
std::array<std::pair<double, double>, 2> rings_of(const RoundFace& round, const RoundFace& best,
                                                  const world::World& world) {
  const auto height_of = [&](const Vec3& p) { return glm::dot(p - best.face.surface.origin, best.face.surface.axis); };
  if (round.face.surface.kind != SurfaceKind::sphere)
    return {{{height_of(round.at(round.from)), round.radius_at(round.from)},
             {height_of(round.at(round.to)), round.radius_at(round.to)}}};
  double from = HUGE_VAL, to = -HUGE_VAL;
  for (const int v : round.vertices) {
    from = std::min(from, height_of(world.points[v]));
    to = std::max(to, height_of(world.points[v]));
  }
  const double centre = height_of(round.face.surface.origin), radius = round.face.surface.radius;
  const auto radius_at = [&](double height) {
    return std::sqrt(std::max(radius * radius - (height - centre) * (height - centre), 0.0));
  };
  return {{{from, radius_at(from)}, {to, radius_at(to)}}};
}

// Uses the axis of the largest face, which is the most accurate one.
CentredRound feature_of(const RoundPart& of, const std::vector<int>& faces) {
  const RoundFace* best = nullptr;
  for (const int i : faces)
    if (of.faces[i].face.surface.kind != SurfaceKind::sphere &&
        (best == nullptr || of.faces[i].face.area > best->face.area))
      best = &of.faces[i];
  CentredRound feature{of.model, best->face.surface.axis};
  feature.enclosed = true;
  std::vector<std::pair<double, double>> rings;
  for (const int i : faces) {
    const RoundFace& round = of.faces[i];
    for (const auto& ring : rings_of(round, *best, of.world)) rings.push_back(ring);
    feature.vertices.insert(feature.vertices.end(), of.vertices[i].begin(), of.vertices[i].end());
    feature.enclosed = feature.enclosed && round.face.inwards && round.is_whole() && !round.cut;
    feature.cut = feature.cut || round.cut;
  }
  std::sort(rings.begin(), rings.end());
  for (const auto& [height, radius] : rings) feature.rings.push_back({best->at(height), radius});
  std::sort(feature.vertices.begin(), feature.vertices.end());
  feature.vertices.erase(std::unique(feature.vertices.begin(), feature.vertices.end()), feature.vertices.end());
  return feature;
}

/// Pairs of round faces.
using RoundEnds = std::vector<std::array<int, 2>>;

// The half cylinders that are ends of slots.
RoundEnds ends_of_slots(const RoundPart& of) {
  std::map<std::array<int, 2>, int> planes_between;
  for (auto& [plane, faces] : round_faces_beside(of, true)) {
    if (!is_plane(of, plane)) continue;
    std::erase_if(faces, [&](int i) { return !is_half_cylinder(of.faces[i]); });
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = i + 1; j < faces.size(); ++j) {
        const auto [low, high] = std::minmax(faces[i], faces[j]);
        ++planes_between[{low, high}];
      }
  }
  RoundEnds ends;
  std::vector<char> used(of.faces.size(), 0);
  for (const auto& [pair, planes] : planes_between) {
    const auto [one, other] = pair;
    if (planes < 2 || used[one] != 0 || used[other] != 0 || !face_each_other(of.faces[one], of.faces[other])) continue;
    used[one] = used[other] = 1;
    ends.push_back(pair);
  }
  return ends;
}

CentredSlot slot_of(const RoundPart& of, const std::array<int, 2>& ends) {
  const auto [one, other] = ends;
  CentredSlot slot{{feature_of(of, {one}), feature_of(of, {other})}};
  for (CentredRound& end : slot.ends)
    end.enclosed = of.faces[one].face.inwards && !of.faces[one].cut && !of.faces[other].cut;
  return slot;
}

// The distance between planes that are mirror images in one with this normal through a point: 0 if they taper, nothing
// if they are no such images.
std::optional<double> width_between(const surfaces::PartSurface& one, const surfaces::PartSurface& other,
                                    const Vec3& at, const Vec3& normal, double slack) {
  const Vec3 off = at + glm::reflect(one.origin - at, normal) - other.origin;
  if (glm::length(glm::cross(glm::reflect(one.axis, normal), other.axis)) > told_apart_sine ||
      std::abs(glm::dot(off, other.axis)) > slack)
    return std::nullopt;
  const bool taper = glm::length(glm::cross(one.axis, normal)) > told_apart_sine;
  return taper ? 0 : 2 * std::abs(glm::dot(one.origin - at, normal));
}

// For each plane the round faces that it meets in corners, perhaps behind a fillet.
std::map<int, std::vector<int>> round_faces_at_corners(const RoundPart& of) {
  std::map<int, std::vector<int>> at_corners = round_faces_beside(of, false);
  const std::map<int, std::vector<int>> tangent = round_faces_beside(of, true);
  for (const auto& [plane, fillets] : tangent)
    for (const int fillet : fillets)
      if (const auto behind = tangent.find(of.faces[fillet].number);
          behind != tangent.end() && of.faces[fillet].face.surface.kind == SurfaceKind::cylinder)
        at_corners[plane].insert(at_corners[plane].end(), behind->second.begin(), behind->second.end());
  std::erase_if(at_corners, [&](const auto& one) { return !is_plane(of, one.first); });
  return at_corners;
}

// Between features of which the round faces are given.
std::vector<CentredArm> arms_of(const RoundPart& of, const std::vector<CentredRound>& round,
                                const std::vector<std::vector<int>>& faces) {
  std::vector<int> feature(of.faces.size(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const int face : faces[i]) feature[face] = static_cast<int>(i);
  std::map<std::array<int, 2>, std::vector<int>> planes_between;
  for (const auto& [plane, list] : round_faces_at_corners(of)) {
    std::set<int> ends;
    for (const int face : list)
      if (feature[face] >= 0 &&
          std::abs(glm::dot(round[feature[face]].axis, of.part.faces[plane].surface.axis)) <= told_apart_sine)
        ends.insert(feature[face]);
    for (auto i = ends.begin(); i != ends.end(); ++i)
      for (auto j = std::next(i); j != ends.end(); ++j) planes_between[{*i, *j}].push_back(plane);
  }
  std::vector<CentredArm> arms;
  for (const auto& [ends, planes] : planes_between) {
    const CentredRound &one = round[ends[0]], &other = round[ends[1]];
    const Vec3 at = one.rings.front().centre, normal = glm::cross(one.axis, other.rings.front().centre - at);
    if (glm::length(glm::cross(one.axis, other.axis)) > told_apart_sine || !(glm::length(normal) > 0)) continue;
    for (std::size_t i = 0; i < planes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const auto width = width_between(of.part.faces[planes[i]].surface, of.part.faces[planes[j]].surface, at,
                                             glm::normalize(normal), slack_of(of.part.tolerance, glm::length(normal))))
          arms.push_back({ends, *width});
  }
  return arms;
}

constexpr int at_free_form = 1, at_round_face = 2;
std::vector<int> kinds_at_vertices(const RoundPart& of) {
  std::vector<int> kinds(of.world.models[of.model].mesh->points.size(), 0);
  const int first = of.world.first_triangle[of.model];
  for (int t = first; t < of.world.first_triangle[of.model + 1]; ++t) {
    const int face = of.part.face_of_triangle[t - first];
    const SurfaceKind kind = face < 0 ? SurfaceKind::free_form : of.part.faces[face].surface.kind;
    for (const int v : of.world.triangles[t])
      kinds[v - of.world.first_vertex[of.model]] |= kind == SurfaceKind::free_form ? at_free_form
                                                    : world::is_round(kind)        ? at_round_face
                                                                                   : 0;
  }
  return kinds;
}

// Whole circles around free-form faces that belong to no round face.
std::vector<CentredRound> rims_of(const RoundPart& of) {
  const bool free = std::any_of(of.part.faces.begin(), of.part.faces.end(), [](const surfaces::PartFace& face) {
    return face.surface.kind == SurfaceKind::free_form;
  });
  if (!free) return {};
  std::vector<CentredRound> features;
  const std::vector<int> kinds = kinds_at_vertices(of);
  for (const mesh::MeshCircle& circle : world::find_circles(of.world, of.model)) {
    if (!circle.whole) continue;
    const bool unknown = std::all_of(circle.vertices.begin(), circle.vertices.end(), [&](int v) {
      return (kinds[v] & at_free_form) != 0 && (kinds[v] & at_round_face) == 0;
    });
    if (!unknown) continue;
    CentredRound feature{of.model, circle.axis, {{circle.centre, circle.radius}}, circle.vertices};
    std::sort(feature.vertices.begin(), feature.vertices.end());
    features.push_back(std::move(feature));
  }
  return features;
}

// The features of one model, with a hexagon: its axis is that of round faces, which it continues, or its own.
std::vector<CentredRound> with_hexagon(const RoundPart& of, const HexagonFeature& hexagon,
                                       std::vector<CentredRound> features) {
  const double slack = slack_of(of.part.tolerance, hexagon.across_flats);
  const auto is_about = [&](const CentredRound& feature) {
    return glm::length(glm::cross(feature.axis, hexagon.axis)) <= told_apart_sine &&
           distance_from_line(feature.rings.front().centre, hexagon.centre, hexagon.axis) <= slack;
  };
  auto feature = std::find_if(features.begin(), features.end(), is_about);
  if (feature == features.end()) {
    features.push_back({of.model, hexagon.axis, {}, {}, hexagon.inwards});
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
  return features;
}

// With the own axes of a turned part across those that have its axis.
std::vector<CentredRound> with_own_axes(const RoundPart& of, const std::vector<PlaneFace>& planes,
                                        std::vector<CentredRound> features) {
  const world::Placed& placed = of.world.models[static_cast<std::size_t>(of.model)];
  std::vector<Vec3> points;
  Box box;
  for (int v = 0; v < static_cast<int>(placed.mesh->whole().points.size()); ++v)
    box.add(points.emplace_back(placed.to_world * Vec4(placed.mesh->whole().point(v), 1)));
  std::vector<PlaneFeature> inclined;
  FlatEnds flat{};
  for (const PlaneFace& plane : planes) {
    if (plane.corners.empty()) continue;
    const int axis = axis_along(plane.normal);
    if (axis < 0) inclined.push_back({of.model, plane.normal, plane.corners});
    for (const std::size_t end : {0U, 1U})
      if (axis >= 0 &&
          std::abs(plane.corners.front()[axis] - (end == 0 ? box.min : box.max)[axis]) <= same_size * box.size()[axis])
        flat[static_cast<std::size_t>(axis)][end] = true;
  }
  if (const auto turned = find_turned_part(inclined, points, flat))
    for (CentredRound& feature : features)
      if (are_parallel(feature.axis, turned->axis)) feature.beside = turned->directions[0];
  return features;
}

/// Features of one model.
struct ModelFeatures {
  std::vector<CentredRound> round{};
  std::vector<std::vector<double>> bores{};  ///< radii of the first round features, as in HoleSize
  std::vector<CentredSlot> slots{};
  std::vector<CentredArm> arms{};  ///< between the round features of this model
};

ModelFeatures features_of(const RoundPart& of) {
  ModelFeatures found;
  std::vector<char> used(of.faces.size(), 0);
  for (const std::array<int, 2>& ends : ends_of_slots(of)) {
    for (const int end : ends) used[end] = 1;
    found.slots.push_back(slot_of(of, ends));
  }
  std::vector<std::vector<int>> groups;
  for (const std::vector<int>& group : coaxial_groups(of, used)) {
    std::vector<int> faces = faces_with_axis(of, group);
    if (faces.empty()) continue;
    found.bores.push_back(bores_of(of, faces));
    found.round.push_back(feature_of(of, faces));
    groups.push_back(std::move(faces));
  }
  found.arms = arms_of(of, found.round, groups);
  for (CentredRound& rim : rims_of(of)) found.round.push_back(std::move(rim));
  const std::vector<PlaneFace> planes = find_plane_faces(of.world, of.model, of.part);
  for (const HexagonFeature& hexagon : find_hexagons(of.model, planes))
    found.round = with_hexagon(of, hexagon, std::move(found.round));
  if (of.world.models.size() == 1) found.round = with_own_axes(of, planes, std::move(found.round));
  return found;
}

// If no faces are recognised.
std::vector<CentredRound> rims_of_mesh(const world::World& world, int model, double crease_angle) {
  std::vector<CentredRound> rims;
  for (const mesh::MeshCircle& circle : world::find_round_rims(world, model, crease_angle)) {
    rims.push_back({model, circle.axis, {{circle.centre, circle.radius}}, circle.vertices});
    std::sort(rims.back().vertices.begin(), rims.back().vertices.end());
  }
  return rims;
}

}  // namespace

CentredFeatures find_centred_features(const world::World& world, double crease_angle, const Progress& progress) {
  progress.begin("finding axes", world.models.size());
  CentredFeatures found;
  std::vector<HoleSize> sizes;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    auto part = world::place_part(world.models[model]);
    ModelFeatures own = part ? features_of(make_round_part(world, model, std::move(*part)))
                             : ModelFeatures{rims_of_mesh(world, model, crease_angle)};
    const int first = static_cast<int>(found.round.size());
    for (std::size_t i = 0; i < own.bores.size(); ++i)
      sizes.push_back({first + static_cast<int>(i), std::move(own.bores[i])});
    std::move(own.round.begin(), own.round.end(), std::back_inserter(found.round));
    std::move(own.slots.begin(), own.slots.end(), std::back_inserter(found.slots));
    for (CentredArm& arm : own.arms) found.arms.push_back({{first + arm.ends[0], first + arm.ends[1]}, arm.width});
    progress.advance(1);
  }
  found.pitch_circles = find_pitch_circles(found.round, sizes, progress);
  return found;
}

}  // namespace epura::features
