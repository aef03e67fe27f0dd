// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_world.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "cut/cut_bodies.hpp"
#include "cut/cut_doubts.hpp"
#include "cut/cut_gaps.hpp"
#include "cut/cut_mesh.hpp"
#include "cut/cut_outline.hpp"
#include "cut/cut_region.hpp"
#include "cut/limits.hpp"
#include "cut/split_world.hpp"
#include "cut/true_outline.hpp"
#include "mesh/edge_table.hpp"
#include "world/placed_part.hpp"

namespace epura::cut {

namespace {

/// A region of a split world, in which a cut ends.
struct RegionOfCut {
  const SplitWorld& split;
  const CutRegion& region;
  int number;

  [[nodiscard]] bool has_triangle(int triangle) const { return split.region_of_triangle[triangle] == number; }
  [[nodiscard]] bool has_point(const Vec3& point) const {
    return std::all_of(region.borders.begin(), region.borders.end(),
                       [&](const CutBorder& border) { return side_of(border, point, split.slack) <= 0; });
  }
};

/// The cut of one model, by one plane or in one region of a surface; then all of them together.
struct ModelCut {
  const world::World& world;
  int model;
  const PlaneFrame& frame;
  CutMesh cut;
  const RegionOfCut* region = nullptr;
  std::size_t of_surface = 0;  ///< number of triangles before those of cut faces
  std::vector<WorldCutFace> faces{};
  std::vector<CutSegment> loose{};  ///< of outlines that are open, or that bound no certain area
  std::vector<OpenOutline> open{};
  std::vector<BridgedGaps> bridged{};
  double moved = 0;  ///< largest distance at which vertices were moved to surfaces

  [[nodiscard]] const mesh::Mesh& mesh() const { return *world.models[model].mesh; }
  [[nodiscard]] int file_vertices() const { return world.first_vertex[model + 1] - world.first_vertex[model]; }
  [[nodiscard]] CutPlaces places() const {
    const auto first = static_cast<std::size_t>(world.first_vertex[model]);
    return {{world.points.data() + first, static_cast<std::size_t>(file_vertices())}, cut.points};
  }

