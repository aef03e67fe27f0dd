// SPDX-License-Identifier: Apache-2.0
#include "composition/stated_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "composition/requirement_words.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "surfaces/limits.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementBounds;
using surfaces::PartFace;
using surfaces::SurfaceKind;

bool has_word(const std::string& text, std::string_view word) { return text.find(word) != std::string::npos; }

const PartFace& face_of(const RequirementSubject& subject, int face) {
  return subject.part.faces[static_cast<std::size_t>(face)];
}

std::vector<Vec3> points_of(const RequirementSubject& subject, const std::vector<int>& faces) {
  std::vector<std::size_t> triangles;
  for (const int face : faces) {
    const std::vector<std::size_t>& more = subject.triangles[static_cast<std::size_t>(face)];
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  std::sort(triangles.begin(), triangles.end());
  std::vector<Vec3> points;
  for (const std::size_t t : triangles)
    for (const int vertex : subject.world.triangles[t])
      points.push_back(subject.world.points[static_cast<std::size_t>(vertex)]);
  return points;
}

std::vector<SeenMark> marks_in(const FaceView& view, const RequirementSubject& subject, const std::vector<int>& faces) {
  std::vector<SeenMark> marks;
  for (const int face : faces) {
    const std::vector<SeenMark> more = view.marks_on({subject.model, face}, face_of(subject, face));
    marks.insert(marks.end(), more.begin(), more.end());
  }
  return marks;
}

// 2: a view shows lines of the faces, 1: it shows the faces, 0: it does not.
int rank_of(const std::vector<SeenMark>& marks) {
  const bool has_line = std::any_of(marks.begin(), marks.end(), [](const SeenMark& mark) { return mark.on_line; });
  return has_line ? 2 : marks.empty() ? 0 : 1;
}

// Whether a requirement may be about what the model measures, mm or degrees: where the file has no value, it is.
bool agrees(double measured, const ModelRequirement& one) {
  constexpr double relative = 1e-6;
  const double half_digit = one.decimals < 0 ? 0 : 0.5 * std::pow(10.0, -one.decimals) * written_unit(one);
  const double slack = half_digit + relative * std::abs(measured);
  if (std::isfinite(one.value)) {
    if (std::abs(measured - one.value) <= slack) return true;
    if (one.bounds == RequirementBounds::deviations)
      return measured >= one.value + one.lower - slack && measured <= one.value + one.upper + slack;
  }
  if (one.bounds == RequirementBounds::limits) return measured >= one.lower - slack && measured <= one.upper + slack;
  return !std::isfinite(one.value);
}

StatedDimension refusal(std::string why) { return {{}, std::move(why)}; }

StatedDimension disagreement(double measured, const ModelRequirement& one) {
  constexpr int digits = 6;
  return refusal("the model measures " + format_rounded(measured / written_unit(one), digits) +
                 (one.is_angle ? "°" : "") + " at its faces");
}

StatedDimension written(scene::DimensionDescription dimension, const ModelRequirement& one,
                        const RequirementSubject& subject, bool is_straight) {
  const std::string before = dimension.text.value_or("");
  if (const std::string why = write_value(dimension, one, subject.manner); !why.empty()) return refusal(why);
  dimension.text.value = before + *dimension.text;
  return {std::move(dimension), "", is_straight};
}

// What has no dimension line stands at a leader: "R5 ±0.1". `measured` is the value if the file gives none.
StatedDimension beside(scene::DimensionDescription dimension, const std::string& sign, const ModelRequirement& one,
                       const RequirementSubject& subject, std::optional<double> measured) {
  if (const std::string why = write_value(dimension, one, subject.manner); !why.empty()) return refusal(why);
  if (!dimension.stated && !measured) return refusal("the file gives it no value");
  StatedDimension stated;
  stated.beside = value_note(dimension, sign, one, subject.manner, measured.value_or(0));
  return stated;
}

// Circles.

/// A circle of a face about its axis, or of a sphere.
struct FaceCircle {
  double along, radius;
};

// Where a face begins and ends; those of tori are the widest and the narrowest.
std::vector<FaceCircle> circles_of(const PartFace& face) {
  const surfaces::PartSurface& surface = face.surface;
  const auto at = [&](double along) { return FaceCircle{along, surface.radius + surface.slope * along}; };
  if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::cone) return {at(face.from), at(face.to)};
  if (surface.kind == SurfaceKind::sphere) return {{0, surface.radius}};
  const double slack = surfaces::same_surface * surface.minor;
  if (surface.kind != SurfaceKind::torus || face.from > slack || face.to < -slack) return {};
  return {{0, surface.radius + surface.minor}, {0, surface.radius - surface.minor}};
}

