// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: one part drawn in several ways, by the format in which it happens to arrive.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>

#include "archive.hpp"
#include "base/text.hpp"
#include "program.hpp"
#include "support.hpp"

namespace epura::test::same_part_test {
namespace {

using Triangles = std::vector<std::array<gp_Pnt, 3>>;

constexpr double deflection = 0.01;  // mm, of the meshes

// A plate with rounded corners, a step, a bore through both, and two holes.
TopoDS_Shape part() {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-40, -25, 0), 80, 50, 12).Shape();
  BRepFilletAPI_MakeFillet rounded(plate);
  for (TopExp_Explorer edge(plate, TopAbs_EDGE); edge.More(); edge.Next()) {
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edge.Current()), from, to);
    gp_Pnt at;
    gp_Vec along;
    curve->D1(from, at, along);
    if (along.X() == 0 && along.Y() == 0) rounded.Add(8, TopoDS::Edge(edge.Current()));
  }
  TopoDS_Shape shape = rounded.Shape();
  const auto remove = [&](const gp_Pnt& foot, double radius, double height) {
    shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(foot, gp::DZ()), radius, height).Shape()).Shape();
  };
  remove({0, 0, -1}, 10, 20);
  remove({0, 0, 7}, 14, 10);
  remove({-30, 15, -1}, 3, 20);
  remove({30, -15, -1}, 3, 20);
  return shape;
}

Triangles triangles_of(const TopoDS_Shape& shape) {
  BRepMesh_IncrementalMesh(shape, deflection, false, 0.3);
  Triangles triangles;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      std::array<int, 3> v{};
      mesh->Triangle(t).Get(v[0], v[1], v[2]);
      if (face.Current().Orientation() == TopAbs_REVERSED) std::swap(v[1], v[2]);
      const auto point = [&](int i) { return mesh->Node(i).Transformed(place.Transformation()); };
      triangles.push_back({point(v[0]), point(v[1]), point(v[2])});
    }
  }
  return triangles;
}

std::string in_text(const gp_Pnt& p, const std::array<std::string, 4>& around) {
  return around[0] + format_number(p.X()) + around[1] + format_number(p.Y()) + around[2] + format_number(p.Z()) +
         around[3];
}

std::string stl_of(const Triangles& triangles) {
  std::string text = "solid part\n";
  for (const auto& triangle : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const gp_Pnt& p : triangle) text += in_text(p, {"vertex ", " ", " ", "\n"});
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

std::string threemf_of(const Triangles& triangles) {
  std::string vertices, faces;
  int next = 0;
  for (const auto& triangle : triangles) {
    for (const gp_Pnt& p : triangle) vertices += in_text(p, {"<vertex x=\"", "\" y=\"", "\" z=\"", "\"/>"});
    faces += "<triangle v1=\"" + std::to_string(next) + "\" v2=\"" + std::to_string(next + 1) + "\" v3=\"" +
             std::to_string(next + 2) + "\"/>";
    next += 3;
  }
  return archive_of(entries_with(model_of("<object id=\"1\" type=\"model\"><mesh><vertices>" + vertices +
                                              "</vertices><triangles>" + faces + "</triangles></mesh></object>",
                                          "<item objectid=\"1\"/>")));
}

std::string step_of(const Folder& folder, const TopoDS_Shape& shape) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const std::string path = (folder / "part.step").string();
  EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  return path;
}

TEST(SamePart, IsDrawnAlikeFromStepStlAnd3mf) {
  const Folder folder;
  const TopoDS_Shape shape = part();
  const std::string step = step_of(folder, shape);
  const Triangles triangles = triangles_of(shape);
  // Drawn on A3 at most at 2:1. Ink is off by 0.02 mm on paper from STEP, and by twice the deflection from the others.
  const std::string tolerance = format_number(0.02 + 2 * deflection + 0.001);
  for (const std::string& mesh :
       {folder.file("part.stl", stl_of(triangles)), folder.file("part.3mf", threemf_of(triangles))}) {
    const Outcome run =
        epura({"compare", step, mesh, "--views", "isometric,front,top", "--tolerance", tolerance}, folder / "");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
  }
}

}  // namespace
}  // namespace epura::test::same_part_test
