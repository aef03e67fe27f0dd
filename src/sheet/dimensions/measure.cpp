// SPDX-License-Identifier: Apache-2.0
#include "dimensions/measure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "scene/choices.hpp"
#include "sizes/tolerance.hpp"

namespace epura::sheet {

namespace {

constexpr double max_tilt = 1e-3;   // sine of a tilt that shortens by only half a millionth
constexpr double whole_ink = 1e-5;  // relative length by which ink may be shorter

[[noreturn]] void refuse_measure(const AnchoredDimension& dimension, const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::input, dimension.where, what, hint);
}

// The view of a dimension, as a map of the world.
struct Sight {
  const drawing::ViewDrawing& drawing;
  const Notation& notation;
  const Vec3 n = drawing.projection.n;
  const bool orthographic = projection::is_orthographic(drawing.projection);

  [[nodiscard]] Vec2 page(const Vec3& p) const { return drawing.shown.breaks.moved(whole_page(p)); }
  // Before parts of the view are moved together.
  [[nodiscard]] Vec2 whole_page(const Vec3& p) const { return Vec2(drawing.world_to_page * Vec4(p, 1)); }
  // Image of a direction.
  [[nodiscard]] Vec2 page_of(const Vec3& d) const { return Vec2(drawing.world_to_page * Vec4(d, 0)); }
  [[nodiscard]] bool in_plane(const Vec3& d) const { return std::abs(glm::dot(d, n)) <= max_tilt * glm::length(d); }
  [[nodiscard]] bool shows_an_axis() const { return in_plane({1, 0, 0}) || in_plane({0, 1, 0}) || in_plane({0, 0, 1}); }
  // A pictorial view along parallel projectors, in which circles may be ellipses.
  [[nodiscard]] bool is_axonometric() const { return !orthographic || !shows_an_axis(); }
  // Of a circle about this axis.
  [[nodiscard]] bool is_edge_on(const Vec3& axis) const {
    return std::abs(glm::dot(axis, glm::normalize(drawing.projection.projector))) <= max_tilt;
  }
  [[nodiscard]] double millimetres() const { return glm::length(page_of(drawing.projection.u)); }  // per unit of length
};

DimensionText with_text(const AnchoredDimension& dimension, MeasuredValue measured, const Notation& notation) {
  measured.stated = dimension.stated;
  DimensionText value = text_of(measured, dimension.tolerance, notation);
  value.framed = dimension.is_exact;
  if (dimension.text.empty()) return value;
  constexpr std::string_view sign = "<>";
  const std::string pattern = with_repeats(dimension.text, notation);
  DimensionText text;
  std::size_t begin = 0, at = 0;
  while ((at = pattern.find(sign, begin)) != std::string::npos) {
    text.add(pattern.substr(begin, at - begin));
    text.add(value);
    begin = at + sign.size();
  }
  if (begin == 0 && dimension.tolerance)
    refuse_measure(dimension, "the text has no value for the tolerance",
                   "write <> where the value belongs, or omit the text");
  text.add(pattern.substr(begin));
  text.framed = dimension.is_exact;
  check(begin <= pattern.size(), "what follows the value is the rest of the text");
  return text;
}

// Half views show one end of a length across their line of symmetry: the dimension line breaks off beyond that line.
// ISO 129-1. Returns false for other lengths.
bool halve(MeasuredLength& length, const Sight& sight, const std::array<Vec2, 2>& unmoved) {
  constexpr double past = 6, slack = 0.1;  // mm
  const drawing::Breaks& breaks = sight.drawing.shown.breaks;
  for (const int axis : {0, 1}) {
    if (std::abs(length.along[axis]) < 1 - max_tilt || !breaks.are_mirrored(unmoved[0], unmoved[1], axis, slack))
      continue;
    const bool to = breaks.keeps(unmoved[0]);
    const double side = unmoved[to ? 1 : 0][axis] > unmoved[to ? 0 : 1][axis] ? 1 : -1;
    Vec2& end = to ? length.to : length.from;
    end[axis] = breaks.moved(Vec2(*breaks.mirror(axis)))[axis] + side * past;
    length.open = to;
    return true;
  }
  return false;
}

void expect_shown(const AnchoredDimension& dimension, const Sight& sight, const Vec3& point) {
  if (!sight.drawing.shown.breaks.keeps(sight.whole_page(point)))
    refuse_measure(dimension, "the view '" + sight.drawing.name + "' leaves out the part that it measures",
                   "measure in another view, or change the breaks of this one");
}

MeasuredDimension length_between(const AnchoredDimension& dimension, const Sight& sight, const Vec2& along,
                                 double value) {
  const Vec2 from = sight.page(dimension.points[0]), to = sight.page(dimension.points[1]);
  MeasuredLength length{from, to, along, left_of(along)};
  length.value = value;
  if (dimension.opposite.size() == 2)
    length.opposite = {sight.page(dimension.opposite[0]), sight.page(dimension.opposite[1])};
  if (!halve(length, sight, {sight.whole_page(dimension.points[0]), sight.whole_page(dimension.points[1])}))
    for (const Vec3& end : dimension.points) expect_shown(dimension, sight, end);
  return {length, with_text(dimension, {value}, sight.notation), dimension.offset};
}

MeasuredDimension linear(const AnchoredDimension& dimension, const Sight& sight) {
  const Vec3 d = dimension.points[1] - dimension.points[0];
  const bool horizontal = dimension.direction == DimensionDirection::horizontal;
  if (!sight.in_plane(d) && !(sight.orthographic && sight.shows_an_axis()))
    refuse_measure(dimension, "the view foreshortens the measured length",
                   "measure in a view parallel to it, or along an axis with 'aligned'");
  const double value = glm::dot(d, horizontal ? sight.drawing.projection.u : sight.drawing.projection.v);
  if (std::abs(value) <= 1e-9 * glm::length(d))
    refuse_measure(dimension, std::string("its anchors lie ") + (horizontal ? "one above the other" : "side by side"),
                   std::string("measure the ") + (horizontal ? "vertical" : "horizontal") + " distance");
  return length_between(dimension, sight, horizontal ? Vec2(1, 0) : Vec2(0, 1), std::abs(value));
}

// Several lengths from one place, or one after another.
MeasuredDimension measure_row(const AnchoredDimension& dimension, const Sight& sight) {
  const bool horizontal = dimension.direction == DimensionDirection::horizontal;
  const Vec3& axis = horizontal ? sight.drawing.projection.u : sight.drawing.projection.v;
  if (!sight.orthographic || !sight.shows_an_axis())
    refuse_measure(dimension, "the view foreshortens the measured lengths",
                   "measure in an orthographic view along an axis");
  const auto value = [&](std::size_t i) { return glm::dot(dimension.points[i] - dimension.points[0], axis); };
  std::vector<std::size_t> order(dimension.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
  MeasuredRow row{{}, 0, horizontal ? Vec2(1, 0) : Vec2(0, 1), {}, *dimension.arrangement};
  if (dimension.opposite.size() == order.size()) row.opposite.emplace();
  const bool is_chain = *dimension.arrangement == DimensionArrangement::chain;
  DimensionText all;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    expect_shown(dimension, sight, dimension.points[i]);
    if (i == 0) row.origin = k;
    row.places.push_back(sight.page(dimension.points[i]));
    if (row.opposite) row.opposite->push_back(sight.page(dimension.opposite[i]));
    if (k > 0 && value(i) - value(order[k - 1]) <= 1e-9 * (value(order.back()) - value(order.front())))
      refuse_measure(dimension, "two of its places have the same extension line", "omit one of them");
    if (is_chain && k + 1 == order.size()) break;
    const double length = is_chain ? value(order[k + 1]) - value(i) : value(i);
    const bool is_origin = !is_chain && i == 0;
    // From a common origin, lengths to the left and downwards are negative.
    const bool is_negative = *dimension.arrangement == DimensionArrangement::ordinate && length < 0;
    DimensionText text(is_origin ? "0" : is_negative ? "-" : "");
    if (!is_origin) text.add(with_text(dimension, {std::abs(length)}, sight.notation));
    row.texts.push_back(text);
    row.values.push_back(std::abs(length));
    if (!is_origin) all.add((all.pieces.empty() ? "" : ", ") + text.line());
  }
  check(row.texts.size() + (is_chain ? 1 : 0) == row.places.size(), "a row has a text for each place or step");
  return {std::move(row), all, dimension.offset};
}

// The image of a world axis most nearly perpendicular to the line on paper, x before y before z, for extension lines of
// axonometric views. Length 1.
Vec2 extension_axis(const Sight& sight, const Vec2& along) {
  Vec2 best = left_of(along);
  double min = 0.99;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2 image = sight.page_of(Mat3(1)[axis]);
    const double size = glm::length(image);
    if (size <= max_tilt * sight.millimetres()) continue;
    const double lean = std::abs(glm::dot(image / size, along));
    if (lean < min - 1e-9) {
      min = lean;
      best = image / size;
    }
  }
  return best;
}

