// SPDX-License-Identifier: Apache-2.0
#include "views/constructions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "annotations/construction_layer.hpp"
#include "base/error.hpp"
#include "construction/axonometry.hpp"
#include "construction/perspective.hpp"
#include "drawing/drawing.hpp"
#include "sheet/arrangement.hpp"
#include "sizes/anchors.hpp"
#include "view/paper_map.hpp"

namespace epura::pipeline {

namespace {

using construction::Request;
using scene::ConstructionArgument;
using scene::ConstructionFamily;
using scene::ConstructionKind;

constexpr double on_axis = 1e-9;  // sine

/// The part that a view plays.
enum class Part { central, parallel, epura };

Part part_of(const view::ProjectedScene& seen, bool in_epura) {
  return in_epura ? Part::epura : seen.projection.central ? Part::central : Part::parallel;
}

bool is_in_epura(const SheetOfViews& views, std::size_t view) {
  return views.epura && (view == views.epura->elevation || view == views.epura->plan);
}

bool suits(ConstructionFamily family, Part part) {
  switch (family) {
    case ConstructionFamily::any:
      return true;
    case ConstructionFamily::central:
      return part == Part::central;
    case ConstructionFamily::parallel:
      return part == Part::parallel;
    case ConstructionFamily::epura:
      return part == Part::epura;
    case ConstructionFamily::central_or_epura:
      return part != Part::parallel;
    case ConstructionFamily::not_epura:
      return part != Part::epura;
  }
  return false;
}

std::string family_name(ConstructionFamily family) {
  switch (family) {
    case ConstructionFamily::central:
      return "a central projection, such as two-point";
    case ConstructionFamily::parallel:
      return "a parallel projection, such as isometric";
    case ConstructionFamily::epura:
      return "an épura: --views epura";
    case ConstructionFamily::not_epura:
      return "a view outside an épura, where 'point' names vertices";
    default:
      return "a central projection, or an épura";
  }
}

const mesh::Mesh& model_of(const world::World& world, const Request& request) {
  const int models = static_cast<int>(world.models.size());
  if (request.item.model >= models)
    construction::refuse(
        request, "names model " + std::to_string(request.item.model) + ", which does not exist",
        models == 1 ? "the only model is 0" : "models are numbered from 0 to " + std::to_string(models - 1));
  return world.models[static_cast<std::size_t>(request.item.model)].mesh->whole();
}

Vec3 vertex_of(const world::World& world, const Request& request, int vertex) {
  return sheet::position_of(world, std::array<int, 2>{request.item.model, vertex}, request.where);
}

void add_edge(Request& request, const world::World& world) {
  const mesh::Mesh& mesh = model_of(world, request);
  for (const int vertex : request.item.numbers) request.elements.push_back(vertex_of(world, request, vertex));
  const mesh::MeshEdge* edge = mesh.edge_between(request.item.numbers);
  if (edge == nullptr || edge->diagonal)
    construction::refuse(request, "names an edge that does not exist",
                         "'epura draw ... --dump edges' lists the edges by their vertices");
}

// The corners of a polygon of the file, in order around it; the first ring if it has holes.
std::vector<int> ring_of(const mesh::Mesh& mesh, int face) {
  std::map<int, int> next;
  std::set<std::pair<int, int>> inside;
  for (int pass = 0; pass < 2; ++pass)
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      if (mesh.polygon[static_cast<std::size_t>(t)] != face) continue;
      const std::array<int, 3> corners = mesh.triangle(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = corners[i], b = corners[(i + 1) % 3];
        if (pass == 0)
          inside.emplace(a, b);
        else if (!inside.contains({b, a}))
          next.emplace(a, b);
      }
    }
  std::vector<int> ring;
  if (next.empty()) return ring;
  for (int at = next.begin()->first; ring.size() < next.size() && (ring.empty() || at != ring.front()); at = next[at])
    ring.push_back(at);
  return ring;
}

void add_face(Request& request, const world::World& world) {
  constexpr double flat = 1e-6;  // part of the model's size
  const mesh::Mesh& mesh = model_of(world, request);
  const std::vector<int> ring = ring_of(mesh, request.item.numbers[0]);
  if (ring.size() < 3)
    construction::refuse(request, "names a face that does not exist",
                         "faces are numbered from 0 to " + std::to_string(mesh.report.faces - 1));
  for (const int vertex : ring) request.elements.push_back(vertex_of(world, request, vertex));
  Vec3 normal(0);
  for (std::size_t i = 0; i < ring.size(); ++i)
    normal += glm::cross(request.elements[i] - request.elements[0],
                         request.elements[(i + 1) % ring.size()] - request.elements[0]);
  normal = glm::normalize(normal);
  for (const Vec3& corner : request.elements)
    if (std::abs(glm::dot(corner - request.elements[0], normal)) > flat * glm::length(world.box.size()))
      construction::refuse(request, "names a face that is not flat", "choose a flat one");
}

// Three points of a plane, as far apart as the models are large.
void add_plane(Request& request, const world::World& world) {
  const Vec3 n = glm::normalize(*request.item.direction);
  const Vec3 least(std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? Vec3(1, 0, 0)
                   : std::abs(n.y) <= std::abs(n.z)                                 ? Vec3(0, 1, 0)
                                                                                    : Vec3(0, 0, 1));
  const double size = std::max(glm::length(world.box.size()), 1.0);
  const Vec3 u = glm::normalize(glm::cross(least, n)), v = glm::cross(n, u);
  request.elements = {*request.item.at, *request.item.at + size * u, *request.item.at + size * v};
}

Request request_of(const world::World& world, const scene::ConstructionItem& item, const std::string& where) {
  Request request{item, where};
  if (item.at) add_plane(request, world);
  if (!item.has_element) return request;
  switch (scene::row_of(item.kind).argument) {
    case ConstructionArgument::edge:
      add_edge(request, world);
      break;
    case ConstructionArgument::vertex:
      model_of(world, request);
      request.elements.push_back(vertex_of(world, request, item.numbers[0]));
      break;
    case ConstructionArgument::face:
    case ConstructionArgument::plane:
      add_face(request, world);
      break;
    default:
      break;
  }
  return request;
}

// Member by member: where memory ends, GCC 12 frees the members of an aggregate twice.
Request optional_request(const scene::ConstructionRow& row, const std::string& where) {
  Request request;
  request.item.kind = row.kind;
  request.item.text = row.word;
  request.where = where;
  request.optional = true;
  return request;
}

// Those that suit the part of the view, "all" as its members.
std::vector<Request> requests_of(const world::World& world, const scene::ViewDescription& view, Part part) {
  std::vector<Request> requests;
  for (const scene::ConstructionItem& item : view.construction.value_or({})) {
    if (item.kind == ConstructionKind::all) {
      for (const scene::ConstructionRow& row : scene::construction_rows)
        if (row.family != ConstructionFamily::any && row.kind != ConstructionKind::vanishing_line && !row.required &&
            suits(row.family, part))
          requests.push_back(optional_request(row, view.construction.where));
    } else if (suits(scene::row_of(item.kind).family, part)) {
      requests.push_back(request_of(world, item, view.construction.where));
    }
  }
  return requests;
}

bool wants_legend(const scene::ViewDescription& view) {
  const scene::ConstructionChoice items = view.construction.value_or({});
  return std::any_of(items.begin(), items.end(), [](const auto& i) { return i.kind == ConstructionKind::legend; });
}

bool is_along_axis(const Vec3& direction) {
  const Vec3 d = glm::normalize(direction);
  int across = 0;
  for (int i = 0; i < 3; ++i) across += std::abs(d[i]) <= on_axis ? 1 : 0;
  return across == 2;
}

// By their models and vertices.
using EdgeNames = std::set<std::array<int, 3>>;

EdgeNames visible_edges(const drawing::ViewDrawing& drawing) {
  EdgeNames names;
  for (const drawing::Segment& segment : drawing.segments)
    if (segment.visible && segment.edge[0] >= 0) names.insert({segment.model, segment.edge[0], segment.edge[1]});
  return names;
}

const Vec3& point_of(const world::World& world, int model, int vertex) {
  return world.points[static_cast<std::size_t>(world.first_vertex[static_cast<std::size_t>(model)] + vertex)];
}

// Whether the triangles at an edge meet in an angle, or it is the border of a surface or a line.
bool is_sharp(const world::World& world, std::size_t model, const mesh::MeshEdge& edge) {
  constexpr double flattest = 0.8660254037844386;  // cosine of 30 degrees
  if (edge.diagonal) return false;
  if (edge.count != 2 || edge.wire) return true;
  std::array<Vec3, 2> normals{};
  for (std::size_t i = 0; i < 2; ++i) {
    const int own = world.models[model].mesh->triangles_of(edge)[i];
    const auto& corners = world.triangles[static_cast<std::size_t>(world.first_triangle[model] + own)];
    const auto point = [&](std::size_t k) { return world.points[static_cast<std::size_t>(corners[k])]; };
    normals[i] = glm::normalize(glm::cross(point(1) - point(0), point(2) - point(0)));
  }
  return glm::dot(normals[0], normals[1]) < flattest;
}

// Where three sharp edges meet, or two at an angle: the corners of flat faces, not the vertices of round edges.
std::vector<Vec3> corners_of(const world::World& world) {
  constexpr double min_turn = 0.7;  // sine of 45 degrees
  std::vector<Vec3> corners;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    std::map<int, std::vector<Vec3>> directions;
    for (const mesh::MeshEdge& edge : world.models[model].mesh->edges) {
      if (!is_sharp(world, model, edge)) continue;
      const auto [a, b] = edge.vertex;
      const Vec3 along = point_of(world, static_cast<int>(model), b) - point_of(world, static_cast<int>(model), a);
      if (!(glm::length(along) > 0)) continue;
      directions[a].push_back(glm::normalize(along));
      directions[b].push_back(-glm::normalize(along));
    }
    for (const auto& [vertex, all] : directions)
      if (all.size() > 2 || (all.size() == 2 && glm::length(glm::cross(all[0], all[1])) > min_turn))
        corners.push_back(point_of(world, static_cast<int>(model), vertex));
  }
  return corners;
}

