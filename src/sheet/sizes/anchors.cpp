// SPDX-License-Identifier: Apache-2.0
#include "sizes/anchors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sizes/rims.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

constexpr double same_vertex = 1e-9;  // relative to the size of the world
constexpr double farthest = 10'000;   // mm on paper

struct TypeRule {
  std::size_t anchors;
  const char* wants;
};

// In order of DimensionType.
constexpr std::array<TypeRule, 8> type_rules{{{2, "its two ends"},
                                              {2, "its two ends"},
                                              {3, "the corner and an end of each leg"},
                                              {1, "a vertex on the circle"},
                                              {1, "a vertex on the circle"},
                                              {1, "a vertex on the arc"},
                                              {0, "no anchors"},
                                              {0, "no anchors"}}};

bool is_seen_on_paper(DimensionDirection direction) { return direction <= DimensionDirection::vertical; }

std::optional<DimensionDirection> direction_of(const scene::DimensionDescription& dimension) {
  const bool linear = *dimension.type == DimensionType::linear;
  const scene::Located<DimensionDirection>& direction = dimension.direction;
  if (!linear && *dimension.type != DimensionType::overall) {
    if (direction.given()) refuse_input(direction.where, "only linear and overall dimensions have a direction");
    return std::nullopt;
  }
  const std::string known = linear ? "horizontal, vertical" : "width, height, depth";
  if (!direction.given()) refuse_input(dimension.where, "the dimension has no direction", "give one of " + known);
  if (is_seen_on_paper(*direction) != linear)
    refuse_input(direction.where,
                 "'" + std::string(scene::word_of(*direction)) + "' is not a direction of " +
                     (linear ? "a linear" : "an overall") + " dimension",
                 "known: " + known);
  return *direction;
}

Vec3 place_of_vertex(const world::World& world, const std::array<int, 2>& vertex, const std::string& where) {
  const auto [model, number] = vertex;
  const int models = static_cast<int>(world.models.size());
  if (model < 0 || model >= models)
    refuse_input(where, "there is no model " + std::to_string(model),
                 "models are numbered from 0 to " + std::to_string(models - 1));
  const int count = world.first_vertex[std::size_t(model) + 1] - world.first_vertex[std::size_t(model)];
  if (number < 0 || number >= count)
    refuse_input(where, "model " + std::to_string(model) + " has no vertex " + std::to_string(number),
                 "its vertices are numbered from 0 to " + std::to_string(count - 1));
  check(world.first_vertex[std::size_t(model) + 1] <= static_cast<int>(world.points.size()),
        "vertices of a model are points of the world");
  const auto& edges = world.models[std::size_t(model)].mesh->edges;
  const auto has_vertex = [number = number](const mesh::MeshEdge& edge) {
    return edge.vertex[0] == number || edge.vertex[1] == number;
  };
  if (std::none_of(edges.begin(), edges.end(), has_vertex))
    refuse_input(
        where,
        "vertex " + std::to_string(number) + " of model " + std::to_string(model) + " belongs to no face and no line",
        "choose a vertex that is drawn, or give a point");
  return world.points[std::size_t(world.first_vertex[std::size_t(model)] + number)];
}

void expect_apart(const world::World& world, const Vec3& a, const Vec3& b, const std::string& where) {
  if (glm::length(a - b) <= same_vertex * glm::length(world.box.size()))
    refuse_input(where, "two of its anchors are at the same place", "choose other vertices");
}

void expect_offset(const AnchoredDimension& dimension) {
  if (!dimension.offset) return;
  if (!(std::abs(*dimension.offset) <= farthest))
    refuse_input(dimension.where, "the offset is not a length on a sheet",
                 "give at most " + format_number(farthest) + " mm");
  if (dimension.type == DimensionType::angular && *dimension.offset <= 0)
    refuse_input(dimension.where, "the offset of an angular dimension is the radius of its arc, which is positive");
}

/// Data of the models that dimensions need, computed on first use.
struct Asked {
  Rims rims;
  std::optional<std::array<features::Extent, 3>> extents{};
  std::optional<double> unevenness{};
};

// How far the ends of lines may be from those of the world, at both ends together: a view shows either end of a plane
// face whose vertices lie on both sides of its plane.
double unevenness_of(const world::World& world) {
  double largest = 0;
  for (const world::Placed& placed : world.models)
    if (const auto part = world::place_part(placed))
      for (const surfaces::PartFace& face : part->faces)
        if (face.surface.kind == surfaces::SurfaceKind::plane) largest = std::max(largest, face.residual);
  return 4 * largest;
}