MeasuredDimension aligned(const AnchoredDimension& dimension, const Sight& sight) {
  const Vec3 d = dimension.points[1] - dimension.points[0];
  const double length = glm::length(d);
  const Vec2 image = sight.page_of(d);
  const bool seen = glm::length(image) > max_tilt * sight.millimetres() * length;
  const bool on_axis = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) >= (1 - max_tilt * max_tilt) * length;
  if (!seen || !(sight.in_plane(d) || on_axis))
    refuse_measure(dimension,
                   seen ? "the view foreshortens the measured line" : "the view looks along the measured line",
                   "measure it in a view parallel to it");
  const Vec2 along = image / glm::length(image);
  MeasuredDimension measured = length_between(dimension, sight, along, length);
  if (!sight.in_plane(d)) std::get<MeasuredLength>(measured.form).extension = extension_axis(sight, along);
  return measured;
}

MeasuredDimension angular(const AnchoredDimension& dimension, const Sight& sight) {
  std::array<Vec3, 2> legs{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 leg = dimension.points[i + 1] - dimension.points[0];
    if (!sight.in_plane(leg))
      refuse_measure(dimension, "the view changes the angle: a leg is not parallel to its plane",
                     "measure it in a view along the axis of the angle");
    legs[i] = glm::normalize(leg);
  }
  const double angle = portable_atan2(glm::length(glm::cross(legs[0], legs[1])), glm::dot(legs[0], legs[1]));
  const double degrees = angle * 180 / std::numbers::pi;
  check(degrees >= 0 && degrees <= 180 * (1 + 1e-9), "an angle between legs is at most half a turn");
  if (degrees < 0.005)
    refuse_measure(dimension, "its legs lie on one line: the angle is zero", "choose other vertices");
  expect_shown(dimension, sight, dimension.points[0]);
  const auto corner_of = [&](const std::vector<Vec3>& points) {
    const Vec2 unmoved = sight.whole_page(points[0]);
    return CornerOnPaper{sight.page(points[0]),
                         {sight.whole_page(points[1]) - unmoved, sight.whole_page(points[2]) - unmoved}};
  };
  const CornerOnPaper own = corner_of(dimension.points);
  MeasuredAngle measured{own.at, own.legs};
  if (dimension.opposite.size() == 3 && !sight.drawing.shown.breaks.any())
    measured.equal = corner_of(dimension.opposite);
  return {measured, with_text(dimension, {degrees, "", true}, sight.notation), dimension.offset};
}

