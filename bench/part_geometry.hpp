// SPDX-License-Identifier: Apache-2.0
// Parts with exact surfaces, their tessellations as exported by CAD systems, and their exact views.
#pragma once

#include <HLRAlgo_Projector.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <epura/scene.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::bench {

struct Part {
  std::string name;
  std::function<TopoDS_Shape()> make;  ///< or reads it; may throw exceptions of Open CASCADE or the standard library
};

/// Parts with typical mechanical features: fillets, chamfers, bores, intersecting pipes, cones on cylinders, free
/// forms.
std::vector<Part> made_parts();

/// A file in STEP, IGES or the format of Open CASCADE, or all such files in a folder and its subfolders, by path.
std::vector<Part> parts_in(const std::filesystem::path& path);

/// The triangles within diagonal / `fineness` of the surfaces, as in an STL file: in 32 bits, and without the faces
/// they come from.
Polygons tessellate(const TopoDS_Shape& part, double fineness);

/// The same by another mesher, the program gmsh: the bytes of an STL file with `around` triangles along a full turn;
/// nothing if it is not installed or cannot mesh the part.
std::optional<std::string> stl_by_gmsh(const TopoDS_Shape& part, int around);

/// In a plane with axes `right` and `up` of the world.
using PlaneLine = std::array<Vec2, 2>;

struct ExactView {
  Vec3 right, up;
  std::vector<PlaneLine> visible, hidden;  ///< sharp edges and outlines
  std::vector<PlaneLine> smooth_visible, smooth_hidden;
  int lost = 0;  ///< curves that Open CASCADE found but cannot follow
};

/// Marks edges of the shape as tangent if faces meet within 5 degrees along their whole length: readers omit many
/// marks.
void mark_tangent_edges(const TopoDS_Shape& shape);

/// How Open CASCADE projects: from the direction `viewer`, or from the point in it that is `eye` away from the origin,
/// if that is not 0, onto the plane through the origin; z is up, or y for a view along z.
HLRAlgo_Projector projector_of(const Vec3& viewer, double eye = 0);

/// By Open CASCADE's exact hidden-line removal, projected like that. Curves become polylines within diagonal /
/// `fineness`.
ExactView exact_view(const TopoDS_Shape& part, const Vec3& viewer, double fineness = 4000, double eye = 0);

}  // namespace epura::bench
