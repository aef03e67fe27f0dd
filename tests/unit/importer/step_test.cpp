// SPDX-License-Identifier: Apache-2.0
// STEP, IGES and BREP files that Open CASCADE writes here, of parts whose faces, edges and volumes are known.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Parab.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>
#include <regex>

#include "shapes.hpp"
#include "support.hpp"

namespace epura::test::step_test {
namespace {

using surfaces::SurfaceKind;

void be_quiet() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

std::string step_file(const Folder& folder, const TopoDS_Shape& shape, const char* unit = "MM") {
  be_quiet();
  const STEPControl_Writer before;  // without one, settings are not there yet
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const std::string path = (folder / "part.step").string();
  EXPECT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  Interface_Static::SetCVal("write.step.unit", "MM");
  return path;
}

std::map<SurfaceKind, int> kinds_of(const surfaces::PartFaces& part) {
  std::map<SurfaceKind, int> kinds;
  for (const surfaces::PartFace& face : part.faces) ++kinds[face.surface.kind];
  return kinds;
}

int count(const surfaces::PartFaces& part, surfaces::BorderKind kind) {
  return static_cast<int>(std::count_if(part.borders.begin(), part.borders.end(),
                                        [&](const surfaces::PartBorder& b) { return b.kind == kind; }));
}

importer::ReadModel read(const std::string& path, const foreign::Assignments& parameters = {}) {
  return importer::read_model(path, parameters, {.plugin_path = {EPURA_TEST_IMPORTERS}});
}

TopoDS_Shape block_with_bore() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(),
                         BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 15, 0), gp::DZ()), 5, 20).Shape())
      .Shape();
}

TEST(StepImporter, BringsFacesAndEdgesOfThePart) {
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, block_with_bore()));
  EXPECT_EQ(model.mesh.report.format, "step");
  EXPECT_EQ(model.mesh.report.open_edges, 0);
  EXPECT_EQ(model.mesh.report.misoriented_edges, 0);
  ASSERT_NE(model.part, nullptr);
  EXPECT_EQ(kinds_of(*model.part), (std::map<SurfaceKind, int>{{SurfaceKind::plane, 6}, {SurfaceKind::cylinder, 1}}));
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::sharp), 14);  // 12 of the block, two rims
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::tangent), 0);
  for (const surfaces::PartFace& face : model.part->faces) {
    if (face.surface.kind != SurfaceKind::cylinder) continue;
    EXPECT_TRUE(face.inwards);
    EXPECT_EQ(face.sweep, 360);
    EXPECT_NEAR(face.surface.radius, 5, 1e-12);
    EXPECT_NEAR(face.to - face.from, 20, 1e-9);
  }
  for (const surfaces::PartBorder& border : model.part->borders) EXPECT_NEAR(border.angle, 90, 1e-6);
  // Chords of the bore lie inside of it: too much material, by no more than the tolerance all around.
  const double exact = 40 * 30 * 20 - std::numbers::pi * 25 * 20, tolerance = 1e-4 * std::sqrt(1600 + 900 + 400);
  EXPECT_GT(volume_of(model.mesh), exact);
  EXPECT_LT(volume_of(model.mesh), exact + 2 * std::numbers::pi * 5 * 20 * tolerance);
}

TopoDS_Shape compound_of(const std::vector<TopoDS_Shape>& shapes) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

TopoDS_Shape circle(double radius, double height) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, height), gp::DZ()), radius)).Shape();
}

TopoDS_Shape point(double x, double y, double z) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Shape(); }

// Of pieces that no face has.
struct Wires {
  int pieces = 0;
  double length = 0, lowest = 1e300, highest = -1e300;  ///< z
  std::map<int, int> ends;                              ///< how many pieces end at a vertex
};

Wires wires_of(const mesh::Mesh& mesh) {
  Wires wires;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    if (edge.count > 0) continue;
    const Vec3 a = mesh.point(edge.vertex[0]), b = mesh.point(edge.vertex[1]);
    ++wires.pieces;
    wires.length += glm::distance(a, b);
    for (const Vec3& p : {a, b})
      wires.lowest = std::min(wires.lowest, p.z), wires.highest = std::max(wires.highest, p.z);
    for (const int v : edge.vertex) ++wires.ends[v];
  }
  return wires;
}