// Of a circle in a view that leaves parts out, the longest arc that is drawn.
void keep_shown_arc(MeasuredCircle& measured, const WorldCircle& circle, const Sight& sight) {
  const Vec2 centre = sight.whole_page(circle.centre);
  double sweep = 0;
  for (const drawing::KeptPart& part : drawing::kept_parts(sight.drawing.shown.breaks)) {
    const Vec2 reach(2 * measured.radius);
    const Vec2 min = glm::max(part.min, centre - reach), max = glm::min(part.max, centre + reach);
    if (!(min.x < max.x && min.y < max.y)) continue;
    for (const drawing::AngleRange& range :
         drawing::circle_inside({(min + max) / 2.0, (max - min) / 2.0, false}, centre, measured.radius)) {
      if (range.to - range.from <= sweep) continue;
      sweep = measured.sweep = range.to - range.from;
      measured.first = range.from;
      measured.centre = centre + part.shift;
    }
  }
}

// Where an arc begins and its sweep, from the order of its vertices on paper.
MeasuredCircle on_paper(const WorldCircle& circle, const Sight& sight, const AnchoredDimension& dimension) {
  MeasuredCircle measured{sight.page(circle.centre),    circle.radius * sight.millimetres(),     0,
                          circle.whole ? full_turn : 0, dimension.type == DimensionType::radius, dimension.is_label};
  measured.value = measured.is_radius ? circle.radius : 2 * circle.radius;
  check(circle.radius > 0, "a circle has a radius");
  measured.place = circle.centre;
  measured.axis = circle.axis;
  if (circle.whole && sight.drawing.shown.breaks.any()) keep_shown_arc(measured, circle, sight);
  if (circle.whole) return measured;
  std::optional<Vec2> before;
  const Vec2 whole_centre = sight.whole_page(circle.centre);
  for (const Vec3& vertex : circle.rim) {
    const Vec2 spoke = sight.whole_page(vertex) - whole_centre;
    if (before) measured.sweep += portable_atan2(glm::dot(left_of(*before), spoke), glm::dot(*before, spoke));
    if (!before) measured.first = portable_atan2(spoke.y, spoke.x);
    before = spoke;
  }
  return measured;
}

