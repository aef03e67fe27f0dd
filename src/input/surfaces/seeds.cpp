// SPDX-License-Identifier: Apache-2.0
#include "surfaces/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "surfaces/estimates.hpp"
#include "surfaces/limits.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

namespace {

struct Neighbour {
  double length;  ///< total length of common edges
  int facet;
};

// Those with the longest common edges first, with or without a region.
std::vector<Neighbour> smooth_neighbours(const Facets& facets, int facet) {
  std::vector<Neighbour> found;
  facets.for_sides(facet, [&](int t, int side, int other) {
    if (facets.facets[other].is_plane || facets.is_sliver(other) || facets.cosine_of_fold(t, side) < smooth_cosine)
      return;
    const double length = facets.length_of(t, side);
    const auto same = std::find_if(found.begin(), found.end(), [&](const auto& n) { return n.facet == other; });
    if (same == found.end())
      found.push_back({length, other});
    else
      same->length += length;
  });
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.length != b.length ? a.length > b.length : a.facet < b.facet;
  });
  return found;
}

std::vector<Facing> facings_of(const Facets& facets, std::span<const int> some) {
  std::vector<Facing> facings;
  facings.reserve(some.size());
  for (const int f : some) facings.push_back({facets.facets[f].middle, facets.facets[f].normal, 1});
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

double sagitta_of(const Facets& facets, const PartSurface& surface, std::span<const int> some) {
  double sum = 0;
  for (const int f : some) sum += std::abs(signed_distance(surface, facets.facets[f].middle));
  return sum / static_cast<double>(some.size());
}

// The surface, fitted to a patch; nothing if the patch does not lie on it.
std::optional<Guess> guess_of(const Facets& facets, std::optional<PartSurface> surface, const Patch& patch) {
  if (!surface) return std::nullopt;
  const double residual = refine(*surface, patch.points, 64 * facets.tolerance);
  const double sagitta = sagitta_of(facets, *surface, patch.facets);
  const double allowance = allowance_of(facets, sagitta);
  if (residual > allowance || sagitta < 4 * residual) return std::nullopt;
  const int seed = patch.facets.front();
  std::size_t explained = 0;
  for (const int f : patch.nearby) {
    const bool fits = approximates(facets, f, *surface, (f == seed ? 1 : 8) * allowance, sagitta);
    if (f == seed && !fits) return std::nullopt;
    explained += fits ? 1 : 0;
  }
  // A surface through just as many points as determine it proves nothing unless it predicts other facets.
  const auto spare = static_cast<int>(patch.points.size()) - unknowns_of(surface->kind);
  if (explained < 2 || (explained <= patch.facets.size() && spare < 2)) return std::nullopt;
  return Guess{*surface, {patch.facets.begin(), patch.facets.end()}, explained};
}

// With a guess, if it explains more facets nearby than the last one of its kind.
std::vector<Guess> with_guess(std::vector<Guess> guesses, std::optional<Guess> guess) {
  if (!guess) return guesses;
  const auto same = std::find_if(guesses.begin(), guesses.end(),
                                 [&](const Guess& g) { return g.surface.kind == guess->surface.kind; });
  if (same == guesses.end())
    guesses.push_back(std::move(*guess));
  else if (guess->explained > same->explained)
    *same = std::move(*guess);
  return guesses;
}

// With guesses at a strip. Three facets of one along a surface give such a good estimate that little is left to refine.
std::vector<Guess> with_strip(std::vector<Guess> guesses, const Facets& facets, Wanted wanted, const Patch& patch) {
  const auto guess_near = [&](const std::optional<PartSurface>& surface) {
    return surface && residual_of(*surface, patch.points) < 0.25 * sagitta_of(facets, *surface, patch.facets)
               ? guess_of(facets, surface, patch)
               : std::nullopt;
  };
  guesses = with_guess(std::move(guesses), guess_near(begin_cylinder(patch.facings, patch.points)));
  if (wanted == Wanted::cylinders) return guesses;
  if (!guesses.empty() && guesses.front().explained == patch.nearby.size()) return guesses;
  guesses = with_guess(std::move(guesses), guess_near(begin_cone(patch.facings, patch.points)));
  if (patch.points.size() < 5) return guesses;
  return with_guess(std::move(guesses), guess_near(begin_sphere(patch.points)));
}

// With guesses at a larger patch.
std::vector<Guess> with_patch(std::vector<Guess> guesses, const Facets& facets, Wanted wanted, const Patch& patch) {
  guesses = with_guess(std::move(guesses), guess_of(facets, begin_cylinder(patch.facings, patch.points), patch));
  if (wanted == Wanted::cylinders) return guesses;
  const auto curvatures = curvatures_of(patch.facings.front(), patch.points);
  const auto by_curvatures = [&](const auto& begin) {
    return curvatures ? begin(*curvatures, patch.points) : std::nullopt;
  };
  auto cone = guess_of(facets, begin_cone(patch.facings, patch.points), patch);
  if (!cone) cone = guess_of(facets, by_curvatures(begin_cone_by_curvatures), patch);
  guesses = with_guess(std::move(guesses), std::move(cone));
  auto torus = guess_of(facets, begin_torus_by_normals(patch.facings, patch.points), patch);
  if (!torus) torus = guess_of(facets, by_curvatures(begin_torus_by_curvatures), patch);
  return with_guess(std::move(guesses), std::move(torus));
}

}  // namespace