// The faces only if an intersection needs them.
construction::EpuraModels models_of(const world::World& world, std::span<const Request> requests) {
  construction::EpuraModels models{corners_of(world), {}};
  const auto cuts = [](const Request& request) {
    return request.item.kind == ConstructionKind::piercing || request.item.kind == ConstructionKind::section;
  };
  if (std::none_of(requests.begin(), requests.end(), cuts)) return models;
  std::map<std::array<int, 2>, construction::FaceTriangles> faces;
  for (int t = 0; t < static_cast<int>(world.triangles.size()); ++t) {
    const int model = world.model_of_triangle(t);
    const int own = t - world.first_triangle[static_cast<std::size_t>(model)];
    const mesh::Mesh& mesh = *world.models[static_cast<std::size_t>(model)].mesh;
    const std::array<int, 3>& corners = world.triangles[static_cast<std::size_t>(t)];
    const auto point = [&](std::size_t i) { return world.points[static_cast<std::size_t>(corners[i])]; };
    faces[{model, mesh.polygon[static_cast<std::size_t>(own)]}].push_back({point(0), point(1), point(2)});
  }
  for (auto& [name, triangles] : faces) models.faces.push_back(std::move(triangles));
  return models;
}

double reach_of(const construction::PicturePlane& plane, const drawing::ViewDrawing& drawing) {
  double reach = 0;
  for (const drawing::Segment& segment : drawing.segments)
    reach = std::max({reach, glm::length(segment.from - plane.origin), glm::length(segment.to - plane.origin)});
  return reach;
}

