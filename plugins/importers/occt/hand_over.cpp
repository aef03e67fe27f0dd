// SPDX-License-Identifier: Apache-2.0
#include "hand_over.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <epura/opencascade_spline.hpp>
#include <stdexcept>
#include <utility>

#include "body_mesh.hpp"
#include "joints.hpp"
#include "readers.hpp"
#include "surface.hpp"
#include "wires.hpp"

namespace occt {

namespace {

struct Totals {
  std::size_t faces = 0, wires = 0, points = 0, unmeshed = 0, inner = 0, gaps = 0, turned = 0;
  double error = 0;

  void add(const BodyMesh& mesh) {
    faces += mesh.faces.size();
    unmeshed += mesh.unmeshed_faces;
    inner += mesh.inner_faces;
    gaps += mesh.gaps;
    error = std::max(error, mesh.error);
    turned += mesh.is_turned ? 1 : 0;
  }
};

void hand_over(const std::optional<Colour>& colour, epura::plugin::Sink& sink) {
  if (colour) sink.colour((*colour)[0], (*colour)[1], (*colour)[2]);
}

/// A shape and a face of it, for each place where a face is handed over.
using FaceNumbers =
    NCollection_DataMap<TopoDS_Shape, std::vector<std::array<std::uint32_t, 2>>, TopTools_ShapeMapHasher>;

/// Numbers the faces that are handed over.
class FaceCounter {
 public:
  void begin_shape() {
    ++shapes_;
    faces_ = 0;
  }
  void count(const TopoDS_Shape& face) {
    const TopoDS_Shape key = face.Located(TopLoc_Location());
    if (!numbers_.IsBound(key)) numbers_.Bind(key, {});
    numbers_.ChangeFind(key).push_back({shapes_ - 1, faces_++});
  }
  [[nodiscard]] const FaceNumbers& numbers() const { return numbers_; }

