// SPDX-License-Identifier: Apache-2.0
#include "features/round_regions.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <deque>
#include <initializer_list>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "features/clusters.hpp"
#include "features/estimates.hpp"
#include "features/limits.hpp"

namespace epura::features {

namespace {

constexpr std::size_t most_beside = 4;
constexpr int facets_at_once = 256;

/// A surface on which some facets around a seed lie.
struct Guess {
  PartSurface surface;
  std::vector<int> seeds;
  std::size_t explained;  ///< number of facets nearby that lie on it
};

/// The first neighbours of a facet.
struct Few {
  std::array<int, most_beside> facets{};
  std::size_t count = 0;

  [[nodiscard]] bool empty() const { return count == 0; }
  [[nodiscard]] std::span<const int> all() const { return std::span(facets).first(count); }
};

struct Neighbour {
  double length;  ///< total length of common edges
  int facet;
};

/// Counts attempts: the longer few of them succeed, as in free forms, the fewer facets are tried.
struct Effort {
  int most_tried;  ///< seeds for each that grows
  int tried = 0;
  int grown = 0;
  int in_vain = -patience;

  void add(bool found) {
    ++tried;
    ++in_vain;
    if (!found) return;
    ++grown;
    in_vain = std::max(in_vain - 8, -patience);
  }

  [[nodiscard]] bool is_hopeless() const { return tried >= least_seeds && tried > most_tried * grown; }
};

/// A facet from which a surface might have grown, and whether it did.
struct Try {
  int facet;
  bool found;
};

/// The origin of a region: regions are kept in this order, whatever was searched at the same time.
struct Origin {
  int stage;
  int seed;  ///< facet

  auto operator<=>(const Origin&) const = default;
};

/// A cylinder or cone, and those of its facets that a sphere took first.
struct Ring {
  PartSurface surface;
  std::vector<int> facets;
  int seed;
};

/// Searches one cluster.
class Search {
 public:
  Search(const Facets& facets, const Progress& progress, Wanted wanted)
      : facets_(facets),
        progress_(progress),
        wanted_(wanted),
        failures_(facets.facets.size(), 0),
        stamp_(facets.facets.size(), 0),
        vertex_stamp_(facets.points.size(), 0),
        neighbours_at_(facets.facets.size(), -1),
        in_ring_(facets.facets.size(), 0),
        grower_(facets, found_.region_of, found_.regions) {
    found_.region_of.assign(facets.facets.size(), -1);
  }

  /// Starts again with the first facet.
  void begin_pass() {
    ++stage_;
    next_ = 0;
    std::fill(failures_.begin(), failures_.end(), char(0));
  }

  /// Tries the next facets up to `end`, given the effort so far.
  std::vector<Try> advance(int end, bool beside_regions, Effort effort) {
    std::vector<Try> tries;
    for (; next_ < end; ++next_) {
      const int f = next_;
      const int most_failures = effort.in_vain < 0 ? enough_failures : effort.in_vain < 256 ? 3 : 1;
      const Facet& facet = facets_.facets[f];
      if (region_of(f) >= 0 || failures_[f] >= most_failures || facet.is_plane || facets_.is_sliver(f)) continue;
      if (beside_regions && !is_beside_region(f)) continue;
      const Few beside = beside_of(f);
      if (beside.empty()) continue;
      progress_.expect_time();
      tries.push_back({f, grow_from(f, beside)});
      effort.add(tries.back().found);
      if (effort.is_hopeless()) break;
    }
    return tries;
  }

  /// Drops regions of this pass that grew from facet `end` or later ones.
  void drop_from(int end) {
    while (!origins_.empty() && origins_.back() >= Origin{stage_, end}) {
      for (const int f : found_.regions.back().facets) found_.region_of[f] = -1;
      found_.regions.pop_back();
      origins_.pop_back();
    }
  }

