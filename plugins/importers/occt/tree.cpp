// SPDX-License-Identifier: Apache-2.0
#include "tree.hpp"

#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include "bodies.hpp"

namespace occt {

namespace {

TopoDS_Shape without_location(const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location()); }

std::size_t count_outside(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum avoided) {
  std::size_t count = 0;
  for (TopExp_Explorer all(shape, kind, avoided); all.More(); all.Next()) ++count;
  return count;
}

}  // namespace

void TreeBuilder::add(const TopoDS_Shape& shape, const std::string& part_name, const std::string& name,
                      std::uint32_t parent, const gp_Trsf& transform) {
  if (shape.IsNull()) return;
  const TopoDS_Shape own = without_location(shape);
  int index = prototypes_.FindIndex(own);
  if (index == 0) index = prototypes_.Add(own, make(own, part_name));
  const Prototype& prototype = prototypes_(index);
  if (prototype.part == EPURA_NONE && prototype.inside.empty()) return;
  const auto place = static_cast<std::uint32_t>(model_.places.size());
  model_.places.push_back({name, parent, prototype.part, transform * shape.Location().Transformation()});
  for (Place inside : prototype.inside) {
    inside.parent = place;
    model_.places.push_back(inside);
  }
}

std::uint32_t TreeBuilder::add_assembly(const std::string& name, std::uint32_t parent, const gp_Trsf& transform) {
  model_.places.push_back({name, parent, EPURA_NONE, transform});
  return static_cast<std::uint32_t>(model_.places.size() - 1);
}

void TreeBuilder::finish() {
  auto note = [this](std::size_t count, const std::string& thing, const std::string& one, const std::string& many) {
    if (count > 0) model_.notes.push_back(counted(count, thing) + (count == 1 ? one : many));
  };
  note(wires_, "wire", " without faces is not drawn", " without faces are not drawn");
  note(points_, "point", " without edges is not drawn", " without edges are not drawn");
  if (loose_ > 0)
    model_.notes.push_back(std::to_string(loose_) + " loose faces and shells were sewn into " +
                           std::to_string(sewn_into_));
}

TreeBuilder::Prototype TreeBuilder::make(const TopoDS_Shape& shape, const std::string& name) {
  wires_ += count_outside(shape, TopAbs_WIRE, TopAbs_FACE);
  // Edges in no wire count as wires of one edge.
  for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_WIRE); edges.More(); edges.Next()) ++wires_;
  points_ += count_outside(shape, TopAbs_VERTEX, TopAbs_EDGE);
  Bodies found = bodies_of(shape);
  loose_ += found.loose;
  sewn_into_ += found.sewn_into;
  Prototype prototype;
  separate_repeats(found.shapes, prototype);
  if (!found.shapes.empty()) prototype.part = add_part(name, found.shapes);
  return prototype;
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
  Part part{name, {}};
  for (const TopoDS_Shape& body : bodies) part.bodies.push_back({body, name_of(body)});
  model_.parts.push_back(std::move(part));
  return static_cast<std::uint32_t>(model_.parts.size() - 1);
}

std::string TreeBuilder::name_of(const TopoDS_Shape& body) const {
  const std::string* name = names_.Seek(without_location(body));
  return name == nullptr ? std::string() : *name;
}

}  // namespace occt
