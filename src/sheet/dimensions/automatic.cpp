// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/automatic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/axis_positions.hpp"
#include "sheet/dimensions/cone_dimensions.hpp"
#include "sheet/dimensions/equal_features.hpp"
#include "sheet/dimensions/hexagon_widths.hpp"
#include "sheet/dimensions/hole_angles.hpp"
#include "sheet/dimensions/level_stations.hpp"
#include "sheet/dimensions/planning.hpp"
#include "sheet/dimensions/round_ends.hpp"
#include "sheet/dimensions/rounded_edges.hpp"
#include "sheet/dimensions/slope_dimensions.hpp"
#include "sheet/dimensions/thread_notes.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;
using design::are_same;
using design::same_size;
using scene::DimensionDescription;

class Planner {
 public:
  Planner(const DimensionDescription& wanted, std::span<const NamedProjection> views, const DimensionSubject& subject,
          const Notation& notation)
      : plan_(wanted, views, subject, notation) {}

  AutomaticPlan plan(std::span<const NamedProjection> views) {
    DimensionDescription overall = plan_.wanted;
    overall.type = {DimensionType::overall, plan_.wanted.type.where};
    plan_.dimensions = overall_dimensions(overall, views, plan_.subject.extents);
    add_round_ends();
    add_hexagons();
    add_radial_holes();
    add_holes();
    add_pitch_circles();
    add_cylinders();
    add_slots();
    add_arcs();
    add_rounds();
    add_balls();
    add_chamfers(plan_);
    add_cones(plan_);
    add_slopes(plan_);
    for (const Station& level : level_stations(plan_.subject, plan_.views, plan_.stations)) plan_.stations.add(level);
    for (DimensionDescription& dimension : plan_.stations.dimensions(plan_.wanted, plan_.notation))
      plan_.dimensions.push_back(std::move(dimension));
    leave_out_excess();
    for (const DimensionDescription& dimension : plan_.dimensions)
      check(dimension.view.given() && dimension.type.given(), "an automatic dimension has a type and a view");
    return {std::move(plan_.dimensions), std::move(tables_)};
  }

 private:
  // Machines of a hundred parts have more features than a sheet has room for.
  void leave_out_excess() {
    std::map<std::pair<std::string, int>, std::size_t> count;
    std::erase_if(plan_.dimensions, [&](const DimensionDescription& dimension) {
      if (dimension.is_label) return false;
      const int row = dimension.direction.given() ? static_cast<int>(*dimension.direction) : -1;
      return ++count[{*dimension.view, row}] > most_of_a_kind;
    });
  }

  DimensionDescription& add(DimensionType type, const NamedProjection& view, const std::string& text) {
    return plan_.add(type, view, text);
  }

  // A view that shows one of several equal features from the side.
  template <class Feature>
  [[nodiscard]] const NamedProjection* beside(const std::vector<const Feature*>& group,
                                              const std::function<Vec3(const Feature&)>& centre) const {
    const NamedProjection* view = nullptr;
    for (std::size_t i = 0; i < group.size() && view == nullptr; ++i)
      view = plan_.views.beside(group[i]->axis, centre(*group[i]));
    return view;
  }

  [[nodiscard]] std::string length(double value) const { return plan_.length(value); }

  [[nodiscard]] std::string note_of(const design::DesignHole& hole, std::size_t count) const {
    return times(count) + name_in_note(hole.thread) + recesses_of(hole, plan_.notation);
  }

  // The width across flats of a hexagon gives that across its corners, which is auxiliary, and the places of its flats;
  // on the axis of a hexagon that is as large as the models, nothing needs a position.
  void add_hexagons() {
    for (const design::DesignHexagon& hexagon : plan_.subject.features.hexagons) {
      check(hexagon.across_flats > 0, "a hexagon has a width");
      if (!has_width(hexagon, plan_.views)) continue;
      for (DimensionDescription& overall : plan_.dimensions)
        if (const int axis = axis_of(*overall.direction);
            is_extent(hexagon, axis, plan_.subject, false) && !is_extent(hexagon, axis, plan_.subject, true))
          overall.text = {"(<>)", plan_.wanted.where};
      for (int axis = 0; axis < 3; ++axis) {
        if (is_extent(hexagon, axis, plan_.subject, false)) plan_.stations.know(axis, hexagon.centre[axis]);
        for (const Vec3& normal : hexagon.normals)
          if (world_axis(normal) == axis)
            for (const double side : {-0.5, 0.5})
              plan_.stations.know(axis, hexagon.centre[axis] + side * hexagon.across_flats);
      }
      ++plan_.groups;
      if (const NamedProjection* view = plan_.views.along(hexagon.axis))
        add_positions(plan_, std::array{hexagon.centre}, hexagon.axis, view);
    }
    for (DimensionDescription& width : hexagon_widths(plan_.wanted, plan_.views, plan_.subject))
      plan_.dimensions.push_back(std::move(width));
  }