  void close();
  [[nodiscard]] GapLimits gap_limits() const;
  void tell_outlines_apart();
  void say_bridged(int body, const std::vector<Bridge>& bridges);
  void leave_out_doubtful();
  void take_faces_in_plane(const std::vector<int>& material, const std::vector<char>& is_open);
  void keep_triangle(int triangle, int body, std::vector<CutSegment>& segments);
  void add_face(int body, std::span<const CutSegment> segments);
  void keep_region();
  void clip_outlines_to_region();
  void append(ModelCut&& other);
  void drop_surface();
  [[nodiscard]] mesh::Mesh make_mesh() const;
};

void ModelCut::close() {
  const std::vector<char> is_open = open_bodies(mesh());
  moved = move_to_surfaces(cut, world, model, frame);
  keep_odd(cut.segments);
  tell_outlines_apart();
  const std::vector<int> material = material_of({world, model, cut, places(), frame}, is_open);
  for (CutSegment& segment : cut.segments) segment.body = material[segment.body];
  for (CutSegment& segment : loose) segment.body = material[segment.body];
  keep_odd(cut.segments);
  keep_odd(loose);
  leave_out_doubtful();
  take_faces_in_plane(material, is_open);
  keep_odd(cut.segments);
  if (region != nullptr) keep_region();
  of_surface = cut.triangles.size();
  if (region != nullptr) return clip_outlines_to_region();
  visit_bodies(cut.segments, [&](int body, std::span<const CutSegment> segments) { add_face(body, segments); });
}

GapLimits ModelCut::gap_limits() const {
  const world::Placed& placed = world.models[model];
  const Mat3 turn(placed.to_world);
  const double shortest = std::min({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
  const bool has_faces = placed.part != nullptr && !placed.part->faces.empty();
  const auto sagitta = [part = placed.part, scale = shortest * frame.normalisation,
                        faces = has_faces ? world::faces_of_triangles(placed) : std::vector<int>()](int triangle) {
    const int face = faces.empty() ? -1 : faces[triangle];
    return face < 0 ? std::nullopt : std::optional(part->faces[face].sagitta * scale);
  };
  return {world.rounding * frame.normalisation, sagitta};
}

void ModelCut::tell_outlines_apart() {
  const GapLimits limits = gap_limits();
  const double nothing = std::max(limits.rounding, rounding_part);
  std::vector<CutSegment> closed;
  visit_bodies(cut.segments, [&](int body, std::span<const CutSegment> segments) {
    ToldApart apart = tell_apart(segments, places(), frame, limits);
    std::erase_if(apart.bridges, [&](const Bridge& bridge) { return bridge.width <= nothing; });
    closed.insert(closed.end(), apart.closed.begin(), apart.closed.end());
    loose.insert(loose.end(), apart.loose.begin(), apart.loose.end());
    if (!apart.bridges.empty()) say_bridged(body, apart.bridges);
    if (!apart.ends.empty()) open.push_back({model, body, places()[apart.ends.front()]});
  });
  cut.segments = std::move(closed);
}

void ModelCut::say_bridged(int body, const std::vector<Bridge>& bridges) {
  const Bridge& widest = *std::max_element(bridges.begin(), bridges.end(),
                                           [](const Bridge& a, const Bridge& b) { return a.width < b.width; });
  const auto& [a, b] = widest.vertex;
  bridged.push_back({model, body, static_cast<int>(bridges.size()), widest.width / frame.normalisation,
                     places()[a] * 0.5 + places()[b] * 0.5});
}

void ModelCut::leave_out_doubtful() {
  const std::vector<char> doubted = doubtful(cut.segments, loose, places(), frame);
  std::vector<CutSegment> certain;
  for (std::size_t s = 0; s < doubted.size(); ++s) (doubted[s] != 0 ? loose : certain).push_back(cut.segments[s]);
  cut.segments = std::move(certain);
}

// Faces in the plane are kept if there is material behind them. If this is unknown, all are kept.
void ModelCut::take_faces_in_plane(const std::vector<int>& material, const std::vector<char>& is_open) {
  std::vector<std::vector<int>> by_body(material.size());
  for (const int t : cut.in_plane) by_body[material[mesh().body[t]]].push_back(t);
  std::vector<char> unknown(material.size(), 0);
  for (std::size_t b = 0; b < material.size(); ++b)
    if (is_open[b] != 0) unknown[material[b]] = 1;
  for (const CutSegment& segment : loose) unknown[segment.body] = 1;
  std::vector<CutSegment> sides;
  for (int body = 0; body < static_cast<int>(by_body.size()); ++body) {
    std::vector<std::array<int, 3>> triangles;
    for (const int t : by_body[body]) triangles.push_back(mesh().triangle(t));
    if (triangles.empty()) continue;
    const auto before = [](const CutSegment& segment, int number) { return segment.body < number; };
    const auto first = std::lower_bound(cut.segments.begin(), cut.segments.end(), body, before);
    const auto last = std::lower_bound(first, cut.segments.end(), body + 1, before);
    const std::vector<bool> inside = lie_inside(triangles, {first, last}, places(), frame);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (inside[i])
        keep_triangle(by_body[body][i], body, sides);
      else if (unknown[body] != 0)
        keep_triangle(by_body[body][i], body, loose);
    }
  }
  cut.segments.insert(cut.segments.end(), sides.begin(), sides.end());
  keep_odd(loose);
}

void ModelCut::keep_triangle(int triangle, int body, std::vector<CutSegment>& segments) {
  const std::array<int, 3> corners = mesh().triangle(triangle);
  cut.triangles.push_back(corners);
  cut.polygon.push_back(mesh().polygon[triangle]);
  cut.body.push_back(mesh().body[triangle]);
  cut.source.push_back(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
    segments.push_back({body, {low, high}});
  }
}

void ModelCut::add_face(int body, std::span<const CutSegment> segments) {
  faces.push_back({model, body, rings_of(segments)});
  FlatOutlines flat = flatten(segments, places(), frame);
  const std::vector<std::array<int, 3>> triangles = mesh::fill_even_odd(flat.outlines);
  for (std::size_t i = flat.vertices.size(); i < flat.outlines.places.size(); ++i) {
    flat.vertices.push_back(file_vertices() + static_cast<int>(cut.points.size()));
    cut.points.push_back(frame.in_space(flat.outlines.places[i]));
    cut.vertices.push_back({{-1, -1}, 0});
  }
  const auto& polygons = mesh().polygon;
  const int face = *std::max_element(polygons.begin(), polygons.end()) + static_cast<int>(faces.size());
  for (const auto& [a, b, c] : triangles) {
    cut.triangles.push_back({flat.vertices[a], flat.vertices[b], flat.vertices[c]});
    cut.polygon.push_back(face);
    cut.body.push_back(body);
  }
}

// Also omits what is open or bridged in other regions.
void ModelCut::keep_region() {
  const int first = world.first_triangle[model];
  std::vector<int> numbers(cut.triangles.size(), -1);
  CutMesh kept;
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    if (!region->has_triangle(first + cut.source[t])) continue;
    numbers[t] = static_cast<int>(kept.triangles.size());
    kept.triangles.push_back(cut.triangles[t]);
    kept.polygon.push_back(cut.polygon[t]);
    kept.body.push_back(cut.body[t]);
    kept.source.push_back(cut.source[t]);
  }
  for (const int t : cut.uncut)
    if (numbers[t] >= 0) kept.uncut.push_back(numbers[t]);
  cut.triangles = std::move(kept.triangles);
  cut.polygon = std::move(kept.polygon);
  cut.body = std::move(kept.body);
  cut.source = std::move(kept.source);
  cut.uncut = std::move(kept.uncut);
  const auto middle = [&](const std::array<int, 2>& ends) { return (places()[ends[0]] + places()[ends[1]]) / 2.0; };
  std::erase_if(cut.wires, [&](const auto& wire) { return !region->has_point(middle(wire)); });
  std::erase_if(loose, [&](const CutSegment& segment) { return !region->has_point(middle(segment.vertex)); });
  std::erase_if(open, [&](const OpenOutline& outline) { return !region->has_point(outline.end); });
  std::erase_if(bridged, [&](const BridgedGaps& gaps) { return !region->has_point(gaps.place); });
}

// Faces end at the borders of the region, where no line is drawn.
void ModelCut::clip_outlines_to_region() {
  const std::vector<CutSegment> segments = std::move(cut.segments);
  cut.segments.clear();
  visit_bodies(segments, [&](int body, std::span<const CutSegment> of_body) {
    const RegionOutlines outlines =
        clip_outlines(of_body, region->region.borders, {places().file, cut}, region->split.slack);
    cut.segments.insert(cut.segments.end(), outlines.drawn.begin(), outlines.drawn.end());
    if (!outlines.ends.empty())
      open.push_back({model, body, places()[outlines.ends.front()]});
    else if (!outlines.closed.empty())
      add_face(body, outlines.closed);
  });
}

// The other cut is of another region of the same model.
void ModelCut::append(ModelCut&& other) {
  const int shift = static_cast<int>(cut.points.size()), file = file_vertices();
  const auto renumber = [&](auto& vertices) {
    for (int& v : vertices)
      if (v >= file) v += shift;
  };
  for (auto& triangle : other.cut.triangles) renumber(triangle);
  for (CutSegment& segment : other.cut.segments) renumber(segment.vertex);
  for (CutSegment& segment : other.loose) renumber(segment.vertex);
  for (auto& wire : other.cut.wires) renumber(wire);
  const auto split = static_cast<std::ptrdiff_t>(other.of_surface), here = static_cast<std::ptrdiff_t>(of_surface);
  for (std::size_t t = other.of_surface; t < other.cut.polygon.size(); ++t)
    other.cut.polygon[t] += static_cast<int>(faces.size());
  const auto join = [&](auto& all, auto& more) {
    all.insert(all.begin() + here, more.begin(), more.begin() + split);
    all.insert(all.end(), more.begin() + split, more.end());
  };
  join(cut.triangles, other.cut.triangles);
  join(cut.polygon, other.cut.polygon);
  join(cut.body, other.cut.body);
  const auto add = [](auto& all, auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  for (WorldCutFace& face : other.faces)
    for (auto& ring : face.rings) renumber(ring);
  add(faces, other.faces);
  add(cut.points, other.cut.points);
  add(cut.vertices, other.cut.vertices);
  add(cut.segments, other.cut.segments);
  add(loose, other.loose);
  add(cut.wires, other.cut.wires);
  add(open, other.open);
  add(bridged, other.bridged);
  cut.cuts_wires = cut.cuts_wires || other.cut.cuts_wires;
  of_surface += other.of_surface;
  moved = std::max(moved, other.moved);
}

void ModelCut::drop_surface() {
  const auto drop = [end = static_cast<std::ptrdiff_t>(of_surface)](auto& list) {
    list.erase(list.begin(), list.begin() + end);
  };
  drop(cut.triangles);
  drop(cut.polygon);
  drop(cut.body);
  // The faces need not have all vertices of their outlines.
  cut.wires.clear();
  for (const CutSegment& segment : cut.segments) cut.wires.push_back(segment.vertex);
  cut.uncut.clear();
  loose.clear();
  of_surface = 0;
}

mesh::Mesh ModelCut::make_mesh() const {
  mesh::Mesh cut_away;
  cut_away.points = mesh().points;
  const Mat4 to_file = glm::inverse(world.models[model].to_world);
  for (const Vec3& made : cut.points) {
    const Vec3 p(to_file * Vec4(made, 1));
    cut_away.points.push_back({p.x, p.y, p.z});
  }
  for (const auto& triangle : cut.triangles)
    cut_away.corners.insert(cut_away.corners.end(), triangle.begin(), triangle.end());
  cut_away.polygon = cut.polygon;
  cut_away.body = cut.body;
  cut_away.report = mesh().report;
  const bool is_split = mesh().uncut != nullptr;
  if (is_split) cut_away.cut_vertices = mesh().cut_vertices;
  cut_away.cut_vertices.insert(cut_away.cut_vertices.end(), cut.vertices.begin(), cut.vertices.end());
  cut_away.first_cut_vertex = is_split ? mesh().first_cut_vertex : file_vertices();
  cut_away.uncut = is_split ? mesh().uncut : world.models[model].mesh;
  mesh::make_edges(cut_away, cut.wires);

  std::vector<std::array<int, 2>> outline;
  for (const CutSegment& segment : cut.segments) outline.push_back(segment.vertex);
  for (const CutSegment& segment : loose) outline.push_back(segment.vertex);
  std::sort(outline.begin(), outline.end());
  for (mesh::MeshEdge& edge : cut_away.edges) {
    // Triangles of cut faces are last.
    const bool in_face = edge.count > 0 && cut_away.triangles_of(edge).front() >= static_cast<int>(of_surface);
    if (std::binary_search(outline.begin(), outline.end(), edge.vertex))
      edge.cut = mesh::CutEdge::outline;
    else if (in_face || !cut_away.origin_of(edge).in_file)
      edge.cut = mesh::CutEdge::inside;
  }
  return cut_away;
}

void append(world::World& world, const ModelCut& cut) {
  const int first = world.first_vertex.back();
  const CutPlaces places = cut.places();
  world.points.insert(world.points.end(), places.file.begin(), places.file.end());
  world.points.insert(world.points.end(), places.made.begin(), places.made.end());
  for (std::array<int, 3> corners : cut.cut.triangles) {
    for (int& v : corners) v += first;
    world.triangles.push_back(corners);
  }
  world.first_vertex.push_back(static_cast<int>(world.points.size()));
  world.first_triangle.push_back(static_cast<int>(world.triangles.size()));
  const world::Placed& whole = cut.world.models[cut.model];
  world.models.push_back(
      {std::make_shared<const mesh::Mesh>(cut.make_mesh()), whole.to_world, whole.part, whole.threads, whole.copy_of});
  if (!cut.world.wires.empty()) world::append_wires(world, *world.models.back().mesh, first);
}

[[noreturn]] void refuse(const scene::CuttingPlane& plane, const std::string& what, const Box& box) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                 (corner & 4) != 0 ? box.max.z : box.min.z);
    const double height = glm::dot(plane.normal, p - plane.point);
    least = std::min(least, height);
    most = std::max(most, height);
  }
  throw Error(ErrorKind::input, plane.where, what,
              "along its normal, the models reach from " + format_rounded(least, 6) + " to " + format_rounded(most, 6) +
                  " of its point: move the point or turn the normal");
}

