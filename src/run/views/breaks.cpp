// SPDX-License-Identifier: Apache-2.0
#include "views/breaks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/arrangement.hpp"
#include "sizes/anchors.hpp"
#include "view/paper_map.hpp"

namespace epura::pipeline {

namespace {

using drawing::Breaks;
using drawing::LeftOut;

constexpr double surely_parallel = 1e-9;
// Normals of thin triangles have rounding errors.
constexpr double along_axis = 1e-4;
// `auto`, in widths of the view: length of the shortest stretch, and what remains of it on either side.
constexpr double shortest_stretch = 3, kept = 1;

std::string axis_name(int axis) { return std::string(1, "xyz"[axis]); }

/// A view as a map of the world to its plane.
struct Plane {
  const view::ProjectedScene& seen;
  const world::World& world;
  Mat4 map = view::world_to_page(seen, view::make_paper_map(seen, 1, Vec2(0)));
  projection::Window drawn = view::drawn_box(seen);

  [[nodiscard]] Vec2 image(const Vec3& point) const {
    const Vec4 p = map * Vec4(point, 1);
    return Vec2(p) / p.w;
  }
  [[nodiscard]] bool is_pictorial() const { return sheet::view_place(seen.projection) == sheet::ViewPlace::pictorial; }
  /// The axis of the page along which an axis of the world is seen in true length; -1 if there is none.
  [[nodiscard]] int page_axis(int axis) const {
    if (std::abs(std::abs(seen.projection.u[axis]) - 1) <= surely_parallel) return 0;
    return std::abs(std::abs(seen.projection.v[axis]) - 1) <= surely_parallel ? 1 : -1;
  }
  /// The strip between two planes perpendicular to an axis of the world. Ends outside the view become infinite.
  [[nodiscard]] LeftOut strip(int axis, double from, double to) const {
    const int along = page_axis(axis);
    const auto at = [&](double place) {
      if (std::isinf(place)) return (along == 0 ? seen.projection.u : seen.projection.v)[axis] * place;
      Vec3 point = world.box.centre();
      point[axis] = place;
      return image(point)[along];
    };
    LeftOut strip{std::min(at(from), at(to)), std::max(at(from), at(to))};
    if (strip.from <= drawn.min[along]) strip.from = -HUGE_VAL;
    if (strip.to >= drawn.max[along]) strip.to = HUGE_VAL;
    return strip;
  }
};

void add_strip(Breaks& breaks, const Plane& plane, const scene::BreakChoice::Part& part, const std::string& where) {
  const int along = plane.page_axis(part.axis);
  if (along < 0)
    refuse_input(where, "the view shows the " + axis_name(part.axis) + " axis neither horizontally nor vertically",
                 "give places on an axis that it does, or choose another projection");
  const LeftOut strip = plane.strip(part.axis, part.from, part.to);
  const std::string extent = "the models extend from " + format_rounded(plane.world.box.min[part.axis], 6) + " to " +
                             format_rounded(plane.world.box.max[part.axis], 6) + " along " + axis_name(part.axis);
  if (strip.from >= plane.drawn.max[along] || strip.to <= plane.drawn.min[along])
    refuse_input(where, "the break leaves nothing out", extent);
  if (std::isinf(strip.from) && std::isinf(strip.to)) refuse_input(where, "the break leaves everything out", extent);
  breaks.along[std::size_t(along)].push_back(strip);
}

// Stretches along an axis of the world in which all faces are parallel to it: their section is constant.
std::vector<std::array<double, 2>> constant_stretches(const world::World& world, int axis) {
  std::vector<std::array<double, 2>> events;
  for (const auto& triangle : world.triangles) {
    const Vec3 &a = world.points[triangle[0]], &b = world.points[triangle[1]], &c = world.points[triangle[2]];
    const Vec3 normal = glm::cross(b - a, c - a);
    if (std::abs(normal[axis]) > along_axis * glm::length(normal))
      events.push_back({std::min({a[axis], b[axis], c[axis]}), std::max({a[axis], b[axis], c[axis]})});
  }
  std::sort(events.begin(), events.end());
  std::vector<std::array<double, 2>> stretches;
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (events[i][0] > events[i - 1][1]) stretches.push_back({events[i - 1][1], events[i][0]});
    events[i][1] = std::max(events[i][1], events[i - 1][1]);
  }
  return stretches;
}

Breaks automatic_breaks(const Plane& plane) {
  Breaks breaks;
  const Vec2 size = plane.drawn.max - plane.drawn.min;
  const std::size_t along = size.x >= size.y ? 0 : 1;
  const double width = size[static_cast<int>(1 - along)];
  for (int axis = 0; axis < 3; ++axis) {
    if (plane.page_axis(axis) != static_cast<int>(along)) continue;
    for (const auto& [from, to] : constant_stretches(plane.world, axis))
      if (to - from > shortest_stretch * width)
        breaks.along[along].push_back(plane.strip(axis, from + kept * width, to - kept * width));
  }
  return breaks;
}

// Which side is left out along an axis of the page: 1 the upper or right one, -1 the other, 0 none.
int left_out_side(HalfView half, int axis) {
  const std::string_view word = scene::word_of(half);
  const auto has = [&](const char* part) { return word.find(part) != std::string_view::npos; };
  return axis == 0 ? (has("left") ? 1 : has("right") ? -1 : 0) : (has("bottom") ? 1 : has("top") ? -1 : 0);
}

void add_half(Breaks& breaks, const Plane& plane, HalfView half) {
  for (const int axis : {0, 1}) {
    const double middle = (plane.drawn.min[axis] + plane.drawn.max[axis]) / 2;
    std::vector<LeftOut>& strips = breaks.along[static_cast<std::size_t>(axis)];
    if (const int side = left_out_side(half, axis); side > 0)
      strips.push_back({middle, HUGE_VAL, true});
    else if (side < 0)
      strips.push_back({-HUGE_VAL, middle, true});
  }
}

// Sorts the strips, and joins those that overlap.
void put_in_order(std::vector<LeftOut>& strips) {
  std::sort(strips.begin(), strips.end(), [](const LeftOut& a, const LeftOut& b) { return a.from < b.from; });
  std::vector<LeftOut> joined;
  for (const LeftOut& strip : strips) {
    if (joined.empty() || strip.from > joined.back().to)
      joined.push_back(strip);
    else
      joined.back().to = std::max(joined.back().to, strip.to);
  }
  strips = std::move(joined);
}

Vec3 point_of(const scene::Anchor& anchor, const world::World& world) {
  const auto* vertex = std::get_if<std::array<int, 2>>(&anchor);
  if (vertex == nullptr) return std::get<Vec3>(anchor);
  return world.points[static_cast<std::size_t>(world.first_vertex[(*vertex)[0]] + (*vertex)[1])];
}

// Freehand lines do not meet.
void expect_one_axis(const Breaks& breaks, const scene::ViewDescription& view) {
  const auto is_broken = [](const std::vector<LeftOut>& strips) {
    return std::any_of(strips.begin(), strips.end(), [](const LeftOut& strip) { return !strip.symmetric; });
  };
  if (is_broken(breaks.along[0]) && is_broken(breaks.along[1]))
    refuse_input(view.break_line.where,
                 "view '" + *view.name + "' is broken in two directions, where freehand lines would meet",
                 "omit 'break_line', or breaks along one axis of the view");
}

Breaks breaks_of(const scene::ViewDescription& view, const Plane& plane) {
  Breaks breaks;
  if (view.breaks.given()) {
    const scene::BreakChoice& choice = *view.breaks;
    if (plane.is_pictorial()) {
      if (choice.is_optional) return breaks;
      refuse_input(view.breaks.where, "view '" + *view.name + "' is pictorial, and only orthographic views are broken",
                   "omit 'break', or choose a view along an axis");
    }
    if (choice.automatic) breaks = automatic_breaks(plane);
    for (const scene::BreakChoice::Part& part : choice.parts)
      if (!choice.is_optional || plane.page_axis(part.axis) >= 0) add_strip(breaks, plane, part, view.breaks.where);
  }
  if (view.half.given()) {
    if (plane.is_pictorial())
      refuse_input(view.half.where,
                   "view '" + *view.name + "' is pictorial, and only orthographic views are drawn by halves",
                   "omit 'half', or choose a view along an axis");
    add_half(breaks, plane, *view.half);
  }
  for (std::vector<LeftOut>& strips : breaks.along) put_in_order(strips);
  if (view.break_line.value_or(BreakLine::zigzag) == BreakLine::freehand) expect_one_axis(breaks, view);
  breaks.freehand = view.break_line.value_or(BreakLine::zigzag) == BreakLine::freehand;
  return breaks;
}

}  // namespace

