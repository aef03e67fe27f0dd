// SPDX-License-Identifier: Apache-2.0
#include "features/recognise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <span>

#include "features/borders.hpp"
#include "features/facets.hpp"
#include "features/free_form.hpp"
#include "features/region.hpp"

namespace epura {

namespace {

constexpr std::size_t most_nearby = 24;  // facets around a seed
constexpr std::size_t most_beside = 4;
constexpr double smooth_cosine = 0.7;  // of a fold that a coarse tessellation has
// Where so few seeds of so many grow, nothing will come of the rest.
constexpr int least_seeds = 256;
constexpr int seeds_for_one = 192;
constexpr char most_failures = 4;
// Of the area of a part.
constexpr double least_recognised = 0.25;

/// A surface that some facets around a seed lie on.
struct Guess {
  PartSurface surface;
  std::vector<int> seeds;
  std::size_t explained;  ///< facets nearby that lie on it
};

class Recogniser {
 public:
  explicit Recogniser(const Facets& facets)
      : facets_(facets),
        region_of_(facets.facets.size(), -1),
        failures_(facets.facets.size(), 0),
        stamp_(facets.facets.size(), 0),
        grower_(facets, region_of_, regions_) {}

  void run() {
    find_round_regions();
    // With their neighbours known, narrow ones show that they are tangent to them.
    if (!regions_.empty()) {
      std::fill(failures_.begin(), failures_.end(), char(0));
      find_round_regions();
    }
  }

  [[nodiscard]] const std::vector<Region>& regions() const { return regions_; }
  [[nodiscard]] const std::vector<int>& region_of() const { return region_of_; }

 private:
  void find_round_regions() {
    int tried = 0, grown = 0;
    for (int f = 0; f < static_cast<int>(facets_.facets.size()); ++f) {
      const Facet& facet = facets_.facets[f];
      if (region_of_[f] >= 0 || failures_[f] >= most_failures || facet.is_plane || facets_.is_sliver(f)) continue;
      const std::vector<int> beside = beside_of(f);
      if (beside.empty()) continue;
      ++tried;
      grown += grow_from(f, beside) ? 1 : 0;
      if (getenv("D") && tried % 1000 == 0) fprintf(stderr, "tried %d grown %d\n", tried, grown);
      if (tried >= least_seeds && tried > seeds_for_one * grown) return;
    }
  }

  // Neighbours without a region across smooth edges, those with the longest common edges first.
  [[nodiscard]] std::vector<int> beside_of(int facet) const {
    struct Neighbour {
      double length;
      int facet;
    };
    std::vector<Neighbour> found;
    for (const int t : facets_.triangles_of(facet))
      for (int side = 0; side < 3; ++side) {
        const int neighbour = facets_.sides[t][side].neighbour;
        if (neighbour < 0) continue;
        const int other = facets_.facet_of[neighbour];
        if (other == facet || region_of_[other] >= 0 || facets_.facets[other].is_plane || facets_.is_sliver(other) ||
            facets_.cosine_of_fold(t, side) < smooth_cosine)
          continue;
        const double length =
            glm::distance(facets_.points[facets_.corners[t][side]], facets_.points[facets_.corners[t][(side + 1) % 3]]);
        const auto same = std::find_if(found.begin(), found.end(), [&](const auto& n) { return n.facet == other; });
        if (same == found.end())
          found.push_back({length, other});
        else
          same->length += length;
      }
    std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
      return a.length != b.length ? a.length > b.length : a.facet < b.facet;
    });
    std::vector<int> beside;
    for (const Neighbour& n : found)
      if (beside.size() < most_beside) beside.push_back(n.facet);
    return beside;
  }

  // The facet, its neighbours, and theirs.
  [[nodiscard]] std::vector<int> around(int facet, const std::vector<int>& beside) {
    ++number_;
    std::vector<int> nearby{facet};
    stamp_[facet] = number_;
    const auto take = [&](const std::vector<int>& more) {
      for (const int f : more)
        if (stamp_[f] != number_ && nearby.size() < most_nearby) {
          stamp_[f] = number_;
          nearby.push_back(f);
        }
    };
    take(beside);
    for (std::size_t i = 1; i < nearby.size() && nearby.size() < most_nearby; ++i) take(beside_of(nearby[i]));
    return nearby;
  }

  [[nodiscard]] std::vector<Vec3> points_of(std::span<const int> facets) const {
    std::vector<int> vertices;
    for (const int f : facets)
      for (const int v : facets_.vertices_of(f)) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<Vec3> points;
    for (const int v : vertices) points.push_back(facets_.points[v]);
    return points;
  }

  [[nodiscard]] std::vector<Facing> facings_of(std::span<const int> facets) const {
    std::vector<Facing> facings;
    for (const int f : facets) facings.push_back({facets_.facets[f].middle, facets_.facets[f].normal, 1});
    // All to one side, though triangles may run round either way.
    for (Facing& f : facings)
      if (glm::dot(f.normal, facings.front().normal) < 0) f.normal = -f.normal;
    return facings;
  }