// The circle of the required size that is farthest from the middle of the model.
std::optional<FaceCircle> required_circle(const PartFace& face, const ModelRequirement& one,
                                          const RequirementSubject& subject, double radii) {
  const Vec3 middle = (subject.world.box.min + subject.world.box.max) / 2.0;
  std::optional<FaceCircle> found;
  double farthest = -1;
  for (const FaceCircle& circle : circles_of(face)) {
    const double off = glm::length(face.surface.origin + circle.along * face.surface.axis - middle);
    if (!(circle.radius > 0) || !agrees(radii * circle.radius, one) || off <= farthest) continue;
    farthest = off;
    found = circle;
  }
  return found;
}

/// A view of a round face, and how it is seen.
struct CircleView {
  const FaceView* view = nullptr;
  std::size_t place = 0;
  bool across = false;
};

// Bores in views along their axes if possible, shafts in views across them.
CircleView view_of_circle(const std::vector<std::vector<int>>& places, const RequirementSubject& subject,
                          bool is_radius) {
  CircleView best;
  int most = 0;
  for (const FaceView& view : subject.views)
    for (std::size_t i = 0; i < places.size(); ++i) {
      const PartFace& face = face_of(subject, places[i].front());
      const bool is_ball = face.surface.kind == SurfaceKind::sphere;
      const double along = std::abs(glm::dot(face.surface.axis, view.projection().n));
      const bool across = !is_ball && along <= max_tilt;
      if (!is_ball && !across && along < 1 - max_tilt * max_tilt) continue;
      if (across && (is_radius || face.sweep < surfaces::whole_turn)) continue;
      const int seen = rank_of(marks_in(view, subject, places[i]));
      const int rank = seen == 0 ? 0 : 2 * seen + (across == !face.inwards ? 3 : 0);
      if (rank <= most) continue;
      most = rank;
      best = {&view, i, across};
    }
  return best;
}

