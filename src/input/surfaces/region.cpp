// SPDX-License-Identifier: Apache-2.0
#include "surfaces/region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "surfaces/estimates.hpp"
#include "surfaces/least_squares.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

double angle_of_cosine(double cosine) { return std::sqrt(std::max(0.0, 2 * (1 - cosine))); }

}  // namespace

double allowance_of(const Facets& facets, double sagitta) {
  return std::clamp(sagitta / 64, usual_slack * facets.tolerance, max_allowance * facets.tolerance);
}

double trimmed_allowance_of(const Facets& facets, double sagitta) {
  return std::min(sagitta / 8, max_trimmed * facets.tolerance);
}

namespace {

// The angle of a point around the axis of a surface, or around the tube of a torus, from 0 to a full turn.
double angle_of(const PartSurface& surface, const Vec3& point, bool around_tube) {
  const Vec3 from = point - surface.origin;
  const auto across = square_to(surface.axis);
  const double x = glm::dot(from, across[0]), y = glm::dot(from, across[1]);
  const double angle = around_tube ? portable_atan2(glm::dot(from, surface.axis), std::hypot(x, y) - surface.radius)
                                   : portable_atan2(y, x);
  return angle < 0 ? angle + full_turn : angle;
}

// Whether the allowance leaves open how the surface faces at a vertex: that close to the apex of a cone.
bool is_at_apex(const PartSurface& surface, const Vec3& point, double allowance) {
  return surface.kind == SurfaceKind::cone &&
         glm::length(glm::cross(surface.axis, point - surface.origin)) <= still_open * allowance;
}

// Returns the normal near a vertex; zero where it is open.
Vec3 normal_at_vertex(const PartSurface& surface, const Vec3& point, double allowance) {
  return is_at_apex(surface, point, allowance) ? Vec3(0) : normal_near(surface, point);
}

/// Whether a facet is too thin for its normal to mean anything: narrower than the arcs that the tessellation leaves
/// out. A greater sagitta than that of a coarse tessellation does not count.
bool has_no_say(const Facets& facets, int facet, const PartSurface& surface, double sagitta) {
  const double min_radius = surface.kind == SurfaceKind::torus ? surface.minor : surface.radius;
  return facets.is_sliver(facet) ||
         facets.facets[facet].width <= 2 * std::min(sagitta, max_relative_sagitta * min_radius);
}

// How far below a round surface the middle of a facet is at most that has its vertices on it, and faces as it does
// there within 60 degrees. Those of a bore may all be on the shaft that it crosses: its walls lie deeper.
double deepest(const Facets& facets, int facet, const PartSurface& surface) {
  double radius = surface.kind == SurfaceKind::sphere ? surface.radius : surface.minor;
  for (const int v : facets.supports_of(facet))
    radius = std::max(radius, glm::length(glm::cross(facets.points[v] - surface.origin, surface.axis)));
  return (1 - min_facing) * radius;
}

}  // namespace

bool approximates(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta) {
  const Facet& f = facets.facets[facet];
  bool faces_away = false;
  for (const int v : facets.supports_of(facet)) {
    const Nearness near = nearness_of(surface, facets.points[v]);
    if (!(std::abs(near.distance) <= allowance)) return false;
    faces_away = faces_away || (near.normal != Vec3(0) && std::abs(glm::dot(near.normal, f.normal)) < min_agreement &&
                                !is_at_apex(surface, facets.points[v], allowance));
  }
  const auto is_within = [&](double depth) {
    return std::abs(signed_distance(surface, f.middle)) <= depth + allowance;
  };
  if (has_no_say(facets, facet, surface, sagitta)) return is_within(deepest(facets, facet, surface));
  return !faces_away && (sagitta == 0 || is_within(max_sagittas * sagitta));
}

