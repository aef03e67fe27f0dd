// SPDX-License-Identifier: Apache-2.0
#include "tree.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <utility>

#include "bodies.hpp"

namespace occt {

namespace {

TopoDS_Shape without_location(const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location()); }

struct WireEdges {
  std::vector<TopoDS_Edge> edges;
  std::size_t endless = 0;  ///< other edges, which are infinite or have no curve
};

WireEdges edges_outside_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape of_faces, found;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    TopExp::MapShapes(faces.Current(), TopAbs_EDGE, of_faces);
  WireEdges wires;
  for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge) || of_faces.Contains(edge) || found.Contains(edge)) continue;
    found.Add(edge);
    double first = 0, last = 0;
    const bool ends =
        !BRep_Tool::Curve(edge, first, last).IsNull() && !Precision::IsInfinite(first) && !Precision::IsInfinite(last);
    if (ends)
      wires.edges.push_back(edge);
    else
      ++wires.endless;
  }
  return wires;
}

std::vector<gp_Pnt> points_outside_edges(const TopoDS_Shape& shape) {
  std::vector<gp_Pnt> points;
  for (TopExp_Explorer vertices(shape, TopAbs_VERTEX, TopAbs_EDGE); vertices.More(); vertices.Next())
    points.push_back(BRep_Tool::Pnt(TopoDS::Vertex(vertices.Current())));
  return points;
}

}  // namespace

void TreeBuilder::add(const TopoDS_Shape& shape, const std::string& part_name, Place place, const Company& company) {
  if (shape.IsNull()) return;
  const TopoDS_Shape own = without_location(shape);
  int index = prototypes_.FindIndex(own);
  if (index == 0) index = prototypes_.Add(own, make(own, part_name, company));
  const Prototype& prototype = prototypes_(index);
  if (prototype.part == EPURA_NONE && prototype.inside.empty()) return;
  const auto number = static_cast<std::uint32_t>(model_.places.size());
  place.part = prototype.part;
  place.transform *= shape.Location().Transformation();
  model_.places.push_back(std::move(place));
  for (Place inside : prototype.inside) {
    inside.parent = number;
    model_.places.push_back(inside);
  }
}

bool TreeBuilder::is_product(const TopoDS_Shape& shape) const {
  return attributes_.products.Contains(without_location(shape));
}

std::uint32_t TreeBuilder::add_assembly(Place place) {
  model_.places.push_back(std::move(place));
  return static_cast<std::uint32_t>(model_.places.size() - 1);
}

void TreeBuilder::finish() {
  std::vector<std::string> omitted;
  for (const auto& [count, thing] : {std::pair(omitted_surfaces_, "surface"), std::pair(omitted_lines_, "line"),
                                     std::pair(omitted_points_, "point")})
    if (count > 0) omitted.push_back(counted(count, thing));
  if (!omitted.empty()) {
    std::string list = omitted.front();
    for (std::size_t i = 1; i < omitted.size(); ++i) list += (i + 1 < omitted.size() ? ", " : " and ") + omitted[i];
    model_.notes.push_back(list + " beside solids left out as construction geometry: FILE:construction=draw draws it");
  }
  auto note = [this](std::size_t count, const std::string& thing, const std::string& one, const std::string& many) {
    if (count > 0) model_.notes.push_back(counted(count, thing) + (count == 1 ? one : many));
  };
  note(endless_, "line", " without an end or without a curve is not drawn",
       " without an end or without a curve are not drawn");
  if (loose_ > 0)
    model_.notes.push_back(std::to_string(loose_) + " loose faces and shells were sewn into " +
                           std::to_string(sewn_into_));
}