StatedDimension state_circle(scene::DimensionDescription dimension, const ModelRequirement& one,
                             const RequirementSubject& subject) {
  const bool is_radius = has_word(one.type, "radius");
  const double radii = is_radius ? 1 : 2;
  const std::string sign = is_radius ? "R" : "⌀";
  const auto places = face_places(one.faces, subject.part);
  for (const int number : one.faces) {
    const PartFace& face = face_of(subject, number);
    if (face.surface.kind == SurfaceKind::plane) return refusal("there is no rule for the " + one.type + " of a plane");
    if (face.surface.kind == SurfaceKind::free_form)
      return beside(std::move(dimension), sheet::times(places.size()) + sign, one, subject, std::nullopt);
    if (face.surface.kind == SurfaceKind::torus && agrees(radii * face.surface.minor, one))
      return beside(std::move(dimension), sheet::times(places.size()) + sign, one, subject, radii * face.surface.minor);
    if (required_circle(face, one, subject, radii)) continue;
    std::vector<FaceCircle> circles = circles_of(face);
    if (circles.empty()) circles.push_back({0, face.surface.minor});
    const auto off = [&](const FaceCircle& circle) { return std::abs(radii * circle.radius - one.value); };
    const auto nearest =
        std::min_element(circles.begin(), circles.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
    return disagreement(radii * nearest->radius, one);
  }
  const CircleView seen = view_of_circle(places, subject, is_radius);
  if (seen.view == nullptr) return refusal(not_seen);
  const std::vector<int>& faces = places[seen.place];
  const PartFace& face = face_of(subject, faces.front());
  const bool is_ball = face.surface.kind == SurfaceKind::sphere;
  dimension.view = {seen.view->name(), dimension.where};
  dimension.type = {is_radius ? DimensionType::radius : DimensionType::diameter, dimension.where};
  const FaceCircle circle = *required_circle(face, one, subject, radii);
  if (is_ball)
    dimension.circle = scene::FeatureCircle{face.surface.origin, seen.view->projection().n, face.surface.radius};
  else
    dimension.circle =
        scene::FeatureCircle{face.surface.origin + circle.along * face.surface.axis, face.surface.axis, circle.radius,
                             arc_of(face, points_of(subject, faces), circle.along, circle.radius)};
  dimension.text = {sheet::times(places.size()) + (is_ball ? "S" : ""), dimension.where};
  return written(std::move(dimension), one, subject, seen.across);
}

// Lengths.

/// What a length may be measured from: a plane, an axis, or the centre of a sphere.
struct LengthEnd {
  bool is_plane;
  Vec3 point, direction;  ///< normal or axis; length 1; of a centre zero
  std::vector<Vec3> points;
};

std::optional<LengthEnd> end_of(const std::vector<int>& faces, const RequirementSubject& subject) {
  const PartFace& face = face_of(subject, faces.front());
  const surfaces::PartSurface& surface = face.surface;
  if (surface.kind == SurfaceKind::plane)
    return LengthEnd{true, surface.origin, surface.axis, points_of(subject, faces)};
  if (surface.kind == SurfaceKind::sphere) return LengthEnd{false, surface.origin, Vec3(0), {surface.origin}};
  if (!surfaces::has_axis(surface.kind)) return std::nullopt;
  const Vec3 from = surface.origin + face.from * surface.axis, to = surface.origin + face.to * surface.axis;
  return LengthEnd{false, from, surface.axis, {from, to}};
}

// The direction in which two ends have the required distance; zero if there is none.
Vec3 direction_between(const LengthEnd& a, const LengthEnd& b, const ModelRequirement& one) {
  const auto is_parallel = [](const Vec3& x, const Vec3& y) { return features::are_parallel(x, y); };
  std::vector<Vec3> directions;
  if (a.is_plane || b.is_plane) {
    const Vec3& normal = a.is_plane ? a.direction : b.direction;
    const LengthEnd& other = a.is_plane ? b : a;
    const bool fits = other.is_plane ? is_parallel(normal, other.direction)
                                     : std::abs(glm::dot(normal, other.direction)) <= features::parallel;
    if (fits) directions.push_back(normal);
  } else if (const Vec3& along = a.direction == Vec3(0) ? b.direction : a.direction;
             along == Vec3(0) || b.direction == Vec3(0) || is_parallel(along, b.direction)) {
    Vec3 off = b.point - a.point;
    off -= glm::dot(off, along) * along;
    if (glm::length(off) > 0) directions.push_back(glm::normalize(off));
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(glm::dot(Mat3(1)[axis], along)) <= features::parallel) directions.push_back(Mat3(1)[axis]);
  }
  for (const Vec3& direction : directions)
    if (agrees(std::abs(glm::dot(b.point - a.point, direction)), one)) return direction;
  return Vec3(0);
}

// The point of an end that is farthest in a direction.
Vec3 farthest(const LengthEnd& end, const Vec3& direction) {
  return *std::max_element(end.points.begin(), end.points.end(), [&](const Vec3& a, const Vec3& b) {
    return glm::dot(a, direction) < glm::dot(b, direction);
  });
}

void anchor_length(scene::DimensionDescription& dimension, const std::array<LengthEnd, 2>& ends, const Vec3& direction,
                   const projection::Projection& seen) {
  const bool horizontal = features::are_parallel(direction, seen.u),
             vertical = features::are_parallel(direction, seen.v);
  const Vec3 side = horizontal ? -seen.v : vertical ? seen.u : glm::normalize(glm::cross(seen.n, direction));
  const std::array<Vec3, 2> points{farthest(ends[0], side), farthest(ends[1], side)};
  if (!horizontal && !vertical) {
    const Vec3 along = glm::dot(points[1] - points[0], direction) * direction;
    dimension.type = {DimensionType::aligned, dimension.where};
    dimension.anchors = {points[0], points[0] + along};
    return;
  }
  dimension.type = {DimensionType::linear, dimension.where};
  dimension.direction = {horizontal ? DimensionDirection::horizontal : DimensionDirection::vertical, dimension.where};
  dimension.anchors = {points[0], points[1]};
  dimension.opposite = {farthest(ends[0], -side), farthest(ends[1], -side)};
}

/// Ends, and the direction in which they have their distance; zero if there is none.
using DirectedEnds = std::pair<std::array<LengthEnd, 2>, Vec3>;

