// SPDX-License-Identifier: Apache-2.0
#include "sizes/drawn_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"
#include "definition/part_of_model.hpp"
#include "features/assembly_features.hpp"
#include "features/engraving.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/feature_table.hpp"
#include "sizes/place_joins.hpp"
#include "surfaces/least_squares.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using definition::Part;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

bool is_on(const WorldCircle& circle, const PartSurface& axis, double slack) {
  return features::are_parallel(axis.axis, circle.axis) &&
         std::abs(features::distance_from_line(circle.centre, axis.origin, axis.axis) - circle.radius) <= slack;
}

// Where an axis crosses the plane of a circle, as an angle.
double angle_of(const PartSurface& axis, const WorldCircle& circle) {
  const Vec3 off = axis.origin - circle.centre;
  const auto [u, v] = surfaces::square_to(circle.axis);
  return std::atan2(glm::dot(off, v), glm::dot(off, u));
}

// Whether angles divide the turn evenly; those of one axis count once.
bool are_even(std::vector<double> angles) {
  constexpr double slack = definition::drawn_parallel * 10;
  std::sort(angles.begin(), angles.end());
  std::vector<double> once;
  for (const double angle : angles)
    if (once.empty() || angle - once.back() > slack) once.push_back(angle);
  for (std::size_t i = 0; i < once.size(); ++i) {
    const double next = i + 1 < once.size() ? once[i + 1] : once[0] + full_turn;
    if (std::abs(next - once[i] - full_turn / static_cast<double>(once.size())) > slack) return false;
  }
  return once.size() > 1;
}

void add_pitch_circle(DrawnPart& drawn, const WorldCircle& circle) {
  const double slack = slack_of(drawn.part);
  std::vector<int> axes;
  std::vector<double> angles;
  for (std::size_t i = 0; i < drawn.faces; ++i) {
    const PartSurface& surface = drawn.part.faces[i].surface;
    const bool is_own = features::are_parallel(surface.axis, circle.axis) &&
                        features::distance_from_line(circle.centre, surface.origin, surface.axis) <= slack;
    if (is_own && surfaces::has_axis(surface.kind) && agree(surface.radius, circle.radius)) return;
    if (surface.kind != SurfaceKind::cylinder || !is_on(circle, surface, slack)) continue;
    axes.push_back(static_cast<int>(i));
    angles.push_back(angle_of(surface, circle));
  }
  check(axes.size() == angles.size(), "each axis on a circle has its angle");
  if (axes.size() < 2) return;
  const PartSurface line{
      .kind = SurfaceKind::cylinder, .origin = circle.centre, .axis = circle.axis, .radius = circle.radius};
  drawn.marks.circles.push_back({static_cast<int>(drawn.part.faces.size()), axes, are_even(angles)});
  drawn.part.faces.push_back({line, circle.centre});
}

// Where an axis meets another one; nothing if it passes by, or runs along it.
std::optional<Vec3> meeting_of(const PartSurface& one, const PartSurface& other, double slack) {
  if (features::are_parallel(one.axis, other.axis)) return std::nullopt;
  const Vec3 across = glm::normalize(glm::cross(one.axis, other.axis)), square = glm::cross(across, other.axis);
  if (std::abs(glm::dot(other.origin - one.origin, across)) > slack) return std::nullopt;
  return one.origin + glm::dot(other.origin - one.origin, square) / glm::dot(one.axis, square) * one.axis;
}

