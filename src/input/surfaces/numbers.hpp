// SPDX-License-Identifier: Apache-2.0
// The numbers by which people and scene files call holes and faces of a part: by what and where they are, whatever
// their order in the file.
#pragma once

#include <string>
#include <vector>

#include "surfaces/holes.hpp"

namespace epura::surfaces {

/// The middle of each face: the centre of its area. Units of the file.
std::vector<Vec3> middles_of_faces(const mesh::Mesh& mesh, const PartFaces& part);

/// The end of the axis where a hole begins: the open one; of a through hole the upper one (z), or else the right one
/// (x), or else the rear one (y).
Vec3 mouth_of(const Hole& hole);

/// Indices of faces in the order of their numbers from 1: by kind, then from left to right (x), from the front to the
/// rear (y), upwards (z), by area. Places that differ by less than a ten-thousandth of the size of the part are one, so
/// that rounding does not matter. `middles` are those of the faces.
std::vector<int> numbered_faces(const PartFaces& part, const std::vector<Vec3>& middles);

/// Likewise of holes, by the places of their mouths, then by diameter.
std::vector<int> numbered_holes(const std::vector<Hole>& holes);

/// The number of each by its index, from an order.
std::vector<int> numbers_in(const std::vector<int>& order);

/// "hole 1 to 4, 7": numbers in ascending order.
std::string numbers_text(const std::string& what, const std::vector<int>& numbers);

}  // namespace epura::surfaces