const foreign::Assignments drawn{{"construction", "draw"}};

TEST(StepImporter, BringsEdgesWithoutFaces) {
  const Folder folder;
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(-5, 50, 5), gp_Pnt(35, 50, 5), gp_Pnt(35, 50, 65));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  const importer::ReadModel model = read(step_file(folder, compound_of({box, polygon.Wire(), circle(100, -7)})), drawn);
  ASSERT_NE(model.part, nullptr);
  EXPECT_EQ(model.part->faces.size(), 6U);
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::sharp), 12);
  EXPECT_TRUE(model.mesh.report.notes.empty()) << model.mesh.report.notes[0];
  const Wires wires = wires_of(model.mesh);
  const double tolerance = 1e-4 * std::hypot(200, 200, 72), around = wires.length - 100;
  // A chord that is off by d in the middle is shorter than its arc by 8 / 3 d^2 / chord or less.
  EXPECT_LT(around, 200 * std::numbers::pi);
  EXPECT_GT(around, 200 * std::numbers::pi * (1 - 4 * tolerance / 300));
  EXPECT_LT(wires.pieces, 2 + 200) << "finer than useful";
  EXPECT_EQ(wires.lowest, -7);
  EXPECT_EQ(wires.highest, 65);
  const auto open =
      std::count_if(wires.ends.begin(), wires.ends.end(), [](const auto& end) { return end.second == 1; });
  EXPECT_EQ(open, 2) << "of the polygon: the circle is closed";
}

TEST(StepImporter, DividesWiresAsItDividesEdges) {
  const Folder folder;
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 30).Shape();
  const mesh::Mesh mesh = read(step_file(folder, compound_of({cylinder, circle(10, 15)})), drawn).mesh;
  EXPECT_EQ(wires_of(mesh).pieces, wires_of(mesh).ends.size());
  for (const auto& [vertex, count] : wires_of(mesh).ends) {
    const Vec3 on_wire = mesh.point(vertex);
    double nearest = 1e300;  // to a vertex of the bottom, seen from above
    for (int v = 0; v < mesh.report.vertices; ++v)
      if (mesh.point(v).z == 0) nearest = std::min(nearest, glm::distance(Vec2(mesh.point(v)), Vec2(on_wire)));
    EXPECT_LT(nearest, 1e-10);
  }
}

world::World world_of(const importer::ReadModel& model) {
  return world::make_world({{std::make_shared<const mesh::Mesh>(model.mesh), Mat4(1.0), model.part}});
}

TEST(StepImporter, WiresAreHiddenByFaces) {
  const Folder folder;
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(-5, 50, 5), gp_Pnt(35, 50, 5), gp_Pnt(35, 50, 65));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  const importer::ReadModel model = read(step_file(folder, compound_of({box, polygon.Wire()})), drawn);
  const Result result = draw(world_of(model), orthographic({0, -1, 0}));
  double visible = 0, hidden = 0;
  for (const drawing::Segment& s : result.drawing.segments)
    if (s.kind == EdgeKind::wire) (s.visible ? visible : hidden) += glm::distance(s.from, s.to);
  // Of 40 to the right, from 0 to 35, and of 60 upwards, up to 20.
  EXPECT_NEAR(hidden / (visible + hidden), (35 + 15) / 100., 1e-9);
  EXPECT_GT(hidden, 0);
}

TEST(StepImporter, WiresOnRoundFacesAreSeenToTheContour) {
  const Folder folder;
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 30).Shape();
  const importer::ReadModel model = read(step_file(folder, compound_of({cylinder, circle(10, 15)})), drawn);
  const Result result = draw(world_of(model), orthographic({0.3, -1, 0.6}));
  std::map<bool, int> whole;
  int divided = 0;
  for (std::size_t e = 0; e < result.drawn.edges.size(); ++e) {
    if (result.drawn.edges[e].kind != EdgeKind::wire) continue;
    std::vector<bool> parts;
    result.hidden.visit_parts(e, [&](double, double, bool is_visible) { parts.push_back(is_visible); });
    if (parts.size() == 1) ++whole[parts[0]];
    if (parts.size() > 1) ++divided;
  }
  EXPECT_LE(divided, 2);
  EXPECT_NEAR(whole[true], whole[false], 2);
  EXPECT_GT(whole[true], 15);
}