  /// Grows rings of triangles that are not strips, which were first taken for a sphere. They come last, since they
  /// would turn rows of a torus into cones. Returns whether any ring grew.
  bool grow_rings() {
    ++stage_;
    const std::size_t before = found_.regions.size();
    for (const Ring& ring : rings_) {
      std::vector<int> seeds;
      for (const int f : ring.facets)
        if (region_of(f) < 0) seeds.push_back(f);
      if (2 * seeds.size() < ring.facets.size()) continue;
      if (auto region = grower_.grow(ring.surface, seeds); region && grower_.is_evident(*region))
        keep(std::move(*region), ring.seed);
    }
    return found_.regions.size() > before;
  }

  [[nodiscard]] const std::vector<Origin>& origins() const { return origins_; }
  [[nodiscard]] RoundRegions& found() { return found_; }

 private:
  [[nodiscard]] int region_of(int facet) const { return found_.region_of[facet]; }

  [[nodiscard]] bool is_beside_region(int facet) const {
    bool found = false;
    facets_.for_sides(facet, [&](int, int, int other) { found = found || region_of(other) >= 0; });
    return found;
  }

  // Returns neighbours without a region across smooth edges, those with the longest common edges first.
  [[nodiscard]] Few beside_of(int facet) {
    int& at = neighbours_at_[facet];
    if (at < 0) {
      at = static_cast<int>(neighbours_.size());
      remember_neighbours(facet);
    }
    Few beside;
    const auto first = static_cast<std::size_t>(at);
    const auto count = static_cast<std::size_t>(neighbours_[first]);
    for (const int other : std::span(neighbours_).subspan(first + 1, count))
      if (region_of(other) < 0 && beside.count < beside.facets.size()) beside.facets[beside.count++] = other;
    return beside;
  }

  // Stores the number of neighbours and the neighbours, with or without a region, since each list is needed often.
  void remember_neighbours(int facet) {
    around_facet_.clear();
    facets_.for_sides(facet, [&](int t, int side, int other) {
      if (facets_.facets[other].is_plane || facets_.is_sliver(other) || facets_.cosine_of_fold(t, side) < smooth_cosine)
        return;
      const double length = facets_.length_of(t, side);
      const auto same =
          std::find_if(around_facet_.begin(), around_facet_.end(), [&](const auto& n) { return n.facet == other; });
      if (same == around_facet_.end())
        around_facet_.push_back({length, other});
      else
        same->length += length;
    });
    std::sort(around_facet_.begin(), around_facet_.end(), [](const Neighbour& a, const Neighbour& b) {
      return a.length != b.length ? a.length > b.length : a.facet < b.facet;
    });
    neighbours_.push_back(static_cast<int>(around_facet_.size()));
    for (const Neighbour& n : around_facet_) neighbours_.push_back(n.facet);
  }

  // Returns the facet, its neighbours, and their neighbours.
  [[nodiscard]] std::vector<int> around(int facet, const Few& beside) {
    ++number_;
    std::vector<int> nearby{facet};
    stamp_[facet] = number_;
    const auto take = [&](const Few& more) {
      for (const int f : more.all())
        if (stamp_[f] != number_ && nearby.size() < most_nearby) {
          stamp_[f] = number_;
          nearby.push_back(f);
        }
    };
    take(beside);
    for (std::size_t i = 1; i < nearby.size() && nearby.size() < most_nearby; ++i) take(beside_of(nearby[i]));
    return nearby;
  }

  [[nodiscard]] std::vector<Vec3> points_of(std::span<const int> facets) {
    ++vertex_number_;
    std::vector<Vec3> points;
    points.reserve(4 * facets.size());
    for (const int f : facets)
      for (const int v : facets_.supports_of(f))
        if (std::exchange(vertex_stamp_[v], vertex_number_) != vertex_number_) points.push_back(facets_.points[v]);
    return points;
  }

  [[nodiscard]] std::vector<Facing> facings_of(std::span<const int> facets) const {
    std::vector<Facing> facings;
    facings.reserve(facets.size());
    for (const int f : facets) facings.push_back({facets_.facets[f].middle, facets_.facets[f].normal, 1});
    // All normals point to one side, although triangles may have either orientation.
    for (Facing& f : facings)
      if (glm::dot(f.normal, facings.front().normal) < 0) f.normal = -f.normal;
    return facings;
  }

