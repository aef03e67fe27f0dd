// SPDX-License-Identifier: Apache-2.0
// Hidden lines of shapes in memory, in one process: libepura-hlr beside Open CASCADE's exact and polygonal algorithms.
//   in_process FOLDER [STEP, IGES or BREP file, or folder of them...]
// Two rows a shape, which is seen from (1, -1, 1), and from a point there that is twice its diagonal away: lengths of
// visible lines, and medians of seconds of processor time on one thread. All three begin with the shape as a program
// has it, the polygonal one and epura with its facets, which are made before. The folder gets what
// bench/drawings/memory.py judges: the shapes, and what each drew of them.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <HLRAlgo_EdgeIterator.hxx>
#include <HLRAlgo_EdgeStatus.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <epura/hlr_opencascade.hpp>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apart.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "part_geometry.hpp"

namespace {

using namespace epura;
namespace fs = std::filesystem;
using Lines = std::vector<bench::PlaneLine>;

constexpr std::size_t rounds = 5;
constexpr double enough_seconds = 2;  ///< of an algorithm, after which it is not run again
constexpr double time_limit = 100;    ///< s for all that is done with a shape
constexpr double fineness = 4000;     ///< of facets: parts of the diagonal
constexpr double eye_distance = 2;    ///< of the centre: diagonals
const Vec3 viewer(1, -1, 1);

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1)), radius, height).Shape();
}

TopoDS_Shape bored_plate(int n) {
  const BRep_Builder builder;
  TopoDS_Compound bores;
  builder.MakeCompound(bores);
  for (int i = 0; i < n * n; ++i) builder.Add(bores, cylinder(20 * (i % n) + 10, 20 * (i / n) + 10, -1, 4, 10));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20.0 * n, 20.0 * n, 8).Shape(), bores).Shape();
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
      {"torus 30, 10", [] { return BRepPrimAPI_MakeTorus(30, 10).Shape(); }},  // of Open CASCADE's test bug25813_3
      {"ball on a box",
       [] {
         return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(20, 20, 5).Shape(),
                                 BRepPrimAPI_MakeSphere(gp_Pnt(10, 10, 8), 7).Shape())
             .Shape();
       }},
  };
  for (const int n : {1, 2, 4, 8, 23})
    parts.push_back({"plate, " + std::to_string(n * n) + " bores", [n] { return bored_plate(n); }});
  for (const int n : {2, 4, 8})
    parts.push_back({"shaft, " + std::to_string(n) + " steps", [n] { return stepped_shaft(n); }});
  return parts;
}

struct Drawn {
  Lines visible, hidden;
};

Drawn exact(const TopoDS_Shape& shape, double eye) {
  bench::ExactView view = bench::exact_view(shape, viewer, fineness, eye);
  return {std::move(view.visible), std::move(view.hidden)};
}

Drawn polygonal(const TopoDS_Shape& shape, double eye) {
  const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo(shape);
  algorithm->Projector(bench::projector_of(viewer, eye));
  algorithm->Update();
  HLRAlgo_EdgeStatus status;
  HLRAlgo_EdgeIterator spans;
  TopoDS_Shape edge;
  Standard_Boolean smooth = false, very_smooth = false, outline = false, internal = false;
  Drawn drawn;
  double begin = 0, end = 0;
  Standard_ShortReal begin_tolerance = 0, end_tolerance = 0;
  for (algorithm->InitHide(); algorithm->MoreHide(); algorithm->NextHide()) {
    const auto& points = algorithm->Hide(status, edge, smooth, very_smooth, outline, internal);
    if ((smooth || very_smooth) && !outline) continue;
    const Vec2 from(points.PntP1.X(), points.PntP1.Y()), along = Vec2(points.PntP2.X(), points.PntP2.Y()) - from;
    for (spans.InitVisible(status); spans.MoreVisible(); spans.NextVisible()) {
      spans.Visible(begin, begin_tolerance, end, end_tolerance);
      drawn.visible.push_back({from + begin * along, from + end * along});
    }
    for (spans.InitHidden(status); spans.MoreHidden(); spans.NextHidden()) {
      spans.Hidden(begin, begin_tolerance, end, end_tolerance);
      drawn.hidden.push_back({from + begin * along, from + end * along});
    }
  }
  return drawn;
}