TEST(StepImporter, ReadsFilesOfWiresOnly) {
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, circle(10, 3)));
  EXPECT_EQ(model.mesh.report.triangles, 0);
  EXPECT_EQ(model.part, nullptr);
  const Wires wires = wires_of(model.mesh);
  EXPECT_GT(wires.pieces, 17) << "twenty degrees at most";
  EXPECT_EQ(wires.ends.size(), static_cast<std::size_t>(wires.pieces));
  for (const auto& [vertex, count] : wires.ends) EXPECT_EQ(count, 2);
}

TEST(StepImporter, DrawsNoEdgeOfAFaceTwice) {
  const Folder folder;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  const TopoDS_Shape own = TopExp_Explorer(box, TopAbs_EDGE).Current();
  be_quiet();
  const std::string path = (folder / "part.brep").string();
  ASSERT_TRUE(BRepTools::Write(compound_of({box, own, point(0, 0, 90)}), path.c_str()));
  const importer::ReadModel model = read(path, drawn);
  EXPECT_EQ(model.mesh.report.wires, model.mesh.report.point_arms);
  EXPECT_EQ(model.mesh.report.points, 1);
}

TopoDS_Shape datum_plane() {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(20, 15, 10), gp::DX()), -100, 100, -100, 100).Shape();
}

constexpr const char* left_out =
    "1 surface, 2 lines and 1 point beside solids left out as construction geometry: FILE:construction=draw draws it";

/// A box with a plane, a sketch and a point, as one product in one representation.
std::string file_with_construction(const Folder& folder) {
  be_quiet();
  const STEPControl_Writer before;
  Interface_Static::SetCVal("write.step.assembly", "Off");
  BRepBuilderAPI_MakePolygon sketch(gp_Pnt(-5, 50, 5), gp_Pnt(35, 50, 5), gp_Pnt(35, 50, 65));
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  std::string path = step_file(folder, compound_of({box, datum_plane(), sketch.Wire(), point(0, 0, 90)}));
  Interface_Static::SetCVal("write.step.assembly", "Auto");
  return path;
}

void expect_construction_left_out(const std::string& path) {
  const importer::ReadModel model = read(path);
  expect_extent(model.mesh, Vec3(0), Vec3(40, 30, 20), 1e-12);
  EXPECT_EQ(model.mesh.report.open_edges, 0);
  EXPECT_EQ(model.mesh.report.wires, 0);
  EXPECT_EQ(model.mesh.report.points, 0);
  EXPECT_EQ(model.mesh.report.notes, (std::vector<std::string>{left_out}));
  const importer::ReadModel all = read(path, drawn);
  EXPECT_EQ(all.mesh.report.triangles, model.mesh.report.triangles + 2);
  EXPECT_EQ(all.mesh.report.open_edges, 4);
  EXPECT_EQ(all.mesh.report.points, 1);
  EXPECT_EQ(wires_of(all.mesh).pieces, 2 + all.mesh.report.point_arms);
  EXPECT_TRUE(all.mesh.report.notes.empty());
}

TEST(StepImporter, LeavesOutConstructionBesideSolids) {
  const Folder folder;
  expect_construction_left_out(file_with_construction(folder));
}

// Most programs write solids, surfaces and curves of a product into representations of their own.
TEST(StepImporter, LeavesOutConstructionInOtherRepresentationsOfTheProduct) {
  const Folder folder;
  std::string text = read_file(file_with_construction(folder));
  const std::regex all("(#\\d+) = SHAPE_REPRESENTATION\\('',\\((#\\d+),(#\\d+),([#\\d,]+)\\),(#\\d+)\\);");
  ASSERT_TRUE(std::regex_search(text, all));
  text = std::regex_replace(text, all,
                            "$1 = SHAPE_REPRESENTATION('',($2),$5);\n"
                            "#9001 = ADVANCED_BREP_SHAPE_REPRESENTATION('',($3),$5);\n"
                            "#9002 = SHAPE_REPRESENTATION('',($4),$5);\n"
                            "#9003 = SHAPE_REPRESENTATION_RELATIONSHIP('','',$1,#9001);\n"
                            "#9004 = SHAPE_REPRESENTATION_RELATIONSHIP('','',$1,#9002);");
  expect_construction_left_out(folder.file("separate.step", text));
}

