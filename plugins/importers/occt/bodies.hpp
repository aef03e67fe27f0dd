// SPDX-License-Identifier: Apache-2.0
// The independent bodies of a shape: its solids, its shells, and its loose faces, sewn together where they meet.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <vector>

namespace occt {

struct Bodies {
  std::vector<TopoDS_Shape> closed;      ///< solids first, then closed shells
  std::size_t solids = 0;                ///< those of `closed` that the file declares to be solids
  std::vector<TopoDS_Shape> open;        ///< shells, and a compound of the faces that meet no other
  std::size_t loose = 0, sewn_into = 0;  ///< open shells and faces before and after sewing, if that helped
};

Bodies bodies_of(const TopoDS_Shape& shape);

/// Which bodies are anywhere in a shape.
struct Company {
  bool has_solid = false, has_closed_shell = false;
};

Company company_in(const TopoDS_Shape& shape);

}  // namespace occt
