// SPDX-License-Identifier: Apache-2.0
#include "verify/ink_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/nearest.hpp"
#include "drawing/chain_lines.hpp"
#include "drawing/drawing.hpp"
#include "verify/missing_lines.hpp"
#include "verify/outline_faults.hpp"
#include "verify/part_eyes.hpp"
#include "verify/surface_sight.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t max_faults_told = 10;
// So many places are judged together, for what is found around them takes memory.
constexpr std::size_t places_at_once = 65536;

/// A place on ink.
struct InkPlace {
  int segment;
  Vec2 at;  ///< mm
};

enum class Verdict { founded, unfounded, thread, within_surface, vague };
constexpr std::array reasons{"", "", "lines of threads, which are a convention",
                             "lines within surfaces, which are wanted",
                             "places that rounding in the files leaves open"};

// The lines as they are written, in their order: chains are what the user sees.
drawing::ViewDrawing written_lines(const drawing::ViewDrawing& drawing) {
  drawing::ViewDrawing lines;
  lines.world_to_page = drawing.world_to_page;
  for (const drawing::Chain& chain : drawing.chains) {
    if (chain.points.size() < 2) continue;
    drawing::Segment piece = drawing.segments[static_cast<std::size_t>(chain.segments.front())];
    piece.visible = chain.visible;
    piece.kind = chain.kind;
    piece.t = {0, 1};
    drawing::visit_lines(chain, [&](const Vec2& from, const Vec2& to) {
      piece.from = from;
      piece.to = to;
      lines.segments.push_back(piece);
    });
  }
  return lines;
}

double length_of(const drawing::Segment& s) { return glm::distance(s.from, s.to); }

class InkJudge {
 public:
  InkJudge(const VerifyInput& input, const Tolerance& tolerance, const InkOptions& options)
      : user_(input.drawing),
        lines_(written_lines(input.drawing)),
        written_{input.world, input.projection, input.limits, input.drawn, input.hidden, lines_},
        options_(options),
        on_(written_, tolerance, options.outline),
        eyes_(input.world, input.projection, options.outline.edges) {
    check_.error = options.error + on_.reach;
  }

  report::InkCheck run(std::span<const AskedLine> needs) {
    judge_places();
    if (options_.outline.complete)
      for (const report::OutlineFault& fault : missing_lines(on_, options_, check_.error, needs)) {
        check_.missing += fault.length;
        ++check_.faults;
        check_.worst.push_back(fault);
      }
    std::ranges::stable_sort(check_.worst, std::greater{}, &report::OutlineFault::length);
    check_.worst.resize(std::min(check_.worst.size(), max_faults_told));
    return std::move(check_);
  }

 private:
  [[nodiscard]] const drawing::Segment& line(const InkPlace& place) const {
    return lines_.segments[static_cast<std::size_t>(place.segment)];
  }
  [[nodiscard]] Vec2 across(const InkPlace& place) const {
    const Vec2 way = glm::normalize(line(place).to - line(place).from);
    return {-way.y, way.x};
  }

  // Evenly spread along all lines; each stands for a step.
  [[nodiscard]] std::vector<InkPlace> spread(double step) const {
    std::vector<InkPlace> places;
    double next = 0.5 * step, begin = 0;
    for (std::size_t i = 0; i < lines_.segments.size(); ++i) {
      const drawing::Segment& s = lines_.segments[i];
      const double length = length_of(s);
      for (; next < begin + length; next += step)
        places.push_back({static_cast<int>(i), s.from + (next - begin) / length * (s.to - s.from)});
      begin += length;
    }
    return places;
  }

  // Whether something near a place is a reason for a line there.
  [[nodiscard]] bool is_founded(const Around& around, bool visible) const {
    if (around.at_limit || around.wire || (visible ? around.seen_crossing : around.any_crossing)) return true;
    return std::ranges::any_of(
        around.edges, [&](const MetEdge& met) { return (!visible || met.is_seen) && is_ground(met, visible); });
  }

  [[nodiscard]] bool is_ground(const MetEdge& met, bool visible) const {
    const FoldRule::Sheets sheets = on_.rule.sheets_at(met.edge);
    if (sheets.edge == nullptr || sheets.edge->wire) return true;
    if (sheets.edge->cut != mesh::CutEdge::none) return sheets.edge->cut == mesh::CutEdge::outline;
    if (on_.rule.ends_at_cut(sheets)) return true;
    return std::ranges::any_of(sheets.bodies, [&](const std::vector<int>& body) {
      if (body.size() != 2) return true;
      if (!eyes_.knows(body[0]) || !eyes_.knows(body[1]))
        return met.front >= 0 || on_.rule.fold(met.edge, body[0], body[1]) != Need::none;
      return eyes_.ground_at(met, {body[0], body[1]}, visible) != Ground::none;
    });
  }

