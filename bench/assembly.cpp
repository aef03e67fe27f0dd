// SPDX-License-Identifier: Apache-2.0
// Creates assemblies of any size in STEP, and draws STEP files by Open CASCADE, for comparison:
//   assembly make KIND N FILE.step          KIND: blocks (N x N x N), instances (N blocks side by side),
//                                           pipes (N over N), gears (N)
//   assembly draw FILE.step FILE.svg        isometric, visible and hidden lines; prints the time of each stage
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/text.hpp"
#include "part_geometry.hpp"
#include "say.hpp"

namespace {

using namespace epura;
using namespace epura::bench;
using Shape = TopoDS_Shape;

constexpr double pitch = 12;  // of blocks of 10 mm

Shape with_bore(const Shape& shape, double x, double y, double radius) {
  return BRepAlgoAPI_Cut(shape,
                         BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, -1), gp_Dir(0, 0, 1)), radius, 100).Shape())
      .Shape();
}

/// A cube with all edges rounded, and a bore: 27 faces.
Shape block() {
  const Shape cube = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  BRepFilletAPI_MakeFillet round(cube);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(cube, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) round.Add(1.5, TopoDS::Edge(edges(i)));
  return with_bore(round.Shape(), 5, 5, 2);
}

Shape pipe(double length) {
  const gp_Ax2 along_x(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(along_x, 5, length).Shape(),
                         BRepPrimAPI_MakeCylinder(along_x, 4, length).Shape())
      .Shape();
}

/// A gear with straight flanks and a bore: 99 faces.
Shape gear() {
  constexpr int teeth = 24;
  BRepBuilderAPI_MakePolygon outline;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double angle = 2 * std::numbers::pi * i / (4 * teeth), radius = i % 4 < 2 ? 26 : 21;
    outline.Add(gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  outline.Close();
  return with_bore(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10)).Shape(), 0,
                   0, 6);
}

class Assembly {
 public:
  Assembly() { builder_.MakeCompound(whole_); }
  void add(const Shape& part, const gp_Vec& place, bool is_turned = false) {
    gp_Trsf move;
    if (is_turned) move.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 2);
    move.SetTranslationPart(place);
    builder_.Add(whole_, part.Moved(TopLoc_Location(move)));
  }
  void write(const char* file) const {
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.step.assembly", 1);
    if (writer.Transfer(whole_, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(file) != IFSelect_RetDone)
      throw std::runtime_error("cannot be written");
  }

 private:
  BRep_Builder builder_;
  TopoDS_Compound whole_;
};

Assembly make(const std::string& kind, int count) {
  Assembly assembly;
  if (kind == "blocks") {
    const Shape part = block();
    for (int i = 0; i < count * count * count; ++i)
      assembly.add(part, pitch * gp_Vec(i % count, i / count % count, i / count / count));
  } else if (kind == "instances") {
    const Shape part = block();
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) assembly.add(part, pitch * gp_Vec(i % side, i / side, 0));
  } else if (kind == "pipes") {
    const Shape part = pipe(pitch * (count + 1));
    for (int i = 0; i < count; ++i) {
      assembly.add(part, {0, pitch * (i + 1), 0});
      assembly.add(part, {pitch * (i + 1), 0, pitch}, true);
    }
  } else if (kind == "gears") {
    const Shape part = gear();
    for (int i = 0; i < count; ++i) assembly.add(part, {47.5 * i, 0, 0}, i % 2 == 1);
  } else {
    throw std::runtime_error("no such kind of assembly: " + kind);
  }
  return assembly;
}

std::string path_of(const std::vector<PlaneLine>& lines) {
  std::string d;
  for (const PlaneLine& line : lines)
    for (const Vec2& p : line)
      d += (&p == line.data() ? 'M' : 'L') + format_fixed(p.x, 3) + ' ' + format_fixed(-p.y, 3);
  return "<path fill='none' stroke='black' stroke-width='0.35' d='" + d + "'/>\n";
}

void draw(const char* from, const char* to) {
  double begin = now();
  const auto tell = [&](const char* stage) {
    say_seconds(stage, now() - begin);
    begin = now();
  };
  const std::vector<Part> parts = parts_in(from);
  if (parts.empty()) throw std::runtime_error("is no part");
  const Shape shape = parts.front().make();
  tell("read");
  const ExactView view = exact_view(shape, {1, -1, 1});
  tell("hide");
  std::ofstream(to) << "<svg xmlns='http://www.w3.org/2000/svg'>\n" + path_of(view.visible) + path_of(view.hidden) +
                           "</svg>\n";
  tell("write");
  say_count("visible", view.visible.size());
  say_count("hidden", view.hidden.size());
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 5 && std::strcmp(words[1], "make") == 0) {
      make(words[2], std::stoi(words[3])).write(words[4]);
    } else if (count == 4 && std::strcmp(words[1], "draw") == 0) {
      draw(words[2], words[3]);
    } else {
      std::fprintf(stderr, "usage: assembly make KIND N FILE.step | assembly draw FILE.step FILE.svg\n");
      return 2;
    }
    return 0;
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "assembly: %s\n", failure.GetMessageString());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "assembly: %s\n", error.what());
  }
  return 1;
}
