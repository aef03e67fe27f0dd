// SPDX-License-Identifier: Apache-2.0
#include "view/projected_scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "view/page_height.hpp"

namespace epura::view {

namespace {

// Vertices closer to the viewer than this fraction of the reference distance lose all digits in the division. If
// distances are measured from the centre of projection itself, they keep all, and only still closer vertices have no
// finite image.
constexpr double nearest_w = 0x1p-44, nearest_w_from_centre = 0x1p-100;
// A viewer inside the scene sees everything around; without a window, the view is limited to a cone of 120 degrees.
const double cone_tangent = std::sqrt(3.0);
// Triangles are cut at 1.5 times the window, so that the edges of the cut lie outside the picture.
constexpr double guard = 1.5;
constexpr double grid_half = (1 << 30) - 2;
constexpr double contact_cells = 4;
constexpr double contact_part = 0x1p-29;
constexpr double joined_part = 0x1p-44;

// Adds the plane for `users`, or as an idle plane if it cuts nothing. Returns whether it cuts.
bool add_plane(ProjectedScene& view, const world::World& world, const ClipPlane& plane,
               std::initializer_list<std::vector<int>*> users) {
  const int number = view.clipper.add_plane(plane);
  const auto is_cut = [&](const auto& corners) {
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return !view.clipper.inside(number, v); });
  };
  const bool cuts = std::any_of(world.triangles.begin(), world.triangles.end(), is_cut) ||
                    std::any_of(world.wires.begin(), world.wires.end(), is_cut);
  if (!cuts) view.idle_planes.push_back(number);
  if (cuts)
    for (std::vector<int>* user : users) user->push_back(number);
  return cuts;
}

// sign * n . (x - P) <= sign * limit. The homogeneous 1 is W + depth_to_one Z, and n . (x - c) follows from Z.
ClipPlane depth_plane(const ProjectedScene& view, double limit, double sign) {
  const ViewMap& map = view.map;
  const Vec3 from_point = map.centre * map.normalisation - view.projection.point * map.normalisation;
  const double constant = limit * map.normalisation - glm::dot(view.projection.n, from_point);
  return {0, 0, sign * (constant * map.depth_to_one - 1 / map.depth_of_n), sign * constant};
}

// Returns whether something lies beside or behind the viewer.
bool add_depth_planes(ProjectedScene& view, const world::World& world, const ViewLimits& limits, Clipping clipping) {
  const projection::Projection& p = view.projection;
  const double viewer = p.central ? glm::dot(p.n, p.projector - p.point) : 0;
  double front = p.front;
  double back = p.back;
  if (limits.near) front = std::min(front, viewer - *limits.near);
  if (limits.far) back = std::max(back, viewer - *limits.far);
  if (!(front > back))
    throw Error(ErrorKind::input, "near and far", "leave nothing between them", "near must be less than far");

  const auto users = {&view.triangle_planes, &view.edge_planes};
  bool around = false;
  const double nearest = view.map.w_constant == 0 ? nearest_w_from_centre : nearest_w;
  // In a parallel view W is 1 everywhere.
  if (p.central || clipping == Clipping::everywhere)
    around = add_plane(view, world, {0, 0, -nearest * view.map.depth_to_one, 1 - nearest}, users);
  if (std::isfinite(front)) add_plane(view, world, depth_plane(view, front, 1), users);
  if (std::isfinite(back)) add_plane(view, world, depth_plane(view, back, -1), users);
  return around;
}

// Whether the plane of a triangle passes through the centre of projection, as far as rounding tells.
bool passes_viewer(const ProjectedScene& view, const world::World& world, const std::array<int, 3>& triangle) {
  if (!view.projection.central) return false;
  const Vec3 eye = view.projection.projector;
  double largest = glm::length(eye);
  std::array<Vec3, 3> from{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& corner = world.points[static_cast<std::size_t>(triangle[i])];
    largest = std::max(largest, glm::length(corner));
    from[i] = corner - eye;
  }
  const double a = glm::length(from[0]), b = glm::length(from[1]), c = glm::length(from[2]);
  const double rounding = 0x1p-49 * largest * (a * b + b * c + c * a);
  return std::abs(glm::dot(from[0], glm::cross(from[1], from[2]))) <= rounding;
}