// The length of an arc that the view shows in true shape.
MeasuredDimension arc_length(const AnchoredDimension& dimension, const Sight& sight) {
  for (const WorldCircle& circle : dimension.circles) {
    if (circle.whole || circle.rim.size() < 2 || glm::length(glm::cross(circle.axis, sight.n)) > max_tilt) continue;
    const MeasuredCircle arc = on_paper(circle, sight, dimension);
    for (const Vec3& end : {circle.rim.front(), circle.rim.back()}) expect_shown(dimension, sight, end);
    const auto leg = [&](double angle) { return arc.radius * Vec2(portable_cos(angle), portable_sin(angle)); };
    const double value = circle.radius * std::abs(arc.sweep);
    return {MeasuredAngle{arc.centre, {leg(arc.first), leg(arc.first + arc.sweep)}, arc.sweep},
            with_text(dimension, {value, sight.notation.arc}, sight.notation), dimension.offset};
  }
  refuse_measure(dimension, "the view shows no arc at this place in its true form",
                 "measure an arc of less than a full turn, in a view along its axis");
}

// For a circle seen edge-on: the distance between its ends.
MeasuredDimension diameter_edge_on(const AnchoredDimension& dimension, const WorldCircle& circle, const Sight& sight,
                                   const DimensionText& text) {
  const Vec3 across = glm::normalize(glm::cross(circle.axis, sight.n)) * circle.radius;
  const Vec2 along = glm::normalize(sight.page_of(across));
  const Vec3 one = circle.centre - across, other = circle.centre + across;
  MeasuredLength length{sight.page(one), sight.page(other), along, left_of(along)};
  length.value = 2 * circle.radius;
  length.is_diameter = true;
  if (!halve(length, sight, {sight.whole_page(one), sight.whole_page(other)})) {
    expect_shown(dimension, sight, one);
    expect_shown(dimension, sight, other);
  }
  return {length, text, dimension.offset};
}

// Two perpendicular ones.
std::array<Vec3, 2> spokes_of(const WorldCircle& circle) {
  const Vec3 size = glm::abs(circle.axis);
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  const Vec3 u = circle.radius * glm::normalize(glm::cross(circle.axis, Mat3(1)[least]));
  return {u, glm::cross(circle.axis, u)};
}

MeasuredDimension circular(const AnchoredDimension& dimension, const Sight& sight) {
  const bool is_radius = dimension.type == DimensionType::radius;
  check(is_radius || dimension.type == DimensionType::diameter, "circles have diameters or radii");
  const auto text = [&](const WorldCircle& circle) {
    const double value = is_radius ? circle.radius : 2 * circle.radius;
    return with_text(dimension, {value, is_radius ? "R" : sight.notation.diameter}, sight.notation);
  };
  for (const WorldCircle& circle : dimension.circles)
    if (glm::length(glm::cross(circle.axis, sight.n)) <= max_tilt)
      return {on_paper(circle, sight, dimension), text(circle), dimension.offset};
  for (const WorldCircle& circle : dimension.circles)
    if (!is_radius && circle.whole && sight.orthographic && sight.in_plane(circle.axis))
      return diameter_edge_on(dimension, circle, sight, text(circle));
  for (const WorldCircle& circle : dimension.circles)
    if (sight.is_axonometric() && !sight.is_edge_on(circle.axis)) {
      MeasuredCircle ellipse = on_paper(circle, sight, dimension);
      const auto [u, v] = spokes_of(circle);
      ellipse.spokes = {sight.page_of(u), sight.page_of(v)};
      return {ellipse, text(circle), dimension.offset};
    }
  refuse_measure(dimension, "the view does not show the circle in its true form",
                 is_radius ? "measure it in a view along its axis"
                           : "measure it in a view along its axis, or perpendicular to it");
}

