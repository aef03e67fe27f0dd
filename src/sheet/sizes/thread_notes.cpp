// SPDX-License-Identifier: Apache-2.0
#include "sizes/thread_notes.hpp"

#include <cstddef>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/hole_table.hpp"

namespace epura::sheet {

namespace {

using features::parallel;

/// The holes or cylinders with one thread: the first one, their number and what follows the name of the thread.
struct ThreadGroup {
  scene::FeatureCircle circle{};
  bool internal = false;
  std::string name{}, rest{};
  int count = 0;
};

// Where its thread begins, from where extension lines to the outside are short.
Vec3 begin_of(const features::CylinderFeature& cylinder) {
  const Vec3& end = cylinder.thread->end;
  return glm::distance(cylinder.from, end) > glm::distance(cylinder.to, end) ? cylinder.from : cylinder.to;
}

ThreadGroup group_of(int number, const features::PartFeatures& features, const Notation& notation) {
  ThreadGroup group;
  const auto add = [&](const Vec3& centre, const Vec3& axis, const features::ThreadFeature& thread, bool internal) {
    if (group.count++ > 0) return false;
    group.circle = {centre, axis, thread.diameter / 2, {}};
    group.internal = internal;
    group.name = thread.text;
    return true;
  };
  for (const features::HoleFeature& hole : features.holes)
    if (hole.thread && hole.thread->number == number && add(hole.mouth, hole.axis, *hole.thread, true))
      group.rest = recesses_of(hole, notation);
  for (const features::CylinderFeature& cylinder : features.cylinders)
    if (cylinder.thread && cylinder.thread->number == number &&
        add(begin_of(cylinder), cylinder.axis, *cylinder.thread, cylinder.inwards) && cylinder.thread->length)
      group.rest = " ↧" + length_text(*cylinder.thread->length, notation);
  check(group.count == 0 || !group.name.empty(), "a thread has a designation");
  return group;
}

// Whether a view shows the circle, or, if it need not, the diameter of a cylinder with this axis.
bool shows(const NamedProjection& view, const Vec3& axis, bool along) {
  if (!is_orthographic(view.projection) || view.aligned()) return false;
  const double tilt = glm::length(glm::cross(view.projection.n, axis));
  return along ? tilt <= parallel : std::abs(glm::dot(view.projection.n, axis)) <= parallel;
}

const NamedProjection* view_for(const scene::ThreadDescription& description, const ThreadGroup& group,
                                std::span<const NamedProjection> views) {
  for (const bool along : {group.internal, !group.internal})
    for (const NamedProjection& view : views)
      if (description.view.value_or(view.name) == view.name && shows(view, group.circle.axis, along)) return &view;
  return nullptr;
}

}  // namespace

std::string name_in_note(const std::optional<features::ThreadFeature>& thread) { return thread ? thread->text : "<>"; }

std::string size_in_words(const std::optional<features::ThreadFeature>& thread, double diameter,
                          const Notation& notation) {
  return thread ? thread->text : "⌀" + length_text(diameter, notation);
}

std::vector<scene::DimensionDescription> thread_dimensions(std::span<const scene::ThreadDescription> threads,
                                                           std::span<const NamedProjection> views,
                                                           const features::PartFeatures& features,
                                                           const Notation& notation) {
  std::vector<scene::DimensionDescription> dimensions;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    const scene::ThreadDescription& description = threads[i];
    if (!description.callout.value_or(true)) continue;
    const ThreadGroup group = group_of(static_cast<int>(i), features, notation);
    if (group.count == 0) continue;
    const NamedProjection* view = view_for(description, group, views);
    if (view == nullptr) {
      if (description.view.given())
        throw Error(
            ErrorKind::input, description.view.where,
            "view '" + *description.view + "' shows the thread " + group.name + " neither along nor across its axis",
            "choose another view");
      continue;
    }
    scene::DimensionDescription& dimension = dimensions.emplace_back();
    dimension.where = description.where;
    dimension.view = {view->name, description.where};
    dimension.type = {DimensionType::diameter, description.where};
    dimension.circle = group.circle;
    dimension.text = {(group.count > 1 ? std::to_string(group.count) + "× " : "") + group.name + group.rest,
                      description.where};
  }
  check(dimensions.size() <= threads.size(), "a thread has one note at most");
  return dimensions;
}

}  // namespace epura::sheet