TEST(StepImporter, SurfacesAndLinesWithoutASolidAreThePart) {
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, compound_of({datum_plane(), circle(10, 3)})));
  EXPECT_EQ(model.mesh.report.triangles, 2);
  EXPECT_GT(wires_of(model.mesh).pieces, 17);
  EXPECT_TRUE(model.mesh.report.notes.empty());
}

// One gap that is too wide makes a body an open surface.
TEST(StepImporter, SurfacesBesideSewnBodiesStay) {
  be_quiet();
  const Folder folder;
  std::vector<TopoDS_Shape> pieces{circle(10, 3)};
  for (TopExp_Explorer each(BRepPrimAPI_MakeBox(40, 30, 20).Shape(), TopAbs_FACE); each.More(); each.Next())
    pieces.push_back(each.Current());
  pieces.push_back(BRepPrimAPI_MakeBox(gp_Pnt(100, 0, 0), 40, 30, 20).TopFace());
  const std::string path = (folder / "part.brep").string();
  ASSERT_TRUE(BRepTools::Write(compound_of(pieces), path.c_str()));
  const importer::ReadModel model = read(path);
  EXPECT_EQ(model.mesh.report.triangles, 12 + 2);
  EXPECT_EQ(model.mesh.report.wires, 0);
  ASSERT_EQ(model.mesh.report.notes.size(), 2U);
  EXPECT_TRUE(model.mesh.report.notes[0].starts_with("1 line beside solids left out")) << model.mesh.report.notes[0];
  EXPECT_EQ(model.mesh.report.notes[1], "7 loose faces and shells were sewn into 2");
}

TEST(IgesImporter, BringsCurves) {
  const Folder folder;
  be_quiet();
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(circle(10, 3));
  writer.AddShape(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 30)).Shape());
  writer.ComputeModel();
  const std::string path = (folder / "curves.igs").string();
  ASSERT_TRUE(writer.Write(path.c_str()));
  const Wires wires = wires_of(read(path).mesh);
  EXPECT_NEAR(wires.length, 30 + 20 * std::numbers::pi, 0.05);
  EXPECT_EQ(wires.highest, 30);
  const auto open =
      std::count_if(wires.ends.begin(), wires.ends.end(), [](const auto& end) { return end.second == 1; });
  EXPECT_EQ(open, 2);
}

TEST(StepImporter, DeflectionBoundsTheDistanceOfFacets) {
  const Folder folder;
  const std::string path = step_file(folder, BRepPrimAPI_MakeCylinder(10, 30).Shape());
  int before = 0;
  for (const char* deflection : {"0.1", "0.01", "0.001"}) {
    const importer::ReadModel model = read(path, {{"deflection", deflection}, {"angle", "60"}});
    double largest = 0;  // of chords along the rims
    for (const surfaces::PartBorder& border : model.part->borders)
      for (const int e : border.edges) {
        const auto& [one, two] = model.mesh.edges[e].vertex;
        const Vec3 middle = 0.5 * (model.mesh.point(one) + model.mesh.point(two));
        largest = std::max(largest, 10 - std::hypot(middle.x, middle.y));
      }
    EXPECT_LT(largest, 1.1 * std::stod(deflection));
    EXPECT_GT(largest, 0.1 * std::stod(deflection)) << "finer than useful";
    EXPECT_GT(model.mesh.report.triangles, before);
    before = model.mesh.report.triangles;
  }
}

TEST(StepImporter, TellsTangentEdgesFromSharpOnes) {
  const Folder folder;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
  BRepFilletAPI_MakeFillet rounded(box);
  rounded.Add(4, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const importer::ReadModel model = read(step_file(folder, rounded.Shape()));
  ASSERT_NE(model.part, nullptr);
  EXPECT_EQ(kinds_of(*model.part), (std::map<SurfaceKind, int>{{SurfaceKind::plane, 6}, {SurfaceKind::cylinder, 1}}));
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::tangent), 2);
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::sharp), 13);
}

