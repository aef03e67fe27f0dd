// SPDX-License-Identifier: Apache-2.0
#include "verify/surface_sight.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <optional>
#include <span>
#include <utility>

#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "verify/probe_grid.hpp"
#include "verify/ray_hits.hpp"
#include "verify/scan_lines.hpp"

namespace epura::verify {

namespace {

using surfaces::SurfaceKind;

constexpr int rays_of_band = 17;
constexpr std::size_t triangles_at_once = 4096, bands_at_once = 8192;
// Depth jumps between two rays if it changes this many times as much as between neighbouring pairs of rays. Where a
// sphere begins, it changes 2.4 times as much: the first of steps of a square root.
constexpr double jump = 6;
// A face reaches this many times the mean height of its surface over facets beyond them.
constexpr double heights_beyond = 4;
// Least cosine between normal and ray by which differences in depth are enlarged.
constexpr double least_facing = 0.05;
// The part of the depth of the error within which facets on both sides of an edge are met at one place.
constexpr double doubt_of_facets = 1e-3;

struct Hit {
  double depth;  ///< of the page's map
  double doubt;  ///< of the depth
  int face;      ///< of the part; -1 - triangle where none is known
  bool is_free;  ///< of a free form
  int model;
  Vec3 normal;  ///< in the world, unit
};

Vec3 linear_row(const Mat4& m, int i) { return Vec3(glm::row(m, i)); }

double distance_to_triangle(const Vec3& p, const std::array<Vec3, 3>& corner) {
  const auto& [a, b, c] = corner;
  const Vec3 normal = glm::cross(b - a, c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return glm::dot(glm::cross(normal, to - from), p - from) >= 0;
  };
  const double area = glm::length(normal);
  if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(glm::dot(normal, p - a)) / area;
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// Facets near a ray: of one face, or of a model without faces.
struct Group {
  int face;  ///< -1: none is known
  SurfaceKind kind;
};

// Where the rays of a band meet the page.
std::vector<Vec2> places_of(const Band& band) {
  std::vector<Vec2> places;
  for (int k = 0; k < rays_of_band; ++k)
    places.push_back(band.middle + band.half * (2.0 * k / (rays_of_band - 1) - 1) * band.across);
  return places;
}

class RayCaster {
 public:
  RayCaster(const VerifyInput& input, const edges::EdgeOptions& options, double error)
      : input_(input),
        options_(options),
        map_(input.drawing.world_to_page),
        to_world_(glm::inverse(map_)),
        error_(error) {
    Vec4 middle = map_ * Vec4(input.world.box.centre(), 1);
    if (!(middle.w > 0)) middle = map_ * Vec4(input.projection.point, 1);  // the centre is behind the viewer
    depth_ = middle.z / middle.w;
    const Vec3 of_w = linear_row(map_, 3);
    per_length_ = glm::length(linear_row(map_, 0) - middle.x / middle.w * of_w) / std::abs(middle.w);
    depth_per_length_ = glm::length(linear_row(map_, 2) - depth_ * of_w) / std::abs(middle.w);
  }

  /// By band.
  [[nodiscard]] std::vector<std::vector<int>> triangles_near(std::span<const Band> bands,
                                                             const Progress& progress) const;
  [[nodiscard]] SeenAcross look(const Band& band, const std::vector<int>& triangles) const;

 private:
  [[nodiscard]] std::vector<Hit> hits(const Vec2& place, std::vector<int> triangles) const;
  [[nodiscard]] SeenAcross compare(const std::vector<std::vector<Hit>>& rays, double half) const;
  [[nodiscard]] std::optional<Extent> extent_of(int triangle) const;
  [[nodiscard]] std::optional<std::array<Vec3, 3>> on_page(int triangle) const;
  [[nodiscard]] Ray ray_at(const Vec2& place) const;
  [[nodiscard]] int face_of(int model, int triangle) const;
  void meet_facet(const Vec2& place, int triangle, const Group& group, std::vector<Hit>& hits) const;
  [[nodiscard]] double depth_of_error() const { return error_ * depth_per_length_ / per_length_; }
  void meet_face(const Ray& ray, std::span<const int> triangles, int face, std::vector<Hit>& hits) const;
  [[nodiscard]] std::vector<int> changes(const std::vector<std::vector<Hit>>& rays, std::size_t layer) const;
  [[nodiscard]] bool folds(const Hit& a, const Hit& b) const;

  const VerifyInput& input_;
  edges::EdgeOptions options_;
  Mat4 map_, to_world_;
  double error_, depth_, per_length_, depth_per_length_;
};

// Page and depth of the corners; nothing if one is behind the viewer.
std::optional<std::array<Vec3, 3>> RayCaster::on_page(int triangle) const {
  std::array<Vec3, 3> shape;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec4 page = map_ * Vec4(input_.world.points[input_.world.triangles[triangle][i]], 1);
    if (!(page.w > 0)) return std::nullopt;
    shape[i] = Vec3(page) / page.w;
  }
  return shape;
}

Ray RayCaster::ray_at(const Vec2& place) const {
  const Vec4 point = to_world_ * Vec4(place, depth_, 1);
  const Vec3 from = Vec3(point) / point.w;
  const projection::Projection& p = input_.projection;
  return {from, glm::normalize(p.central ? p.projector - from : p.projector)};
}

int RayCaster::face_of(int model, int triangle) const {
  const world::Placed& placed = input_.world.models[static_cast<std::size_t>(model)];
  if (placed.part == nullptr || placed.part->faces.empty() || placed.mesh->uncut != nullptr) return -1;
  return placed.part->face_of_triangle[static_cast<std::size_t>(triangle - input_.world.first_triangle[model])];
}

// On the page, widened by the error.
std::optional<Extent> RayCaster::extent_of(int triangle) const {
  const auto shape = on_page(triangle);
  if (!shape) return std::nullopt;
  Extent box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL), 0, 0};
  for (const Vec3& corner : *shape) {
    box.min = glm::min(box.min, Vec2(corner) - error_);
    box.max = glm::max(box.max, Vec2(corner) + error_);
  }
  return box;
}

