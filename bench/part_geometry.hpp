// SPDX-License-Identifier: Apache-2.0
// Parts with exact surfaces, what a CAD system exports of them, and what is to be seen of them.
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <epura/scene.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::bench {

struct Part {
  std::string name;
  std::function<TopoDS_Shape()> make;  ///< or reads it; throws what Open CASCADE or the standard library throws
};

/// Parts with what mechanical parts have: fillets, chamfers, bores, pipes that meet, cones on cylinders, free forms.
std::vector<Part> made_parts();

/// A file in STEP, IGES or the format of Open CASCADE, or all of them in a folder and its folders, by their paths.
std::vector<Part> parts_in(const std::filesystem::path& path);

/// The triangles within diagonal / `fineness` of the surfaces, as an STL file keeps them: in 32 bits, and nothing of
/// the faces they come from.
Polygons tessellate(const TopoDS_Shape& part, double fineness);

/// In a plane with axes `right` and `up` of the world.
using PlaneLine = std::array<Vec2, 2>;

struct ExactView {
  Vec3 right, up;
  std::vector<PlaneLine> visible, hidden;  ///< sharp edges and outlines
  std::vector<PlaneLine> smooth_visible, smooth_hidden;
  int lost = 0;  ///< curves that Open CASCADE found and cannot follow
};

/// Marks edges as tangent in the shape where faces meet within 5 degrees all along: readers leave many out.
void mark_tangent_edges(const TopoDS_Shape& shape);

/// By Open CASCADE's exact hidden-line removal. `viewer` points to the viewer; z is up, or y where the view is along z.
ExactView exact_view(const TopoDS_Shape& part, const Vec3& viewer);

}  // namespace epura::bench
