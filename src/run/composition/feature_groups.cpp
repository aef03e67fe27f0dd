// SPDX-License-Identifier: Apache-2.0
#include "composition/feature_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sheet/phrases.hpp"
#include "surfaces/numbers.hpp"
#include "surfaces/part_surface.hpp"

namespace epura::pipeline {

namespace {

using sheet::SizeKind;

/// The words for features in a language.
class FeatureWords {
 public:
  FeatureWords(const sheet::Notation& notation, std::string_view language) : notation_(notation), language_(language) {}

  [[nodiscard]] std::string operator()(const features::HoleFeature& hole) const {
    std::string text = size(hole.thread, hole.diameter);
    if (hole.through) text += say("through");
    const bool has_length = hole.thread && hole.thread->length;
    if (has_length) text += say("thread deep", {length(*hole.thread->length)});
    if (!hole.through && hole.depth) text += say(has_length ? "core deep" : "deep", {length(*hole.depth)});
    if (const auto& recess = hole.counterbore)
      text += say("counterbore", {length(recess->diameter), length(recess->size)});
    if (const auto& recess = hole.countersink)
      text += say("countersink", {length(recess->diameter), sheet::angle_text(recess->size, notation_)});
    return text;
  }
  [[nodiscard]] std::string operator()(const features::CylinderFeature& one) const {
    return say(one.inwards ? "bore" : "shaft", {size(one.thread, 2 * one.radius)});
  }
  [[nodiscard]] std::string operator()(const features::SlotFeature& one) const {
    return say("slot", {length(2 * one.radius)});
  }
  [[nodiscard]] std::string operator()(const features::HexagonFeature& one) const {
    return say("hexagon", {length(one.across_flats)});
  }
  [[nodiscard]] std::string operator()(const features::ArcFeature& one) const {
    return say("radius", {length(one.radius)});
  }

 private:
  [[nodiscard]] std::string say(std::string_view key, const std::vector<std::string>& texts = {}) const {
    return sheet::phrase(key, language_, texts);
  }
  [[nodiscard]] std::string length(double value) const { return sheet::length_text(value, notation_); }
  [[nodiscard]] std::string size(const std::optional<features::ThreadFeature>& thread, double diameter) const {
    return thread ? thread->text : say("diameter", {length(diameter)});
  }

  const sheet::Notation& notation_;
  std::string_view language_;
};

/// A face of a model in the world.
struct PlacedFace {
  int model;
  surfaces::PartSurface surface;
  bool inwards;
  Vec3 middle;                ///< of its area
  double tolerance;           ///< of the part
  std::vector<int> vertices;  ///< of a plane, in the model's file; ascending

