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
#include "cut/cut_mesh.hpp"
#include "cut/cut_overlaps.hpp"
#include "cut/model_cut.hpp"
#include "cut/split_world.hpp"

namespace epura::cut {

namespace {

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
  std::vector<ModelCut> cuts;
  // A plane in the joint of bodies shows those behind it without cutting any.
  remainder.cuts = surface.beyond && std::any_of(sides.of.begin(), sides.of.end(), [](int side) { return side > 0; });
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    cuts.push_back({world, model, frame, cut_mesh(world, model, sides)});
    progress.expect_time();
    cuts.back().close();
  }
  remainder.result.overlaps = settle_overlaps(cuts, progress);
  for (ModelCut& cut : cuts) {
    progress.expect_time();
    cut.finish();
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

  /// Adds the remainders of all models.
  void cut(Remainder& remainder, const Progress& progress) const {
    std::vector<std::vector<ModelCut>> cuts(regions_.size());
    for (int model = 0; model < static_cast<int>(split_.world.models.size()); ++model)
      cut_regions(model, cuts, progress);
    for (std::vector<ModelCut>& region : cuts) {
      const std::vector<OverlappingBodies> overlaps = settle_overlaps(region, progress);
      remainder.result.overlaps.insert(remainder.result.overlaps.end(), overlaps.begin(), overlaps.end());
    }
    for (std::size_t model = 0; model < split_.world.models.size(); ++model) join_regions(model, cuts, remainder);
  }

 private:
  // The cuts of a model, by region.
  void cut_regions(int model, std::vector<std::vector<ModelCut>>& cuts, const Progress& progress) const {
    const world::World& world = split_.world;
    const int first = world.first_triangle[model], first_vertex = world.first_vertex[model];
    const std::vector<bool> whole = whole_bodies(world, model, [&](int triangle, int vertex) {
      const auto region = static_cast<std::size_t>(split_.region_of_triangle[first + triangle]);
      return region < sides_.size() ? -sides_[region].of[first_vertex + vertex] : 0;
    });
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      progress.expect_time();
      cuts[r].push_back({world, model, frames_[r], cut_mesh(world, model, sides_[r], whole), &regions_[r]});
      cuts[r].back().close();
    }
  }

  void join_regions(std::size_t model, std::vector<std::vector<ModelCut>>& cuts, Remainder& remainder) const {
    std::optional<ModelCut> all;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      ModelCut& cut = cuts[r][model];
      cut.finish();
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
  stepped.cut(remainder, progress);
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
  for (OverlappingBodies& overlap : part.overlaps) {
    overlap.model += first_model;
    overlap.under_model += first_model;
  }
  const auto add = [](auto& list, auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  add(world.points, part.world.points);
  add(world.triangles, part.world.triangles);
  add(world.wires, part.world.wires);
  add(all.faces, part.faces);
  add(all.open, part.open);
  add(all.bridged, part.bridged);
  add(all.overlaps, part.overlaps);
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
