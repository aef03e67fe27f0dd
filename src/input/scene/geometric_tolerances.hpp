// SPDX-License-Identifier: Apache-2.0
// Geometrical tolerances and datums. ISO 1101, ISO 5459.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/choices.hpp"

namespace epura::scene {

/// Whether a tolerance refers to datums.
enum class DatumRule { none, optional, required };

struct CharacteristicRow {
  Characteristic characteristic;
  const char* name;
  DatumRule datums;
  /// Around the origin, in units of 0.085 heights of capitals; after ISO 7083: `m x y`, `l x y` begin and continue a
  /// line, `c x y r` is a circle, `h x y r` its upper half, `f x y x y x y` a filled triangle.
  const char* symbol;
};

/// The characteristics of ISO 1101 with their symbols.
inline constexpr std::array characteristics = {
    CharacteristicRow{Characteristic::straightness, "straightness", DatumRule::none, "m -8 0 l 8 0"},
    CharacteristicRow{Characteristic::flatness, "flatness", DatumRule::none,
                      "m -9 -4.5 l 3.8 -4.5 l 9 4.5 l -3.8 4.5 l -9 -4.5"},
    CharacteristicRow{Characteristic::roundness, "roundness", DatumRule::none, "c 0 0 6"},
    CharacteristicRow{Characteristic::cylindricity, "cylindricity", DatumRule::none,
                      "c 0 0 4 m -6.96 -4.06 l 0.04 8.06 m -0.04 -8.06 l 6.96 4.06"},
    CharacteristicRow{Characteristic::line_profile, "line-profile", DatumRule::optional, "h 0 -3.5 7"},
    CharacteristicRow{Characteristic::surface_profile, "surface-profile", DatumRule::optional,
                      "h 0 -3.5 7 m -7 -3.5 l 7 -3.5"},
    CharacteristicRow{Characteristic::parallelism, "parallelism", DatumRule::required,
                      "m -5.95 -6 l 0.98 6 m -0.98 -6 l 5.95 6"},
    CharacteristicRow{Characteristic::perpendicularity, "perpendicularity", DatumRule::required,
                      "m -7 -6 l 7 -6 m 0 -6 l 0 6"},
    CharacteristicRow{Characteristic::angularity, "angularity", DatumRule::required, "m 7 4 l -7 -4 l 7 -4"},
    CharacteristicRow{Characteristic::position, "position", DatumRule::optional, "c 0 0 4.5 m -8 0 l 8 0 m 0 -8 l 0 8"},
    CharacteristicRow{Characteristic::concentricity, "concentricity", DatumRule::required, "c 0 0 6 c 0 0 3.5"},
    CharacteristicRow{Characteristic::symmetry, "symmetry", DatumRule::required,
                      "m -8 0 l 8 0 m -4.5 4 l 4.5 4 m -4.5 -4 l 4.5 -4"},
    CharacteristicRow{Characteristic::circular_run_out, "circular-run-out", DatumRule::required,
                      "m -5.5 -5.5 l 5.5 5.5 f 5.5 5.5 1.01 2.91 2.91 1.01"},
    CharacteristicRow{Characteristic::total_run_out, "total-run-out", DatumRule::required,
                      "m 2.5 5.5 l -8.5 -5.5 l -1 -5.5 l 10 5.5 f 2.5 5.5 -1.99 2.91 -0.09 1.01 "
                      "f 10 5.5 5.51 2.91 7.41 1.01"},
};

constexpr const CharacteristicRow& row_of(Characteristic one) { return characteristics[static_cast<std::size_t>(one)]; }

template <>
struct Words<Characteristic> {
  static constexpr auto list = [] {
    std::array<const char*, characteristics.size()> words{};
    for (const CharacteristicRow& row : characteristics) words[static_cast<std::size_t>(row.characteristic)] = row.name;
    return words;
  }();
};

/// A part of a compartment: a text, or a letter in a circle.
struct FramePiece {
  std::string text;
  bool circled = false;

  bool operator==(const FramePiece&) const = default;
};
using FrameCell = std::vector<FramePiece>;

/// A tolerance frame: what stands in its compartments after the symbol.
struct ToleranceFrame {
  Characteristic characteristic{};
  FrameCell zone{};                    ///< numbers with a decimal point
  std::vector<FrameCell> datums{};     ///< in their order
  std::vector<std::string> letters{};  ///< of the datums
  std::string above{};                 ///< text above the frame: "4×"
  std::vector<ToleranceFrame> also{};  ///< further ones of the same feature, below it; their letters are here, too
  bool all_around = false;             ///< a circle on the leader; not in scene files
  bool is_composite = false;           ///< below another one, whose symbol is that of both; not in scene files
};

/// A datum feature, marked by a triangle.
struct DatumFeature {
  std::string letter;
};

/// Parses a zone, "0.05", "Ø0.1 M", "S⌀0.2", "0.1 CZ", "Ø0 M P 20": a width or diameter in the unit of dimensions, then
/// modifiers of ISO 1101, ISO 2692 and ISO 5458. Throws Error{input} with `where` as the location.
FrameCell parse_zone(std::string_view text, const std::string& where);

/// Parses a datum, "A", "A M", or a common one, "A-B"; adds its letters. Throws Error{input}.
FrameCell parse_datum(std::string_view text, const std::string& where, std::vector<std::string>& letters);

/// Throws Error{input} for letters of datums that are not capitals, or that look like numbers: I, O and Q.
void expect_datum_letter(std::string_view letter, const std::string& where);

}  // namespace epura::scene
