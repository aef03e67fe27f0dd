// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/automatic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/anchors.hpp"
#include "sheet/dimensions/cone_angles.hpp"
#include "sheet/dimensions/equal_features.hpp"
#include "sheet/dimensions/hexagon_widths.hpp"
#include "sheet/dimensions/level_stations.hpp"
#include "sheet/dimensions/rounded_edges.hpp"
#include "sheet/dimensions/stations.hpp"
#include "sheet/dimensions/thread_notes.hpp"
#include "sheet/dimensions/view_choice.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;
using design::are_same;
using design::same_size;
using scene::DimensionDescription;

constexpr std::size_t most_of_a_kind = 40;  // notes, horizontal or vertical dimensions of a view

bool are_coaxial(const Vec3& point, const Vec3& axis, const Vec3& other, double size) {
  return glm::length(glm::cross(other - point, axis)) <= same_size * size;
}

bool are_equal_chamfers(const design::DesignBevel& a, const design::DesignBevel& b) {
  return a.model == b.model && a.along == b.along && are_same(a.leg(), b.leg());
}

bool are_equal_ends(const design::DesignCylinder& a, const design::DesignCylinder& b) {
  return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
}

class Planner {
 public:
  Planner(const DimensionDescription& wanted, std::span<const NamedProjection> views, const DimensionSubject& subject,
          const Notation& notation)
      : wanted_(wanted),
        views_(wanted, views),
        subject_(subject),
        notation_(notation),
        stations_(subject),
        box_(design::box_of_faces(subject.world)) {}

  AutomaticPlan plan(std::span<const NamedProjection> views) {
    DimensionDescription overall = wanted_;
    overall.type = {DimensionType::overall, wanted_.type.where};
    dimensions_ = overall_dimensions(overall, views, subject_.extents);
    add_hexagons();
    add_holes();
    add_pitch_circles();
    add_cylinders();
    add_slots();
    add_arcs();
    add_rounds();
    add_balls();
    add_chamfers();
    add_cones();
    add_bevels();
    for (const Station& level : level_stations(subject_, views_, stations_)) stations_.add(level);
    for (DimensionDescription& dimension : stations_.dimensions(wanted_, notation_))
      dimensions_.push_back(std::move(dimension));
    leave_out_excess();
    for (const DimensionDescription& dimension : dimensions_)
      check(dimension.view.given() && dimension.type.given(), "an automatic dimension has a type and a view");
    return {std::move(dimensions_), std::move(tables_)};
  }

 private:
  // Machines of a hundred parts have more features than a sheet has room for.
  void leave_out_excess() {
    std::map<std::pair<std::string, int>, std::size_t> count;
    std::erase_if(dimensions_, [&](const DimensionDescription& dimension) {
      if (dimension.is_label) return false;
      const int row = dimension.direction.given() ? static_cast<int>(*dimension.direction) : -1;
      return ++count[{*dimension.view, row}] > most_of_a_kind;
    });
  }

  DimensionDescription& add(DimensionType type, const NamedProjection& view, const std::string& text) {
    DimensionDescription& dimension = dimensions_.emplace_back();
    dimension.where = wanted_.where;
    dimension.view = {view.name, wanted_.where};
    dimension.type = {type, wanted_.where};
    if (text != "<>") dimension.text = {text, wanted_.where};
    return dimension;
  }

  // In the upper right, where leaders find room beside the lower and left baselines.
  template <class Feature>
  static const Feature* uppermost(const std::vector<const Feature*>& group, const NamedProjection& view,
                                  const std::function<Vec3(const Feature&)>& centre) {
    const auto height = [&](const Feature* one) {
      const std::optional<Vec3> shown = shown_point(view, centre(*one));
      return shown && keeps(view, centre(*one)) ? glm::dot(*shown, view.projection.u + view.projection.v) : -HUGE_VAL;
    };
    return *std::max_element(group.begin(), group.end(),
                             [&](const Feature* a, const Feature* b) { return height(a) < height(b); });
  }

  // A view that shows one of several equal features from the side.
  template <class Feature>
  [[nodiscard]] const NamedProjection* beside(const std::vector<const Feature*>& group,
                                              const std::function<Vec3(const Feature&)>& centre) const {
    const NamedProjection* view = nullptr;
    for (std::size_t i = 0; i < group.size() && view == nullptr; ++i)
      view = views_.beside(group[i]->axis, centre(*group[i]));
    return view;
  }