// Slanted ones of a note for several, which no pitch circle shows: "6× ⌀8" towards one point of an axis.
void add_even_axes(DrawnPart& drawn, const WorldCircle& circle) {
  const double slack = slack_of(drawn.part);
  std::vector<int> axes;
  for (std::size_t i = 0; i < drawn.faces; ++i)
    if (const PartSurface& one = drawn.part.faces[i].surface;
        one.kind == SurfaceKind::cylinder && agree(one.radius, circle.radius))
      axes.push_back(static_cast<int>(i));
  for (std::size_t about = 0; about < drawn.faces && axes.size() >= features::fewest_holes; ++about) {
    const PartSurface& other = drawn.part.faces[about].surface;
    if (!surfaces::has_axis(other.kind)) continue;
    const PartSurface& first = drawn.part.faces[static_cast<std::size_t>(axes.front())].surface;
    const std::optional<Vec3> centre = meeting_of(first, other, slack);
    const auto is_about = [&](int axis) {
      const PartSurface& one = drawn.part.faces[static_cast<std::size_t>(axis)].surface;
      const std::optional<Vec3> at = meeting_of(one, other, slack);
      return at && glm::distance(*at, *centre) <= slack &&
             std::abs(std::abs(glm::dot(one.axis, other.axis)) - std::abs(glm::dot(first.axis, other.axis))) <=
                 features::parallel;
    };
    const bool is_slanted = std::abs(glm::dot(first.axis, other.axis)) > features::parallel;
    if (!centre || !is_slanted || !std::ranges::all_of(axes, is_about)) continue;
    std::vector<double> angles;
    for (const int axis : axes) {
      const definition::Face& one = drawn.part.faces[static_cast<std::size_t>(axis)];
      PartSurface out = one.surface;
      out.origin = *centre + (glm::dot(one.at - *centre, out.axis) < 0 ? -out.axis : out.axis);
      angles.push_back(angle_of(out, {*centre, other.axis, circle.radius, {}, true}));
    }
    check(angles.size() == axes.size(), "each axis has its angle");
    if (are_even(angles)) drawn.marks.even_axes.push_back({static_cast<int>(about), axes});
    return;
  }
}

// Parallel planes of the model, and the plane in the middle between them.
struct Pair {
  std::array<int, 2> faces;
  Vec3 normal, at;
  double width, middle;  // from the origin, along the normal
};

// Of equal widths, those of earlier faces come first.
bool is_narrower(const Pair& a, const Pair& b) { return std::tie(a.width, a.faces) < std::tie(b.width, b.faces); }

bool are_at_60_degrees(const Vec3& a, const Vec3& b) {
  return std::abs(std::abs(glm::dot(a, b)) - 0.5) <= features::parallel;  // its cosine
}

// Planes of the model by their directions, in the order of their places along these.
class ParallelPlanes {
 public:
  explicit ParallelPlanes(const DrawnPart& drawn) : drawn_(drawn), slack_(slack_of(drawn.part)) {
    for (int face = 0; face < static_cast<int>(drawn.faces); ++face) {
      const PartSurface& one = surface(face);
      if (one.kind != SurfaceKind::plane) continue;
      const auto known = std::find_if(all_.begin(), all_.end(), [&](const Parallel& parallel) {
        return features::are_parallel(parallel.normal, one.axis);
      });
      Parallel& own = known == all_.end() ? all_.emplace_back(Parallel{one.axis, {}}) : *known;
      own.places.emplace_back(glm::dot(one.origin, own.normal), face);
    }
    for (Parallel& parallel : all_) std::sort(parallel.places.begin(), parallel.places.end());
  }

  // Of each direction that `is_wanted`, the pairs with the middle in a point, the narrowest ones first.
  template <class IsWanted>
  [[nodiscard]] std::vector<std::vector<Pair>> about(const Vec3& point, double slack, const IsWanted& is_wanted) const {
    std::vector<std::vector<Pair>> found;
    for (const Parallel& parallel : all_) {
      if (!is_wanted(parallel.normal)) continue;
      const double middle = glm::dot(point, parallel.normal);
      std::vector<Pair> pairs;
      for (const auto& [place, face] : parallel.places) {
        const double other = 2 * middle - place;
        if (place >= other) break;
        auto at = std::lower_bound(parallel.places.begin(), parallel.places.end(), std::pair(other - 2 * slack, -1));
        for (; at != parallel.places.end() && at->first <= other + 2 * slack; ++at)
          if (at->first - place > slack_) pairs.push_back(pair_of(parallel, {place, face}, *at));
      }
      std::sort(pairs.begin(), pairs.end(), is_narrower);
      if (!pairs.empty()) found.push_back(std::move(pairs));
    }
    check(found.size() <= all_.size(), "each direction has its pairs once");
    return found;
  }

