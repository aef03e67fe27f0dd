// SPDX-License-Identifier: Apache-2.0
// The simple surface on which a face lies.
#pragma once

#include <TopoDS_Face.hxx>
#include <epura/importer_plugin.hpp>

namespace occt {

/// Also recognises surfaces described as trimmed, offset, swept or by splines. In the coordinates of the face; the axis
/// of a plane points outward.
epura_face surface_of(const TopoDS_Face& face);

}  // namespace occt
