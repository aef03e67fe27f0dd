// SPDX-License-Identifier: Apache-2.0
#include "verify/sample.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

namespace epura::verify {

namespace {

// Least lengths of the strata, as fractions of the drawing.
constexpr std::array classes{1e-2, 1e-4, guaranteed};

PageLine page_line(const VerifyInput& input, const Viewing& viewing, const Tolerance& tolerance, const PageFrame& frame,
                   const edges::FeatureEdge& edge) {
  const std::array<Vec3, 2> ends = input.ends_of(edge);
  PageLine line{0, edge.t, {1, 1}};
  std::array<Vec2, 2> place;
  for (std::size_t i = 0; i < 2; ++i) {
    const Triple<Bounded> p = position_on<Bounded>(ends, edge.t[i]);
    place[i] = frame.to_page(p);
    if (viewing.projection.central)
      line.w[i] = glm::dot(viewing.projection.n, viewing.projection.projector - Vec3(p.x.value, p.y.value, p.z.value));
  }
  const double length = glm::distance(place[0], place[1]);
  // Parameters are doubles: on a long edge of which only a part is seen, adjacent ones may lie far apart.
  const double largest = std::max(std::abs(edge.t[0]), std::abs(edge.t[1])) / std::abs(edge.t[1] - edge.t[0]);
  const double stretch = std::max(line.w[0] / line.w[1], line.w[1] / line.w[0]);
  if (length * stretch * largest * 0x1p-50 < tolerance.sideways()) line.length = length;
  return line;
}

// Written anew: the code under test must not take part in its test.
void add_spans(const VerifyInput& input, int edge, std::vector<TestedSpan>& spans) {
  const visibility::HiddenSpans& hidden = input.hidden;
  double at = 0;
  // Facets alone do not tell what is hidden of these.
  const bool is_doubtful = std::ranges::binary_search(hidden.by_surface, edge);
  const auto add = [&](double from, double to, bool visible) {
    if (from < to && (visible || !is_doubtful)) spans.push_back({edge, from, to, visible, -1});
  };
  const auto add_visible = [&](double from, double to) {
    for (const visibility::FacetsSpan& span : hidden.hidden_by_facets(static_cast<std::size_t>(edge))) {
      add(from, std::min(to, span.from), true);
      from = std::max(from, span.to);
    }
    add(from, to, true);
  };
  for (std::size_t i = hidden.first[edge]; i < hidden.first[edge + 1]; ++i) {
    add_visible(at, hidden.spans[i][0]);
    add(hidden.spans[i][0], hidden.spans[i][1], false);
    at = hidden.spans[i][1];
  }
  add_visible(at, 1);
}

void stratify(Population& population, const edges::FeatureEdges& drawn, double size) {
  std::map<std::tuple<bool, EdgeKind, std::size_t>, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < population.spans.size(); ++i) {
    const TestedSpan& span = population.spans[i];
    const double length = population.length_of(span);
    population.length += length;
    const auto found = std::ranges::find_if(classes, [&](double min) { return length >= min * size; });
    if (found == classes.end()) continue;
    members[{!span.visible, drawn.edges[span.edge].kind, static_cast<std::size_t>(found - classes.begin())}].push_back(
        i);
  }
  for (const auto& [key, list] : members) {
    report::Stratum stratum{!std::get<0>(key), std::get<1>(key), classes[std::get<2>(key)]};
    for (const std::size_t i : list) {
      population.spans[i].stratum = static_cast<int>(population.strata.size());
      stratum.length += population.length_of(population.spans[i]);
    }
    population.strata.push_back(stratum);
  }
}

// The standard fixes the numbers of the engine, but not its distributions.
double uniform(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

// Random points on the spans of one stratum.
void draw_at_random(const Population& population, int stratum, std::mt19937_64& random, std::vector<Sample>& samples) {
  std::vector<double> places;
  for (int i = 0; i < population.strata[stratum].samples; ++i)
    places.push_back(uniform(random) * population.strata[stratum].length);
  std::ranges::sort(places);
  double before = 0;
  auto next = places.begin();
  for (std::size_t i = 0; i < population.spans.size() && next != places.end(); ++i) {
    const TestedSpan& span = population.spans[i];
    if (span.stratum != stratum) continue;
    const double length = population.length_of(span);
    for (; next != places.end() && *next < before + length; ++next)
      samples.push_back({static_cast<int>(i), span.from + (*next - before) / length * (span.to - span.from), true});
    before += length;
  }
}

// The middle of a span, and both sides of its ends. The outer sides belong to the adjacent spans.
void add_marks(const Population& population, int number, double size, std::vector<Sample>& samples) {
  const TestedSpan& span = population.spans[number];
  const double step = guaranteed * size / population.lines[span.edge].length;
  samples.push_back({number, 0.5 * (span.from + span.to), false});
  const auto add = [&](double s, int step_to) {
    for (int i = number; i >= 0 && i < static_cast<int>(population.spans.size()); i += step_to) {
      const TestedSpan& other = population.spans[i];
      if (other.edge != span.edge) return;
      if (s < other.from || s > other.to) continue;
      samples.push_back({i, s, false});
      return;
    }
  };
  add(span.from + step, 1);
  add(span.to - step, -1);
  add(span.from - step, -1);
  add(span.to + step, 1);
}

}  // namespace

double PageLine::t_at(double s) const {
  const double part = s * w[0] / (s * w[0] + (1 - s) * w[1]);
  return t[0] + part * (t[1] - t[0]);
}

Population population_of(const VerifyInput& input, const Viewing& viewing, const Tolerance& tolerance,
                         const PageFrame& frame) {
  Population population;
  for (std::size_t e = 0; e < input.drawn.edges.size(); ++e) {
    population.lines.push_back(page_line(input, viewing, tolerance, frame, input.drawn.edges[e]));
    add_spans(input, static_cast<int>(e), population.spans);
  }
  stratify(population, input.drawn, tolerance.size);
  return population;
}

std::vector<Sample> draw_samples(Population& population, const Tolerance& tolerance, int count) {
  std::mt19937_64 random(1);
  std::vector<Sample> samples;
  double length = 0;
  for (const report::Stratum& stratum : population.strata) length += stratum.length;
  for (std::size_t i = 0; i < population.strata.size(); ++i) {
    report::Stratum& stratum = population.strata[i];
    const double share = 0.5 / static_cast<double>(population.strata.size()) + 0.5 * stratum.length / length;
    stratum.samples = static_cast<int>(std::ceil(share * count));
    draw_at_random(population, static_cast<int>(i), random, samples);
  }
  std::vector<int> met;
  for (const Sample& sample : samples) met.push_back(sample.span);
  std::ranges::sort(met);
  met.erase(std::unique(met.begin(), met.end()), met.end());
  for (const int span : met) add_marks(population, span, tolerance.size, samples);
  return samples;
}

Probe probe_at(const Population& population, int edge, double s) { return {edge, population.lines[edge].t_at(s)}; }

}  // namespace epura::verify