void add_label(construction::Figure& figure, const construction::PicturePlane& plane, const Request& request) {
  const scene::NamedPoint& label = *request.item.label;
  const auto at = construction::image_of(plane, label.at);
  if (!at) construction::refuse(request, "names a point that is not in front of the viewer", "choose another point");
  const std::size_t index = label.symbol.find('_');
  construction::Point point{{label.symbol.substr(0, index)}, *at, *at, label.marked};
  if (index != std::string::npos) point.symbol.index = label.symbol.substr(index + 1);
  if (label.away_from) point.guide = construction::image_of(plane, *label.away_from).value_or(*at);
  if (!label.meaning.empty())
    construction::add_term(figure, label.symbol.substr(0, label.symbol.find(':')), label.meaning);
  construction::add_point(figure, std::move(point));
}

}  // namespace

std::optional<EpuraViews> epura_views(const scene::SheetDescription& sheet, const SheetOfViews& views,
                                      std::span<const view::ProjectedScene> seen) {
  if (sheet.layout.value_or(SheetLayout::standard) != SheetLayout::monge) return std::nullopt;
  const auto find = [&](sheet::ViewPlace place) {
    for (std::size_t i = 0; i < seen.size(); ++i)
      if (sheet::view_place(seen[i].projection) == place && !views.descriptions[i].detail.given() &&
          !views.descriptions[i].scale.given())
        return i;
    throw Error(ErrorKind::input, sheet.layout.where,
                std::string("the layout monge needs a ") + (place == sheet::ViewPlace::front ? "front" : "top") +
                    " view at the scale of the sheet",
                "draw --views epura, or the views front and top");
  };
  if (sheet.angle.value_or(ProjectionAngle::first) == ProjectionAngle::third)
    throw Error(ErrorKind::input, sheet.angle.where, "an épura is in first angle: its plan is below its elevation",
                "omit the third angle");
  return EpuraViews{find(sheet::ViewPlace::front), find(sheet::ViewPlace::top)};
}

