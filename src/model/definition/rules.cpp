// SPDX-License-Identifier: Apache-2.0
#include "definition/rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "definition/limits.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::definition {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

Row difference(Row row, const Row& other, double factor = 1) {
  add(row, other, -factor);
  return tidy(std::move(row));
}

const PartSurface& surface_of(const Part& part, int face) { return part.faces[static_cast<std::size_t>(face)].surface; }

std::size_t number_of(const Part& part) { return part.faces.size(); }

// All faces with the direction of another one turn with it.
void state_parallel(const Part& part, const Directions& directions, const Unknowns& unknowns, const Marks&,
                    Statement& statement) {
  for (std::size_t i = 0; i < number_of(part); ++i) {
    const int direction = directions.of_face[i], face = static_cast<int>(i);
    if (direction < 0) continue;
    const int first = directions.first_face[static_cast<std::size_t>(direction)];
    if (first == face) continue;
    for (const Vec3& across : surfaces::square_to(directions.directions[static_cast<std::size_t>(direction)]))
      statement.rows.push_back(difference(unknowns.turn(face, across), unknowns.turn(first, across)));
  }
}

void state_perpendicular(const Part&, const Directions& directions, const Unknowns& unknowns, const Marks&,
                         Statement& statement) {
  for (std::size_t i = 0; i < directions.directions.size(); ++i)
    for (std::size_t j = i + 1; j < directions.directions.size(); ++j) {
      const Vec3 &a = directions.directions[i], &b = directions.directions[j];
      if (std::abs(glm::dot(a, b)) > drawn_parallel) continue;
      const Vec3 about = glm::cross(a, b);
      statement.rows.push_back(
          difference(unknowns.turn(directions.first_face[i], about), unknowns.turn(directions.first_face[j], about)));
    }
}

// Axes that are one line in a view, in whose direction one lies behind the other.
void state_in_view(const Part& part, const Directions& directions, const Unknowns& unknowns, const Vec3& sight,
                   Statement& statement) {
  const auto seen = std::find_if(directions.directions.begin(), directions.directions.end(), [&](const Vec3& one) {
    return glm::length(glm::cross(one, sight)) <= drawn_parallel;
  });
  if (seen == directions.directions.end()) return;
  const int behind = directions.first_face[static_cast<std::size_t>(seen - directions.directions.begin())];
  std::map<int, std::vector<std::pair<double, int>>> places;  // of each direction
  for (int face = 0; face < static_cast<int>(number_of(part)); ++face) {
    const PartSurface& surface = surface_of(part, face);
    if (!surfaces::has_axis(surface.kind) || std::abs(glm::dot(surface.axis, sight)) > drawn_parallel) continue;
    const Vec3 across = glm::cross(surface.axis, sight);
    places[directions.of_face[static_cast<std::size_t>(face)]].emplace_back(glm::dot(unknowns.anchor(face), across),
                                                                            face);
  }
  for (auto& [direction, list] : places) {
    std::sort(list.begin(), list.end());
    for (std::size_t i = 1; i < list.size(); ++i) {
      const auto& [from, first] = list[i - 1];
      const auto& [to, face] = list[i];
      if (to - from > drawn_in_line * part.size) continue;
      const Vec3 &axis = surface_of(part, face).axis, &at = unknowns.anchor(face);
      const Vec3 across = glm::cross(axis, sight);
      const Vec3 before = unknowns.anchor(first) + glm::dot(at - unknowns.anchor(first), axis) * axis;
      Row row = unknowns.axis_motion(face, at, across);
      add(row, unknowns.axis_motion(first, before, across), -1);
      add(row, unknowns.turn(behind, glm::cross(across, (at - before) / part.size)));
      statement.rows.push_back(tidy(std::move(row)));
    }
  }
}

