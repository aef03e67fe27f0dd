// SPDX-License-Identifier: Apache-2.0
// What a sheet says of the faces of a part: dimensions, as rows that are zero when it holds.
//
// Whatever moves or turns the part as a whole changes none of them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "definition/unknowns.hpp"

namespace epura::definition {

struct Statement {
  std::string name;  ///< by which it is told of: "52 along x"
  std::vector<Row> rows;
  bool is_certain = true;    ///< otherwise it may be that the sheet says this
  double more = 0;           ///< what its text says beyond what the part has, as each row counts it
  double slack = 0;          ///< how far that may be off, by the last digit of the text
  bool is_by_count = false;  ///< said of equal things beside the one that is measured, as by "4×"
};

/// Where a length begins or ends: on faces, all of which go through the place, or on the axis or at the centre of one;
/// of two, where the axis of the first meets the plane of the second.
struct End {
  Vec3 at;
  std::vector<int> faces;
  bool is_axis = false;
};

/// How far an end goes along a direction as its faces change; nothing if they do not hold it in that direction. A
/// corner goes where its faces meet.
Row end_motion(const Unknowns& unknowns, const Part& part, const End& end, const Vec3& along);

/// The length along a direction from one end to another. The direction turns with that of a face; -1 if the ends are
/// one behind the other in it. Nothing if the faces do not hold both ends.
Row length(const Unknowns& unknowns, const Part& part, const std::array<End, 2>& ends, const Vec3& along,
           int direction_face);

/// The diameter of a circle in which faces end; across it, two points are taken.
Row diameter(const Unknowns& unknowns, const Part& part, const std::array<End, 2>& ends);

/// The angle, about a direction of sight, between the sides of two faces at places of theirs.
Row angle(const Unknowns& unknowns, const std::array<End, 2>& sides, const Vec3& sight);

}  // namespace epura::definition
