// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "scene/choices.hpp"
#include "scene/standard_threads.hpp"
#include "sizes/noted_circles.hpp"
#include "sizes/stated_values.hpp"

namespace epura::sheet {

namespace {

double diameter_of(const NotedElement& one) { return one.sign == NotedSign::radius ? 2 * one.least : one.least; }

// A length is that of a hole or of a shaft.
bool is_of_hole_alone(const NotedElement& one) { return is_of_hole(one) && one.role != NotedRole::length; }

class HoleJudge {
 public:
  HoleJudge(const NotedText& text, const HoleWalls& walls, const Notation& notation)
      : text_(text), elements_(text.all_understood()), walls_(walls), notation_(notation) {
    check(elements_.size() <= text.elements.size(), "what is understood is part of a text");
  }

  void judge(Verdict& verdict, const WorldCircle& noted) const {
    const bool any_of_hole = std::ranges::any_of(elements_, is_of_hole);
    if (!any_of_hole && text_.count == 1 && !is_on_circle()) return;
    const WorldCircle circle = circle_meant(text_, noted, walls_);
    const std::optional<HoleChain> chain = walls_.chain_at(circle);
    const std::vector<HoleWall> shafts = walls_.shafts_at(circle);
    if (!chain && any_of_hole && !judge_shaft(verdict, circle, shafts)) return;
    if (chain)
      for (const NotedElement& one : elements_)
        if (const std::string has = denied(one, *chain, shafts); !has.empty()) verdict.deny(has);
    if (verdict.has.empty()) judge_count(verdict, circle, chain);
  }

 private:
  [[nodiscard]] bool has(NotedRole role) const {
    return std::ranges::any_of(elements_, [role](const NotedElement& one) { return one.role == role; });
  }
  [[nodiscard]] bool is_on_circle() const { return has(NotedRole::circle) || has(NotedRole::evenly); }
  [[nodiscard]] std::string number(double millimetres) const { return number_text(millimetres, notation_); }

  // What goes around material has lengths and threads. Whether there is more to judge.
  bool judge_shaft(Verdict& verdict, const WorldCircle& circle, const std::vector<HoleWall>& shafts) const {
    const bool is_thread = has(NotedRole::thread);
    if (shafts.empty() || (!is_thread && std::ranges::any_of(elements_, is_of_hole_alone))) {
      if (walls_.has_round(circle) && !is_thread)
        verdict.deny("no hole there");
      else
        verdict.doubt("whether a hole is there");
      return false;
    }
    const auto threaded = std::ranges::find_if(shafts, [](const HoleWall& wall) { return wall.thread.has_value(); });
    const HoleWall& own = threaded == shafts.end() ? shafts.front() : *threaded;
    for (const NotedElement& one : elements_) {
      if (one.role == NotedRole::thread) verdict.deny(denied_thread(one, own, false));
      if (one.of_role == NotedRole::thread && own.thread) verdict.deny(denied_length_of_thread(one, {own}));
      if (one.role == NotedRole::length && one.of_role == NotedRole::size && one.of > 0 && !is_length_of(one, shafts))
        verdict.deny(number(shafts.front().length()) + " there");
    }
    return true;
  }

  [[nodiscard]] bool is_length_of(const NotedElement& one, const std::vector<HoleWall>& shafts) const {
    return std::ranges::any_of(shafts, [&](const HoleWall& wall) {
      return one.allows(wall.length(), 2 * walls_.slack() + definition::same_size * wall.length());
    });
  }

  void judge_count(Verdict& verdict, const WorldCircle& circle, const std::optional<HoleChain>& chain) const {
    std::vector<WorldCircle> equal;
    if (chain && std::ranges::any_of(elements_, is_of_hole)) {
      const HoleWall& own = chain->walls[chain->own];
      const bool is_thread = has(NotedRole::thread) && own.thread.has_value();
      for (const HoleChain& one : walls_.chains_of(circle.radius))
        if (!(!own.is_fillet() && one.walls[one.own].is_fillet()) && !(is_thread && !one.walls[one.own].thread) &&
            std::ranges::all_of(elements_, [&](const auto& of) { return denied(of, one, {}).empty(); }))
          equal.push_back({one.centre, one.axis, circle.radius, {}, true});
    } else {
      for (const NotedRound& one : rounds_like(circle)) equal.push_back(one.circle);
    }
    const int count = static_cast<int>(equal.size());
    if (text_.count > 1 && count == 0) return verdict.doubt("how many of these there are");
    if (count < text_.count) return verdict.deny(std::to_string(count) + " of these");
    if (is_on_circle()) judge_circle(verdict, circle, equal);
  }