std::vector<std::vector<int>> RayCaster::triangles_near(std::span<const Band> bands, const Progress& progress) const {
  std::vector<Extent> extents;
  for (const Band& band : bands) {
    Extent box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL), 0, 0};
    for (const Vec2& place : places_of(band)) {
      box.min = glm::min(box.min, place);
      box.max = glm::max(box.max, place);
    }
    extents.push_back(box);
  }
  const ProbeGrid grid(extents);
  const std::size_t count = input_.world.triangles.size();
  std::vector<std::vector<std::pair<int, int>>> found((count + triangles_at_once - 1) / triangles_at_once);
  parallel_for(found.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      for (std::size_t t = part * triangles_at_once; t < std::min((part + 1) * triangles_at_once, count); ++t) {
        if (const auto box = extent_of(static_cast<int>(t)))
          grid.overlapping(*box, [&](int band) { found[part].emplace_back(band, static_cast<int>(t)); });
      }
  });
  std::vector<std::vector<int>> near(bands.size());
  for (const auto& part : found)
    for (const auto& [band, triangle] : part) near[static_cast<std::size_t>(band)].push_back(triangle);
  return near;
}

void RayCaster::meet_facet(const Vec2& place, int triangle, const Group& group, std::vector<Hit>& hits) const {
  const auto shape = on_page(triangle);
  if (!shape) return;
  const auto& [a, b, c] = *shape;
  const double area = cross(Vec2(b - a), Vec2(c - a));
  const double of_b = cross(place - Vec2(a), Vec2(c - a)) / area, of_c = cross(Vec2(b - a), place - Vec2(a)) / area;
  if (!(of_b >= 0 && of_c >= 0 && of_b + of_c <= 1)) return;
  const auto& corner = input_.world.triangles[triangle];
  const auto& points = input_.world.points;
  const Vec3 normal = glm::cross(points[corner[1]] - points[corner[0]], points[corner[2]] - points[corner[0]]);
  hits.push_back({a.z + of_b * (b.z - a.z) + of_c * (c.z - a.z), doubt_of_facets * depth_of_error(),
                  group.face < 0 ? -1 - triangle : group.face, group.face >= 0 && group.kind == SurfaceKind::free_form,
                  input_.world.model_of_triangle(triangle), glm::normalize(normal)});
}

