// SPDX-License-Identifier: Apache-2.0
// The independent bodies of a shape: its solids, its shells, and its loose faces, sewn together where they meet.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace occt {

struct Bodies {
  std::vector<TopoDS_Shape> shapes;      ///< solids, shells, and a compound of the faces that meet no other
  std::size_t loose = 0, sewn_into = 0;  ///< open shells and faces before and after sewing, if that helped
};

Bodies bodies_of(const TopoDS_Shape& shape);

}  // namespace occt