  // Whether holes of one group are behind those of the other, and look the same from the other side.
  [[nodiscard]] bool are_opposite(const std::vector<const design::DesignHole*>& group,
                                  const std::vector<const design::DesignHole*>& other) const {
    design::DesignHole turned = *other.front();
    turned.axis = -turned.axis;
    const auto is_behind = [&](const design::DesignHole* hole) {
      return std::any_of(group.begin(), group.end(), [&](const design::DesignHole* one) {
        return are_coaxial(one->mouth, one->axis, hole->mouth, one->called());
      });
    };
    return group.size() == other.size() && !turned.through && design::are_equal(*group.front(), turned) &&
           std::all_of(other.begin(), other.end(), is_behind);
  }

  // Groups of equal holes; those behind others that only one view shows have one note with them. Rows of a table name
  // the side by their letters.
  [[nodiscard]] std::vector<std::vector<const design::DesignHole*>> groups_of_holes() const {
    auto groups = groups_of<design::DesignHole>(plan_.subject.features.holes, design::are_equal);
    for (auto& group : groups) {
      std::erase_if(group, [this](const design::DesignHole* hole) { return is_radial(*hole); });
      if (group.empty()) continue;
      const Vec3 axis = group.front()->axis;
      const NamedProjection* view = plan_.views.along(axis, true);
      if (view == nullptr || glm::dot(view->projection.n, axis) <= 0 || plan_.views.along(-axis, true) != view)
        continue;
      if (has_table() && can_have_table(*view)) continue;
      const auto other = std::find_if(groups.begin(), groups.end(), [&](const auto& one) {
        return &one != &group && !one.empty() && are_opposite(group, one);
      });
      if (other == groups.end()) continue;
      group.insert(group.end(), other->begin(), other->end());
      other->clear();
    }
    std::erase_if(groups, [](const auto& group) { return group.empty(); });
    for (const auto& group : groups) check(!group.empty(), "a group of holes has one");
    return groups;
  }

  void add_holes() {
    for (const auto& group : groups_of_holes()) {
      ++plan_.groups;
      const NamedProjection* along = plan_.views.along(group.front()->axis, !group.front()->through);
      const auto mouth = [](const design::DesignHole& hole) { return hole.mouth; };
      const NamedProjection* view = along != nullptr ? along : beside<design::DesignHole>(group, mouth);
      if (view == nullptr) continue;
      check(group.front()->called() > 0, "a hole has a diameter");
      if (along != nullptr && has_table() && can_have_table(*view)) {
        add_to_table(group, *view);
        continue;
      }
      const auto* shown = uppermost<design::DesignHole>(group, *view, mouth);
      add(DimensionType::diameter, *view, note_of(*group.front(), group.size())).circle = {
          shown->mouth, shown->axis, shown->called() / 2, {}};
      std::vector<Vec3> centres;
      for (const design::DesignHole* hole : group)
        if (hole->pitch_circle < 0) centres.push_back(hole->mouth);
      if (!centres.empty()) add_positions(plan_, centres, group.front()->axis, along);
    }
  }