bool is_chord(const Facets& facets, int facet, const PartSurface& surface, double allowance, double sagitta) {
  const auto is_near = [&](const Vec3& p, double distance) {
    return std::abs(signed_distance(surface, p)) <= distance;
  };
  for (const int v : facets.supports_of(facet))
    if (!is_near(facets.points[v], allowance)) return false;
  const Facet& f = facets.facets[facet];
  const auto facing = [&](const Vec3& p) { return std::abs(glm::dot(normal_near(surface, p), f.normal)); };
  // A facet that does not tilt, but spans a large angle, is a flat of the part.
  if (facing(f.middle) > tilted_facing)
    for (const int v : facets.supports_of(facet)) {
      const Vec3 normal = normal_at_vertex(surface, facets.points[v], allowance);
      if (normal != Vec3(0) && std::abs(glm::dot(normal, f.normal)) < min_agreement) return false;
    }
  const double most = std::min(max_sagittas * sagitta, deepest(facets, facet, surface)) + allowance;
  for (const int t : facets.triangles_of(facet)) {
    const auto& [a, b, c] = facets.corners[t];
    const Vec3 middle = (facets.points[a] + facets.points[b] + facets.points[c]) / 3.0;
    if (!is_near(middle, most)) return false;
    if (facing(middle) < min_facing && !facets.is_sliver(facet)) return false;
    for (int side = 0; side < 3; ++side) {
      const std::array<Vec3, 2> ends = facets.ends_of(t, side);
      if (!is_near((ends[0] + ends[1]) / 2.0, most)) return false;
    }
  }
  return true;
}

// That of a surface of revolution at its origin; for cones whose origin is near the apex, as files may declare it, the
// largest one at the points.
double radius_near(const PartSurface& s, std::span<const Vec3> points) {
  if (s.kind != SurfaceKind::cone) return s.radius;
  double widest = 0;
  for (const Vec3& p : points) widest = std::max(widest, glm::length(glm::cross(p - s.origin, s.axis)));
  return s.radius < widest / 4 ? widest : s.radius;
}

Places places_of(const PartSurface& s, std::span<const Vec3> points, bool around_tube, double allowance) {
  const double at_origin = radius_near(s, points), radius = around_tube ? s.minor : at_origin;
  const double same = std::max(1e-5, 16 * allowance / radius);
  std::vector<double> angles(points.size());
  parallel_for(points.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // A point on the axis has no angle: it comes last.
      const Vec3 from = points[i] - s.origin;
      const bool is_off = glm::length(from - glm::dot(from, s.axis) * s.axis) > 1e-3 * at_origin;
      angles[i] = is_off ? angle_of(s, points[i], around_tube) : HUGE_VAL;
    }
  });
  parallel_sort(angles.begin(), angles.end());
  while (!angles.empty() && angles.back() == HUGE_VAL) angles.pop_back();
  if (angles.empty()) return {};
  std::vector<double> places{angles.front()};
  for (const double a : angles)
    if (a > places.back() + same) places.push_back(a);
  if (places.size() > 1 && places.front() + full_turn - places.back() <= same) places.pop_back();
  double gap = places.front() + full_turn - places.back();
  double from = places.front();
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] - places[i - 1] > gap) {
      gap = places[i] - places[i - 1];
      from = places[i];
    }
  const auto count = static_cast<int>(places.size());
  const bool closed = gap < widest_chord * degree && gap <= 4 * full_turn / count;
  double step = closed ? gap : 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] != from) step = std::max(step, places[i] - places[i - 1]);
  return {count, from, closed ? full_turn : full_turn - gap, step, closed};
}

Reach reach_of(const PartSurface& surface, std::span<const Vec3> points, double allowance) {
  Reach reach;
  for (const Vec3& p : points) {
    const double height = glm::dot(p - surface.origin, surface.axis);
    reach.from = std::min(reach.from, height);
    reach.to = std::max(reach.to, height);
  }
  const Places places = places_of(surface, points, false, allowance);
  reach.sweep = places.closed ? 360 : places.sweep * degrees;
  reach.middle = places.from + (places.sweep + full_turn) / 2;
  return reach;
}

