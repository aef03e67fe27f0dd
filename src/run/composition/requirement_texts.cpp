// SPDX-License-Identifier: Apache-2.0
#include "composition/requirement_texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/requirement_words.hpp"
#include "scene/choices.hpp"
#include "sizes/tolerance.hpp"

namespace epura::pipeline {

namespace {

using importer::ModelRequirement;
using importer::RequirementBounds;

/// The sign of what a standard takes for granted.
constexpr std::string_view implied = "implied";

/// The word of a file, and the sign of drawings: of ISO, and if it differs, of ASME Y14.5.
struct Sign {
  std::string_view word, iso, asme{};

  [[nodiscard]] constexpr std::string_view sign(bool is_asme) const { return is_asme && !asme.empty() ? asme : iso; }
};

// Behind a size. ISO 14405-1; by ISO 8015 sizes are independent of form, by ASME Y14.5 they have an envelope.
constexpr std::array size_signs{Sign{"envelope requirement", "(E)", implied},
                                Sign{"independency", implied, "(I)"},
                                Sign{"two point size", "(LP)"},
                                Sign{"local size defined by a sphere", "(LS)"},
                                Sign{"least squares association criterion", "(GG)"},
                                Sign{"maximum inscribed association criterion", "(GX)"},
                                Sign{"minimum circumscribed association criterion", "(GN)"},
                                Sign{"circumference diameter", "(CC)"},
                                Sign{"area diameter", "(CA)"},
                                Sign{"volume diameter", "(CV)"},
                                Sign{"maximum size", "(SX)"},
                                Sign{"minimum size", "(SN)"},
                                Sign{"average size", "(SA)"},
                                Sign{"median size", "(SM)"},
                                Sign{"mid range size", "(SD)"},
                                Sign{"range of sizes", "(SR)"},
                                Sign{"any cross section", "ACS"},
                                Sign{"specific fixed cross section", "SCS"},
                                Sign{"common tolerance", "CT", "<CF>"},
                                Sign{"continuous feature", "CT", "<CF>"},
                                Sign{"statistical", "<ST>"},
                                Sign{"statistical tolerance", "<ST>"},
                                Sign{"free state condition", "(F)"},
                                Sign{"minimum", "min.", "MIN"},
                                Sign{"maximum", "max.", "MAX"}};

// In a circle behind a tolerance or a datum. ISO 1101, ISO 2692, ISO 10579. A projected zone (ISO 10578) has a length.
constexpr std::array circled_signs{Sign{"maximum material requirement", "M"},
                                   Sign{"least material requirement", "L"},
                                   Sign{"maximum material condition", "M"},
                                   Sign{"least material condition", "L"},
                                   Sign{"reciprocity requirement", "R"},
                                   Sign{"free state", "F"},
                                   Sign{"free state condition", "F"},
                                   Sign{"tangent plane", "T"},
                                   Sign{"regardless of feature size", implied, "S"}};

// Without one.
constexpr std::array plain_signs{Sign{"common zone", "CZ"}, Sign{"separate requirement", "SZ"},
                                 Sign{"not convex", "NC"}, Sign{"statistical tolerance", "<ST>"}};

constexpr std::array signs_above{
    Sign{"any cross section", "ACS"},           Sign{"all over", "all over", "ALL OVER"},
    Sign{"line element", "LE", "EACH ELEMENT"}, Sign{"each radial element", "LE", "EACH RADIAL ELEMENT"},
    Sign{"major diameter", "MD", "MAJOR DIA"},  Sign{"minor diameter", "LD", "MINOR DIA"},
    Sign{"pitch diameter", "PD", "PITCH DIA"}};

// Empty if there is none.
template <std::size_t count>
std::string sign_of(const std::array<Sign, count>& signs, std::string_view word, bool is_asme) {
  const auto found = std::find_if(signs.begin(), signs.end(), [&](const Sign& one) { return one.word == word; });
  return found == signs.end() ? std::string() : std::string(found->sign(is_asme));
}

// Whether fonts have all characters of a file's word.
bool is_plain(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

std::string no_sign_for(std::string_view word) { return "there is no sign for '" + std::string(word) + "'"; }

bool is_in(const ModelRequirement& one, Unit unit) {
  return one.is_angle != 0 || written_unit(one) == scene::millimetres(unit);
}

// What stands behind numbers that are not in the unit of the sheet.
std::string unit_behind(const ModelRequirement& one, Unit unit) {
  if (is_in(one, unit)) return "";
  return written_unit(one) == 1 ? " mm" : " in";
}

/// Deviations as a scene states them.
struct Deviations {
  double upper, lower;
  int decimals;

  [[nodiscard]] std::string text() const {
    const auto with_sign = [this](double value) {
      const std::string number = format_with_zeros(std::abs(value), decimals);
      return value == 0 ? std::string("0") : (value < 0 ? "-" : "+") + number;
    };
    if (upper == -lower) return "±" + format_with_zeros(upper, decimals);
    return with_sign(upper) + " " + with_sign(lower);
  }
};

// Numbers of inches have all decimals of their tolerance, and the other way round. ASME Y14.5.
void use_equal_decimals(scene::StatedValue& value, Deviations& deviations) {
  value.decimals = deviations.decimals = std::max(value.decimals, deviations.decimals);
}

std::string write_bounds(scene::DimensionDescription& dimension, const ModelRequirement& one) {
  const double unit = written_unit(one), lower = one.lower / unit, upper = one.upper / unit;
  if (!(upper > lower)) return "its limits permit no size";
  const bool are_limits = one.bounds == RequirementBounds::limits;
  if (!dimension.stated && are_limits) dimension.stated = {lower, std::max(needed_decimals(lower), one.decimals)};
  if (!dimension.stated) return "the file has deviations without a value";
  const double from = are_limits ? dimension.stated->value : 0;
  Deviations deviations{upper - from, lower - from, std::max(needed_decimals(upper), needed_decimals(lower))};
  if (dimension.stated->value + deviations.lower <= 0) return "its lower limit is not above 0";
  if (unit != 1) use_equal_decimals(*dimension.stated, deviations);
  dimension.tolerance = {deviations.text(), dimension.where};
  dimension.limits = {are_limits, dimension.where};
  return "";
}

// A number with at least these decimals.
std::string number_text(double value, int decimals, Unit unit) {
  std::string text = format_with_zeros(value, std::max(decimals, needed_decimals(value)));
  if (unit == Unit::in && text.starts_with("0.")) text.erase(0, 1);
  return text;
}

// How far the zone reaches out of the material: as ASME says, or for ISO, how far its middle is displaced.
void add_uneven(scene::FrameCell& cell, double outside, const ModelRequirement& one, const Manner& manner) {
  const double by = written_unit(one);
  if (manner.is_asme) {
    cell.insert(cell.end(), {{"U", true}, {number_text(outside / by, 0, manner.unit)}});
    return;
  }
  const double offset = outside - one.value / 2;
  cell.push_back({std::string("UZ ") + (offset < 0 ? "-" : "+") + number_text(std::abs(offset) / by, 0, manner.unit)});
}

// "0.1/10 M UZ +0.2": the width or diameter of the zone, and its modifiers. Those that have a place elsewhere stay in
// `left`.
scene::FrameCell zone_cell(const ModelRequirement& one, const Manner& manner, std::vector<std::string>& left) {
  const double by = written_unit(one);
  const auto number = [&](double value, int decimals) { return number_text(value, decimals, manner.unit); };
  const bool is_sphere = one.zone.find("spher") != std::string::npos;
  const bool is_round = is_sphere || one.zone.find("cylind") != std::string::npos || one.zone == "within a circle";
  std::string width = (is_sphere ? "S⌀" : is_round ? "⌀" : "") + number(one.value / by, one.decimals);
  scene::FrameCell cell(1);
  for (const std::string& word : items_of(one.modifiers, ", ")) {
    if (const std::string sign = sign_of(circled_signs, word, manner.is_asme); sign == implied)
      continue;
    else if (!sign.empty())
      cell.push_back({sign, true});
    else if (const std::string plain = sign_of(plain_signs, word, manner.is_asme); !plain.empty())
      cell.push_back({plain});
    else if (const auto unit_length = length_in(word, "per unit of "))
      width += "/" + number(*unit_length / by, 0);
    else if (const auto outside = length_in(word, "unequally disposed "))
      add_uneven(cell, *outside, one, manner);
    else if (const auto projected = length_in(word, "projected "))
      cell.insert(cell.end(), {{"P", true}, {number(*projected / by, 0)}});
    else if (const auto most = length_in(word, "maximum "))
      cell.push_back({number(*most / by, 0) + (manner.is_asme ? " MAX" : " max.")});
    else
      left.push_back(word);
  }
  cell.front().text = width + unit_behind(one, manner.unit);
  return cell;
}

// A datum of a frame: "B-C (maximum material requirement)".
std::string write_datum(scene::ToleranceFrame& frame, std::string_view text, bool is_asme) {
  const std::size_t bracket = std::min(text.find(" ("), text.size());
  const std::string letters(text.substr(0, bracket));
  scene::FrameCell& cell = frame.datums.emplace_back();
  cell.push_back({letters});
  for (const std::string& letter : items_of(letters, "-")) frame.letters.push_back(letter);
  if (letters.find('?') != std::string::npos || !is_plain(letters)) return "a datum that it refers to is not read";
  if (bracket == text.size()) return "";
  for (const std::string& word : items_of(text.substr(bracket + 2, text.size() - bracket - 3), ", ")) {
    const std::string sign = sign_of(circled_signs, word, is_asme);
    if (sign.empty()) return no_sign_for(word);
    if (sign == implied) continue;
    cell.push_back({sign, true});
  }
  return "";
}

// The other way round.

template <std::size_t count>
std::string word_of(const std::array<Sign, count>& signs, std::string_view sign) {
  const auto found =
      std::find_if(signs.begin(), signs.end(), [&](const Sign& one) { return one.iso == sign || one.asme == sign; });
  return found == signs.end() ? std::string() : std::string(found->word);
}

void read_number(ModelRequirement& one, std::string_view text, const std::string& where) {
  const auto number = parse_number(text);
  if (!number || !std::isfinite(*number) || *number < 0)
    refuse_input(where, "'" + std::string(text) + "' is not a value", "write a number with its decimals: 8.00");
  const std::size_t point = std::min(text.find('.'), text.size() - 1);
  one.value = *number * one.unit;
  one.decimals = std::min(static_cast<int>(text.size() - point - 1), importer::max_decimals);
}

void read_tolerance(ModelRequirement& one, const scene::LocatedText& text) {
  const sheet::Tolerance tolerance = sheet::parse_tolerance(*text, text.where);
  if (tolerance.deviations) {
    if (std::isnan(one.value))
      refuse_input(text.where, "deviations need the value from which they are",
                   "write it with its decimals: value = \"8.00\"");
    one.bounds = RequirementBounds::deviations;
    one.lower = tolerance.deviations->lower * one.unit;
    one.upper = tolerance.deviations->upper * one.unit;
  } else {
    one.fit = *text;
  }
}

// "⌀0.1 M" as a width, the form of its zone, and modifiers.
void read_zone(ModelRequirement& one, const scene::FrameCell& zone, const std::string& where) {
  std::string_view width = zone.front().text;
  for (const auto& [sign, form] :
       {std::pair<std::string_view, const char*>{"S⌀", "spherical"}, {"⌀", "cylindrical or circular"}})
    if (width.starts_with(sign)) {
      one.zone = form;
      width.remove_prefix(sign.size());
    }
  read_number(one, width, where);
  for (std::size_t i = 1; i < zone.size(); ++i) {
    const std::string word =
        zone[i].circled ? word_of(circled_signs, zone[i].text) : word_of(plain_signs, zone[i].text);
    if (word.empty())
      refuse_input(where, "requirements have no modifier '" + zone[i].text + "'", "[[tolerance_frame]] draws it");
    append_to_list(one.modifiers, word);
  }
}

// "B-C (maximum material requirement)"
std::string datum_in_words(const scene::FrameCell& cell) {
  std::string modifiers;
  for (std::size_t i = 1; i < cell.size(); ++i) append_to_list(modifiers, word_of(circled_signs, cell[i].text));
  return cell.front().text + (modifiers.empty() ? "" : " (" + modifiers + ")");
}

}  // namespace

importer::ModelRequirement requirement_of(const scene::RequirementDescription& words, Unit unit) {
  ModelRequirement one{};
  one.type = *words.type;
  one.name = words.name.value_or("");
  one.is_angle = one.type == "angle" ? 1 : 0;
  one.unit = one.is_angle != 0 ? 1 : scene::millimetres(unit);
  one.decimals = -1;
  one.value = one.lower = one.upper = NAN;
  if (words.letter.given()) {
    one.kind = importer::RequirementKind::datum;
    one.datums = *words.letter;
  } else if (!words.frame.zone.empty()) {
    one.kind = importer::RequirementKind::tolerance;
    std::replace(one.type.begin(), one.type.end(), '-', ' ');
    read_zone(one, words.frame.zone, words.where);
    for (const scene::FrameCell& cell : words.frame.datums)
      one.datums += (one.datums.empty() ? "" : " | ") + datum_in_words(cell);
  } else {
    one.kind = importer::RequirementKind::dimension;
    if (words.value.given()) read_number(one, *words.value, words.value.where);
    if (words.tolerance.given()) read_tolerance(one, words.tolerance);
  }
  return one;
}

std::string write_value(scene::DimensionDescription& dimension, const ModelRequirement& one, const Manner& manner) {
  const double written = one.value / written_unit(one);
  if (std::isfinite(written))
    dimension.stated = scene::StatedValue{written, std::max(one.decimals, needed_decimals(written))};
  if (one.bounds != RequirementBounds::none)
    if (const std::string why = write_bounds(dimension, one); !why.empty()) return why;
  std::string before, after = (one.fit.empty() ? "" : " " + one.fit) + unit_behind(one, manner.unit);
  if (!is_plain(one.fit)) return no_sign_for(one.fit);
  bool is_auxiliary = false;
  for (const std::string& word : items_of(one.modifiers, ", ")) {
    const std::string sign = sign_of(size_signs, word, manner.is_asme);
    if (sign == implied) continue;
    if (word == "theoretical" || word == "basic")
      dimension.is_exact = true;
    else if (word == "auxiliary" || word == "reference")
      is_auxiliary = true;
    else if (word == "square")
      before = "□" + before;
    else if (word == "controlled radius")
      before = "C" + before;
    else if (sign.empty())
      return no_sign_for(word);
    else
      after += " " + sign;
  }
  const std::string text = before + "<>" + after;
  dimension.text = {is_auxiliary ? "(" + text + ")" : text, dimension.where};
  return "";
}

scene::NoteText value_note(const scene::DimensionDescription& dimension, const std::string& sign,
                           const ModelRequirement& one, const Manner& manner, double measured) {
  constexpr int digits = 6;
  const double unit = written_unit(one);
  const std::string degrees = one.is_angle != 0 ? "°" : "";
  const std::string whole = dimension.text.value_or("<>");
  const auto with = [&](double value, int decimals, const std::string& tolerance) {
    std::string text = whole;
    text.replace(text.find("<>"), 2, sign + number_text(value, decimals, manner.unit) + degrees + tolerance);
    return text + (dimension.is_exact ? manner.is_asme ? " BASIC" : " TED" : "");
  };
  scene::NoteText note;
  note.has_values = true;
  const int decimals = dimension.stated ? dimension.stated->decimals : 0;
  if (dimension.limits.value_or(false)) {
    note.lines = {with(one.upper / unit, decimals, ""), with(one.lower / unit, decimals, "")};
    return note;
  }
  const std::string tolerance = dimension.tolerance.given() ? " " + *dimension.tolerance + degrees : std::string();
  const auto rounded = parse_number(format_rounded(measured / unit, digits));
  note.lines = {with(dimension.stated ? dimension.stated->value : rounded.value_or(0), decimals, tolerance)};
  return note;
}

std::string write_frame(scene::ToleranceFrame& frame, const ModelRequirement& one, const Manner& manner) {
  std::string name = one.type == "coaxiality"        ? "concentricity"
                     : one.type == "circular runout" ? "circular-run-out"
                     : one.type == "total runout"    ? "total-run-out"
                                                     : one.type;
  std::replace(name.begin(), name.end(), ' ', '-');
  const auto row = std::find_if(scene::characteristics.begin(), scene::characteristics.end(),
                                [&](const scene::CharacteristicRow& known) { return known.name == name; });
  if (row == scene::characteristics.end()) return "there is no characteristic '" + one.type + "'";
  if (!std::isfinite(one.value) || one.value < 0) return "the file gives its zone no width";
  frame.characteristic = row->characteristic;
  std::vector<std::string> words;
  frame.zone = zone_cell(one, manner, words);
  for (const std::string& datum : items_of(one.datums, " | "))
    if (const std::string why = write_datum(frame, datum, manner.is_asme); !why.empty()) return why;
  for (const std::string& word : words) {
    const std::string sign = sign_of(signs_above, word, manner.is_asme);
    if (!is_plain(word)) return no_sign_for(word);
    if (word == "all around")
      frame.all_around = true;
    else
      add_above(frame, sign.empty() ? word : sign);
  }
  return "";
}

scene::DatumTarget target_of(const ModelRequirement& one, bool with_size, const Manner& manner) {
  constexpr int digits = 6;
  scene::DatumTarget target{one.datums};
  target.is_round = one.zone.find("circle") != std::string::npos;
  const auto number = [&](const std::array<double, 3>& half) {
    const double size = 2 * std::hypot(half[0], half[1], half[2]) / scene::millimetres(manner.unit);
    const auto rounded = parse_number(format_rounded(size, digits));
    return size > 0 ? number_text(rounded.value_or(size), 0, manner.unit) : std::string();
  };
  if (!with_size || one.area.size() < 3) return target;
  const std::string length = number(one.area[1]), width = number(one.area[2]);
  target.size = target.is_round ? "⌀" + length : width.empty() ? length : length + "×" + width;
  if (length.empty()) target.size.clear();
  return target;
}

scene::SurfaceTexture texture_of(const ModelRequirement& one) {
  constexpr std::string_view made_by = "made by ";
  scene::SurfaceTexture texture;
  texture.lines = items_of(one.text, "; ");
  for (const std::string& word : items_of(one.modifiers, ", ")) {
    if (word == "material removal required") texture.removal = MaterialRemoval::required;
    if (word == "material removal prohibited") texture.removal = MaterialRemoval::prohibited;
    if (word.starts_with(made_by)) append_to_list(texture.process, word.substr(made_by.size()));
  }
  return texture;
}

scene::NoteText note_of(const ModelRequirement& one) {
  constexpr std::size_t widest = 40;  // characters
  scene::NoteText note;
  for (const std::string_view word : split(one.text, ' ')) {
    if (note.lines.empty() || note.lines.back().size() + word.size() >= widest)
      note.lines.emplace_back(word);
    else
      note.lines.back().append(" ").append(word);
  }
  return note;
}

void add_above(scene::ToleranceFrame& frame, const std::string& words) { append_to_list(frame.above, words); }

}  // namespace epura::pipeline
