// SPDX-License-Identifier: Apache-2.0
#include "sizes/fits.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::sheet {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();  // not defined at this size
constexpr int min_grade = 1, greatest_grade = 18;
constexpr double micrometre = 1e-3;

// Sizes up to and including the limit, mm; the fundamental deviations have finer steps.
constexpr std::array<double, 13> size_steps{3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
constexpr std::array<double, 25> fine_steps{3,   6,   10,  14,  18,  24,  30,  40,  50,  65,  80,  100, 120,
                                            140, 160, 180, 200, 225, 250, 280, 315, 355, 400, 450, 500};

// Table 1: standard tolerances IT1 to IT18, micrometres.
constexpr std::array<std::array<double, size_steps.size()>, greatest_grade> grades{{
    {0.8, 1, 1, 1.2, 1.5, 1.5, 2, 2.5, 3.5, 4.5, 6, 7, 8},
    {1.2, 1.5, 1.5, 2, 2.5, 2.5, 3, 4, 5, 7, 8, 9, 10},
    {2, 2.5, 2.5, 3, 4, 4, 5, 6, 8, 10, 12, 13, 15},
    {3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20},
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970},
    {250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550},
    {400, 480, 580, 700, 840, 1000, 1200, 1400, 1600, 1850, 2100, 2300, 2500},
    {600, 750, 900, 1100, 1300, 1600, 1900, 2200, 2500, 2900, 3200, 3600, 4000},
    {1000, 1200, 1500, 1800, 2100, 2500, 3000, 3500, 4000, 4600, 5200, 5700, 6300},
    {1400, 1800, 2200, 2700, 3300, 3900, 4600, 5400, 6300, 7200, 8100, 8900, 9700},
}};

using LimitRow = std::array<double, size_steps.size()>;
using FineRow = std::array<double, fine_steps.size()>;

// Tables 4 and 5: distance of the shaft's zone from the nominal size, micrometres, below it for c to h and above it for
// k to u. Those of d to p depend on the main steps only.
struct Clearance {
  std::string_view letter;
  LimitRow distance;
};
constexpr std::array<Clearance, 9> main_rows{{
    {"d", {20, 30, 40, 50, 65, 80, 100, 120, 145, 170, 190, 210, 230}},
    {"e", {14, 20, 25, 32, 40, 50, 60, 72, 85, 100, 110, 125, 135}},
    {"f", {6, 10, 13, 16, 20, 25, 30, 36, 43, 50, 56, 62, 68}},
    {"g", {2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 18, 20}},
    {"h", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"k", {0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5}},
    {"m", {2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23}},
    {"n", {4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40}},
    {"p", {6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68}},
}};
struct FineClearance {
  std::string_view letter;
  FineRow distance;
};
constexpr std::array<FineClearance, 5> fine_rows{{
    {"c", {60,  70,  80,  95,  95,  110, 110, 120, 130, 140, 150, 170, 180,
           200, 210, 230, 240, 260, 280, 300, 330, 360, 400, 440, 480}},
    {"r", {10, 15, 19, 23, 23, 28, 28, 34, 34, 41, 43, 51, 54, 63, 65, 68, 77, 80, 84, 94, 98, 108, 114, 126, 132}},
    {"s",
     {14, 19, 23, 28, 28, 35, 35, 43, 43, 53, 59, 71, 79, 92, 100, 108, 122, 130, 140, 158, 170, 190, 208, 232, 252}},
    {"t", {none, none, none, none, none, none, 41,  48,  54,  66,  75,  91, 104,
           122,  134,  146,  166,  180,  196,  218, 240, 268, 294, 330, 360}},
    {"u", {18,  23,  28,  33,  33,  41,  48,  60,  70,  87,  102, 124, 144,
           170, 190, 210, 236, 258, 284, 315, 350, 390, 435, 490, 540}},
}};
// j: lower deviations of j5 and j6, and of j7; J: upper deviations of J6 to J8. They follow no rule.
constexpr LimitRow j5_below{2, 2, 2, 3, 4, 5, 7, 9, 11, 13, 16, 18, 20};
constexpr LimitRow j7_below{4, 4, 5, 6, 8, 10, 12, 15, 18, 21, 26, 28, 32};
constexpr std::array<LimitRow, 3> holes_j_above{{{2, 5, 5, 6, 8, 10, 13, 16, 18, 22, 25, 29, 33},
                                                 {4, 6, 8, 10, 12, 14, 18, 22, 26, 30, 36, 39, 43},
                                                 {6, 10, 12, 15, 20, 24, 28, 34, 41, 47, 55, 60, 66}}};

constexpr std::string_view known_letters = "C to H, J, JS, K to U for holes, and c to h, j, js, k to u for shafts";

template <std::size_t count>
std::size_t step_of(const std::array<double, count>& limits, double size) {
  return static_cast<std::size_t>(std::lower_bound(limits.begin(), limits.end(), size) - limits.begin());
}

double grade_of(int grade, std::size_t step) { return grades[std::size_t(grade - 1)][step]; }

