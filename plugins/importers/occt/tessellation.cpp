// SPDX-License-Identifier: Apache-2.0
#include "tessellation.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_Context.hxx>
#include <BRepMesh_DefaultRangeSplitter.hxx>
#include <BRepMesh_DelaunayBaseMeshAlgo.hxx>
#include <BRepMesh_DelaunayNodeInsertionMeshAlgo.hxx>
#include <BRepMesh_FaceDiscret.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepMesh_MeshAlgoFactory.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <OSD_Parallel.hxx>
#include <OSD_ThreadPool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "face_mesh.hpp"
#include "readers.hpp"
#include "session.hpp"
#include "turning_edges.hpp"

namespace occt {

namespace {

/// Meshes cones without inner points: most need none except those that face_mesh.hpp adds.
class FewPoints : public BRepMesh_MeshAlgoFactory {
  DEFINE_STANDARD_RTTI_INLINE(FewPoints, BRepMesh_MeshAlgoFactory)

 public:
  Handle(IMeshTools_MeshAlgo)
      GetAlgo(GeomAbs_SurfaceType surface, const IMeshTools_Parameters& parameters) const override {
    if (surface != GeomAbs_Cone) return BRepMesh_MeshAlgoFactory::GetAlgo(surface, parameters);
    return new BRepMesh_DelaunayNodeInsertionMeshAlgo<BRepMesh_DefaultRangeSplitter, BRepMesh_DelaunayBaseMeshAlgo>;
  }
};

TopoDS_Compound everything_of(const Model& model) {
  TopoDS_Compound everything;
  const BRep_Builder builder;
  builder.MakeCompound(everything);
  for (const Part& part : model.parts)
    for (const Body& body : part.bodies) builder.Add(everything, body.shape);
  return everything;
}

/// Poles of spline surfaces are far outside the surface, so points on the surface are sampled.
void add(const TopoDS_Face& face, Bnd_Box& box) {
  const BRepAdaptor_Surface surface(face, /*Restriction=*/false);
  if (surface.GetType() <= GeomAbs_Torus) {
    Bnd_Box own;
    BRepBndLib::Add(face, own, /*useTriangulation=*/false);
    // Planes without an outline are infinite, and cannot be drawn.
    if (!own.IsVoid() && !own.IsOpen()) box.Add(own);
    return;
  }
  constexpr int steps = 12;
  std::array<double, 4> range{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      box.Add(
          surface.Value(range[0] + (range[1] - range[0]) * i / steps, range[2] + (range[3] - range[2]) * j / steps));
}

/// Poles of spline curves are far off, too.
void add(const TopoDS_Edge& edge, Bnd_Box& box) {
  constexpr int steps = 24;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  for (int i = 0; i <= steps; ++i) box.Add(curve.Value(first + (last - first) * i / steps));
}

/// Facets of one free form, which Open CASCADE makes in 20 s and 0.7 GB; both grow faster than their number.
constexpr double most_facets = 100'000;
/// Facets that it makes for each one that deflection and angle need: 3.8 and 4.6 on sheets of 42 x 42 and 20 x 20
/// poles.
constexpr double made_for_needed = 4;

/// The number of steps in which a surface is sampled in one direction: four between two knots.
int steps_between(int knots) { return std::clamp(4 * (knots - 1), 12, 200); }

/// In how many pieces the deflection and the angle divide the line through three points.
double pieces(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const Fineness& fineness) {
  const gp_Vec first(a, b), second(b, c);
  const double sagitta = (second - first).Magnitude() / 2, angle = fineness.angle * std::numbers::pi / 180;
  const bool is_folded = first.Magnitude() > 0 && second.Magnitude() > 0;
  return std::max(std::sqrt(sagitta / fineness.deflection), is_folded ? first.Angle(second) / angle : 0.0);
}

/// About how many facets a spline surface needs; 0 for others.
double facets_of(const TopoDS_Face& face, const Fineness& fineness) {
  const BRepAdaptor_Surface surface(face, /*Restriction=*/false);
  if (surface.GetType() != GeomAbs_BSplineSurface && surface.GetType() != GeomAbs_BezierSurface) return 0;
  std::array<double, 4> range{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  const bool is_spline = surface.GetType() == GeomAbs_BSplineSurface;
  const int along = steps_between(is_spline ? surface.NbUKnots() : surface.UDegree());
  const int across = steps_between(is_spline ? surface.NbVKnots() : surface.VDegree());
  std::vector<std::vector<gp_Pnt>> at(static_cast<std::size_t>(along) + 1);
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      at[i].push_back(
          surface.Value(range[0] + (range[1] - range[0]) * i / along, range[2] + (range[3] - range[2]) * j / across));
  double facets = 0;
  for (int i = 1; i < along; ++i)
    for (int j = 1; j < across; ++j) {  // half of what two steps need, but one piece for the whole surface
      const double u = std::max(pieces(at[i - 1][j], at[i][j], at[i + 1][j], fineness) / 2, 1.0 / along);
      const double v = std::max(pieces(at[i][j - 1], at[i][j], at[i][j + 1], fineness) / 2, 1.0 / across);
      facets += 2 * u * v;
    }
  return made_for_needed * facets;
}

Bnd_Box box_of(const Part& part) {
  Bnd_Box box;
  for (const Body& body : part.bodies)
    for (TopExp_Explorer faces(body.shape, TopAbs_FACE); faces.More(); faces.Next())
      add(TopoDS::Face(faces.Current()), box);
  for (const TopoDS_Edge& edge : part.wires) add(edge, box);
  return box;
}

/// Returns the number of edges that had no curve in space.
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
  // Open CASCADE's own pool accepts a number of threads, but oneTBB's arena behind its loops does not.
  OSD_Parallel::SetUseOcctThreads(true);
  OSD_ThreadPool::DefaultPool()->Init(static_cast<int>(threads) - 1);
}

struct Progress {
  epura::plugin::Sink& sink;
  double from, to;
};

void mesh(const TopoDS_Shape& shape, const IMeshTools_Parameters& parameters,
          const Handle(IMeshTools_MeshAlgoFactory) & algorithms, const Progress& progress) {
  BRepMesh_IncrementalMesh mesher;
  mesher.SetShape(shape);
  mesher.ChangeParameters() = parameters;
  const Handle(IMeshTools_Context) context = new BRepMesh_Context(parameters.MeshAlgo);
  context->SetEdgeDiscret(new TurningEdges);
  context->SetFaceDiscret(new BRepMesh_FaceDiscret(algorithms));
  const Handle(Stage) stage = new Stage(progress.sink, progress.from, progress.to);
  mesher.Perform(context, stage->Start());
  stage->finish();
}

/// Gives faces of three straight edges their triangle where Open CASCADE gave none, as for edges that do not quite end
/// in their vertices: there is nothing to choose.
void complete_triangles(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& known = BRep_Tool::Triangulation(face, location);
    if (!known.IsNull() && known->NbTriangles() > 0) continue;
    std::vector<gp_Pnt> corners;
    bool is_straight = true;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More() && corners.size() <= 3; edges.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
      is_straight = is_straight && !BRep_Tool::Degenerated(edge) && BRepAdaptor_Curve(edge).GetType() == GeomAbs_Line;
      const TopoDS_Vertex vertex = TopExp::FirstVertex(edge, true);
      if (!vertex.IsNull()) corners.push_back(BRep_Tool::Pnt(vertex).Transformed(location.Transformation().Inverted()));
    }
    if (!is_straight || corners.size() != 3) continue;
    const Handle(Poly_Triangulation) triangle = new Poly_Triangulation(3, 1, false);
    for (int corner = 0; corner < 3; ++corner) triangle->SetNode(corner + 1, corners[corner]);
    triangle->SetTriangle(1, Poly_Triangle(1, 2, 3));
    BRep_Builder().UpdateFace(face, triangle);
  }
}

/// Faces with triangles that cannot be refined to the tolerance without becoming too many.
std::vector<TopoDS_Face> unsuitable(const TopoDS_Shape& shape, double tolerance) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<char> is_unsuitable(static_cast<std::size_t>(faces.Extent()) + 1, 0);
  OSD_Parallel::For(1, faces.Extent() + 1, [&](int i) {
    is_unsuitable[i] = refined(TopoDS::Face(faces(i)), tolerance, useful_growth).error > 0 ? 1 : 0;
  });
  std::vector<TopoDS_Face> found;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (is_unsuitable[i] != 0) found.push_back(TopoDS::Face(faces(i)));
  return found;
}

}  // namespace

