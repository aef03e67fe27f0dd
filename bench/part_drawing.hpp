// SPDX-License-Identifier: Apache-2.0
// Drawings of tessellated parts, whose quality is measured, and tables about them.
#pragma once

#include <array>
#include <cstddef>
#include <epura/epura.hpp>
#include <string>

#include "apart.hpp"

namespace epura::bench {

/// The usual fineness of a tessellation: diagonal / deflection.
inline constexpr double usual_fineness = 1500;

struct Direction {
  const char* name;
  std::array<double, 3> viewer;
};
inline constexpr std::array<Direction, 3> directions{
    {{"isometric", {1, -1, 1}}, {"front", {0, -1, 0}}, {"top", {0, 0, 1}}}};

/// One view on A4, with hidden lines; a picture, in which helical threads are drawn as they are, not as in ISO 6410-1.
/// By one thread, since parts are drawn in parallel.
Drawing drawing_of(const Model& part, const Direction& direction);

/// Number of chains of lines, as a pen draws them.
double strokes_of(const Drawing& drawing);

/// Why there are no numbers, and at which stage.
std::string sentence_of(const Outcome& outcome);

/// Writes one row of a table at once.
void print(const std::string& line);

/// The share of a number, as a percentage.
std::string percent(std::size_t count, std::size_t all);

}  // namespace epura::bench
