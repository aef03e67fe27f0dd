// SPDX-License-Identifier: Apache-2.0
// What a motion is, in words of a drawing office.
#pragma once

#include <functional>
#include <string>

#include "definition/account.hpp"

namespace epura::definition {

/// Writes a length, in mm.
using LengthText = std::function<std::string(double)>;

/// "plane face of 1200 mm² at (10, 20, 30)"
std::string name_of_face(const Face& face, const LengthText& length);

/// "bore of ... and 2 more faces can move along x: add a distance along x". Of a face that is a round one, size and
/// place name it; of several that do the same, the largest.
std::string sentence_of(const Motion& motion, const Part& part, const Unknowns& unknowns, const LengthText& length);

}  // namespace epura::definition