/// Cuts of whole models, added to a world one after the other.
struct Remainder {
  CutWorld result{};
  bool beyond;
  bool cuts = false;

  Remainder(const world::World& world, const CuttingSurface& surface) : beyond(surface.beyond) {
    result.world = world::without_models(world);
    result.uncut.resize(surface.regions.size());
  }

  void add(ModelCut& cut) {
    if (!beyond) cut.drop_surface();
    const int first = result.world.first_vertex.back();
    std::stable_sort(cut.faces.begin(), cut.faces.end(), [](const auto& a, const auto& b) { return a.body < b.body; });
    for (WorldCutFace& face : cut.faces) {
      for (auto& ring : face.rings)
        for (int& v : ring) v += first;
      const bool is_more =
          !result.faces.empty() && result.faces.back().model == face.model && result.faces.back().body == face.body;
      if (is_more)
        std::move(face.rings.begin(), face.rings.end(), std::back_inserter(result.faces.back().rings));
      else
        result.faces.push_back(std::move(face));
    }
    result.open.insert(result.open.end(), cut.open.begin(), cut.open.end());
    result.bridged.insert(result.bridged.end(), cut.bridged.begin(), cut.bridged.end());
    const auto by_body = [](const auto& a, const auto& b) {
      return std::pair(a.model, a.body) < std::pair(b.model, b.body);
    };
    std::stable_sort(result.open.begin(), result.open.end(), by_body);
    std::stable_sort(result.bridged.begin(), result.bridged.end(), by_body);
    result.moved = std::max(result.moved, cut.moved);
    cuts = cuts || !cut.cut.segments.empty() || !cut.loose.empty() || cut.cut.cuts_wires;
    append(result.world, cut);
  }