 private:
  std::uint32_t shapes_ = 0, faces_ = 0;
  FaceNumbers numbers_;
};

void hand_over(const Requirement& requirement, const FaceNumbers& numbers, epura::plugin::Sink& sink) {
  std::vector<std::uint32_t> faces;
  std::size_t lost = 0;
  for (const TopoDS_Shape& face : requirement.faces) {
    const auto* found = numbers.Seek(face.Located(TopLoc_Location()));
    if (found == nullptr) ++lost;
    if (found != nullptr)
      for (const auto& number : *found) faces.insert(faces.end(), number.begin(), number.end());
  }
  std::string missing = requirement.missing;
  if (lost > 0) missing += (missing.empty() ? "" : ", ") + counted(lost, "face") + " beside the drawn ones";
  const auto text = [](const std::string& words) { return words.empty() ? nullptr : words.c_str(); };
  std::vector<double> lines, area;
  for (const std::array<double, 6>& line : requirement.lines) lines.insert(lines.end(), line.begin(), line.end());
  for (const gp_XYZ& v : requirement.area) area.insert(area.end(), {v.X(), v.Y(), v.Z()});
  sink.requirement({.size = sizeof(epura_requirement),
                    .kind = requirement.kind,
                    .id = requirement.id.c_str(),
                    .type = text(requirement.type),
                    .name = text(requirement.name),
                    .value = requirement.value,
                    .lower = requirement.lower,
                    .upper = requirement.upper,
                    .bounds = requirement.bounds,
                    .is_angle = requirement.is_angle ? 1u : 0u,
                    .unit = requirement.unit,
                    .decimals = requirement.decimals,
                    .face_count = static_cast<std::uint32_t>(faces.size() / 2),
                    .faces = faces.data(),
                    .fit = text(requirement.fit),
                    .modifiers = text(requirement.modifiers),
                    .zone = text(requirement.zone),
                    .datums = text(requirement.datums),
                    .above = text(requirement.above),
                    .missing = text(missing),
                    .text = text(requirement.text),
                    .line_count = lines.size() / 6,
                    .lines = lines.data(),
                    .area = area.empty() ? nullptr : area.data()});
}

void hand_over(const SavedView& view, epura::plugin::Sink& sink) {
  std::vector<double> planes;
  for (const std::array<double, 6>& plane : view.planes) planes.insert(planes.end(), plane.begin(), plane.end());
  sink.saved_view({.size = sizeof(epura_saved_view),
                   .is_central = view.is_central ? 1u : 0u,
                   .name = view.name.c_str(),
                   .eye = {view.eye.X(), view.eye.Y(), view.eye.Z()},
                   .towards = {view.towards.X(), view.towards.Y(), view.towards.Z()},
                   .up = {view.up.X(), view.up.Y(), view.up.Z()},
                   .plane_count = view.planes.size(),
                   .planes = planes.data()});
}

void hand_over_spline(const TopoDS_Edge& edge, std::vector<double> parameters, epura::plugin::Sink& sink) {
  if (!sink.takes_splines()) return;
  const epura::OpenCascadeSpline spline(edge, std::move(parameters));
  if (epura_spline told; spline.told(told)) sink.spline(told);
}

void hand_over(const Body& body, const BodyMesh& mesh, FaceCounter& counter, epura::plugin::Sink& sink) {
  sink.body(body.name);
  hand_over(body.colour, sink);
  sink.points(mesh.points);
  for (const Facets& facets : mesh.faces) {
    counter.count(facets.face);
    sink.face(surface_of(facets.face));
    sink.triangles(facets.triangles);
  }
  for (Joint& joint : joints_of(mesh)) {
    sink.edge(joint.along.points, joint.is_tangent, joint.angle);
    hand_over_spline(joint.edge, std::move(joint.along.parameters), sink);
  }
}

void hand_over(const WireMesh& mesh, epura::plugin::Sink& sink) {
  sink.points(mesh.points);
  for (const Wire& wire : mesh.wires) {
    sink.wire(wire.along.points);
    hand_over_spline(wire.edge, wire.along.parameters, sink);
  }
}

void hand_over(const std::vector<gp_Pnt>& points, std::uint32_t first, epura::plugin::Sink& sink) {
  std::vector<epura::plugin::Point> places;
  for (const gp_Pnt& point : points) places.push_back({point.X(), point.Y(), point.Z()});
  sink.points(places);
  for (std::uint32_t i = 0; i < places.size(); ++i) sink.point(first + i);
}

epura::plugin::Transform rows_of(const gp_Trsf& transform) {
  epura::plugin::Transform rows{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) rows[4 * row + column] = transform.Value(row + 1, column + 1);
  return rows;
}

/// Two significant digits, independent of the locale.
std::string rough(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 2).ptr;
  return {text.data(), end};
}

void note(const Totals& totals, std::vector<std::string>& notes) {
  if (totals.unmeshed > 0)
    notes.push_back(counted(totals.unmeshed, "face") + " could not be tessellated: holes are left in their places");
  if (totals.inner > 0) notes.push_back(counted(totals.inner, "face") + " inside solids bound nothing: not drawn");
  if (totals.gaps > 0)
    notes.push_back(counted(totals.gaps, "edge") + " have faces that do not agree on their points: fine gaps are left");
  if (totals.error > 0)
    notes.push_back("some faces could not be tessellated finely enough: they are off by " + rough(totals.error) +
                    " mm");
  if (totals.turned > 0) notes.push_back(counted(totals.turned, "solid") + " with faces that looked inward: turned");
}

}  // namespace

void hand_over(Model& model, const Fineness& fineness, epura::plugin::Sink& sink) {
  sink.unit(1);
  Totals totals;
  FaceCounter counter;
  const double done = share_of_reading + share_of_meshing;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Part& part = model.parts[i];
    sink.progress(done + (1 - done) * static_cast<double>(i) / static_cast<double>(model.parts.size()));
    sink.shape(part.name);
    counter.begin_shape();
    hand_over(part.colour, sink);
    std::uint32_t points = 0;
    for (const Body& body : part.bodies) {
      const BodyMesh mesh = mesh_of(body.shape, points, fineness.deflection);
      totals.add(mesh);
      if (mesh.faces.empty()) continue;
      hand_over(body, mesh, counter, sink);
      points += static_cast<std::uint32_t>(mesh.points.size());
    }
    const WireMesh wires = mesh_of(part.wires, points, fineness);
    totals.wires += wires.wires.size();
    hand_over(wires, sink);
    hand_over(part.points, points + static_cast<std::uint32_t>(wires.points.size()), sink);
    totals.points += part.points.size();
  }
  note(totals, model.notes);
  for (const std::string& sentence : model.notes) sink.note(sentence);
  if (totals.faces == 0 && totals.wires == 0 && totals.points == 0)
    throw std::runtime_error("holds no face that could be tessellated");
  for (const Place& place : model.places) {
    sink.node(place.name, place.parent, place.part, rows_of(place.transform));
    hand_over(place.colour, sink);
  }
  for (const Requirement& requirement : model.requirements) hand_over(requirement, counter.numbers(), sink);
  for (const SavedView& view : model.saved_views) hand_over(view, sink);
  if (!model.standard.empty()) sink.standard(model.standard);
  sink.progress(1);
}

}  // namespace occt
