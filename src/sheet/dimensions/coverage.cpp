// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/circle_sizes.hpp"
#include "sheet/dimensions/cone_angles.hpp"
#include "sheet/dimensions/equal_features.hpp"
#include "sheet/dimensions/face_coverage.hpp"
#include "sheet/dimensions/hexagon_widths.hpp"
#include "sheet/dimensions/missing_views.hpp"
#include "sheet/dimensions/place_chain.hpp"
#include "sheet/dimensions/round_ends.hpp"
#include "sheet/dimensions/slope_dimensions.hpp"
#include "sheet/dimensions/stations.hpp"
#include "sheet/dimensions/turned_coverage.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;
using design::parallel;

constexpr double place_agrees = 2e-5;  // relative to the size of the models

bool is_auxiliary(const std::string& text) { return !text.empty() && text.front() == '('; }

class CoverageFinder {
 public:
  CoverageFinder(const DimensionSubject& subject, const Notation& notation)
      : subject_(subject), notation_(notation), sizes_(circle_sizes(subject.features, notation)) {
    const double slack = place_agrees * glm::length(subject.world.box.size());
    for (int axis = 0; axis < 3; ++axis) chains_.emplace_back(subject.extents[axis], slack);
    widths_.resize(subject.features.hexagons.size(), 0);
    add_places();
    for (PlaceChain& chain : chains_) chain.begin();
  }

