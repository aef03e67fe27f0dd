// SPDX-License-Identifier: Apache-2.0
#include "features/recognise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "base/portable_math.hpp"
#include "features/borders.hpp"
#include "features/chords.hpp"
#include "features/facets.hpp"
#include "features/free_form.hpp"
#include "features/region.hpp"

namespace epura::features {

namespace {

constexpr std::size_t most_nearby = 24;  // facets around a seed
constexpr std::size_t most_beside = 4;
constexpr double smooth_cosine = 0.7;  // of a fold that a coarse tessellation has
// Where so few seeds of so many grow, nothing will come of the rest.
constexpr int least_seeds = 256;
constexpr int seeds_for_one = 192;
constexpr int patience = 512;
constexpr char enough_failures = 8;
// Of the area of a part.
constexpr double least_recognised = 0.25;
constexpr std::size_t most_alone = 256;
// The tangent of a fold from which an edge of the mesh certainly is one of the part.
constexpr double shallow_most = 1;

/// A surface that some facets around a seed lie on.
struct Guess {
  PartSurface surface;
  std::vector<int> seeds;
  std::size_t explained;  ///< facets nearby that lie on it
};

class Recogniser {
 public:
  Recogniser(const Facets& facets, const Progress& progress)
      : facets_(facets),
        progress_(progress),
        region_of_(facets.facets.size(), -1),
        failures_(facets.facets.size(), 0),
        stamp_(facets.facets.size(), 0),
        in_ring_(facets.facets.size(), 0),
        grower_(facets, region_of_, regions_) {}

  void run() {
    find_round_regions(false);
    if (regions_.empty() && !grow_rings()) return;
    // With their neighbours known, narrow ones show that they are tangent to them.
    find_beside_regions();
    if (grow_rings()) find_beside_regions();
  }

  [[nodiscard]] const std::vector<Region>& regions() const { return regions_; }
  [[nodiscard]] const std::vector<int>& region_of() const { return region_of_; }

 private:
  void find_beside_regions() {
    std::fill(failures_.begin(), failures_.end(), char(0));
    find_round_regions(true);
  }

  void find_round_regions(bool beside_regions) {
    int tried = 0, grown = 0, in_vain = -patience;
    for (int f = 0; f < static_cast<int>(facets_.facets.size()); ++f) {
      // The longer little was found, as in free forms, the fewer seeds are tried.
      const int most_failures = in_vain < 0 ? enough_failures : in_vain < 256 ? 3 : 1;
      const Facet& facet = facets_.facets[f];
      if (region_of_[f] >= 0 || failures_[f] >= most_failures || facet.is_plane || facets_.is_sliver(f)) continue;
      if (beside_regions && !is_beside_region(f)) continue;
      const std::vector<int> beside = beside_of(f);
      if (beside.empty()) continue;
      progress_.expect_time();
      ++tried;
      ++in_vain;
      if (grow_from(f, beside)) {
        ++grown;
        in_vain = std::max(in_vain - 8, -patience);
      }
      if (tried >= least_seeds && tried > seeds_for_one * grown) return;
    }
  }

  [[nodiscard]] bool is_beside_region(int facet) const {
    bool found = false;
    facets_.for_sides(facet, [&](int, int, int other) { found = found || region_of_[other] >= 0; });
    return found;
  }

  // Neighbours without a region across smooth edges, those with the longest common edges first.
  [[nodiscard]] std::vector<int> beside_of(int facet) const {
    struct Neighbour {
      double length;
      int facet;
    };
    std::vector<Neighbour> found;
    facets_.for_sides(facet, [&](int t, int side, int other) {
      if (region_of_[other] >= 0 || facets_.facets[other].is_plane || facets_.is_sliver(other) ||
          facets_.cosine_of_fold(t, side) < smooth_cosine)
        return;
      const double length = facets_.length_of(t, side);
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& n) { return n.facet == other; });
      if (same == found.end())
        found.push_back({length, other});
      else
        same->length += length;
    });
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
    facets_.sort_by_place(vertices);
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

  /// Some facets, what a fit asks of them, and those around them that are to tell whether it is right.
  struct Patch {
    std::span<const int> facets, nearby;
    std::vector<Vec3> points;
    std::vector<Facing> facings;
  };

  [[nodiscard]] Patch patch_of(std::span<const int> facets, std::span<const int> nearby) const {
    return {facets, nearby, points_of(facets), facings_of(facets)};
  }

  [[nodiscard]] double sagitta_of(const PartSurface& surface, std::span<const int> facets) const {
    double sum = 0;
    for (const int f : facets) sum += std::abs(signed_distance(surface, facets_.facets[f].middle));
    return sum / static_cast<double>(facets.size());
  }