// Of two lines, of which one stands upright on the other: the foot, and the far end of the upright one. If both stand
// on an end of the other, the one that is as long as required.
std::optional<DirectedEnds> upright_on(const std::array<LengthEnd, 2>& lines, const ModelRequirement& one) {
  if (std::abs(glm::dot(lines[0].direction, lines[1].direction)) > features::parallel) return std::nullopt;
  std::optional<DirectedEnds> found;
  for (std::size_t upright = 0; upright < lines.size(); ++upright) {
    const LengthEnd &foot = lines[1 - upright], &leg = lines[upright];
    const double length = glm::length(leg.points[1] - leg.points[0]);
    for (std::size_t k = 0; k < leg.points.size(); ++k) {
      const double off = features::distance_from_line(leg.points[k], foot.point, foot.direction);
      if (!features::are_same(length, length + off) || !agrees(length, one)) continue;
      if (found) return std::nullopt;
      const Vec3& end = leg.points[1 - k];
      found = {{foot, {false, end, leg.direction, {end}}}, leg.direction};
    }
  }
  return found;
}

// Straight lines on faces, and the direction of their distance; of one line alone, its ends and its own direction.
std::optional<DirectedEnds> lines_of(const ModelRequirement& one, const RequirementSubject& subject) {
  const auto at = [&](const std::array<double, 6>& line, std::size_t from) {
    return subject.placed({line[from], line[from + 1], line[from + 2]});
  };
  std::array<LengthEnd, 2> ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vec3 from = at(one.lines[i], 0), to = at(one.lines[i], 3);
    if (!(glm::length(to - from) > 0)) return std::nullopt;
    ends[i] = {false, from, glm::normalize(to - from), {from, to}};
  }
  if (one.lines[0] == one.lines[1]) {
    const std::vector<Vec3> both = ends[0].points;
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = {false, both[i], ends[i].direction, {both[i]}};
    return std::pair(ends, ends[0].direction);
  }
  if (auto upright = upright_on(ends, one)) return upright;
  return std::pair(ends, direction_between(ends[0], ends[1], one));
}

// In a view that shows their faces true.
StatedDimension state_between_lines(scene::DimensionDescription dimension, const ModelRequirement& one,
                                    const RequirementSubject& subject) {
  const auto lines = lines_of(one, subject);
  if (!lines || lines->second == Vec3(0)) return refusal("its lines have no distance of this length in one direction");
  const auto& [ends, direction] = *lines;
  if (const double measured = std::abs(glm::dot(ends[1].point - ends[0].point, direction)); !agrees(measured, one))
    return disagreement(measured, one);
  for (const FaceView& view : subject.views) {
    const Vec3& n = view.projection().n;
    const bool is_true = std::all_of(one.faces.begin(), one.faces.end(), [&](int face) {
      const surfaces::PartSurface& surface = face_of(subject, face).surface;
      return surface.kind != SurfaceKind::plane || std::abs(glm::dot(surface.axis, n)) >= 1 - max_tilt * max_tilt;
    });
    if (!is_true || std::abs(glm::dot(direction, n)) > max_tilt || rank_of(marks_in(view, subject, one.faces)) == 0)
      continue;
    dimension.view = {view.name(), dimension.where};
    anchor_length(dimension, ends, direction, view.projection());
    return written(std::move(dimension), one, subject, false);
  }
  return refusal(not_seen);
}

StatedDimension state_length(scene::DimensionDescription dimension, const ModelRequirement& one,
                             const RequirementSubject& subject) {
  if (one.lines.size() == 2) return state_between_lines(std::move(dimension), one, subject);
  const auto places = face_places(one.faces, subject.part);
  if (places.size() != 2)
    return refusal("its faces are at " + std::to_string(places.size()) + (places.size() == 1 ? " place" : " places") +
                   ", but a length is between two");
  const auto a = end_of(places[0], subject), b = end_of(places[1], subject);
  if (!a || !b) return refusal("there is no rule for a " + one.type + " to faces that are neither flat nor round");
  const Vec3 direction = direction_between(*a, *b, one);
  if (direction == Vec3(0)) {
    if (a->is_plane && features::are_parallel(a->direction, b->direction))
      return disagreement(std::abs(glm::dot(b->point - a->point, a->direction)), one);
    return refusal("its faces have no distance of this length in one direction");
  }
  const FaceView* view = nullptr;
  int most = 0;
  for (const FaceView& candidate : subject.views) {
    if (std::abs(glm::dot(direction, candidate.projection().n)) > max_tilt) continue;
    const int first = rank_of(marks_in(candidate, subject, places[0]));
    const int second = first == 0 ? 0 : rank_of(marks_in(candidate, subject, places[1]));
    if (second == 0 || first + second <= most) continue;
    most = first + second;
    view = &candidate;
  }
  if (view == nullptr) return refusal(not_seen);
  dimension.view = {view->name(), dimension.where};
  anchor_length(dimension, {*a, *b}, direction, view->projection());
  return written(std::move(dimension), one, subject, true);
}