Extent extent_of(const Model& model) {
  std::vector<Bnd_Box> boxes;
  for (const Part& part : model.parts) boxes.push_back(box_of(part));
  std::vector<gp_Trsf> to_world;
  Bnd_Box all;
  Extent extent{0, 1};
  for (const Place& place : model.places) {
    to_world.push_back(place.parent == EPURA_NONE ? place.transform : to_world[place.parent] * place.transform);
    if (place.part == EPURA_NONE || boxes[place.part].IsVoid()) continue;
    all.Add(boxes[place.part].Transformed(to_world.back()));
    extent.scale = std::max(extent.scale, std::abs(to_world.back().ScaleFactor()));
  }
  if (!all.IsVoid()) extent.diagonal = std::sqrt(all.SquareExtent());
  return extent;
}

Fineness affordable(Model& model, Fineness wanted) {
  double most = 0;
  for (const Part& part : model.parts)
    for (const Body& body : part.bodies)
      for (TopExp_Explorer faces(body.shape, TopAbs_FACE); faces.More(); faces.Next())
        most = std::max(most, facets_of(TopoDS::Face(faces.Current()), wanted));
  if (!(most > most_facets)) return wanted;
  // The number of facets is inverse to their height, and to the square of the angle between them.
  const double coarser = most / most_facets;
  Fineness fineness = wanted;
  fineness.deflection *= coarser;
  fineness.angle = std::min(wanted.angle * std::sqrt(coarser), 60.0);
  std::ostringstream note;
  note.precision(2);
  note << "a free form would take about " << std::llround(most / 1000)
       << " 000 facets: all are coarser, and off by up to " << fineness.deflection << " mm instead of "
       << wanted.deflection << " mm";
  model.notes.push_back(note.str());
  return fineness;
}

