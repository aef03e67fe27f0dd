// SPDX-License-Identifier: Apache-2.0
#include "sizes/face_statements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/feature_table.hpp"
#include "sizes/measured_faces.hpp"
#include "sizes/noted_faces.hpp"
#include "sizes/place_joins.hpp"
#include "sizes/stated_values.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

using definition::End;
using definition::Row;
using definition::Statement;
using definition::UnknownKind;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

// One thing that a number in a text may mean: it determines one of two from the other. -1: what is fixed.
struct Candidate {
  Row row;
  int one, other;
};

// How many independent things candidates determine.
int rank_of(const std::vector<Candidate>& candidates, int count) {
  DisjointSets sets(static_cast<std::size_t>(count) + 1);
  int rank = 0;
  for (const Candidate& candidate : candidates)
    if (const int one = sets.root(candidate.one + 1), other = sets.root(candidate.other + 1); one != other) {
      sets.join(one, other);
      ++rank;
    }
  return rank;
}

// To an axis of the world.
bool is_at_45_degrees(const PartSurface& surface) {
  if (surface.kind == SurfaceKind::cone) return std::abs(std::abs(surface.slope) - 1) <= size_agrees;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(std::abs(surface.axis[axis]) - std::sqrt(0.5)) <= size_agrees) return true;
  return false;
}

class Reader {
 public:
  Reader(const DrawnPart& drawn, const definition::Directions& directions, const definition::Unknowns& unknowns,
         const Notation& notation)
      : part_(drawn.part),
        count_(drawn.faces),
        directions_(directions),
        unknowns_(unknowns),
        notation_(notation),
        measured_(drawn, directions, unknowns, notation),
        noted_(drawn, unknowns, measured_),
        slack_(slack_of(drawn.part)) {}

  FaceStatements read(std::span<const DimensionsInView> views) {
    find_measured(views);
    for (std::size_t view = 0; view < views.size(); ++view)
      for (std::size_t i = 0; i < views[view].dimensions.size(); ++i)
        if (const AnchoredDimension& dimension = views[view].dimensions[i]; !is_auxiliary(dimension)) {
          read_one(dimension, views[view], {view, i});
          found_.of.resize(found_.statements.size(), {view, i});
        }
    return std::move(found_);
  }

 private:
  struct OwnCircle {
    WorldCircle circle;
    DimensionPlace of;
  };

  [[nodiscard]] const PartSurface& surface(int face) const {
    return part_.faces[static_cast<std::size_t>(face)].surface;
  }
  [[nodiscard]] int all_faces() const { return static_cast<int>(part_.faces.size()); }

  // Circles that have a dimension of their own.
  void find_measured(std::span<const DimensionsInView> views) {
    for (std::size_t view = 0; view < views.size(); ++view)
      for (std::size_t i = 0; i < views[view].dimensions.size(); ++i)
        if (const AnchoredDimension& one = views[view].dimensions[i]; !is_auxiliary(one))
          for (const WorldCircle& circle : one.circles) own_circles_.push_back({circle, {view, i}});
  }

  // Whether a face, of equal ones that are more than a dimension counts, has one of its own.
  [[nodiscard]] bool is_measured_elsewhere(int face, const DimensionPlace& place) const {
    return std::ranges::any_of(own_circles_, [&](const OwnCircle& one) {
      return one.of != place && measured_.is_around(face, one.circle) &&
             measured_.are_alike(surface(face).radius, one.circle.radius);
    });
  }