  /// Some facets, the input of a fit to them, and the facets around them that decide whether it is right.
  struct Patch {
    std::span<const int> facets, nearby;
    std::vector<Vec3> points;
    std::vector<Facing> facings;
  };

  [[nodiscard]] Patch patch_of(std::span<const int> facets, std::span<const int> nearby) {
    return {facets, nearby, points_of(facets), facings_of(facets)};
  }

  [[nodiscard]] double sagitta_of(const PartSurface& surface, std::span<const int> facets) const {
    double sum = 0;
    for (const int f : facets) sum += std::abs(signed_distance(surface, facets_.facets[f].middle));
    return sum / static_cast<double>(facets.size());
  }

  // Keeps the surface if the patch lies on it and it explains more facets nearby than the last one of its kind. Returns
  // whether the patch lies on it.
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
    // A surface through just as many points as determine it proves nothing unless it predicts other facets.
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

  // Three facets of a strip along a surface give such a good estimate that little is left to refine.
  void guess_strip(std::vector<Guess>& guesses, const Patch& patch) const {
    const auto is_near = [&](const std::optional<PartSurface>& surface) {
      return surface && residual_of(*surface, patch.points) < 0.25 * sagitta_of(*surface, patch.facets);
    };
    if (const auto cylinder = begin_cylinder(patch.facings, patch.points); is_near(cylinder))
      consider(guesses, cylinder, patch);
    if (wanted_ == Wanted::cylinders) return;
    if (!guesses.empty() && guesses.front().explained == patch.nearby.size()) return;
    if (const auto cone = begin_cone(patch.facings, patch.points); is_near(cone)) consider(guesses, cone, patch);
    if (patch.points.size() < 5) return;
    if (const auto sphere = begin_sphere(patch.points); is_near(sphere)) consider(guesses, sphere, patch);
  }

  void guess_patch(std::vector<Guess>& guesses, const Patch& patch) const {
    consider(guesses, begin_cylinder(patch.facings, patch.points), patch);
    if (wanted_ == Wanted::cylinders) return;
    const auto curvatures = curvatures_of(patch.facings.front(), patch.points);
    const auto by_curvatures = [&](const auto& begin) {
      return curvatures ? begin(*curvatures, patch.points) : std::nullopt;
    };
    if (!consider(guesses, begin_cone(patch.facings, patch.points), patch))
      consider(guesses, by_curvatures(begin_cone_by_curvatures), patch);
    if (!consider(guesses, begin_torus_by_normals(patch.facings, patch.points), patch))
      consider(guesses, by_curvatures(begin_torus_by_curvatures), patch);
  }

  [[nodiscard]] std::vector<Guess> guess(int facet, const Few& neighbours, const std::vector<int>& nearby) {
    std::vector<Guess> guesses;
    const auto try_strip = [&](std::initializer_list<int> seeds) {
      guess_strip(guesses, patch_of(std::span(seeds.begin(), seeds.size()), nearby));
    };
    const std::span<const int> beside = neighbours.all();
    if (beside.size() == 1) try_strip({facet, beside[0]});
    // Most faces are isolated cylinders.
    const auto explains_all = [&] {
      return guesses.size() == 1 && guesses.front().surface.kind == SurfaceKind::cylinder && nearby.size() > 5 &&
             guesses.front().explained == nearby.size();
    };
    // The longest edges of a strip are those along it; neighbours across these are most often on the same surface.
    for (std::size_t i = 0; i + 1 < beside.size() && !explains_all(); ++i) try_strip({facet, beside[i], beside[i + 1]});
    if (explains_all()) return guesses;
    if (beside.size() > 2) try_strip({facet, beside[0], beside[2]});
    std::size_t size = std::min<std::size_t>(9, nearby.size());
    while (size < nearby.size() && size < 13 && points_of(std::span(nearby).first(size)).size() < 14) ++size;
    if (size >= 7) guess_patch(guesses, patch_of(std::span(nearby).first(size), nearby));
    // The guess that explains more comes first; of equals, the simpler one.
    std::sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) {
      return a.explained != b.explained ? a.explained > b.explained : a.surface.kind < b.surface.kind;
    });
    return guesses;
  }

