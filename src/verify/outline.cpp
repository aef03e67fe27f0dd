// SPDX-License-Identifier: Apache-2.0
#include "verify/outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <tuple>

#include "drawing/drawing.hpp"
#include "verify/confidence.hpp"
#include "verify/ink.hpp"
#include "verify/line_scan.hpp"
#include "verify/sample.hpp"

namespace epura::verify {

namespace {

constexpr int directions = 16;
constexpr double least_lines = 128, most_lines = 2048;
// Limit on how many triangles the lines cut in total: this multiple of the number of triangles in the world, plus a
// constant.
constexpr double hits_per_triangle = 16, free_hits = 1 << 20;
// Numbers of steps along the straight line of a fault: up to the least length that counts, from where it was found;
// over the whole line; and bisections of both ends.
constexpr int near_steps = 8, far_steps = 32, halvings = 8;
constexpr std::ptrdiff_t most_followed = 300;
constexpr std::size_t at_once = 4096, most_told = 10;

enum class Kind { missing, unfounded, doubled };
constexpr std::array names{"missing", "unfounded", "doubled"};

/// A suspected fault at the place where a line met it.
struct Suspect {
  Kind kind;
  Vec2 place;
  std::array<Vec2, 2> ends;  ///< of the straight line that the fault is part of
  std::array<int, 2> edge, triangles;
  int segment;
  int met = 1;  ///< how often it was met
  double length = 0;

  [[nodiscard]] auto key() const { return std::tuple(edge, edge[0] < 0 ? triangles : edge, segment); }
};

class Outline {
 public:
  Outline(const VerifyInput& input, const Tolerance& tolerance, const OutlineOptions& options)
      : input_(input),
        options_(options),
        reach_(std::max(guaranteed * tolerance.size, 16 * tolerance.contact)),
        least_(8 * reach_),
        scene_(input, reach_ / 16, options.edges.thread_depth),
        rule_(input.world, options.edges, 2 * reach_ / scene_.page),
        window_(window()),
        scan_(input, scene_, rule_, {reach_, tolerance.sideways(), tolerance.contact}, window_) {}

  report::OutlineCheck run() {
    scan_page();
    follow();
    report::OutlineCheck check = std::move(check_);
    for (const Suspect& suspect : suspects_) {
      if (!is_wrong(suspect))
        check.undecided += suspect.met;
      else if (suspect.kind == Kind::missing)
        check.missing += suspect.met;
      else
        (suspect.kind == Kind::unfounded ? check.unfounded : check.doubled) += suspect.met;
    }
    if (check.asked + check.ink > 0)
      check.at_most = greatest_share(check.wrong(), check.asked + check.ink, stated_confidence);
    check.worst = worst();
    return check;
  }

 private:
  [[nodiscard]] ScanWindow window() const {
    ScanWindow box;
    if (options_.window)
      return {options_.window->min - scene_.origin + reach_, options_.window->max - scene_.origin - reach_};
    const auto add = [&](const auto& vertices) {
      for (const int v : vertices)
        if (scene_.is_before_viewer(v)) box.add(scene_.position(v));
    };
    for (const auto& triangle : input_.world.triangles) add(triangle);
    for (const auto& wire : input_.world.wires) add(wire);
    return {box.min - reach_, box.max + reach_};
  }

  void scan_page() {
    const double size = glm::distance(window_.min, window_.max);
    const double ink = std::max(scan_.length_of_ink(), size);
    double lines = std::clamp(options_.samples * std::numbers::pi * size / (2 * ink), least_lines,
                              std::max(most_lines, static_cast<double>(options_.samples)));
    const double hits = scan_.perimeter_of_triangles(3 * size) / (std::numbers::pi * size) * lines;
    const double most_hits = hits_per_triangle * static_cast<double>(input_.world.triangles.size()) + free_hits;
    if (hits > most_hits) lines = std::max(static_cast<double>(directions), lines * most_hits / hits);
    const double distance = size / std::ceil(lines / directions);
    check_.length = std::numbers::pi * distance / (2 * directions);
    for (int i = 0; i < directions; ++i) {
      const LineBundle bundle(window_, (i + 0.3) * std::numbers::pi / directions, distance, i + 1);
      check_.lines += static_cast<int>(bundle.lines().size());
      for (const LineFindings& findings : scan_.along(bundle, options_.progress)) note(findings);
    }
    look_for_ink();
  }

  void note(const LineFindings& findings) {
    check_.ink += static_cast<int>(findings.ink.size());
    for (const InkCrossing& ink : findings.ink)
      if (ink.verdict != InkVerdict::right) suspect(of_ink(ink));
    if (!options_.complete) return;
    check_.asked += static_cast<int>(findings.asked.size());
    asked_.insert(asked_.end(), findings.asked.begin(), findings.asked.end());
  }