  // Keeps the surface if the seeds lie on it and it explains more nearby facets than the last of its kind.
  void consider(std::vector<Guess>& guesses, std::optional<PartSurface> surface, std::span<const int> seeds,
                std::span<const Vec3> points, std::span<const int> nearby) const {
    if (!surface) return;
    double sagitta = 0;
    const double residual = refine(*surface, points, 64 * facets_.tolerance);
    for (const int f : seeds)
      sagitta += std::abs(signed_distance(*surface, facets_.facets[f].middle)) / static_cast<double>(seeds.size());
    const double allowance = allowance_of(facets_, sagitta);
    if (residual > allowance || sagitta < 4 * residual) return;
    std::vector<int> explained;
    for (const int f : nearby)
      if (approximates(facets_, f, *surface, (f == seeds[0] ? 1 : 8) * allowance, sagitta)) explained.push_back(f);
    if (explained.size() < 2 || explained.front() != seeds[0]) return;
    const auto same =
        std::find_if(guesses.begin(), guesses.end(), [&](const Guess& g) { return g.surface.kind == surface->kind; });
    if (same == guesses.end())
      guesses.push_back({*surface, {seeds.begin(), seeds.end()}, explained.size()});
    else if (explained.size() > same->explained)
      *same = {*surface, {seeds.begin(), seeds.end()}, explained.size()};
  }

  [[nodiscard]] std::vector<Guess> guess(int facet, const std::vector<int>& beside,
                                         const std::vector<int>& nearby) const {
    std::vector<Guess> guesses;
    const auto try_all = [&](const std::vector<int>& seeds) {
      const std::vector<Vec3> points = points_of(seeds);
      const std::vector<Facing> facings = facings_of(seeds);
      consider(guesses, begin_cylinder(facings, points), seeds, points, nearby);
      consider(guesses, begin_cone(facings, points), seeds, points, nearby);
      if (points.size() > 4) consider(guesses, begin_sphere(points), seeds, points, nearby);
    };
    if (beside.size() == 1) try_all({facet, beside[0]});
    // The longest edges of a strip are those along it; neighbours across them are on one surface most often.
    for (std::size_t i = 0; i + 1 < beside.size(); ++i) try_all({facet, beside[i], beside[i + 1]});
    if (beside.size() > 2) try_all({facet, beside[0], beside[2]});
    for (const std::size_t size : {std::size_t(13), std::size_t(9)}) {
      if (nearby.size() < size) continue;
      const std::vector<int> seeds(nearby.begin(), nearby.begin() + static_cast<std::ptrdiff_t>(size));
      const std::vector<Vec3> points = points_of(seeds);
      const std::vector<Facing> facings = facings_of(seeds);
      consider(guesses, begin_torus_by_normals(facings, points), seeds, points, nearby);
      consider(guesses, begin_torus_by_curvatures(facings, points), seeds, points, nearby);
    }
    // What explains more; of equals the simpler one.
    std::sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) {
      return a.explained != b.explained ? a.explained > b.explained : a.surface.kind < b.surface.kind;
    });
    return guesses;
  }

  bool grow_from(int facet, const std::vector<int>& beside) {
    const std::vector<int> nearby = around(facet, beside);
    for (const Guess& g : guess(facet, beside, nearby)) {
      auto region = grower_.grow(g.surface, g.seeds);
      if (getenv("G"))
        fprintf(stderr, "seed %d beside %zu nearby %zu guess %s r %g explained %zu -> %s facets %zu evident %d\n",
                facet, beside.size(), nearby.size(), surface_kind_names[int(g.surface.kind)], g.surface.radius,
                g.explained, region ? "grown" : "-", region ? region->facets.size() : 0,
                region ? int(grower_.is_evident(*region)) : -1);
      if (!region || !grower_.is_evident(*region)) continue;
      for (const int f : region->facets) region_of_[f] = static_cast<int>(regions_.size());
      regions_.push_back(std::move(*region));
      return true;
    }
    // What is as large as the seed would hardly do better.
    for (const int f : nearby) {
      const double ratio = facets_.facets[f].width / facets_.facets[facet].width;
      if (ratio > 0.4 && ratio < 2.5) ++failures_[f];
    }
    failures_[facet] = most_failures;
    return false;
  }

  const Facets& facets_;
  std::vector<int> region_of_;
  std::vector<Region> regions_;
  std::vector<char> failures_;  ///< of seeds nearby
  std::vector<int> stamp_;
  int number_ = 0;
  RegionGrower grower_;
};

/// Regions as faces, in the lengths of the file.
class Result {
 public:
  Result(const Mesh& mesh, const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions)
      : mesh_(mesh), facets_(facets), region_of_(region_of), regions_(regions) {}