  Coverage find(std::span<const DimensionsInView> views) {
    for (const DimensionsInView& view : views)
      for (const AnchoredDimension& dimension : view.dimensions)
        if (dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius) count(dimension);
    for (const DimensionsInView& view : views)
      for (const AnchoredDimension& dimension : view.dimensions)
        if (!is_auxiliary(dimension.text)) join(dimension, view);
    join_round_ends();
    for (int axis = 0; axis < 3; ++axis) chains_[axis].list_open(axis, notation_, coverage_.undimensioned);
    std::vector<int> places(sizes_.size(), 0);  // of each list of equal ones
    for (const CircleSize& size : sizes_) {
      int& of_list = places[static_cast<std::size_t>(size.equal)];
      if (of_list == 0) of_list = places_of(size);
      check(size.dimensions >= 0 && of_list > 0, "a size is of one place or more");
      if (!is_given(size)) add_undimensioned(size.name, remedy_for(outward_axis(size), is_only_along(size), views));
      if (size.dimensions > of_list) coverage_.repeated.push_back(size.name);
    }
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      const std::string name = "hexagon " + length(subject_.features.hexagons[i].across_flats) + " across flats";
      if (widths_[i] == 0) coverage_.undimensioned.push_back(name);
      if (widths_[i] > 1) coverage_.repeated.push_back(name);
    }
    add_uncheckable(views);
    TurnedCoverage turned = cover_turned(views, subject_, notation_);
    coverage_.undimensioned.insert(coverage_.undimensioned.end(), turned.missing.begin(), turned.missing.end());
    count_faces(slopes_given(views), turned.holes);
    merge(coverage_.undimensioned);
    merge(coverage_.repeated);
    return std::move(coverage_);
  }

 private:
  void add_undimensioned(const std::string& name, const Remedy& remedy) {
    coverage_.undimensioned.push_back(name + remedy.sentence);
    std::vector<std::string>& views = coverage_.views_to_add;
    if (!remedy.view.empty() && std::find(views.begin(), views.end(), remedy.view) == views.end())
      views.push_back(remedy.view);
  }

  // Towards the side of the models on which it is: from there, nothing larger hides it.
  [[nodiscard]] Vec3 outward_axis(const CircleSize& size) const {
    return glm::dot(size.centre - subject_.world.box.centre(), size.axis) < 0 ? -size.axis : size.axis;
  }

  // Diameters can be given in views beside their axis, too.
  static bool is_only_along(const CircleSize& size) { return size.anywhere || size.kind == "pitch circle"; }

  [[nodiscard]] std::string length(double value) const { return length_text(value, notation_); }

  void add_place(const Vec3& centre, const Vec3& axis, const std::string& name) {
    for (int other = 0; other < 3; ++other)
      if (std::abs(axis[other]) <= parallel) chains_[other].add(centre[other], name);
  }

  void add_places() {
    const design::DesignFeatures& features = subject_.features;
    for (const design::DesignHole& hole : features.holes)
      add_place(hole.mouth, hole.axis, "hole ⌀" + length(hole.diameter));
    for (const design::DesignCylinder& cylinder : features.cylinders)
      add_place(cylinder.from, cylinder.axis, name_of(cylinder, notation_));
    for (const design::DesignSlot& slot : features.slots)
      for (const Vec3& centre : slot.centres) add_place(centre, slot.axis, "slot R" + length(slot.radius));
    for (const design::DesignPitchCircle& circle : features.pitch_circles)
      add_place(circle.centre, circle.axis, "pitch circle ⌀" + length(2 * circle.radius));
    for (const RoundEnd& end : find_round_ends(features))
      add_place(end.centre, end.axis, "round end R" + length(end.radius));
    for (const design::DesignHexagon& hexagon : features.hexagons)
      add_place(hexagon.centre, hexagon.axis, "hexagon " + length(hexagon.across_flats));
    for (const design::DesignLevel& level : features.levels) {
      check(level.axis >= 0 && level.axis < 3, "a step is perpendicular to an axis of the world");
      chains_[level.axis].add(level.at, "step");
      if (level.other_side) chains_[level.axis].add(*level.other_side, "");
    }
    for (const design::DesignCone& cone : features.cones)
      if (const int axis = world_axis(cone.axis); axis >= 0)
        for (const Vec3& end : cone.ends) chains_[axis].add(end[axis], "end of a cone");
    for (const design::DesignBevel& bevel : features.bevels)
      for (int axis = 0; axis < 3; ++axis)
        for (const Vec3& end : bevel.ends)
          if (axis != bevel.along && !has_angle(bevel, subject_))
            chains_[axis].add(end[axis], bevel.is_chamfer ? "chamfer" : "slope");
    for (const design::DesignCylinder& cylinder : features.cylinders)
      if (const int axis = world_axis(cylinder.axis); axis >= 0 && cylinder.thread && cylinder.thread->length)
        chains_[axis].add(cylinder.thread->end[axis], "end of thread " + cylinder.thread->text);
  }

  // A dimension counts for the features on its circle, and for those equal to them if it is one of a fillet or has
  // "4×".
  void count(const AnchoredDimension& dimension) {
    if (dimension.type == DimensionType::radius) radii_.push_back(dimension.circles.front().radius);
    const bool many = repeats_of(dimension.text) > 1;
    const WorldCircle& circle = dimension.circles.front();
    std::vector<int> lists;
    for (const CircleSize& size : sizes_)
      if (size.is_at(circle) && !(size.needs_depth && dimension.text.empty())) lists.push_back(size.equal);
    if (lists.empty() && dimension.type == DimensionType::radius)
      for (const CircleSize& size : sizes_)
        if (size.anywhere && size.is_equal(circle)) lists.push_back(size.equal);
    for (CircleSize& size : sizes_) {
      const bool listed = std::find(lists.begin(), lists.end(), size.equal) != lists.end();
      if (listed && (size.anywhere || many || size.is_at(circle))) ++size.dimensions;
    }
  }

  // The number of different features at the places of a size and of all equal to it: a bolt fills its hole, and each
  // may have its dimension, which counts for both.
  [[nodiscard]] int places_of(const CircleSize& size) const {
    std::vector<int> lists{size.equal};
    for (const CircleSize& one : sizes_) {
      if (one.equal != size.equal) continue;
      for (const CircleSize& other : sizes_)
        if (other.is_at({one.centre, one.axis, one.radius, {}, true}) &&
            std::find(lists.begin(), lists.end(), other.equal) == lists.end())
          lists.push_back(other.equal);
    }
    return static_cast<int>(lists.size());
  }

  // Whether a size is the radius of a fillet that the dimension of another one gives. Radii of short arcs are not
  // accurate: the number that is written counts.
  [[nodiscard]] bool is_given_by_equal(const CircleSize& size) const {
    return size.is_fillet() && std::any_of(radii_.begin(), radii_.end(),
                                           [&](double radius) { return length(radius) == length(size.radius); });
  }

  [[nodiscard]] bool is_given(const CircleSize& size) const {
    return size.dimensions > 0 || given_elsewhere(size) || is_in_table(size) || is_given_by_equal(size);
  }

  // Whether an overall dimension is this diameter.
  [[nodiscard]] bool given_elsewhere(const CircleSize& size) const {
    return std::any_of(subject_.extents.begin(), subject_.extents.end(), [&](const design::Extent& extent) {
      return extent.form == design::ExtentForm::diameter && agree(extent.size(), 2 * size.radius) &&
             are_parallel(extent.axis, size.axis) &&
             glm::length(glm::cross(size.centre - extent.centre, size.axis)) <= size_agrees * 10 * size.radius;
    });
  }

  void join_between(int axis, double a, double b, const AnchoredDimension& dimension) {
    // What is symmetrical to the axis of a round part needs no position.
    const design::Extent& extent = subject_.extents[axis];
    const double middle = (extent.from + extent.to) / 2;
    if (extent.form != design::ExtentForm::length && agree(b - middle, middle - a)) chains_[axis].join(middle, a);
    const int parts = repeats_of(dimension.text);
    const bool is_row = parts > 1 && dimension.text.find('=') != std::string::npos;
    if (is_row)
      chains_[axis].join_row(a, b, parts);
    else if (!chains_[axis].join_by_length(a, b))
      coverage_.repeated.push_back(length(std::abs(b - a)) + " along " + axis_names[axis]);
  }

  // Each place with the first one, or in a chain with the one before.
  void join_row(int axis, const AnchoredDimension& dimension) {
    std::vector<double> places;
    for (const Vec3& point : dimension.points) places.push_back(point[axis]);
    const bool is_chain = *dimension.arrangement == DimensionArrangement::chain;
    if (is_chain) std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i)
      join_between(axis, places[is_chain ? i - 1 : 0], places[i], dimension);
  }

  void join(const AnchoredDimension& dimension, const DimensionsInView& view) {
    if (dimension.type == DimensionType::overall) {
      join_overall(axis_of(*dimension.direction));
    } else if (dimension.type == DimensionType::linear || dimension.type == DimensionType::aligned) {
      Vec3 along = dimension.points[1] - dimension.points[0];
      if (dimension.type == DimensionType::linear)
        along = *dimension.direction == DimensionDirection::horizontal ? view.projection.u : view.projection.v;
      if (view.turned_about && !are_parallel(*view.turned_about, glm::normalize(along))) return;
      const int axis = world_axis(glm::normalize(along));
      if (!dimension.arrangement)
        join_hexagons(dimension.text, [&](const design::DesignHexagon& hexagon) {
          return is_across_flats(hexagon, glm::normalize(along), dimension.points[0], dimension.points[1]);
        });
      if (axis >= 0 && dimension.arrangement)
        join_row(axis, dimension);
      else if (axis >= 0)
        join_between(axis, dimension.points[0][axis], dimension.points[1][axis], dimension);
      if (axis >= 0 && dimension.type == DimensionType::aligned && repeats_of(dimension.text) > 1) join_slots(axis);
      if (axis >= 0 && dimension.text.find("×45°") != std::string::npos)
        join_chamfers(dimension, world_axis(view.projection.n));
    } else if (dimension.type == DimensionType::diameter) {
      if (dimension.is_label) join_label(dimension.circles.front());
      join_circles(dimension);
    } else if (dimension.type == DimensionType::angular) {
      join_cones(dimension);
    }
  }

  // An angle gives the rounded end of a cone.
  void join_cones(const AnchoredDimension& dimension) {
    for (const design::DesignCone& cone : subject_.features.cones) {
      if (!has_angle(cone, glm::length(subject_.world.box.size())) || !is_angle_of(dimension, cone)) continue;
      if (const int axis = world_axis(cone.axis); axis >= 0) chains_[axis].join(cone.ends[0][axis], cone.ends[1][axis]);
      const int end = rounded_end(cone);
      for (CircleSize& size : sizes_)
        if (size.is_at({cone.ends[end], cone.axis, cone.radii[end], {}, true})) ++size.dimensions;
    }
  }

  // A table gives positions from the ends of the models.
  void join_label(const WorldCircle& circle) {
    labels_.push_back(circle);
    for (int axis = 0; axis < 3; ++axis) {
      const design::Extent& extent = subject_.extents[axis];
      const double middle = (extent.from + extent.to) / 2;
      const bool is_round = extent.form != design::ExtentForm::length;
      if (std::abs(circle.axis[axis]) <= parallel)
        chains_[axis].join(is_round ? middle : extent.from, circle.centre[axis]);
    }
  }

  [[nodiscard]] bool is_labelled(const design::DesignHole& hole) const {
    return std::any_of(labels_.begin(), labels_.end(), [&](const WorldCircle& label) {
      return glm::length(label.centre - hole.mouth) <= size_agrees * label.radius;
    });
  }

  // Whether a size is that of a pitch circle whose holes are in a table.
  [[nodiscard]] bool is_in_table(const CircleSize& size) const {
    return std::any_of(subject_.features.holes.begin(), subject_.features.holes.end(), [&](const auto& hole) {
      if (hole.pitch_circle < 0) return false;
      const design::DesignPitchCircle& circle = subject_.features.pitch_circles[std::size_t(hole.pitch_circle)];
      return is_labelled(hole) && size.is_at({circle.centre, circle.axis, circle.radius, {}, true});
    });
  }

  // The note of a chamfer gives its size along both axes; "4×" those of all that are equal to it.
  void join_chamfers(const AnchoredDimension& dimension, int along) {
    const double leg = glm::length(dimension.points[1] - dimension.points[0]) / std::sqrt(2.0);
    const bool many = repeats_of(dimension.text) > 1;
    for (const design::DesignBevel& bevel : subject_.features.bevels) {
      if (!bevel.is_chamfer || bevel.along != along || !agree(bevel.leg(), leg)) continue;
      const double off = glm::length(bevel.ends[0] + bevel.ends[1] - dimension.points[0] - dimension.points[1]);
      for (int other = 0; other < 3; ++other)
        if (other != along && (many || off <= size_agrees * leg))
          chains_[other].join(bevel.ends[0][other], bevel.ends[1][other]);
    }
  }

  // The radius of a round end gives the distance from its centre to the end of the models.
  void join_round_ends() {
    for (const RoundEnd& end : find_round_ends(subject_.features)) {
      const auto is_it = [&end](double radius) { return agree(radius, end.radius); };
      if (std::none_of(radii_.begin(), radii_.end(), is_it)) continue;
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1})
          if (const design::Extent& extent = subject_.extents[axis]; end.ends_models(axis, side, extent))
            chains_[axis].join(end.centre[axis], side == 0 ? extent.from : extent.to);
    }
  }

  // The length of one of several equal slots joins the ends of all of them.
  void join_slots(int axis) {
    for (const design::DesignSlot& slot : subject_.features.slots)
      chains_[axis].join(slot.centres[0][axis], slot.centres[1][axis]);
  }

  // The width across flats gives the places of flats and corners: of the hexagons at which it is, and for "2×" of all
  // equal ones.
  template <class Measures>
  void join_hexagons(const std::string& text, const Measures& measures) {
    const std::vector<design::DesignHexagon>& hexagons = subject_.features.hexagons;
    const bool many = repeats_of(text) > 1;
    const auto gives = [&](const design::DesignHexagon& hexagon) {
      return measures(hexagon) || (many && std::any_of(hexagons.begin(), hexagons.end(), [&](const auto& other) {
                                     return measures(other) && are_equal(other, hexagon);
                                   }));
    };
    for (std::size_t i = 0; i < hexagons.size(); ++i) {
      if (!gives(hexagons[i])) continue;
      ++widths_[i];
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(hexagons[i].axis[axis]) > parallel) continue;
        const double middle = hexagons[i].centre[axis], reach = hexagons[i].reach(Mat3(1)[axis]);
        check(reach > 0, "a hexagon reaches to either side of its axis");
        for (const double side : {-reach, reach}) chains_[axis].join(middle, middle + side);
      }
    }
  }

  // A diameter is the size along both axes across a shaft.
  void join_overall(int axis) {
    const design::Extent& extent = subject_.extents[axis];
    for (int other = 0; other < 3; ++other) {
      const design::Extent& same = subject_.extents[other];
      if (other != axis && !extent.is_same_as(same)) continue;
      join_hexagons("",
                    [&](const design::DesignHexagon& hexagon) { return is_extent(hexagon, other, subject_, true); });
      if (!chains_[other].join_by_length(same.from, same.to) && other == axis)
        coverage_.repeated.push_back(std::string("overall size along ") + axis_names[axis]);
      if (same.form != design::ExtentForm::length) chains_[other].join(same.from, (same.from + same.to) / 2);
    }
    for (int other = 0; other < 3 && extent.form == design::ExtentForm::diameter; ++other)
      if (std::abs(extent.axis[other]) <= parallel) join_beside_flats(other, extent);
  }

  // The axis of a shaft, where flats may have taken one end or, equally, both.
  void join_beside_flats(int axis, const design::Extent& shaft) {
    const double middle = shaft.centre[axis];
    for (const double side : {-0.5, 0.5}) chains_[axis].join(middle, middle + side * shaft.size());
    const design::Extent& own = subject_.extents[axis];
    if (agree(own.to - middle, middle - own.from)) chains_[axis].join(middle, own.from);
  }

  // A diameter gives both sides of its circle; "4×" those of all that are equal to it.
  void join_circles(const AnchoredDimension& dimension) {
    const bool many = repeats_of(dimension.text) > 1;
    for (const WorldCircle& circle : dimension.circles)
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(circle.axis[axis]) > parallel) continue;
        const double middle = circle.centre[axis];
        join_sides(axis, middle, circle.radius);
        for (const CircleSize& size : sizes_)
          if (many && size.is_equal(circle)) join_sides(axis, size.centre[axis], circle.radius);
        for (const design::DesignHole& hole : subject_.features.holes)
          if (lies_on(hole.mouth, circle) && are_parallel(hole.axis, circle.axis))
            chains_[axis].join(middle, hole.mouth[axis]);
      }
  }

  void join_sides(int axis, double middle, double radius) {
    for (const double side : {-radius, radius}) chains_[axis].join(middle, middle + side);
  }

  static bool lies_on(const Vec3& point, const WorldCircle& circle) {
    return agree(glm::length(glm::cross(point - circle.centre, circle.axis)), circle.radius);
  }

  // Whether an overall dimension is the diameter of a ball of this size.
  [[nodiscard]] bool is_overall_sphere(const features::PartSurface& sphere) const {
    return std::any_of(subject_.extents.begin(), subject_.extents.end(), [&](const design::Extent& extent) {
      return extent.form == design::ExtentForm::sphere && agree(extent.size(), 2 * sphere.radius);
    });
  }

  // Positions of holes are asked for along the axes of the world across theirs.
  [[nodiscard]] bool is_placed(const design::DesignHole& hole) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(hole.axis[axis]) <= parallel && !chains_[axis].is_joined(hole.mouth[axis])) return false;
    return true;
  }

  // By its angle, or by the places of its ends.
  std::vector<bool> slopes_given(std::span<const DimensionsInView> views) {
    std::vector<bool> given;
    check(subject_.features.bevels.empty() || !views.empty(), "slopes are seen in views");
    for (const design::DesignBevel& bevel : subject_.features.bevels) {
      bool is_known = true;
      if (has_angle(bevel, subject_)) {
        is_known = std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
          return std::any_of(view.dimensions.begin(), view.dimensions.end(),
                             [&](const AnchoredDimension& one) { return is_angle_of(one, bevel); });
        });
        if (!is_known) coverage_.undimensioned.push_back("slope of " + format_rounded(bevel.area, 4) + " mm²: angle");
      } else {
        for (int axis = 0; axis < 3; ++axis)
          for (const Vec3& end : bevel.ends)
            is_known = is_known && (axis == bevel.along || chains_[axis].is_joined(end[axis]));
      }
      given.push_back(is_known);
    }
    return given;
  }

  void count_faces(std::vector<bool> slopes, const std::vector<bool>& turned_holes) {
    GivenSizes given{[this](int axis, double at) { return chains_[axis].is_joined(at); },
                     [this](const features::PartFace& face) { return has_doubly_curved(face); }};
    const std::vector<design::DesignHole>& holes = subject_.features.holes;
    int placed = 0;
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      const CircleSize& size = sizes_[i];
      const bool is_hole = i < holes.size();  // the sizes of holes are the first
      const bool has_size = is_given(size) || (is_hole && is_labelled(holes[i]));
      given.circles.push_back({size.centre, size.axis, size.radius, has_size});
      if (size.kind == "slot") given.slots.push_back(has_size);
      if (!is_hole) continue;
      given.holes.push_back(has_size);
      if (has_size && turned_holes[i] && is_placed(holes[i])) ++placed;
      given.circles.push_back({size.centre, size.axis, holes[i].diameter / 2, has_size});
      for (const auto& recess : {holes[i].counterbore, holes[i].countersink})
        if (recess) given.circles.push_back({size.centre, size.axis, recess->diameter / 2, has_size});
    }
    check(given.holes.size() == holes.size(), "the sizes of holes are the first");
    given.radii = radii_;
    for (const SizedCircle& circle : given.circles)
      if (circle.is_given) given.radii.push_back(circle.radius);
    for (const int dimensions : widths_) given.hexagons.push_back(dimensions > 0);
    given.bevels = std::move(slopes);
    FaceCoverage faces = cover_faces(subject_, given, notation_);
    coverage_.counts = std::move(faces.counts);
    if (!holes.empty()) coverage_.counts.push_back({"holes", placed, static_cast<int>(holes.size())});
    std::vector<std::string>& open = coverage_.undimensioned;
    open.insert(open.end(), faces.unaccounted.begin(), faces.unaccounted.end());
  }

  // Spheres and tori, and models whose faces are others than those of their files.
  void add_uncheckable(std::span<const DimensionsInView> views) {
    for (std::size_t model = 0; model < subject_.world.models.size(); ++model) {
      const world::Placed& placed = subject_.world.models[model];
      if (placed.part == nullptr) continue;
      if (const auto part = world::place_part(placed))
        add_doubly_curved(*part, views);
      else
        coverage_.undimensioned.push_back("model " + std::to_string(model) +
                                          ": it is scaled unequally, so only overall sizes are checked");
    }
  }

  [[nodiscard]] bool has_doubly_curved(const features::PartFace& face) const {
    const bool sphere = face.surface.kind == features::SurfaceKind::sphere;
    const double radius = sphere ? face.surface.radius : face.surface.minor;
    check(radius > 0, "a sphere or torus has a radius");
    const auto is_it = [&](double r) {
      return agree(r, radius) || are_written_alike(r, radius, notation_) ||
             std::abs(r - radius) <= design::radius_doubt(face);
    };
    return std::any_of(radii_.begin(), radii_.end(), is_it) || (sphere && is_overall_sphere(face.surface));
  }

  // Parts of a fillet around a corner belong to it: a dimension of its radius gives theirs.
  void add_doubly_curved(const world::PlacedPart& part, std::span<const DimensionsInView> views) {
    std::vector<features::PartSurface> seen;
    for (const features::PartFace& face : part.faces) {
      const features::PartSurface& surface = face.surface;
      const bool sphere = surface.kind == features::SurfaceKind::sphere;
      if (!sphere && surface.kind != features::SurfaceKind::torus) continue;
      const auto same = [&](const features::PartSurface& other) { return features::are_one(other, surface); };
      if (has_doubly_curved(face) || std::any_of(seen.begin(), seen.end(), same)) continue;
      seen.push_back(surface);
      if (sphere)
        add_undimensioned("sphere SR" + length(surface.radius), {});
      else
        add_undimensioned("torus R" + length(surface.minor) + " around ⌀" + length(2 * surface.radius),
                          remedy_beside(surface.axis, views));
    }
  }

  // Equal sentences once, with their number.
  static void merge(std::vector<std::string>& sentences) {
    std::vector<std::pair<std::string, int>> counted;
    for (const std::string& sentence : sentences) {
      const auto same =
          std::find_if(counted.begin(), counted.end(), [&](const auto& c) { return c.first == sentence; });
      if (same == counted.end())
        counted.emplace_back(sentence, 1);
      else
        ++same->second;
    }
    sentences.clear();
    for (const auto& [sentence, count] : counted)
      sentences.push_back((count > 1 ? std::to_string(count) + "× " : "") + sentence);
  }

  const DimensionSubject& subject_;
  Notation notation_;
  std::vector<PlaceChain> chains_;
  std::vector<CircleSize> sizes_;
  std::vector<int> widths_;          // dimensions that give that of each hexagon
  std::vector<double> radii_;        // that dimensions give
  std::vector<WorldCircle> labels_;  // of holes in tables
  Coverage coverage_;
};

}  // namespace

Coverage find_coverage(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                       const Notation& notation) {
  return CoverageFinder(subject, notation).find(views);
}

}  // namespace epura::sheet
