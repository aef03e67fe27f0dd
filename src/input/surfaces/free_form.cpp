// SPDX-License-Identifier: Apache-2.0
#include "surfaces/free_form.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "surfaces/chords.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

class Completion {
 public:
  Completion(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions)
      : facets_(facets), region_of_(region_of), regions_(regions), sets_(facets.facets.size()) {}

  void run() {
    find_largest_folds();
    for (int f = 0; f < size(); ++f)
      if (is_loose(f)) join_smooth_neighbours(f);
    for (int i = 0; i < max_between && join_narrow_triangles(); ++i) continue;
    make_regions();
    give_slivers_away();
  }

 private:
  [[nodiscard]] int size() const { return static_cast<int>(facets_.facets.size()); }
  /// Whether a facet is neither on a round surface nor clearly a plane.
  [[nodiscard]] bool is_loose(int f) const {
    return region_of_[f] < 0 && !facets_.facets[f].is_plane && !facets_.is_sliver(f);
  }

  // Finds the two largest smooth folds of each facet, and the neighbour at the largest.
  void find_largest_folds() {
    folds_.assign(facets_.facets.size(), {});
    for (int f = 0; f < size(); ++f) {
      if (!is_loose(f)) continue;
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (facets_.is_sliver(other)) return;
        const double angle = facets_.fold_at(t, side);
        Folds& own = folds_[f];
        if (angle > max_smooth || other == own.neighbour) return;
        if (angle > own.largest)
          own = {angle, own.largest, other};
        else
          own.second = std::max(own.second, angle);
      });
    }
  }

  // The largest smooth fold of a facet other than that to a neighbour.
  [[nodiscard]] double fold_beside(int facet, int neighbour) const {
    return folds_[facet].neighbour == neighbour ? folds_[facet].second : folds_[facet].largest;
  }

  [[nodiscard]] bool is_polygon(int facet) const { return facets_.vertices_of(facet).size() > 3; }

  // The same if the facet is one half of a nearly flat pair of triangles: the largest fold beside the other half.
  [[nodiscard]] double fold_behind(int facet, int neighbour, double angle) const {
    double largest = 0;
    facets_.for_sides(facet, [&](int t, int side, int half) {
      if (half != neighbour && is_loose(half) && 4 * facets_.fold_at(t, side) < angle)
        largest = std::max(largest, fold_beside(half, facet));
    });
    return largest;
  }

  // How far a facet extends from a side of one of its triangles.
  [[nodiscard]] double reach(int facet, const Vec3& from, const Vec3& to) const {
    const Vec3 along = glm::normalize(to - from);
    double reach = 0;
    for (const int v : facets_.vertices_of(facet))
      reach = std::max(reach, glm::length(glm::cross(facets_.points[v] - from, along)));
    return reach;
  }

  void join_smooth_neighbours(int f) {
    facets_.for_sides(f, [&](int t, int side, int other) {
      if (other < f || !is_loose(other)) return;
      const double angle = facets_.fold_at(t, side);
      if (angle > max_smooth) return;
      const auto is_usual = [&](double usual) { return angle <= fold_ratio * usual + fold_slack; };
      if (!is_usual(std::max(fold_beside(f, other), fold_beside(other, f))) &&
          !is_usual(std::max(fold_behind(f, other, angle), fold_behind(other, f, angle))))
        return;
      const auto [a, b] = facets_.ends_of(t, side);
      const double one = reach(f, a, b), two = reach(other, a, b);
      const double max_ratio =
          angle > coarse_fold && is_polygon(f) && is_polygon(other) ? similar_width_ratio : width_ratio;
      if (one > max_ratio * two || two > max_ratio * one) return;
      sets_.join(f, other);
    });
  }

  [[nodiscard]] std::vector<int> count_members() {
    std::vector<int> members(facets_.facets.size(), 0);
    for (int f = 0; f < size(); ++f)
      if (is_loose(f)) ++members[sets_.root(f)];
    return members;
  }

  [[nodiscard]] bool is_narrow(int t, int side, int facet) const {
    return !is_polygon(facet) && facets_.length_of(t, side) > narrow * facets_.facets[facet].width;
  }

  // Narrow triangles between a long chord of a free form's border and a vertex close to it tilt. A set that contains
  // only such triangles belongs to the face beyond one of their long sides. Returns whether there was any.
  bool join_narrow_triangles() {
    const std::vector<int> members = count_members();
    struct Join {
      double fold = max_smooth;
      int facet = -1, other = -1;
    };
    std::vector<Join> joins(facets_.facets.size());
    std::vector<char> has_wide(facets_.facets.size(), 0);
    for (int f = 0; f < size(); ++f) {
      if (!is_loose(f)) continue;
      const int root = sets_.root(f);
      bool is_wide = true;
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (!is_narrow(t, side, f)) return;
        is_wide = false;
        if (!is_loose(other) || members[sets_.root(other)] < 3 || sets_.root(other) == root) return;
        if (const double fold = facets_.fold_at(t, side); fold < joins[root].fold) joins[root] = {fold, f, other};
      });
      if (is_wide) has_wide[root] = 1;
    }
    bool any = false;
    for (int root = 0; root < size(); ++root)
      if (joins[root].other >= 0 && has_wide[root] == 0) {
        sets_.join(joins[root].facet, joins[root].other);
        any = true;
      }
    return any;
  }

  void make_regions() {
    const std::vector<int> members = count_members();
    std::vector<int> region_of_set(facets_.facets.size(), -1);
    for (int f = 0; f < size(); ++f) {
      if (region_of_[f] >= 0 || facets_.is_sliver(f)) continue;
      int& region = region_of_set[sets_.root(f)];
      if (region < 0) {
        region = static_cast<int>(regions_.size());
        regions_.push_back({});
        if (members[sets_.root(f)] < 3) regions_.back().surface = plane_of(f, regions_.back().residual);
      }
      region_of_[f] = region;
      regions_[region].facets.push_back(f);
    }
    // Two facets are too few for a free form; the second one becomes a plane of its own.
    const int before = static_cast<int>(regions_.size());
    for (int r = 0; r < before; ++r) {
      if (regions_[r].surface.kind != SurfaceKind::plane || regions_[r].facets.size() != 2) continue;
      const int second = regions_[r].facets.back();
      regions_[r].facets.pop_back();
      region_of_[second] = static_cast<int>(regions_.size());
      regions_.push_back({});
      regions_.back().facets = {second};
      regions_.back().surface = plane_of(second, regions_.back().residual);
    }
  }

  // A polygon of the file may be bent.
  [[nodiscard]] PartSurface plane_of(int facet, double& residual) const {
    std::vector<Vec3> points;
    for (const int v : facets_.vertices_of(facet)) points.push_back(facets_.points[v]);
    PartSurface plane{SurfaceKind::plane, facets_.facets[facet].middle, facets_.facets[facet].normal};
    residual = residual_of(plane, points);
    if (residual <= 4 * facets_.tolerance) return plane;
    residual = 0;
    return {};
  }

  // Assigns slivers to the neighbour on whose surface they lie, otherwise to the one beyond their longest side.
  void give_slivers_away() {
    for (bool changed = true; changed;) {
      changed = false;
      for (int f = 0; f < size(); ++f) {
        if (region_of_[f] >= 0) continue;
        const int region = best_region_beside(f);
        if (region < 0) continue;
        region_of_[f] = region;
        regions_[region].facets.push_back(f);
        changed = true;
      }
    }
    for (int f = 0; f < size(); ++f)
      if (region_of_[f] < 0) {
        region_of_[f] = static_cast<int>(regions_.size());
        regions_.push_back({});
        regions_.back().facets = {f};
      }
  }

  [[nodiscard]] int best_region_beside(int facet) const {
    int best = -1;
    std::pair<bool, double> best_claim{false, -1};
    facets_.for_sides(facet, [&](int t, int side, int other) {
      const int region = region_of_[other];
      if (region < 0) return;
      const double length = facets_.length_of(t, side);
      const std::pair<bool, double> claim{lies_on(facet, regions_[region]), length};
      if (best >= 0 && claim <= best_claim) return;
      best = region;
      best_claim = claim;
    });
    return best;
  }

  [[nodiscard]] bool lies_on(int facet, const Region& region) const {
    if (region.surface.kind == SurfaceKind::free_form) return false;
    const auto vertices = facets_.vertices_of(facet);
    return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
      return std::abs(signed_distance(region.surface, facets_.points[v])) <= allowance_of(facets_, region.sagitta);
    });
  }

  struct Folds {
    double largest = 0, second = 0;
    int neighbour = -1;
  };

  const Facets& facets_;
  std::vector<int>& region_of_;
  std::vector<Region>& regions_;
  DisjointSets sets_;
  std::vector<Folds> folds_;
};

