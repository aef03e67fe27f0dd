// SPDX-License-Identifier: Apache-2.0
// Hidden lines of shapes in memory, in one process: libepura-hlr beside Open CASCADE's exact and polygonal algorithms.
//   in_process                                          shapes of its own
//   in_process STEP or IGES file, or folder of them...
// One row a shape: lengths of visible lines in an isometric view, and medians of seconds. All three begin with the
// shape as a program has it; the polygonal one and epura with its facets, which are made before.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Bnd_Box.hxx>
#include <HLRAlgo_EdgeIterator.hxx>
#include <HLRAlgo_EdgeStatus.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <epura/hlr_opencascade.hpp>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "part_geometry.hpp"
#include "say.hpp"

namespace {

using namespace epura;

constexpr int rounds = 5;
constexpr double fineness = 4000;  ///< of facets: parts of the diagonal
const Vec3 viewer(1, -1, 1);

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), radius, height).Shape();
}

TopoDS_Shape bored_plate(int n) {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(20.0 * n, 20.0 * n, 8).Shape();
  for (int i = 0; i < n * n; ++i)
    plate = BRepAlgoAPI_Cut(plate, cylinder(20 * (i % n) + 10, 20 * (i / n) + 10, -1, 4, 10)).Shape();
  return plate;
}

TopoDS_Shape stepped_shaft(int n) {
  TopoDS_Shape shaft = cylinder(0, 0, 0, 10, 12);
  for (int i = 1; i < n; ++i) shaft = BRepAlgoAPI_Fuse(shaft, cylinder(0, 0, 12 * i, i % 2 == 0 ? 10 : 6, 12)).Shape();
  return shaft;
}

std::vector<bench::Part> own_parts() {
  std::vector<bench::Part> parts{
      {"box", [] { return BRepPrimAPI_MakeBox(10, 20, 30).Shape(); }},
      {"cylinder", [] { return cylinder(0, 0, 0, 10, 20); }},
      {"cone", [] { return BRepPrimAPI_MakeCone(10, 0, 20).Shape(); }},
      {"frustum", [] { return BRepPrimAPI_MakeCone(10, 4, 20).Shape(); }},
      {"sphere", [] { return BRepPrimAPI_MakeSphere(10).Shape(); }},
      {"torus", [] { return BRepPrimAPI_MakeTorus(10, 3).Shape(); }},
      {"ball on a box",
       [] {
         return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(20, 20, 5).Shape(),
                                 BRepPrimAPI_MakeSphere(gp_Pnt(10, 10, 8), 7).Shape())
             .Shape();
       }},
  };
  for (int n = 1; n <= 8; ++n) {
    parts.push_back({"plate, " + std::to_string(n * n) + " bores", [n] { return bored_plate(n); }});
    if (n > 1) parts.push_back({"shaft, " + std::to_string(n) + " steps", [n] { return stepped_shaft(n); }});
  }
  return parts;
}

struct Measured {
  double length = 0, seconds = 0;
};

// The median of `rounds` runs; NaN if the algorithm fails.
Measured measured(const std::function<double()>& visible_length) {
  std::array<double, rounds> seconds{};
  double length = 0;
  for (double& taken : seconds) {
    const double start = bench::now();
    try {
      length = visible_length();
    } catch (const Standard_Failure&) {
      return {std::nan(""), std::nan("")};
    }
    taken = bench::now() - start;
  }
  std::ranges::sort(seconds);
  return {length, seconds[rounds / 2]};
}

double exact(const TopoDS_Shape& shape) {
  double length = 0;
  for (const auto& [from, to] : bench::exact_view(shape, viewer, fineness).visible) length += glm::distance(from, to);
  return length;
}