  [[nodiscard]] Suspect of_ink(const InkCrossing& ink) const {
    const Kind kind = ink.verdict == InkVerdict::doubled ? Kind::doubled : Kind::unfounded;
    return {kind, ink.place, scan_.segment(ink.segment), {-1, -1}, {-1, -1}, ink.segment};
  }

  [[nodiscard]] std::optional<Suspect> of_asked(const AskedLine& asked) const {
    const auto& [place, mark] = asked;
    const auto ends = mark.edge[0] >= 0 ? scene_.line_of(mark.edge) : crossing_of(place, mark.triangles);
    if (!ends) return std::nullopt;
    return Suspect{Kind::missing, place, *ends, mark.edge, mark.triangles, -1};
  }

  // The line in which the planes of two triangles intersect, through a place on it, as long as the page is wide.
  [[nodiscard]] std::optional<std::array<Vec2, 2>> crossing_of(const Vec2& place,
                                                               const std::array<int, 2>& triangles) const {
    const auto gradient = [&](int triangle) {
      const auto& corner = input_.world.triangles[triangle];
      const Vec3 a = page_and_depth(corner[0]), b = page_and_depth(corner[1]) - a, c = page_and_depth(corner[2]) - a;
      const Vec3 normal = glm::cross(b, c);
      return Vec2(normal) / -normal.z;
    };
    const Vec2 difference = gradient(triangles[0]) - gradient(triangles[1]);
    const double length = glm::length(difference);
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    const Vec2 half = 0.5 * glm::distance(window_.min, window_.max) / length * Vec2(-difference.y, difference.x);
    return std::array{place - half, place + half};
  }

  [[nodiscard]] Vec3 page_and_depth(int vertex) const {
    return {scene_.position(vertex), scene_.depth_of(scene_.local[vertex])};
  }

  void suspect(const Suspect& found) {
    const auto [at, is_new] = known_.try_emplace(found.key(), suspects_.size());
    if (is_new) return suspects_.push_back(found);
    Suspect& same = suspects_[at->second];
    ++same.met;
    // Beyond the end of the first line, parts of a second one may be alone.
    same.kind = std::max(same.kind, found.kind);
  }

  [[nodiscard]] std::vector<bool> inked(const std::vector<AskedLine>& asked) const {
    std::vector<Expected> places;
    for (const AskedLine& one : asked) places.push_back({one.place + scene_.origin, true});
    return find_ink(input_.drawing, places, reach_ + input_.drawing.joined_within);
  }

  void look_for_ink() {
    const std::vector<bool> found = inked(asked_);
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      if (found[i]) continue;
      if (const auto missing = of_asked(asked_[i]))
        suspect(*missing);
      else
        ++check_.undecided;
    }
  }

