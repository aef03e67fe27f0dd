// SPDX-License-Identifier: Apache-2.0
#include "features/assembly_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "features/tolerances.hpp"
#include "world/explosion_order.hpp"
#include "world/mass.hpp"

namespace epura::features {

namespace {

// Whether a shaft, such as that of a bolt, is in a hole.
bool is_filled_by(const HoleFeature& hole, const CylinderFeature& shaft) {
  const double radius = hole.diameter / 2;
  if (shaft.inwards || !world::may_be_in(shaft.radius, radius) || !are_parallel(hole.axis, shaft.axis)) return false;
  if (distance_from_line(shaft.from, hole.mouth, hole.axis) > off_axis * radius) return false;
  const auto [low, high] =
      std::minmax({glm::dot(shaft.from - hole.mouth, hole.axis), glm::dot(shaft.to - hole.mouth, hole.axis)});
  return high > -hole.depth.value_or(looks_into * hole.diameter) && low < 0;
}

struct Bodies {
  std::map<std::array<int, 2>, Box> boxes{};  // by model and number
  Box whole{};

  [[nodiscard]] bool is_placed(const Box& box) const {
    return glm::length(box.size()) >= min_part * glm::length(whole.size());
  }
};

Bodies bodies_of(const world::World& world) {
  Bodies bodies;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const std::vector<int>& body = world.models[m].mesh->body;
    for (std::size_t t = 0; t < body.size(); ++t)
      for (const int v : world.triangles[static_cast<std::size_t>(world.first_triangle[m]) + t])
        bodies.boxes[{static_cast<int>(m), body[t]}].add(world.points[static_cast<std::size_t>(v)]);
  }
  for (const auto& [number, box] : bodies.boxes)
    bodies.whole = {glm::min(bodies.whole.min, box.min), glm::max(bodies.whole.max, box.max)};
  return bodies;
}

/// A line in the middle of a part, along an axis of the world.
struct MiddleAxis {
  int along;
  Vec3 point;
};

// Of a part that is round or has a bore in its middle, as bolts, nuts and rods.
std::optional<MiddleAxis> middle_axis(const Box& part, const PartFeatures& all) {
  const auto is_middle = [&](const Vec3& point, const Vec3& axis, double radius) {
    const int along = axis_along(axis);
    const double slack = off_axis * radius;
    bool is_it = along >= 0;
    for (int across = 0; across < 3 && is_it; ++across) {
      const double from = part.min[across], width = part.size()[across];
      is_it = across == along ? point[across] >= from - slack && point[across] <= from + width + slack
                              : std::abs(point[across] - from - width / 2) <= slack && 6 * radius >= width &&
                                    2 * radius <= width + 2 * slack;
    }
    return is_it;
  };
  for (const CylinderFeature& one : all.cylinders)
    if (is_middle((one.from + one.to) / 2.0, one.axis, one.radius)) return MiddleAxis{axis_along(one.axis), one.from};
  for (const HoleFeature& hole : all.holes)
    if (is_middle(hole.mouth, hole.axis, hole.diameter / 2)) return MiddleAxis{axis_along(hole.axis), hole.mouth};
  return std::nullopt;
}

// A level where a part within the assembly begins, or across its middle axis, where that is: its size is for its own
// drawing.
void add_levels(std::vector<LevelFeature>& levels, const Box& part, const Box& whole,
                const std::optional<MiddleAxis>& middle) {
  const double slack = 1e-6 * glm::length(whole.size());
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_across = middle && middle->along != axis;
    const double at = is_across ? middle->point[axis] : part.min[axis];
    const auto is_there = [&](const LevelFeature& level) {
      return level.axis == axis && std::abs(level.at - at) <= slack;
    };
    if (at <= whole.min[axis] + slack) continue;
    auto level = std::find_if(levels.begin(), levels.end(), is_there);
    if (level == levels.end()) level = levels.insert(levels.end(), {axis, at, 0, {}});
    const Vec3 size = part.size();
    level->area += size[(axis + 1) % 3] * size[(axis + 2) % 3];
    for (const double end :
         is_across ? std::vector{part.min[middle->along], part.max[middle->along]} : std::vector<double>()) {
      Vec3 point = middle->point;
      point[middle->along] = end;
      level->points.push_back(point);
    }
    for (int corner = 0; corner < 4 && !is_across; ++corner) {
      Vec3 point = part.min;
      if ((corner & 1) != 0) point[(axis + 1) % 3] = part.max[(axis + 1) % 3];
      if ((corner & 2) != 0) point[(axis + 2) % 3] = part.max[(axis + 2) % 3];
      level->points.push_back(point);
    }
  }
}