// What lies on one line square to a direction, which is that of a face, is one place. Beside planes, lines align only
// along the axes of the views, and those of a part that is turned in one.
void state_in_line(const Part& part, const Directions& directions, const Unknowns& unknowns, const Marks& marks,
                   Statement& statement) {
  for (std::size_t d = 0; d < directions.directions.size(); ++d) {
    const Vec3& along = directions.directions[d];
    const auto is_along = [&](const Vec3& axis) { return glm::length(glm::cross(axis, along)) <= drawn_parallel; };
    const bool is_main = std::ranges::any_of(marks.axes, is_along) || std::ranges::any_of(marks.own_axes, is_along);
    std::vector<std::pair<double, int>> places;
    for (int face = 0; face < static_cast<int>(number_of(part)); ++face)
      if (const PartSurface& surface = surface_of(part, face);
          has_place_along(surface, along) &&
          ((is_main && marks.has_centre_lines) || surface.kind == SurfaceKind::plane))
        places.emplace_back(glm::dot(unknowns.anchor(face), along), face);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i) {
      const auto& [from, first] = places[i - 1];
      const auto& [to, face] = places[i];
      if (to - from > drawn_in_line * part.size) continue;
      const Vec3 arm = (unknowns.anchor(face) - unknowns.anchor(first)) / part.size;
      Row row = unknowns.axis_motion(face, unknowns.anchor(face), along);
      add(row, unknowns.axis_motion(first, unknowns.anchor(first), along), -1);
      add(row, unknowns.turn(directions.first_face[d], glm::cross(along, arm)));
      statement.rows.push_back(tidy(std::move(row)));
    }
  }
  if (!marks.has_centre_lines) return;
  for (const Vec3& sight : marks.axes) state_in_view(part, directions, unknowns, sight, statement);
}

double off_axis(const Vec3& point, const PartSurface& line) {
  const Vec3 off = point - line.origin;
  return glm::length(off - glm::dot(off, line.axis) * line.axis);
}

// Axes that are drawn as one centre line, and centres on it; equal radii of faces that something interrupts.
void state_coaxial(const Part& part, const Directions& directions, const Unknowns& unknowns, const Marks&,
                   Statement& statement) {
  const double slack = drawn_in_line * part.size;
  for (int face = 0; face < static_cast<int>(number_of(part)); ++face) {
    const PartSurface& surface = surface_of(part, face);
    if (!surfaces::has_axis(surface.kind) && surface.kind != SurfaceKind::sphere) continue;
    for (int other = 0; other < static_cast<int>(number_of(part)); ++other) {
      const PartSurface& axis = surface_of(part, other);
      const bool is_ball = surface.kind == SurfaceKind::sphere;
      if (!surfaces::has_axis(axis.kind) || (!is_ball && other >= face) ||
          off_axis(unknowns.anchor(face), axis) > slack ||
          (!is_ball &&
           directions.of_face[static_cast<std::size_t>(face)] != directions.of_face[static_cast<std::size_t>(other)]))
        continue;
      for (const Vec3& across : surfaces::square_to(axis.axis))
        statement.rows.push_back(difference(unknowns.axis_motion(face, unknowns.anchor(face), across),
                                            unknowns.axis_motion(other, unknowns.anchor(face), across)));
      break;
    }
  }
}

// Axes that are drawn as centre lines which cross stay in one plane.
void state_crossing(const Part& part, const Directions& directions, const Unknowns& unknowns, const Marks&,
                    Statement& statement) {
  std::vector<int> lines;  // of those with one axis, the first
  for (int face = 0; face < static_cast<int>(number_of(part)); ++face) {
    if (!surfaces::has_axis(surface_of(part, face).kind)) continue;
    const auto direction_of = [&](int one) { return directions.of_face[static_cast<std::size_t>(one)]; };
    const Vec3& at = unknowns.anchor(face);
    const bool is_known = std::any_of(lines.begin(), lines.end(), [&](int line) {
      return direction_of(line) == direction_of(face) &&
             off_axis(at, surface_of(part, line)) <= drawn_in_line * part.size;
    });
    if (is_known) continue;
    for (const int line : lines) {
      const PartSurface &one = surface_of(part, line), &two = surface_of(part, face);
      if (direction_of(line) == direction_of(face)) continue;
      const Vec3 across = glm::normalize(glm::cross(one.axis, two.axis)), off = at - unknowns.anchor(line);
      if (std::abs(glm::dot(off, across)) > drawn_in_line * part.size) continue;
      const Vec3 square = glm::cross(across, two.axis);
      const Vec3 crossing = unknowns.anchor(line) + glm::dot(off, square) / glm::dot(one.axis, square) * one.axis;
      statement.rows.push_back(
          difference(unknowns.axis_motion(face, crossing, across), unknowns.axis_motion(line, crossing, across)));
    }
    lines.push_back(face);
  }
}

