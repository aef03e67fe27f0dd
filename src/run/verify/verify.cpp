// SPDX-License-Identifier: Apache-2.0
#include "verify/verify.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/drawing.hpp"
#include "verify/confidence.hpp"
#include "verify/ink.hpp"
#include "verify/judge.hpp"
#include "verify/sample.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t max_offences = 10;
// Number of steps over the least guaranteed length in which the length of a wrong span is measured.
constexpr int steps = 8;

enum class Finding { right, undecided, either_way, misclassified, no_ink };

bool contradicts(const TestedSpan& span, ProbeAnswer answer) {
  return answer != ProbeAnswer::undecided && (answer == ProbeAnswer::visible) != span.visible;
}

class Verifier {
 public:
  Verifier(const VerifyInput& input, const Tolerance& tolerance, bool hidden_drawn, const Progress& progress)
      : input_(input),
        tolerance_(tolerance),
        hidden_drawn_(hidden_drawn),
        progress_(progress),
        viewing_(viewing_of(input)),
        reference_(reference_of(input)),
        frame_(sight_from(viewing_, reference_), 0),
        population_(population_of(input, viewing_, tolerance, frame_)) {}

  report::Verification run(int count) {
    samples_ = draw_samples(population_, tolerance_, count);
    findings_.assign(samples_.size(), Finding::right);
    facets_.assign(samples_.size(), -1);
    judge_samples();
    measure_wrong_stretches();
    progress_.expect_time();
    look_for_ink();
    return tally();
  }

 private:
  static Triple<Bounded> reference_of(const VerifyInput& input) {
    const edges::FeatureEdge& edge = input.drawn.edges[0];
    return position_on<Bounded>(input.ends_of(edge), edge.t[0]);
  }

  [[nodiscard]] const TestedSpan& span_of(std::size_t sample) const { return population_.spans[samples_[sample].span]; }
  [[nodiscard]] Probe probe_of(std::size_t sample) const {
    return probe_at(population_, span_of(sample).edge, samples_[sample].s);
  }