bool lies_on(const Facets& facets, const Region& region, const PartSurface& surface, double sagitta) {
  const double allowance = allowance_of(facets, sagitta);
  const std::span<const int> exact = region.exact_facets();
  return std::all_of(exact.begin(), exact.end(),
                     [&](int f) { return approximates(facets, f, surface, allowance, sagitta); });
}

// Where the normal of a torus is parallel to its axis, its facets form a flat ring, or parts of it.
bool is_ring_of_torus(const Facets& facets, const Region& flat, const Region& torus) {
  if (torus.surface.kind != SurfaceKind::torus || !are_chords(facets, flat, torus)) return false;
  return glm::length(glm::cross(torus.surface.axis, flat.surface.axis)) <= told_apart_sine ||
         (flat.facets.size() == 1 && facets.vertices_of(flat.facets.front()).size() <= corners_in_ring);
}

// Whether the region with fewer facets, which determine its surface less precisely, is a part of the other one.
bool is_one_face(const Facets& facets, const Region& one, const Region& two) {
  const auto& [smaller, larger] = one.facets.size() < two.facets.size() ? std::tie(one, two) : std::tie(two, one);
  if (larger.surface.kind == SurfaceKind::free_form) return false;
  if (larger.surface.kind == SurfaceKind::plane)
    return smaller.surface.kind == SurfaceKind::plane && lies_on(facets, smaller, larger.surface, larger.sagitta);
  if (smaller.surface.kind == SurfaceKind::plane) return is_ring_of_torus(facets, smaller, larger);
  return lies_on(facets, smaller, larger.surface, larger.sagitta) ||
         (2 * smaller.facets.size() < larger.facets.size() && are_chords(facets, smaller, larger));
}

