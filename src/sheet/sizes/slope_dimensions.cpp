// SPDX-License-Identifier: Apache-2.0
#include "sizes/slope_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using features::are_same;
using features::BevelFeature;
using scene::DimensionDescription;

bool are_equal_chamfers(const BevelFeature& a, const BevelFeature& b) {
  return a.model == b.model && a.along == b.along && are_same(a.leg(), b.leg());
}

// Beyond the models along an axis across the slope.
bool is_outside(const BevelFeature& slope, std::size_t end, const DimensionSubject& subject) {
  for (int axis = 0; axis < 3; ++axis) {
    const features::Extent& extent = subject.extents[static_cast<std::size_t>(axis)];
    const double at = slope.ends[end][axis], slack = features::same_size * extent.size();
    if (axis != slope.along && (at < extent.from - slack || at > extent.to + slack)) return true;
  }
  return false;
}

// Whether the neighbour at an end of a slope goes on from there along an axis.
bool goes_on(const BevelFeature& slope, std::size_t end, const Vec3& along, const world::World& world) {
  const double slack = features::same_point * glm::length(world.box.size());
  const int across = slope.across[end];
  const auto off = [&](int p) { return world.points[static_cast<std::size_t>(p)] - slope.ends[end]; };
  return std::any_of(world.triangles.begin(), world.triangles.end(), [&](const std::array<int, 3>& corners) {
    const auto any = [&](const auto& is) { return std::any_of(corners.begin(), corners.end(), is); };
    return !any([&](int p) { return std::abs(off(p)[across]) > slack; }) &&
           any([&](int p) { return std::abs(glm::dot(off(p), along)) <= slack; }) &&
           any([&](int p) { return glm::dot(off(p), along) > slack; });
  });
}

// The corner at an end, and the ends of its legs, at an acute angle: along its neighbour, or, shorter, to where an
// extension line prolongs it, and along the slope.
std::array<Vec3, 3> anchors_of_angle(const BevelFeature& slope, std::size_t end, const world::World& world) {
  check(slope.across[end] >= 0, "a slope has a neighbour that is perpendicular to an axis of the world");
  const int axis = 3 - slope.along - slope.across[end];
  const Vec3 corner = slope.ends[end], side = slope.ends[1 - end] - corner;
  const Vec3 along = (side[axis] < 0 ? -1.0 : 1.0) * Mat3(1)[axis];
  const double drawn = slope.rounded[end] || goes_on(slope, end, along, world) ? 1 : 1.0 / 16;
  return {corner, corner + drawn * glm::length(side) * along, corner + side};
}

// The same at the other end of a slope between parallel faces; nothing for others.
std::vector<Vec3> anchors_of_equal(const BevelFeature& slope, std::size_t end, const std::array<Vec3, 3>& own) {
  constexpr double drawn = 1.0 / 16;  // of the slope: prolonged by an extension line
  if (slope.across[0] != slope.across[1]) return {};
  const Vec3 corner = slope.ends[1 - end], side = slope.ends[end] - corner;
  return {corner, corner - drawn * glm::length(side) * glm::normalize(own[1] - own[0]), corner + side};
}

// Where a slope and a neighbour meet whose angle is dimensioned; nothing if positions are.
std::optional<std::size_t> corner_of_angle(const BevelFeature& slope, const DimensionSubject& subject,
                                           const std::optional<AngledEnd>& angled) {
  if (angled) return slope.across[1 - angled->end] >= 0 ? 1 - angled->end : angled->end;
  if (!has_angle(slope, subject)) return std::nullopt;
  return slope.across[0] >= 0 && (slope.across[1] < 0 || is_outside(slope, 0, subject)) ? 0 : 1;
}

// Whether the number that is written for a length is its true size, to within `slack`.
bool is_written_exactly(double length, double slack, const Notation& notation) {
  const double unit = notation.unit == Unit::mm ? 1 : scene::millimetres(notation.unit);
  const double step = unit * std::pow(10.0, -notation.decimals);
  return std::abs(length - std::nearbyint(length / step) * step) <= slack;
}

// Whether an angle is a multiple of half a degree: what nobody would have drawn by coordinates.
bool is_plain_angle(const Vec3& side, int along, double slack, const Notation& notation) {
  const double angle = portable_atan2(std::abs(side[(along + 1) % 3]), std::abs(side[(along + 2) % 3])) * degrees;
  const double plain = std::nearbyint(2 * angle) / 2;
  return std::abs(angle - plain) <= slack / glm::length(side) * degrees &&
         angle_text(angle, notation) == angle_text(plain, notation);
}

