// SPDX-License-Identifier: Apache-2.0
// Judges what a note says of the walls about the circle where it ends, and of how many there are.
#pragma once

#include <string>

#include "sheet/notation.hpp"
#include "sizes/hole_walls.hpp"
#include "sizes/note_text.hpp"

namespace epura::sheet {

inline constexpr double angle_doubt = 0.02;  ///< degrees, of fitted cones

/// What is found of one text. The first fault is told.
struct Verdict {
  std::string has{};     ///< the part, where the text says otherwise
  std::string unsure{};  ///< of what nobody can tell

  void doubt(const std::string& what) {
    if (unsure.empty()) unsure = what;
  }
  void deny(const std::string& what) {
    if (has.empty()) has = what;
  }
};

/// Whether an element says something of a hole.
bool is_of_hole(const NotedElement& one);

/// A length or an angle as verdicts state it.
std::string number_text(double millimetres, const Notation& notation);

/// Whether a leader ends at the rim of the recess that its note gives, whose diameter it then has.
bool is_at_recess(const NotedText& text, double diameter, const HoleWalls& walls);

/// The circle that the size of a note means: of a thread its bore, of a note at its recess the wall below.
WorldCircle circle_meant(const NotedText& text, WorldCircle noted, const HoleWalls& walls);

/// Of what is understood of the text.
void judge_hole(Verdict& verdict, const NotedText& text, const WorldCircle& noted, const HoleWalls& walls,
                const Notation& notation);

}  // namespace epura::sheet