std::size_t count_distinct(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

// Whether all vertices of a region lie on its border.
bool has_no_vertex_inside(const Facets& facets, const std::vector<int>& region_of, const Region& region, int number) {
  std::vector<int> all, ends;
  for (const int f : region.facets) {
    facets.for_sides(f, [&](int t, int side, int other) {
      if (region_of[other] == number) return;
      ends.push_back(facets.corners[t][side]);
      ends.push_back(facets.corners[t][(side + 1) % 3]);
    });
    const auto vertices = facets.vertices_of(f);
    all.insert(all.end(), vertices.begin(), vertices.end());
  }
  return count_distinct(ends) == count_distinct(all);
}

// Whether a region is a row of another one's facets: two circles about one axis lie on a cone, whatever lies between
// them. The vertices of an inexact face lie off its surface, but not off those of its rows. A row that continues the
// other face without an edge may be a face by itself, unless it lies below a sphere as what is left of cut facets does:
// a tangent face rises from it.
bool is_row_of(const Facets& facets, const Regions& found, int row, int face) {
  const Region &some = found.regions[row], &of = found.regions[face];
  const SurfaceKind kind = of.surface.kind;
  if (kind == SurfaceKind::plane || kind == SurfaceKind::free_form || some.surface.kind == SurfaceKind::plane ||
      some.surface.kind == SurfaceKind::free_form || 2 * some.facets.size() >= of.facets.size())
    return false;
  if (!has_no_vertex_inside(facets, found.region_of, some, row)) return false;
  if (are_left_of_sphere(facets, some, of)) return true;
  bool folds = false;
  for (const int f : some.facets)
    facets.for_sides(f, [&](int t, int side, int other) {
      if (found.region_of[other] != face) return;
      const Vec3 end = facets.ends_of(t, side)[0];
      const double cosine = std::abs(glm::dot(normal_near(some.surface, end), normal_near(of.surface, end)));
      folds = folds || cosine < tangent_cosine;
    });
  return folds && are_chords(facets, some, of, trimmed_allowance_of(facets, of.sagitta));
}

/// Finds strips of spheres, cylinders and cones that are rows of a free form's tessellation. Two circles about one axis
/// always lie on a sphere; strips of cylinders and cones lie beside facets of a free form, or several lie side by side.
/// So are regions of cylinders and cones of which vertices lie off the surface by more than rounding, beside facets of
/// a free form or other such regions along their generators: over a short way, any curve is nearly an arc.
class Rows {
 public:
  Rows(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions)
      : facets_(facets), region_of_(region_of), strips_(regions.size()), is_row_(regions.size()) {
    for (std::size_t r = 0; r < regions.size(); ++r) strips_[r] = strip_of(regions[r], static_cast<int>(r));
    for (std::size_t r = 0; r < regions.size(); ++r) flanks_.push_back(flanks_of(regions[r], static_cast<int>(r)));
    for (std::size_t r = 0; r < regions.size(); ++r) is_row_[r] = is_strip_of_sphere(regions[r], static_cast<int>(r));
  }

  std::vector<char> find() {
    find_chains();
    find_long_chains();
    // A row may only be recognised by the next one.
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t r = 0; r < strips_.size(); ++r)
        if (is_row_[r] == 0 && (lies_beside_free_form(strips_[r]) || continues_in_free_form(flanks_[r])))
          is_row_[r] = changed = true;
    }
    return is_row_;
  }

 private:
  /// A part of a long side at which the surface continues with a fold typical of tessellations, and with facets of
  /// similar width.
  struct LongSide {
    int beyond;  ///< facet
    double length, fold;
    bool convex;
  };

  /// A region that is one facet wide; any other region has no sides here.
  struct Strip {
    std::vector<LongSide> sides;
    std::vector<int> beyond{};  ///< facets beyond long sides without a sharp fold, also where it is flat
    double across = 0;          ///< total length of all long sides
  };

  /// The sides of an inexact region along its generators; any other region has none here.
  struct Flanks {
    std::vector<LongSide> smooth;
    double length = 0;  ///< of all of them
  };

  [[nodiscard]] Flanks flanks_of(const Region& region, int number) const {
    const SurfaceKind kind = region.surface.kind;
    if (kind != SurfaceKind::cylinder && kind != SurfaceKind::cone) return {};
    if (region.residual <= facets_.tolerance / 2 || sweep_of(region) > max_row_sweep) return {};
    Flanks flanks;
    for (const int f : region.facets)
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (region_of_[other] == number || !runs_along(region.surface, t, side)) return;
        const double length = facets_.length_of(t, side), fold = facets_.fold_at(t, side);
        flanks.length += length;
        if (fold < max_smooth) flanks.smooth.push_back({other, length, fold, is_convex(f, other)});
      });
    return flanks;
  }

  [[nodiscard]] double sweep_of(const Region& region) const {
    std::vector<Vec3> points;
    for (const int f : region.facets)
      for (const int v : facets_.vertices_of(f)) points.push_back(facets_.points[v]);
    return reach_of(region.surface, points, allowance_of(facets_, region.sagitta)).sweep;
  }

  [[nodiscard]] bool continues_in_free_form(const Flanks& flanks) const {
    double free = 0;
    for (const LongSide& side : flanks.smooth)
      if (is_free(side.beyond) || (region_of_[side.beyond] >= 0 && !flanks_[region_of_[side.beyond]].smooth.empty()))
        free += side.length;
    return free > 0.25 * flanks.length;
  }

  [[nodiscard]] Strip strip_of(const Region& region, int number) const {
    const SurfaceKind kind = region.surface.kind;
    if (kind != SurfaceKind::cylinder && kind != SurfaceKind::cone) return {};
    Strip strip;
    std::size_t at_border = 0;
    for (const int f : region.facets) {
      const double before = strip.across;
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (region_of_[other] != number) add_side(strip, region.surface, t, side);
      });
      at_border += strip.across > before ? 1 : 0;
    }
    return 10 * at_border > 9 * region.facets.size() ? strip : Strip{};
  }

  [[nodiscard]] bool is_strip_of_sphere(const Region& region, int number) const {
    if (region.surface.kind != SurfaceKind::sphere) return false;
    const auto at_border = std::count_if(region.facets.begin(), region.facets.end(), [&](int f) {
      bool is_at_border = false;
      facets_.for_sides(f, [&](int, int, int other) { is_at_border = is_at_border || region_of_[other] != number; });
      return is_at_border;
    });
    return 10 * at_border > 9 * static_cast<std::ptrdiff_t>(region.facets.size()) &&
           has_no_vertex_inside(facets_, region_of_, region, number);
  }

  void add_side(Strip& strip, const PartSurface& surface, int triangle, int side) const {
    if (runs_along(surface, triangle, side)) return;
    const double length = facets_.length_of(triangle, side);
    strip.across += length;
    const int other = facets_.facet_of[facets_.sides[triangle][side].neighbour];
    const double ratio = facets_.facets[other].width / facets_.facets[facets_.facet_of[triangle]].width;
    const double fold = facets_.fold_at(triangle, side);
    if (ratio < 1 / similar_width_ratio || ratio > similar_width_ratio || fold > max_smooth) return;
    strip.beyond.push_back(other);
    if (fold > min_row_fold) strip.sides.push_back({other, length, fold, is_convex(facets_.facet_of[triangle], other)});
  }

  // Whether a side runs along the generators rather than across them.
  [[nodiscard]] bool runs_along(const PartSurface& surface, int triangle, int side) const {
    const auto [a, b] = facets_.ends_of(triangle, side);
    return std::abs(glm::dot(b - a, generator(surface, a))) > 0.7 * glm::distance(a, b);
  }

  [[nodiscard]] bool is_convex(int facet, int other) const {
    return glm::dot(facets_.facets[facet].normal, facets_.facets[other].middle - facets_.facets[facet].middle) < 0;
  }

  [[nodiscard]] static Vec3 generator(const PartSurface& surface, const Vec3& point) {
    const Vec3 around = glm::cross(surface.axis, point - surface.origin);
    const Vec3 along = glm::cross(around, normal_near(surface, point));
    const double length = glm::length(along);
    return length > 0 ? along / length : surface.axis;
  }

  [[nodiscard]] bool lies_beside_free_form(const Strip& strip) const {
    double free = 0;
    for (const LongSide& side : strip.sides)
      if (is_free(side.beyond)) free += side.length;
    return free > 0.25 * strip.across;
  }

  [[nodiscard]] bool is_free(int facet) const {
    const int region = region_of_[facet];
    return region < 0 ? !facets_.facets[facet].is_plane && !facets_.is_sliver(facet) : is_row_[region] != 0;
  }

  // Many adjacent strips that turn back at few of them: a surface of revolution over a curve.
  void find_long_chains() {
    DisjointSets sets(strips_.size());
    for (std::size_t r = 0; r < strips_.size(); ++r)
      for (const int facet : strips_[r].beyond) {
        const int other = region_of_[facet];
        if (other >= 0 && strips_[other].across > 0) sets.join(static_cast<int>(r), other);
      }
    std::vector<int> turned_back(strips_.size());
    for (std::size_t r = 0; r < strips_.size(); ++r) {
      const auto turns = [&](bool convex) {
        return std::any_of(strips_[r].sides.begin(), strips_[r].sides.end(),
                           [&](const LongSide& side) { return side.convex == convex; });
      };
      if (turns(true) && turns(false)) ++turned_back[sets.root(static_cast<int>(r))];
    }
    mark_rows(sets, [&](int root, int members) {
      return members >= min_rows_turning && max_turned_back * turned_back[root] <= members;
    });
  }

  template <class AreRows>
  void mark_rows(DisjointSets& sets, const AreRows& are_rows) {
    std::vector<int> members(strips_.size());
    for (std::size_t r = 0; r < strips_.size(); ++r) ++members[sets.root(static_cast<int>(r))];
    for (std::size_t r = 0; r < strips_.size(); ++r) {
      const int root = sets.root(static_cast<int>(r));
      if (are_rows(root, members[root])) is_row_[r] = 1;
    }
  }

  // Adjacent strips with folds of similar size.
  void find_chains() {
    DisjointSets sets(strips_.size());
    for (std::size_t r = 0; r < strips_.size(); ++r) {
      const auto [least, most] = std::minmax_element(strips_[r].sides.begin(), strips_[r].sides.end(),
                                                     [](const auto& a, const auto& b) { return a.fold < b.fold; });
      if (strips_[r].sides.empty() || most->fold > row_fold_ratio * least->fold) continue;
      double length = 0;
      for (const LongSide& side : strips_[r].sides) length += side.length;
      if (2 * length < strips_[r].across) continue;
      // The strips of a shoulder turn one way and back again.
      const bool convex = strips_[r].sides.front().convex;
      const auto turns_alike = [&](const LongSide& side) { return side.convex == convex; };
      if (!std::all_of(strips_[r].sides.begin(), strips_[r].sides.end(), turns_alike)) continue;
      for (const LongSide& side : strips_[r].sides) {
        const int other = region_of_[side.beyond];
        if (other >= 0 && !strips_[other].sides.empty()) sets.join(static_cast<int>(r), other);
      }
    }
    mark_rows(sets, [](int, int members) { return members >= min_rows; });
  }

  const Facets& facets_;
  const std::vector<int>& region_of_;
  std::vector<Strip> strips_;
  std::vector<Flanks> flanks_;
  std::vector<char> is_row_;
};

}  // namespace

