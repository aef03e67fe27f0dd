// SPDX-License-Identifier: Apache-2.0
#include "sizes/free_face_dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "definition/limits.hpp"
#include "definition/words.hpp"
#include "features/tolerances.hpp"
#include "sizes/face_dimensions.hpp"

namespace epura::sheet {

namespace {

using definition::Motion;
using definition::Row;
using scene::DimensionDescription;

double largest_of(const Row& row) {
  double largest = 0;
  for (const definition::Term& term : row) largest = std::max(largest, std::abs(term.factor));
  return largest;
}

// Both are tidy.
double product(const Row& a, const Row& b) {
  double sum = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->unknown == j->unknown) sum += i->factor * j->factor;
    const bool both = i->unknown == j->unknown, first = i->unknown < j->unknown;
    if (both || first) ++i;
    if (both || !first) ++j;
  }
  return sum;
}

// Whether a row forbids a motion.
bool forbids(const Row& row, const Motion& motion) {
  double squares = 0;
  for (const definition::Term& term : row) squares += term.factor * term.factor;
  return std::abs(product(row, motion.change)) >
         definition::seen_at_all * std::sqrt(squares) * largest_of(motion.change);
}

// By face: whether it is one of so many equal planes, as the flanks of teeth or of a knurl, that a view has no room for
// a dimension of each. Some of them lean against the axes of the world.
std::vector<char> faces_in_patterns(const DrawnPart& drawn) {
  std::vector<std::pair<double, std::size_t>> planes;  // by area
  for (std::size_t face = 0; face < drawn.faces; ++face)
    if (const definition::Face& one = drawn.part.faces[face]; one.surface.kind == surfaces::SurfaceKind::plane)
      planes.emplace_back(one.area, face);
  std::sort(planes.begin(), planes.end());
  std::vector<char> found(drawn.faces, 0);
  for (std::size_t first = 0, last = 0; first < planes.size(); first = last) {
    bool any_askew = false;
    for (; last < planes.size() && features::are_same(planes[last].first, planes[first].first); ++last)
      any_askew = any_askew || features::axis_along(drawn.part.faces[planes[last].second].surface.axis) < 0;
    for (std::size_t i = first; i < last && any_askew && last - first > max_parallel; ++i) found[planes[i].second] = 1;
  }
  check(planes.size() <= found.size(), "a plane is a face");
  return found;
}

// Motions that are still free, and the dimensions that take them away.
class Completion {
 public:
  Completion(const Planning& plan, const SheetReading& reading, std::vector<Motion> motions)
      : plan_(plan),
        reading_(reading),
        faces_(plan, reading),
        in_pattern_(faces_in_patterns(reading.drawn)),
        coordinates_(plan.subject, plan.datums, plan.table.round_ends, plan.views.all()),
        motions_(std::move(motions)) {}

  FreeFaceDimensions find() {
    Planned planned;
    std::size_t given_up = 0;
    while (given_up < motions_.size()) {
      const std::size_t before = motions_.size();
      if (std::optional<Planned> one = dimension_against(motions_[given_up])) {
        planned.append(std::move(*one));
        check(motions_.size() < before, "each dimension takes a motion away");
      } else {
        ++given_up;
      }
    }
    return {std::move(planned), motions_.empty()};
  }