Few SmoothNeighbours::beside(int facet) {
  if (first_[facet] < 0) {
    first_[facet] = static_cast<int>(lists_.size());
    const std::vector<Neighbour> list = smooth_neighbours(facets_, facet);
    lists_.push_back(static_cast<int>(list.size()));
    for (const Neighbour& n : list) lists_.push_back(n.facet);
  }
  Few beside;
  const auto first = static_cast<std::size_t>(first_[facet]);
  for (const int other : std::span(lists_).subspan(first + 1, static_cast<std::size_t>(lists_[first])))
    if (region_of_[other] < 0 && beside.count < beside.facets.size()) beside.facets[beside.count++] = other;
  return beside;
}

std::vector<int> SmoothNeighbours::around(int facet, const Few& beside_it) {
  ++number_;
  std::vector<int> nearby{facet};
  stamp_[facet] = number_;
  const auto take = [&](const Few& more) {
    for (const int f : more.all())
      if (stamp_[f] != number_ && nearby.size() < max_nearby) {
        stamp_[f] = number_;
        nearby.push_back(f);
      }
  };
  take(beside_it);
  for (std::size_t i = 1; i < nearby.size() && nearby.size() < max_nearby; ++i) take(beside(nearby[i]));
  return nearby;
}

std::vector<Vec3> Guesser::points_of(std::span<const int> facets) {
  ++number_;
  std::vector<Vec3> points;
  points.reserve(4 * facets.size());
  for (const int f : facets)
    for (const int v : facets_.supports_of(f))
      if (std::exchange(stamp_[v], number_) != number_) points.push_back(facets_.points[v]);
  return points;
}

std::optional<PartSurface> Guesser::cone_through(std::span<const int> facets) {
  return begin_cone(facings_of(facets_, facets), points_of(facets));
}

std::vector<Guess> Guesser::guesses_at(int facet, std::span<const int> beside, std::span<const int> nearby) {
  std::vector<Guess> guesses;
  const auto patch_of = [&](std::span<const int> facets) {
    return Patch{facets, nearby, points_of(facets), facings_of(facets_, facets)};
  };
  const auto try_strip = [&](std::initializer_list<int> seeds) {
    guesses = with_strip(std::move(guesses), facets_, wanted_, patch_of(std::span(seeds.begin(), seeds.size())));
  };
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
  while (size < nearby.size() && size < 13 && points_of(nearby.first(size)).size() < enough_vertices) ++size;
  if (size >= 7) guesses = with_patch(std::move(guesses), facets_, wanted_, patch_of(nearby.first(size)));
  std::sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) {
    return a.explained != b.explained ? a.explained > b.explained : a.surface.kind < b.surface.kind;
  });
  return guesses;
}

}  // namespace epura::surfaces