  [[nodiscard]] PartFaces faces() const {
    PartFaces result;
    result.tolerance = facets_.tolerance / facets_.scale;
    for (const Region& region : regions_) result.faces.push_back(face_of(region));
    for (const int facet : facets_.facet_of) result.face_of_triangle.push_back(region_of_[facet]);
    double area = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      area += result.faces[r].area;
      if (is_sure(regions_[r])) result.recognised += result.faces[r].area;
    }
    if (area > 0) result.recognised /= area;
    turn_bodies(result);
    return result;
  }

 private:
  // A triangle alone beside a smooth edge may be part of anything.
  [[nodiscard]] bool is_sure(const Region& region) const {
    if (region.surface.kind == SurfaceKind::free_form) return false;
    if (region.surface.kind != SurfaceKind::plane || region.facets.size() > 1) return true;
    const int facet = region.facets.front();
    if (facets_.triangles_of(facet).size() > 1) return true;
    const int t = facets_.triangles_of(facet).front();
    for (int side = 0; side < 3; ++side)
      if (facets_.sides[t][side].neighbour >= 0 && facets_.cosine_of_fold(t, side) > smooth_cosine) return false;
    return true;
  }

  [[nodiscard]] PartFace face_of(const Region& region) const {
    PartFace face;
    const double unit = 1 / facets_.scale;
    face.surface = region.surface;
    face.surface.origin = region.surface.origin * unit + facets_.origin;
    face.surface.radius *= unit;
    face.surface.minor *= unit;
    face.residual = region.residual * unit;
    face.sagitta = region.sagitta * unit;
    face.body = mesh_.body[facets_.triangles_of(region.facets.front()).front()];
    double outwards = 0;
    for (const int f : region.facets) {
      const Facet& facet = facets_.facets[f];
      face.area += facet.area * unit * unit;
      face.triangles += static_cast<int>(facets_.triangles_of(f).size());
      outwards += facet.area * glm::dot(normal_near(region.surface, facet.middle), facet.normal);
    }
    measure_turn(region, face);
    if (region.surface.kind == SurfaceKind::plane && outwards < 0) face.surface.axis = -face.surface.axis;
    if (region.surface.kind != SurfaceKind::plane) face.inwards = outwards < 0;
    return face;
  }

  void measure_turn(const Region& region, PartFace& face) const {
    const SurfaceKind kind = region.surface.kind;
    if (kind != SurfaceKind::cylinder && kind != SurfaceKind::cone && kind != SurfaceKind::torus) return;
    std::vector<Vec3> points;
    face.from = HUGE_VAL;
    face.to = -HUGE_VAL;
    for (const int f : region.facets)
      for (const int v : facets_.vertices_of(f)) {
        points.push_back(facets_.points[v]);
        const double height = glm::dot(points.back() - region.surface.origin, region.surface.axis) / facets_.scale;
        face.from = std::min(face.from, height);
        face.to = std::max(face.to, height);
      }
    const Places places = places_of(region.surface, points, false, allowance_of(facets_, region.sagitta));
    face.sweep = places.closed ? 360 : places.sweep * (180 / std::numbers::pi);
  }

  // A body whose triangles all run the other way round has its inside outside.
  void turn_bodies(PartFaces& result) const {
    if (mesh_.body.empty()) return;
    std::vector<double> volume(static_cast<std::size_t>(*std::max_element(mesh_.body.begin(), mesh_.body.end())) + 1);
    for (std::size_t t = 0; t < facets_.corners.size(); ++t) {
      const auto& [a, b, c] = facets_.corners[t];
      volume[mesh_.body[t]] += glm::dot(facets_.points[a], glm::cross(facets_.points[b], facets_.points[c]));
    }
    for (PartFace& face : result.faces) {
      if (!(volume[face.body] < 0)) continue;
      if (face.surface.kind == SurfaceKind::plane)
        face.surface.axis = -face.surface.axis;
      else if (face.surface.kind != SurfaceKind::free_form)
        face.inwards = !face.inwards;
    }
  }

  const Mesh& mesh_;
  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
};

}  // namespace

PartFaces recognise_faces(const Mesh& mesh, const RecogniseOptions& options) {
  const Facets facets = make_facets(mesh);
  Recogniser recogniser(facets);
  recogniser.run();
  std::vector<int> region_of = recogniser.region_of();
  std::vector<Region> regions = recogniser.regions();
  complete_regions(facets, region_of, regions);
  merge_regions(facets, region_of, regions);
  PartFaces result = Result(mesh, facets, region_of, regions).faces();
  // A scan, or a mesh that an artist made: its few flat places are none of a part.
  if (result.recognised < least_recognised)
    return {{}, std::vector<int>(mesh.polygon.size(), -1), {}, result.tolerance, result.recognised};
  result.borders = find_borders(mesh, facets, region_of, regions, options.tangent_angle);
  return result;
}

}  // namespace epura