// Faces of one round surface that something interrupts, and concentric spheres.
void state_same(const Part& part, const Directions&, const Unknowns& unknowns, const Marks&, Statement& statement) {
  for (int face = 0; face < static_cast<int>(number_of(part)); ++face)
    for (int other = 0; other < face; ++other) {
      const PartSurface &one = surface_of(part, face), &two = surface_of(part, other);
      if (one.kind != two.kind || one.kind == SurfaceKind::plane || one.kind == SurfaceKind::free_form) continue;
      const bool are_concentric =
          one.kind == SurfaceKind::sphere && glm::distance(one.origin, two.origin) <= drawn_in_line * part.size;
      for (int axis = 0; axis < 3 && are_concentric; ++axis)
        statement.rows.push_back(difference(unknowns.axis_motion(face, one.origin, Mat3(1)[axis]),
                                            unknowns.axis_motion(other, one.origin, Mat3(1)[axis])));
      if (!surfaces::are_one(one, two)) continue;
      if (one.kind == SurfaceKind::cone) {
        const Vec3 out = surfaces::square_to(one.axis)[0];
        const Vec3 rim = unknowns.anchor(face) + one.radius * out;
        statement.rows.push_back(
            difference(unknowns.surface_motion(face, rim, out), unknowns.surface_motion(other, rim, out)));
      } else {
        statement.rows.push_back(
            difference(unknowns.growth(face, UnknownKind::radius), unknowns.growth(other, UnknownKind::radius)));
      }
      for (const UnknownKind size : {UnknownKind::minor, UnknownKind::angle})
        if (Row row = difference(unknowns.growth(face, size), unknowns.growth(other, size)); !row.empty())
          statement.rows.push_back(std::move(row));
      break;
    }
}

// Of twist drills, as they are (DIN 1412), and as they are drawn: 118 to 120 degrees.
bool has_angle_of_drill(const PartSurface& cone) {
  const long angle = std::lround(2 * std::atan(std::abs(cone.slope)) * degrees);
  return angle >= 118 && angle <= 120;
}

// A cone that is the end of a bore, and touches nothing else, has the angle of a drill, if it looks like that.
void state_drilled(const Part& part, const Directions&, const Unknowns& unknowns, const Marks&, Statement& statement) {
  std::vector<std::vector<int>> touched(number_of(part));
  for (const Contact& contact : part.contacts)
    for (const int side : {0, 1})
      touched[static_cast<std::size_t>(contact.faces[static_cast<std::size_t>(side)])].push_back(
          contact.faces[static_cast<std::size_t>(1 - side)]);
  for (int face = 0; face < static_cast<int>(number_of(part)); ++face) {
    const std::vector<int>& others = touched[static_cast<std::size_t>(face)];
    const PartSurface& end = surface_of(part, face);
    if (end.kind != SurfaceKind::cone || !has_angle_of_drill(end) || others.empty()) continue;
    const bool is_point = std::all_of(others.begin(), others.end(), [&](int other) {
      const PartSurface& bore = surface_of(part, other);
      return bore.kind == SurfaceKind::cylinder &&
             off_axis(unknowns.anchor(other), surface_of(part, face)) <= drawn_in_line * part.size;
    });
    if (is_point && std::set<int>(others.begin(), others.end()).size() == 1)
      statement.rows.push_back(unknowns.growth(face, UnknownKind::angle));
  }
}

// The surfaces keep touching wherever they do: what one moves along the common normal, the other does. Normals of both
// differ by the errors of the file, so those of one count: of a plane, if there is one.
void state_tangent(const Part& part, const Directions&, const Unknowns& unknowns, const Marks&, Statement& statement) {
  for (const Contact& contact : part.contacts) {
    if (!contact.is_tangent) continue;
    auto [face, other] = contact.faces;
    if (surface_of(part, other).kind == SurfaceKind::plane) std::swap(face, other);
    if (surface_of(part, other).kind == SurfaceKind::free_form) continue;
    for (const Vec3& point : contact.points) {
      const Vec3 normal = surfaces::normal_near(surface_of(part, face), point);
      if (glm::length(normal) > 0)
        statement.rows.push_back(
            difference(unknowns.surface_motion(face, point, normal), unknowns.surface_motion(other, point, normal)));
    }
  }
}

// Points, and directions along which they tell where a plane, an axis or a centre is.
std::vector<std::array<Vec3, 2>> held_points(const Part& part, const Unknowns& unknowns, int face) {
  const PartSurface& surface = surface_of(part, face);
  const Vec3& at = unknowns.anchor(face);
  if (surface.kind == SurfaceKind::sphere) return {{at, Vec3(1, 0, 0)}, {at, Vec3(0, 1, 0)}, {at, Vec3(0, 0, 1)}};
  const auto [u, v] = surfaces::square_to(surface.axis);
  const Vec3 along = part.size * surface.axis;
  if (surface.kind == SurfaceKind::plane)
    return {{at, surface.axis}, {at + part.size * u, surface.axis}, {at + part.size * v, surface.axis}};
  std::vector<std::array<Vec3, 2>> held{{at, u}, {at, v}, {at + along, u}, {at + along, v}};
  if (surface.kind == SurfaceKind::torus) held.push_back({at, surface.axis});
  return held;
}