  void keep(Region region, int seed) {
    origins_.push_back({stage_, seed});
    for (const int f : region.facets) found_.region_of[f] = static_cast<int>(found_.regions.size());
    found_.regions.push_back(std::move(region));
  }

  void remember_ring(const Region& region, int seed) {
    if (in_ring_[region.facets.front()] != 0) return;
    const auto simpler = grower_.simpler_than(region);
    if (!simpler) return;
    for (const int f : region.facets) in_ring_[f] = 1;
    rings_.push_back({*simpler, region.facets, seed});
  }

  std::optional<Region> cone_along(std::span<const int> facets) {
    const auto cone = begin_cone(facings_of(facets), points_of(facets));
    return cone ? grower_.grow(*cone, facets) : std::nullopt;
  }

  // Along a slender cone, or a part of it, a cylinder may lie within tolerance: returns the cone if it goes on farther,
  // or vertices lie on it much more exactly.
  Region or_cone(Region region) {
    if (region.surface.kind != SurfaceKind::cylinder || region.residual <= facets_.tolerance / 2) return region;
    auto wider = cone_along(region.facets);
    if (!wider || wider->facets.size() < region.facets.size() || !grower_.is_evident(*wider)) return region;
    const bool is_better =
        4 * wider->facets.size() >= 5 * region.facets.size() || 4 * wider->residual < region.residual;
    return is_better ? std::move(*wider) : std::move(region);
  }

  bool grow_from(int facet, const Few& beside) {
    const std::vector<int> nearby = around(facet, beside);
    const std::vector<Guess> guesses = guess(facet, beside, nearby);
    for (const Guess& g : guesses) {
      auto region = grower_.grow(g.surface, g.seeds);
      // No cone was tried where a cylinder explains all facets nearby.
      if (!region && guesses.size() == 1 && g.surface.kind == SurfaceKind::cylinder) region = cone_along(nearby);
      if (!region) continue;
      if (grower_.is_evident(*region)) {
        keep(or_cone(std::move(*region)), facet);
        return true;
      }
      if (region->surface.kind == SurfaceKind::sphere) remember_ring(*region, facet);
    }
    // Facets about as large as the seed would hardly do better.
    for (const int f : nearby) {
      const double ratio = facets_.facets[f].width / facets_.facets[facet].width;
      if (ratio > 0.4 && ratio < 2.5 && failures_[f] < enough_failures) ++failures_[f];
    }
    failures_[facet] = enough_failures;
    return false;
  }

  const Facets& facets_;
  const Progress& progress_;
  Wanted wanted_;
  RoundRegions found_;
  std::vector<Origin> origins_;  ///< of the regions
  int stage_ = 0;
  int next_ = 0;
  std::vector<char> failures_;  ///< by facet: failed seeds nearby
  std::vector<int> stamp_, vertex_stamp_;
  int number_ = 0, vertex_number_ = 0;
  std::vector<Neighbour> around_facet_;
  std::vector<int> neighbours_at_, neighbours_;  ///< for each facet, where its list begins: the number of neighbours,
                                                 ///< then the neighbours
  std::vector<Ring> rings_;
  std::vector<char> in_ring_;  ///< whether a facet is in one of the rings
  RegionGrower grower_;
};

/// Searches all clusters in parallel.
class SideBySide {
 public:
  SideBySide(const Facets& all, const Progress& progress, Wanted wanted)
      : all_(all), wanted_(wanted), clusters_(clusters_of(all)) {
    for (const Cluster& cluster : clusters_) searches_.emplace_back(cluster.facets(all), progress, wanted);
  }

  RoundRegions run() {
    pass(false);
    if (!has_regions() && !grow_rings()) return joined();
    // With known neighbours, narrow regions turn out to be tangent to them.
    begin_pass();
    pass(true);
    if (grow_rings()) {
      begin_pass();
      pass(true);
    }
    return joined();
  }