double polygonal(const TopoDS_Shape& shape) {
  const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo(shape);
  algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(viewer.x, viewer.y, viewer.z))));
  algorithm->Update();
  HLRAlgo_EdgeStatus status;
  HLRAlgo_EdgeIterator spans;
  TopoDS_Shape edge;
  Standard_Boolean smooth = false, very_smooth = false, outline = false, internal = false;
  double length = 0, begin = 0, end = 0;
  Standard_ShortReal begin_tolerance = 0, end_tolerance = 0;
  for (algorithm->InitHide(); algorithm->MoreHide(); algorithm->NextHide()) {
    const auto& points = algorithm->Hide(status, edge, smooth, very_smooth, outline, internal);
    if ((smooth || very_smooth) && !outline) continue;
    const double whole = std::hypot(points.Pnt2.X() - points.Pnt1.X(), points.Pnt2.Y() - points.Pnt1.Y());
    for (spans.InitVisible(status); spans.MoreVisible(); spans.NextVisible()) {
      spans.Visible(begin, begin_tolerance, end, end_tolerance);
      length += whole * (end - begin);
    }
  }
  return length;
}

double by_epura(const TopoDS_Shape& shape, double deflection) {
  epura_hlr_error error{};
  error.size = sizeof error;
  epura_hlr_model* model = epura_hlr_model_new(EPURA_HLR_VERSION);
  add_shape(*epura_hlr_sink(model), shape, deflection);
  const double s = std::sqrt(0.5), t = std::sqrt(1.0 / 6);
  const std::array matrix{s, s, 0.0, 0.0, -t, t, 2 * t, 0.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
  epura_hlr_request request{};
  request.size = sizeof request;
  request.matrix = matrix.data();
  request.kinds = EPURA_HLR_USUAL - EPURA_HLR_WIRE;  // sketches are none of what the others draw
  epura_hlr_drawing* drawing = nullptr;
  if (epura_hlr_finish(model, nullptr, &error) == EPURA_HLR_DONE) drawing = epura_hlr_draw(model, &request, &error);
  double length = 0;
  if (drawing != nullptr) {
    const epura_hlr_result& result = *epura_hlr_result_of(drawing);
    for (std::uint64_t i = 0; i < result.curve_count; ++i) {
      const epura_hlr_curve& curve = result.curves[i];
      if (curve.visible == 0) continue;
      for (std::uint64_t p = curve.first; p + 1 < curve.first + curve.count; ++p)
        length += std::hypot(result.points[2 * p + 2] - result.points[2 * p],
                             result.points[2 * p + 3] - result.points[2 * p + 1]);
    }
  }
  epura_hlr_drawing_free(drawing);
  epura_hlr_model_free(model);
  if (drawing == nullptr) throw std::runtime_error(std::string(error.place) + ": " + error.reason);
  return length;
}

void print_row(const bench::Part& part) {
  const TopoDS_Shape shape = part.make();
  bench::mark_tangent_edges(shape);
  const Measured exactly = measured([&] { return exact(shape); });
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  const double deflection = std::sqrt(box.SquareExtent()) / fineness;
  BRepMesh_IncrementalMesh(shape, deflection, false, 0.35, false);
  const Measured by_facets = measured([&] { return polygonal(shape); });
  const Measured own = measured([&] { return by_epura(shape, deflection); });
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::printf("| %s | %d | %.3f | %.3f | %.3f | %.2f | %.2f | %.2f | %.1f | %.1f |\n", part.name.c_str(),
              faces.Extent(), exactly.length, by_facets.length, own.length, 1e3 * exactly.seconds,
              1e3 * by_facets.seconds, 1e3 * own.seconds, exactly.seconds / own.seconds,
              by_facets.seconds / own.seconds);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::printf(
      "| shape | faces | exact | polygonal | epura | exact, ms | polygonal, ms | epura, ms | exact : epura | polygonal "
      ": epura |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<bench::Part> parts = argc > 1 ? std::vector<bench::Part>() : own_parts();
  if (argc == 1)
    for (const bench::Part& part : bench::made_parts()) parts.push_back(part);
  for (int i = 1; i < argc; ++i)
    for (const bench::Part& part : bench::parts_in(argv[i])) parts.push_back(part);
  for (const bench::Part& part : parts) try {
      print_row(part);
    } catch (const Standard_Failure& failure) {
      std::printf("| %s | Open CASCADE: %s |\n", part.name.c_str(), failure.GetMessageString());
    } catch (const std::exception& wrong) {
      std::printf("| %s | %s |\n", part.name.c_str(), wrong.what());
    }
}