// Whether a plane face perpendicular to an axis is at a place along it.
bool has_plane_at(int axis, double at, const DimensionSubject& subject, const FeatureTable& table, double slack) {
  const auto is_there = [&](double other) { return std::abs(other - at) <= slack; };
  const auto number = static_cast<std::size_t>(axis);
  if (is_there(subject.extents[number].from)) return table.flat_ends[number][0];
  if (is_there(subject.extents[number].to)) return table.flat_ends[number][1];
  return std::any_of(subject.features.levels.begin(), subject.features.levels.end(),
                     [&](const features::LevelFeature& level) { return level.axis == axis && is_there(level.at); });
}

// With those at the flats of a hexagon that lean against the axes of the world.
std::size_t count_chamfers(const Planning& plan, const std::vector<const BevelFeature*>& group) {
  std::size_t count = group.size();
  for (const HexagonChamfer& one : plan.table.hexagon_chamfers) {
    const BevelFeature& like = plan.subject.features.bevels[static_cast<std::size_t>(one.bevel)];
    for (const BevelFeature* bevel : group)
      if (bevel->model == like.model && bevel->face == like.face) ++count;
  }
  return count;
}

Planned dimensions_of_chamfers(const Planning& plan, const std::vector<BevelFeature>& chamfers) {
  Planned planned;
  const Vec3 size = plan.box.size();
  const double least = min_radius * std::max({size.x, size.y, size.z});
  for (const auto& group : groups_of<BevelFeature>(chamfers, are_equal_chamfers)) {
    const NamedProjection* view = plan.views.along(Mat3(1)[group.front()->along]);
    if (view == nullptr || group.front()->leg() < least) continue;
    const auto* shown = uppermost<BevelFeature>(
        group, *view, [](const BevelFeature& one) { return (one.ends[0] + one.ends[1]) / 2.0; });
    DimensionDescription dimension =
        plan.dimension(DimensionType::linear, *view, times(count_chamfers(plan, group)) + "<>×45°");
    dimension.direction = {DimensionDirection::horizontal, plan.wanted.where};
    for (const Vec3& end : shown->ends) dimension.anchors.emplace_back(end);
    check(shown->leg() > 0, "a chamfer has a width");
    planned.dimensions.push_back(std::move(dimension));
    // The other ends are on the faces at the corner.
    for (const BevelFeature* chamfer : group)
      for (const int end : {0, 1})
        planned.places.emplace_back(KnownPlace{chamfer->across[end], chamfer->ends[1 - end][chamfer->across[end]]});
  }
  return planned;
}

/// The angle of a slope to the face at one of its ends, which an axis of the world is across.
struct AngleOfSlope {
  const BevelFeature* slope;
  int across;
  std::size_t corner;
  const NamedProjection* view;
};

// Equal ones have one, with their number.
std::vector<DimensionDescription> dimensions_of_angles(const std::vector<AngleOfSlope>& angles, const Planning& plan) {
  const auto have_one = [](const AngleOfSlope& a, const AngleOfSlope& b) {
    return a.across == b.across && a.view == b.view && are_equal(*a.slope, *b.slope);
  };
  std::vector<DimensionDescription> dimensions;
  for (const auto& group : groups_of<AngleOfSlope>(angles, have_one)) {
    const AngleOfSlope& shown = *group.front();
    dimensions.push_back(plan.dimension(DimensionType::angular, *shown.view, times(group.size()) + "<>"));
    const std::array<Vec3, 3> anchors = anchors_of_angle(*shown.slope, shown.corner, plan.subject.world);
    dimensions.back().anchors.assign(anchors.begin(), anchors.end());
    dimensions.back().opposite = anchors_of_equal(*shown.slope, shown.corner, anchors);
    check(dimensions.back().anchors.size() == 3, "an angle has a corner and two legs");
  }
  return dimensions;
}

}  // namespace

bool has_angle(const BevelFeature& slope, const DimensionSubject& subject) {
  return is_outside(slope, 0, subject) || is_outside(slope, 1, subject);
}