  // All pairs with directions at 60 degrees to others, the narrowest ones first.
  [[nodiscard]] std::vector<Pair> at_60_degrees() const {
    std::vector<Pair> pairs;
    for (const Parallel& one : all_) {
      if (std::none_of(all_.begin(), all_.end(),
                       [&](const Parallel& other) { return are_at_60_degrees(one.normal, other.normal); }))
        continue;
      for (std::size_t i = 0; i < one.places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (one.places[i].first - one.places[j].first > slack_)
            pairs.push_back(pair_of(one, one.places[j], one.places[i]));
    }
    std::sort(pairs.begin(), pairs.end(), is_narrower);
    return pairs;
  }

 private:
  using Place = std::pair<double, int>;  // along the normal, and the face
  struct Parallel {
    Vec3 normal;
    std::vector<Place> places;
  };

  [[nodiscard]] const PartSurface& surface(int face) const {
    return drawn_.part.faces[static_cast<std::size_t>(face)].surface;
  }

  // The later face is the first of the pair, and its normal that of both.
  [[nodiscard]] Pair pair_of(const Parallel& parallel, const Place& one, const Place& other) const {
    const int first = std::max(one.second, other.second), second = std::min(one.second, other.second);
    const double sense = glm::dot(surface(first).axis, parallel.normal) < 0 ? -1 : 1;
    return {{first, second},
            surface(first).axis,
            drawn_.part.faces[static_cast<std::size_t>(first)].at,
            std::abs(one.first - other.first),
            sense * (one.first + other.first) / 2};
  }

  const DrawnPart& drawn_;
  double slack_;
  std::vector<Parallel> all_;
};

int add_middle(DrawnPart& drawn, const Pair& pair, const Vec3& at, std::vector<int> axes) {
  for (const definition::SymmetryLine& line : drawn.marks.symmetries)
    if (line.pairs.front() == pair.faces && line.axes == axes) return line.face;
  const int face = static_cast<int>(drawn.part.faces.size());
  const PartSurface middle{.kind = SurfaceKind::plane, .origin = at, .axis = pair.normal};
  drawn.marks.symmetries.push_back({face, {pair.faces}, std::move(axes)});
  drawn.part.faces.push_back({middle, at});
  check(drawn.part.faces.size() > drawn.faces, "what is only drawn follows the faces of the model");
  return face;
}

// Pairs of planes on both sides of the axis of a round part.
void add_symmetry(DrawnPart& drawn, const ParallelPlanes& planes, const features::Extent& extent) {
  const double slack = slack_of(drawn.part);
  int axis = -1;
  for (std::size_t i = 0; i < drawn.faces && axis < 0; ++i)
    if (const PartSurface& one = drawn.part.faces[i].surface;
        one.kind == SurfaceKind::cylinder && features::are_parallel(one.axis, extent.axis) &&
        features::distance_from_line(extent.centre, one.origin, one.axis) <= slack)
      axis = static_cast<int>(i);
  if (axis < 0) return;
  const auto is_beside = [&](const Vec3& normal) {
    return std::abs(glm::dot(normal, extent.axis)) <= features::parallel;
  };
  for (const std::vector<Pair>& pairs : planes.about(extent.centre, slack / 2, is_beside))
    for (const Pair& pair : pairs) add_middle(drawn, pair, extent.centre, {axis});
  check(drawn.part.faces.size() >= drawn.faces, "the faces of the model come before what is only drawn");
}

// For each face that is a cylinder, the first one about its axis; -1 for others.
std::vector<int> first_about_axis(const DrawnPart& drawn) {
  std::vector<int> first(drawn.faces, -1), known;
  for (int face = 0; face < static_cast<int>(drawn.faces); ++face) {
    const PartSurface& own = drawn.part.faces[static_cast<std::size_t>(face)].surface;
    if (own.kind != SurfaceKind::cylinder) continue;
    const auto about = std::ranges::find_if(known, [&](int one) {
      const PartSurface& axis = drawn.part.faces[static_cast<std::size_t>(one)].surface;
      return features::are_parallel(axis.axis, own.axis) &&
             features::distance_from_line(own.origin, axis.origin, axis.axis) <= slack_of(drawn.part);
    });
    first[static_cast<std::size_t>(face)] = about == known.end() ? known.emplace_back(face) : *about;
  }
  return first;
}

// Whether planes are mirror images in another one.
bool are_images(const PartSurface& one, const PartSurface& other, const PartSurface& mirror, double slack) {
  const Vec3 off = mirror.origin + glm::reflect(one.origin - mirror.origin, mirror.axis) - other.origin;
  return features::are_parallel(glm::reflect(one.axis, mirror.axis), other.axis) &&
         std::abs(glm::dot(off, other.axis)) <= slack;
}

// By plane, the axes of cylinders along it that it meets in corners, perhaps behind a fillet: the first face about
// each.
std::map<int, std::set<int>> axes_at_planes(const DrawnPart& drawn) {
  const std::vector<int> axis_of = first_about_axis(drawn);
  const auto surface = [&](int face) -> const PartSurface& {
    return drawn.part.faces[static_cast<std::size_t>(face)].surface;
  };
  std::map<int, std::set<int>> axes;
  const auto add = [&](int plane, int face) {
    const int axis = axis_of[static_cast<std::size_t>(face)];
    if (axis >= 0 && surface(plane).kind == SurfaceKind::plane &&
        std::abs(glm::dot(surface(plane).axis, surface(axis).axis)) <= features::parallel)
      axes[plane].insert(axis);
  };
  std::map<int, std::vector<int>> tangent;
  for (const definition::Contact& contact : drawn.part.contacts)
    for (const auto& [face, other] :
         {std::pair(contact.faces[0], contact.faces[1]), std::pair(contact.faces[1], contact.faces[0])}) {
      if (contact.is_tangent)
        tangent[face].push_back(other);
      else
        add(face, other);
    }
  for (const auto& [fillet, beside] : tangent)
    for (const int plane : beside)
      for (const int behind : beside)
        if (surface(fillet).kind == SurfaceKind::cylinder && behind != plane) add(plane, behind);
  check(axes.size() <= drawn.faces, "planes are faces of the model");
  return axes;
}

// Sides of an arm from boss to boss, with the line of centres in the middle.
void add_arms(DrawnPart& drawn) {
  const auto surface = [&](int face) -> const PartSurface& {
    return drawn.part.faces[static_cast<std::size_t>(face)].surface;
  };
  std::map<std::array<int, 2>, std::vector<int>> sides;  // by axes
  for (const auto& [plane, of_plane] : axes_at_planes(drawn))
    for (auto i = of_plane.begin(); i != of_plane.end(); ++i)
      for (auto j = std::next(i); j != of_plane.end(); ++j)
        if (features::are_parallel(surface(*i).axis, surface(*j).axis)) sides[{*i, *j}].push_back(plane);
  for (const auto& [ends, planes] : sides) {
    const PartSurface one = surface(ends[0]), other = surface(ends[1]);
    const PartSurface middle{.kind = SurfaceKind::plane,
                             .origin = one.origin,
                             .axis = glm::normalize(glm::cross(one.axis, other.origin - one.origin))};
    for (std::size_t i = 0; i < planes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (!are_images(surface(planes[i]), surface(planes[j]), middle, slack_of(drawn.part))) continue;
        const int face = static_cast<int>(drawn.part.faces.size());
        drawn.marks.symmetries.push_back({face, {{planes[i], planes[j]}}, {ends[0], ends[1]}});
        drawn.part.faces.push_back({middle, one.origin});
      }
  }
  check(drawn.part.faces.size() >= drawn.faces, "the faces of the model come before what is only drawn");
}

// What a dimension measures from or to is no face, corner or axis, but the middle between faces; along the own axes of
// a turned part, where rectangles have their places by their middles, also that in line with an axis.
void add_middles(DrawnPart& drawn, const ParallelPlanes& planes, const Vec3& point, const Vec3& along) {
  const double slack = slack_of(drawn.part);
  const std::vector<definition::Face>& faces = drawn.part.faces;
  const bool is_own =
      std::ranges::any_of(drawn.marks.own_axes, [&](const Vec3& own) { return features::are_parallel(own, along); });
  if (std::any_of(faces.begin(), faces.end(), [&](const definition::Face& face) {
        return (!is_own || face.surface.kind == SurfaceKind::plane) &&
               definition::has_place_along(face.surface, along) &&
               std::abs(glm::dot(point - face.surface.origin, along)) <= slack;
      }))
    return;
  std::vector<Pair> nearest;  // of each direction, the narrowest ones first
  const auto is_across = [&](const Vec3& normal) { return std::abs(glm::dot(normal, along)) > features::parallel; };
  for (const std::vector<Pair>& pairs : planes.about(point, slack, is_across)) nearest.push_back(pairs.front());
  std::sort(nearest.begin(), nearest.end(), is_narrower);
  if (nearest.empty()) return;
  const bool is_one = features::are_parallel(nearest.front().normal, along);
  nearest.resize(std::min<std::size_t>(nearest.size(), is_one ? 1 : 2));
  std::vector<int> middles;
  for (const Pair& pair : nearest) middles.push_back(add_middle(drawn, pair, point, {}));
  if (middles.size() > 1) drawn.part.contacts.push_back({{middles[0], middles[1]}, {point}});
  check(!middles.empty(), "a middle is between faces");
}

// A centre line across a direction, where no plane has it.
void add_centre_line(DrawnPart& drawn, const Vec3& at, const Vec3& across) {
  const bool is_known =
      std::any_of(drawn.part.faces.begin(), drawn.part.faces.end(), [&](const definition::Face& face) {
        return face.surface.kind == SurfaceKind::plane && features::are_parallel(face.surface.axis, across);
      });
  if (is_known) return;
  drawn.part.faces.push_back({PartSurface{.kind = SurfaceKind::plane, .origin = at, .axis = across}, at});
}

// Those from which an angle is measured.
void add_centre_lines(DrawnPart& drawn, std::span<const Vec3> points) {
  for (const Vec3& end : points.subspan(1)) {
    const Vec3 leg = glm::normalize(end - points[0]);
    if (features::axis_along(leg) < 0) continue;
    const Vec3 sight = glm::normalize(glm::cross(points[1] - points[0], points[2] - points[0]));
    for (const Vec3& across : {leg, glm::cross(sight, leg)}) add_centre_line(drawn, points[0], across);
  }
}

// Those from and along which a length is measured between places that are not in line with it, where nothing of the
// part has a direction by which it could turn: as those of one round thing beside another.
void add_centre_lines(DrawnPart& drawn, std::span<const Vec3> points, const Vec3& along, const Vec3& sight) {
  const Vec3 across = glm::cross(sight, along);
  const auto is_aside = [&](const Vec3& point) {
    return std::abs(glm::dot(point - points[0], across)) > slack_of(drawn.part);
  };
  const auto has_direction = [&](const definition::Face& face) {
    const bool any = face.surface.kind == SurfaceKind::plane || surfaces::has_axis(face.surface.kind);
    return any &&
           (features::are_parallel(face.surface.axis, along) || features::are_parallel(face.surface.axis, across));
  };
  const auto of_model = std::span(drawn.part.faces).first(drawn.faces);
  if (std::ranges::none_of(points, is_aside) || std::ranges::any_of(of_model, has_direction)) return;
  for (const Vec3& normal : {along, across}) add_centre_line(drawn, points[0], normal);
}

// Three pairs, of each the middle goes through one axis.
void add_hexagons(DrawnPart& drawn, const ParallelPlanes& planes) {
  const double slack = slack_of(drawn.part);
  const auto near = [&](const Pair& pair, const Vec3& centre, const Vec3& axis) {
    return std::all_of(pair.faces.begin(), pair.faces.end(), [&](int face) {
      return features::distance_from_line(drawn.part.faces[static_cast<std::size_t>(face)].at, centre, axis) <=
             pair.width;
    });
  };
  const std::vector<Pair> pairs = planes.at_60_degrees();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size() && pairs[j].width <= pairs[i].width + slack; ++j) {
      if (!are_at_60_degrees(pairs[i].normal, pairs[j].normal)) continue;
      const Vec3 axis = glm::normalize(glm::cross(pairs[i].normal, pairs[j].normal));
      const Vec3 centre = glm::inverse(glm::transpose(Mat3(pairs[i].normal, pairs[j].normal, axis))) *
                          Vec3(pairs[i].middle, pairs[j].middle, glm::dot(pairs[i].at, axis));
      for (std::size_t k = j + 1; k < pairs.size() && pairs[k].width <= pairs[i].width + slack; ++k) {
        if (!are_at_60_degrees(pairs[i].normal, pairs[k].normal) ||
            !are_at_60_degrees(pairs[j].normal, pairs[k].normal) ||
            std::abs(glm::dot(pairs[k].normal, axis)) > features::parallel ||
            std::abs(glm::dot(centre, pairs[k].normal) - pairs[k].middle) > slack)
          continue;
        if (!near(pairs[i], centre, axis) || !near(pairs[j], centre, axis) || !near(pairs[k], centre, axis)) continue;
        definition::Hexagon hexagon{static_cast<int>(drawn.part.faces.size()), {}};
        for (const std::size_t pair : {i, j, k})
          hexagon.sides.insert(hexagon.sides.end(), pairs[pair].faces.begin(), pairs[pair].faces.end());
        check(hexagon.sides.size() == 6, "three pairs have six sides");
        drawn.marks.hexagons.push_back(std::move(hexagon));
        const PartSurface touching{
            .kind = SurfaceKind::cylinder, .origin = centre, .axis = axis, .radius = pairs[i].width / 2};
        drawn.part.faces.push_back({touching, centre});
      }
    }
}

