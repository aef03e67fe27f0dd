// SPDX-License-Identifier: Apache-2.0
#include "verify/outline_faults.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "drawing/drawing.hpp"
#include "verify/ink.hpp"
#include "verify/sample.hpp"

namespace epura::verify {

namespace {

// Numbers of steps along the straight line of a fault: up to the least length that counts, from where it was found;
// over the whole line; and bisections of both ends.
constexpr int near_steps = 8, far_steps = 32, halvings = 8;
constexpr std::ptrdiff_t max_followed = 300;
constexpr std::size_t lines_at_once = 4096;

ScanWindow window_of(const VerifyInput& input, const OutlineOptions& options, const ScanScene& scene, double reach) {
  ScanWindow box;
  if (options.window) return {options.window->min - scene.origin + reach, options.window->max - scene.origin - reach};
  const auto add = [&](const auto& vertices) {
    for (const int v : vertices)
      if (scene.is_before_viewer(v)) box.add(scene.position(v));
  };
  for (const auto& triangle : input.world.triangles) add(triangle);
  for (const auto& wire : input.world.wires) add(wire);
  return {box.min - reach, box.max + reach};
}

// Steps from the place where a suspect was met: mm along its straight line, ascending, including both of its ends.
std::vector<double> steps_along(const Suspect& suspect, double min) {
  const double length = glm::distance(suspect.ends[0], suspect.ends[1]);
  const double at = glm::dot(suspect.place - suspect.ends[0], suspect.ends[1] - suspect.ends[0]) / length;
  std::vector<double> list{-at, 0, length - at};
  for (int i = 1; i <= near_steps; ++i)
    for (const int side : {-1, 1}) list.push_back(side * i * min / near_steps);
  for (int i = 0; i < far_steps; ++i) list.push_back((i + 0.5) / far_steps * length - at);
  std::erase_if(list, [&](double step) { return step < -at || step > length - at; });
  std::ranges::sort(list);
  return list;
}

// A place on the straight line of a suspect, to be tested for the same fault.
struct Step {
  std::size_t suspect;
  double at;
};
using Ends = std::array<Step, 2>;

// For each short line, whether a required line is missing near its middle.
std::vector<char> lacking(const OutlineScan& on, const std::vector<LineFindings>& findings) {
  std::vector<AskedLine> asked;
  std::vector<std::size_t> owner;
  for (std::size_t i = 0; i < findings.size(); ++i)
    for (const AskedLine& one : findings[i].asked) {
      if (std::abs(one.mark.u) > on.reach) continue;
      asked.push_back(one);
      owner.push_back(i);
    }
  const std::vector<bool> found = on.inked(asked);
  std::vector<char> lacking(findings.size(), 0);
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (!found[i]) lacking[owner[i]] = 1;
  return lacking;
}

char has_wrong_ink(const LineFindings& findings, int segment) {
  return std::ranges::any_of(
      findings.ink, [&](const InkCrossing& ink) { return ink.segment == segment && ink.verdict != InkVerdict::right; });
}

std::vector<char> are_wrong(const OutlineScan& on, const std::vector<Suspect>& suspects,
                            const std::vector<Step>& places) {
  std::vector<char> wrong;
  for (std::size_t first = 0; first < places.size(); first += lines_at_once) {
    const std::span<const Step> some{places.data() + first, std::min(lines_at_once, places.size() - first)};
    std::vector<ScanLine> lines;
    for (const Step& step : some) {
      const Suspect& suspect = suspects[step.suspect];
      const Vec2 way = glm::normalize(suspect.ends[1] - suspect.ends[0]);
      lines.push_back({suspect.place + step.at * way, {-way.y, way.x}, 4 * on.reach});
    }
    const std::vector<LineFindings> findings = on.scan.along(lines, on.options.progress);
    const std::vector<char> lack = lacking(on, findings);
    for (std::size_t i = 0; i < some.size(); ++i)
      wrong.push_back(suspects[some[i].suspect].kind == FaultKind::missing
                          ? lack[i]
                          : has_wrong_ink(findings[i], suspects[some[i].suspect].segment));
  }
  return wrong;
}

// The ends of faults: the last place where they are met, and the next one, halved again and again.
std::vector<Ends> closed_in(const OutlineScan& on, const std::vector<Suspect>& suspects, std::vector<Ends> ends) {
  for (int i = 0; i < halvings; ++i) {
    std::vector<Step> middles;
    for (const auto& [last, next] : ends) middles.push_back({last.suspect, 0.5 * (last.at + next.at)});
    const std::vector<char> wrong = are_wrong(on, suspects, middles);
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k][wrong[k] != 0 ? 0 : 1] = middles[k];
  }
  return ends;
}

}  // namespace

OutlineScan::OutlineScan(const VerifyInput& drawn, const Tolerance& tolerance, const OutlineOptions& how)
    : input(drawn),
      options(how),
      reach(std::max(guaranteed * tolerance.size, 16 * tolerance.contact)),
      least(8 * reach),
      scene(drawn, reach / 16, how.edges.thread_depth),
      rule(drawn.world, how.edges, 2 * reach / scene.page),
      window(window_of(drawn, how, scene, reach)),
      scan(drawn, scene, rule, {reach, tolerance.sideways(), tolerance.contact}, window) {}

std::vector<bool> OutlineScan::inked(const std::vector<AskedLine>& asked) const {
  std::vector<Expected> places;
  for (const AskedLine& one : asked) places.push_back({one.place + scene.origin, true});
  return find_ink(input.drawing, places, reach + input.drawing.distances.joined_within);
}

void Suspects::add(const Suspect& found) {
  const auto [at, is_new] = known_.try_emplace(found.key(), all_.size());
  if (is_new) return all_.push_back(found);
  Suspect& same = all_[at->second];
  ++same.met;
  // Beyond the end of the first line, parts of a second one may be alone.
  same.kind = std::max(same.kind, found.kind);
}

std::vector<Suspect> followed(const OutlineScan& on, std::vector<Suspect> suspects) {
  std::ranges::stable_sort(suspects, {}, [](const Suspect& s) { return -s.met; });
  const auto count = static_cast<std::size_t>(std::min(std::ssize(suspects), max_followed));
  std::vector<Step> all;
  for (std::size_t i = 0; i < count; ++i)
    for (const double at : steps_along(suspects[i], on.least)) all.push_back({i, at});
  const std::vector<char> wrong = are_wrong(on, suspects, all);
  // On both sides, from the last wrong place to the first that is not; both are equal if the line ends there.
  std::vector<Ends> ends;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].at != 0 || wrong[i] == 0) continue;
    for (const int side : {-1, 1}) {
      std::size_t last = i;
      const auto goes_on = [&] { return last + side < all.size() && all[last + side].suspect == all[i].suspect; };
      while (goes_on() && wrong[last + side] != 0) last += side;
      ends.push_back({all[last], goes_on() ? all[last + side] : all[last]});
    }
  }
  for (const auto& [last, next] : closed_in(on, suspects, std::move(ends)))
    suspects[last.suspect].length += std::abs(last.at);
  return suspects;
}

std::vector<char> are_faults(const OutlineScan& on, const std::vector<Suspect>& followed) {
  const auto is_long = [&](const Suspect& s) { return s.length >= on.least; };
  const bool most_are_wrong = 2 * std::ranges::count_if(followed, is_long) > max_followed;
  std::vector<char> faults;
  for (std::ptrdiff_t i = 0; i < std::ssize(followed); ++i)
    faults.push_back(is_long(followed[i]) || (i >= max_followed && most_are_wrong) ? 1 : 0);
  return faults;
}

}  // namespace epura::verify