std::optional<AngledEnd> angled_end(const BevelFeature& slope, const DimensionSubject& subject,
                                    const FeatureTable& table, const Notation& notation) {
  const double slack = features::same_point * glm::length(subject.world.box.size());
  if (slope.is_chamfer || has_angle(slope, subject) ||
      !is_plain_angle(slope.ends[1] - slope.ends[0], slope.along, slack, notation))
    return std::nullopt;
  for (const std::size_t end : {0U, 1U}) {
    if (slope.across[end] < 0) continue;
    const int axis = 3 - slope.along - slope.across[end];
    const features::Extent& extent = subject.extents[static_cast<std::size_t>(axis)];
    const double from = slope.ends[end][axis] - extent.from, to = extent.to - slope.ends[end][axis];
    const auto is_exact = [&](double length) { return is_written_exactly(length, slack, notation); };
    const bool ends_models = std::min(std::abs(from), std::abs(to)) <= slack;
    if (ends_models ? is_exact(extent.size()) : is_exact(from) || is_exact(to)) continue;
    if (!has_plane_at(axis, slope.ends[end][axis], subject, table, slack)) return AngledEnd{end, axis};
  }
  return std::nullopt;
}

bool is_over_slope(const Planning& plan, int axis) {
  const features::Extent& extent = plan.extent(axis);
  const double slack = features::same_size * extent.size();
  const std::vector<BevelFeature>& bevels = plan.subject.features.bevels;
  return std::any_of(bevels.begin(), bevels.end(), [&](const BevelFeature& slope) {
    const auto angled = angled_end(slope, plan.subject, plan.table, plan.notation);
    if (!angled || angled->axis != axis || plan.views.along(Mat3(1)[slope.along]) == nullptr) return false;
    const double at = slope.ends[angled->end][axis];
    return slope.area >= min_area(plan.box) &&
           (std::abs(at - extent.from) <= slack || std::abs(at - extent.to) <= slack);
  });
}

bool is_angle_of(const AnchoredDimension& dimension, const BevelFeature& slope) {
  if (dimension.type != DimensionType::angular) return false;
  check(dimension.points.size() == 3, "an angle has a corner and two legs");
  const Vec3 side = slope.ends[1] - slope.ends[0], corner = dimension.points[0];
  const double off = glm::dot(corner - slope.ends[0], slope.normal);
  if (std::abs(off) > 10 * features::same_size * glm::length(side)) return false;
  const std::array<Vec3, 2> legs{glm::normalize(dimension.points[1] - corner),
                                 glm::normalize(dimension.points[2] - corner)};
  for (const std::size_t leg : {0U, 1U})
    if (features::are_parallel(legs[leg], glm::normalize(side)) && features::axis_along(legs[1 - leg]) >= 0)
      return true;
  return false;
}

bool are_equal(const BevelFeature& a, const BevelFeature& b) {
  return a.model == b.model && a.along == b.along && features::are_parallel(glm::abs(a.normal), glm::abs(b.normal));
}

bool gives_angle(const AnchoredDimension& dimension, const BevelFeature& slope, const std::vector<BevelFeature>& all) {
  return is_angle_of(dimension, slope) ||
         (repeats_of(dimension.text) > 1 && std::any_of(all.begin(), all.end(), [&](const BevelFeature& other) {
            return are_equal(other, slope) && is_angle_of(dimension, other);
          }));
}

Planned slope_dimensions(const Planning& plan) {
  std::vector<BevelFeature> chamfers, slopes;
  for (const BevelFeature& bevel : plan.subject.features.bevels) {
    check(bevel.along >= 0 && bevel.along < 3 && bevel.area > 0, "a slope has an axis and an area");
    (bevel.is_chamfer ? chamfers : slopes).push_back(bevel);
  }
  Planned planned = dimensions_of_chamfers(plan, chamfers);
  std::stable_sort(slopes.begin(), slopes.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
  std::size_t shown = 0;
  std::vector<AngleOfSlope> angles;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const NamedProjection* view = plan.views.along(Mat3(1)[slopes[i].along]);
    if (view == nullptr || slopes[i].area < min_area(plan.box)) continue;
    if (++shown > max_of_a_kind) {
      ++planned.omitted.too_many[view->name];
      continue;
    }
    const auto angled = angled_end(slopes[i], plan.subject, plan.table, plan.notation);
    if (const auto corner = corner_of_angle(slopes[i], plan.subject, angled)) {
      angles.push_back({&slopes[i], slopes[i].across[*corner], *corner, view});
      if (!angled) continue;  // the angle stands for both ends
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const std::size_t end : {0U, 1U})
        if (const Vec3& at = slopes[i].ends[end];
            axis != slopes[i].along && !(angled && angled->end == end && angled->axis == axis))
          planned.places.emplace_back(Coordinate{view, axis, at[axis], at, -1, at});
  }
  planned.append({dimensions_of_angles(angles, plan)});
  return planned;
}

