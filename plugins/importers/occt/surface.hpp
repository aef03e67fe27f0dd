// SPDX-License-Identifier: Apache-2.0
// Which of the simple surfaces a face lies on.
#pragma once

#include <TopoDS_Face.hxx>
#include <epura/importer_plugin.hpp>

namespace occt {

/// Also where the file describes it as trimmed, offset, swept or by splines. In the coordinates that the face stands
/// in; the axis of a plane points outward.
epura_face surface_of(const TopoDS_Face& face);

}  // namespace occt