UnsetVector<ViewTriangle> clipped_triangles(ProjectedScene& view, const world::World& world, Clipping clipping) {
  // Idle planes come first: they cut off none of the world's own corners, whereas clipping creates corners that are
  // rounded.
  std::vector<int> planes = clipping == Clipping::everywhere ? view.idle_planes : std::vector<int>();
  planes.insert(planes.end(), view.triangle_planes.begin(), view.triangle_planes.end());
  UnsetVector<ViewTriangle> triangles(planes.empty() ? world.triangles.size() : 0);
  parallel_for(triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) triangles[f] = {world.triangles[f], static_cast<int>(f)};
  });
  if (planes.empty()) return triangles;
  triangles.reserve(world.triangles.size());
  std::vector<std::array<int, 3>> pieces;
  for (std::size_t f = 0; f < world.triangles.size(); ++f) {
    pieces.clear();
    view.clipper.clip_triangle(world.triangles[f], planes, pieces);
    if (pieces.empty()) continue;
    // Where a triangle that is seen edge-on reaches the viewer, rounding decides where its corners are. It hides
    // nothing.
    const bool is_whole = pieces.size() == 1 && pieces.front() == world.triangles[f];
    if (!is_whole && passes_viewer(view, world, world.triangles[f]))
      for (auto& piece : pieces) piece[2] = piece[1];
    for (const auto& piece : pieces) triangles.push_back({piece, static_cast<int>(f)});
  }
  return triangles;
}

// What the planes leave of the wires, as far as planes cut anything yet.
std::vector<std::array<int, 2>> clipped_wires(ProjectedScene& view, const world::World& world) {
  std::vector<std::array<int, 2>> wires;
  for (const auto& [a, b] : world.wires)
    if (const auto part = view.clipper.clip_edge(a, b, view.edge_planes)) wires.push_back(part->vertex);
  return wires;
}

projection::Window box_of(ProjectedScene& view, const world::World& world) {
  const std::vector<std::array<int, 2>> wires = clipped_wires(view, world);
  // Most vertices are corners of several triangles; each is divided once.
  std::vector<char> used(view.clipper.vertices.size(), 0);
  for (const ViewTriangle& triangle : view.triangles)
    for (const int v : triangle.vertex) used[v] = 1;
  for (const auto& wire : wires)
    for (const int v : wire) used[v] = 1;
  projection::Window box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    const Mapped& p = view.clipper.vertices[v];
    const Vec2 place(p.x / p.w, p.y / p.w);
    box.min = glm::min(box.min, place);
    box.max = glm::max(box.max, place);
  }
  return box;
}

projection::Window cone_of_vision(const ProjectedScene& view) {
  const projection::Projection& p = view.projection;
  const Vec3 from_point = p.projector * view.map.normalisation - p.point * view.map.normalisation;
  const double reach = cone_tangent * p.scale * glm::dot(p.n, from_point);
  const Vec2 foot = p.scale * Vec2(glm::dot(p.u, from_point), glm::dot(p.v, from_point)) - view.map.image;
  return {foot - reach, foot + reach};
}

void choose_window(ProjectedScene& view, const world::World& world, bool around, Clipping clipping) {
  if (const auto& given = view.projection.window) {
    const double unit = view.projection.scale * view.map.normalisation;
    view.window = {given->min * unit - view.map.image, given->max * unit - view.map.image};
    view.window_given = true;
    return;
  }
  view.triangles = clipped_triangles(view, world, clipping);
  view.window = box_of(view, world);
  if (!around) return;
  const projection::Window cone = cone_of_vision(view);
  view.window = {glm::max(view.window.min, cone.min), glm::min(view.window.max, cone.max)};
  view.window_given = true;
}

// Adds min.x <= X/W <= max.x, and likewise for Y, as planes.
void add_window_planes(ProjectedScene& view, const world::World& world, const projection::Window& window,
                       std::vector<int>& user) {
  add_plane(view, world, {1, 0, 0, -window.min.x}, {&user});
  add_plane(view, world, {-1, 0, 0, window.max.x}, {&user});
  add_plane(view, world, {0, 1, 0, -window.min.y}, {&user});
  add_plane(view, world, {0, -1, 0, window.max.y}, {&user});
}

void choose_grid(ProjectedScene& view) {
  const Vec2 size = view.window.max - view.window.min;
  view.extent = std::max(size.x, size.y);
  if (!(view.extent > 0)) view.extent = 1;
  const double reach = view.extent * (view.window_given ? guard : 1) / 2;
  view.cell = std::ldexp(1.0, std::ilogb(reach / grid_half) + 1);
  // The middle is a grid point, so that moving the scene by whole cells moves the grid along with it.
  const Vec2 middle = view.window.min * 0.5 + view.window.max * 0.5;
  view.middle = {std::round(middle.x / view.cell) * view.cell, std::round(middle.y / view.cell) * view.cell};
}

std::int32_t to_grid(double cells) {
  return std::abs(cells) <= grid_half ? static_cast<std::int32_t>(std::nearbyint(cells)) : 0;
}