TEST(StepImporter, SeamsAndPolesAreNoEdges) {
  const Folder folder;
  const struct {
    TopoDS_Shape shape;
    SurfaceKind kind;
    int sharp;
    double volume;
  } parts[]{{BRepPrimAPI_MakeSphere(10).Shape(), SurfaceKind::sphere, 0, 4000 * std::numbers::pi / 3},
            {BRepPrimAPI_MakeTorus(10, 3).Shape(), SurfaceKind::torus, 0, 180 * std::numbers::pi * std::numbers::pi},
            {BRepPrimAPI_MakeCone(10, 0, 30).Shape(), SurfaceKind::cone, 1, 1000 * std::numbers::pi}};
  for (const auto& part : parts) {
    const importer::ReadModel model = read(step_file(folder, part.shape));
    SCOPED_TRACE(surfaces::surface_kind_names[static_cast<std::size_t>(part.kind)]);
    EXPECT_EQ(model.mesh.report.open_edges, 0);
    ASSERT_NE(model.part, nullptr);
    EXPECT_EQ(kinds_of(*model.part)[part.kind], 1);
    EXPECT_EQ(count(*model.part, surfaces::BorderKind::sharp), part.sharp);
    EXPECT_NEAR(volume_of(model.mesh), part.volume, 0.005 * part.volume);
    EXPECT_LT(volume_of(model.mesh), part.volume);
  }
}

// z = (x^2 + y^2) / 40 over a square of 20 mm, exactly.
TEST(StepImporter, PatchesOfSplinesAreAsNearAsAskedFor) {
  TColgp_Array2OfPnt poles(0, 2, 0, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) poles(i, j) = gp_Pnt(10 * i, 10 * j, (i == 2 ? 10 : 0) + (j == 2 ? 10 : 0));
  const TopoDS_Shape patch = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape();
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, patch), {{"deflection", "0.01"}});
  ASSERT_NE(model.part, nullptr);
  EXPECT_EQ(kinds_of(*model.part), (std::map<SurfaceKind, int>{{SurfaceKind::free_form, 1}}));
  EXPECT_EQ(count(*model.part, surfaces::BorderKind::open), 1);
  const auto height = [](const Vec3& p) { return (p.x * p.x + p.y * p.y) / 40; };
  for (int t = 0; t < model.mesh.report.triangles; ++t) {
    Vec3 middle(0);
    for (const int v : model.mesh.triangle(t)) {
      const Vec3 p = model.mesh.point(v);
      EXPECT_NEAR(p.z, height(p), 1e-9);
      middle += p / 3.0;
    }
    EXPECT_NEAR(middle.z, height(middle), 0.01 * std::sqrt(3.0));  // upright, where the surface is as steep as it gets
  }
}

TEST(StepImporter, FacetsOfALoftFaceAsItDoes) {
  BRepOffsetAPI_ThruSections sections(/*isSolid=*/true);
  const double circles[][4]{{0, 0, 0, 20}, {5, 0, 15, 12}, {0, 5, 35, 16}};
  for (const auto& [x, y, z, radius] : circles)
    sections.AddWire(
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius)).Edge()));
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, sections.Shape()), {{"deflection", "0.003688"}});
  ASSERT_NE(model.part, nullptr);
  const auto normal = [&](int triangle) {
    const auto [a, b, c] = model.mesh.triangle(triangle);
    return glm::normalize(
        glm::cross(model.mesh.point(b) - model.mesh.point(a), model.mesh.point(c) - model.mesh.point(a)));
  };
  double least = 1;
  for (std::size_t e = 0; e < model.mesh.edges.size(); ++e) {
    const auto triangles = model.mesh.triangles_of(model.mesh.edges[e]);
    if (model.part->border_of_edge[e] < 0 && triangles.size() == 2)
      least = std::min(least, glm::dot(normal(triangles[0]), normal(triangles[1])));
  }
  EXPECT_GT(least, std::cos(30 * std::numbers::pi / 180)) << "a sliver stands askew";
}