  CutWorld finish(const scene::CuttingPlane& plane, const Box& box) {
    if (beyond && result.world.triangles.empty() && result.world.wires.empty())
      refuse(plane, "the cutting plane removes everything", box);
    if (!cuts) refuse(plane, "the plane cuts nothing", box);
    return std::move(result);
  }
};

CutWorld cut_by_plane(const world::World& world, const CuttingSurface& surface, const Progress& progress) {
  const scene::CuttingPlane& plane = surface.plane;
  const Sides sides = find_sides(world, plane);
  const PlaneFrame frame(world, plane, sides.normalisation);
  Remainder remainder(world, surface);
  // A plane in the joint of bodies shows those behind it without cutting any.
  remainder.cuts = surface.beyond && std::any_of(sides.of.begin(), sides.of.end(), [](int side) { return side > 0; });
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    ModelCut cut{world, model, frame, cut_mesh(world, model, sides)};
    progress.expect_time();
    cut.close();
    progress.expect_time();
    for (const int triangle : surface.beyond ? cut.cut.uncut : std::vector<int>())
      remainder.result.uncut[0].push_back(remainder.result.world.first_triangle.back() + triangle);
    remainder.add(cut);
  }
  return remainder.finish(plane, world.box);
}

/// A stepped surface and the world split for it. Of its regions, the first `count` are cut, and nothing remains of the
/// others.
class SteppedCut {
 public:
  SteppedCut(const world::World& world, const CuttingSurface& surface, std::size_t count)
      : surface_(surface), split_(split_world(world, surface)) {
    for (std::size_t r = 0; r < count; ++r) {
      // Where everything is kept, a plane in front of everything removes nothing.
      const scene::CuttingPlane plane = surface.regions[r].plane.value_or(in_front_of(world.box));
      sides_.push_back(find_sides(split_.world, plane));
      frames_.emplace_back(split_.world, plane, sides_.back().normalisation);
      regions_.push_back({split_, surface.regions[r], static_cast<int>(r)});
    }
  }