  void judge_samples() {
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < samples_.size(); ++i) probes.push_back(probe_of(i));
    const std::vector<ProbeVerdict> verdicts = judge(input_, tolerance_, probes, false, progress_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (verdicts[i].answer == ProbeAnswer::undecided) findings_[i] = Finding::undecided;
      if (contradicts(span_of(i), verdicts[i].answer)) findings_[i] = Finding::misclassified;
    }
  }

  // The tolerance, increased by the uncertainty of positions on the page that is due to rounding in the files.
  [[nodiscard]] Tolerance tolerance_of_files(std::span<const Probe> probes) const {
    Tolerance tolerance = tolerance_;
    for (const Probe& probe : probes) {
      const auto place = position_on<Bounded>(input_.ends_of(input_.drawn.edges[probe.edge]), probe.t);
      tolerance.rounding = std::max(tolerance.rounding, 2 * input_.world.rounding * sight_from(viewing_, place).page);
    }
    return tolerance;
  }

  // Spans that are wrong over less than the guaranteed length do not count, nor do those that depend on rounding in the
  // files: a point on one is undecided.
  void measure_wrong_stretches() {
    std::vector<std::size_t> wrong;
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (findings_[i] != Finding::misclassified) continue;
      wrong.push_back(i);
      for (int k = -2 * steps; k <= 2 * steps; ++k)
        probes.push_back(probe_at(population_, span_of(i).edge, std::clamp(beside(i, k), 0.0, 1.0)));
    }
    const std::vector<ProbeVerdict> verdicts = judge(input_, tolerance_of_files(probes), probes, true, progress_);
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      const ProbeVerdict* middle = &verdicts[i * (4 * steps + 1) + 2 * steps];
      const auto is_wrong = [&](int k) {
        const double s = beside(wrong[i], k);
        const TestedSpan& span = span_of(wrong[i]);
        return s >= span.from && s <= span.to && contradicts(span, middle[k].answer);
      };
      int first = 0, last = 0;
      while (first > -2 * steps && is_wrong(first - 1)) --first;
      while (last < 2 * steps && is_wrong(last + 1)) ++last;
      facets_[wrong[i]] = middle->facet;
      if (last - first < steps) findings_[wrong[i]] = Finding::undecided;
    }
  }

  // The page parameter k steps away from a sample.
  [[nodiscard]] double beside(std::size_t sample, int k) const {
    return samples_[sample].s +
           k * guaranteed * tolerance_.size / steps / population_.lines[span_of(sample).edge].length;
  }

  void look_for_ink() {
    std::vector<std::size_t> asked;
    std::vector<Expected> places;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const bool undecided = findings_[i] == Finding::undecided, visible = span_of(i).visible;
      if (!undecided && (findings_[i] != Finding::right || (!visible && !hidden_drawn_))) continue;
      asked.push_back(i);
      places.push_back({page_of(i), visible || undecided});
    }
    // Lines within contact of another one are not drawn, nor are remainders shorter than a few times that.
    const double reach =
        std::max(guaranteed * tolerance_.size, 16 * tolerance_.contact) + input_.drawing.distances.joined_within;
    const std::vector<bool> found = find_ink(input_.drawing, places, reach);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      Finding& finding = findings_[asked[i]];
      if (finding == Finding::undecided)
        finding = found[i] ? Finding::either_way : finding;
      else if (!found[i])
        finding = Finding::no_ink;
    }
  }

  [[nodiscard]] Vec2 page_of(std::size_t sample) const {
    const Vec4 base =
        input_.drawing.world_to_page * Vec4(reference_.x.value, reference_.y.value, reference_.z.value, 1);
    const Probe probe = probe_of(sample);
    return Vec2(base) / base.w +
           frame_.to_page(position_on<Bounded>(input_.ends_of(input_.drawn.edges[probe.edge]), probe.t));
  }

  [[nodiscard]] report::Verification tally() {
    report::Verification result;
    result.points = static_cast<int>(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const bool either_way = findings_[i] == Finding::either_way, wrong = is_wrong(i);
      const bool undecided = either_way || findings_[i] == Finding::undecided;
      result.decided += undecided ? 0 : 1;
      result.either_way += either_way ? 1 : 0;
      result.wrong += wrong ? 1 : 0;
      if (!samples_[i].at_random) continue;
      report::Stratum& stratum = population_.strata[span_of(i).stratum];
      stratum.undecided += undecided ? 1 : 0;
      stratum.wrong += wrong ? 1 : 0;
    }
    estimate(result);
    result.worst = worst_offences();
    return result;
  }

  [[nodiscard]] bool is_wrong(std::size_t sample) const {
    return findings_[sample] == Finding::misclassified || findings_[sample] == Finding::no_ink;
  }

  void estimate(report::Verification& result) const {
    result.strata = population_.strata;
    result.length = population_.length;
    int wrong = 0;
    double tested = 0, max_weight = 0;
    for (const report::Stratum& stratum : result.strata) {
      const double share = stratum.length / result.length;
      tested += share;
      result.undecided += share * stratum.undecided / stratum.samples;
      result.misclassified += share * stratum.wrong / stratum.samples;
      max_weight = std::max(max_weight, share / stratum.samples);
      result.samples += stratum.samples;
      wrong += stratum.wrong;
    }
    if (result.samples == 0) return;
    result.untested = std::max(0.0, 1 - tested);
    const double weight = max_weight * result.samples;
    result.at_most = std::min(1.0, weight * greatest_share(wrong, result.samples, stated_confidence));
  }

  [[nodiscard]] std::vector<report::Mismatch> worst_offences() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (is_wrong(i)) order.push_back(i);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return population_.length_of(span_of(a)) > population_.length_of(span_of(b));
    });
    order.resize(std::min(order.size(), max_offences));
    std::vector<report::Mismatch> offences;
    for (const std::size_t i : order) offences.push_back(offence_of(i));
    return offences;
  }

  [[nodiscard]] report::FacetName facet_name(int triangle) const {
    const int model = input_.world.model_of_triangle(triangle);
    return {input_.world.number_in_scene(model),
            input_.world.models[model].mesh->polygon[triangle - input_.world.first_triangle[model]]};
  }

  // The outline of a cut is identified by the face that was cut.
  void name_edge(const edges::FeatureEdge& edge, report::Mismatch& offence) const {
    const mesh::Mesh& mesh = *input_.world.models[edge.model].mesh;
    const mesh::EdgeOrigin origin = mesh.origin_of(mesh.edges[edge.mesh_edge]);
    if (origin.in_file)
      offence.edge = origin.vertex;
    else
      offence.facets.push_back({input_.world.number_in_scene(edge.model),
                                mesh.polygon[mesh.triangles_of(mesh.edges[edge.mesh_edge]).front()]});
  }

  [[nodiscard]] report::Mismatch offence_of(std::size_t sample) const {
    const TestedSpan& span = span_of(sample);
    const edges::FeatureEdge& edge = input_.drawn.edges[span.edge];
    report::Mismatch offence{span.visible ? "drawn visible" : "drawn hidden",
                             input_.world.number_in_scene(edge.model),
                             {-1, -1},
                             {},
                             probe_of(sample).t,
                             page_of(sample),
                             {},
                             population_.length_of(span)};
    if (findings_[sample] == Finding::no_ink) offence.what = "not drawn";
    if (edge.mesh_edge >= 0) name_edge(edge, offence);
    if (edge.crossing >= 0)
      for (const int triangle : input_.drawn.crossings[edge.crossing].triangles)
        offence.facets.push_back(facet_name(triangle));
    if (facets_[sample] >= 0) offence.hider = facet_name(facets_[sample]);
    return offence;
  }

  const VerifyInput& input_;
  const Tolerance& tolerance_;
  bool hidden_drawn_;
  const Progress& progress_;
  Viewing viewing_;
  Triple<Bounded> reference_;
  PageFrame frame_;
  Population population_;
  std::vector<Sample> samples_;
  std::vector<Finding> findings_;
  std::vector<int> facets_;
};

}  // namespace

report::Verification verify(const VerifyInput& input, const Tolerance& tolerance, int samples, bool hidden_drawn,
                            const Progress& progress) {
  if (input.drawn.edges.empty()) return {};
  return Verifier(input, tolerance, hidden_drawn, progress).run(samples);
}

}  // namespace epura::verify