  // Of the same radius: fillets, or what is round all around, if it is one of these.
  [[nodiscard]] std::vector<NotedRound> rounds_like(const WorldCircle& circle) const {
    std::vector<NotedRound> equal = walls_.rounds(circle.radius);
    const auto own = std::ranges::find_if(
        equal, [&](const NotedRound& one) { return one.has_centre(circle.centre, walls_.slack()); });
    if (own == equal.end()) return equal;
    const bool is_fillet = own->is_fillet(), is_whole = own->is_whole();
    std::erase_if(
        equal, [&](const NotedRound& one) { return (is_fillet && one.is_whole()) || (is_whole && one.is_fillet()); });
    return equal;
  }

  void judge_circle(Verdict& verdict, const WorldCircle& circle, const std::vector<WorldCircle>& equal) const {
    std::optional<double> diameter, angle;
    double slack = 2 * walls_.slack();
    for (const NotedElement& one : elements_) {
      if (one.role == NotedRole::circle) diameter = one.least, slack += one.slack;
      if (one.role == NotedRole::evenly && one.least > 0) angle = one.least;
    }
    check(static_cast<int>(equal.size()) >= text_.count, "what is missing is denied before");
    if (text_.count == 1) return verdict.doubt("which holes are on one circle");
    const std::vector<CircleOfHoles> circles = circles_of_holes(circle, equal, diameter, slack);
    const auto count = static_cast<std::size_t>(text_.count);
    const auto suits = [&](const CircleOfHoles& one) {
      const bool is_even = one.angles.size() == count && one.is_even();
      const bool is_angle = !angle || std::abs(*angle * text_.count - 360) <= angle_doubt * text_.count;
      return one.angles.size() >= count && (!has(NotedRole::evenly) || (is_even && is_angle));
    };
    if (std::ranges::any_of(circles, suits)) return;
    const std::string of = diameter ? " of ⌀" + number(*diameter) : "";
    verdict.deny("no circle" + of + " with " + std::to_string(text_.count) + " of these" +
                 (has(NotedRole::evenly) ? " at equal angles" : ""));
  }

  // What the part has where an element of a note says something else; empty if it is right.
  [[nodiscard]] std::string denied(const NotedElement& one, const HoleChain& chain,
                                   const std::vector<HoleWall>& shafts) const {
    switch (one.role) {
      case NotedRole::counterbore:
      case NotedRole::countersink:
        return denied_recess(one, chain);
      case NotedRole::depth:
        return denied_depth(one, chain);
      case NotedRole::length:
        return one.of > 0 && !is_length_of(one, shafts) && !is_along(one, chain) ? denied_depth(one, chain) : "";
      case NotedRole::angle:
        return denied_angle(one, chain);
      case NotedRole::thread:
        return denied_thread(one, chain.walls[chain.own], true);
      case NotedRole::drill:
        return denied_drill(one, chain);
      case NotedRole::through:
        if (chain.ends_at(chain.own, 0) || chain.ends_at(chain.own, 1)) return "a blind hole there";
        return is_threaded_through() ? denied_end_of_thread(chain) : "";
      case NotedRole::blind:
        return chain.ends_at(chain.own, 0) || chain.ends_at(chain.own, 1) ? "" : "a through hole there";
      default:
        return "";
    }
  }