  void read_one(const AnchoredDimension& dimension, const DimensionsInView& view, const DimensionPlace& place) {
    const std::size_t before = found_.statements.size();
    if (!gives_size(dimension, view, notation_)) {
      found_.unread.push_back(place);
      return;
    }
    switch (dimension.type) {
      case DimensionType::overall:
        read_overall(dimension);
        break;
      case DimensionType::linear:
      case DimensionType::aligned:
        read_length(dimension, view);
        break;
      case DimensionType::angular:
        read_angle(dimension);
        break;
      case DimensionType::radius:
      case DimensionType::diameter:
        read_circle(dimension, place);
        if (!dimension.circles.empty()) read_note(with_row(dimension, view), view.projection.n);
        break;
      default:
        break;
    }
    check(found_.statements.size() >= before, "no dimension takes back what another one says");
    if (found_.statements.size() == before) {
      // The exact place of a tolerance zone or a datum target is none of a face.
      if (!dimension.is_exact) found_.unread.push_back(place);
    } else if (const std::optional<StatedSize> size = stated_size(dimension, view, notation_)) {
      state_text(found_.statements[before], *size, dimension, view);
    }
  }

  // What its text says of the statement that a dimension makes first.
  void state_text(Statement& statement, const StatedSize& size, const AnchoredDimension& dimension,
                  const DimensionsInView& view) const {
    double factor = 1 / part_.size;
    if (dimension.type == DimensionType::diameter) factor /= 2;
    if (dimension.type == DimensionType::angular) factor = -1 / degrees;
    if (const std::optional<Vec3> along = measured_along(dimension, view))
      factor = std::copysign(factor, glm::dot(dimension.points[1] - dimension.points[0], *along));
    statement.more = factor * (size.stated - size.measured);
    statement.slack = std::abs(factor) * size.slack;
  }

  void say(std::vector<Row> rows, bool is_certain = true) {
    std::erase_if(rows, [](const Row& row) { return row.empty(); });
    if (!rows.empty()) found_.statements.push_back({"", std::move(rows), is_certain});
  }

  void say_by_count(std::vector<Row> rows, bool is_certain) {
    const std::size_t before = found_.statements.size();
    say(std::move(rows), is_certain);
    for (std::size_t i = before; i < found_.statements.size(); ++i) found_.statements[i].is_by_count = true;
  }

  // Of "3×": for certain if there are no more than three things that it can mean.
  void say_one_of(std::vector<Candidate> candidates, int repeats) {
    const bool is_certain = rank_of(candidates, all_faces()) <= repeats;
    std::vector<Row> rows;
    for (Candidate& candidate : candidates) rows.push_back(definition::tidy(std::move(candidate.row)));
    say_by_count(std::move(rows), is_certain);
  }

  void read_overall(const AnchoredDimension& dimension) {
    const Vec3 along = Mat3(1)[axis_of(*dimension.direction)];
    std::vector<Row> rows = measured_.lengths(dimension.points[0], dimension.points[1], along);
    if (rows.empty() && dimension.form == features::ExtentForm::diameter) rows = widest_rims(dimension, along);
    say(std::move(rows));
  }

  // The rims in line whose diameter an overall size is, of cones about an axis across it: at no corner of the part.
  [[nodiscard]] std::vector<Row> widest_rims(const AnchoredDimension& dimension, const Vec3& along) const {
    const Vec3 from = dimension.points[0], middle = (from + dimension.points[1]) / 2.0;
    std::vector<Row> rows;
    for (const WorldCircle& rim : measured_.rims_of_cones(std::abs(glm::dot(middle - from, along))))
      if (std::abs(glm::dot(rim.axis, along)) <= features::parallel &&
          std::abs(glm::dot(rim.centre - middle, along)) <= slack_)
        rows.push_back(measured_.rim(rim));
    return rows;
  }

  void read_length(const AnchoredDimension& dimension, const DimensionsInView& view) {
    const std::optional<Vec3> along = measured_along(dimension, view);
    if (!along) return;
    const std::vector<Vec3>& points = dimension.points;
    std::vector<Row> rows;
    const bool is_chain = dimension.arrangement && *dimension.arrangement == DimensionArrangement::chain;
    std::vector<Vec3> places = points;
    if (is_chain)
      std::sort(places.begin(), places.end(),
                [&](const Vec3& a, const Vec3& b) { return glm::dot(a - b, *along) < 0; });
    for (std::size_t i = 1; i < places.size(); ++i)
      rows.push_back(measured_.length(places[is_chain ? i - 1 : 0], places[i], *along));
    check(rows.size() + 1 == places.size(), "each place after the first one is measured");
    const int repeats = repeats_of(dimension.text);
    if (repeats > 1 && dimension.text.find('=') != std::string::npos)
      for (int i = 1; i < repeats; ++i)
        rows.push_back(measured_.length(points[0], points[0] + double(i) / repeats * (points[1] - points[0]), *along));
    say(std::move(rows));
    if (dimension.text.find("45°") != std::string::npos) say_chamfer(dimension, *along, view.projection.n);
    if (dimension.text.find("45°") != std::string::npos ||
        (repeats > 1 && dimension.text.find('=') == std::string::npos))
      say_of_equal_lengths(dimension, *along);
  }

