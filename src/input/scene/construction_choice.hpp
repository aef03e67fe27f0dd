// SPDX-License-Identifier: Apache-2.0
// Which constructions of a projection are drawn: "horizon", "vp:1,1,0", "to-vp:0:3-7", "section:0,0,9:1,0,1".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.hpp"
#include "scene/choices.hpp"

namespace epura::scene {

enum class ConstructionKind : std::uint8_t {
  all,
  legend,
  horizon,
  vanishing_point,
  to_vanishing_point,
  principal_point,
  station_point,
  distance_points,
  measuring_points,
  true_length,
  vanishing_line,
  ground_line,
  cone,
  axes,
  ellipses,
  trace_triangle,
  corners,
  point,
  traces,
  true_shape,
  piercing,
  section,
  label
};

/// What follows the word and a colon. A plane is that of a face, or has a point and a normal.
enum class ConstructionArgument : std::uint8_t { none, direction, degrees, edge, vertex, face, plane, named_point };

/// The drawings in which a kind has a meaning.
enum class ConstructionFamily : std::uint8_t { any, central, parallel, epura, central_or_epura, not_epura };

struct ConstructionRow {
  ConstructionKind kind;
  const char* word;
  ConstructionFamily family;
  ConstructionArgument argument = ConstructionArgument::none;
  bool required = false;  ///< the argument is
};

/// In the order of the enumerators.
inline constexpr std::array construction_rows = {
    ConstructionRow{ConstructionKind::all, "all", ConstructionFamily::any},
    ConstructionRow{ConstructionKind::legend, "legend", ConstructionFamily::any},
    ConstructionRow{ConstructionKind::horizon, "horizon", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::vanishing_point, "vp", ConstructionFamily::central,
                    ConstructionArgument::direction},
    ConstructionRow{ConstructionKind::to_vanishing_point, "to-vp", ConstructionFamily::central,
                    ConstructionArgument::edge},
    ConstructionRow{ConstructionKind::principal_point, "principal", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::station_point, "station", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::distance_points, "distance", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::measuring_points, "measuring", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::true_length, "true-length", ConstructionFamily::central_or_epura,
                    ConstructionArgument::edge, true},
    ConstructionRow{ConstructionKind::vanishing_line, "vanishing-line", ConstructionFamily::central,
                    ConstructionArgument::direction},
    ConstructionRow{ConstructionKind::ground_line, "ground", ConstructionFamily::central},
    ConstructionRow{ConstructionKind::cone, "cone", ConstructionFamily::central, ConstructionArgument::degrees},
    ConstructionRow{ConstructionKind::axes, "axes", ConstructionFamily::parallel},
    ConstructionRow{ConstructionKind::ellipses, "ellipses", ConstructionFamily::parallel},
    ConstructionRow{ConstructionKind::trace_triangle, "trace-triangle", ConstructionFamily::parallel},
    ConstructionRow{ConstructionKind::corners, "corners", ConstructionFamily::epura},
    ConstructionRow{ConstructionKind::point, "point", ConstructionFamily::epura, ConstructionArgument::vertex, true},
    ConstructionRow{ConstructionKind::traces, "traces", ConstructionFamily::central_or_epura,
                    ConstructionArgument::plane, true},
    ConstructionRow{ConstructionKind::true_shape, "true-shape", ConstructionFamily::epura, ConstructionArgument::face,
                    true},
    ConstructionRow{ConstructionKind::piercing, "piercing", ConstructionFamily::epura, ConstructionArgument::edge,
                    true},
    ConstructionRow{ConstructionKind::section, "section", ConstructionFamily::epura, ConstructionArgument::plane, true},
    ConstructionRow{ConstructionKind::label, "label", ConstructionFamily::not_epura, ConstructionArgument::named_point,
                    true},
};

static_assert([] {
  for (std::size_t i = 0; i < construction_rows.size(); ++i)
    if (construction_rows[i].kind != static_cast<ConstructionKind>(i)) return false;
  return true;
}());

constexpr const ConstructionRow& row_of(ConstructionKind kind) {
  return construction_rows[static_cast<std::size_t>(kind)];
}

/// A point of the world with its symbol, such as VP_x.
struct NamedPoint {
  std::string symbol;  ///< with an index after '_', or a note after ':' that is not in the legend
  Vec3 at{0.0};
  std::string meaning{};            ///< in the legend, if there is one
  bool marked = true;               ///< by a circle
  std::optional<Vec3> away_from{};  ///< a point on whose other side the symbol is, if there is room

  bool operator==(const NamedPoint&) const = default;
};

struct ConstructionItem {
  ConstructionKind kind;
  std::string text;                  ///< as given, for messages
  std::optional<Vec3> direction{};   ///< not zero
  std::optional<double> degrees{};   ///< more than 0, less than 180
  int model = 0;                     ///< of the edge, vertex or face
  std::array<int, 2> numbers{0, 0};  ///< in the file: the ends of the edge, the lower first; or the vertex or face
  bool has_element = false;          ///< an edge, vertex or face is given
  std::optional<Vec3> at{};          ///< a point of the plane whose normal is `direction`
  bool by_change_of_planes = false;  ///< instead of a rotation
  std::optional<NamedPoint> label{};

  bool operator==(const ConstructionItem&) const = default;
};

using ConstructionChoice = std::vector<ConstructionItem>;

/// WORD, or WORD:ARGUMENT. Throws Error{input}.
ConstructionItem parse_construction(std::string_view text, const std::string& where);

/// Joins what a comma in a direction or position has split: "vp:1", "1", "0".
std::vector<std::string> join_directions(const std::vector<std::string>& words);

}  // namespace epura::scene