// The image of one face of a pair is the other one; a plane of symmetry that moves takes it along twice.
void state_symmetric(const Part& part, const Directions&, const Unknowns& unknowns, const Marks& marks,
                     Statement& statement) {
  for (const SymmetryLine& line : marks.symmetries) {
    const PartSurface& mirror = surface_of(part, line.face);
    for (const int face : line.axes)
      for (const double along : {0.0, part.size}) {
        const PartSurface& surface = surface_of(part, face);
        if (along > 0 && !surfaces::has_axis(surface.kind)) continue;
        const Vec3 point = unknowns.anchor(face) + along * surface.axis;
        statement.rows.push_back(difference(unknowns.axis_motion(face, point, mirror.axis),
                                            unknowns.axis_motion(line.face, point, mirror.axis)));
      }
    for (const auto& [face, image] : line.pairs) {
      for (const auto& [point, along] : held_points(part, unknowns, image)) {
        const Vec3 from = mirror.origin + glm::reflect(point - mirror.origin, mirror.axis);
        Row row = difference(unknowns.axis_motion(image, point, along),
                             unknowns.axis_motion(face, from, glm::reflect(along, mirror.axis)));
        add(row, unknowns.axis_motion(line.face, point, along), -2);
        statement.rows.push_back(tidy(std::move(row)));
      }
      for (const UnknownKind size : {UnknownKind::radius, UnknownKind::minor, UnknownKind::angle})
        if (Row row = difference(unknowns.growth(image, size), unknowns.growth(face, size)); !row.empty())
          statement.rows.push_back(std::move(row));
    }
  }
}

// How far an even circle turns about its axis as the centre lines of a view do, if one of these goes through one of its
// axes, or midway between two. `turned`: how far its first axis goes along the circle.
void add_to_centre_line(std::vector<std::pair<Vec3, Row>>& on_lines, const PitchCircle& circle, const Row& turned,
                        const Part& part, const Marks& marks) {
  const PartSurface& drawn = surface_of(part, circle.face);
  std::vector<Vec3> places;  // of faces about one axis, one
  for (const int face : circle.axes) {
    const Vec3 out = surfaces::normal_near(drawn, surface_of(part, face).origin);
    if (std::ranges::none_of(places, [&](const Vec3& one) { return glm::distance(one, out) <= 10 * drawn_parallel; }))
      places.push_back(out);
  }
  const double step = full_turn / (2 * static_cast<double>(places.size()));
  const Vec3& out = places.front();
  const bool is_on_line = std::ranges::any_of(marks.axes, [&](const Vec3& along) {
    if (std::abs(glm::dot(along, drawn.axis)) > drawn_parallel) return false;
    const double angle = std::atan2(glm::dot(glm::cross(along, out), drawn.axis), glm::dot(along, out)) / step;
    return std::abs(angle - std::round(angle)) * step <= 10 * drawn_parallel;
  });
  if (!is_on_line) return;
  Row turn = turned;
  for (Term& term : turn) term.factor *= part.size / drawn.radius;
  on_lines.emplace_back(drawn.axis, std::move(turn));
}

void state_on_circle(const Part& part, const Directions&, const Unknowns& unknowns, const Marks& marks,
                     Statement& statement) {
  std::vector<std::pair<Vec3, Row>> on_lines;  // axes of circles, and how far they turn
  for (const PitchCircle& circle : marks.circles) {
    const PartSurface& drawn = surface_of(part, circle.face);
    Row first;
    for (const int face : circle.axes) {
      const Vec3& at = unknowns.anchor(circle.face);
      const PartSurface& axis = surface_of(part, face);
      const Vec3 point = axis.origin + glm::dot(at - axis.origin, axis.axis) * axis.axis;
      const Vec3 out = surfaces::normal_near(drawn, point), around = glm::cross(drawn.axis, out);
      statement.rows.push_back(
          difference(unknowns.axis_motion(face, point, out), unknowns.surface_motion(circle.face, point, out)));
      if (!circle.is_even) continue;
      const Row turned =
          difference(unknowns.axis_motion(face, point, around), unknowns.axis_motion(circle.face, at, around));
      if (first.empty())
        first = turned;
      else
        statement.rows.push_back(difference(turned, first));
    }
    if (circle.is_even) add_to_centre_line(on_lines, circle, first, part, marks);
  }
  for (std::size_t i = 1; i < on_lines.size(); ++i)
    if (glm::length(glm::cross(on_lines[i].first, on_lines[0].first)) <= drawn_parallel) {
      const double sense = glm::dot(on_lines[i].first, on_lines[0].first) < 0 ? -1 : 1;
      Row row = on_lines[i].second;
      add(row, on_lines[0].second, -sense);
      statement.rows.push_back(tidy(std::move(row)));
    }
  for (const EvenAxes& even : marks.even_axes)
    for (std::size_t i = 1; i < even.axes.size(); ++i) {
      const Vec3& about = surface_of(part, even.about).axis;
      statement.rows.push_back(difference(unknowns.turn(even.axes[i], about), unknowns.turn(even.axes.front(), about)));
    }
}