  // The note of a chamfer gives the length, and the angle to it.
  void say_chamfer(const AnchoredDimension& dimension, const Vec3& along, const Vec3& sight) {
    Row row = measured_.turn_of_leg(dimension.points[0], dimension.points[1], sight);
    const int fixed = measured_.face_along(along);
    if (row.empty() || fixed < 0) return;
    definition::add(row, unknowns_.turn(fixed, sight), -1);
    say({definition::tidy(std::move(row))});
  }

  // Lengths of the same value, and slopes between them, wherever they are: as "4×" may say.
  void say_of_equal_lengths(const AnchoredDimension& dimension, const Vec3& measured) {
    const double value = std::abs(glm::dot(dimension.points[1] - dimension.points[0], measured));
    std::vector<Row> rows;
    const bool is_chamfer = dimension.text.find("45°") != std::string::npos;
    int sloped = 0;
    for (int face = 0; face < static_cast<int>(count_); ++face) {
      const PartSurface& one = surface(face);
      if (one.kind != SurfaceKind::plane && one.kind != SurfaceKind::cone) continue;
      if (is_chamfer && !is_at_45_degrees(one)) continue;
      std::vector<Vec3> points;  // not at corners, which other faces of the kind may hold as well
      for (const definition::Contact& contact : part_.contacts)
        if (contact.faces[0] == face || contact.faces[1] == face) {
          const bool is_straight = std::all_of(contact.faces.begin(), contact.faces.end(),
                                               [&](int other) { return surface(other).kind == SurfaceKind::plane; });
          points.push_back(is_straight ? surfaces::mean_of(contact.points) : contact.points.front());
        }
      const std::size_t before = rows.size();
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t i = 1; i < points.size() && measured_.face_along(Mat3(1)[axis]) >= 0; ++i)
          for (std::size_t j = 0; j < i; ++j)
            if (agree(std::abs(points[i][axis] - points[j][axis]), value))
              rows.push_back(measured_.length(points[j], points[i], Mat3(1)[axis]));
      if (rows.size() == before) continue;
      add_turns(rows, face);
      ++sloped;
    }
    say_by_count(std::move(rows), is_chamfer && sloped <= repeats_of(dimension.text));
    if (is_chamfer) return;
    say_of_equal_widths(dimension, value);
    say_of_equal_distances(dimension, value);
  }

  // Of parallel axes.
  void say_of_equal_distances(const AnchoredDimension& dimension, double distance) {
    std::vector<Candidate> found;
    for (int face = 0; face < static_cast<int>(count_); ++face)
      for (int other = 0; other < face; ++other) {
        if (surface(face).kind != SurfaceKind::cylinder || surface(other).kind != SurfaceKind::cylinder ||
            !features::are_parallel(surface(face).axis, surface(other).axis))
          continue;
        const Vec3 &axis = surface(face).axis, &from = unknowns_.anchor(other);
        const Vec3 off = unknowns_.anchor(face) - from, across = off - glm::dot(off, axis) * axis;
        if (!agree(glm::length(across), distance)) continue;
        found.push_back(
            {definition::length(unknowns_, part_, {End{from, {other}, true}, End{from + across, {face}, true}},
                                glm::normalize(across), -1),
             measured_.axis_through(from + across, axis), measured_.axis_through(from, axis)});
      }
    check(std::all_of(found.begin(), found.end(), [](const Candidate& one) { return one.one != one.other; }),
          "a distance is between two axes");
    say_one_of(std::move(found), repeats_of(dimension.text));
  }

  // Equal widths of turned rectangles and hexagons. Where each of these is, their centre lines may say.
  void say_of_equal_widths(const AnchoredDimension& dimension, double width) {
    std::vector<Candidate> widths;
    std::vector<Row> places;
    for (int face = 0; face < static_cast<int>(count_); ++face)
      for (int other = 0; other < face; ++other) {
        const Vec3& normal = surface(face).axis;
        const bool is_turned =
            std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}) < 1 - features::parallel;
        if (!is_turned || surface(face).kind != SurfaceKind::plane || surface(other).kind != SurfaceKind::plane ||
            directions_.of_face[static_cast<std::size_t>(face)] != directions_.of_face[static_cast<std::size_t>(other)])
          continue;
        const Vec3 &from = unknowns_.anchor(other), &to = unknowns_.anchor(face);
        const double off = glm::dot(to - from, normal);
        if (!agree(std::abs(off), width)) continue;
        const int hexagon = measured_.hexagon_of(face, other);  // whose three widths are one
        widths.push_back({definition::length(unknowns_, part_, {End{from, {other}}, End{to, {face}}}, normal, -1),
                          hexagon < 0 ? face : hexagon, hexagon < 0 ? other : -1});
        for (const int side : {face, other})
          places.push_back(unknowns_.surface_motion(side, unknowns_.anchor(side), surface(side).axis));
      }
    check(places.size() == 2 * widths.size(), "each width has two sides");
    if (widths.size() < 2) return;
    say_one_of(std::move(widths), repeats_of(dimension.text));
    say_by_count(std::move(places), false);
  }

  // A label stands for what its row in a table says.
  static AnchoredDimension with_row(AnchoredDimension dimension, const DimensionsInView& view) {
    const auto row = view.sizes_in_tables.find(dimension.text);
    if (dimension.is_label && row != view.sizes_in_tables.end()) dimension.text = row->second;
    return dimension;
  }

  // What a table may say of a hole beside its place: sizes and depths around its axis.
  void say_by_table(const WorldCircle& circle) {
    std::vector<Row> rows;
    for (int face = 0; face < static_cast<int>(count_); ++face)
      for (const UnknownKind size : {UnknownKind::radius, UnknownKind::angle})
        if (measured_.is_around(face, circle)) rows.push_back(unknowns_.growth(face, size));
    const std::vector<Vec3> rims = measured_.rims_around(circle);
    for (const Vec3& rim : rims) rows.push_back(measured_.length(rims.front(), rim, circle.axis));
    say(std::move(rows), false);
  }

  // All angles of a face.
  void add_turns(std::vector<Row>& rows, int face) const {
    for (int axis = 0; axis < 3; ++axis) {
      Row row = unknowns_.turn(face, Mat3(1)[axis]);
      const int fixed = measured_.face_along(Mat3(1)[(axis + 1) % 3]);
      if (fixed < 0) continue;
      definition::add(row, unknowns_.turn(fixed, Mat3(1)[axis]), -1);
      rows.push_back(definition::tidy(std::move(row)));
    }
    rows.push_back(unknowns_.growth(face, UnknownKind::angle));
  }

  void read_angle(const AnchoredDimension& dimension) {
    const std::vector<Vec3>& at = dimension.points;
    const Vec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
    if (!(glm::length(across) > 0)) return;
    const Vec3 sight = glm::normalize(across);
    Row row = measured_.turn_of_leg(at[0], at[1], sight);
    const Row other = measured_.turn_of_leg(at[0], at[2], sight);
    if (!row.empty() && !other.empty()) {
      definition::add(row, other, -1);
      say({definition::tidy(std::move(row))});
    }
    if (const int repeats = repeats_of(dimension.text); repeats > 1) {
      const double cosine = glm::dot(glm::normalize(at[1] - at[0]), glm::normalize(at[2] - at[0]));
      say_one_of(equal_angles(std::acos(cosine), sight, repeats), repeats);
      say_one_of(equal_angles_about(dimension, sight, std::acos(cosine)), repeats);
    }
  }

  // Between directions of faces, of which those along the axes of the world are square to each other; of cones. Those
  // that are seen in their true size with the text, if that is how many it means.
  [[nodiscard]] std::vector<Candidate> equal_angles(double angle, const Vec3& sight, int repeats) const {
    const auto is_it = [&](double one) { return std::abs(one - angle) <= size_agrees; };
    std::vector<Candidate> found, seen;
    for (std::size_t i = 0; i < directions_.directions.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vec3 &a = directions_.directions[i], &b = directions_.directions[j];
        const double between = std::acos(std::clamp(std::abs(glm::dot(a, b)), 0.0, 1.0));
        if (!is_it(between) && !is_it(full_turn / 4 - between) && !is_it(full_turn / 2 - between)) continue;
        const Vec3 about = glm::normalize(glm::cross(a, b));
        Row row = unknowns_.turn(directions_.first_face[i], about);
        definition::add(row, unknowns_.turn(directions_.first_face[j], about), -1);
        const auto body = [&](std::size_t k) {
          return features::axis_along(directions_.directions[k]) >= 0 ? -1 : directions_.first_face[k];
        };
        if (body(i) == body(j)) continue;
        found.push_back({std::move(row), std::max(body(i), body(j)), std::min(body(i), body(j))});
        if (features::are_parallel(about, sight)) seen.push_back(found.back());
      }
    for (int face = 0; face < all_faces(); ++face) {
      const double half = std::atan(std::abs(surface(face).slope));
      if (surface(face).kind == SurfaceKind::cone && (is_it(half) || is_it(2 * half) || is_it(full_turn / 4 - half)))
        found.push_back({unknowns_.growth(face, UnknownKind::angle), face, -1});
    }
    check(std::all_of(found.begin(), found.end(), [](const Candidate& one) { return one.one != one.other; }),
          "an angle is between two");
    return rank_of(seen, all_faces()) == repeats ? seen : found;
  }

  // Between axes on one circle, and from these to centre lines.
  [[nodiscard]] std::vector<Candidate> equal_angles_about(const AnchoredDimension& dimension, const Vec3& sight,
                                                          double angle) const {
    const Vec3& corner = dimension.points[0];
    const double radius = glm::distance(corner, dimension.points[2]);
    std::vector<int> axes;
    std::vector<Vec3> legs;
    for (int face = 0; face < static_cast<int>(count_); ++face) {
      const PartSurface& one = surface(face);
      if (one.kind != SurfaceKind::cylinder || !features::are_parallel(one.axis, sight)) continue;
      const Vec3 off = one.origin - corner, across = off - glm::dot(off, sight) * sight;
      if (std::abs(glm::length(across) - radius) > slack_ || measured_.axis_through(corner + across, sight) != face)
        continue;
      axes.push_back(face);
      legs.push_back(across);
    }
    check(axes.size() == legs.size(), "each axis has its leg");
    const std::size_t count = axes.size();
    const Vec3 first = glm::normalize(dimension.points[1] - corner);
    for (const Vec3& fixed : {first, -first, glm::cross(sight, first), -glm::cross(sight, first)}) {
      if (measured_.face_along(fixed) < 0) continue;
      legs.push_back(radius * fixed);
      // An axis on a centre line is where that is.
      for (std::size_t i = 0; i < count; ++i)
        if (glm::distance(legs[i], legs.back()) <= slack_) axes[i] = -1;
    }
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < legs.size(); ++j) {
        const double cosine = glm::dot(glm::normalize(legs[i]), glm::normalize(legs[j]));
        if (std::abs(std::acos(std::clamp(cosine, -1.0, 1.0)) - angle) > size_agrees) continue;
        Row row = measured_.turn_of_leg(corner, corner + legs[i], sight);
        const Row other = measured_.turn_of_leg(corner, corner + legs[j], sight);
        if (row.empty() || other.empty()) continue;
        definition::add(row, other, -1);
        found.push_back({std::move(row), axes[i], j < count ? axes[j] : -1});
      }
    return found;
  }

  // The radii of faces around a circle, and of others that its dimension may mean: of fillets only if it is of one.
  struct Radii {
    std::vector<Row> own, equal;
    std::vector<int> lines;  // the first faces of axes with that direction
  };

  [[nodiscard]] Radii radii_of(const AnchoredDimension& dimension, const DimensionPlace& place,
                               bool with_measured) const {
    Radii found;
    const std::vector<WorldCircle> others = circles_left_out(dimension);
    for (const WorldCircle& circle : dimension.circles) {
      const bool with_parts = dimension.type == DimensionType::radius || noted_.is_of_part(circle);
      for (int face = 0; face < all_faces(); ++face) {
        Row row = measured_.size(face, circle.radius);
        const auto is_around = [&](const WorldCircle& one) { return measured_.is_around(face, one); };
        const bool is_own = is_around(circle);
        if (row.empty() || std::ranges::any_of(others, is_around)) continue;
        if (!is_own &&
            ((!with_parts && noted_.is_part(face)) || (!with_measured && is_measured_elsewhere(face, place))))
          continue;
        // A dimension of a radius gives those of all fillets that are equal on paper.
        (is_own ? found.own : found.equal).push_back(std::move(row));
        if (!features::are_parallel(surface(face).axis, circle.axis)) continue;
        if (const int line = measured_.axis_through(unknowns_.anchor(face), circle.axis);
            std::find(found.lines.begin(), found.lines.end(), line) == found.lines.end())
          found.lines.push_back(line);
      }
    }
    check(found.lines.size() <= part_.faces.size(), "each axis counts once");
    return found;
  }

  void read_circle(const AnchoredDimension& dimension, const DimensionPlace& place) {
    const int repeats = repeats_of(dimension.text);
    Radii radii = radii_of(dimension, place, true);
    if (static_cast<int>(radii.lines.size()) > repeats) radii = radii_of(dimension, place, false);
    auto& [own, equal, lines] = radii;
    for (const WorldCircle& circle : dimension.circles) {
      Row rim = measured_.rim(circle);
      for (definition::Term& term : rim) term.factor /= 2;  // as that of a radius
      own.push_back(std::move(rim));
      if (dimension.is_label)
        for (int axis = 0; axis < 3; ++axis)
          if (std::abs(circle.axis[axis]) <= features::parallel) say_place(circle.centre, axis);
    }
    say(std::move(own));
    if (dimension.is_label)
      for (const WorldCircle& circle : dimension.circles) say_by_table(circle);
    const bool is_radius = dimension.type == DimensionType::radius;
    if (repeats > 1) say_equal_rims(dimension.circles.front(), repeats);
    if (is_radius || repeats > 1) say_by_count(std::move(equal), static_cast<int>(lines.size()) <= repeats);
  }

  // Of cones along parallel axes, for "3×".
  void say_equal_rims(const WorldCircle& circle, int repeats) {
    std::vector<Row> rows;
    for (const WorldCircle& rim : measured_.rims_of_cones(circle.radius))
      if (features::are_parallel(rim.axis, circle.axis)) rows.push_back(measured_.rim(rim));
    const bool is_certain = static_cast<int>(rows.size()) <= repeats;
    say_by_count(std::move(rows), is_certain);
  }

  // A table gives places from one end of the models, where a plane or the axis of the whole is.
  void say_place(const Vec3& centre, int axis) {
    const Vec3 along = Mat3(1)[axis];
    std::optional<Vec3> from;
    for (std::size_t i = 0; i < count_; ++i)
      if (const PartSurface& one = part_.faces[i].surface; one.kind == SurfaceKind::plane &&
                                                           features::are_parallel(one.axis, along) &&
                                                           (!from || (*from)[axis] > one.origin[axis]))
        from = one.origin;
    if (from) say({measured_.length(*from, centre, along)});
  }

  // What stands behind a diameter: depths, counterbores, countersinks and threads of faces around the axis, and for
  // "4×" around all axes with the same circle. Nothing else than its size tells which face a number means; of circles
  // of one diameter, a note means those that have all its numbers.
  void read_note(const AnchoredDimension& dimension, const Vec3& sight) {
    const std::vector<NotedNumber> numbers = noted_numbers(dimension.text, notation_);
    const bool is_thread = gives_thread(dimension.text, notation_);
    std::vector<WorldCircle> circles = noted_.equal_circles(dimension, is_thread);
    std::vector<WorldCircle> meant = noted_.with_all(circles, numbers);
    check(meant.size() <= circles.size(), "a note means some of the circles of its size");
    if (!meant.empty()) circles = std::move(meant);
    for (WorldCircle& one : circles)
      if (glm::dot(one.axis, sight) < 0) one.axis = -one.axis;
    std::vector<Statement> of_others;
    for (const NotedNumber& number : numbers)
      for (Statement& one : say_number(number, circles, sight, repeats_of(dimension.text)))
        of_others.push_back(std::move(one));
    for (Statement& one : of_others) say_by_count(std::move(one.rows), one.is_certain);
    for (const WorldCircle& one : circles)
      if (is_thread) say(noted_.thread(one), static_cast<int>(circles.size()) <= repeats_of(dimension.text));
  }

  // For certain if it means one thing around each circle, or as many as there are, as of holes from both sides; of
  // fewer, in a view along them, those that are nearer to the viewer. What it says of circles after the first one.
  std::vector<Statement> say_number(const NotedNumber& number, std::span<const WorldCircle> circles, const Vec3& sight,
                                    int repeats) {
    std::vector<Statement> of_others;
    std::vector<std::vector<Row>> meant;
    std::size_t count = 0;
    for (const WorldCircle& one : circles) count += meant.emplace_back(noted_.rows_of(number, one)).size();
    check(meant.size() == circles.size(), "a number means something around each circle");
    const bool are_all = static_cast<int>(circles.size()) <= repeats;
    for (std::size_t i = 0; i < meant.size(); ++i) {
      if (static_cast<int>(count) > repeats && number.kind == NumberKind::depth && meant[i].size() > 1 &&
          features::are_parallel(circles[i].axis, sight))
        meant[i].resize(1);
      const bool is_certain = are_all && (meant[i].size() == 1 || static_cast<int>(count) <= repeats);
      if (i == 0) say(std::move(meant[i]), is_certain);
      if (i > 0) of_others.push_back({"", std::move(meant[i]), is_certain});
    }
    return of_others;
  }

  // Those of the same size that a note cannot mean, by what else it says.
  [[nodiscard]] std::vector<WorldCircle> circles_left_out(const AnchoredDimension& dimension) const {
    if (dimension.type != DimensionType::diameter || repeats_of(dimension.text) == 1) return {};
    std::vector<WorldCircle> circles = noted_.equal_circles(dimension, gives_thread(dimension.text, notation_));
    const std::vector<WorldCircle> meant = noted_.with_all(circles, noted_numbers(dimension.text, notation_));
    if (meant.empty()) return {};
    std::erase_if(circles, [&](const WorldCircle& one) {
      return std::ranges::any_of(meant, [&](const WorldCircle& other) {
        return features::are_parallel(one.axis, other.axis) &&
               features::distance_from_line(one.centre, other.centre, other.axis) <= slack_;
      });
    });
    return circles;
  }

  const definition::Part& part_;
  std::size_t count_;  // of faces of the model
  const definition::Directions& directions_;
  const definition::Unknowns& unknowns_;
  const Notation& notation_;
  MeasuredFaces measured_;
  NotedFaces noted_;
  double slack_;
  std::vector<OwnCircle> own_circles_;
  FaceStatements found_;
};

}  // namespace

FaceStatements state_dimensions(std::span<const DimensionsInView> views, const DrawnPart& drawn,
                                const definition::Directions& directions, const definition::Unknowns& unknowns,
                                const Notation& notation) {
  return Reader(drawn, directions, unknowns, notation).read(views);
}

}  // namespace epura::sheet