  // Keeps the surface if the patch lies on it and it explains more facets nearby than the last of its kind. Whether the
  // patch does.
  bool consider(std::vector<Guess>& guesses, std::optional<PartSurface> surface, const Patch& patch) const {
    if (!surface) return false;
    const double residual = refine(*surface, patch.points, 64 * facets_.tolerance);
    const double sagitta = sagitta_of(*surface, patch.facets);
    const double allowance = allowance_of(facets_, sagitta);
    if (residual > allowance || sagitta < 4 * residual) return false;
    const int seed = patch.facets.front();
    std::size_t explained = 0;
    for (const int f : patch.nearby) {
      const bool fits = approximates(facets_, f, *surface, (f == seed ? 1 : 8) * allowance, sagitta);
      if (f == seed && !fits) return false;
      explained += fits ? 1 : 0;
    }
    // As many points as determine it say nothing, unless it foretells others.
    const auto spare = static_cast<int>(patch.points.size()) - unknowns_of(surface->kind);
    if (explained < 2 || (explained <= patch.facets.size() && spare < 2)) return false;
    const Guess guess{*surface, {patch.facets.begin(), patch.facets.end()}, explained};
    const auto same =
        std::find_if(guesses.begin(), guesses.end(), [&](const Guess& g) { return g.surface.kind == surface->kind; });
    if (same == guesses.end())
      guesses.push_back(guess);
    else if (explained > same->explained)
      *same = guess;
    return true;
  }

  // Three facets of a strip that lies along a surface begin it so well that little is left to refine.
  void guess_strip(std::vector<Guess>& guesses, const Patch& patch) const {
    const auto is_near = [&](const std::optional<PartSurface>& surface) {
      return surface && residual_of(*surface, patch.points) < 0.25 * sagitta_of(*surface, patch.facets);
    };
    if (const auto cylinder = begin_cylinder(patch.facings, patch.points); is_near(cylinder))
      consider(guesses, cylinder, patch);
    if (!guesses.empty() && guesses.front().explained == patch.nearby.size()) return;
    if (const auto cone = begin_cone(patch.facings, patch.points); is_near(cone)) consider(guesses, cone, patch);
    if (patch.points.size() < 5) return;
    if (const auto sphere = begin_sphere(patch.points); is_near(sphere)) consider(guesses, sphere, patch);
  }

  [[nodiscard]] std::vector<Guess> guess(int facet, const std::vector<int>& beside,
                                         const std::vector<int>& nearby) const {
    std::vector<Guess> guesses;
    const auto try_strip = [&](const std::vector<int>& seeds) { guess_strip(guesses, patch_of(seeds, nearby)); };
    if (beside.size() == 1) try_strip({facet, beside[0]});
    // Most faces are cylinders that are alone.
    const auto explains_all = [&] {
      return guesses.size() == 1 && guesses.front().surface.kind == SurfaceKind::cylinder && nearby.size() > 5 &&
             guesses.front().explained == nearby.size();
    };
    // The longest edges of a strip are those along it; neighbours across them are on one surface most often.
    for (std::size_t i = 0; i + 1 < beside.size() && !explains_all(); ++i) try_strip({facet, beside[i], beside[i + 1]});
    if (explains_all()) return guesses;
    if (beside.size() > 2) try_strip({facet, beside[0], beside[2]});
    std::size_t size = std::min<std::size_t>(9, nearby.size());
    while (size < nearby.size() && size < 13 && points_of(std::span(nearby).first(size)).size() < 14) ++size;
    if (size >= 7) {
      const Patch patch = patch_of(std::span(nearby).first(size), nearby);
      consider(guesses, begin_cylinder(patch.facings, patch.points), patch);
      if (!consider(guesses, begin_cone(patch.facings, patch.points), patch))
        consider(guesses, begin_cone_by_curvatures(patch.facings, patch.points), patch);
      if (!consider(guesses, begin_torus_by_normals(patch.facings, patch.points), patch))
        consider(guesses, begin_torus_by_curvatures(patch.facings, patch.points), patch);
    }
    // What explains more; of equals the simpler one.
    std::sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) {
      return a.explained != b.explained ? a.explained > b.explained : a.surface.kind < b.surface.kind;
    });
    return guesses;
  }

  void keep(Region region) {
    for (const int f : region.facets) region_of_[f] = static_cast<int>(regions_.size());
    regions_.push_back(std::move(region));
  }

  void remember_ring(const Region& region) {
    if (in_ring_[region.facets.front()] != 0) return;
    const auto simpler = grower_.simpler_than(region);
    if (!simpler) return;
    for (const int f : region.facets) in_ring_[f] = 1;
    rings_.push_back({*simpler, region.facets, 0});
  }

  // Rings of triangles that are no strip begin with a sphere. They come last: of the rows of a torus they would make
  // cones. Whether there were any.
  bool grow_rings() {
    const std::size_t before = regions_.size();
    for (const Guess& ring : rings_) {
      std::vector<int> seeds;
      for (const int f : ring.seeds)
        if (region_of_[f] < 0) seeds.push_back(f);
      if (2 * seeds.size() < ring.seeds.size()) continue;
      if (auto region = grower_.grow(ring.surface, seeds); region && grower_.is_evident(*region))
        keep(std::move(*region));
    }
    return regions_.size() > before;
  }

  bool grow_from(int facet, const std::vector<int>& beside) {
    const std::vector<int> nearby = around(facet, beside);
    for (const Guess& g : guess(facet, beside, nearby)) {
      auto region = grower_.grow(g.surface, g.seeds);
      if (!region) continue;
      if (grower_.is_evident(*region)) {
        keep(std::move(*region));
        return true;
      }
      if (region->surface.kind == SurfaceKind::sphere) remember_ring(*region);
    }
    // What is as large as the seed would hardly do better.
    for (const int f : nearby) {
      const double ratio = facets_.facets[f].width / facets_.facets[facet].width;
      if (ratio > 0.4 && ratio < 2.5 && failures_[f] < enough_failures) ++failures_[f];
    }
    failures_[facet] = enough_failures;
    return false;
  }

  const Facets& facets_;
  const Progress& progress_;
  std::vector<int> region_of_;
  std::vector<Region> regions_;
  std::vector<char> failures_;  ///< of seeds nearby
  std::vector<int> stamp_;
  int number_ = 0;
  std::vector<Guess> rings_;
  std::vector<char> in_ring_;  ///< whether a facet is in one of them
  RegionGrower grower_;
};