  [[nodiscard]] bool is_about(const Vec3& point, const Vec3& axis, double size) const {
    return surfaces::has_axis(surface.kind) && features::are_parallel(surface.axis, axis) &&
           features::distance_from_line(surface.origin, point, axis) <= features::slack_of(tolerance, size);
  }
  [[nodiscard]] bool is_cylinder(double radius) const {
    return surface.kind == surfaces::SurfaceKind::cylinder &&
           std::abs(surface.radius - radius) <= features::slack_of(tolerance, radius);
  }
  // Whether its middle is between two places along an axis.
  [[nodiscard]] bool is_between(const Vec3& from, const Vec3& to, const Vec3& axis, double slack) const {
    const auto [low, high] = std::minmax({glm::dot(from, axis), glm::dot(to, axis)});
    const double at = glm::dot(middle, axis);
    return at >= low - slack && at <= high + slack;
  }
};

bool is_of(const PlacedFace& face, const features::HoleFeature& hole) {
  const double slack = features::slack_of(face.tolerance, hole.diameter);
  return face.model == hole.model && face.inwards && face.is_about(hole.mouth, hole.axis, hole.diameter) &&
         face.is_between(hole.mouth, hole.mouth - hole.reach * hole.axis, hole.axis, slack);
}

bool is_of(const PlacedFace& face, const features::CylinderFeature& one) {
  const auto [from, to] = one.reach.value_or(std::array{one.from, one.to});
  return face.model == one.model && face.inwards == one.inwards && face.is_cylinder(one.radius) &&
         face.is_about(one.from, one.axis, one.radius) &&
         face.is_between(from, to, one.axis, features::slack_of(face.tolerance, one.radius));
}

bool is_of(const PlacedFace& face, const features::SlotFeature& one) {
  return face.model == one.model && face.inwards && face.is_cylinder(one.radius) &&
         std::ranges::any_of(one.centres, [&](const Vec3& at) { return face.is_about(at, one.axis, one.radius); });
}

bool is_of(const PlacedFace& face, const features::HexagonFeature& one) {
  return face.model == one.model && !face.vertices.empty() && one.has_flat(face.vertices);
}

bool is_of(const PlacedFace& face, const features::ArcFeature& one) {
  return face.model == one.model && face.inwards == one.inwards && face.is_cylinder(one.radius) &&
         face.is_about(one.centre, one.axis, one.radius);
}

// The kinds that have faces of their own, and words.
template <class Visit>
void for_each_kind(const features::PartFeatures& features, const Visit& visit) {
  visit(SizeKind::hole, features.holes);
  visit(SizeKind::cylinder, features.cylinders);
  visit(SizeKind::slot, features.slots);
  visit(SizeKind::hexagon, features.hexagons);
  visit(SizeKind::arc, features.arcs);
}

bool is_in(const PlacedFace& face, const FeatureGroup& group, const features::PartFeatures& features) {
  bool is_there = false;
  for_each_kind(features, [&](SizeKind kind, const auto& all) {
    is_there = is_there || (kind == group.kind && std::ranges::any_of(group.features, [&](std::size_t number) {
                              return is_of(face, all[number]);
                            }));
  });
  return is_there;
}

// Of planes alone, since they may be flats of hexagons.
std::vector<std::vector<int>> vertices_of_planes(const mesh::Mesh& mesh, const surfaces::PartFaces& part) {
  std::vector<std::vector<int>> vertices(part.faces.size());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int face = part.face_of_triangle[static_cast<std::size_t>(t)];
    if (face < 0 || part.faces[static_cast<std::size_t>(face)].surface.kind != surfaces::SurfaceKind::plane) continue;
    for (const int vertex : mesh.triangle(t)) vertices[static_cast<std::size_t>(face)].push_back(vertex);
  }
  for (std::vector<int>& of_face : vertices) {
    std::ranges::sort(of_face);
    of_face.erase(std::unique(of_face.begin(), of_face.end()), of_face.end());
  }
  return vertices;
}

}  // namespace

std::string counted(std::size_t count, const std::string& what) {
  return count == 1 ? what : std::to_string(count) + " × " + what;
}

std::vector<FeatureGroup> feature_groups(const features::PartFeatures& features, const sheet::FeatureTable& table,
                                         const sheet::Notation& notation, std::string_view language) {
  const FeatureWords words(notation, language);
  std::vector<FeatureGroup> groups;
  for_each_kind(features, [&](SizeKind kind, const auto& all) {
    for (const auto& equal : sheet::equal_features(table, kind, all)) {
      FeatureGroup& group = groups.emplace_back(FeatureGroup{kind, {}, words(*equal.front()), kind == SizeKind::hole});
      for (const auto* one : equal) group.features.push_back(static_cast<std::size_t>(one - all.data()));
    }
  });
  return groups;
}

std::vector<int> groups_of_faces(const world::World& world, int model, const features::PartFeatures& features,
                                 const std::vector<FeatureGroup>& groups) {
  const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
  if (placed.part == nullptr) return {};
  std::vector<int> found(placed.part->faces.size(), -1);
  const std::optional<double> scale = surfaces::similarity_scale(placed.to_world);
  if (!scale) return found;
  const std::vector<Vec3> middles = surfaces::middles_of_faces(placed.mesh->whole(), *placed.part);
  std::vector<std::vector<int>> vertices(found.size());
  if (!features.hexagons.empty()) vertices = vertices_of_planes(placed.mesh->whole(), *placed.part);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const surfaces::PartFace& one = placed.part->faces[i];
    const PlacedFace face{model,
                          surfaces::moved(one.surface, placed.to_world, *scale),
                          one.inwards,
                          Vec3(placed.to_world * Vec4(middles[i], 1)),
                          *scale * placed.part->tolerance,
                          std::move(vertices[i])};
    const auto group =
        std::ranges::find_if(groups, [&](const FeatureGroup& known) { return is_in(face, known, features); });
    if (group != groups.end()) found[i] = static_cast<int>(group - groups.begin());
  }
  return found;
}

}  // namespace epura::pipeline