  /// Adds the remainder of a model.
  void cut(int model, Remainder& remainder, const Progress& progress) const {
    const world::World& world = split_.world;
    const int first = world.first_triangle[model], first_vertex = world.first_vertex[model];
    const std::vector<bool> whole = whole_bodies(world, model, [&](int triangle, int vertex) {
      const auto region = static_cast<std::size_t>(split_.region_of_triangle[first + triangle]);
      return region < sides_.size() ? -sides_[region].of[first_vertex + vertex] : 0;
    });
    std::optional<ModelCut> all;
    std::vector<std::vector<int>> uncut;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      progress.expect_time();
      ModelCut cut{world, model, frames_[r], cut_mesh(world, model, sides_[r], whole), &regions_[r]};
      cut.close();
      const int shift = remainder.result.world.first_triangle.back() + static_cast<int>(all ? all->of_surface : 0);
      if (surface_.beyond)
        for (const int triangle : cut.cut.uncut) remainder.result.uncut[r].push_back(shift + triangle);
      if (all)
        all->append(std::move(cut));
      else
        all.emplace(std::move(cut));
    }
    remainder.add(*all);
  }

 private:
  [[nodiscard]] scene::CuttingPlane in_front_of(const Box& box) const {
    scene::CuttingPlane plane = surface_.plane;
    const double reach = glm::length(box.size()) + glm::distance(box.centre(), plane.point);
    plane.point = box.centre() + 2 * reach * plane.normal;
    return plane;
  }

  const CuttingSurface& surface_;
  SplitWorld split_;
  std::vector<Sides> sides_;
  std::vector<PlaneFrame> frames_;
  std::vector<RegionOfCut> regions_;
};