 private:
  // The cheapest one; takes away what it forbids. One of a pattern is left out.
  std::optional<Planned> dimension_against(const Motion& motion) {
    check(!motion.change.empty(), "a motion changes something");
    std::vector<std::pair<FaceDimension, int>> all;
    for (const int face : faces_of(motion))
      for (FaceDimension& one : faces_.of(face)) all.emplace_back(std::move(one), face);
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.first.measure < b.first.measure; });
    for (auto& [one, face] : all) {
      const std::vector<Row> rows = rows_of(one.planned);
      if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return forbids(row, motion); })) continue;
      for (const Row& row : rows) take_away(row);
      if (in_pattern_[static_cast<std::size_t>(face)] == 0) return std::move(one.planned);
      return Planned{.omitted = {.too_many = {{view_of(one.planned), 1}}}};
    }
    return std::nullopt;
  }

  static std::string view_of(const Planned& one) {
    return one.dimensions.empty() ? std::get<Coordinate>(one.places.front()).view->name : *one.dimensions.front().view;
  }

  // The largest ones that move, and those that keep still beside them: to these the distance changes.
  [[nodiscard]] std::vector<int> faces_of(const Motion& motion) const {
    constexpr std::size_t most = 8;  // of each
    std::vector<int> faces, still;
    for (const int face : motion.faces)
      if (static_cast<std::size_t>(face) < reading_.drawn.faces) faces.push_back(face);
    std::stable_sort(faces.begin(), faces.end(), [&](int a, int b) {
      const std::vector<definition::Face>& all = reading_.drawn.part.faces;
      return all[static_cast<std::size_t>(a)].area >
             all[static_cast<std::size_t>(b)].area * (1 + definition::same_size);
    });
    faces.resize(std::min(faces.size(), most));
    const auto has = [](const std::vector<int>& list, int face) {
      return std::find(list.begin(), list.end(), face) != list.end();
    };
    for (const int face : faces)
      for (const int other : faces_.beside(face))
        if (still.size() < most && !has(motion.faces, other) && !has(still, other)) still.push_back(other);
    faces.insert(faces.end(), still.begin(), still.end());
    check(faces.size() <= 2 * most, "a motion has as many faces as are asked for");
    return faces;
  }

  // What a reader finds in it for certain.
  [[nodiscard]] std::vector<Row> rows_of(const Planned& planned) const {
    std::vector<DimensionDescription> dimensions = planned.dimensions;
    for (const auto& place : planned.places)
      if (const auto* coordinate = std::get_if<Coordinate>(&place))
        if (auto one = coordinates_.distance_to(*coordinate, plan_.wanted.where)) dimensions.push_back(std::move(*one));
    if (dimensions.empty()) return {};
    const std::vector<const NamedProjection*>& all = plan_.views.all();
    const auto view = std::find_if(all.begin(), all.end(),
                                   [&](const NamedProjection* one) { return one->name == *dimensions.front().view; });
    if (view == all.end()) return {};
    const DimensionsInView in_view{(*view)->name, (*view)->projection, find_anchors(plan_.subject.world, dimensions),
                                   std::nullopt};
    const FaceStatements said =
        state_dimensions({&in_view, 1}, reading_.drawn, reading_.directions, reading_.unknowns, plan_.notation);
    check(said.of.size() == said.statements.size(), "each statement is that of a dimension");
    std::vector<Row> rows;
    for (const definition::Statement& one : said.statements)
      if (one.is_certain)
        for (const Row& row : one.rows) rows.push_back(definition::tidy(row));
    return rows;
  }

  void take_away(const Row& row) {
    const auto first =
        std::find_if(motions_.begin(), motions_.end(), [&](const Motion& one) { return forbids(row, one); });
    if (first == motions_.end()) return;
    const Motion taken = std::move(*first);
    motions_.erase(first);
    const double along = product(row, taken.change);
    for (Motion& other : motions_)
      if (const double more = product(row, other.change); more != 0) {
        definition::add(other.change, taken.change, -more / along);
        other.change = definition::tidy(std::move(other.change));
        set_faces(other);
      }
  }

  void set_faces(Motion& motion) const {
    motion.faces.clear();
    const double least = definition::moves * largest_of(motion.change);
    for (const definition::Term& term : motion.change)
      if (const int face = reading_.unknowns[term.unknown].face;
          std::abs(term.factor) > least && (motion.faces.empty() || motion.faces.back() != face))
        motion.faces.push_back(face);
  }

  const Planning& plan_;
  const SheetReading& reading_;
  FaceDimensions faces_;
  std::vector<char> in_pattern_;
  Coordinates coordinates_;
  std::vector<Motion> motions_;
};

}  // namespace

FreeFaceDimensions dimensions_of_free_faces(const Planning& plan, std::span<const DimensionsInView> views) {
  std::optional<DrawnPart> drawn = part_on_sheets(views, plan.subject.world, plan.subject.extents);
  if (!drawn || drawn->faces > most_faces_planned) return {};
  const SheetReading reading(std::move(*drawn), views, plan.notation);
  if (!reading.said.unread.empty()) return {};
  definition::Account account = reading.account(definition::rules_of(definition::Standard::iso));
  if (account.motions.empty() || account.motions.size() > max_of_a_kind) return {};
  return Completion(plan, reading, std::move(account.motions)).find();
}

}  // namespace epura::sheet
