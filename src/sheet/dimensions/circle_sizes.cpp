// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/circle_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/hole_angles.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;

// Those that one note can describe, as automatic dimensions do.
std::string kind_of(const design::DesignCylinder& cylinder) {
  return std::string(cylinder.whole ? "" : "interrupted ") + (cylinder.inwards ? "bore" : "cylinder");
}

bool have_equal_lengths(const CircleSize& a, const CircleSize& b) {
  return std::equal(a.lengths.begin(), a.lengths.end(), b.lengths.begin(), b.lengths.end(),
                    [](double x, double y) { return std::abs(x - y) <= 1e-4 * std::max(std::abs(x), std::abs(y)); });
}

class SizeLister {
 public:
  SizeLister(const design::DesignFeatures& features, const Notation& notation)
      : features_(features), notation_(notation) {}

  std::vector<CircleSize> list() {
    add_holes();
    for (const design::DesignCylinder& one : features_.cylinders) {
      const std::string name = name_of(one, notation_);
      add({name, one.thread ? name : kind_of(one), {one.called()}, one.model, one.from, one.axis, one.called()});
    }
    for (const design::DesignPitchCircle& one : features_.pitch_circles)
      add({"pitch circle ⌀" + length(2 * one.radius),
           "pitch circle",
           {one.radius},
           one.model,
           one.centre,
           one.axis,
           one.radius});
    for (const design::DesignCone& cone : features_.cones)
      for (const int end : {0, 1}) add_end_of_cone(cone, end);
    for (const design::DesignSlot& one : features_.slots)
      add({"slot R" + length(one.radius), "slot", {one.radius}, one.model, one.centres[1], one.axis, one.radius, true});
    for (const design::DesignArc& one : features_.arcs)
      add({"radius R" + length(one.radius), "radius", {one.radius}, one.model, one.centre, one.axis, one.radius, true});
    check(sizes_.size() >= features_.holes.size(), "each hole has a size");
    return std::move(sizes_);
  }

 private:
  [[nodiscard]] std::string length(double value) const { return length_text(value, notation_); }

  void add(CircleSize size) {
    size.equal = static_cast<int>(sizes_.size());
    for (const CircleSize& other : sizes_)
      if (other.kind == size.kind && other.model == size.model && have_equal_lengths(other, size) &&
          (size.is_fillet() || are_parallel(other.axis, size.axis)) &&
          (!size.needs_depth || glm::dot(other.axis, size.axis) > 0)) {
        size.equal = other.equal;
        break;
      }
    sizes_.push_back(std::move(size));
  }

  void add_holes() {
    for (const design::DesignHole& hole : features_.holes) {
      check(hole.called() > 0 && (!hole.depth || *hole.depth > 0), "a hole has a diameter, and a depth if it is known");
      std::string name = "hole " + (hole.thread ? hole.thread->text : "⌀" + length(hole.diameter));
      std::string kind = hole.thread ? name : "hole";
      std::vector<double> lengths{hole.called()};
      const auto add_recess = [&](const char* sign, double value) {
        name += sign + length(value);
        kind += sign;
        lengths.push_back(value);
      };
      if (hole.depth) add_recess(" ↧", *hole.depth);
      if (hole.counterbore) add_recess(" ⌴⌀", hole.counterbore->diameter);
      if (hole.countersink) add_recess(" ⌵⌀", hole.countersink->diameter);
      add({name, kind, lengths, hole.model, hole.mouth, hole.axis, hole.called() / 2, false,
           hole.depth || hole.counterbore || hole.countersink});
    }
    // One note describes holes about an axis.
    const auto size_of = [&](const design::DesignHole* hole) -> CircleSize& {
      return sizes_[static_cast<std::size_t>(hole - features_.holes.data())];
    };
    for (const RadialPattern& pattern : find_radial_patterns(features_))
      for (const design::DesignHole* hole : pattern.holes) size_of(hole).equal = size_of(pattern.holes.front()).equal;
  }

  // A cylinder that continues a cone has the size of its end.
  void add_end_of_cone(const design::DesignCone& cone, int end) {
    const design::DesignCylinder circle{cone.model, cone.ends[end], cone.ends[end], cone.axis, cone.radii[end], false};
    if (circle.radius > 0 && !design::has_coaxial_outline(features_, circle))
      add({"end of a cone ⌀" + length(2 * circle.radius),
           "end of a cone",
           {circle.radius},
           cone.model,
           circle.from,
           cone.axis,
           circle.radius});
  }

  const design::DesignFeatures& features_;
  const Notation& notation_;
  std::vector<CircleSize> sizes_;
};

}  // namespace

bool agree(double a, double b) { return std::abs(a - b) <= size_agrees * std::max(std::abs(a), std::abs(b)); }

bool CircleSize::is_equal(const WorldCircle& circle) const {
  return are_parallel(axis, circle.axis) && agree(radius, circle.radius);
}

bool CircleSize::is_at(const WorldCircle& circle) const {
  return is_equal(circle) && glm::length(glm::cross(centre - circle.centre, axis)) <= size_agrees * 10 * circle.radius;
}

std::string name_of(const design::DesignCylinder& cylinder, const Notation& notation) {
  const std::string size = cylinder.thread ? cylinder.thread->text : "⌀" + length_text(2 * cylinder.radius, notation);
  return (cylinder.inwards ? "bore " : "cylinder ") + size;
}

std::vector<CircleSize> circle_sizes(const design::DesignFeatures& features, const Notation& notation) {
  return SizeLister(features, notation).list();
}

}  // namespace epura::sheet