bool passes_over(const PartSurface& surface, const std::array<Vec3, 3>& triangle, double angle) {
  const auto across = square_to(surface.axis);
  const double x = portable_cos(angle), y = portable_sin(angle);
  const Vec3 out = x * across[0] + y * across[1], aside = x * across[1] - y * across[0];
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& corner : triangle) {
    if (!(glm::dot(corner - surface.origin, out) > 0)) return false;
    low = std::min(low, glm::dot(corner - surface.origin, aside));
    high = std::max(high, glm::dot(corner - surface.origin, aside));
  }
  return low < 0 && high > 0;
}

RegionGrower::RegionGrower(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions)
    : facets_(facets),
      region_of_(region_of),
      regions_(regions),
      stamp_(facets.facets.size(), 0),
      vertex_stamp_(facets.points.size(), 0) {}

bool RegionGrower::may_cross(int triangle, int side) const {
  const int other = facets_.facet_of[facets_.sides[triangle][side].neighbour];
  if (region_of_[other] >= 0) return false;
  return facets_.is_sliver(other) || facets_.is_sliver(facets_.facet_of[triangle]) ||
         facets_.cosine_of_fold(triangle, side) > min_fold_cosine;
}

void RegionGrower::add(Region& region, int facet) {
  stamp_[facet] = number_;
  region.facets.push_back(facet);
  sagittas_ += std::abs(signed_distance(region.surface, facets_.facets[facet].middle));
  region.sagitta = sagittas_ / static_cast<double>(region.facets.size());
}

std::vector<Vec3> RegionGrower::points_of(const Region& region, std::size_t most) {
  ++vertex_number_;
  std::vector<Vec3> points;
  for (const int f : region.facets)
    for (const int v : facets_.supports_of(f))
      if (std::exchange(vertex_stamp_[v], vertex_number_) != vertex_number_) points.push_back(facets_.points[v]);
  if (points.size() <= most) return points;
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * points.size() / most]);
  return some;
}

// Vertices that lie off the surface, such as those on the border to an inexact blend, must not bend it: it is fitted to
// the other vertices once they are known.
bool RegionGrower::fit_again(Region& region) {
  const std::vector<Vec3> points = points_of(region, max_fitted);
  region.residual = refine(region.surface, points);
  const double most = (region.surface.kind == SurfaceKind::torus ? 2 : 4) * facets_.tolerance;
  if (region.residual > most && region.residual < HUGE_VAL) {
    std::vector<double> distances;
    for (const Vec3& p : points) distances.push_back(std::abs(signed_distance(region.surface, p)));
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::vector<double> sorted = distances;
    std::nth_element(sorted.begin(), sorted.begin() + (middle - distances.begin()), sorted.end());
    const double near =
        std::max(2 * facets_.tolerance, 1.5 * sorted[static_cast<std::size_t>(middle - distances.begin())]);
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (distances[i] <= near) kept.push_back(points[i]);
    PartSurface other = region.surface;
    if (static_cast<int>(kept.size()) > 2 * unknowns_of(other.kind) && refine(other, kept) < near) {
      region.surface = other;
      region.residual = residual_of(other, points);
    }
  }
  sagittas_ = 0;
  for (const int f : region.facets) sagittas_ += std::abs(signed_distance(region.surface, facets_.facets[f].middle));
  region.sagitta = sagittas_ / static_cast<double>(region.facets.size());
  return region.residual <= allowance_of(facets_, region.sagitta);
}