// Angles.

// Towards the points of a face in the picture, as long as the face.
Vec3 leg_of(const std::vector<Vec3>& points, const Vec3& corner, const Vec3& along) {
  Vec3 farthest(0);
  for (const Vec3& p : points) {
    const Vec3 leg = glm::dot(p - corner, along) * along;
    if (glm::length(leg) > glm::length(farthest)) farthest = leg;
  }
  return farthest;
}

// Of a cone: between its outlines, or half of it to its axis, in a view across that; otherwise beside it.
StatedDimension state_cone_angle(scene::DimensionDescription dimension, const ModelRequirement& one,
                                 const RequirementSubject& subject, std::size_t places) {
  const PartFace& face = face_of(subject, one.faces.front());
  const surfaces::PartSurface& surface = face.surface;
  const double half = portable_atan2(std::abs(surface.slope), 1) * 180 / std::numbers::pi;
  const bool is_half = !agrees(2 * half, one);
  if (is_half && !agrees(half, one)) return disagreement(2 * half, one);
  const Vec3 apex = surface.origin - surface.radius / surface.slope * surface.axis;
  const double base = circles_of(face)[0].radius > circles_of(face)[1].radius ? face.from : face.to;
  const Vec3 foot = surface.origin + base * surface.axis;
  for (const FaceView& view : subject.views) {
    const Vec3& n = view.projection().n;
    const bool is_across = std::abs(glm::dot(surface.axis, n)) <= max_tilt && face.sweep >= surfaces::whole_turn;
    if (!is_across || rank_of(marks_in(view, subject, one.faces)) == 0) continue;
    const Vec3 out = (surface.radius + surface.slope * base) * glm::normalize(glm::cross(surface.axis, n));
    dimension.view = {view.name(), dimension.where};
    dimension.type = {DimensionType::angular, dimension.where};
    dimension.anchors = {apex, is_half ? foot : foot - out, foot + out};
    dimension.text = {sheet::times(places), dimension.where};
    return written(std::move(dimension), one, subject, false);
  }
  return beside(std::move(dimension), sheet::times(places), one, subject, is_half ? half : 2 * half);
}

StatedDimension state_angle(scene::DimensionDescription dimension, const ModelRequirement& one,
                            const RequirementSubject& subject) {
  const auto places = face_places(one.faces, subject.part);
  const auto is_cone = [&](int face) { return face_of(subject, face).surface.kind == SurfaceKind::cone; };
  if (places.size() != 2 && std::all_of(one.faces.begin(), one.faces.end(), is_cone))
    return state_cone_angle(std::move(dimension), one, subject, places.size());
  if (places.size() != 2) return refusal("an angle is between two faces");
  const auto a = end_of(places[0], subject), b = end_of(places[1], subject);
  if (!a || !b || a->direction == Vec3(0) || b->direction == Vec3(0))
    return refusal("there is no rule for angles of faces that are neither flat nor have an axis");
  const Vec3 edge = glm::cross(a->direction, b->direction);
  if (glm::length(edge) <= features::parallel) return refusal("its faces are parallel or square in each view");
  const Vec3 axis = glm::normalize(edge);
  // Planes and axes are lines in the view: along them, and the normal of the second one.
  const auto along = [&axis](const LengthEnd& end) {
    return end.is_plane ? glm::cross(axis, end.direction) : end.direction;
  };
  const Vec3 ways[2] = {along(*a), along(*b)};
  const Vec3 across = glm::cross(axis, ways[1]);
  // From the point of the first line along it to the second one.
  const double to_corner = glm::dot(b->point - a->point, across) / glm::dot(ways[0], across);
  const Vec3 corner = a->point + to_corner * ways[0];
  Vec3 legs[2] = {leg_of(a->points, corner, ways[0]), leg_of(b->points, corner, ways[1])};
  if (legs[0] == Vec3(0) || legs[1] == Vec3(0)) return refusal("its faces are parallel");
  const double cosine = glm::dot(glm::normalize(legs[0]), glm::normalize(legs[1]));
  const double degrees = portable_atan2(std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine) * 180 / std::numbers::pi;
  if (!agrees(degrees, one)) {
    if (!agrees(180 - degrees, one)) return disagreement(degrees, one);
    legs[1] = -legs[1];
  }
  for (const FaceView& view : subject.views) {
    if (std::abs(glm::dot(axis, view.projection().n)) < 1 - max_tilt * max_tilt) continue;
    if (rank_of(marks_in(view, subject, places[0])) == 0 || rank_of(marks_in(view, subject, places[1])) == 0) continue;
    dimension.view = {view.name(), dimension.where};
    dimension.type = {DimensionType::angular, dimension.where};
    dimension.anchors = {corner, corner + legs[0], corner + legs[1]};
    return written(std::move(dimension), one, subject, false);
  }
  return refusal(not_seen);
}

}  // namespace