/// Regions as faces, in the lengths of the file.
class Result {
 public:
  Result(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
         const std::vector<Region>& regions)
      : mesh_(mesh), facets_(facets), region_of_(region_of), regions_(regions) {}

  [[nodiscard]] PartFaces faces() const {
    PartFaces result;
    result.tolerance = facets_.tolerance / facets_.scale;
    for (const Region& region : regions_) result.faces.push_back(face_of(region));
    for (const int facet : facets_.facet_of) result.face_of_triangle.push_back(region_of_[facet]);
    double area = 0;  // in which the file's unit may be beyond all doubles
    for (const Region& region : regions_) {
      const bool sure = is_sure(region);
      for (const int f : region.facets) {
        area += facets_.facets[f].area;
        if (sure) result.recognised += facets_.facets[f].area;
      }
    }
    if (area > 0) result.recognised /= area;
    turn_bodies(result);
    return result;
  }

 private:
  // A triangle alone beside a smooth edge may be part of anything, and so may one of very many.
  [[nodiscard]] bool is_sure(const Region& region) const {
    if (region.surface.kind == SurfaceKind::free_form) return false;
    if (region.surface.kind != SurfaceKind::plane || region.facets.size() > 1) return true;
    const int facet = region.facets.front();
    if (facets_.triangles_of(facet).size() > 1) return true;
    if (facets_.facets.size() > most_alone) return false;
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

  const mesh::Mesh& mesh_;
  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
};

// Whether so little lies on round surfaces and in planes of several triangles that no part will be recognised.
bool is_scan(const Facets& facets, const std::vector<int>& region_of) {
  if (facets.facets.size() <= most_alone) return false;
  double all = 0, sure = 0;
  for (std::size_t f = 0; f < facets.facets.size(); ++f) {
    all += facets.facets[f].area;
    if (region_of[f] >= 0 || facets.triangles_of(static_cast<int>(f)).size() > 1) sure += facets.facets[f].area;
  }
  return sure < least_recognised * all;
}

}  // namespace

PartFaces recognise_faces(const mesh::Mesh& mesh, const RecogniseOptions& options, const Progress& progress) {
  const Facets facets = make_facets(mesh);
  Recogniser recogniser(facets, progress);
  recogniser.run();
  // A scan, or a mesh that an artist made: its few flat places are none of a part.
  PartFaces nothing{{}, std::vector<int>(mesh.polygon.size(), -1), {}, {}, facets.tolerance / facets.scale, 0};
  if (is_scan(facets, recogniser.region_of())) return nothing;
  std::vector<int> region_of = recogniser.region_of();
  std::vector<Region> regions = recogniser.regions();
  merge_regions(facets, region_of, regions);
  dissolve_rows(facets, region_of, regions);
  take_chords(facets, region_of, regions);
  complete_regions(facets, region_of, regions);
  merge_regions(facets, region_of, regions);
  PartFaces result = Result(mesh, facets, region_of, regions).faces();
  nothing.recognised = result.recognised;
  if (result.recognised < least_recognised) return nothing;
  result.borders = find_borders(mesh, facets, region_of, regions, options.tangent_angle);
  result.border_of_edge.assign(mesh.edges.size(), -1);
  for (std::size_t b = 0; b < result.borders.size(); ++b)
    for (const int edge : result.borders[b].edges) result.border_of_edge[edge] = static_cast<int>(b);
  return result;
}

bool has_shallow_folds(const mesh::Mesh& mesh, double least) {
  const double shallow_least = portable_tan(least * (std::numbers::pi / 180));
  const auto normal = [&](int triangle) {
    const auto [a, b, c] = mesh.triangle(triangle);
    return glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
  };
  return std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const mesh::MeshEdge& edge) {
    if (edge.count != 2) return false;
    const auto triangles = mesh.triangles_of(edge);
    const Vec3 one = normal(triangles[0]), two = normal(triangles[1]);
    const double sine = glm::length(glm::cross(one, two)), cosine = std::abs(glm::dot(one, two));
    return sine > shallow_least * cosine && sine < shallow_most * cosine;
  });
}

}  // namespace epura::features