// Its sides keep their angles and touch one circle.
void state_regular(const Part& part, const Directions&, const Unknowns& unknowns, const Marks& marks,
                   Statement& statement) {
  for (const Hexagon& hexagon : marks.hexagons) {
    const PartSurface& circle = surface_of(part, hexagon.face);
    for (const int side : hexagon.sides) {
      const Vec3& normal = surface_of(part, side).axis;
      const Vec3 at = circle.origin + glm::dot(unknowns.anchor(side) - circle.origin, normal) * normal;
      statement.rows.push_back(
          difference(unknowns.turn(side, circle.axis), unknowns.turn(hexagon.sides.front(), circle.axis)));
      statement.rows.push_back(
          difference(unknowns.surface_motion(side, at, normal), unknowns.surface_motion(hexagon.face, at, normal)));
    }
  }
}

// Which ones are equal, the dimension says (with_counts).
void state_equal(const Part&, const Directions&, const Unknowns&, const Marks&, Statement&) {}

constexpr const char *iso_sizes = "ISO 129-1", *iso_lines = "ISO 128-2";
constexpr const char* asme = "ASME Y14.5";

constexpr std::array<Rule, rule_count> rules{{
    {"parallel", "lines that are drawn parallel", {nullptr, iso_sizes, asme}, state_parallel},
    {"perpendicular", "lines that are drawn at right angles", {nullptr, iso_sizes, asme}, state_perpendicular},
    {"in-line", "faces and centre lines that are drawn as one line", {nullptr, iso_sizes, asme}, state_in_line},
    {"coaxial", "a common centre line", {nullptr, iso_lines, asme}, state_coaxial, true},
    {"crossing", "centre lines that cross", {nullptr, iso_lines, asme}, state_crossing, true},
    {"same", "a round outline that something interrupts", {nullptr, iso_sizes, asme}, state_same},
    {"drilled", "the point of a blind hole", {nullptr, iso_sizes, asme}, state_drilled},
    {"tangent", "an outline that turns without a corner", {nullptr, iso_sizes, asme}, state_tangent},
    {"symmetric", "a line of symmetry", {nullptr, iso_lines, asme}, state_symmetric, true},
    {"on-circle", "a pitch circle, or axes about another one", {nullptr, iso_sizes, asme}, state_on_circle, true},
    {"regular", "a hexagon with equal sides", {nullptr, iso_sizes, asme}, state_regular},
    {"equal", "a number of equal features, as 4×", {nullptr, iso_sizes, asme}, state_equal},
}};

}  // namespace

std::span<const Rule, rule_count> all_rules() { return rules; }

RuleSet rules_of(Standard standard) {
  RuleSet applied;
  for (std::size_t i = 0; i < rule_count; ++i)
    applied[i] = rules[i].clause[static_cast<std::size_t>(standard)] != nullptr;
  return applied;
}

std::vector<Statement> with_counts(std::vector<Statement> dimensions, const RuleSet& applied) {
  for (std::size_t i = 0; i < rule_count; ++i)
    if (rules[i].state == state_equal && !applied[i])
      for (Statement& one : dimensions)
        if (one.is_by_count) one.rows.clear();
  return dimensions;
}

std::vector<Statement> state_rules(const Part& part, const Directions& directions, const Unknowns& unknowns,
                                   const Marks& marks, const RuleSet& applied) {
  std::vector<Statement> statements;
  for (std::size_t i = 0; i < rule_count; ++i) {
    if (!applied[i] || (rules[i].is_by_centre_lines && !marks.has_centre_lines)) continue;
    statements.push_back({rules[i].name, {}});
    rules[i].state(part, directions, unknowns, marks, statements.back());
  }
  return statements;
}

}  // namespace epura::definition
