// SPDX-License-Identifier: Apache-2.0
// How numbers are written on a sheet. ISO 129-1, ASME Y14.5. Coordinates in files are not affected.
#pragma once

#include <epura/choices.hpp>
#include <string>

namespace epura::sheet {

struct Notation {
  int decimals = 2;      ///< of lengths: at most; in inches: exactly
  Unit unit = Unit::mm;  ///< of lengths
  DecimalSign sign = DecimalSign::point;
  bool is_asme = false;    ///< signs of ASME Y14.5 where ISO has others
  std::string diameter{};  ///< sign before diameters
  std::string arc{};       ///< sign before lengths of arcs
};

/// The number with the decimal sign; `number` has a point or none.
std::string with_decimal_sign(std::string number, DecimalSign sign);

/// "4× ⌀8" in the signs of the standard: "4X ⌀8" in ASME Y14.5, 1.9.5.
std::string with_repeats(std::string text, const Notation& notation);

/// A length of the world, given in millimetres. In mm and m without trailing zeros ("12.5"); in inches with all
/// decimals and without a zero before the decimal sign (".500", "1.250"; ASME Y14.5-2018, 4.3.2).
std::string length_text(double millimetres, const Notation& notation);

/// An angle in degrees, with at most two decimals: "36.87°".
std::string angle_text(double degrees, const Notation& notation);

/// A mass with three significant digits or more: "0.123 kg", "12.3 kg", "1234 kg"; below 0.1 kg in grams.
std::string mass_text(double kilograms, DecimalSign sign);

/// The same of one of several, in the unit of the heaviest one: "0.0123 kg" beside "12.3 kg".
std::string mass_text(double kilograms, DecimalSign sign, double heaviest);

/// Decimals of lengths by the largest size of the models, mm: four digits of small ones, and at least as fine as 0.01
/// mm or 0.001 in.
int usual_decimals(double largest_size, Unit unit);

}  // namespace epura::sheet