TreeBuilder::Prototype TreeBuilder::make(const TopoDS_Shape& shape, const std::string& name, const Company& company) {
  WireEdges wires = edges_outside_faces(shape);
  Content content{bodies_of(shape), std::move(wires.edges), wires.endless, points_outside_edges(shape)};
  if (construction_ == Construction::omit) omit_construction(content, company);
  endless_ += content.endless;
  loose_ += content.bodies.loose;
  sewn_into_ += content.bodies.sewn_into;
  std::vector<TopoDS_Shape> bodies = std::move(content.bodies.closed);
  bodies.insert(bodies.end(), content.bodies.open.begin(), content.bodies.open.end());
  Prototype prototype;
  separate_repeats(bodies, prototype);
  if (!bodies.empty() || !content.wires.empty() || !content.points.empty()) {
    prototype.part = add_part(name, bodies);
    Part& part = model_.parts[prototype.part];
    part.wires = std::move(content.wires);
    part.points = std::move(content.points);
    part.colour = colour_of(shape);
  }
  return prototype;
}

// Datum planes, sketches and reference points. Files rarely say so: STEP has constructive geometry, but programs write
// datums as surfaces, curves and points of the part's own representation. What has no body beside it is the part
// itself. Surfaces stay beside bodies that were only sewn, since they may be bodies with larger gaps.
void TreeBuilder::omit_construction(Content& content, const Company& company) {
  Bodies& bodies = content.bodies;
  if (bodies.closed.empty() && !company.has_solid && !company.has_closed_shell) return;
  omitted_lines_ += content.wires.size() + content.endless;
  omitted_points_ += content.points.size();
  content.wires.clear();
  content.points.clear();
  content.endless = 0;
  if ((bodies.solids == 0 && !company.has_solid) || bodies.open.empty()) return;
  omitted_surfaces_ += bodies.open.size();
  bodies.open.clear();
  if (bodies.closed.size() == bodies.solids) bodies.loose = bodies.sewn_into = 0;
}

void TreeBuilder::separate_repeats(std::vector<TopoDS_Shape>& bodies, Prototype& prototype) {
  NCollection_IndexedDataMap<TopoDS_Shape, std::vector<TopoDS_Shape>, TopTools_ShapeMapHasher> same;
  for (const TopoDS_Shape& body : bodies) {
    const TopoDS_Shape own = without_location(body).Oriented(TopAbs_FORWARD);
    const int index = same.FindIndex(own);
    if (index == 0) {
      same.Add(own, {body});
    } else {
      same.ChangeFromIndex(index).push_back(body);
    }
  }
  bodies.clear();
  for (int i = 1; i <= same.Extent(); ++i) {
    const std::vector<TopoDS_Shape>& places = same(i);
    if (places.size() == 1) {
      bodies.push_back(places.front());
      continue;
    }
    const TopoDS_Shape own = without_location(places.front());
    const std::string name = name_of(own);
    const std::uint32_t part = add_part(name, {own});
    for (const TopoDS_Shape& place : places)
      prototype.inside.push_back({name, EPURA_NONE, part, place.Location().Transformation()});
  }
}

std::uint32_t TreeBuilder::add_part(const std::string& name, const std::vector<TopoDS_Shape>& bodies) {
  Part part;
  part.name = name;
  for (const TopoDS_Shape& body : bodies) part.bodies.push_back({body, name_of(body), colour_of(body)});
  model_.parts.push_back(std::move(part));
  return static_cast<std::uint32_t>(model_.parts.size() - 1);
}

std::string TreeBuilder::name_of(const TopoDS_Shape& body) const {
  const std::string* name = attributes_.names.Seek(without_location(body));
  return name == nullptr ? std::string() : *name;
}

// Many programs colour the faces of a body one by one.
std::optional<Colour> TreeBuilder::colour_of(const TopoDS_Shape& body) const {
  const Colours& colours = attributes_.colours;
  if (const Colour* own = colours.Seek(without_location(body))) return *own;
  const Colour* of_all = nullptr;
  for (TopExp_Explorer faces(body, TopAbs_FACE); faces.More() && !colours.IsEmpty(); faces.Next()) {
    const Colour* one = colours.Seek(without_location(faces.Current()));
    if (one == nullptr || (of_all != nullptr && *one != *of_all)) return std::nullopt;
    of_all = one;
  }
  return of_all == nullptr ? std::nullopt : std::optional(*of_all);
}

}  // namespace occt