std::vector<Vec3> arc_of(const PartFace& face, const std::vector<Vec3>& points, double along, double radius) {
  constexpr int steps = 16;
  if (face.sweep >= surfaces::whole_turn || points.empty()) return {};
  const Vec3& axis = face.surface.axis;
  const Vec3 centre = face.surface.origin + along * axis;
  const Vec3 off = points.front() - centre, u = glm::normalize(off - glm::dot(off, axis) * axis);
  const Vec3 v = glm::cross(axis, u);
  std::vector<double> angles;
  for (const Vec3& p : points) angles.push_back(portable_atan2(glm::dot(p - centre, v), glm::dot(p - centre, u)));
  std::sort(angles.begin(), angles.end());
  double from = angles.back() - 2 * std::numbers::pi, widest = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double before = i == 0 ? angles.back() - 2 * std::numbers::pi : angles[i - 1];
    if (angles[i] - before <= widest) continue;
    widest = angles[i] - before;
    from = angles[i];
  }
  const double sweep = 2 * std::numbers::pi - widest;
  std::vector<Vec3> arc;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + sweep * i / steps;
    arc.push_back(centre + radius * (portable_cos(angle) * u + portable_sin(angle) * v));
  }
  return arc;
}

std::vector<std::vector<int>> face_places(const std::vector<int>& faces, const world::PlacedPart& part) {
  constexpr double same = 1e-6;  // of the size of a face
  const auto are_at_one = [&](const PartFace& a, const PartFace& b) {
    if (a.surface.kind != b.surface.kind) return false;
    const double size = same * std::sqrt(a.area + b.area) + part.tolerance;
    const Vec3 off = b.surface.origin - a.surface.origin;
    if (a.surface.kind == SurfaceKind::plane)
      return features::are_parallel(a.surface.axis, b.surface.axis) && std::abs(glm::dot(off, a.surface.axis)) <= size;
    if (a.surface.kind == SurfaceKind::sphere) return glm::length(off) <= size;
    return surfaces::has_axis(a.surface.kind) && features::are_parallel(a.surface.axis, b.surface.axis) &&
           glm::length(off - glm::dot(off, a.surface.axis) * a.surface.axis) <= size;
  };
  std::vector<std::vector<int>> places;
  for (const int face : faces) {
    const PartFace& one = part.faces[static_cast<std::size_t>(face)];
    const auto place = std::find_if(places.begin(), places.end(), [&](const std::vector<int>& known) {
      return are_at_one(part.faces[static_cast<std::size_t>(known.front())], one);
    });
    if (place == places.end())
      places.push_back({face});
    else
      place->push_back(face);
  }
  return places;
}

StatedDimension state_dimension(const ModelRequirement& one, const RequirementSubject& subject,
                                const std::string& where) {
  if (one.faces.empty())
    return refusal(one.missing.empty() ? "it belongs to no face of the model" : "not read: " + one.missing);
  scene::DimensionDescription dimension;
  dimension.where = where;
  dimension.name = {where, where};
  if (one.is_angle || one.type == "angle") return state_angle(std::move(dimension), one, subject);
  if (has_word(one.type, "diameter") || has_word(one.type, "radius"))
    return state_circle(std::move(dimension), one, subject);
  if (has_word(one.type, "curve")) return beside(std::move(dimension), "⌒", one, subject, std::nullopt);
  return state_length(std::move(dimension), one, subject);
}

}  // namespace epura::pipeline