TEST(StepImporter, ConvertsInches) {
  const Folder folder;
  const importer::ReadModel model = read(step_file(folder, BRepPrimAPI_MakeBox(25.4, 50.8, 76.2).Shape(), "INCH"));
  EXPECT_EQ(model.unit, 1);
  expect_extent(model.mesh, Vec3(0), Vec3(25.4, 50.8, 76.2), 1e-9);
  ASSERT_EQ(model.mesh.report.notes.size(), 1U);
  EXPECT_TRUE(contains(model.mesh.report.notes[0], "inch")) << model.mesh.report.notes[0];
}

TEST(StepImporter, AssembliesKeepNamesAndPlaces) {
  be_quiet();
  const Folder folder;
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto named = [](const TDF_Label& label, const char* name) {
    TDataStd_Name::Set(label, name);
    return label;
  };
  const auto moved = [](double x, double y, double z) {
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(x, y, z));
    return TopLoc_Location(shift);
  };
  const TDF_Label pin = named(tool->AddShape(BRepPrimAPI_MakeCylinder(2, 10).Shape(), Standard_False), "pin");
  const TDF_Label plate = named(tool->AddShape(BRepPrimAPI_MakeBox(50, 20, 4).Shape(), Standard_False), "plate");
  const TDF_Label pair = named(tool->NewShape(), "pair");
  named(tool->AddComponent(pair, pin, moved(10, 10, 4)), "left pin");
  named(tool->AddComponent(pair, pin, moved(40, 10, 4)), "right pin");
  const TDF_Label whole = named(tool->NewShape(), "whole");
  named(tool->AddComponent(whole, plate, moved(0, 0, 0)), "base");
  named(tool->AddComponent(whole, pair, moved(0, 0, 100)), "upper");
  tool->UpdateAssemblies();
  const auto colour = [&](const TDF_Label& label, double red, double green, double blue) {
    XCAFDoc_DocumentTool::ColorTool(document->Main())
        ->SetColor(label, Quantity_Color(red, green, blue, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  };
  colour(pin, 1, 0, 0);
  colour(plate, 0, 0.2, 0.4);
  const std::string path = (folder / "assembly.step").string();
  STEPCAFControl_Writer writer;
  writer.SetNameMode(Standard_True);
  ASSERT_TRUE(writer.Transfer(document));
  ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);

  const importer::ReadModel model = read(path);
  EXPECT_EQ(model.mesh.report.bodies, 3);
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"base", "left pin", "right pin"}));
  const std::optional<Colour> blue = Colour{0, 51, 102}, red = Colour{255, 0, 0};
  EXPECT_EQ(model.mesh.report.body_colours, (std::vector{blue, red, red}));
  expect_extent(model.mesh, Vec3(0), Vec3(50, 20, 114), 1e-9);
  EXPECT_NEAR(volume_of(model.mesh), 4000 + 2 * 40 * std::numbers::pi, 2);
}

// A seal, a label or the run of a cable is a part of its own.
TEST(StepImporter, SurfacesAndLinesThatArePartsOfAnAssemblyStay) {
  be_quiet();
  const Folder folder;
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label whole = tool->NewShape();
  for (const TopoDS_Shape& shape : {BRepPrimAPI_MakeBox(40, 30, 20).Shape(), datum_plane(), circle(10, 3)})
    tool->AddComponent(whole, tool->AddShape(shape, Standard_False), TopLoc_Location());
  tool->UpdateAssemblies();
  const std::string path = (folder / "assembly.step").string();
  STEPCAFControl_Writer writer;
  ASSERT_TRUE(writer.Transfer(document));
  ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
  const importer::ReadModel model = read(path);
  EXPECT_EQ(model.mesh.report.triangles, 12 + 2);
  EXPECT_GT(wires_of(model.mesh).pieces, 17);
  EXPECT_TRUE(model.mesh.report.notes.empty());
}