void expect_constructions(const SheetOfViews& views, std::span<const view::ProjectedScene> seen) {
  const auto part = [&](std::size_t i) { return part_of(seen[i], is_in_epura(views, i)); };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto& wanted = views.descriptions[i].construction;
    if (!wanted.given() || views.descriptions[i].detail.given()) continue;
    if (views.plans[i].options.exploded)
      throw Error(ErrorKind::input, wanted.where, "view '" + *views.descriptions[i].name + "' is exploded",
                  "constructions need the models in their places");
    if (views.plans[i].options.breaks.any())
      throw Error(ErrorKind::input, wanted.where, "view '" + *views.descriptions[i].name + "' is interrupted",
                  "constructions need a whole view");
    for (const scene::ConstructionItem& item : *wanted) {
      const ConstructionFamily family = scene::row_of(item.kind).family;
      bool is_shown = false;
      for (std::size_t j = 0; j < seen.size(); ++j)
        is_shown = is_shown || (views.descriptions[j].construction.where == wanted.where && suits(family, part(j)));
      if (!is_shown)
        throw Error(ErrorKind::input, wanted.where,
                    "'" + item.text + "' has no meaning in the view '" + *views.descriptions[i].name + "'",
                    "it needs " + family_name(family));
    }
  }
}

construction::Figure figure_of_view(const world::World& world, const scene::ViewDescription& view,
                                    const construction::PicturePlane& plane, double factor,
                                    const construction::Surroundings& around) {
  const std::vector<Request> requests = requests_of(world, view, plane.central ? Part::central : Part::parallel);
  construction::Figure figure = plane.central ? construction::perspective_figure(plane, requests, around)
                                              : construction::axonometry_figure(plane, factor, requests);
  for (const Request& request : requests)
    if (request.item.label) add_label(figure, plane, request);
  figure.legend = wants_legend(view);
  return figure;
}

construction::Figure figure_in_plane(const world::World& world, const scene::ViewDescription& view,
                                     const view::ProjectedScene& seen) {
  const view::PaperMap map = view::make_paper_map(seen, 1, {0, 0});
  const auto plane = construction::picture_plane(seen.projection, view::world_to_page(seen, map), 1);
  construction::Surroundings around{world.box, 0, {}};
  for (const view::ViewTriangle& triangle : seen.triangles)
    for (const int i : triangle.vertex)
      around.reach =
          std::max(around.reach, glm::length(map(seen.vertices[static_cast<std::size_t>(i)]) - plane.origin));
  return figure_of_view(world, view, plane, seen.projection.scale, around);
}