  // Positions in the plane of a view, along the axes of the world that it shows.
  void add_position(const NamedProjection& view, const Vec3& centre, int group) {
    for (const Vec3& along : {view.projection.u, view.projection.v})
      if (const int axis = world_axis(along); axis >= 0)
        stations_.add({&view, axis, centre[axis], centre, group, centre});
  }

  [[nodiscard]] std::string length(double value) const { return length_text(value, notation_); }

  [[nodiscard]] std::string note_of(const design::DesignHole& hole, std::size_t count) const {
    return times(count) + name_in_note(hole.thread) + recesses_of(hole, notation_);
  }

  // The width across flats of a hexagon gives that across its corners, which is auxiliary, and the places of its flats;
  // on the axis of a hexagon that is as large as the models, nothing needs a position.
  void add_hexagons() {
    for (const design::DesignHexagon& hexagon : subject_.features.hexagons) {
      check(hexagon.across_flats > 0, "a hexagon has a width");
      if (!has_width(hexagon, views_)) continue;
      for (DimensionDescription& overall : dimensions_)
        if (const int axis = axis_of(*overall.direction);
            is_extent(hexagon, axis, subject_, false) && !is_extent(hexagon, axis, subject_, true))
          overall.text = {"(<>)", wanted_.where};
      for (int axis = 0; axis < 3; ++axis) {
        if (is_extent(hexagon, axis, subject_, false)) stations_.know(axis, hexagon.centre[axis]);
        for (const Vec3& normal : hexagon.normals)
          if (world_axis(normal) == axis)
            for (const double side : {-0.5, 0.5})
              stations_.know(axis, hexagon.centre[axis] + side * hexagon.across_flats);
      }
      if (const NamedProjection* view = views_.along(hexagon.axis)) add_position(*view, hexagon.centre, ++groups_);
    }
    for (DimensionDescription& width : hexagon_widths(wanted_, views_, subject_))
      dimensions_.push_back(std::move(width));
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
    auto groups = groups_of<design::DesignHole>(subject_.features.holes, design::are_equal);
    for (auto& group : groups) {
      if (group.empty()) continue;
      const Vec3 axis = group.front()->axis;
      const NamedProjection* view = views_.along(axis, true);
      if (view == nullptr || glm::dot(view->projection.n, axis) <= 0 || views_.along(-axis, true) != view) continue;
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
      ++groups_;
      const NamedProjection* along = views_.along(group.front()->axis, !group.front()->through);
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
      for (const design::DesignHole* hole : group)
        if (along != nullptr && hole->pitch_circle < 0) add_position(*along, hole->mouth, groups_);
    }
  }

  [[nodiscard]] bool has_table() const {
    return wanted_.holes.value_or(HoleDimensions::notes) == HoleDimensions::table;
  }

  static bool can_have_table(const NamedProjection& view) {
    return world_axis(view.projection.u) >= 0 && world_axis(view.projection.v) >= 0;
  }

  // The left or lower end of the models in a view along one of its directions; the axis of a round part.
  [[nodiscard]] double origin_along(const Vec3& direction) const {
    const int axis = world_axis(direction);
    const design::Extent& extent = subject_.extents[axis];
    if (extent.form != design::ExtentForm::length) return (extent.from + extent.to) / 2;
    return direction[axis] > 0 ? extent.from : extent.to;
  }

