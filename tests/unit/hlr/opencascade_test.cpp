// SPDX-License-Identifier: Apache-2.0
// Shapes of Open CASCADE, drawn with the lengths that their formulas give.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <epura/hlr_opencascade.hpp>
#include <map>
#include <utility>

#include "shapes.hpp"

namespace epura::test::opencascade_test {
namespace {

struct Drawn {
  HlrModel model;
  AddedShape added;
  Drawing drawing;

  explicit Drawn(const TopoDS_Shape& shape, const std::array<double, 16>& matrix = isometric, std::uint32_t kinds = 0,
                 double deflection = 0.005) {
    added = add_shape(*model.sink, shape, deflection);
    model.finish();
    epura_hlr_request request = request_for(matrix);
    request.kinds = kinds;
    request.arcs = 0.01;
    drawing = model.draw(request);
  }
  [[nodiscard]] double length(bool visible) const {
    return length_of_all(drawing, [=](const epura_hlr_curve& c) { return (c.visible != 0) == visible; });
  }
};

const double foreshortened = std::sqrt(2.0 / 3);

TEST(OpenCascadeShapes, BoxHasItsFacesAndEdges) {
  const Drawn box(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  EXPECT_EQ(box.added.faces.size(), 6U);
  EXPECT_EQ(box.added.edges.size(), 12U);
  EXPECT_NEAR(box.length(true), foreshortened * 18, 1e-9);
  EXPECT_NEAR(box.length(false), foreshortened * 6, 1e-9);
  for (const epura_hlr_curve& curve : curves_of(box.drawing)) {
    ASSERT_LT(curve.edge, 12U);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(box.added.faces[curve.faces[0].face], TopAbs_EDGE, edges);
    EXPECT_TRUE(edges.Contains(box.added.edges[curve.edge]));
  }
}

TEST(OpenCascadeShapes, CylinderIsTwoRimsAndTwoGenerators) {
  const Drawn cylinder(BRepPrimAPI_MakeCylinder(5, 12).Shape());
  EXPECT_EQ(cylinder.added.faces.size(), 3U);
  EXPECT_EQ(cylinder.added.edges.size(), 2U) << "the seam is none";
  // From the viewer at (1, -1, 1), circles are ellipses with semi-axes 5 and 5 / sqrt 3.
  double ellipse = 0;
  for (int i = 0; i < 36000; ++i) {
    const double a = 2 * std::numbers::pi * (i + 0.5) / 36000;
    ellipse += 5 * std::hypot(std::sin(a), std::cos(a) / std::sqrt(3)) * 2 * std::numbers::pi / 36000;
  }
  EXPECT_NEAR(cylinder.length(true), 1.5 * ellipse + 2 * 12 * foreshortened, 5e-3);
  EXPECT_NEAR(cylinder.length(false), ellipse / 2, 5e-3);
}

TEST(OpenCascadeShapes, SphereHasNeitherSeamNorPoles) {
  const Drawn sphere(BRepPrimAPI_MakeSphere(5).Shape());
  EXPECT_EQ(sphere.added.faces.size(), 1U);
  EXPECT_TRUE(sphere.added.edges.empty());
  for (const epura_hlr_curve& curve : curves_of(sphere.drawing)) {
    EXPECT_EQ(curve.kind, std::uint32_t{EPURA_HLR_CONTOUR});
    const double* points = epura_hlr_result_of(sphere.drawing.get())->points + 2 * curve.first;
    for (std::uint64_t i = 0; i < curve.count; ++i)
      EXPECT_NEAR(std::hypot(points[2 * i], points[2 * i + 1]), 5, 0.01);  // by facets, which are 0.005 off
  }
}

TEST(OpenCascadeShapes, TorusFromAboveIsTwoCircles) {
  const Drawn torus(BRepPrimAPI_MakeTorus(10, 3).Shape(), top);
  EXPECT_NEAR(torus.length(true), 2 * std::numbers::pi * (13 + 7), 0.05);
}

// A shape of Open CASCADE's own tests of hidden lines, and the length that these expect.
TEST(OpenCascadeShapes, TorusOfOtherTestsHasTheirLength) {
  const Drawn torus(BRepPrimAPI_MakeTorus(30, 10).Shape(), isometric, 0, 0.02);
  EXPECT_NEAR(torus.length(true), 302.685, 0.1);
}

TEST(OpenCascadeShapes, ConeFromAboveIsItsRim) {
  const Drawn cone(BRepPrimAPI_MakeCone(6, 0, 9).Shape(), top);
  EXPECT_NEAR(cone.length(true), 2 * std::numbers::pi * 6, 0.01);
}

TEST(OpenCascadeShapes, BoreIsSeenThrough) {
  const TopoDS_Shape bored =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 4).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10, 10, -1), gp_Dir(0, 0, 1)), 5, 9).Shape());
  const Drawn plate(bored, top);
  EXPECT_EQ(plate.added.faces.size(), 7U);
  EXPECT_NEAR(plate.length(true), 80 + 2 * std::numbers::pi * 5, 0.01);
}