construction::Figure figure_on_paper(const world::World& world, const scene::ViewDescription& view,
                                     const drawing::ViewDrawing& drawing) {
  const auto plane = construction::picture_plane(drawing.projection, drawing.world_to_page, drawing.scale);
  construction::Surroundings around{world.box, reach_of(plane, drawing), {}};
  for (const auto& [model, a, b] : visible_edges(drawing))
    if (const Vec3 from = point_of(world, model, a), to = point_of(world, model, b); is_along_axis(to - from))
      around.axis_edges.push_back({from, to});
  return figure_of_view(world, view, plane, drawing.projection.scale, around);
}

std::array<projection::Window, 2> epura_boxes(const world::World& world, const SheetOfViews& views,
                                              std::span<const view::ProjectedScene> seen) {
  constexpr double usual_size = 150, apart = 20;  // mm on paper
  const std::array<std::size_t, 2> places{views.epura->elevation, views.epura->plan};
  std::array<projection::Window, 2> boxes{view::drawn_box(seen[places[0]]), view::drawn_box(seen[places[1]])};
  double size = 0;
  for (const projection::Window& box : boxes) size = std::max({size, box.max.x - box.min.x, box.max.y - box.min.y});
  if (!(size > 0)) return boxes;
  // As on paper: the elevation above y = 0, the plan below, both with the middle of the world at x = 0.
  const double scale = usual_size / size;
  std::array<construction::PicturePlane, 2> planes;
  std::array<Vec2, 2> shifts;
  for (const std::size_t i : {0, 1}) {
    const view::ProjectedScene& view = seen[places[i]];
    const Vec4 middle =
        view::world_to_page(view, view::make_paper_map(view, scale, {0, 0})) * Vec4(world.box.centre(), 1);
    const double y = i == 0 ? apart - scale * boxes[i].min.y : -apart - scale * boxes[i].max.y;
    shifts[i] = {-middle.x / middle.w, y};
    planes[i] = construction::picture_plane(
        view.projection, view::world_to_page(view, view::make_paper_map(view, scale, shifts[i])), scale);
  }
  sheet::Rectangle ink{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const std::size_t i : {0, 1})
    ink = sheet::united(ink, {shifts[i] + scale * boxes[i].min, shifts[i] + scale * boxes[i].max});
  const std::array descriptions{&views.descriptions[places[0]], &views.descriptions[places[1]]};
  const construction::Figure figure =
      figure_of_epura(world, descriptions, {planes[1], planes[0], 0, {ink.min.x, ink.max.x}});
  const sheet::Rectangle whole = sheet::box_of(figure, ink, 2 * usual_size);
  for (const std::size_t i : {0, 1}) {
    const sheet::Rectangle own{(whole.min - shifts[i]) / scale, (whole.max - shifts[i]) / scale};
    boxes[i].min = {own.min.x, i == 0 ? boxes[i].min.y : own.min.y};
    boxes[i].max = {own.max.x, i == 0 ? own.max.y : boxes[i].max.y};
  }
  return boxes;
}

// Without other requests, all corners are named, if there are not too many.
construction::Figure figure_of_epura(const world::World& world, std::span<const scene::ViewDescription* const> views,
                                     const construction::Epura& epura) {
  std::vector<Request> requests;
  bool legend = false;
  for (const scene::ViewDescription* view : views) {
    legend = legend || wants_legend(*view);
    for (Request& request : requests_of(world, *view, Part::epura)) {
      const auto is_same = [&request](const Request& other) { return other.item == request.item; };
      if (std::none_of(requests.begin(), requests.end(), is_same)) requests.push_back(std::move(request));
    }
  }
  const auto is_epura = [](const Request& r) { return scene::row_of(r.item.kind).family != ConstructionFamily::any; };
  if (std::none_of(requests.begin(), requests.end(), is_epura))
    requests.push_back({{ConstructionKind::corners, "corners"}, {}, {}, true});
  construction::Figure figure = construction::epura_figure(epura, requests, models_of(world, requests));
  figure.legend = legend;
  return figure;
}

}  // namespace epura::pipeline