Regions complete_regions(const Facets& facets, Regions found) {
  Completion(facets, found.region_of, found.regions).run();
  return found;
}

Regions dissolve_rows(const Facets& facets, Regions found, std::size_t first) {
  const std::vector<char> is_row = Rows(facets, found.region_of, found.regions).find();
  std::vector<int> number(found.regions.size(), -1);
  std::vector<Region> kept;
  for (std::size_t r = 0; r < found.regions.size(); ++r) {
    if (r >= first && is_row[r] != 0) continue;
    number[r] = static_cast<int>(kept.size());
    kept.push_back(std::move(found.regions[r]));
  }
  for (int& region : found.region_of)
    if (region >= 0) region = number[region];
  return {std::move(kept), std::move(found.region_of)};
}

Regions merge_regions(const Facets& facets, Regions found) {
  std::vector<Region>& regions = found.regions;
  std::vector<int>& region_of = found.region_of;
  std::vector<std::pair<int, int>> neighbours;
  for (std::size_t t = 0; t < facets.corners.size(); ++t)
    for (const Side& side : facets.sides[t]) {
      if (side.neighbour < 0) continue;
      const int one = region_of[facets.facet_of[t]], two = region_of[facets.facet_of[side.neighbour]];
      if (one >= 0 && one < two) neighbours.emplace_back(one, two);
    }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  DisjointSets sets(regions.size());
  const auto is_plane = [&](int r) { return regions[r].surface.kind == SurfaceKind::plane; };
  std::vector<char> is_taken(regions.size(), 0);  // a flat or row of a round face does not connect it with another
  const auto join_piece = [&](int piece, int face) {
    if (std::exchange(is_taken[piece], 1) == 0) sets.join(piece, face);
  };
  const auto join = [&](int one, int two) {
    if (is_plane(one) == is_plane(two))
      sets.join(one, two);
    else
      join_piece(is_plane(one) ? one : two, is_plane(one) ? two : one);
  };
  for (const auto& [one, two] : neighbours)
    if (is_one_face(facets, regions[one], regions[two]))
      join(one, two);
    else if (is_row_of(facets, found, one, two))
      join_piece(one, two);
    else if (is_row_of(facets, found, two, one))
      join_piece(two, one);
  for (int r = 0; r < static_cast<int>(regions.size()); ++r) {
    if (!is_plane(r) || regions[r].facets.size() > 1) continue;
    if (const int round = region_around(facets, regions[r].facets.front(), region_of, regions); round >= 0)
      join(r, round);
  }
  std::vector<int> number(regions.size(), -1);
  std::vector<Region> merged;
  std::vector<std::size_t> largest;  // size of the region to which each surface was fitted
  for (int r = 0; r < static_cast<int>(regions.size()); ++r) {
    const int root = sets.root(r);
    number[r] = number[root];
    if (root == r) {
      number[r] = static_cast<int>(merged.size());
      largest.push_back(regions[r].facets.size());
      merged.push_back(std::move(regions[r]));
      continue;
    }
    Region& to = merged[number[root]];
    const bool is_larger = regions[r].facets.size() > largest[number[root]];
    if (is_larger) {
      largest[number[root]] = regions[r].facets.size();
      to.surface = regions[r].surface;
      to.sagitta = regions[r].sagitta;
    }
    if (to.surface.kind == SurfaceKind::sphere && is_taken[is_larger ? root : r] != 0) {  // rows lie off it
      if (is_larger) std::swap(to.facets, regions[r].facets);
      to.exact = to.exact_facets().size();
    }
    to.facets.insert(to.facets.end(), regions[r].facets.begin(), regions[r].facets.end());
    to.residual = std::max(to.residual, regions[r].residual);
  }
  for (int& region : region_of)
    if (region >= 0) region = number[region];
  return {std::move(merged), std::move(region_of)};
}

}  // namespace epura::surfaces