// Rows: to the right, up, and towards the viewer, at whose eye the last one is 0.
std::array<double, 16> matrix_of(double eye) {
  const double s = std::sqrt(0.5), t = std::sqrt(1.0 / 6), n = std::sqrt(1.0 / 3);
  std::array matrix{s, s, 0.0, 0.0, -t, t, 2 * t, 0.0, n, -n, n, 0.0, 0.0, 0.0, 0.0, 1.0};
  if (eye > 0)
    for (std::size_t i = 0; i < 3; ++i) matrix[12 + i] = -matrix[8 + i] / eye;
  return matrix;
}

/// Sketches are none of what the others draw.
constexpr std::uint32_t own_kinds = EPURA_HLR_USUAL - EPURA_HLR_WIRE;

Drawn by_epura(const TopoDS_Shape& shape, double deflection, double eye, std::uint32_t kinds = own_kinds) {
  epura_hlr_error error{};
  error.size = sizeof error;
  epura_hlr_model* model = epura_hlr_model_new(EPURA_HLR_VERSION);
  add_shape(*epura_hlr_sink(model), shape, deflection);
  const std::array matrix = matrix_of(eye);
  epura_hlr_settings settings{};
  settings.size = sizeof settings;
  settings.threads = 1;
  epura_hlr_request request{};
  request.size = sizeof request;
  request.matrix = matrix.data();
  request.threads = 1;
  request.kinds = kinds;
  epura_hlr_drawing* drawing = nullptr;
  if (epura_hlr_finish(model, &settings, &error) == EPURA_HLR_DONE) drawing = epura_hlr_draw(model, &request, &error);
  Drawn drawn;
  if (drawing != nullptr) {
    const epura_hlr_result& result = *epura_hlr_result_of(drawing);
    const auto at = [&](std::uint64_t i) { return Vec2(result.points[2 * i], result.points[2 * i + 1]); };
    for (std::uint64_t i = 0; i < result.curve_count; ++i) {
      const epura_hlr_curve& curve = result.curves[i];
      Lines& lines = curve.visible != 0 ? drawn.visible : drawn.hidden;
      for (std::uint64_t p = curve.first; p + 1 < curve.first + curve.count; ++p) lines.push_back({at(p), at(p + 1)});
    }
  }
  epura_hlr_drawing_free(drawing);
  epura_hlr_model_free(model);
  if (drawing == nullptr) throw std::runtime_error(std::string(error.place) + ": " + error.reason);
  return drawn;
}

constexpr double failed = -1;

struct Measured {
  double length = failed, seconds = failed;
};

std::string rows_of(const Drawn& drawn) {
  std::string text;
  for (const auto& [seen, lines] : {std::pair('1', &drawn.visible), std::pair('0', &drawn.hidden)})
    for (const auto& [from, to] : *lines) {
      text += seen;
      for (const double number : {from.x, from.y, to.x, to.y}) text += ' ' + format_number(number);
      text += '\n';
    }
  return text;
}

// Writes what was drawn, into a file if one is named; if the algorithm fails, nothing.
Measured measured(const std::string& file, const std::function<Drawn()>& draw) {
  Measured result;
  std::vector<double> seconds;
  const std::clock_t start = std::clock();
  const auto since = [](std::clock_t begin) { return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; };
  Drawn drawn;
  try {
    while (seconds.size() < rounds && since(start) < enough_seconds) {
      const std::clock_t begin = std::clock();
      drawn = draw();
      seconds.push_back(since(begin));
    }
  } catch (const Standard_Failure&) {
    return result;
  }
  std::ranges::sort(seconds);
  result = {0, seconds[seconds.size() / 2]};
  for (const auto& [from, to] : drawn.visible) result.length += glm::distance(from, to);
  if (!file.empty()) write_file(file, rows_of(drawn));
  return result;
}