// Adds neighbours until no more of them lie on the surface, and fits it again whenever the region has grown enough.
// Returns whether anything was added.
bool RegionGrower::spread(Region& region) {
  const std::size_t before = region.facets.size();
  std::size_t fitted = before;
  for (std::size_t next = 0; next < region.facets.size(); ++next) {
    facets_.for_sides(region.facets[next], [&](int t, int side, int facet) {
      if (stamp_[facet] == number_ || !may_cross(t, side)) return;
      // A fit to few facets is less certain for adjacent facets than for its own.
      const double allowance = allowance_of(facets_, region.sagitta) * (region.facets.size() < 12 ? 8 : 2);
      if (approximates(facets_, facet, region.surface, allowance, region.sagitta)) add(region, facet);
    });
    if (region.facets.size() < 3 * fitted) continue;
    if (!fit_again(region)) drop_misfits(region);
    fitted = region.facets.size();
  }
  return region.facets.size() > before;
}

// A cone with a very small slope is a cylinder with inexact vertices, unless vertices lie on the cone much more
// exactly.
void RegionGrower::prefer_cylinder(Region& region) {
  if (std::abs(region.surface.slope) > min_sine) return;
  PartSurface cylinder = region.surface;
  cylinder.kind = SurfaceKind::cylinder;
  cylinder.slope = 0;
  const double residual = refine(cylinder, points_of(region, max_fitted));
  if (residual > 2 * allowance_of(facets_, region.sagitta)) return;
  if (residual > std::max(facets_.tolerance, 4 * region.residual)) return;
  region.surface = cylinder;
  region.residual = residual;
}

// Adds facets that are so skewed that they face elsewhere, but lie among those of the region.
void RegionGrower::take_enclosed(Region& region) {
  const double allowance = allowance_of(facets_, region.sagitta);
  const double sagitta = region.sagitta;
  const auto is_enclosed = [&](int facet) {
    double within = 0, all = 0;
    for (const int t : facets_.triangles_of(facet))
      for (int side = 0; side < 3; ++side) {
        const int neighbour = facets_.sides[t][side].neighbour;
        if (neighbour >= 0 && facets_.facet_of[neighbour] == facet) continue;
        const double length = facets_.length_of(t, side);
        all += length;
        if (neighbour >= 0 && stamp_[facets_.facet_of[neighbour]] == number_) within += length;
      }
    return 2 * within > all;
  };
  const auto lies_on = [&](int facet) {
    const auto vertices = facets_.supports_of(facet);
    const auto is_near = [&](int v) {
      return std::abs(signed_distance(region.surface, facets_.points[v])) <= allowance;
    };
    return std::all_of(vertices.begin(), vertices.end(), is_near) &&
           std::abs(signed_distance(region.surface, facets_.facets[facet].middle)) <= max_sagittas * sagitta;
  };
  for (std::size_t next = 0; next < region.facets.size(); ++next)
    facets_.for_sides(region.facets[next], [&](int, int, int facet) {
      if (stamp_[facet] == number_ || region_of_[facet] >= 0 || facets_.facets[facet].is_plane) return;
      if (lies_on(facet) && (is_enclosed(facet) || is_chord(facets_, facet, region.surface, allowance, sagitta)))
        add(region, facet);
    });
}

void RegionGrower::drop_misfits(Region& region) {
  const double allowance = allowance_of(facets_, region.sagitta);
  std::vector<char> stays(region.facets.size());
  parallel_for(stays.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      stays[i] = approximates(facets_, region.facets[i], region.surface, allowance, region.sagitta) ? 1 : 0;
  });
  std::vector<int> kept;
  for (std::size_t i = 0; i < stays.size(); ++i)
    if (stays[i] != 0)
      kept.push_back(region.facets[i]);
    else
      stamp_[region.facets[i]] = 0;
  const bool dropped = kept.size() < region.facets.size();
  region.facets = std::move(kept);
  if (dropped && !region.facets.empty()) fit_again(region);
}