  // One note, the angles and the height of holes that lead to the axis of a round part.
  void add_radial_holes() {
    radial_ = find_radial_patterns(plan_.subject.features);
    for (const RadialPattern& pattern : radial_) {
      ++plan_.groups;
      const auto mouth = [](const design::DesignHole& hole) { return hole.mouth; };
      check(pattern.holes.size() >= 2, "holes of a radial pattern have several directions");
      const design::DesignHole* shown = pattern.holes.front();
      const NamedProjection* view = nullptr;
      for (const design::DesignHole* hole : pattern.holes)
        if (const NamedProjection* along = plan_.views.along(hole->axis, true); along != nullptr && view == nullptr) {
          view = along;
          shown = hole;
        }
      if (view == nullptr) view = beside<design::DesignHole>(pattern.holes, mouth);
      if (view == nullptr) continue;
      add(DimensionType::diameter, *view, note_of(*shown, pattern.holes.size())).circle = {
          shown->mouth, shown->axis, shown->called() / 2, {}};
      add_angles(plan_, directions_of(pattern), true);
      const int axis = world_axis(pattern.axis);
      const NamedProjection* across = plan_.views.across(pattern.axis, shown->mouth);
      if (axis < 0 || across == nullptr) continue;
      plan_.stations.add({across, axis, shown->mouth[axis], shown->mouth, plan_.groups, shown->mouth});
    }
  }

  [[nodiscard]] bool is_radial(const design::DesignHole& hole) const {
    return std::any_of(radial_.begin(), radial_.end(), [&](const RadialPattern& pattern) {
      return std::find(pattern.holes.begin(), pattern.holes.end(), &hole) != pattern.holes.end();
    });
  }

  [[nodiscard]] bool has_table() const {
    return plan_.wanted.holes.value_or(HoleDimensions::notes) == HoleDimensions::table;
  }

  static bool can_have_table(const NamedProjection& view) {
    return world_axis(view.projection.u) >= 0 && world_axis(view.projection.v) >= 0;
  }

  // The left or lower end of the models in a view along one of its directions; the axis of a round part.
  [[nodiscard]] double origin_along(const Vec3& direction) const {
    const int axis = world_axis(direction);
    const design::Extent& extent = plan_.subject.extents[axis];
    if (extent.form != design::ExtentForm::length) return (extent.from + extent.to) / 2;
    return direction[axis] > 0 ? extent.from : extent.to;
  }

  HoleTable& table_of(const NamedProjection& view) {
    for (HoleTable& table : tables_)
      if (table.view == view.name) return table;
    HoleTable& table = tables_.emplace_back();
    table.view = view.name;
    table.origin = plan_.box.max;
    for (const Vec3& along : {view.projection.u, view.projection.v})
      table.origin[world_axis(along)] = origin_along(along);
    return table;
  }

  // Numbered from left to right, then upwards.
  void add_to_table(std::vector<const design::DesignHole*> group, const NamedProjection& view) {
    HoleTable& table = table_of(view);
    const Vec3 u = view.projection.u, v = view.projection.v, origin = table.origin;
    const auto place = [&](const design::DesignHole* hole) {
      return std::pair(glm::dot(hole->mouth - origin, u), glm::dot(hole->mouth - origin, v));
    };
    const double same = same_size * glm::length(plan_.box.size());
    std::sort(group.begin(), group.end(), [&](const auto* a, const auto* b) {
      const auto [ax, ay] = place(a);
      const auto [bx, by] = place(b);
      return std::pair(std::round(ax / same), ay) < std::pair(std::round(bx / same), by);
    });
    const std::string letters = letters_of(labelled_++);
    for (std::size_t i = 0; i < group.size(); ++i) {
      const design::DesignHole& hole = *group[i];
      check(hole.called() > 0, "a hole has a diameter");
      const auto [x, y] = place(&hole);
      const std::string label = letters + std::to_string(i + 1);
      const std::string size = hole.thread ? hole.thread->text : "⌀" + length(hole.diameter);
      table.rows.push_back({label, length(x), length(y), size + recesses_of(hole, plan_.notation)});
      DimensionDescription& dimension = add(DimensionType::diameter, view, label);
      dimension.circle = {hole.mouth, hole.axis, hole.called() / 2, {}};
      dimension.is_label = true;
      for (const Vec3& along : {u, v}) plan_.stations.know(world_axis(along), hole.mouth[world_axis(along)]);
    }
  }