TEST(StepImporter, ReadsIgesAndBrep) {
  be_quiet();
  const Folder folder;
  const TopoDS_Shape shape = block_with_bore();
  const std::string iges = (folder / "part.igs").string(), brep = (folder / "part.brep").string();
  IGESControl_Writer writer("MM", 1);
  writer.AddShape(shape);
  ASSERT_TRUE(writer.Write(iges.c_str()));
  ASSERT_TRUE(BRepTools::Write(shape, brep.c_str()));
  for (const std::string& path : {iges, brep}) {
    SCOPED_TRACE(path);
    const importer::ReadModel model = read(path);
    ASSERT_NE(model.part, nullptr);
    EXPECT_EQ(kinds_of(*model.part)[SurfaceKind::plane], 6);
    EXPECT_EQ(model.part->faces.size(), 7U);
    EXPECT_NEAR(volume_of(model.mesh), 40 * 30 * 20 - std::numbers::pi * 25 * 20, 5);
  }
}

std::string with_statements(const std::string& path, const std::string& statements) {
  std::string text = read_file(path);
  text.insert(text.rfind("ENDSEC;"), statements);
  return text;
}

TEST(StepImporter, WhatIsNotDrawnIsCounted) {
  const Folder folder;
  const std::string text = with_statements(
      step_file(folder, block_with_bore()),
      "#9001=DIMENSIONAL_SIZE(#1,'diameter');\n#9002=DATUM('A;(',$,#1,.F.,'A');\n/* #9=DATUM(); */\n"
      "#9003=(GEOMETRIC_TOLERANCE('',$,#1,#1)POSITION_TOLERANCE());\n#9004=FLATNESS_TOLERANCE('',$,#1,#1);\n"
      "#9005=PLUS_MINUS_TOLERANCE(#1,#1);\n#9006=CAMERA_MODEL_D3('v',#1,#1);\n"
      "#9007=PRESENTATION_LAYER_ASSIGNMENT('L','',());\n#9008=INVISIBILITY((#9007));\n");
  const importer::ReadModel model = read(folder.file("m.step", text));
  const std::vector<std::string>& notes = model.mesh.report.notes;
  EXPECT_EQ(importer::counted_requirements(model.requirements), "1 dimension, 2 geometric tolerances and 1 datum");
  EXPECT_NE(std::find(notes.begin(), notes.end(), "1 saved view without a camera that can be placed: not read"),
            notes.end());
  EXPECT_NE(std::find(notes.begin(), notes.end(), "1 layer is switched off in the file, which is not heeded"),
            notes.end());
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  return std::regex_replace(text, std::regex(from), to);
}

// A parabola of focal distance 5 that ends at (20, 20), where the parameter is 2: Open CASCADE writes and reads 20.
TEST(StepImporter, ParabolasAreTrimmedByPoints) {
  const Folder folder;
  const std::string text = read_file(step_file(folder, BRepBuilderAPI_MakeEdge(gp_Parab(gp_Ax2(), 5), 0, 20).Edge()));
  const std::string by_points = replaced(text, "PARAMETER_VALUE\\(20\\.\\)", "PARAMETER_VALUE(2.)");
  ASSERT_NE(by_points, text);
  const importer::ReadModel trimmed = read(folder.file("points.step", by_points));
  EXPECT_TRUE(trimmed.mesh.report.notes.empty()) << trimmed.mesh.report.notes[0];
  const Wires wires = wires_of(trimmed.mesh);
  EXPECT_NEAR(wires.length, 29.58, 0.05);

  const std::string by_parameters = replaced(by_points, "\\(#[0-9]+,\\s*PARAMETER_VALUE", "(PARAMETER_VALUE");
  ASSERT_NE(by_parameters, by_points);
  const std::vector<std::string> notes = read(folder.file("parameters.step", by_parameters)).mesh.report.notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0],
            "1 parabola trimmed by parameters, first #16: may end elsewhere, since programs do not agree what these "
            "mean; trim by points");
}

TEST(StepImporter, ShapesOfTrianglesAreNamed) {
  const Folder folder;
  const std::string empty =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n";
  EXPECT_EQ(refusal_of(folder.file("m.step", empty + "#5=TESSELLATED_SOLID('',(#6),$);\nENDSEC;\nEND-ISO-10303-21;\n")),
            "holds no shape: its shapes are triangles (TESSELLATED_SOLID), which are not read: export it with exact "
            "surfaces, or as 3MF, STL or OBJ");
}

}  // namespace
}  // namespace epura::test::step_test