std::optional<Region> RegionGrower::grow(const PartSurface& beginning, std::span<const int> seeds) {
  ++number_;
  sagittas_ = 0;
  Region region{beginning, {}};
  for (const int f : seeds) add(region, f);
  for (int round = 0; round < 4; ++round) {
    if (!spread(region) && round > 0) break;
    // A few vertices off the surface may have bent it.
    const std::size_t before = region.facets.size();
    region.chosen = !fit_again(region) || region.chosen;
    drop_misfits(region);
    if (region.facets.size() < 2 || 3 * region.facets.size() < 2 * before) return std::nullopt;
    if (region.residual > allowance_of(facets_, region.sagitta)) return std::nullopt;
  }
  // A surface is distinguishable from the polyhedron only where the two differ.
  if (region.residual > allowance_of(facets_, region.sagitta) || region.sagitta < facets_.slack * region.residual)
    return std::nullopt;
  if (region.surface.kind == SurfaceKind::cone) prefer_cylinder(region);
  take_enclosed(region);
  return region;
}

double RegionGrower::mean_turn_of(const Region& region) const {
  const double allowance = allowance_of(facets_, region.sagitta);
  double sum = 0;
  int count = 0;
  for (const int f : region.facets) {
    if (has_no_say(facets_, f, region.surface, region.sagitta)) continue;
    double least = HUGE_VAL;
    for (const int v : facets_.supports_of(f)) {
      const Vec3 normal = normal_at_vertex(region.surface, facets_.points[v], allowance);
      if (normal != Vec3(0)) least = std::min(least, std::abs(glm::dot(normal, facets_.facets[f].normal)));
    }
    if (least == HUGE_VAL) continue;
    sum += angle_of_cosine(least);
    ++count;
  }
  // If too few facets count, the others cannot be thin ones among them.
  return 4 * count >= static_cast<int>(region.facets.size()) ? sum / count : full_turn;
}

Places RegionGrower::places_around(const Region& region, bool around_tube) {
  return places_of(region.surface, points_of(region, facets_.points.size()), around_tube,
                   allowance_of(facets_, region.sagitta));
}

// Returns at how many ends of the arc neighbours continue without an edge.
int RegionGrower::tangent_ends(const Region& region, const Places& places, bool around_tube) {
  if (places.closed) return 0;
  ++number_;
  for (const int f : region.facets) stamp_[f] = number_;
  const double near = 1e-3 + places.sweep / (16 * places.count);
  std::array<double, 2> lengths{}, tangent{};
  const auto end_at = [&](const Vec3& p) {
    double along = angle_of(region.surface, p, around_tube) - places.from;
    if (along < -full_turn / 4) along += full_turn;
    return std::abs(along) < near || std::abs(along - full_turn) < near ? 0
           : std::abs(along - places.sweep) < near                      ? 1
                                                                        : -1;
  };
  for (const int f : region.facets)
    facets_.for_sides(f, [&](int t, int side, int other) {
      if (stamp_[other] == number_) return;
      const auto [a, b] = facets_.ends_of(t, side);
      const int end = end_at(a);
      if (end < 0 || end_at(b) != end) return;
      const Vec3 normal =
          region_of_[other] >= 0 ? normal_near(regions_[region_of_[other]].surface, a) : facets_.facets[other].normal;
      const double length = glm::distance(a, b);
      lengths[end] += length;
      if (std::abs(glm::dot(normal, normal_near(region.surface, a))) > tangent_cosine) tangent[end] += length;
    });
  int count = 0;
  for (int end = 0; end < 2; ++end) count += lengths[end] > 0 && tangent[end] > 0.5 * lengths[end] ? 1 : 0;
  return count;
}

bool RegionGrower::is_evident_arc(const Region& region, bool around_tube, double mean_turn) {
  const Places places = places_around(region, around_tube);
  const double most = around_tube ? max_mean_turn_both_ways : max_mean_turn;
  // An octagon with narrow chamfers has as many positions, but not evenly around.
  if (places.closed) return places.count >= 12 && mean_turn <= most && places.step <= max_step;
  // A wide facet with narrow ones at both ends, which belong to the adjacent faces.
  if (places.step > max_of_sweep * places.sweep) return false;
  const int tangent = tangent_ends(region, places, around_tube);
  if (tangent < 2 && places.step > max_step) return false;
  if (tangent < 2 && mean_turn > most) return false;
  return places.count >= 3 && places.count + tangent >= min_places;
}

