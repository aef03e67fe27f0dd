// SPDX-License-Identifier: Apache-2.0
#include "edges/edge_kind.hpp"

namespace epura {

std::string_view name_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::contour:
      return "contour";
    case EdgeKind::boundary:
      return "boundary";
    case EdgeKind::crease:
      return "crease";
    case EdgeKind::intersection:
      return "intersection";
    case EdgeKind::section:
      return "section";
    case EdgeKind::tangent:
      return "tangent";
    case EdgeKind::smooth:
      return "smooth";
  }
  return "";
}

}  // namespace epura