// The ends of the ink, without lines beside faces, along a direction on paper: among several, the farthest along
// `side`.
std::array<Vec2, 2> ends_of_ink(const drawing::ViewDrawing& drawing, const Vec2& along, const Vec2& side) {
  constexpr double same = 1e-6;  // mm
  const auto is_wire = [](const drawing::Segment& segment) { return segment.kind == EdgeKind::wire; };
  const auto face_line = std::find_if_not(drawing.segments.begin(), drawing.segments.end(), is_wire);
  const bool only_wires = face_line == drawing.segments.end();
  const Vec2 first = only_wires ? drawing.segments.front().from : face_line->from;
  std::array<Vec2, 2> ends{first, first};
  const auto take = [&](Vec2& end, const Vec2& direction, const Vec2& p) {
    const double farther = glm::dot(p - end, direction);
    if (farther > same || (farther >= -same && glm::dot(p - end, side) > 0)) end = p;
  };
  for (const drawing::Segment& segment : drawing.segments) {
    if (is_wire(segment) && !only_wires) continue;
    for (const Vec2& p : {segment.from, segment.to}) {
      take(ends[0], -along, p);
      take(ends[1], along, p);
    }
  }
  return ends;
}

// In a half view, one end of the ink is at the line of symmetry: replaces it with the mirror image of the other end.
void complete_half(std::array<Vec2, 2>& ends, const drawing::Breaks& breaks, const Vec2& along) {
  for (const int axis : {0, 1}) {
    const std::optional<double> mirror = breaks.mirror(axis);
    if (!mirror || std::abs(along[axis]) < 1 - max_tilt) continue;
    const auto distance = [&](const Vec2& p) { return std::abs(p[axis] - *mirror); };
    const bool second = distance(ends[0]) > distance(ends[1]);
    ends[second ? 1 : 0][axis] = 2 * *mirror - ends[second ? 0 : 1][axis];
  }
}

MeasuredDimension overall(const AnchoredDimension& dimension, const Sight& sight) {
  const int axis = axis_of(*dimension.direction);
  const Vec3 e = Mat3(1)[axis];
  if (!sight.orthographic || !sight.in_plane(e))
    refuse_measure(dimension, "the view does not show this size in true length",
                   "choose an orthographic view parallel to the axis");
  const Vec2 image = sight.page_of(e), along = glm::normalize(image);
  const double value = dimension.points[1][axis] - dimension.points[0][axis];
  check(value >= 0, "an extent is not negative");
  // The dimension line is below, or on the right.
  const Vec2 side = std::abs(along.x) > std::abs(along.y) ? Vec2(0, -1) : Vec2(1, 0);
  std::array<Vec2, 2> ends{};
  if (!sight.drawing.segments.empty()) ends = ends_of_ink(sight.drawing, along, side);
  const drawing::Breaks& breaks = sight.drawing.shown.breaks;
  std::array<Vec2, 2> whole_ends{breaks.restored(ends[0]), breaks.restored(ends[1])};
  complete_half(whole_ends, breaks, along);
  const double drawn = glm::dot(whole_ends[1] - whole_ends[0], along) / glm::length(image);
  // Lines of a mesh end where the mesh does; lines of its surfaces may reach as far as the surfaces. At either end, a
  // line may be drawn slightly displaced, replaced by another, or too near to another one to be told apart.
  const drawing::LineDistances& off = sight.drawing.distances;
  const double beside = 2 * (off.contours_moved + off.joined_within + off.coincident) / glm::length(image);
  const double least = value - dimension.beyond_vertices - dimension.unevenness - beside;
  if (sight.drawing.segments.empty() || drawn < least - whole_ink * value || drawn > value + beside + whole_ink * value)
    refuse_measure(dimension, "the view does not show all of the models along this axis",
                   "omit --near and --far, and include contour in --edges");
  // Both sides of a sheet of metal may be one line.
  if (!(drawn > 0))
    for (const int end : {0, 1}) {
      ends[end] += (end - 0.5) * value * image;
      whole_ends[end] += (end - 0.5) * value * image;
    }
  const std::string sign = dimension.form == features::ExtentForm::length   ? ""
                           : dimension.form == features::ExtentForm::sphere ? "S" + sight.notation.diameter
                                                                            : sight.notation.diameter;
  MeasuredLength length{ends[0], ends[1], along, left_of(along)};
  length.value = value;
  halve(length, sight, whole_ends);
  return {length, with_text(dimension, {value, sign}, sight.notation), dimension.offset};
}