bool RegionGrower::is_evident_sphere(const Region& region) {
  return region.facets.size() >= 5 && points_of(region, 8).size() == 8 && !simpler_than(region);
}

std::optional<PartSurface> RegionGrower::simpler_than(const Region& region) {
  if (region.surface.kind != SurfaceKind::sphere) return std::nullopt;
  const std::vector<Vec3> points = points_of(region, max_fitted);
  std::vector<Facing> facings;
  for (const int f : region.facets)
    if (!facets_.is_sliver(f)) facings.push_back({facets_.facets[f].middle, facets_.facets[f].normal, 1});
  if (facings.empty()) return std::nullopt;
  for (auto simpler : {begin_cylinder(facings, points), begin_cone(facings, points)})
    if (simpler && refine(*simpler, points) <= allowance_of(facets_, region.sagitta)) return simpler;
  return std::nullopt;
}

// The number of vertices that do not lie on one plane arc, if they are few: nothing if not.
std::optional<std::size_t> RegionGrower::few_beside_arc(const Region& region) {
  const std::vector<Vec3> points = points_of(region, max_near_arc + 1);
  const std::size_t count = points.size();
  if (count > max_near_arc) return std::nullopt;
  std::size_t least = count;
  const auto look = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double length = glm::length(normal);
    if (length <= min_sine * glm::distance(a, b) * glm::distance(a, c)) return;
    const auto off = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
      return std::abs(glm::dot(p - a, normal)) > 2 * facets_.tolerance * length;
    });
    least = std::min(least, static_cast<std::size_t>(off));
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k) look(points[i], points[j], points[k]);
  return 4 * least <= count ? std::optional(least) : std::nullopt;
}

bool RegionGrower::is_beyond_chance(const Region& region) {
  const auto vertices = static_cast<double>(points_of(region, max_fitted).size());
  const double distance = std::max(region.residual, facets_.tolerance / 4);
  double evidence = vertices - unknowns_of(region.surface.kind);
  // A cylinder through a plane arc, such as the edge of a fillet, can be tilted and shifted towards a few more
  // vertices.
  if (region.surface.kind == SurfaceKind::cylinder)
    if (const auto few = few_beside_arc(region)) evidence = std::min(evidence, static_cast<double>(*few));
  return evidence * std::log2(region.sagitta / distance) >= (region.chosen ? 2 * min_bits : min_bits);
}

// Every small smooth patch is nearly a torus. Those of a part may have inexact vertices where other blends end at them.
bool RegionGrower::fits_exactly(const Region& region) {
  if (region.residual <= 2 * facets_.tolerance) return true;
  const std::vector<Vec3> points = points_of(region, max_fitted);
  const auto exact = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    return std::abs(signed_distance(region.surface, p)) <= facets_.tolerance / 2;
  });
  return 4 * exact >= 3 * static_cast<std::ptrdiff_t>(points.size());
}

bool RegionGrower::is_evident(const Region& region) {
  if (!is_beyond_chance(region)) return false;
  const double mean_turn = mean_turn_of(region);
  switch (region.surface.kind) {
    case SurfaceKind::cylinder:
    case SurfaceKind::cone:
      return is_evident_arc(region, false, mean_turn);
    case SurfaceKind::sphere:
      return mean_turn <= max_mean_turn_both_ways && is_evident_sphere(region);
    case SurfaceKind::torus:
      return fits_exactly(region) && places_around(region, false).count >= 4 && is_evident_arc(region, true, mean_turn);
    case SurfaceKind::plane:
    case SurfaceKind::free_form:
      break;
  }
  return true;
}

}  // namespace epura::surfaces