void tessellate(Model& model, const Fineness& fineness, epura::plugin::Sink& sink) {
  const TopoDS_Compound everything = everything_of(model);
  BRepTools::Clean(everything);
  const std::size_t completed = complete_curves(everything);
  if (completed > 0) model.notes.push_back(counted(completed, "edge") + " had no curve in space and got one");
  use_threads(fineness.threads);

  IMeshTools_Parameters parameters;
  parameters.Deflection = told_for_wanted * fineness.deflection;
  parameters.Angle = fineness.angle * std::numbers::pi / 180;
  parameters.AngleInterior = parameters.Angle;
  parameters.InParallel = fineness.threads > 1;
  // With this option, Open CASCADE inserts twice as many triangles as face_mesh.hpp needs for most faces.
  parameters.ControlSurfaceDeflection = false;
  mesh(everything, parameters, new FewPoints, {sink, share_of_reading, share_of_reading + share_of_meshing / 2});
  const std::vector<TopoDS_Face> again = unsuitable(everything, fineness.deflection);
  for (const TopoDS_Face& face : again) BRepTools::Clean(face);
  parameters.ControlSurfaceDeflection = true;
  if (!again.empty())
    mesh(everything, parameters, new BRepMesh_MeshAlgoFactory,
         {sink, share_of_reading + share_of_meshing / 2, share_of_reading + share_of_meshing});
  complete_triangles(everything);
}

}  // namespace occt