  void add_pitch_circles() {
    if (has_table()) return;
    const std::vector<design::DesignPitchCircle>& circles = plan_.subject.features.pitch_circles;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      ++plan_.groups;
      const NamedProjection* view = plan_.views.along(circles[i].axis);
      if (view == nullptr) continue;
      add(DimensionType::diameter, *view, "<>").circle = {circles[i].centre, circles[i].axis, circles[i].radius, {}};
      add_angles(plan_, directions_of(plan_.subject.features, static_cast<int>(i)), false);
      add_positions(plan_, std::array{circles[i].centre}, circles[i].axis, view);
    }
  }

  // The radius of a round end and the place of its centre give the size over it.
  void add_round_ends() {
    const std::vector<RoundEnd> ends = find_round_ends(plan_.subject.features);
    for (DimensionDescription& overall : plan_.dimensions) {
      const int axis = axis_of(*overall.direction);
      const design::Extent& extent = plan_.subject.extents[static_cast<std::size_t>(axis)];
      // It bulges beyond the faces beside it, or is as wide as the models.
      const auto gives = [&](const RoundEnd& end) {
        const bool low = end.ends_models(axis, 0, extent), high = end.ends_models(axis, 1, extent);
        return plan_.views.along(end.axis) != nullptr &&
               ((low && high) || (low && end.bulges(axis, 0)) || (high && end.bulges(axis, 1)));
      };
      if (std::any_of(ends.begin(), ends.end(), gives)) overall.text = {"(<>)", plan_.wanted.where};
    }
    // Its radius is half of the width of a bar.
    for (const RoundEnd& end : ends)
      for (int axis = 0; axis < 3; ++axis)
        if (const design::Extent& extent = plan_.subject.extents[static_cast<std::size_t>(axis)];
            end.ends_models(axis, 0, extent) && end.ends_models(axis, 1, extent))
          plan_.stations.know(axis, end.centre[axis]);
  }

  // The end of a cylinder from which extension lines to the outside are short.
  [[nodiscard]] Vec3 outer_end(const design::DesignCylinder& cylinder) const {
    const Vec3 middle = plan_.box.centre();
    const auto off = [&](const Vec3& p) { return std::abs(glm::dot(p - middle, cylinder.axis)); };
    return off(cylinder.from) > off(cylinder.to) ? cylinder.from : cylinder.to;
  }

  void add_cylinders() {
    std::vector<design::DesignCylinder> left;
    for (const design::DesignCylinder& cylinder : plan_.subject.features.cylinders)
      if (cylinder.inwards || !sheet::is_overall(plan_.subject, cylinder)) left.push_back(cylinder);
    const auto equal = [](const design::DesignCylinder& a, const design::DesignCylinder& b) {
      return a.inwards == b.inwards && a.whole == b.whole && a.model == b.model && are_same(a.radius, b.radius) &&
             are_parallel(a.axis, b.axis) && name_in_note(a.thread) == name_in_note(b.thread);
    };
    for (const auto& group : groups_of<design::DesignCylinder>(left, equal)) {
      ++plan_.groups;
      const Vec3& axis = group.front()->axis;
      const NamedProjection* along = plan_.views.along(axis);
      const auto end = [this](const design::DesignCylinder& cylinder) { return outer_end(cylinder); };
      const NamedProjection* across = group.front()->inwards ? nullptr : plan_.views.across(axis, end(*group.front()));
      // Across an interrupted one, its outline may not be seen.
      const bool is_clear = across != nullptr && (group.front()->whole || along == nullptr);
      const NamedProjection* view = is_clear ? across : along;
      if (view == nullptr && group.front()->whole) view = beside<design::DesignCylinder>(group, end);
      if (view == nullptr) continue;
      const design::DesignCylinder& shown = *uppermost<design::DesignCylinder>(group, *view, end);
      check(shown.called() > 0, "a cylinder has a radius");
      add(DimensionType::diameter, *view, times(group.size()) + name_in_note(shown.thread)).circle = {
          outer_end(shown), axis, shown.called(), {}};
      if (across != nullptr) add_thread_ends(group, *across);
      std::vector<Vec3> centres;
      for (const design::DesignCylinder* cylinder : group) centres.push_back(cylinder->from);
      add_positions(plan_, centres, axis, along);
    }
  }

  // Useful lengths of threads, as positions of their ends.
  void add_thread_ends(const std::vector<const design::DesignCylinder*>& group, const NamedProjection& view) {
    for (const design::DesignCylinder* cylinder : group) {
      const int axis = world_axis(cylinder->axis);
      if (axis < 0 || !cylinder->thread || !cylinder->thread->length) continue;
      const bool horizontal = std::abs(view.projection.u[axis]) > 0.5;
      const Vec3 towards = cylinder->called() * (horizontal ? -view.projection.v : view.projection.u);
      const Vec3& end = cylinder->thread->end;
      plan_.stations.add({&view, axis, end[axis], end + towards, -1, end - towards});
    }
  }

  void add_slots() {
    const auto span = [](const design::DesignSlot& slot) { return slot.centres[1] - slot.centres[0]; };
    const auto equal = [&](const design::DesignSlot& a, const design::DesignSlot& b) {
      return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis) &&
             are_same(glm::length(span(a)), glm::length(span(b))) &&
             are_parallel(glm::normalize(span(a)), glm::normalize(span(b)));
    };
    for (const auto& group : groups_of<design::DesignSlot>(plan_.subject.features.slots, equal)) {
      ++plan_.groups;
      const design::DesignSlot& slot = *group.front();
      check(slot.radius > 0 && slot.centres[0] != slot.centres[1], "a slot has a width and a length");
      const NamedProjection* view = plan_.views.along(slot.axis);
      if (view == nullptr) continue;
      const Vec3 along = glm::normalize(span(slot)), out = glm::cross(slot.axis, along);
      std::vector<Vec3> arc;
      for (const double turn : {-1.0, 0.0, 1.0})
        arc.push_back(slot.centres[1] + slot.radius * (turn * out + (1 - std::abs(turn)) * along));
      add(DimensionType::radius, *view, times(2 * group.size()) + "<>").circle = {slot.centres[1], slot.axis,
                                                                                  slot.radius, arc};
      const int axis = world_axis(along);
      if (axis >= 0)
        add(DimensionType::aligned, *view, times(group.size()) + "<>").anchors = {slot.centres[0], slot.centres[1]};
      for (const design::DesignSlot* one : group) {
        const double way = glm::dot(span(*one), view->projection.u + view->projection.v);
        const auto& [low, high] = std::pair(one->centres[way > 0 ? 0 : 1], one->centres[way > 0 ? 1 : 0]);
        add_positions(plan_, std::array{low}, slot.axis, view);
        if (axis >= 0)
          plan_.stations.know(axis, high[axis]);
        else
          add_positions(plan_, std::array{high}, slot.axis, view);
      }
    }
  }

  // Equal radii have one note, whatever their axes: the view that shows most of them has it.
  void add_arcs() {
    const auto equal = [this](const design::DesignArc& a, const design::DesignArc& b) {
      return a.model == b.model && are_alike(a.radius, b.radius);
    };
    auto groups = groups_of<design::DesignArc>(plan_.subject.features.arcs, equal);
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
      return double(a.size()) * a.front()->radius > double(b.size()) * b.front()->radius;
    });
    const Vec3 size = plan_.box.size();
    const double largest = std::max({size.x, size.y, size.z});
    std::map<std::string, std::size_t> in_view;
    for (const RoundEnd& end : find_round_ends(plan_.subject.features)) {
      ++plan_.groups;
      add_positions(plan_, std::array{end.centre}, end.axis, plan_.views.along(end.axis));
    }
    for (const auto& group : groups) {
      const auto [view, seen] = most_seen(group);
      if (view == nullptr || double(group.size()) * group.front()->radius < least_radius * largest ||
          in_view[view->name]++ >= most_radii)
        continue;
      const auto* shown =
          uppermost<design::DesignArc>(seen, *view, [](const design::DesignArc& arc) { return arc.points[4]; });
      check(shown->radius > 0 && shown->points.size() > 4, "an arc has a radius and a middle");
      add(DimensionType::radius, *view, times(group.size()) + "<>").circle = {shown->centre, shown->axis, shown->radius,
                                                                              shown->points};
    }
  }

  // The view along most of some arcs, and these.
  [[nodiscard]] std::pair<const NamedProjection*, std::vector<const design::DesignArc*>> most_seen(
      const std::vector<const design::DesignArc*>& arcs) const {
    std::pair<const NamedProjection*, std::vector<const design::DesignArc*>> best{};
    for (const NamedProjection* view : plan_.views.all()) {
      std::vector<const design::DesignArc*> seen;
      std::copy_if(arcs.begin(), arcs.end(), std::back_inserter(seen),
                   [&](const design::DesignArc* arc) { return plan_.views.along(arc->axis) == view; });
      if (seen.size() > best.second.size()) best = {view, std::move(seen)};
    }
    return best;
  }

  [[nodiscard]] bool are_alike(double a, double b) const { return are_written_alike(a, b, plan_.notation); }

  [[nodiscard]] bool has_radius(double radius, double doubt = 0) const {
    return std::any_of(plan_.dimensions.begin(), plan_.dimensions.end(), [&](const DimensionDescription& dimension) {
      return *dimension.type == DimensionType::radius &&
             (are_alike(dimension.circle->radius, radius) || std::abs(dimension.circle->radius - radius) <= doubt);
    });
  }

  // Those whose radius is not that of a fillet with a dimension, to which they belong.
  void add_rounds() {
    const auto equal = [](const design::DesignRound& a, const design::DesignRound& b) {
      return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
    };
    for (const auto& group : groups_of<design::DesignRound>(plan_.subject.features.rounds, equal)) {
      const design::DesignRound& round = *group.front();
      std::optional<SeenSection> seen = seen_section(round, plan_.views);
      if (!seen || has_radius(round.radius)) continue;
      add(DimensionType::radius, *seen->view, times(group.size()) + "<>").circle = std::move(seen->circle);
    }
  }

  // Spheres that are no corners of fillets, in the first view that shows their outline.
  void add_balls() {
    const auto equal = [&](const design::DesignBall& a, const design::DesignBall& b) {
      return a.model == b.model && are_alike(a.radius, b.radius);
    };
    for (const auto& group : groups_of<design::DesignBall>(plan_.subject.features.balls, equal)) {
      const design::DesignBall& ball = *group.front();
      check(ball.radius > 0, "a ball has a radius");
      if (has_radius(ball.radius, ball.doubt) || is_overall(ball)) continue;
      const auto found = std::find_if(
          plan_.views.all().begin(), plan_.views.all().end(),
          [&](const NamedProjection* one) { return std::abs(glm::dot(ball.middle, one->projection.n)) < 0.5; });
      if (found == plan_.views.all().end()) continue;
      const NamedProjection* view = *found;
      const projection::Projection& projection = view->projection;
      const Vec3 flat = ball.middle - glm::dot(ball.middle, projection.n) * projection.n;
      const Vec3 out = glm::normalize(glm::length(flat) > 0.1 ? flat : projection.u + projection.v);
      const Vec3 aside = glm::cross(projection.n, out);
      std::vector<Vec3> arc;
      for (const double turn : {-0.1, 0.0, 0.1})
        arc.push_back(ball.centre + ball.radius * glm::normalize(out + turn * aside));
      add(DimensionType::radius, *view, times(group.size()) + "S<>").circle = {ball.centre, projection.n, ball.radius,
                                                                               arc};
    }
  }

  // Whether an overall dimension is the diameter of a ball.
  [[nodiscard]] bool is_overall(const design::DesignBall& ball) const {
    return std::any_of(plan_.subject.extents.begin(), plan_.subject.extents.end(), [&](const design::Extent& extent) {
      return extent.form == design::ExtentForm::sphere && are_same(extent.size(), 2 * ball.radius);
    });
  }

  Planning plan_;
  std::vector<RadialPattern> radial_;
  std::vector<HoleTable> tables_;
  std::size_t labelled_ = 0;  // groups in tables
};

}  // namespace

AutomaticPlan automatic_dimensions(const DimensionDescription& wanted, std::span<const NamedProjection> views,
                                   const DimensionSubject& subject, const Notation& notation) {
  if (wanted.tolerance.given() || wanted.limits.given())
    throw Error(ErrorKind::input, wanted.tolerance.given() ? wanted.tolerance.where : wanted.limits.where,
                "automatic dimensions have no common tolerance",
                "add a [[dimension]] for the size, or general_tolerance to the [title_block]");
  return Planner(wanted, views, subject, notation).plan(views);
}

}  // namespace epura::sheet