// Places along an axis that are more than a view has room for belong to drawings of groups of parts.
void leave_out_crowds(PartFeatures& features) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto is_along = [&](const LevelFeature& level) { return level.axis == axis; };
    const auto count =
        static_cast<std::size_t>(std::count_if(features.levels.begin(), features.levels.end(), is_along));
    if (count <= max_places) continue;
    features.unplaced[static_cast<std::size_t>(axis)] = count;
    std::erase_if(features.levels, is_along);
  }
}

// With names, or closed: a cracked surface is in pieces, too.
bool has_several_bodies(const world::Placed& placed) {
  const mesh::Mesh& mesh = placed.mesh->whole();
  if (mesh.report.body_names.size() > 1) return true;
  if (std::all_of(mesh.body.begin(), mesh.body.end(), [](int body) { return body == 0; })) return false;
  const std::vector<world::Solid> solids = world::solids_of(mesh, placed.to_world);
  return std::count_if(solids.begin(), solids.end(), [](const world::Solid& one) { return one.fault.empty(); }) > 1;
}

}  // namespace

bool is_assembly(const world::World& world) {
  std::size_t models = 0;
  for (const world::Placed& placed : world.models) {
    if (placed.mesh->triangle_count() == 0) continue;
    if (has_several_bodies(placed)) return true;
    ++models;
  }
  return models > 1;
}

PartFeatures assembly_features(const world::World& world, const PartFeatures& all) {
  PartFeatures features;
  features.of_assembly = true;
  for (const HoleFeature& hole : all.holes)
    if (std::none_of(all.cylinders.begin(), all.cylinders.end(),
                     [&](const CylinderFeature& shaft) { return is_filled_by(hole, shaft); }))
      features.holes.push_back(hole);
  features.pitch_circles = all.pitch_circles;
  features.inclined = all.inclined;
  const Bodies bodies = bodies_of(world);
  for (const auto& [number, box] : bodies.boxes)
    if (bodies.is_placed(box)) add_levels(features.levels, box, bodies.whole, middle_axis(box, all));
  std::stable_sort(features.levels.begin(), features.levels.end(), [](const LevelFeature& a, const LevelFeature& b) {
    return std::pair(a.axis, a.at) < std::pair(b.axis, b.at);
  });
  leave_out_crowds(features);
  return features;
}

bool has_too_many_parts(const PartFeatures& features) {
  return std::ranges::all_of(features.unplaced, [](std::size_t count) { return count > 0; });
}

std::vector<std::string> unplaced_parts(const std::array<std::size_t, 3>& unplaced) {
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (unplaced[axis] > 0)
      names.push_back(std::to_string(unplaced[axis]) + " places of parts along " + std::string(1, "xyz"[axis]));
  return names;
}

std::size_t parts_without_place(const world::World& world) {
  const Bodies bodies = bodies_of(world);
  return static_cast<std::size_t>(std::count_if(bodies.boxes.begin(), bodies.boxes.end(),
                                                [&](const auto& one) { return !bodies.is_placed(one.second); }));
}

PartFeatures features_to_dimension(const world::World& world, const Progress& progress) {
  PartFeatures features = find_part_features(world, progress);
  return features.of_assembly ? assembly_features(world, features) : features;
}

}  // namespace epura::features