Remainder cut_by_steps(const world::World& world, const CuttingSurface& surface, std::size_t count,
                       const Progress& progress) {
  const SteppedCut stepped(world, surface, count);
  Remainder remainder(world, surface);
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) stepped.cut(model, remainder, progress);
  return remainder;
}

// A surface whose first region is one of an aligned section; the others are what is beside it.
CuttingSurface surface_of(const CuttingSurface& aligned, const CutRegion& region) {
  CuttingSurface surface = plane_surface(*region.plane);
  surface.beyond = aligned.beyond;
  surface.regions = {region};
  for (const CutBorder& border : region.borders)
    surface.regions.push_back({std::nullopt, {{border.point, -border.normal}}});
  return surface;
}

// Whether a plane between two others begins and ends within the models, seen along these axes: it may lie in a hole.
bool is_within(const CutRegion& region, const Box& box) {
  const auto is_inside = [&](const CutBorder& border) {
    const Vec3 axis = glm::cross(region.plane->normal, border.normal);
    double from = -HUGE_VAL, to = HUGE_VAL;  // of the part of a line along the axis that is in the box
    for (int i = 0; i < 3; ++i) {
      const double low = box.min[i] - border.point[i], high = box.max[i] - border.point[i];
      if (axis[i] == 0 && (low > 0 || high < 0)) return false;
      if (axis[i] == 0) continue;
      const auto [begin, end] = std::minmax({low / axis[i], high / axis[i]});
      from = std::max(from, begin);
      to = std::min(to, end);
    }
    return from <= to;
  };
  return region.borders.size() == 2 && std::all_of(region.borders.begin(), region.borders.end(), is_inside);
}