// Adds page vertices for everything that the clipper has created since the last call.
void lay_out(ProjectedScene& view) {
  const std::size_t first = view.vertices.size();
  view.vertices.resize(view.clipper.vertices.size());
  view.grid.resize(view.clipper.vertices.size());
  parallel_for(view.vertices.size() - first, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = first + begin; v < first + end; ++v) {
      const Mapped& p = view.clipper.vertices[v];
      PageVertex page{0, 0, 0, p.w};
      if (p.w > 0) page = {p.x / p.w - view.middle.x, p.y / p.w - view.middle.y, p.z / p.w, p.w};
      view.vertices[v] = page;
      view.grid[v] = {to_grid(page.x / view.cell), to_grid(page.y / view.cell)};
    }
  });
}

Contact contact_of(const world::World& world, const ProjectedScene& view, std::optional<double> given) {
  const double unit = view.map.unit;
  const double rounding = world.rounding * view.map.normalisation;
  const double min = joined_part * view.extent;
  if (given) {
    const double in_space = *given * view.map.normalisation;
    const double touching = std::max(in_space * unit, min);
    return {touching, std::clamp(rounding * unit, min, touching), in_space};
  }
  const Vec3 size = world.box.size() * view.map.normalisation;
  return {std::max(contact_cells * view.cell, rounding * unit), std::max(rounding * unit, min),
          std::max(contact_part * std::max({size.x, size.y, size.z}), rounding)};
}

// What is cut off a triangle seen edge-on has corners between those of the triangle on the page, which the grid rounds
// off its line. It hides nothing, like the whole triangle.
void flatten_pieces_edge_on(ProjectedScene& view, const world::World& world) {
  const double resolution = page_resolution(world, view);
  parallel_for(view.triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ViewTriangle& triangle = view.triangles[i];
      const std::array<int, 3>& whole = world.triangles[static_cast<std::size_t>(triangle.source)];
      if (triangle.vertex != whole && height_on_page(view, whole) <= resolution)
        triangle.vertex[2] = triangle.vertex[1];
    }
  });
}

}  // namespace

ProjectedScene project_scene(const world::World& world, const projection::Projection& projection,
                             const ViewLimits& limits, Clipping clipping) {
  const ViewMap map = make_view_map(projection, world.box);
  UnsetVector<Mapped> mapped(world.points.size());
  parallel_for(world.points.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) mapped[v] = map(world.points[v]);
  });
  return project_scene(world, projection, limits, std::move(mapped), clipping);
}

ProjectedScene project_scene(const world::World& world, const projection::Projection& projection,
                             const ViewLimits& limits, UnsetVector<Mapped> mapped, Clipping clipping) {
  ProjectedScene view;
  view.projection = projection;
  view.map = make_view_map(projection, world.box);
  view.clipper.vertices = std::move(mapped);
  const bool around = add_depth_planes(view, world, limits, clipping);
  choose_window(view, world, around, clipping);
  if (view.window_given) {
    const Vec2 margin = (view.window.max - view.window.min) * ((guard - 1) / 2);
    add_window_planes(view, world, {view.window.min - margin, view.window.max + margin}, view.triangle_planes);
    add_window_planes(view, world, view.window, view.edge_planes);
    view.triangles = clipped_triangles(view, world, clipping);
  }
  if (view.triangles.empty() && clipped_wires(view, world).empty())
    throw Error(ErrorKind::input, "projection '" + projection.name + "'",
                "nothing of the model lies in front of the viewer and inside the window",
                "move the eye or the window, or omit near, far and window");
  choose_grid(view);
  view.contact = contact_of(world, view, limits.contact);
  lay_out(view);
  flatten_pieces_edge_on(view, world);
  return view;
}

int add_point(ProjectedScene& view, const Vec3& point) { return add_mapped_point(view, view.map(point)); }

int add_mapped_point(ProjectedScene& view, const Mapped& mapped) {
  view.clipper.vertices.push_back(mapped);
  lay_out(view);
  return static_cast<int>(view.vertices.size()) - 1;
}

std::optional<ClippedEdge> clip_edge(ProjectedScene& view, int a, int b) {
  if (view.edge_planes.empty()) return ClippedEdge{{a, b}, {0, 1}};
  auto edge = view.clipper.clip_edge(a, b, view.edge_planes);
  lay_out(view);
  return edge;
}

std::vector<int> clip_ring(ProjectedScene& view, const std::vector<int>& ring) {
  if (view.edge_planes.empty()) return ring;
  std::vector<int> clipped = view.clipper.clip_ring(ring, view.edge_planes);
  lay_out(view);
  return clipped;
}

}  // namespace epura::view