// Triangles of one face with a closed form.
void RayCaster::meet_face(const Ray& ray, std::span<const int> triangles, int face, std::vector<Hit>& hits) const {
  const int model = input_.world.model_of_triangle(triangles[0]);
  const world::Placed& placed = input_.world.models[static_cast<std::size_t>(model)];
  const surfaces::PartFace& part = placed.part->faces[static_cast<std::size_t>(face)];
  const Mat4 to_file = glm::inverse(placed.to_world);
  const Vec3 along = Mat3(to_file) * ray.along;
  const double scale = glm::length(along);
  const Ray in_file{Vec3(to_file * Vec4(ray.from, 1)), along / scale};
  const double beyond = heights_beyond * part.sagitta + part.residual + placed.part->tolerance;
  const Mat3 normals = glm::transpose(Mat3(to_file));
  for (const double at : ray_hits(part.surface, in_file)) {
    const Vec3 point = in_file.from + at * in_file.along, in_world = ray.from + at / scale * ray.along;
    double nearest = HUGE_VAL;
    for (const int t : triangles) {
      const auto& [a, b, c] = input_.world.triangles[t];
      const auto& points = input_.world.points;
      nearest = std::min(nearest, distance_to_triangle(in_world, {points[a], points[b], points[c]}));
    }
    if (!(nearest * scale <= beyond + error_ / per_length_ * scale)) continue;
    const Vec4 page = map_ * Vec4(in_world, 1);
    const Vec3 normal = glm::normalize(normals * normal_on(part.surface, point));
    const double facing = std::max(least_facing, std::abs(glm::dot(normal, ray.along)));
    hits.push_back({page.z / page.w, beyond / scale * depth_per_length_ / facing, face, false, model, normal});
  }
}

std::vector<Hit> RayCaster::hits(const Vec2& place, std::vector<int> triangles) const {
  const auto key = [&](int t) {
    const int model = input_.world.model_of_triangle(t);
    return std::pair(model, face_of(model, t));
  };
  std::ranges::stable_sort(triangles, {}, key);
  std::vector<Hit> hits;
  const Ray ray = ray_at(place);
  for (std::size_t i = 0; i < triangles.size();) {
    const auto [model, face] = key(triangles[i]);
    std::size_t end = i;
    while (end < triangles.size() && key(triangles[end]) == std::pair(model, face)) ++end;
    const std::span<const int> group{triangles.data() + i, end - i};
    const Group of{face, face < 0
                             ? SurfaceKind::free_form
                             : input_.world.models[static_cast<std::size_t>(model)].part->faces[face].surface.kind};
    if (of.kind != SurfaceKind::free_form && of.kind != SurfaceKind::plane)
      meet_face(ray, group, face, hits);
    else
      for (const int t : group) meet_facet(place, t, of, hits);
    i = end;
  }
  std::ranges::stable_sort(hits, std::greater{}, &Hit::depth);
  // Neighbouring faces overlap a little, and facets of a free form fold where their surface does not.
  std::vector<Hit> apart;
  const auto is_known = [&](const Hit& hit) {
    return (!apart.empty() && apart.back().depth - hit.depth <= apart.back().doubt + hit.doubt) ||
           (hit.is_free && std::ranges::any_of(apart, [&](const Hit& other) {
              return other.face == hit.face && other.model == hit.model;
            }));
  };
  for (const Hit& hit : hits)
    if (!is_known(hit)) apart.push_back(hit);
  return apart;
}

