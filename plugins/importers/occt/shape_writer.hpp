// SPDX-License-Identifier: Apache-2.0
// One shape with facets -> points, faces and edges of the part for epura.
#pragma once

#include <TopoDS_Shape.hxx>
#include <epura/importer_plugin.hpp>
#include <functional>
#include <string>

namespace epura_occt {

/// What of a shape is not drawn.
struct Missing {
  int faces = 0;  ///< that got no facets
  int wires = 0;  ///< edges without a face
};

/// The name that the file gives to a part of a shape; empty where it gives none.
using NameOf = std::function<std::string(const TopoDS_Shape&)>;

/// Hands over a shape whose faces have facets, in its own coordinates. Faces share the points of their edges.
Missing write_shape(const TopoDS_Shape& shape, const std::string& name, const NameOf& name_of,
                    epura::plugin::Sink& sink);

}  // namespace epura_occt