// No sheet is longer.
void expect_within_a_sheet(const AnchoredDimension& dimension, const Sight& sight) {
  for (const Vec3& point : dimension.points) {
    const Vec2 place = glm::abs(sight.whole_page(point));
    if (!(std::max(place.x, place.y) <= scene::longest_side))
      refuse_measure(
          dimension,
          "one of its points lies " + format_rounded(std::max(place.x, place.y) / 1000, 4) + " m away on the sheet",
          "use a smaller scale, and points that are on the models");
  }
}

}  // namespace

MeasuredDimension measure(const drawing::ViewDrawing& drawing, const AnchoredDimension& dimension,
                          const Notation& notation) {
  if (drawing.projection.central)
    refuse_measure(dimension, "the view '" + drawing.name + "' is a perspective, which shows no true lengths",
                   "measure in an orthographic view");
  const Sight sight{drawing, notation};
  check(sight.millimetres() > 0, "a parallel view has a scale");
  expect_within_a_sheet(dimension, sight);
  switch (dimension.type) {
    case DimensionType::linear:
      return dimension.arrangement ? measure_row(dimension, sight) : linear(dimension, sight);
    case DimensionType::aligned:
      return aligned(dimension, sight);
    case DimensionType::angular:
      return angular(dimension, sight);
    case DimensionType::arc:
      return arc_length(dimension, sight);
    case DimensionType::overall:
      return overall(dimension, sight);
    default:
      return circular(dimension, sight);
  }
}

namespace {

bool is_on_line(const Vec2& p, const Vec2& on, const Vec2& direction) {
  constexpr double slack = 1e-6;
  return std::abs(glm::dot(p - on, left_of(direction))) <= slack * (1 + glm::length(p - on)) * glm::length(direction);
}

}  // namespace

bool ends_at(const MeasuredLength& length, const Vec2& tip) {
  const auto is_end = [&](const Vec2& end) { return is_on_line(tip, end, length.extension); };
  return is_end(length.from) || is_end(length.to) ||
         (length.opposite && (is_end((*length.opposite)[0]) || is_end((*length.opposite)[1])));
}

bool ends_at(const MeasuredRow& row, const Vec2& tip) {
  const auto is_place = [&](const Vec2& place) { return is_on_line(tip, place, left_of(row.along)); };
  return std::any_of(row.places.begin(), row.places.end(), is_place) ||
         (row.opposite && std::any_of(row.opposite->begin(), row.opposite->end(), is_place));
}

// The extension lines of the length of an arc may be parallel to its bisector.
bool ends_at(const MeasuredAngle& angle, const Vec2& tip) {
  const auto is_of_equal = [&](const Vec2& leg) { return is_on_line(tip, angle.equal->at, leg); };
  return std::any_of(angle.legs.begin(), angle.legs.end(),
                     [&](const Vec2& leg) {
                       return is_on_line(tip, angle.corner, leg) ||
                              (angle.arc && is_on_line(tip, angle.corner + leg, angle.legs[0] + angle.legs[1]));
                     }) ||
         (angle.equal && std::ranges::any_of(angle.equal->legs, is_of_equal));
}

bool ends_at(const MeasuredCircle& circle, const Vec2& tip) {
  return std::abs(glm::length(circle.in_spokes(tip - circle.centre)) - 1) * circle.radius <= 1e-6 * (1 + circle.radius);
}

std::vector<double> places_of(const MeasuredDimension& dimension) {
  std::vector<double> places{static_cast<double>(dimension.form.index())};
  const auto add = [&places](const Vec2& v) { places.insert(places.end(), {v.x, v.y}); };
  check(!std::holds_alternative<MeasuredRow>(dimension.form), "a row has other places with other texts");
  if (dimension.offset) places.push_back(*dimension.offset);
  if (const auto* length = std::get_if<MeasuredLength>(&dimension.form)) {
    for (const Vec2& v : {length->from, length->to, length->along, length->extension}) add(v);
    if (length->opposite) std::ranges::for_each(*length->opposite, add);
  } else if (const auto* angle = std::get_if<MeasuredAngle>(&dimension.form)) {
    for (const Vec2& v : {angle->corner, angle->legs[0], angle->legs[1]}) add(v);
    if (angle->arc) places.push_back(*angle->arc);
    if (angle->equal) add(angle->equal->at);
  } else if (const auto* circle = std::get_if<MeasuredCircle>(&dimension.form)) {
    add(circle->centre);
    add({circle->first, circle->sweep});
    add({circle->radius, circle->is_radius ? 1 : 0});
    if (circle->spokes) std::ranges::for_each(*circle->spokes, add);
  }
  return places;
}

}  // namespace epura::sheet