Breaks find_breaks(const scene::ViewDescription& view, const view::ProjectedScene& seen, const world::World& world) {
  if (view.detail.given() || !(view.breaks.given() || view.half.given())) return {};
  return breaks_of(view, Plane{seen, world});
}

void find_breaks(SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                 const std::function<const world::World&(std::size_t)>& world) {
  for (std::size_t i = 0; i < seen.size(); ++i)
    sheet.plans[i].options.breaks = find_breaks(sheet.descriptions[i], seen[i], world(i));
}

bool is_left_out(const scene::DimensionDescription& dimension, const world::World& world, const Breaks& breaks,
                 const view::ProjectedScene& seen) {
  if (!breaks.any()) return false;
  const Plane plane{seen, world};
  const auto is_out = [&](const Vec3& point) { return !breaks.keeps(plane.image(point)); };
  if (dimension.type.value == DimensionType::overall && dimension.direction.given()) {
    const int axis = plane.page_axis(sheet::axis_of(*dimension.direction));
    return axis >= 0 && std::any_of(breaks.along[axis].begin(), breaks.along[axis].end(),
                                    [](const LeftOut& strip) { return !strip.is_between() && !strip.symmetric; });
  }
  if (dimension.circle) return is_out(dimension.circle->centre);
  std::vector<Vec2> ends;
  for (const scene::Anchor& anchor : dimension.anchors) ends.push_back(plane.image(point_of(anchor, world)));
  const double slack = 1e-3 * glm::length(plane.drawn.max - plane.drawn.min);
  for (const int axis : {0, 1})
    if (ends.size() == 2 && breaks.are_mirrored(ends[0], ends[1], axis, slack)) return false;
  return std::any_of(ends.begin(), ends.end(), [&](const Vec2& end) { return !breaks.keeps(end); });
}

}  // namespace epura::pipeline
