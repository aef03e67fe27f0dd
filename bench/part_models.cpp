// SPDX-License-Identifier: Apache-2.0
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "base/text.hpp"
#include "part_geometry.hpp"

namespace epura::bench {

namespace {

namespace fs = std::filesystem;
using Shape = TopoDS_Shape;

constexpr double pi = std::numbers::pi;

gp_Ax2 upright(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }
gp_Ax2 along_x(double x) { return {gp_Pnt(x, 0, 0), gp_Dir(1, 0, 0)}; }

Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }
Shape cylinder(const gp_Ax2& axis, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(axis, radius, height).Shape();
}
Shape cone(const gp_Ax2& axis, double radius, double other_radius, double height) {
  return BRepPrimAPI_MakeCone(axis, radius, other_radius, height).Shape();
}

Shape cut(const Shape& shape, const Shape& tool) { return BRepAlgoAPI_Cut(shape, tool).Shape(); }

/// Merges faces that continue each other on one surface.
Shape fuse(const Shape& shape, const Shape& other) {
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(shape, other).Shape());
  unify.Build();
  return unify.Shape();
}

/// Applies `Maker` to the first `count` edges of the shape.
template <class Maker>
Shape with_edges(const Shape& shape, double size, int count = std::numeric_limits<int>::max()) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  Maker maker(shape);
  for (int i = 1; i <= std::min(count, edges.Extent()); ++i) maker.Add(size, TopoDS::Edge(edges(i)));
  return maker.Shape();
}
constexpr auto fillet = with_edges<BRepFilletAPI_MakeFillet>;
constexpr auto chamfer = with_edges<BRepFilletAPI_MakeChamfer>;

Shape prism(const std::vector<gp_Pnt>& corners, const gp_Vec& height) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& corner : corners) outline.Add(corner);
  outline.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), height).Shape();
}

TopoDS_Wire ring(const gp_Ax2& axis, double radius) {
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axis, radius)).Edge()).Wire();
}

Shape drilled_plate() {
  const Shape plate = fillet(box(80, 50, 12), 3, 4);
  return cut(cut(plate, cylinder(upright(20, 25, -1), 8, 20)), cylinder(upright(55, 25, -1), 5, 20));
}

/// Both rims have a fold of 15.6 degrees: less than between the facets of a coarse round face.
Shape cone_on_cylinder() {
  const double narrower = 10 * std::tan(15.6 * pi / 180);
  return fuse(cylinder(upright(0, 0, 0), 20, 30), cone(upright(0, 0, 30), 20, 20 - narrower, 10));
}

Shape nut() {
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < 6; ++i) corners.emplace_back(10 * std::cos(i * pi / 3), 10 * std::sin(i * pi / 3), 0);
  const Shape chamfered = BRepAlgoAPI_Common(prism(corners, {0, 0, 8}), cone(upright(0, 0, -8), 26, 8.36, 24)).Shape();
  return cut(chamfered, cylinder(upright(0, 0, -1), 5, 12));
}

Shape tee(double branch_radius) {
  return fuse(cylinder(along_x(-40), 12, 80), cylinder(upright(0, 0, 0), branch_radius, 35));
}

Shape hub() { return fuse(cylinder(upright(0, 0, 0), 40, 8), cylinder(upright(0, 0, 8), 18, 30)); }

Shape flange() {
  Shape shape = cut(hub(), cylinder(upright(0, 0, -1), 11, 60));
  for (int i = 0; i < 6; ++i)
    shape = cut(shape, cylinder(upright(30 * std::cos(i * pi / 3), 30 * std::sin(i * pi / 3), -1), 3.5, 20));
  return shape;
}

Shape drilled_ball() {
  return cut(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 20).Shape(), cylinder(upright(0, 0, -30), 7, 60));
}

