// SPDX-License-Identifier: Apache-2.0
// A view of a STEP file by Open CASCADE's hidden-line removal, as its users call it, alone without any library of
// epura's:
//   occ_lines exact|polygonal PART.step X Y Z OUT.svg      X Y Z: towards the viewer
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_QuasiUniformDeflection.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr double usual_fineness = 1500;  // diagonal / deflection of facets, as in bench/parts
constexpr double chord = 0.01;           // mm between curves and what is drawn of them

void draw(std::FILE* svg, const TopoDS_Shape& lines, const char* style) {
  if (lines.IsNull()) return;
  BRepLib::BuildCurves3d(lines);
  for (TopExp_Explorer at(lines, TopAbs_EDGE); at.More(); at.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));
    const GCPnts_QuasiUniformDeflection points(curve, chord);
    if (!points.IsDone()) continue;
    std::fprintf(svg, "<polyline%s points=\"", style);
    for (int i = 1; i <= points.NbPoints(); ++i)
      std::fprintf(svg, "%.5f,%.5f ", points.Value(i).X(), -points.Value(i).Y());
    std::fprintf(svg, "\"/>\n");
  }
}

template <class Found>
void draw_all(std::FILE* svg, Found& found) {
  for (const TopoDS_Shape& lines : {found.VCompound(), found.OutLineVCompound()}) draw(svg, lines, "");
  for (const TopoDS_Shape& lines : {found.HCompound(), found.OutLineHCompound()})
    draw(svg, lines, " stroke-dasharray=\"2 1\"");
}

void draw_view(std::FILE* svg, const TopoDS_Shape& part, const gp_Dir& viewer, bool exact) {
  const gp_Dir z(0, 0, 1), right = (viewer.IsParallel(z, 1e-6) ? gp_Dir(0, 1, 0) : z).Crossed(viewer);
  const HLRAlgo_Projector projector(gp_Ax2(gp_Pnt(0, 0, 0), viewer, right));
  if (exact) {
    const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo();
    algorithm->Add(part);
    algorithm->Projector(projector);
    algorithm->Update();
    algorithm->Hide();
    HLRBRep_HLRToShape found(algorithm);
    draw_all(svg, found);
  } else {
    Bnd_Box box;
    BRepBndLib::Add(part, box);
    const BRepMesh_IncrementalMesh mesher(part, std::sqrt(box.SquareExtent()) / usual_fineness);
    const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
    algorithm->Load(part);
    algorithm->Projector(projector);
    algorithm->Update();
    HLRBRep_PolyHLRToShape found;
    found.Update(algorithm);
    draw_all(svg, found);
  }
}

}  // namespace

int main(int argc, char** words) {
  if (argc != 7) {
    std::fputs("usage: occ_lines exact|polygonal PART.step X Y Z OUT.svg\n", stderr);
    return 2;
  }
  try {
    STEPControl_Reader reader;
    if (reader.ReadFile(words[2]) != IFSelect_RetDone) return 2;
    reader.TransferRoots();
    std::FILE* svg = std::fopen(words[6], "w");
    if (!svg) return 4;
    std::fputs(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000mm\" height=\"1000mm\" viewBox=\"0 0 1000 1000\" "
        "stroke=\"#000\" fill=\"none\">\n",
        svg);
    draw_view(svg, reader.OneShape(), gp_Dir(std::atof(words[3]), std::atof(words[4]), std::atof(words[5])),
              std::strcmp(words[1], "exact") == 0);
    std::fputs("</svg>\n", svg);
    return std::fclose(svg) == 0 ? 0 : 4;
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "occ_lines: %s\n", failure.GetMessageString());
    return 1;
  }
}