// Of a lower-case letter other than j and js; nothing for unknown letters.
std::optional<double> distance_of(std::string_view letter, double size) {
  for (const Clearance& row : main_rows)
    if (row.letter == letter) return row.distance[step_of(size_steps, size)];
  for (const FineClearance& row : fine_rows)
    if (row.letter == letter) return row.distance[step_of(fine_steps, size)];
  return {};
}

// Lower deviation of shafts k to u, micrometres. Only k4 to k7 are above the nominal size.
double shaft_ei(const std::string& letter, int grade, double size) {
  return letter == "k" && (grade < 4 || grade > 7) ? 0 : distance_of(letter, size).value_or(none);
}

// Upper deviation of holes K to U, micrometres: that of the shaft below the nominal size, and for fine grades the
// difference of two grades, so that K7 with h6 fits as H7 with k6. ISO 286-1:2010, 4.3.2.5.
double hole_es(const std::string& letter, int grade, double size) {
  const std::size_t step = step_of(size_steps, size);
  const bool middle = letter == "k" || letter == "m" || letter == "n";
  if (letter == "k" && grade > 8) return step == 0 ? 0 : none;
  if (letter == "n" && grade > 8 && step > 0) return 0;
  if (letter == "m" && grade == 6 && size_steps[step] == 315) return -9;  // the standard's exception: not -11
  const bool finer = step > 0 && grade >= 3 && grade <= (middle ? 8 : 7);
  const double es = -distance_of(letter, size).value_or(none);
  return finer ? es + grade_of(grade, step) - grade_of(grade - 1, step) : es;
}

// Micrometres; not finite if the standard does not define the class at this size.
Deviations zone_of(const ToleranceClass& one, double size) {
  const std::size_t step = step_of(size_steps, size);
  const double width = grade_of(one.grade, step);
  const std::string letter = to_lower(one.letters);
  if (letter == "js") return {width / 2, -width / 2};
  if (letter == "j" && one.is_hole()) {
    const double es = one.grade >= 6 && one.grade <= 8 ? holes_j_above[std::size_t(one.grade - 6)][step] : none;
    return {es, es - width};
  }
  if (letter == "j") {
    double ei = one.grade == 5 || one.grade == 6 ? -j5_below[step] : one.grade == 7 ? -j7_below[step] : none;
    if (one.grade == 8 && step == 0) ei = -6;
    return {ei + width, ei};
  }
  if (letter <= "h") {
    const double off = distance_of(letter, size).value_or(none);
    return one.is_hole() ? Deviations{off + width, off} : Deviations{-off, -off - width};
  }
  if (one.is_hole()) {
    const double es = hole_es(letter, one.grade, size);
    return {es, es - width};
  }
  const double ei = shaft_ei(letter, one.grade, size);
  return {ei + width, ei};
}

}  // namespace

ToleranceClass parse_tolerance_class(std::string_view text, const std::string& where) {
  std::size_t letters = 0;
  while (letters < text.size() && std::isalpha(static_cast<unsigned char>(text[letters]))) ++letters;
  const auto grade = parse_integer(text.substr(letters));
  const std::string quoted = "'" + std::string(text) + "'";
  if (letters == 0 || !grade)
    refuse_input(where, quoted + " is not a tolerance class of ISO 286",
                 "a letter and a grade, as H7 or g6, or deviations, as ±0.1 or +0.2 -0.1");
  ToleranceClass one{std::string(text.substr(0, letters)), 0};
  const std::string lower = to_lower(one.letters);
  const bool one_case =
      one.letters == lower || std::none_of(one.letters.begin(), one.letters.end(), [](char c) { return c >= 'a'; });
  if (!one_case || (lower != "j" && lower != "js" && !distance_of(lower, 25)))
    refuse_input(where, quoted + " has no fundamental deviation that is known here",
                 "known are " + std::string(known_letters));
  if (*grade < min_grade || *grade > greatest_grade)
    refuse_input(where, quoted + " has no standard tolerance grade", "the grades of ISO 286-1 are 1 to 18");
  one.grade = static_cast<int>(*grade);
  return one;
}

Deviations deviations_of(const ToleranceClass& tolerance, double size, const std::string& where) {
  if (!(size > 0 && size <= largest_fit_size))
    refuse_input(where, "the table for " + tolerance.text() + " has no size of " + format_number(size) + " mm",
                 "the sizes of ISO 286-1 here are up to " + format_number(largest_fit_size) +
                     " mm; give the deviations, as +0.2 -0.1");
  const Deviations zone = zone_of(tolerance, size);
  if (!std::isfinite(zone.upper) || !std::isfinite(zone.lower))
    refuse_input(where, "ISO 286-1 defines no " + tolerance.text() + " for a size of " + format_number(size) + " mm",
                 "choose another grade or letter, or give the deviations, as +0.2 -0.1");
  return {zone.upper * micrometre, zone.lower * micrometre};
}

}  // namespace epura::sheet