 private:
  template <class Do>
  void for_each(const Do& act) {
    parallel_for(searches_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) act(c);
    });
  }

  // All clusters advance together, largest facets first: the attempts in one depend slightly on the results in others,
  // but never on which thread was faster.
  void pass(bool beside_regions) {
    Effort effort{wanted_ == Wanted::cylinders ? seeds_for_one_cylinder : seeds_for_one};
    const auto count = static_cast<int>(all_.facets.size());
    const int window = clusters_.size() > 1 ? facets_at_once : count;
    for (int end = std::min(window, count);; end = std::min(end + window, count)) {
      std::vector<std::vector<Try>> tries(searches_.size());
      for_each([&](std::size_t c) { tries[c] = searches_[c].advance(local(c, end), beside_regions, effort); });
      for (const Try& one : in_order(std::move(tries))) {
        effort.add(one.found);
        if (effort.is_hopeless()) return drop_from(one.facet + 1);
      }
      if (end == count) return;
    }
  }

  // Drops what clusters found beyond the facet at which the search was abandoned.
  void drop_from(int end) {
    for_each([&](std::size_t c) { searches_[c].drop_from(local(c, end)); });
  }

  [[nodiscard]] std::vector<Try> in_order(std::vector<std::vector<Try>> tries) const {
    std::vector<Try> all;
    for (std::size_t c = 0; c < tries.size(); ++c)
      for (const Try& one : tries[c]) all.push_back({in_whole(c, one.facet), one.found});
    std::sort(all.begin(), all.end(), [](const Try& a, const Try& b) { return a.facet < b.facet; });
    return all;
  }

  [[nodiscard]] int in_whole(std::size_t cluster, int facet) const {
    const std::vector<int>& whole = clusters_[cluster].whole;
    return whole.empty() ? facet : whole[facet];
  }

  [[nodiscard]] bool has_regions() const {
    return std::any_of(searches_.begin(), searches_.end(), [](const Search& s) { return !s.origins().empty(); });
  }

  [[nodiscard]] int local(std::size_t cluster, int facet) const {
    const std::vector<int>& whole = clusters_[cluster].whole;
    if (whole.empty()) return facet;
    return static_cast<int>(std::lower_bound(whole.begin(), whole.end(), facet) - whole.begin());
  }

  void begin_pass() {
    for_each([&](std::size_t c) { searches_[c].begin_pass(); });
  }

  bool grow_rings() {
    std::vector<char> grown(searches_.size(), 0);
    for_each([&](std::size_t c) { grown[c] = searches_[c].grow_rings() ? 1 : 0; });
    return std::find(grown.begin(), grown.end(), 1) != grown.end();
  }

  RoundRegions joined() {
    if (searches_.size() == 1) return std::move(searches_.front().found());
    struct Number {
      Origin origin;
      std::size_t cluster, region;
    };
    std::vector<Number> order;
    for (std::size_t c = 0; c < searches_.size(); ++c)
      for (std::size_t r = 0; r < searches_[c].origins().size(); ++r) {
        const Origin& origin = searches_[c].origins()[r];
        order.push_back({{origin.stage, in_whole(c, origin.seed)}, c, r});
      }
    std::sort(order.begin(), order.end(), [](const Number& a, const Number& b) {
      return std::tie(a.origin, a.region) < std::tie(b.origin, b.region);
    });
    RoundRegions all{{}, std::vector<int>(all_.facets.size(), -1)};
    for (const Number& number : order) {
      Region region = std::move(searches_[number.cluster].found().regions[number.region]);
      for (int& f : region.facets) {
        f = in_whole(number.cluster, f);
        all.region_of[f] = static_cast<int>(all.regions.size());
      }
      all.regions.push_back(std::move(region));
    }
    return all;
  }

  const Facets& all_;
  Wanted wanted_;
  std::vector<Cluster> clusters_;
  std::deque<Search> searches_;
};

}  // namespace

RoundRegions find_round_regions(const Facets& facets, const Progress& progress, Wanted wanted) {
  return SideBySide(facets, progress, wanted).run();
}

}  // namespace epura::features