TEST(OpenCascadeShapes, FilletsMeetTheirNeighboursSmoothly) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(2, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const Drawn rounded(fillet.Shape());
  EXPECT_EQ(rounded.added.faces.size(), 7U);
  const Drawn with_tangents(fillet.Shape(), isometric, EPURA_HLR_USUAL | EPURA_HLR_TANGENT);
  const auto is_tangent = [](const epura_hlr_curve& c) { return c.kind == EPURA_HLR_TANGENT; };
  EXPECT_EQ(length_of_all(rounded.drawing, is_tangent), 0);
  EXPECT_GT(length_of_all(with_tangents.drawing, is_tangent), 10 * foreshortened);
}

TEST(OpenCascadeShapes, MirroredAndMovedOnesAreTheSame) {
  gp_Trsf mirror, move;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  move.SetTranslation(gp_Vec(7, 8, 9));
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(6, 2, 9).Shape();
  const double length = Drawn(cone).length(true);
  EXPECT_NEAR(Drawn(cone.Moved(TopLoc_Location(move))).length(true), length, 1e-6);
  EXPECT_NEAR(Drawn(cone.Located(TopLoc_Location(mirror), false)).length(true), length, 5e-3);  // facets are others
}

TEST(OpenCascadeShapes, WiresHaveNumbersOfTheirOwn) {
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  BRep_Builder().Add(all, BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  BRep_Builder().Add(all, BRepBuilderAPI_MakeEdge(gp_Pnt(5, 5, 0), gp_Pnt(9, 5, 0)).Edge());
  const Drawn drawn(all, top);
  ASSERT_EQ(drawn.added.wires.size(), 1U);
  EXPECT_NEAR(
      length_of_all(drawn.drawing, [](const epura_hlr_curve& c) { return c.kind == EPURA_HLR_WIRE && c.edge == 0; }), 4,
      1e-9);
}

// Where two cylinders of different size meet, Open CASCADE has B-splines.
TEST(OpenCascadeShapes, SplinesOfEdgesAreSeenWhereTheirCurvesAre) {
  const TopoDS_Shape tee =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -20), gp_Dir(0, 0, 1)), 10, 40).Shape(),
                       BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, -1, 0)), 6, 30).Shape())
          .Shape();
  gp_Trsf move;
  move.SetTranslation(gp_Vec(7, 8, 9));
  for (const TopoDS_Shape& shape : {tee, tee.Moved(TopLoc_Location(move))}) {
    HlrModel model;
    const AddedShape added = add_shape(*model.sink, shape, 0.005);
    model.finish();
    epura_hlr_request request = request_for(isometric);
    request.all_types = 1;
    const Drawing drawing = model.draw(request);
    std::map<std::uint32_t, double> parts;  // of each edge: parameters between which it is seen, or hidden
    bool is_any_visible = false, is_any_hidden = false;
    for (const epura_hlr_curve& curve : curves_of(drawing)) {
      if (curve.type != EPURA_HLR_SPLINE) continue;
      (curve.visible != 0 ? is_any_visible : is_any_hidden) = true;
      parts[curve.edge] += std::abs(curve.to - curve.from);
      const BRepAdaptor_Curve edge(added.edges[curve.edge]);
      ASSERT_EQ(edge.GetType(), GeomAbs_BSplineCurve);
      const double* points = epura_hlr_result_of(drawing.get())->points + 2 * curve.first;
      for (const auto& [parameter, place] :
           {std::pair(curve.from, points), std::pair(curve.to, points + 2 * (curve.count - 1))}) {
        const gp_Pnt p = edge.Value(parameter);
        for (std::size_t row = 0; row < 2; ++row) {
          const double* m = isometric.data() + 4 * row;
          EXPECT_NEAR(m[0] * p.X() + m[1] * p.Y() + m[2] * p.Z(), place[row], 0.006) << "of facets 0.005 off";
        }
      }
    }
    EXPECT_TRUE(is_any_visible && is_any_hidden);
    for (std::uint32_t i = 0; i < added.edges.size(); ++i) {
      const BRepAdaptor_Curve edge(added.edges[i]);
      if (edge.GetType() != GeomAbs_BSplineCurve) continue;
      EXPECT_NEAR(parts[i], edge.LastParameter() - edge.FirstParameter(), 1e-2 * parts[i]) << i;
    }
    EXPECT_FALSE(parts.empty());
  }
}

}  // namespace
}  // namespace epura::test::opencascade_test