bool RayCaster::folds(const Hit& a, const Hit& b) const {
  if (a.model != b.model) return true;
  if (a.face == b.face) return false;
  const double angle = angle_between_planes(a.normal, b.normal);
  // Between faces that were merely recognised, only facets know of a smaller fold (PartEyes).
  const world::Placed& placed = input_.world.models[static_cast<std::size_t>(a.model)];
  const bool is_declared = a.face >= 0 && b.face >= 0 && placed.part->declared;
  return angle > (is_declared ? options_.part_angle : options_.crease_angle);
}

// The rays after which this layer changes.
std::vector<int> RayCaster::changes(const std::vector<std::vector<Hit>>& rays, std::size_t layer) const {
  std::vector<int> list;
  std::vector<double> steps;
  double doubt = 0;
  for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
    const bool is_there = rays[i].size() > layer, goes_on = rays[i + 1].size() > layer;
    steps.push_back(0);
    if (is_there != goes_on) list.push_back(static_cast<int>(i));
    if (!is_there || !goes_on) continue;
    const Hit &a = rays[i][layer], &b = rays[i + 1][layer];
    if (folds(a, b)) list.push_back(static_cast<int>(i));
    steps.back() = std::abs(a.depth - b.depth);
    doubt = std::max({doubt, a.doubt, b.doubt});
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double before = i > 0 ? steps[i - 1] : 0, after = i + 1 < steps.size() ? steps[i + 1] : 0;
    if (steps[i] > jump * std::max(before, after) + 2 * doubt + depth_of_error()) list.push_back(static_cast<int>(i));
  }
  return list;
}

SeenAcross RayCaster::compare(const std::vector<std::vector<Hit>>& rays, double half) const {
  std::size_t most = 0;
  for (const auto& hits : rays) most = std::max(most, hits.size());
  SeenAcross seen;
  double nearest = HUGE_VAL;
  for (const int ray : changes(rays, 0)) {
    const double at = half * ((2.0 * ray + 1) / (rays_of_band - 1) - 1);
    if (std::abs(at) < nearest) seen.at = at;
    nearest = std::min(nearest, std::abs(at));
  }
  seen.front_changes = nearest < HUGE_VAL;
  seen.any_changes = seen.front_changes;
  for (std::size_t layer = 1; layer < most && !seen.any_changes; ++layer)
    seen.any_changes = !changes(rays, layer).empty();
  return seen;
}

SeenAcross RayCaster::look(const Band& band, const std::vector<int>& triangles) const {
  std::vector<Extent> extents;
  for (const int t : triangles) extents.push_back(extent_of(t).value_or(Extent{}));
  std::vector<std::vector<Hit>> rays;
  for (const Vec2& place : places_of(band)) {
    std::vector<int> near;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Vec2 &min = extents[i].min, &max = extents[i].max;
      if (min.x <= place.x && place.x <= max.x && min.y <= place.y && place.y <= max.y) near.push_back(triangles[i]);
    }
    rays.push_back(hits(place, std::move(near)));
  }
  return compare(rays, band.half);
}

}  // namespace

std::vector<SeenAcross> see_across(const VerifyInput& input, const edges::EdgeOptions& options, double error,
                                   const std::vector<Band>& bands, const Progress& progress) {
  const RayCaster caster(input, options, error);
  std::vector<SeenAcross> seen(bands.size());
  for (std::size_t from = 0; from < bands.size(); from += bands_at_once) {
    const std::span<const Band> some{bands.data() + from, std::min(bands_at_once, bands.size() - from)};
    const std::vector<std::vector<int>> near = caster.triangles_near(some, progress);
    parallel_for(some.size(), 1, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) seen[from + i] = caster.look(some[i], near[i]);
    });
  }
  return seen;
}

}  // namespace epura::verify