Shape elbow() {
  const Shape bend = BRepPrimAPI_MakeTorus(upright(0, 0, 0), 30, 8, pi / 2).Shape();
  return fuse(fuse(bend, cylinder({gp_Pnt(30, 0, 0), gp_Dir(0, -1, 0)}, 8, 20)),
              cylinder({gp_Pnt(0, 30, 0), gp_Dir(-1, 0, 0)}, 8, 20));
}

Shape loft() {
  BRepOffsetAPI_ThruSections sections(/*isSolid=*/true, /*ruled=*/false);
  sections.AddWire(ring(upright(0, 0, 0), 20));
  sections.AddWire(ring(upright(5, 0, 15), 12));
  sections.AddWire(ring(upright(0, 5, 35), 16));
  return sections.Shape();
}

Shape countersunk_plate() {
  Shape shape = box(50, 30, 10);
  for (const double x : {10, 25, 40}) {
    shape = cut(shape, cylinder(upright(x, 15, -1), 3, 20));
    shape = cut(shape, cone(upright(x, 15, 7), 3, 6, 3));
  }
  return shape;
}

Shape stepped_shaft() {
  const Shape thick = fuse(cylinder(along_x(0), 10, 30), cylinder(along_x(30), 14, 20));
  return chamfer(fuse(thick, cylinder(along_x(50), 8, 25)), 1, std::numeric_limits<int>::max());
}

Shape pocket() {
  const Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(10, 10, 8), 40, 40, 30).Shape();
  return cut(box(60, 60, 20), fillet(tool, 6, std::numeric_limits<int>::max()));
}

/// Its upper faces have folds of two degrees: less than the limit for tangent faces.
Shape wedge() {
  return prism({gp_Pnt(0, 0, 0), gp_Pnt(60, 0, 0), gp_Pnt(60, 0, 5), gp_Pnt(30, 0, 7), gp_Pnt(0, 0, 10)}, {0, 30, 0});
}

template <class Reader>
Shape transferred(const fs::path& file) {
  Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error("cannot be read");
  reader.TransferRoots();
  return reader.OneShape();
}

std::string kind_of(const fs::path& file) { return to_lower(file.extension().string()); }

bool is_part(const fs::path& file) {
  const std::string kind = kind_of(file);
  return kind == ".step" || kind == ".stp" || kind == ".iges" || kind == ".igs" || kind == ".brep";
}

Shape read_part(const fs::path& file) {
  const std::string kind = kind_of(file);
  if (kind == ".step" || kind == ".stp") return transferred<STEPControl_Reader>(file);
  if (kind == ".iges" || kind == ".igs") return transferred<IGESControl_Reader>(file);
  Shape shape;
  if (!BRepTools::Read(shape, file.c_str(), BRep_Builder())) throw std::runtime_error("cannot be read");
  return shape;
}

}  // namespace

std::vector<Part> made_parts() {
  constexpr int all = std::numeric_limits<int>::max();
  return {{"filleted box", [] { return fillet(box(60, 40, 25), 5, all); }},
          {"chamfered box", [] { return chamfer(box(60, 40, 25), 3, all); }},
          {"drilled plate", drilled_plate},
          {"cone on cylinder", cone_on_cylinder},
          {"nut", nut},
          {"tee", [] { return tee(8); }},
          {"equal tee", [] { return tee(12); }},
          {"flange", flange},
          {"filleted flange", [] { return fillet(hub(), 3, all); }},
          {"drilled ball", drilled_ball},
          {"elbow", elbow},
          {"loft", loft},
          {"countersunk plate", countersunk_plate},
          {"stepped shaft", stepped_shaft},
          {"pocket", pocket},
          {"wedge", wedge}};
}

std::vector<Part> parts_in(const fs::path& path) {
  std::vector<fs::path> files;
  if (fs::is_directory(path)) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file() && is_part(entry.path())) files.push_back(entry.path());
  } else if (fs::is_regular_file(path) && is_part(path)) {
    files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  std::vector<Part> parts;
  for (const fs::path& file : files) parts.push_back({file.filename().string(), [file] { return read_part(file); }});
  return parts;
}

}  // namespace epura::bench