  // The wall that a diameter in a note means; nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> wall_of(NotedRole role, double diameter, double slack,
                                                   const HoleChain& chain) const {
    if (!is_recess(role) && role != NotedRole::drill) return chain.own;
    for (std::size_t i = 0; i < chain.walls.size(); ++i) {
      const HoleWall& wall = chain.walls[i];
      const double doubt = 2 * (walls_.slack() + wall.doubt) + definition::same_size * diameter;
      if ((i != chain.own || role == NotedRole::drill) && wall.is_cone() == (role == NotedRole::countersink) &&
          std::abs(2 * wall.widest() - diameter) <= slack + doubt)
        return i;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string denied_recess(const NotedElement& one, const HoleChain& chain) const {
    if (wall_of(one.role, diameter_of(one), one.slack, chain)) return "";
    const bool is_bore = one.role == NotedRole::counterbore;
    const NotedRole other = is_bore ? NotedRole::countersink : NotedRole::counterbore;
    if (wall_of(other, diameter_of(one), one.slack, chain))
      return is_bore ? "a countersink there" : "a counterbore there";
    return std::string("no ") + (is_bore ? "counterbore" : "countersink") + " of ⌀" + number(diameter_of(one)) +
           " there";
  }

  // Of a through hole, or of its wall.
  [[nodiscard]] bool is_along(const NotedElement& one, const HoleChain& chain) const {
    const HoleWall& wall = chain.walls[chain.own];
    const double all = chain.walls.back().at[1] - chain.walls.front().at[0];
    const bool is_open = !chain.is_closed[0] && !chain.is_closed[1];
    return is_open && one.of_role == NotedRole::size &&
           (one.allows(wall.length(), walls_.slack()) || one.allows(all, walls_.slack()));
  }

  // From the end of the wall to its beginning, or to the mouth; to where a mouth in a round face begins or ends.
  [[nodiscard]] std::string denied_depth(const NotedElement& one, const HoleChain& chain) const {
    const bool is_drill = one.of_role == NotedRole::drill;
    std::optional<std::size_t> at = wall_of(one.of_role, one.of, diameter_slack(one), chain);
    if (!at && is_drill) at = chain.own;
    if (!at) return "";  // the recess itself is denied
    const HoleWall& wall = chain.walls[*at];
    const bool is_thread = one.of_role == NotedRole::thread;
    if (is_thread && wall.thread) return denied_length_of_thread(one, chain.walls);
    std::string has;
    for (const std::size_t end : {0, 1}) {
      if (!chain.ends_at(*at, static_cast<int>(end))) continue;
      const double to_mouth = end == 0 ? chain.walls.back().at[1] - wall.at[0] : wall.at[1] - chain.walls.front().at[0];
      for (const double depth : {wall.length(), to_mouth}) {
        const double doubt = walls_.slack() + definition::same_size * depth;
        if (one.most + one.slack + doubt >= depth - chain.uneven[1 - end] && one.least - one.slack - doubt <= depth)
          return "";
        if (is_thread && one.least <= depth + one.slack + doubt) return "";
      }
      has = "↧" + number(wall.length()) + " there";
    }
    if (has.empty() && is_thread && one.least <= wall.length() + one.slack) return "";
    return has.empty() ? "a through hole there" : has;
  }

  // Of the diameter before it.
  static double diameter_slack(const NotedElement& one) { return definition::same_size * one.of; }

  // Between opposite sides; behind the diameter of a hole, perhaps to its axis, as of a chamfer.
  [[nodiscard]] static std::string denied_angle(const NotedElement& one, const HoleChain& chain) {
    std::string has;
    for (const HoleWall& wall : chain.walls) {
      if (!wall.is_cone()) continue;
      if (one.allows(wall.angle, angle_doubt)) return "";
      if (one.of_role == NotedRole::size && one.allows(wall.angle / 2, angle_doubt)) return "";
      has = format_rounded(wall.angle, 4) + "° there";
    }
    return has.empty() ? "no cone there" : has;
  }

  // Drilled or turned for it, or drawn as wide as the thread.
  [[nodiscard]] bool is_thread_of(const NotedElement& one, double diameter, bool internal) const {
    if (one.allows(diameter, features::same_size * one.least + 2 * walls_.slack())) return true;
    if (one.pitch > 0) return scene::suits({one.least, one.pitch, ""}, diameter, internal);
    return diameter >= core_of_thread * one.least && diameter <= one.least;
  }

  // As the scene or the file states it, if it does; otherwise what may be one.
  [[nodiscard]] std::string denied_thread(const NotedElement& one, const HoleWall& wall, bool internal) const {
    const double diameter = 2 * wall.widest();
    if (!wall.thread) return is_thread_of(one, diameter, internal) ? "" : "⌀" + number(diameter) + " there";
    const scene::Thread& form = wall.thread->form;
    const bool is_pitch = !(one.pitch > 0) || std::abs(one.pitch - form.pitch) <= definition::same_size * form.pitch;
    return is_pitch && one.allows(form.diameter, definition::same_size * form.diameter) ? "" : form.text + " there";
  }

  // From the end of the thread to the beginning of its wall, or of that of a wall before it, of which `walls` are all.
  [[nodiscard]] std::string denied_length_of_thread(const NotedElement& one, const std::vector<HoleWall>& walls) const {
    const auto wall = std::ranges::find_if(walls, [](const HoleWall& own) { return own.thread.has_value(); });
    check(wall != walls.end(), "a thread is stated");
    const std::array<double, 2>& at = wall->thread->at;
    const bool is_from_low = at[0] <= wall->at[0] + walls_.slack(),
               is_from_high = at[1] >= wall->at[1] - walls_.slack();
    for (const double length :
         {at[1] - at[0], is_from_high ? walls.back().at[1] - at[0] : 0, is_from_low ? at[1] - walls.front().at[0] : 0})
      if (one.allows(length, walls_.slack() + definition::same_size * length)) return "";
    return wall->thread->form.text + " ↧" + number(at[1] - at[0]) + " there";
  }

  // "M8 THRU" is said of the thread, "M8 ↧15/⌀6.8 THRU" of its drill.
  [[nodiscard]] bool is_threaded_through() const {
    return has(NotedRole::thread) && !has(NotedRole::drill) && !has(NotedRole::depth);
  }

  [[nodiscard]] std::string denied_end_of_thread(const HoleChain& chain) const {
    const HoleWall& wall = chain.walls[chain.own];
    if (!wall.thread || wall.thread->at[1] - wall.thread->at[0] >= wall.length() - walls_.slack()) return "";
    return wall.thread->form.text + " ↧" + number(wall.thread->at[1] - wall.thread->at[0]) + " there";
  }

  // What is drawn as wide as the thread may be drilled narrower.
  [[nodiscard]] std::string denied_drill(const NotedElement& one, const HoleChain& chain) const {
    const auto thread =
        std::ranges::find_if(elements_, [](const NotedElement& other) { return other.role == NotedRole::thread; });
    const double diameter = 2 * chain.walls[chain.own].widest();
    const bool is_wide = thread != elements_.end() && thread->allows(diameter, 2 * walls_.slack());
    if (is_wide || wall_of(NotedRole::drill, one.least, one.slack, chain)) return "";
    return "⌀" + number(diameter) + " there";
  }

  const NotedText& text_;
  std::span<const NotedElement> elements_;  // that are understood
  const HoleWalls& walls_;
  const Notation& notation_;
};

}  // namespace

bool is_of_hole(const NotedElement& one) {
  const bool is_behind_diameter = one.of > 0 && (one.role == NotedRole::angle || one.role == NotedRole::length);
  return one.is_recess() || one.role == NotedRole::depth || one.role == NotedRole::through ||
         one.role == NotedRole::blind || one.role == NotedRole::thread || one.role == NotedRole::drill ||
         is_behind_diameter;
}

std::string number_text(double millimetres, const Notation& notation) {
  return format_rounded(millimetres / scene::millimetres(notation.unit), 6);
}

bool is_at_recess(const NotedText& text, double diameter, const HoleWalls& walls) {
  const auto elements = text.all_understood();
  return text.size() != nullptr && text.size()->sign == NotedSign::diameter &&
         std::ranges::any_of(elements, [&](const NotedElement& one) {
           return one.is_recess() && one.allows(diameter, definition::same_size * diameter + 2 * walls.slack());
         });
}

WorldCircle circle_meant(const NotedText& text, WorldCircle noted, const HoleWalls& walls) {
  const auto elements = text.all_understood();
  if (std::ranges::any_of(elements, [](const NotedElement& one) { return one.role == NotedRole::thread; }))
    return walls.bore_of(noted, core_of_thread);
  if (is_at_recess(text, 2 * noted.radius, walls)) noted.radius = text.size()->least / 2;
  return noted;
}

void judge_hole(Verdict& verdict, const NotedText& text, const WorldCircle& noted, const HoleWalls& walls,
                const Notation& notation) {
  HoleJudge(text, walls, notation).judge(verdict, noted);
}

}  // namespace epura::sheet
