// SPDX-License-Identifier: Apache-2.0
#include "verify/judge.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "verify/probe_grid.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t rays_at_once = 4096;
// Area of the square of rays, whose total is 4, that may stay uncovered where triangles join.
constexpr double min_gap = 0.01;

struct Met {
  int probe;
  Portion portion;
};

// Returns for each portion the number of its component: the triangles connected by common edges.
std::vector<int> connected_parts(const world::World& world, const std::vector<Portion>& portions) {
  DisjointSets parts(portions.size());
  std::map<std::pair<int, int>, int> owner;
  for (int i = 0; i < static_cast<int>(portions.size()); ++i) {
    const auto& corner = world.triangles[portions[i].triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, other] = std::minmax(corner[k], corner[(k + 1) % 3]);
      parts.join(i, owner.try_emplace({first, other}, i).first->second);
    }
  }
  return std::move(parts).roots();
}

// Whether connected triangles cover the square. Unconnected triangles that merely abut on the page leave a gap when one
// of them moves by less than the tolerance.
bool covered(const world::World& world, const std::vector<Portion>& portions) {
  std::map<int, std::vector<ConvexPolygon>> parts;
  const std::vector<int> part = connected_parts(world, portions);
  for (std::size_t i = 0; i < portions.size(); ++i) parts[part[i]].push_back(portions[i].corner);
  return std::ranges::any_of(parts, [](const auto& one) { return uncovered(one.second) < min_gap; });
}

class Judge {
 public:
  Judge(const VerifyInput& input, const Tolerance& tolerance, std::span<const Probe> probes, bool name_facets)
      : input_(input),
        viewing_(viewing_of(input)),
        probes_(probes),
        name_facets_(name_facets),
        frame_(sight_from(viewing_, to_page(probes[0])), 4 * tolerance.sideways()),
        grid_(extents()),
        settled_(probes.size()),
        doubted_(probes.size()) {
    for (const Probe& probe : probes) lookouts_.emplace_back(viewing_, tolerance, line_of(probe), probe.t);
  }

  std::vector<ProbeVerdict> verdicts(const Progress& progress) {
    const std::size_t count = input_.world.triangles.size();
    std::vector<std::vector<Met>> met((count + rays_at_once - 1) / rays_at_once);
    progress.begin("verifying", met.size());
    parallel_for(met.size(), 1, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part)
        for (std::size_t t = part * rays_at_once; t < std::min((part + 1) * rays_at_once, count); ++t) {
          progress.expect_time();
          meet(static_cast<int>(t), met[part]);
        }
      progress.advance(last - first);
    });
    std::vector<std::vector<Portion>> portions(probes_.size());
    for (std::vector<Met>& part : met)
      for (Met& one : part) portions[one.probe].push_back(std::move(one.portion));
    std::vector<ProbeVerdict> verdicts(probes_.size());
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      progress.expect_time();
      verdicts[i] = verdict_of(i, portions[i]);
    }
    return verdicts;
  }

 private:
  [[nodiscard]] std::array<Vec3, 2> line_of(const Probe& probe) const {
    return input_.ends_of(input_.drawn.edges[probe.edge]);
  }
  [[nodiscard]] Triple<Bounded> to_page(const Probe& probe) const {
    return position_on<Bounded>(line_of(probe), probe.t);
  }

  [[nodiscard]] std::vector<Extent> extents() const {
    std::vector<Extent> list;
    for (const Probe& probe : probes_) list.push_back(frame_.extent_of(to_page(probe)));
    return list;
  }

  // Records what one triangle does to all probes. A probe that is certainly hidden needs no further triangles.
  void meet(int triangle, std::vector<Met>& met) {
    const auto& vertex = input_.world.triangles[triangle];
    const auto& points = input_.world.points;
    const std::array corners{points[vertex[0]], points[vertex[1]], points[vertex[2]]};
    const std::optional<Extent> extent = frame_.extent_of(corners);
    if (!extent) return;
    grid_.overlapping(*extent, [&](int probe) {
      if (settled_[probe].load(std::memory_order_relaxed) && !name_facets_) return;
      const edges::FeatureEdge& edge = input_.drawn.edges[probes_[probe].edge];
      if (input_.contains(edge, triangle)) return;
      auto portion = lookouts_[probe].look(corners, triangle, input_.joined(edge, triangle));
      if (!portion) return;
      if (!portion->in_front) return doubted_[probe].store(true, std::memory_order_relaxed);
      if (uncovered({portion->corner}) < min_gap) settled_[probe].store(true, std::memory_order_relaxed);
      met.push_back({probe, std::move(*portion)});
    });
  }

  [[nodiscard]] ProbeVerdict verdict_of(std::size_t probe, const std::vector<Portion>& portions) const {
    if (portions.empty() && !doubted_[probe]) return {};
    if (!settled_[probe] && !covered(input_.world, portions)) return {ProbeAnswer::undecided};
    const auto nearest = std::ranges::min_element(portions, {}, &Portion::depth);
    return {ProbeAnswer::hidden, name_facets_ ? nearest->triangle : -1};
  }

  const VerifyInput& input_;
  Viewing viewing_;
  std::span<const Probe> probes_;
  bool name_facets_;
  PageFrame frame_;
  ProbeGrid grid_;
  std::vector<Lookout> lookouts_;
  std::vector<std::atomic<bool>> settled_;  ///< certainly hidden by one triangle
  std::vector<std::atomic<bool>> doubted_;  ///< perhaps hidden by one triangle
};

}  // namespace

