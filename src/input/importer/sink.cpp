// SPDX-License-Identifier: Apache-2.0
#include "importer/sink.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <exception>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "foreign/parameters.hpp"

namespace epura::importer {

namespace {

using foreign::require;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

constexpr std::size_t max_notes = 100;

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

template <class Numbers>
Vec3 vector_of(const Numbers& v) {
  return {v[0], v[1], v[2]};
}

// Indexed by the numbers in importer_abi.h.
constexpr std::array surface_kinds{SurfaceKind::free_form, SurfaceKind::plane,  SurfaceKind::cylinder,
                                   SurfaceKind::cone,      SurfaceKind::sphere, SurfaceKind::torus};

PartSurface surface_of(const epura_face& face) {
  require(face.size >= sizeof(epura_face), "hands over a face of " + std::to_string(face.size) + " bytes");
  require(face.kind < surface_kinds.size(), "hands over a face of unknown kind " + std::to_string(face.kind));
  PartSurface surface;
  surface.kind = surface_kinds[face.kind];
  if (surface.kind == SurfaceKind::free_form) return surface;
  const bool is_round = surface.kind != SurfaceKind::plane, has_axis = surface.kind != SurfaceKind::sphere;
  surface.origin = vector_of(face.origin);
  require(finite(surface.origin), "hands over a face whose place is not finite");
  if (has_axis) {
    const Vec3 axis = vector_of(face.axis);
    require(finite(axis) && axis != Vec3(0), "hands over a face without an axis");
    surface.axis = glm::normalize(axis);
  }
  if (is_round) surface.radius = face.radius;
  if (surface.kind == SurfaceKind::torus) surface.minor = face.minor;
  if (surface.kind == SurfaceKind::cone) surface.slope = face.slope;
  const bool may_be_flat = surface.kind == SurfaceKind::cone || surface.kind == SurfaceKind::torus;
  require(!is_round || (std::isfinite(surface.radius) && (surface.radius > 0 || (may_be_flat && surface.radius == 0))),
          "hands over a round face whose radius is not positive");
  require(surface.kind != SurfaceKind::torus || (std::isfinite(surface.minor) && surface.minor > 0),
          "hands over a torus whose tube has no positive radius");
  require(std::isfinite(surface.slope), "hands over a cone whose slope is not finite");
  return surface;
}

// Its numbers are those of importer_abi.h.
EdgeSpline spline_of(const epura_spline& told, std::size_t points) {
  constexpr std::uint32_t most_degree = 25;  // as Open CASCADE, and more than any file has
  require(1 <= told.degree && told.degree <= most_degree, "hands over a spline of unknown degree");
  require(told.degree < told.pole_count && told.pole_count <= INT_MAX / 6,
          "hands over a spline of no more poles than its degree, or of more than can be numbered");
  require(told.poles != nullptr && told.knots != nullptr && told.parameters != nullptr,
          "hands over a spline without poles, knots or parameters");
  EdgeSpline taken{false, 0, {static_cast<int>(told.degree), {}, {}}, {}};
  const auto are_finite = [](const double* numbers, std::size_t count) {
    return std::all_of(numbers, numbers + count, [](double v) { return std::isfinite(v); });
  };
  const std::size_t knots = told.pole_count + told.degree + 1;
  require(are_finite(told.poles, 3 * told.pole_count), "hands over a spline with a pole that is not finite");
  for (std::size_t i = 0; i < told.pole_count; ++i) {
    const double weight = told.weights == nullptr ? 1 : told.weights[i];
    require(weight > 0 && std::isfinite(weight), "hands over a spline with a weight that is not positive");
    const double* p = told.poles + 3 * i;
    taken.spline.poles.emplace_back(weight * p[0], weight * p[1], weight * p[2], weight);
  }
  require(are_finite(told.knots, knots) && std::is_sorted(told.knots, told.knots + knots) &&
              told.knots[told.degree] < told.knots[told.pole_count],
          "hands over a spline whose knots do not rise");
  taken.spline.knots.assign(told.knots, told.knots + knots);
  taken.parameters.assign(told.parameters, told.parameters + points);
  const auto [least, most] = std::ranges::minmax(taken.parameters);
  const auto rise = [](const auto& order) { return [order](double a, double b) { return !order(a, b); }; };
  require(are_finite(told.parameters, points) && told.knots[told.degree] <= least &&
              most <= told.knots[told.pole_count] &&
              (std::ranges::adjacent_find(taken.parameters, rise(std::less())) == taken.parameters.end() ||
               std::ranges::adjacent_find(taken.parameters, rise(std::greater())) == taken.parameters.end()),
          "hands over a spline with parameters that neither all rise nor all fall between its ends");
  return taken;
}

// Without faces.
Requirement requirement_of(const epura_requirement& told) {
  const auto bounds = static_cast<RequirementBounds>(told.bounds);
  return {{.kind = static_cast<RequirementKind>(told.kind),
           .bounds = bounds,
           .is_angle = told.is_angle != 0 ? 1 : 0,
           .decimals = told.decimals,
           .value = told.value,
           .lower = bounds == RequirementBounds::none ? std::nan("") : told.lower,
           .upper = bounds == RequirementBounds::none ? std::nan("") : told.upper,
           .unit = told.unit,
           .id = text_of(told.id),
           .type = text_of(told.type),
           .name = text_of(told.name),
           .fit = text_of(told.fit),
           .modifiers = text_of(told.modifiers),
           .zone = text_of(told.zone),
           .datums = text_of(told.datums),
           .above = text_of(told.above),
           .missing = text_of(told.missing),
           .text = text_of(told.text)},
          {}};
}

}  // namespace

DocumentSink::DocumentSink(std::function<void(double)> tell, bool takes_splines)
    : tell_(std::move(tell)),
      calls_{sizeof(epura_sink),
             0,
             this,
             &call<&DocumentSink::unit, double>,
             &call<&DocumentSink::up, char>,
             &call<&DocumentSink::shape, const char*>,
             &call<&DocumentSink::body, const char*>,
             &call<&DocumentSink::points, uint64_t, const double*>,
             &call<&DocumentSink::face, const epura_face*>,
             &call<&DocumentSink::polygons, uint64_t, const uint64_t*, const uint32_t*>,
             &call<&DocumentSink::edge, const epura_edge*>,
             &call<&DocumentSink::node, const epura_node*>,
             &call<&DocumentSink::note, const char*>,
             &call<&DocumentSink::progress, double>,
             &call<&DocumentSink::rounding, uint32_t>,
             &call<&DocumentSink::colour, double, double, double>,
             &call<&DocumentSink::step, double>,
             &call<&DocumentSink::requirement, const epura_requirement*>,
             &call<&DocumentSink::saved_view, const epura_saved_view*>,
             &call<&DocumentSink::standard, const char*>,
             takes_splines ? &call<&DocumentSink::spline, const epura_spline*> : nullptr} {}

template <auto member, class... A>
int DocumentSink::call(void* host, A... arguments) noexcept {
  auto* sink = static_cast<DocumentSink*>(host);
  if (!sink->fault_.empty()) return 1;
  try {
    return (sink->*member)(arguments...);
  } catch (const std::exception& error) {
    sink->fault_ = error.what();
    return 1;
  }
}

Shape& DocumentSink::current() {
  require(!document_.shapes.empty(), "hands over a part of a shape before any shape");
  return document_.shapes.back();
}

void DocumentSink::expect_fewer(std::size_t items) const {
  require(items <= INT_MAX / 6, "hands over more than can be numbered");
}

void DocumentSink::expect_points(uint64_t count, const uint32_t* numbers, const char* what) {
  require(count == 0 || numbers != nullptr, std::string("hands over no corners of ") + what);
  const std::size_t points = current().points.size();
  require(std::all_of(numbers, numbers + count, [&](uint32_t n) { return n < points; }),
          std::string("hands over ") + what + " with a corner that is no point of the shape");
}

int DocumentSink::unit(double millimetres) {
  require(std::isfinite(millimetres) && millimetres > 0, "hands over a unit of length that is not positive");
  document_.unit = millimetres;
  return 0;
}

int DocumentSink::up(char axis) {
  require(axis == 'y' || axis == 'z', "hands over an upward axis that is neither 'y' nor 'z'");
  document_.is_y_up = axis == 'y' ? 1 : 0;
  return 0;
}

int DocumentSink::shape(const char* name) {
  expect_fewer(document_.shapes.size());
  document_.shapes.emplace_back().name = text_of(name);
  edge_ = {};
  begun_ = Begun::shape;
  return 0;
}

int DocumentSink::body(const char* name) {
  expect_fewer(current().body_names.size());
  current().body_names.push_back(text_of(name));
  current().body_colours.push_back(no_colour);
  begun_ = Begun::body;
  return 0;
}

int DocumentSink::points(uint64_t count, const double* xyz) {
  mesh::Points& points = current().points;
  require(count == 0 || xyz != nullptr, "hands over no points where it says so");
  require(count <= INT_MAX / 6, "hands over more points than can be numbered");
  expect_fewer(points.size() + count);
  const std::size_t before = points.size();
  points.resize(before + count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(xyz + 3 * i, 3, points[before + i].begin());
  return 0;
}

int DocumentSink::face(const epura_face* face) {
  require(face != nullptr, "hands over no face where it says so");
  expect_fewer(current().faces.size());
  current().faces.push_back(surface_of(*face));
  return 0;
}

int DocumentSink::polygons(uint64_t count, const uint64_t* ends, const uint32_t* corners) {
  if (count == 0) return 0;
  Shape& shape = current();
  require(ends != nullptr && std::is_sorted(ends, ends + count) && count <= INT_MAX / 6,
          "hands over polygons whose ends do not follow each other");
  const uint64_t last = ends[count - 1];
  require(last <= INT_MAX / 6, "hands over more corners than can be numbered");
  expect_fewer(shape.corners.size() + last);
  expect_points(last, corners, "a polygon");
  const auto before = static_cast<int>(shape.corners.size());
  shape.corners.insert(shape.corners.end(), corners, corners + last);
  for (std::size_t i = 0; i < count; ++i) shape.polygon_ends.push_back(before + static_cast<int>(ends[i]));
  shape.face_of_polygon.resize(shape.polygon_ends.size(), static_cast<int>(shape.faces.size()) - 1);
  shape.body_of_polygon.resize(shape.polygon_ends.size(), static_cast<int>(shape.body_names.size()) - 1);
  return 0;
}

int DocumentSink::edge(const epura_edge* edge) {
  require(edge != nullptr && edge->size >= sizeof(epura_edge), "hands over no edge where it says so");
  require(edge->kind <= EPURA_POINT, "hands over an edge of unknown kind " + std::to_string(edge->kind));
  const bool is_point = edge->kind == EPURA_POINT;
  require(is_point || edge->count >= 2, "hands over an edge of fewer than two points");
  require(!is_point || edge->count == 1, "hands over a point that is not one");
  require(std::isnan(edge->angle) || (edge->angle >= 0 && edge->angle <= 180),
          "hands over an edge whose angle is not between 0 and 180 degrees");
  const bool is_wire = edge->kind == EPURA_WIRE;
  expect_points(edge->count, edge->vertices, is_point ? "a point" : is_wire ? "a wire" : "an edge");
  Shape& shape = current();
  edge_ = {};
  if (is_point) {
    expect_fewer(shape.marked_points.size());
    shape.marked_points.push_back(static_cast<int>(*edge->vertices));
    return 0;
  }
  std::vector<int>& vertices = is_wire ? shape.wire_vertices : shape.edge_vertices;
  expect_fewer(vertices.size() + edge->count);
  vertices.insert(vertices.end(), edge->vertices, edge->vertices + edge->count);
  edge_ = std::span(vertices).last(edge->count);
  is_wire_ = is_wire;
  if (is_wire) {
    shape.wire_ends.push_back(static_cast<int>(vertices.size()));
    return 0;
  }
  shape.edges.push_back({edge->angle, edge->kind == EPURA_TANGENT, static_cast<int>(shape.edge_vertices.size())});
  return 0;
}

int DocumentSink::node(const epura_node* node) {
  require(node != nullptr && node->size >= sizeof(epura_node), "hands over no node where it says so");
  const std::size_t number = document_.nodes.size();
  expect_fewer(number);
  require(node->parent == EPURA_NONE || node->parent < number, "hands over a node whose parent is not an earlier one");
  const auto number_or_none = [](uint32_t n) { return n == EPURA_NONE ? -1 : static_cast<int>(n); };
  Node taken{number_or_none(node->parent), number_or_none(node->shape), text_of(node->name), {}};
  require(taken.shape >= -1, "hands over a node with a shape that cannot be numbered");
  std::copy_n(node->transform, taken.transform.size(), taken.transform.begin());
  require(std::all_of(taken.transform.begin(), taken.transform.end(), [](double v) { return std::isfinite(v); }),
          "hands over a node whose transform is not finite");
  document_.nodes.push_back(std::move(taken));
  begun_ = Begun::node;
  return 0;
}

int DocumentSink::note(const char* sentence) {
  if (document_.notes.size() < max_notes) document_.notes.push_back(text_of(sentence));
  return 0;
}

int DocumentSink::rounding(uint32_t kinds) {
  require((kinds & ~(EPURA_SINGLE | EPURA_PRINTED)) == 0, "tells of a rounding that is not known");
  document_.is_single_precision = (kinds & EPURA_SINGLE) != 0 ? 1 : 0;
  document_.is_printed = (kinds & EPURA_PRINTED) != 0 ? 1 : 0;
  return 0;
}

int DocumentSink::colour(double red, double green, double blue) {
  int number = 0;
  for (const double part : {red, green, blue}) {
    require(part >= 0 && part <= 1, "hands over a colour that is not between 0 and 1");
    number = 256 * number + static_cast<int>(std::lround(255 * part));
  }
  require(begun_ != Begun::nothing, "hands over a colour of nothing");
  if (begun_ == Begun::node) document_.nodes.back().colour = number;
  if (begun_ == Begun::shape) document_.shapes.back().colour = number;
  if (begun_ == Begun::body) document_.shapes.back().body_colours.back() = number;
  return 0;
}

int DocumentSink::step(double distance) {
  require(std::isfinite(distance) && distance > 0, "hands over a step of coordinates that is not positive");
  current().step = std::max(current().step, distance);
  return 0;
}

int DocumentSink::requirement(const epura_requirement* told) {
  require(told != nullptr && told->size >= sizeof(epura_requirement), "hands over no requirement where it says so");
  expect_fewer(document_.requirements.size());
  require(told->id != nullptr && *told->id != '\0' && ids_.insert(told->id).second,
          "hands over a requirement whose id is empty or that of another one");
  require(told->kind <= EPURA_SURFACE_TEXTURE && told->bounds <= EPURA_LIMITS,
          std::string("hands over the requirement ") + told->id + " of unknown kind or with unknown bounds");
  require(-1 <= told->decimals && told->decimals <= max_decimals,
          std::string("hands over the requirement ") + told->id + " with decimals that no number has");
  require(told->face_count == 0 || told->faces != nullptr,
          std::string("hands over no faces of the requirement ") + told->id);
  require(told->line_count == 0 || told->lines != nullptr,
          std::string("hands over no lines of the requirement ") + told->id);
  expect_fewer(told->line_count);
  document_.requirements.push_back(requirement_of(*told));
  Requirement& taken = document_.requirements.back();
  for (std::uint64_t i = 0; i < told->line_count; ++i)
    std::copy_n(told->lines + 6 * i, 6, taken.lines.emplace_back().begin());
  for (std::size_t i = 0; told->area != nullptr && i < 3; ++i)
    std::copy_n(told->area + 3 * i, 3, taken.area.emplace_back().begin());
  require(has_sound_places(taken), "hands over the requirement " + taken.id + " with places that are not finite");
  for (uint32_t i = 0; i < told->face_count; ++i) {
    const uint32_t shape = told->faces[2 * i], face = told->faces[2 * i + 1];
    require(shape < document_.shapes.size() && face < document_.shapes[shape].faces.size(),
            std::string("hands over the requirement ") + told->id + " with a face that it does not hand over");
    document_.requirements.back().faces.push_back({static_cast<int>(shape), static_cast<int>(face)});
  }
  auto& faces = document_.requirements.back().faces;
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return 0;
}

int DocumentSink::saved_view(const epura_saved_view* told) {
  require(told != nullptr && told->size >= sizeof(epura_saved_view), "hands over no saved view where it says so");
  const std::string name = text_of(told->name);
  std::vector<SavedView>& views = document_.saved_views;
  require(!name.empty() && std::ranges::none_of(views, [&](const SavedView& one) { return one.name == name; }),
          "hands over a saved view whose name is empty or that of another one");
  require(told->plane_count == 0 || told->planes != nullptr, "hands over no planes of the saved view " + name);
  expect_fewer(views.size() + told->plane_count);
  SavedView view{told->is_central != 0 ? 1 : 0, name, {}, {}, {}};
  std::copy_n(told->eye, 3, view.eye.begin());
  std::copy_n(told->towards, 3, view.towards.begin());
  std::copy_n(told->up, 3, view.up.begin());
  for (std::uint64_t i = 0; i < told->plane_count; ++i)
    std::copy_n(told->planes + 6 * i, 6, view.planes.emplace_back().begin());
  require(is_sound_view(view), "hands over the saved view " + name + " with directions or places that are none");
  views.push_back(std::move(view));
  return 0;
}

int DocumentSink::standard(const char* name) {
  document_.standard = text_of(name);
  return 0;
}

// Its points may be off by their tolerance, but not by more than they are apart.
int DocumentSink::spline(const epura_spline* told) {
  require(told != nullptr && told->size >= sizeof(epura_spline), "hands over no spline where it says so");
  require(!edge_.empty(), "hands over a spline of no edge");
  EdgeSpline taken = spline_of(*told, edge_.size());
  Shape& shape = current();
  const auto point = [&](std::size_t i) { return vector_of(shape.points[static_cast<std::size_t>(edge_[i])]); };
  for (std::size_t i = 0; i < edge_.size(); ++i) {
    const Vec4 on_it = point_of(taken.spline, taken.parameters[i]);
    const double apart = glm::distance(point(i), point(i == 0 ? 1 : i - 1));
    require(glm::distance(Vec3(on_it) / on_it.w, point(i)) <= apart,
            "hands over a spline that does not run through the points of its edge");
  }
  taken.is_wire = is_wire_;
  taken.number = static_cast<int>(is_wire_ ? shape.wire_ends.size() : shape.edges.size()) - 1;
  shape.splines.push_back(std::move(taken));
  edge_ = {};
  return 0;
}

int DocumentSink::progress(double done) {
  if (done >= 0 && done <= 1) tell_(done);
  return 0;
}

}  // namespace epura::importer