void set_extent(AnchoredDimension& dimension, const world::World& world, Asked& asked) {
  const int axis = axis_of(*dimension.direction);
  if (!asked.extents) asked.extents = features::true_extents(world);
  if (!asked.unevenness) asked.unevenness = unevenness_of(world);
  const features::Extent& extent = (*asked.extents)[axis];
  const Box box = features::box_of_faces(world);
  dimension.points = {box.min, box.max};
  dimension.points[0][axis] = extent.from;
  dimension.points[1][axis] = extent.to;
  dimension.form = extent.form;
  dimension.beyond_vertices = extent.size() - box.size()[axis];
  dimension.unevenness = *asked.unevenness;
}

std::optional<Tolerance> tolerance_of(const scene::DimensionDescription& description) {
  if (!description.tolerance.given()) {
    if (description.limits.value_or(false))
      refuse_input(description.limits.where, "a dimension without a tolerance has no limits", "give it a 'tolerance'");
    return {};
  }
  Tolerance tolerance = parse_tolerance(*description.tolerance, description.tolerance.where);
  tolerance.limits = description.limits.value_or(false);
  return tolerance;
}

AnchoredDimension anchored(const world::World& world, Asked& asked, const scene::DimensionDescription& description) {
  const std::string& where = description.where;
  if (!description.type.given()) refuse_input(where, "the dimension has no type");
  const DimensionType type = *description.type;
  const TypeRule& rule = type_rules[std::size_t(type)];
  AnchoredDimension dimension{where,
                              type,
                              direction_of(description),
                              {},
                              description.opposite,
                              {},
                              description.offset.value,
                              description.text.value_or(""),
                              tolerance_of(description)};
  dimension.name = description.name.value_or("");
  dimension.stated = description.stated;
  dimension.is_exact = description.is_exact;
  if (description.circle) {
    const scene::FeatureCircle& circle = *description.circle;
    dimension.is_label = description.is_label;
    dimension.circles = {{circle.centre, circle.axis, circle.radius, circle.arc, circle.arc.empty()}};
    return dimension;
  }
  if (type == DimensionType::linear) dimension.arrangement = description.arrangement.value;
  if (dimension.arrangement ? description.anchors.size() < rule.anchors : description.anchors.size() != rule.anchors)
    refuse_input(where, "the number of its anchors is " + std::to_string(description.anchors.size()),
                 "the dimension '" + std::string(scene::word_of(type)) + "' needs " + rule.wants);
  expect_offset(dimension);
  for (const scene::Anchor& anchor : description.anchors) dimension.points.push_back(position_of(world, anchor, where));
  for (std::size_t i = 1; i < dimension.points.size() && !dimension.arrangement; ++i)
    expect_apart(world, dimension.points[0], dimension.points[i], where);
  if (type == DimensionType::radius || type == DimensionType::diameter || type == DimensionType::arc)
    dimension.circles = asked.rims.through(description.anchors[0], dimension.points[0], where);
  if (type == DimensionType::overall) set_extent(dimension, world, asked);
  check(!dimension.arrangement || dimension.points.size() >= 2, "a row has two places");
  return dimension;
}

}  // namespace

Vec3 position_of(const world::World& world, const scene::Anchor& anchor, const std::string& where) {
  const auto* vertex = std::get_if<std::array<int, 2>>(&anchor);
  check(!std::holds_alternative<scene::FeatureName>(anchor), "features are found once the models are read");
  const Vec3 place = vertex ? place_of_vertex(world, *vertex, where) : std::get<Vec3>(anchor);
  if (!finite(place)) refuse_input(where, "the coordinates of an anchor are not finite");
  return place;
}

std::vector<AnchoredDimension> find_anchors(const world::World& world,
                                            std::span<const scene::DimensionDescription> dimensions,
                                            const Progress& progress) {
  Asked asked{Rims(world)};
  std::vector<AnchoredDimension> anchored_ones;
  for (const scene::DimensionDescription& dimension : dimensions) {
    if (progress.is_out_of_time()) break;
    anchored_ones.push_back(anchored(world, asked, dimension));
  }
  return anchored_ones;
}

}  // namespace epura::sheet
