// SPDX-License-Identifier: Apache-2.0
// What a motion is, in words of a drawing office.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "definition/account.hpp"

namespace epura::definition {

/// Writes a length, in mm.
using LengthText = std::function<std::string(double)>;

/// "plane face 12 of 1200 mm² at (10, 20, 30)"; without a number for 0.
std::string name_of_face(const Face& face, const LengthText& length, int number = 0);

/// What a motion does, and what would forbid it.
struct Words {
  int face;            ///< the largest of the faces that do it; -1: none of the model does
  std::size_t others;  ///< how many more there are
  std::string can;     ///< "can move along x"
  std::string add;     ///< "a distance along x"
  Vec3 along;          ///< unit: of the move, of the axis of the turn or of the size; 0: it has none
  bool is_move;        ///< so that views beside the direction show it; otherwise those along it do
};
Words words_of(const Motion& motion, const Part& part, const Unknowns& unknowns);

/// "plane face 12 of ... and 2 more faces: can move along x; add a distance along x"
std::string sentence_of(const Words& words, const Part& part, const LengthText& length, int number = 0);

}  // namespace epura::definition