// The shape with its centre at the origin.
TopoDS_Shape centred(const TopoDS_Shape& shape, double& diagonal) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  if (box.IsVoid()) throw std::runtime_error("the part is empty");
  diagonal = std::sqrt(box.SquareExtent());
  gp_Trsf move;
  move.SetTranslation(gp_Vec(box.CornerMax().XYZ() + box.CornerMin().XYZ()) * -0.5);
  return shape.Moved(TopLoc_Location(move));
}

/// Faces, length and seconds of each of the three, and epura's seconds without lines where faces cross, which the
/// others do not look for.
bench::Numbers draw_all(const bench::Part& part, const fs::path& path, bool central, const bench::Stage& stage) {
  stage("the shape");
  double diagonal = 0;
  const TopoDS_Shape shape = centred(part.make(), diagonal);
  BRepTools::Clean(shape);  // files may have facets of their own
  if (!BRepTools::Write(shape, (path.string() + ".brep").c_str()))
    throw std::runtime_error("the shape cannot be written");
  write_file(path.string() + ".size", format_number(diagonal));
  bench::mark_tangent_edges(shape);
  const double eye = central ? eye_distance * diagonal : 0, deflection = diagonal / fineness;
  const std::string start = path.string() + (central ? "-central-" : "-parallel-");
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  stage("exact");
  const Measured exactly = measured(start + "exact.txt", [&] { return exact(shape, eye); });
  stage("facets");
  BRepMesh_IncrementalMesh(shape, deflection, false, 0.35, false);
  stage("polygonal");
  const Measured by_facets = measured(start + "polygonal.txt", [&] { return polygonal(shape, eye); });
  stage("epura");
  const Measured own = measured(start + "epura.txt", [&] { return by_epura(shape, deflection, eye); });
  const Measured less =
      measured("", [&] { return by_epura(shape, deflection, eye, own_kinds - EPURA_HLR_INTERSECTION); });
  return {static_cast<double>(faces.Extent()),
          exactly.length,
          by_facets.length,
          own.length,
          exactly.seconds,
          by_facets.seconds,
          own.seconds,
          less.seconds};
}

std::string row_of(const bench::Numbers& numbers) {
  std::string row = format_fixed(numbers[0], 0);
  const auto add = [&](double value, int digits) {
    row += " | " + (value >= 0 ? format_fixed(value, digits) : std::string("fails"));
  };
  for (const std::size_t i : {1, 2, 3}) add(numbers[i], 2);
  for (const std::size_t i : {4, 5, 6, 7}) add(1e3 * numbers[i], 2);
  for (const std::size_t i : {4, 5}) add(numbers[i] < 0 ? failed : numbers[i] / numbers[7], 2);
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: in_process FOLDER [FILE|FOLDER...]\n", stderr);
    return 2;
  }
  const fs::path folder = argv[1];
  std::vector<bench::Part> parts = own_parts();
  for (const bench::Part& part : bench::made_parts()) parts.push_back(part);
  for (int i = 2; i < argc; ++i)
    for (const bench::Part& part : bench::parts_in(argv[i])) parts.push_back(part);
  std::string names;
  std::vector<bench::Work> works;
  const auto path = [&](std::size_t i) { return folder / std::to_string(i); };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    names += std::to_string(i) + ' ' + parts[i].name + '\n';
    for (const bool central : {false, true})
      works.emplace_back(
          [&, i, central](const bench::Stage& stage) { return draw_all(parts[i], path(i), central, stage); });
  }
  write_file((folder / "names.txt").string(), names);
  std::puts(
      "| shape | seen | faces | exact | polygonal | epura | exact, ms | polygonal, ms | epura, ms | without crossings, "
      "ms "
      "| exact : that | polygonal : that |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  bench::run_apart(works, {1, time_limit}, [&](std::size_t number, const bench::Outcome& outcome) {
    std::printf("| %s | %s | %s |\n", parts[number / 2].name.c_str(), number % 2 == 0 ? "parallel" : "central",
                (outcome.trouble ? outcome.stage + ": " + *outcome.trouble : row_of(outcome.numbers)).c_str());
    std::fflush(stdout);
  });
}
