// SPDX-License-Identifier: Apache-2.0
// Rules that every reader of a sheet applies without a number: each is a row of one table.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <span>
#include <vector>

#include "definition/statements.hpp"

namespace epura::definition {

/// A plane of symmetry: the part has a symmetry line there on the sheet.
struct SymmetryLine {
  int face;                                 ///< of the plane among those of the part, where it is only drawn
  std::vector<std::array<int, 2>> pairs{};  ///< faces that it makes equal
  std::vector<int> axes{};                  ///< of faces, and centres, that lie in it
};

/// A circle through axes, evenly spaced on it.
struct PitchCircle {
  int face;               ///< of the cylinder through the axes, where it is only drawn
  std::vector<int> axes;  ///< of faces
  bool is_even = true;
};

/// Axes that meet another one in one point, at one angle to it, evenly spaced about it.
struct EvenAxes {
  int about;              ///< a face with the other axis
  std::vector<int> axes;  ///< of faces
};

/// A regular hexagon: six planes about an axis.
struct Hexagon {
  int face;  ///< of the cylinder that touches all six, where it is only drawn
  std::vector<int> sides;
};

/// What is on the sheet beside dimensions.
struct Marks {
  std::vector<Vec3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};  ///< of the views: along which lines align,
  std::vector<Vec3> own_axes{};  ///< as along those of a part that is turned in a view
  std::vector<SymmetryLine> symmetries{};
  std::vector<PitchCircle> circles{};
  std::vector<EvenAxes> even_axes{};
  std::vector<Hexagon> hexagons{};
  bool has_centre_lines = true;  ///< without them, nothing shows where axes are
};

/// Whose rules count; `none` for a reader who applies none.
enum class Standard : unsigned char { none, iso, asme };
inline constexpr std::array standard_names{"none", "iso", "asme"};

struct Rule {
  const char* name;
  const char* mark;                   ///< what is on the sheet
  std::array<const char*, 3> clause;  ///< of each standard; null: it has no such rule
  void (*state)(const Part&, const Directions&, const Unknowns&, const Marks&, Statement&);
  bool is_by_centre_lines = false;  ///< its mark is one, or stands on some
};

inline constexpr std::size_t rule_count = 12;
std::span<const Rule, rule_count> all_rules();

/// Rules that readers apply, in the order of all_rules().
using RuleSet = std::bitset<rule_count>;
RuleSet rules_of(Standard standard);

/// What dimensions say where readers apply these: of those by count, nothing without the rule for equal features.
std::vector<Statement> with_counts(std::vector<Statement> dimensions, const RuleSet& applied);

/// What some rules say of a part, one statement for each.
std::vector<Statement> state_rules(const Part& part, const Directions& directions, const Unknowns& unknowns,
                                   const Marks& marks, const RuleSet& applied);

}  // namespace epura::definition