// Of a part that is turned about an axis of the world.
void add_own_axes(DrawnPart& drawn, std::span<const features::Extent, 3> extents) {
  std::vector<features::PlaneFeature> inclined(drawn.faces);
  std::vector<Vec3> points;
  FlatEnds flat{};
  for (const definition::Contact& contact : drawn.part.contacts) {
    points.insert(points.end(), contact.points.begin(), contact.points.end());
    for (const int face : contact.faces) {
      const PartSurface& surface = drawn.part.faces[static_cast<std::size_t>(face)].surface;
      if (surface.kind != SurfaceKind::plane) continue;
      features::PlaneFeature& plane = inclined[static_cast<std::size_t>(face)];
      plane.normal = surface.axis;
      plane.corners.insert(plane.corners.end(), contact.points.begin(), contact.points.end());
    }
  }
  check(drawn.marks.own_axes.empty(), "a part is turned once");
  const double slack = slack_of(drawn.part);
  std::erase_if(inclined, [&](const features::PlaneFeature& plane) {
    if (plane.corners.empty()) return true;
    const int axis = features::axis_along(plane.normal);
    if (axis < 0) return false;
    const auto along = static_cast<std::size_t>(axis);
    const double at = plane.corners.front()[axis];
    flat[along][0] = flat[along][0] || std::abs(at - extents[along].from) <= slack;
    flat[along][1] = flat[along][1] || std::abs(at - extents[along].to) <= slack;
    return true;
  });
  if (const auto turned = features::find_turned_part(inclined, points, flat))
    drawn.marks.own_axes.assign(turned->directions.begin(), turned->directions.end());
}

}  // namespace