namespace {

using features::are_parallel;

// Corners of a step where a view shows them, without those that a section has removed.
std::vector<Vec3> points_shown(const features::LevelFeature& level, const NamedProjection& view) {
  std::vector<Vec3> points;
  for (const Vec3& point : level.points)
    if (const auto shown = shown_point(view, point); shown && (view.aligned() || keeps(view, point)))
      points.push_back(*shown);
  return points;
}

// Of views that do not hide a step, if there are any, the one in which it is nearest to the viewer, so that little can
// hide it; the first one of several. Otherwise the first aligned section that shows it.
const NamedProjection* view_of_level(const features::LevelFeature& level, const ViewChoice& views,
                                     const std::vector<Vec3>& all_points, double slack) {
  check(level.axis >= 0 && level.axis < 3 && !level.points.empty(), "a step has an axis and corners");
  const Vec3 axis = Mat3(1)[level.axis];
  const NamedProjection* best = nullptr;
  double least = HUGE_VAL;
  bool is_best_hidden = true;
  for (const NamedProjection* view : views.all()) {
    const projection::Projection& projection = view->projection;
    if (!are_parallel(projection.u, axis) && !are_parallel(projection.v, axis)) continue;
    if (points_shown(level, *view).empty()) continue;
    const auto depth = [&](const Vec3& p) { return glm::dot(p, projection.n); };
    double front = -HUGE_VAL, nearest = -HUGE_VAL;
    for (const Vec3& p : all_points) front = std::max(front, depth(p));
    for (const Vec3& p : level.points) nearest = std::max(nearest, depth(p));
    const bool is_hidden = view->shows && std::ranges::none_of(level.points, view->shows);
    const double behind = front - nearest;
    if (best != nullptr && (is_hidden != is_best_hidden ? is_hidden : behind >= least - slack)) continue;
    best = view;
    least = behind;
    is_best_hidden = is_hidden;
  }
  if (best != nullptr) return best;
  for (const NamedProjection* view : views.aligned())
    if (keeps_positions(*view, level.axis) && !points_shown(level, *view).empty()) return view;
  return nullptr;
}

}  // namespace

std::optional<Coordinate> coordinate_of(const features::LevelFeature& level, const ViewChoice& views,
                                        const std::vector<Vec3>& all_points, double slack) {
  const NamedProjection* view = view_of_level(level, views, all_points, slack);
  if (view == nullptr) return std::nullopt;
  const bool horizontal = std::abs(view->projection.u[level.axis]) > 0.5;
  const Vec3 towards = horizontal ? -view->projection.v : view->projection.u;
  const std::vector<Vec3> points = points_shown(level, *view);
  const auto [high, low] = std::minmax_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
    return glm::dot(a, towards) < glm::dot(b, towards);
  });
  return Coordinate{view, level.axis, level.at, *low, -1, *high, level.other_side, level.partner};
}

double min_area(const Box& box) {
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z}), least = std::min({size.x, size.y, size.z});
  return min_level * largest * (size.x + size.y + size.z - largest - least);
}

Planned level_positions(const DimensionSubject& subject, const ViewChoice& views, const Coordinates& known) {
  const Box box = features::box_of_faces(subject.world);
  const std::vector<Vec3> all_points = features::points_of_faces(subject.world);
  const double slack = features::same_size * glm::length(box.size());
  std::map<std::pair<std::string, int>, std::vector<std::pair<double, Coordinate>>> by_view;
  for (const features::LevelFeature& level : subject.features.levels)
    if (!known.is_known(level.axis, level.at) && level.area >= min_area(box))
      if (const auto coordinate = coordinate_of(level, views, all_points, slack))
        by_view[{coordinate->view->name, level.axis}].emplace_back(-level.area, *coordinate);
  Planned planned;
  for (auto& [key, levels] : by_view) {
    check(!levels.empty(), "a view has the steps for which it was chosen");
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < std::min(levels.size(), max_levels); ++i) planned.places.emplace_back(levels[i].second);
    if (levels.size() > max_levels) planned.omitted.too_many[key.first] += levels.size() - max_levels;
  }
  return planned;
}

}  // namespace epura::sheet