  HoleTable& table_of(const NamedProjection& view) {
    for (HoleTable& table : tables_)
      if (table.view == view.name) return table;
    HoleTable& table = tables_.emplace_back();
    table.view = view.name;
    table.origin = box_.max;
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
    const double same = same_size * glm::length(box_.size());
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
      table.rows.push_back({label, length(x), length(y), size + recesses_of(hole, notation_)});
      DimensionDescription& dimension = add(DimensionType::diameter, view, label);
      dimension.circle = {hole.mouth, hole.axis, hole.called() / 2, {}};
      dimension.is_label = true;
      for (const Vec3& along : {u, v}) stations_.know(world_axis(along), hole.mouth[world_axis(along)]);
    }
  }

  void add_pitch_circles() {
    if (has_table()) return;
    for (const design::DesignPitchCircle& circle : subject_.features.pitch_circles) {
      ++groups_;
      const NamedProjection* view = views_.along(circle.axis);
      if (view == nullptr) continue;
      add(DimensionType::diameter, *view, "<>").circle = {circle.centre, circle.axis, circle.radius, {}};
      add_position(*view, circle.centre, groups_);
    }
  }

  // Whether an overall dimension is the diameter of a cylinder.
  [[nodiscard]] bool is_overall(const design::DesignCylinder& cylinder) const {
    return std::any_of(subject_.extents.begin(), subject_.extents.end(), [&](const design::Extent& extent) {
      return extent.form == design::ExtentForm::diameter && are_same(extent.size(), 2 * cylinder.radius) &&
             are_parallel(extent.axis, cylinder.axis) &&
             are_coaxial(extent.centre, extent.axis, cylinder.from, cylinder.radius);
    });
  }

  // The end of a cylinder from which extension lines to the outside are short.
  [[nodiscard]] Vec3 outer_end(const design::DesignCylinder& cylinder) const {
    const Vec3 middle = box_.centre();
    const auto off = [&](const Vec3& p) { return std::abs(glm::dot(p - middle, cylinder.axis)); };
    return off(cylinder.from) > off(cylinder.to) ? cylinder.from : cylinder.to;
  }

  void add_cylinders() {
    std::vector<design::DesignCylinder> left;
    for (const design::DesignCylinder& cylinder : subject_.features.cylinders)
      if (cylinder.inwards || !is_overall(cylinder)) left.push_back(cylinder);
    const auto equal = [](const design::DesignCylinder& a, const design::DesignCylinder& b) {
      return a.inwards == b.inwards && a.whole == b.whole && a.model == b.model && are_same(a.radius, b.radius) &&
             are_parallel(a.axis, b.axis) && name_in_note(a.thread) == name_in_note(b.thread);
    };
    for (const auto& group : groups_of<design::DesignCylinder>(left, equal)) {
      ++groups_;
      const Vec3& axis = group.front()->axis;
      const NamedProjection* along = views_.along(axis);
      const auto end = [this](const design::DesignCylinder& cylinder) { return outer_end(cylinder); };
      const NamedProjection* across = group.front()->inwards ? nullptr : views_.across(axis, end(*group.front()));
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
      if (along == nullptr) continue;
      for (const design::DesignCylinder* cylinder : group) add_position(*along, cylinder->from, groups_);
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
      stations_.add({&view, axis, end[axis], end + towards, -1, end - towards});
    }
  }

  void add_slots() {
    const auto span = [](const design::DesignSlot& slot) { return slot.centres[1] - slot.centres[0]; };
    const auto equal = [&](const design::DesignSlot& a, const design::DesignSlot& b) {
      return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis) &&
             are_same(glm::length(span(a)), glm::length(span(b))) &&
             are_parallel(glm::normalize(span(a)), glm::normalize(span(b)));
    };
    for (const auto& group : groups_of<design::DesignSlot>(subject_.features.slots, equal)) {
      ++groups_;
      const design::DesignSlot& slot = *group.front();
      check(slot.radius > 0 && slot.centres[0] != slot.centres[1], "a slot has a width and a length");
      const NamedProjection* view = views_.along(slot.axis);
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
        add_position(*view, low, groups_);
        if (axis >= 0)
          stations_.know(axis, high[axis]);
        else
          add_position(*view, high, groups_);
      }
    }
  }

  void add_arcs() {
    const auto equal = [](const design::DesignArc& a, const design::DesignArc& b) {
      return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
    };
    auto groups = groups_of<design::DesignArc>(subject_.features.arcs, equal);
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
      return double(a.size()) * a.front()->radius > double(b.size()) * b.front()->radius;
    });
    const Vec3 size = box_.size();
    const double largest = std::max({size.x, size.y, size.z});
    std::map<std::string, std::size_t> in_view;
    for (const auto& group : groups) {
      const NamedProjection* view = views_.along(group.front()->axis);
      const std::size_t count = group.size() + (view == nullptr ? 0 : unseen_arcs(groups, *group.front()));
      const double sum = double(count) * group.front()->radius;
      if (view == nullptr || sum < least_radius * largest || in_view[view->name]++ >= most_radii) continue;
      const auto* shown =
          uppermost<design::DesignArc>(group, *view, [](const design::DesignArc& arc) { return arc.points[4]; });
      check(shown->radius > 0 && shown->points.size() > 4, "an arc has a radius and a middle");
      add(DimensionType::radius, *view, times(count) + "<>").circle = {shown->centre, shown->axis, shown->radius,
                                                                       shown->points};
    }
  }

  [[nodiscard]] bool are_alike(double a, double b) const { return are_written_alike(a, b, notation_); }

  // The number of fillets of the same radius whose form no view shows, such as those around a hexagon. The first group
  // that a view shows stands for them.
  std::size_t unseen_arcs(const std::vector<std::vector<const design::DesignArc*>>& groups,
                          const design::DesignArc& shown) const {
    std::size_t count = 0;
    for (const auto& group : groups) {
      const design::DesignArc& arc = *group.front();
      if (arc.model != shown.model || !are_alike(arc.radius, shown.radius)) continue;
      const bool is_seen = views_.along(arc.axis) != nullptr;
      if (is_seen && &arc != &shown) return count;
      if (is_seen) break;
    }
    for (const auto& group : groups)
      if (group.front()->model == shown.model && are_alike(group.front()->radius, shown.radius) &&
          views_.along(group.front()->axis) == nullptr)
        count += group.size();
    return count;
  }

  [[nodiscard]] bool has_radius(double radius, double doubt = 0) const {
    return std::any_of(dimensions_.begin(), dimensions_.end(), [&](const DimensionDescription& dimension) {
      return *dimension.type == DimensionType::radius &&
             (are_alike(dimension.circle->radius, radius) || std::abs(dimension.circle->radius - radius) <= doubt);
    });
  }

  // Those whose radius is not that of a fillet with a dimension, to which they belong.
  void add_rounds() {
    const auto equal = [](const design::DesignRound& a, const design::DesignRound& b) {
      return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
    };
    for (const auto& group : groups_of<design::DesignRound>(subject_.features.rounds, equal)) {
      const design::DesignRound& round = *group.front();
      std::optional<SeenSection> seen = seen_section(round, views_);
      if (!seen || has_radius(round.radius)) continue;
      add(DimensionType::radius, *seen->view, times(group.size()) + "<>").circle = std::move(seen->circle);
    }
  }

  // Spheres that are no corners of fillets, in the first view that shows their outline.
  void add_balls() {
    const auto equal = [&](const design::DesignBall& a, const design::DesignBall& b) {
      return a.model == b.model && are_alike(a.radius, b.radius);
    };
    for (const auto& group : groups_of<design::DesignBall>(subject_.features.balls, equal)) {
      const design::DesignBall& ball = *group.front();
      check(ball.radius > 0, "a ball has a radius");
      if (has_radius(ball.radius, ball.doubt) || is_overall(ball)) continue;
      const auto found = std::find_if(views_.all().begin(), views_.all().end(), [&](const NamedProjection* one) {
        return std::abs(glm::dot(ball.middle, one->projection.n)) < 0.5;
      });
      if (found == views_.all().end()) continue;
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
    return std::any_of(subject_.extents.begin(), subject_.extents.end(), [&](const design::Extent& extent) {
      return extent.form == design::ExtentForm::sphere && are_same(extent.size(), 2 * ball.radius);
    });
  }

  // The angle of a cone with a rounded end; diameters and positions of other ends, as far as no cylinder and no step
  // has them.
  void add_cones() {
    std::vector<design::DesignCylinder> ends;
    for (const design::DesignCone& cone : subject_.features.cones) {
      check(cone.radii[0] >= 0 && cone.radii[0] <= cone.radii[1], "a cone begins at its smaller end");
      ++groups_;
      const NamedProjection* view = views_.across(cone.axis, cone.ends[0]);
      if (view == nullptr) continue;
      const projection::Projection& projection = view->projection;
      const bool horizontal = are_parallel(projection.u, cone.axis);
      const Vec3 out = horizontal ? -projection.v : projection.u;
      const bool by_angle = has_angle(cone, glm::length(box_.size()));
      if (by_angle) {
        const NamedProjection* shown = view_of_angle(cone, subject_.features, views_);
        DimensionDescription& angle = add(DimensionType::angular, *shown, "<>");
        for (const Vec3& anchor : anchors_of_angle(cone, shown->projection)) angle.anchors.emplace_back(anchor);
      }
      for (const int end : {0, 1}) {
        if (by_angle && end == rounded_end(cone)) continue;
        const design::DesignCylinder circle{cone.model, cone.ends[end],  cone.ends[end],
                                            cone.axis,  cone.radii[end], false};
        if (!(circle.radius > 0)) continue;
        const auto is_same = [&](const design::DesignCylinder& other) {
          return are_equal_ends(other, circle) && glm::distance(other.from, circle.from) <= same_size * circle.radius;
        };
        if (!is_overall(circle) && !design::has_coaxial_outline(subject_.features, circle) &&
            std::none_of(ends.begin(), ends.end(), is_same))
          ends.push_back(circle);
        if (const int axis = world_axis(cone.axis); axis >= 0)
          stations_.add({view, axis, circle.from[axis], circle.from + circle.radius * out, -1,
                         circle.from - circle.radius * out});
      }
    }
    add_ends_of_cones(ends);
  }

  void add_ends_of_cones(const std::vector<design::DesignCylinder>& ends) {
    for (const auto& group : groups_of<design::DesignCylinder>(ends, are_equal_ends)) {
      const design::DesignCylinder& shown = *group.front();
      const NamedProjection* view = views_.across(shown.axis, shown.from);
      check(view != nullptr, "an end of a cone is measured across its axis");
      add(DimensionType::diameter, *view, times(group.size()) + "<>").circle = {
          shown.from, shown.axis, shown.radius, {}};
    }
  }

  void add_chamfers() {
    const auto equal = [](const design::DesignCone& a, const design::DesignCone& b) {
      return a.model == b.model && are_same(glm::length(a.ends[1] - a.ends[0]), glm::length(b.ends[1] - b.ends[0])) &&
             are_same(a.angle, b.angle) && are_parallel(a.axis, b.axis);
    };
    for (const auto& group : groups_of<design::DesignCone>(subject_.features.chamfers, equal)) {
      const design::DesignCone& chamfer = *group.front();
      check(chamfer.angle > 0 && chamfer.angle < 90, "a chamfer is neither a cylinder nor a plane");
      const NamedProjection* view = views_.across(chamfer.axis, chamfer.ends[0]);
      if (view == nullptr) continue;
      const projection::Projection& projection = view->projection;
      const bool horizontal = are_parallel(projection.u, chamfer.axis);
      const Vec3 out = horizontal ? -projection.v : projection.u;
      DimensionDescription& dimension =
          add(DimensionType::linear, *view, times(group.size()) + "<>×" + format_fixed(chamfer.angle, 1) + "°");
      dimension.direction = {horizontal ? DimensionDirection::horizontal : DimensionDirection::vertical, wanted_.where};
      for (const int end : {0, 1}) dimension.anchors.emplace_back(chamfer.ends[end] + chamfer.radii[end] * out);
    }
  }

  // Chamfered corners have a note; other slopes have the positions of their ends, those of the largest ones first.
  void add_bevels() {
    std::vector<design::DesignBevel> chamfers, slopes;
    for (const design::DesignBevel& bevel : subject_.features.bevels) {
      check(bevel.along >= 0 && bevel.along < 3 && bevel.area > 0, "a slope has an axis and an area");
      (bevel.is_chamfer ? chamfers : slopes).push_back(bevel);
    }
    for (const auto& group : groups_of<design::DesignBevel>(chamfers, are_equal_chamfers)) {
      const NamedProjection* view = views_.along(Mat3(1)[group.front()->along]);
      if (view == nullptr) continue;
      const auto* shown = uppermost<design::DesignBevel>(
          group, *view, [](const design::DesignBevel& one) { return (one.ends[0] + one.ends[1]) / 2.0; });
      DimensionDescription& dimension = add(DimensionType::linear, *view, times(group.size()) + "<>×45°");
      dimension.direction = {DimensionDirection::horizontal, wanted_.where};
      for (const Vec3& end : shown->ends) dimension.anchors.emplace_back(end);
      // The other ends are on the faces at the corner.
      for (const design::DesignBevel* chamfer : group)
        for (const int end : {0, 1}) stations_.know(chamfer->across[end], chamfer->ends[1 - end][chamfer->across[end]]);
    }
    std::stable_sort(slopes.begin(), slopes.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
    for (std::size_t i = 0; i < std::min(slopes.size(), most_of_a_kind); ++i) {
      const NamedProjection* view = views_.along(Mat3(1)[slopes[i].along]);
      if (view == nullptr || slopes[i].area < least_area(box_)) continue;
      for (int axis = 0; axis < 3; ++axis)
        for (const Vec3& end : slopes[i].ends)
          if (axis != slopes[i].along) stations_.add({view, axis, end[axis], end, -1, end});
    }
  }

  const DimensionDescription& wanted_;
  ViewChoice views_;
  const DimensionSubject& subject_;
  Notation notation_;
  Stations stations_;
  Box box_;
  int groups_ = 0;  ///< of equal holes, so far
  std::vector<DimensionDescription> dimensions_;
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