double slack_of(const Part& part) { return definition::drawn_in_line * part.size; }

DrawnPart with_drawn_lines(Part part, std::span<const DimensionsInView> views,
                           std::span<const features::Extent, 3> extents) {
  const std::size_t faces = part.faces.size();
  DrawnPart drawn{std::move(part), faces, {}};
  drawn.marks.has_centre_lines = std::ranges::any_of(views, &DimensionsInView::has_centre_lines);
  const ParallelPlanes planes(drawn);
  std::vector<WorldCircle> seen;
  for (const DimensionsInView& view : views)
    for (const AnchoredDimension& dimension : view.dimensions) {
      if (dimension.type != DimensionType::diameter || dimension.circles.empty()) continue;
      const WorldCircle& circle = dimension.circles.front();
      const bool is_new = std::none_of(seen.begin(), seen.end(), [&](const WorldCircle& one) {
        return glm::distance(one.centre, circle.centre) <= slack_of(drawn.part) && agree(one.radius, circle.radius);
      });
      if (is_new) add_pitch_circle(drawn, circle);
      if (repeats_of(dimension.text) > 1) add_even_axes(drawn, circle);
      seen.push_back(circle);
    }
  for (std::size_t i = 0; i < 3; ++i)
    if (extents[i].form == features::ExtentForm::diameter &&
        std::none_of(extents.begin(), extents.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const features::Extent& one) { return one.is_same_as(extents[i]); }))
      add_symmetry(drawn, planes, extents[i]);
  add_hexagons(drawn, planes);
  add_arms(drawn);
  add_own_axes(drawn, extents);
  for (const DimensionsInView& view : views)
    for (const AnchoredDimension& dimension : view.dimensions) {
      if (dimension.type == DimensionType::angular) add_centre_lines(drawn, dimension.points);
      if (const std::optional<Vec3> along = measured_along(dimension, view)) {
        for (const Vec3& point : dimension.points) add_middles(drawn, planes, point, *along);
        if (dimension.type == DimensionType::linear)
          add_centre_lines(drawn, dimension.points, *along, view.projection.n);
      }
    }
  check(drawn.part.faces.size() >= faces + drawn.marks.circles.size() + drawn.marks.symmetries.size(),
        "each circle and plane of symmetry has a face of its own");
  return drawn;
}

std::optional<DrawnPart> part_on_sheets(std::span<const DimensionsInView> views, const world::World& world,
                                        std::span<const features::Extent, 3> extents) {
  if (features::is_assembly(world) || world.models.size() != 1) return std::nullopt;
  auto faces = definition::part_of_model(world, 0);
  if (!faces) return std::nullopt;
  const std::vector<char> letters = features::walls_of_letters(world.models[0], *world::place_part(world.models[0]));
  for (std::size_t i = 0; i < faces->faces.size(); ++i)
    if (letters[i] != 0) faces->faces[i].surface.kind = SurfaceKind::free_form;
  const std::size_t count = faces->faces.size();
  if (count > most_faces) return DrawnPart{std::move(*faces), count, {}};
  DrawnPart drawn = with_drawn_lines(std::move(*faces), views, extents);
  const definition::Directions directions = definition::find_directions(drawn.part.faces);
  drawn.part = definition::with_common_directions(std::move(drawn.part), directions);
  return drawn;
}

}  // namespace epura::sheet