  // Steps from the place where a suspect was met: mm along its straight line, ascending, including both of its ends.
  [[nodiscard]] static std::vector<double> steps(const Suspect& suspect, double min) {
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
  [[nodiscard]] std::vector<char> are_wrong(const std::vector<Step>& steps) const {
    std::vector<char> wrong;
    for (std::size_t first = 0; first < steps.size(); first += at_once) {
      const std::span<const Step> some{steps.data() + first, std::min(at_once, steps.size() - first)};
      std::vector<ScanLine> lines;
      for (const Step& step : some) {
        const Suspect& suspect = suspects_[step.suspect];
        const Vec2 way = glm::normalize(suspect.ends[1] - suspect.ends[0]);
        lines.push_back({suspect.place + step.at * way, {-way.y, way.x}, 4 * reach_});
      }
      const std::vector<LineFindings> findings = scan_.along(lines, options_.progress);
      const std::vector<char> lack = lacking(findings);
      for (std::size_t i = 0; i < some.size(); ++i)
        wrong.push_back(suspects_[some[i].suspect].kind == Kind::missing
                            ? lack[i]
                            : has_wrong_ink(findings[i], suspects_[some[i].suspect].segment));
    }
    return wrong;
  }

  static char has_wrong_ink(const LineFindings& findings, int segment) {
    return std::ranges::any_of(findings.ink, [&](const InkCrossing& ink) {
      return ink.segment == segment && ink.verdict != InkVerdict::right;
    });
  }

  void follow() {
    std::ranges::stable_sort(suspects_, {}, [](const Suspect& s) { return -s.met; });
    const auto count = static_cast<std::size_t>(std::min(std::ssize(suspects_), most_followed));
    std::vector<Step> all;
    for (std::size_t i = 0; i < count; ++i)
      for (const double at : steps(suspects_[i], least_)) all.push_back({i, at});
    const std::vector<char> wrong = are_wrong(all);
    // On both sides, from the last wrong place to the first that is not; both are equal if the line ends there.
    std::vector<std::array<Step, 2>> ends;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].at != 0 || wrong[i] == 0) continue;
      for (const int side : {-1, 1}) {
        std::size_t last = i;
        const auto goes_on = [&] { return last + side < all.size() && all[last + side].suspect == all[i].suspect; };
        while (goes_on() && wrong[last + side] != 0) last += side;
        ends.push_back({all[last], goes_on() ? all[last + side] : all[last]});
      }
    }
    close_in(ends);
    for (const auto& [last, next] : ends) suspects_[last.suspect].length += std::abs(last.at);
    const auto wrong_ones = std::ranges::count_if(suspects_, [&](const Suspect& s) { return s.length >= least_; });
    most_are_wrong_ = 2 * wrong_ones > most_followed;
  }

  void close_in(std::vector<std::array<Step, 2>>& ends) const {
    for (int i = 0; i < halvings; ++i) {
      std::vector<Step> middles;
      for (const auto& [last, next] : ends) middles.push_back({last.suspect, 0.5 * (last.at + next.at)});
      const std::vector<char> wrong = are_wrong(middles);
      for (std::size_t k = 0; k < ends.size(); ++k) ends[k][wrong[k] != 0 ? 0 : 1] = middles[k];
    }
  }

  // For each short line, whether a required line is missing near its middle.
  [[nodiscard]] std::vector<char> lacking(const std::vector<LineFindings>& findings) const {
    std::vector<AskedLine> asked;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < findings.size(); ++i)
      for (const AskedLine& one : findings[i].asked) {
        if (std::abs(one.mark.u) > reach_) continue;
        asked.push_back(one);
        owner.push_back(i);
      }
    const std::vector<bool> found = inked(asked);
    std::vector<char> lacking(findings.size(), 0);
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (!found[i]) lacking[owner[i]] = 1;
    return lacking;
  }

  // Suspects that were not followed count as wrong if most of the followed ones are.
  [[nodiscard]] bool is_wrong(const Suspect& suspect) const {
    return suspect.length >= least_ || (&suspect - suspects_.data() >= most_followed && most_are_wrong_);
  }

  [[nodiscard]] std::vector<report::OutlineFault> worst() const {
    std::vector<const Suspect*> order;
    for (const Suspect& suspect : suspects_)
      if (suspect.length >= least_) order.push_back(&suspect);
    std::ranges::stable_sort(order, [](const Suspect* a, const Suspect* b) { return a->length > b->length; });
    order.resize(std::min(order.size(), most_told));
    std::vector<report::OutlineFault> faults;
    for (const Suspect* suspect : order) faults.push_back(fault_of(*suspect));
    return faults;
  }

  [[nodiscard]] report::OutlineFault fault_of(const Suspect& suspect) const {
    report::OutlineFault fault{
        names[static_cast<std::size_t>(suspect.kind)], suspect.place + scene_.origin, suspect.length, -1, {-1, -1}, {}};
    if (suspect.segment >= 0) {
      fault.model = input_.world.number_in_scene(input_.drawing.segments[suspect.segment].model);
      fault.edge = input_.drawing.segments[suspect.segment].edge;
      return fault;
    }
    for (const int triangle : suspect.triangles) {
      if (triangle < 0) continue;
      const int model = input_.world.model_of_triangle(triangle);
      fault.facets.push_back({input_.world.number_in_scene(model),
                              input_.world.models[model].mesh->polygon[triangle - input_.world.first_triangle[model]]});
      fault.model = input_.world.number_in_scene(model);
    }
    if (const auto sheets = suspect.edge[0] >= 0 ? rule_.sheets_at(suspect.edge) : FoldRule::Sheets{}; sheets.edge) {
      fault.model = input_.world.number_in_scene(sheets.model);
      const mesh::EdgeOrigin origin = input_.world.models[sheets.model].mesh->origin_of(*sheets.edge);
      if (origin.in_file) fault.edge = origin.vertex;
    }
    return fault;
  }

  const VerifyInput& input_;
  const OutlineOptions& options_;
  double reach_, least_;  ///< mm: places this close are one; faults of this length count
  ScanScene scene_;
  FoldRule rule_;
  ScanWindow window_;
  LineScan scan_;
  report::OutlineCheck check_;
  std::vector<AskedLine> asked_;
  std::vector<Suspect> suspects_;  ///< only the first `most_followed` are followed
  bool most_are_wrong_ = false;
  std::map<decltype(std::declval<Suspect>().key()), std::size_t> known_;
};

}  // namespace

report::OutlineCheck verify_outline(const VerifyInput& input, const Tolerance& tolerance,
                                    const OutlineOptions& options) {
  if (input.world.triangles.empty() && input.world.wires.empty()) return {};
  return Outline(input, tolerance, options).run();
}

}  // namespace epura::verify
