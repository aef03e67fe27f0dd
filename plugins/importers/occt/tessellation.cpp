// SPDX-License-Identifier: Apache-2.0
#include "tessellation.hpp"

#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <OSD_Parallel.hxx>
#include <OSD_ThreadPool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <numbers>

#include "readers.hpp"
#include "session.hpp"

namespace occt {

namespace {

TopoDS_Compound everything_of(const Model& model) {
  TopoDS_Compound everything;
  const BRep_Builder builder;
  builder.MakeCompound(everything);
  for (const Part& part : model.parts)
    for (const Body& body : part.bodies) builder.Add(everything, body.shape);
  return everything;
}

Bnd_Box box_of(const Part& part) {
  Bnd_Box box;
  for (const Body& body : part.bodies) BRepBndLib::Add(body.shape, box, /*useTriangulation=*/false);
  return box;
}

/// Returns how many edges had no curve in space.
std::size_t complete_curves(const TopoDS_Shape& shape) {
  std::size_t count = 0;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    double first = 0, last = 0;
    if (BRep_Tool::Degenerated(edge) || !BRep_Tool::Curve(edge, first, last).IsNull()) continue;
    if (BRepLib::BuildCurve3d(edge)) ++count;
  }
  return count;
}

void use_threads(unsigned threads) {
  // Open CASCADE's own pool can be told how many threads to use, oneTBB's arena behind its loops cannot.
  OSD_Parallel::SetUseOcctThreads(true);
  OSD_ThreadPool::DefaultPool()->Init(static_cast<int>(threads) - 1);
}

}  // namespace

double diagonal_of(const Model& model) {
  std::vector<Bnd_Box> boxes;
  for (const Part& part : model.parts) boxes.push_back(box_of(part));
  std::vector<gp_Trsf> to_world;
  Bnd_Box all;
  for (const Place& place : model.places) {
    to_world.push_back(place.parent == EPURA_NONE ? place.transform : to_world[place.parent] * place.transform);
    if (place.part != EPURA_NONE && !boxes[place.part].IsVoid())
      all.Add(boxes[place.part].Transformed(to_world.back()));
  }
  return all.IsVoid() ? 0 : std::sqrt(all.SquareExtent());
}

void tessellate(Model& model, const Fineness& fineness, epura::plugin::Sink& sink) {
  const TopoDS_Compound everything = everything_of(model);
  BRepTools::Clean(everything);
  const std::size_t completed = complete_curves(everything);
  if (completed > 0) model.notes.push_back(counted(completed, "edge") + " had no curve in space and got one");
  use_threads(fineness.threads);

  IMeshTools_Parameters parameters;
  parameters.Deflection = fineness.deflection;
  parameters.Angle = fineness.angle * std::numbers::pi / 180;
  parameters.AngleInterior = parameters.Angle;
  parameters.InParallel = fineness.threads > 1;
  BRepMesh_IncrementalMesh mesher;
  mesher.SetShape(everything);
  mesher.ChangeParameters() = parameters;
  const Handle(Stage) stage = new Stage(sink, share_of_reading, share_of_reading + share_of_meshing);
  mesher.Perform(stage->Start());
  stage->finish();
}

}  // namespace occt