  [[nodiscard]] Verdict first_verdict(const InkPlace& place, const Around& around) const {
    const EdgeKind kind = line(place).kind;
    if (kind == EdgeKind::thread || kind == EdgeKind::thread_end) return Verdict::thread;
    if (edges::is_within_surface(kind)) return Verdict::within_surface;
    if (around.is_vague) return Verdict::vague;
    return is_founded(around, line(place).visible) ? Verdict::founded : Verdict::unfounded;
  }

  [[nodiscard]] std::vector<Verdict> verdicts(std::span<const InkPlace> places) const {
    std::vector<ScanLine> lines;
    for (const InkPlace& place : places) lines.push_back({place.at - on_.scene.origin, across(place), check_.error});
    const std::vector<Around> around = on_.scan.around(lines, check_.error, options_.outline.progress);
    std::vector<Verdict> found;
    std::vector<Band> bands;
    std::vector<std::size_t> doubtful;
    for (std::size_t i = 0; i < places.size(); ++i) {
      found.push_back(first_verdict(places[i], around[i]));
      if (found[i] != Verdict::unfounded) continue;
      doubtful.push_back(i);
      bands.push_back({places[i].at, across(places[i]), check_.error});
    }
    const std::vector<SeenAcross> seen =
        see_across(written_, options_.outline.edges, check_.error, bands, options_.outline.progress);
    for (std::size_t k = 0; k < doubtful.size(); ++k)
      if (line(places[doubtful[k]]).visible ? seen[k].front_changes : seen[k].any_changes)
        found[doubtful[k]] = Verdict::founded;
    return found;
  }

  void judge_places() {
    for (const drawing::Segment& s : lines_.segments) check_.length += length_of(s);
    if (!(check_.length > 0)) return;
    const double step = check_.length / options_.outline.samples;
    const std::vector<InkPlace> places = spread(step);
    std::vector<Verdict> found;
    for (std::size_t from = 0; from < places.size(); from += places_at_once)
      for (const Verdict one : verdicts({places.data() + from, std::min(places_at_once, places.size() - from)}))
        found.push_back(one);
    std::map<Verdict, int> count;
    int known = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      ++count[found[i]];
      const world::Placed& placed = on_.input.world.models[static_cast<std::size_t>(line(places[i]).model)];
      const bool by_surfaces = placed.part != nullptr && placed.mesh->uncut == nullptr;
      known += by_surfaces && found[i] <= Verdict::unfounded ? 1 : 0;
    }
    check_.judged = step * (count[Verdict::founded] + count[Verdict::unfounded]);
    check_.by_surfaces = step * known;
    for (const auto& [verdict, places_of_it] : count)
      if (verdict > Verdict::unfounded)
        check_.unjudged.push_back({reasons[static_cast<std::size_t>(verdict)], step * places_of_it});
    tell_stretches(places, found, step);
  }

  /// Ink without a reason.
  struct Stretch {
    InkPlace middle;
    double length;  ///< mm
  };

  // Neighbouring places without a reason are one fault.
  void tell_stretches(const std::vector<InkPlace>& places, const std::vector<Verdict>& found, double step) {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < places.size();) {
      if (found[i] != Verdict::unfounded) {
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      const auto goes_on = [&] {
        return found[end] == Verdict::unfounded && line(places[end]).visible == line(places[i]).visible &&
               glm::distance(places[end].at, places[end - 1].at) < 2 * step;
      };
      while (end < places.size() && goes_on()) ++end;
      const double length = step * static_cast<double>(end - i);
      // A single place does not tell how long it is.
      if (end - i > 1 && length > least_errors * check_.error) {
        stretches.push_back({places[i + (end - i) / 2], length});
        check_.unfounded += length;
        ++check_.faults;
      }
      i = end;
    }
    std::ranges::stable_sort(stretches, std::greater{}, &Stretch::length);
    if (stretches.size() > max_faults_told) stretches.resize(max_faults_told);
    for (const auto& [middle, length] : stretches) {
      const drawing::Segment& origin = origin_of(middle);
      check_.worst.push_back(
          {"unfounded", middle.at, length, on_.input.world.number_in_scene(origin.model), origin.edge, {}});
    }
  }

  // The segment whose line a place is on; a visible one if the ink is visible.
  [[nodiscard]] const drawing::Segment& origin_of(const InkPlace& place) const {
    const auto away = [&](const drawing::Segment& s) {
      return std::pair(line(place).visible && !s.visible, distance_to_segment(place.at, s.from, s.to));
    };
    return *std::ranges::min_element(user_.segments, {}, away);
  }

  const drawing::ViewDrawing& user_;
  drawing::ViewDrawing lines_;
  VerifyInput written_;
  const InkOptions& options_;
  OutlineScan on_;
  PartEyes eyes_;
  report::InkCheck check_;
};

}  // namespace

report::InkCheck judge_ink(const VerifyInput& input, const Tolerance& tolerance, const InkOptions& options,
                           std::span<const AskedLine> needs) {
  if (input.world.triangles.empty() && input.world.wires.empty()) return {};
  return InkJudge(input, tolerance, options).run(needs);
}

}  // namespace epura::verify