std::vector<ProbeVerdict> judge(const VerifyInput& input, const Tolerance& tolerance, std::span<const Probe> probes,
                                bool name_facets, const Progress& progress) {
  if (probes.empty()) return {};
  return Judge(input, tolerance, probes, name_facets).verdicts(progress);
}

namespace {

// Pieces with a smaller area are due to rounding.
constexpr double min_area = 1e-9;

double signed_area(const ConvexPolygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum / 2;
}

// The part of a polygon on the side of the line a, b where `sign` times the cross product is positive.
ConvexPolygon side_of(const ConvexPolygon& polygon, const Vec2& a, const Vec2& b, double sign) {
  ConvexPolygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& from = polygon[i];
    const Vec2& to = polygon[(i + 1) % polygon.size()];
    const double at_from = sign * cross(b - a, from - a), at_to = sign * cross(b - a, to - a);
    if (at_from >= 0) rest.push_back(from);
    if ((at_from >= 0) != (at_to >= 0)) rest.push_back(from + at_from / (at_from - at_to) * (to - from));
  }
  return rest;
}

// Appends `piece` without `cover`: the part outside the first side, then the part of the rest outside the second, and
// so on.
void subtract(ConvexPolygon piece, const ConvexPolygon& cover, std::vector<ConvexPolygon>& rest) {
  const double sign = signed_area(cover) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    const Vec2& a = cover[i];
    const Vec2& b = cover[(i + 1) % cover.size()];
    if (glm::distance(a, b) < min_area) continue;
    ConvexPolygon outside = side_of(piece, a, b, -sign);
    if (std::abs(signed_area(outside)) > min_area) rest.push_back(std::move(outside));
    piece = side_of(piece, a, b, sign);
  }
}

}  // namespace

double uncovered(const std::vector<ConvexPolygon>& polygons) {
  std::vector<ConvexPolygon> pieces{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const ConvexPolygon& polygon : polygons) {
    if (std::abs(signed_area(polygon)) <= min_area) continue;
    std::vector<ConvexPolygon> rest;
    for (ConvexPolygon& piece : pieces) subtract(std::move(piece), polygon, rest);
    pieces = std::move(rest);
    if (pieces.empty()) return 0;
  }
  double area = 0;
  for (const ConvexPolygon& piece : pieces) area += std::abs(signed_area(piece));
  return area;
}

}  // namespace epura::verify