[[noreturn]] void refuse_leg(const CutRegion& region, const world::World& world) {
  const auto range = [&box = world.box](int axis) {
    return format_rounded(box.min[axis], 6) + " to " + format_rounded(box.max[axis], 6);
  };
  const Vec3& from = region.plane->point;
  throw Error(ErrorKind::input, region.plane->where,
              "the plane of the aligned section that begins at " + format_rounded(from.x, 6) + ", " +
                  format_rounded(from.y, 6) + ", " + format_rounded(from.z, 6) + " cuts nothing",
              "the models reach from " + range(0) + " along x, " + range(1) + " along y and " + range(2) +
                  " along z: move the corners of the path");
}

// Appends what remains in a region of an aligned section, turned.
void append_turned(CutWorld& all, CutWorld part, const Mat4& turn, bool is_first) {
  world::World& world = all.world;
  const int first_model = static_cast<int>(world.models.size());
  const int first_vertex = world.first_vertex.back(), first_triangle = world.first_triangle.back();
  const auto shift = [first_vertex](auto& vertices) {
    for (int& v : vertices) v += first_vertex;
  };
  for (Vec3& p : part.world.points) p = Vec3(turn * Vec4(p, 1));
  for (auto& triangle : part.world.triangles) {
    for (const int v : triangle) world.box.add(part.world.points[v]);
    shift(triangle);
  }
  for (auto& wire : part.world.wires) {
    for (const int v : wire) world.box.add(part.world.points[v]);
    shift(wire);
  }
  for (std::size_t m = 0; m < part.world.models.size(); ++m) {
    world::Placed& placed = part.world.models[m];
    placed.to_world = turn * placed.to_world;
    if (!is_first) placed.copy_of = static_cast<int>(m);
    world.models.push_back(std::move(placed));
    world.first_vertex.push_back(first_vertex + part.world.first_vertex[m + 1]);
    world.first_triangle.push_back(first_triangle + part.world.first_triangle[m + 1]);
  }
  for (WorldCutFace& face : part.faces) {
    face.model += first_model;
    for (auto& ring : face.rings) shift(ring);
  }
  for (int& triangle : part.uncut[0]) triangle += first_triangle;
  for (OpenOutline& open : part.open) open.model += first_model;
  for (BridgedGaps& gaps : part.bridged) gaps.model += first_model;
  const auto add = [](auto& list, auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  add(world.points, part.world.points);
  add(world.triangles, part.world.triangles);
  add(world.wires, part.world.wires);
  add(all.faces, part.faces);
  add(all.open, part.open);
  add(all.bridged, part.bridged);
  all.uncut.push_back(std::move(part.uncut[0]));
  all.moved = std::max(all.moved, part.moved);
}

CutWorld cut_aligned(const world::World& world, const CuttingSurface& surface, const Progress& progress) {
  CutWorld all;
  all.world = world::without_models(world);
  for (const CutRegion& region : surface.regions) {
    Remainder remainder = cut_by_steps(world, surface_of(surface, region), 1, progress);
    if (!remainder.cuts && !is_within(region, world.box)) refuse_leg(region, world);
    append_turned(all, std::move(remainder.result), region.turn, all.world.models.empty());
  }
  return all;
}

}  // namespace

CutWorld cut_world(const world::World& world, const CuttingSurface& surface, const Progress& progress) {
  if (surface.aligned) return cut_aligned(world, surface, progress);
  if (surface.is_plane()) return cut_by_plane(world, surface, progress);
  return cut_by_steps(world, surface, surface.regions.size(), progress).finish(surface.plane, world.box);
}

}  // namespace epura::cut
