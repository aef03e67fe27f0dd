// SPDX-License-Identifier: Apache-2.0
#include "surfaces/round_regions.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "surfaces/clusters.hpp"
#include "surfaces/limits.hpp"
#include "surfaces/seeds.hpp"

namespace epura::surfaces {

namespace {

constexpr int facets_at_once = 256;

/// Counts attempts: the longer few of them succeed, as in free forms, the fewer facets are tried.
struct Effort {
  int max_tried;  ///< seeds for each that grows
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

  [[nodiscard]] bool is_hopeless() const { return tried >= min_seeds && tried > max_tried * grown; }
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
        failures_(facets.facets.size(), 0),
        neighbours_(facets, found_.region_of),
        guesser_(facets, wanted),
        grower_(facets, found_.region_of, found_.regions) {
    found_.region_of.assign(facets.facets.size(), -1);
  }

  /// Starts again with the first facet.
  void begin_pass() {
    ++stage_;
    next_ = 0;
    std::fill(failures_.begin(), failures_.end(), char(0));
    first_valid_ = rejections_;
  }

  /// Tries the next facets up to `end`, given the effort so far.
  std::vector<Try> advance(int end, bool beside_regions, Effort effort) {
    std::vector<Try> tries;
    for (; next_ < end; ++next_) {
      const int f = next_;
      const int max_failures = effort.in_vain < 0 ? enough_failures : effort.in_vain < 256 ? 3 : 1;
      const Facet& facet = facets_.facets[f];
      if (region_of(f) >= 0 || failures_[f] >= max_failures || facet.is_plane || facets_.is_sliver(f)) continue;
      if (beside_regions && !is_beside_region(f)) continue;
      const Few beside = neighbours_.beside(f);
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
  [[nodiscard]] Regions& found() { return found_; }

 private:
  [[nodiscard]] int region_of(int facet) const { return found_.region_of[facet]; }

  [[nodiscard]] bool is_beside_region(int facet) const {
    bool found = false;
    facets_.for_sides(facet, [&](int, int, int other) { found = found || region_of(other) >= 0; });
    return found;
  }

  void keep(Region region, int seed) {
    origins_.push_back({stage_, seed});
    for (const int f : region.facets) found_.region_of[f] = static_cast<int>(found_.regions.size());
    found_.regions.push_back(std::move(region));
    first_valid_ = rejections_;
  }

  // A region that is not evident would grow from most of its facets.
  void reject(const Region& region, int seed) {
    std::vector<int>& in = rejected_[static_cast<std::size_t>(region.surface.kind)];
    in.resize(facets_.facets.size(), -1);
    for (const int f : region.facets) in[f] = rejections_;
    ++rejections_;
    if (region.surface.kind != SurfaceKind::sphere) return;
    if (const auto simpler = grower_.simpler_than(region)) rings_.push_back({*simpler, region.facets, seed});
  }

  /// Whether all that speaks for a guess lies in one region of this kind that was rejected.
  [[nodiscard]] bool is_rejected(const Guess& guess, std::span<const int> nearby) const {
    const std::vector<int>& in = rejected_[static_cast<std::size_t>(guess.surface.kind)];
    const int rejection = in.empty() ? -1 : in[guess.seeds.front()];
    const auto is_there = [&](int f) { return in[f] == rejection; };
    return rejection >= first_valid_ && std::ranges::all_of(guess.seeds, is_there) &&
           std::cmp_greater_equal(std::ranges::count_if(nearby, is_there), guess.explained);
  }

  std::optional<Region> cone_along(std::span<const int> facets) {
    const auto cone = guesser_.cone_through(facets);
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
    const std::vector<int> nearby = neighbours_.around(facet, beside);
    const std::vector<Guess> guesses = guesser_.guesses_at(facet, beside.all(), nearby);
    for (const Guess& g : guesses) {
      if (is_rejected(g, nearby)) continue;
      auto region = grower_.grow(g.surface, g.seeds);
      // No cone was tried where a cylinder explains all facets nearby.
      if (!region && guesses.size() == 1 && g.surface.kind == SurfaceKind::cylinder) region = cone_along(nearby);
      if (!region) continue;
      if (grower_.is_evident(*region)) {
        keep(or_cone(std::move(*region)), facet);
        return true;
      }
      reject(*region, facet);
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
  Regions found_;
  std::vector<Origin> origins_;  ///< of the regions
  int stage_ = 0;
  int next_ = 0;
  std::vector<char> failures_;  ///< by facet: failed seeds nearby
  SmoothNeighbours neighbours_;
  Guesser guesser_;
  std::vector<Ring> rings_;
  /// By kind of surface and facet, the number of the last region that was not evident; -1 for none.
  std::array<std::vector<int>, surface_kind_names.size()> rejected_;
  int rejections_ = 0;
  int first_valid_ = 0;  ///< earlier rejections may not hold any more: regions that were found since prove others
  RegionGrower grower_;
};

/// Searches all clusters in parallel.
class SideBySide {
 public:
  SideBySide(const Facets& all, const Progress& progress, Wanted wanted)
      : all_(all), wanted_(wanted), clusters_(clusters_of(all)) {
    for (const Cluster& cluster : clusters_) searches_.emplace_back(cluster.facets(all), progress, wanted);
  }

  Regions run() {
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

  Regions joined() {
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
    Regions all{{}, std::vector<int>(all_.facets.size(), -1)};
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

Regions find_round_regions(const Facets& facets, const Progress& progress, Wanted wanted) {
  return SideBySide(facets, progress, wanted).run();
}

}  // namespace epura::surfaces
