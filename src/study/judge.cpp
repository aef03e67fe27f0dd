#include "study/judge.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/parallel.hpp"
#include "study/patch.hpp"
#include "study/probe_grid.hpp"

namespace epura {

namespace {

constexpr std::size_t chunk = 4096;
// Of the square of rays, whose area is 4: what may stay uncovered where triangles join.
constexpr double least_gap = 0.01;

struct Met {
  int probe;
  Portion portion;
};

class Judge {
 public:
  Judge(const Subject& subject, const Tolerance& tolerance, std::span<const Probe> probes, bool name_facets)
      : subject_(subject),
        viewing_(viewing_of(subject)),
        probes_(probes),
        name_facets_(name_facets),
        frame_(sight_from(viewing_, place_of(probes[0])), 4 * tolerance.sideways()),
        grid_(extents()),
        settled_(probes.size()) {
    for (const Probe& probe : probes) lookouts_.emplace_back(viewing_, tolerance, line_of(probe), probe.t);
  }

  std::vector<Verdict> verdicts() {
    const std::size_t count = subject_.world.triangles.size();
    std::vector<std::vector<Met>> met((count + chunk - 1) / chunk);
    parallel_for(met.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part)
        for (std::size_t t = part * chunk; t < std::min((part + 1) * chunk, count); ++t)
          meet(static_cast<int>(t), met[part]);
    });
    std::vector<std::vector<Portion>> portions(probes_.size());
    for (std::vector<Met>& part : met)
      for (Met& one : part) portions[one.probe].push_back(std::move(one.portion));
    std::vector<Verdict> verdicts(probes_.size());
    for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i] = verdict_of(settled_[i], portions[i]);
    return verdicts;
  }

 private:
  [[nodiscard]] std::array<Vec3, 2> line_of(const Probe& probe) const {
    return subject_.ends_of(subject_.drawn.edges[probe.edge]);
  }
  [[nodiscard]] Triple<Bounded> place_of(const Probe& probe) const {
    return place_on<Bounded>(line_of(probe), probe.t);
  }

  [[nodiscard]] std::vector<Extent> extents() const {
    std::vector<Extent> list;
    for (const Probe& probe : probes_) list.push_back(frame_.extent_of(place_of(probe)));
    return list;
  }

  // What one triangle does to all probes. A probe that one triangle hides for certain needs no others.
  void meet(int triangle, std::vector<Met>& met) {
    const auto& vertex = subject_.world.triangles[triangle];
    const auto& points = subject_.world.points;
    const std::array corners{points[vertex[0]], points[vertex[1]], points[vertex[2]]};
    const std::optional<Extent> extent = frame_.extent_of(corners);
    if (!extent) return;
    grid_.overlapping(*extent, [&](int probe) {
      if (settled_[probe].load(std::memory_order_relaxed) && !name_facets_) return;
      const DrawnEdge& edge = subject_.drawn.edges[probes_[probe].edge];
      if (subject_.contains(edge, triangle)) return;
      auto portion = lookouts_[probe].look(corners, triangle, subject_.joined(edge, triangle));
      if (!portion) return;
      if (portion->in_front && uncovered({portion->corner}) < least_gap)
        settled_[probe].store(true, std::memory_order_relaxed);
      met.push_back({probe, std::move(*portion)});
    });
  }

  [[nodiscard]] Verdict verdict_of(bool settled, const std::vector<Portion>& portions) const {
    if (portions.empty()) return {};
    const Portion* nearest = nullptr;
    std::vector<ConvexPolygon> covers;
    for (const Portion& portion : portions) {
      if (!portion.in_front) continue;
      covers.push_back(portion.corner);
      if (!nearest || portion.depth < nearest->depth) nearest = &portion;
    }
    if (!settled && !(uncovered(covers) < least_gap)) return {Answer::undecided};
    return {Answer::hidden, name_facets_ ? nearest->triangle : -1};
  }

  const Subject& subject_;
  Viewing viewing_;
  std::span<const Probe> probes_;
  bool name_facets_;
  PageFrame frame_;
  ProbeGrid grid_;
  std::vector<Lookout> lookouts_;
  std::vector<std::atomic<bool>> settled_;
};

}  // namespace

std::vector<Verdict> judge(const Subject& subject, const Tolerance& tolerance, std::span<const Probe> probes,
                           bool name_facets) {
  if (probes.empty()) return {};
  return Judge(subject, tolerance, probes, name_facets).verdicts();
}

}  // namespace epura
