// SPDX-License-Identifier: Apache-2.0
// User choices: enums with their words, and values that are more than one number.
#pragma once

#include <array>
#include <cstddef>
#include <epura/choices.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/vec.hpp"

namespace epura::scene {

/// The words for the values of an enum, in the order of its enumerators. Each enum has a specialisation next to it.
template <class Enum>
struct Words;

template <class Enum>
std::string_view word_of(Enum value) {
  return Words<Enum>::list[static_cast<std::size_t>(value)];
}

template <>
struct Words<Unit> {
  static constexpr std::array list{"mm", "in", "m"};
};
/// Returns the length of one unit in mm.
double millimetres(Unit unit);

template <>
struct Words<UpAxis> {
  static constexpr std::array list{"z", "y"};
};

template <>
struct Words<Surfaces> {
  static constexpr std::array list{"auto", "mesh"};
};

template <>
struct Words<Pmi> {
  static constexpr std::array list{"all", "dimensions", "tolerances", "none"};
};

template <>
struct Words<HiddenLines> {
  static constexpr std::array list{"none", "dashed", "solid"};
};

template <>
struct Words<HatchPattern> {
  static constexpr std::array list{"none", "general", "steel", "bronze", "nonmetal", "solid"};
};

template <>
struct Words<LayersBy> {
  static constexpr std::array list{"role", "body"};
};

template <>
struct Words<EdgeKind> {
  static constexpr std::array list{"contour",    "boundary", "crease", "intersection", "section",
                                   "thread-end", "wire",     "thread", "tangent",      "smooth"};
};
/// The kinds that can be chosen; outlines of sections are always drawn.
inline constexpr std::array<std::pair<EdgeKind, bool EdgeKinds::*>, 7> chosen_edge_kinds{
    {{EdgeKind::contour, &EdgeKinds::contour},
     {EdgeKind::crease, &EdgeKinds::crease},
     {EdgeKind::boundary, &EdgeKinds::boundary},
     {EdgeKind::intersection, &EdgeKinds::intersection},
     {EdgeKind::wire, &EdgeKinds::wire},
     {EdgeKind::tangent, &EdgeKinds::tangent},
     {EdgeKind::smooth, &EdgeKinds::smooth}}};

template <>
struct Words<BreakLine> {
  static constexpr std::array list{"zigzag", "freehand"};
};

template <>
struct Words<HalfView> {
  static constexpr std::array list{"left",     "right",     "top",         "bottom",
                                   "top-left", "top-right", "bottom-left", "bottom-right"};
};

template <>
struct Words<Orientation> {
  static constexpr std::array list{"landscape", "portrait"};
};

template <>
struct Words<SheetLayout> {
  static constexpr std::array list{"standard", "monge"};
};

template <>
struct Words<SheetFit> {
  static constexpr std::array list{"model", "construction"};
};

template <>
struct Words<ProjectionAngle> {
  static constexpr std::array list{"first", "third"};
};

template <>
struct Words<FrameKind> {
  static constexpr std::array list{"auto", "none", "plain", "full"};
};

template <>
struct Words<DecimalSign> {
  static constexpr std::array list{".", ","};
  static constexpr std::array other{"point", "comma"};  ///< for shells and for the eye
};

template <>
struct Words<DimensionType> {
  static constexpr std::array list{"linear", "aligned", "angular", "radius", "diameter", "arc", "overall", "auto"};
};

template <>
struct Words<DimensionArrangement> {
  static constexpr std::array list{"baseline", "chain", "ordinate"};
};

template <>
struct Words<HoleDimensions> {
  static constexpr std::array list{"notes", "table"};
};

template <>
struct Words<DimensionDirection> {
  static constexpr std::array list{"horizontal", "vertical", "width", "height", "depth"};
};

/// Millimetres on paper per unit of the model. Without a fixed value: the largest scale that fits, or the largest
/// standard scale that fits (ISO 5455).
struct ScaleChoice {
  std::optional<double> fixed{};
  bool standard = false;

  bool operator==(const ScaleChoice&) const = default;
};

/// Greatest length of a sheet's side and of a drawing, mm: 100 m.
inline constexpr double longest_side = 100'000;

/// A paper size.
struct PaperChoice {
  enum class Kind { iso, ansi, custom, none, automatic, automatic_ansi };
  Kind kind = Kind::iso;
  int number = 4;                    ///< iso: 0 to 4, for A0 to A4; ansi: 0 to 4, for A to E
  std::array<double, 2> size{0, 0};  ///< custom: width and height, mm

  bool operator==(const PaperChoice&) const = default;
};

/// The parts of a view that are left out. ISO 128-3.
struct BreakChoice {
  /// What lies between two planes perpendicular to an axis of the world; infinite: up to the end.
  struct Part {
    int axis;
    double from, to;

    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts{};
  bool automatic = false;    ///< long parts of constant section
  bool is_optional = false;  ///< views that cannot be broken are drawn whole

  bool operator==(const BreakChoice&) const = default;
};

/// Whether a lettering font is given by its file, not its family: with a slash, or the extension of a font file.
bool names_font_file(const std::string& font);

/// The name of a projection, and values of its parameters as text: the plugin's table defines the permitted ones.
struct ProjectionRequest {
  std::string name;
  std::vector<std::pair<std::string, std::string>> assignments{};

  /// NAME[:key=value]...
  [[nodiscard]] std::string text() const;
};

// These functions throw Error{input} with `where` as the location of the text.
ScaleChoice parse_scale(std::string_view text, const std::string& where);        ///< fit, auto, 1:2, 0.5
PaperChoice parse_paper_size(std::string_view text, const std::string& where);   ///< A4, ANSI-B, 300x200, none, auto
BreakChoice::Part parse_break(std::string_view text, const std::string& where);  ///< x:40:160, z::20, y:40:
ProjectionRequest parse_request(std::string_view text);  ///< NAME[:key=value]... or saved:VIEW; location: text

}  // namespace epura::scene
