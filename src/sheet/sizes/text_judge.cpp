// SPDX-License-Identifier: Apache-2.0
#include "sizes/text_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "scene/choices.hpp"
#include "sizes/dimension_names.hpp"
#include "sizes/equal_lengths.hpp"
#include "sizes/hole_walls.hpp"
#include "sizes/note_text.hpp"
#include "sizes/place_joins.hpp"
#include "sizes/stated_values.hpp"

namespace epura::sheet {

namespace {

constexpr double angle_doubt = 0.02;  ///< degrees, of fitted cones

/// What is found of one text. The first fault is told.
struct Verdict {
  std::string has{};     ///< the part, where the text says otherwise
  std::string unsure{};  ///< of what nobody can tell

  void doubt(const std::string& what) {
    if (unsure.empty()) unsure = what;
  }
  void deny(const std::string& what) {
    if (has.empty()) has = what;
  }
};

bool is_of_hole(const NotedElement& one) {
  return one.is_recess() || one.role == NotedRole::depth || one.role == NotedRole::through ||
         one.role == NotedRole::blind || one.role == NotedRole::thread ||
         (one.role == NotedRole::angle && one.of_role != NotedRole::size);
}

double diameter_of(const NotedElement& one) { return one.sign == NotedSign::radius ? 2 * one.least : one.least; }

class Judge {
 public:
  Judge(const world::World& world, const Notation& notation) : world_(world), notation_(notation), walls_(world) {}

  Verdict judge(const AnchoredDimension& dimension, const DimensionsInView& view) {
    Verdict verdict;
    if (dimension.arrangement) {
      if (dimension.text.find_first_not_of("<>") != std::string::npos) verdict.doubt("of a row of lengths");
      return verdict;
    }
    const bool is_hole = dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius;
    const bool is_written = dimension.text.find_first_not_of("<>") != std::string::npos;
    if (!is_written && !dimension.stated && !dimension.is_label) return verdict;
    const NotedText text = read_text(written(dimension, view), notation_);
    if (!text.unread.empty()) verdict.doubt("'" + text.unread + "'");
    judge_size(verdict, text, dimension, view);
    if (is_hole && !dimension.circles.empty())
      judge_hole(verdict, text, dimension.circles.front());
    else
      judge_length(verdict, text, dimension, view);
    return verdict;
  }

  // With a leader to a place in the world.
  Verdict judge(const LeaderNote& note) {
    Verdict verdict;
    const NotedText text = read_text(note.text, notation_);
    if (text.elements.empty()) return verdict;
    const std::optional<WorldCircle> circle = note.at ? walls_.circle_through(*note.at) : std::optional<WorldCircle>();
    const NotedElement* size = text.size();
    const bool is_round = size != nullptr && (size->sign == NotedSign::diameter || size->sign == NotedSign::radius);
    if (!text.unread.empty()) verdict.doubt("'" + text.unread + "'");
    if (!circle || !is_round) {
      verdict.doubt("'" + note.text + "'");
      return verdict;
    }
    const double measured = (size->sign == NotedSign::radius ? 1 : 2) * circle->radius;
    if (!size->allows(measured, walls_.slack()) && !is_at_recess(text, measured)) verdict.deny(number(measured));
    judge_hole(verdict, text, *circle);
    return verdict;
  }

 private:
  // A label stands for what its row in a table says.
  [[nodiscard]] std::string written(const AnchoredDimension& dimension, const DimensionsInView& view) const {
    const auto row = view.sizes_in_tables.find(dimension.text);
    if (dimension.is_label) return row == view.sizes_in_tables.end() ? std::string() : row->second;
    return text_of(dimension, view, notation_);
  }

  [[nodiscard]] std::string number(double millimetres) const {
    return format_rounded(millimetres / scene::millimetres(notation_.unit), 6);
  }

  // What is measured, its sum and the same in another unit.
  void judge_size(Verdict& verdict, const NotedText& text, const AnchoredDimension& dimension,
                  const DimensionsInView& view) {
    const std::optional<double> measured = measured_size(dimension, view);
    if (!measured) return verdict.doubt("what it measures");
    const bool is_angle = dimension.type == DimensionType::angular;
    const std::string has = is_angle ? format_rounded(*measured, 6) + "°" : number(*measured);
    const NotedElement* size = text.size();
    if (size == nullptr && text.unread.empty() && std::ranges::none_of(text.elements, is_of_hole))
      verdict.doubt("a text without a size");
    if (size != nullptr && (size->sign == NotedSign::degrees) != is_angle) return verdict.deny(has);
    const double doubt = is_angle ? angle_doubt * 1e-3 : definition::same_size * 1e-3 * *measured;
    const double of_circle = dimension.type == DimensionType::diameter && size != nullptr &&
                                     (size->sign == NotedSign::radius || size->sign == NotedSign::sphere_radius)
                                 ? 0.5
                                 : 1;
    if (size != nullptr && !size->allows(of_circle * *measured, doubt) && !is_at_recess(text, *measured))
      verdict.deny(has);
    for (std::size_t i = 0; i < text.understood; ++i) {
      const NotedElement& one = text.elements[i];
      if (one.role != NotedRole::other_unit) continue;
      const double inch = scene::millimetres(Unit::in);
      const bool is_it = one.unit > 0 ? one.allows(*measured, doubt)
                                      : one.allows(*measured, doubt) || one.allows(*measured / inch, doubt) ||
                                            one.allows(*measured * inch, doubt);
      if (!is_it) verdict.deny(has);
    }
  }

  // Whether a length has the kind and the count that its text says.
  void judge_length(Verdict& verdict, const NotedText& text, const AnchoredDimension& dimension,
                    const DimensionsInView& view) {
    std::optional<Vec3> along = measured_along(dimension, view);
    if (dimension.type == DimensionType::overall) along = Mat3(1)[axis_of(*dimension.direction)];
    for (std::size_t i = 0; i < text.understood; ++i) judge_kind(verdict, text.elements[i], dimension, along);
    if (text.count == 1 || !verdict.has.empty()) return;
    const NotedElement* size = text.size();
    if (size != nullptr && size->role == NotedRole::sum) return judge_row(verdict, text, dimension, along);
    const EqualLengths equal(walls_.parts(), world_, walls_.slack());
    const std::optional<double> measured = measured_size(dimension, view);
    const bool is_chamfer = std::ranges::any_of(
        text.elements, [](const NotedElement& one) { return one.role == NotedRole::angle && one.of <= 0; });
    const int count = !measured                                  ? 0
                      : dimension.type == DimensionType::angular ? angles_like(equal, dimension, view, *measured)
                      : is_chamfer                               ? equal.slopes(*measured)
                                                                 : equal.lengths(*measured);
    if (count == 0) return verdict.doubt("how many of these there are");
    if (count < text.count) verdict.deny(std::to_string(count) + " of these");
  }

  static int angles_like(const EqualLengths& equal, const AnchoredDimension& dimension, const DimensionsInView& view,
                         double angle) {
    const Vec3& corner = dimension.points[0];
    return equal.angles(angle, corner, glm::normalize(dimension.points[1] - corner), view.projection.n);
  }

  void judge_kind(Verdict& verdict, const NotedElement& one, const AnchoredDimension& dimension,
                  const std::optional<Vec3>& along) {
    if (is_of_hole(one)) return verdict.deny("no hole there");
    if (one.role == NotedRole::angle && along) return judge_slope(verdict, one, dimension, *along);
    if (one.role != NotedRole::size || one.sign == NotedSign::none || one.sign == NotedSign::degrees) return;
    if (one.sign == NotedSign::square) return verdict.doubt("a square");
    const bool is_radius = one.sign == NotedSign::radius || one.sign == NotedSign::sphere_radius;
    const double radius = (is_radius ? 1 : 0.5) * one.least;
    if (!along || is_radius || !walls_.is_between(dimension.points[0], dimension.points[1], radius, *along)) {
      const bool any_part = std::ranges::any_of(walls_.parts(), [](const auto& part) { return part.has_value(); });
      if (any_part)
        verdict.deny(std::string("no ") + (is_radius ? "radius" : "diameter") + " there");
      else
        verdict.doubt("whether something round is there");
    }
  }

  // "3×45°": between the length and the slope at which it ends.
  static void judge_slope(Verdict& verdict, const NotedElement& one, const AnchoredDimension& dimension,
                          const Vec3& along) {
    const Vec3 off = dimension.points[1] - dimension.points[0];
    const double length = std::abs(glm::dot(off, along)), aside = glm::length(off - glm::dot(off, along) * along);
    if (!(aside > definition::same_size * length)) return verdict.doubt("where the slope is");
    const double angle = std::atan2(aside, length) * degrees;
    if (!one.allows(angle, angle_doubt) && !one.allows(90 - angle, angle_doubt))
      verdict.deny(format_rounded(angle, 4) + "° there");
  }

  // "3× 20 (=60)": each is as long as it says, and something is at all of their ends.
  void judge_row(Verdict& verdict, const NotedText& text, const AnchoredDimension& dimension,
                 const std::optional<Vec3>& along) {
    const auto size = std::ranges::find_if(text.elements, [](const auto& one) { return one.role == NotedRole::size; });
    const NotedElement& sum = *text.size();
    if (size == text.elements.end() || !along) return verdict.doubt("what the sum is of");
    if (std::abs(size->least * text.count - sum.least) > size->slack * text.count + sum.slack)
      return verdict.deny("another length for each of " + std::to_string(text.count));
    const EqualLengths equal(walls_.parts(), world_, walls_.slack());
    for (int i = 1; i < text.count; ++i) {
      const double share = static_cast<double>(i) / text.count;
      const Vec3 place = dimension.points[0] + share * (dimension.points[1] - dimension.points[0]);
      if (!equal.has_place(place, *along, size->slack))
        return verdict.deny("nothing at the end of each of " + std::to_string(text.count) + " lengths");
    }
  }

  // Whether the leader of a note ends at the rim of the recess that the note gives.
  [[nodiscard]] bool is_at_recess(const NotedText& text, double diameter) const {
    const auto elements = std::span(text.elements).first(text.understood);
    return text.size() != nullptr && text.size()->sign == NotedSign::diameter &&
           std::ranges::any_of(elements, [&](const NotedElement& one) {
             return one.is_recess() && one.allows(diameter, definition::same_size * diameter + 2 * walls_.slack());
           });
  }

  // The circle that the size of a note means: of a thread its bore, of a note at its recess the wall below.
  [[nodiscard]] WorldCircle circle_meant(const NotedText& text, WorldCircle noted, bool is_thread) const {
    if (is_thread) return walls_.bore_of(noted, core_of_thread);
    if (is_at_recess(text, 2 * noted.radius)) noted.radius = text.size()->least / 2;
    return noted;
  }

  // What a note says of the walls about the circle where it ends, and of how many there are.
  void judge_hole(Verdict& verdict, const NotedText& text, const WorldCircle& noted) {
    const std::vector<NotedElement> elements(text.elements.begin(),
                                             text.elements.begin() + static_cast<std::ptrdiff_t>(text.understood));
    check(elements.size() <= text.elements.size(), "what is understood is part of a text");
    const bool any_of_hole = std::ranges::any_of(elements, is_of_hole);
    if (!any_of_hole && text.count == 1) return;
    const bool is_thread = std::ranges::any_of(elements, [](const auto& one) { return one.role == NotedRole::thread; });
    const WorldCircle circle = circle_meant(text, noted, is_thread);
    const std::optional<HoleChain> chain = walls_.chain_at(circle);
    if (!chain && any_of_hole && !is_thread) {
      if (walls_.has_round(circle)) return verdict.deny("no hole there");
      return verdict.doubt("whether a hole is there");
    }
    if (chain)
      for (const NotedElement& one : elements)
        if (const std::string has = denied(one, *chain); !has.empty()) verdict.deny(has);
    if (text.count == 1 || !verdict.has.empty()) return;
    int count = 0;
    if (chain && any_of_hole)
      for (const HoleChain& one : walls_.chains_of(circle.radius))
        count += std::ranges::all_of(elements, [&](const auto& of) { return denied(of, one).empty(); }) ? 1 : 0;
    else
      count = walls_.faces_of(circle.radius);
    if (count == 0) return verdict.doubt("how many of these there are");
    if (count < text.count) verdict.deny(std::to_string(count) + " of these");
  }

  // What the part has where an element of a note says something else; empty if it is right.
  [[nodiscard]] std::string denied(const NotedElement& one, const HoleChain& chain) const {
    switch (one.role) {
      case NotedRole::counterbore:
      case NotedRole::countersink:
        return denied_recess(one, chain);
      case NotedRole::depth:
        return denied_depth(one, chain);
      case NotedRole::angle:
        return denied_angle(one, chain);
      case NotedRole::thread:
        return denied_thread(one, chain);
      case NotedRole::through:
        return chain.ends_at(chain.own, 0) || chain.ends_at(chain.own, 1) ? "a blind hole there" : "";
      case NotedRole::blind:
        return chain.ends_at(chain.own, 0) || chain.ends_at(chain.own, 1) ? "" : "a through hole there";
      default:
        return "";
    }
  }

  // The wall that a diameter in a note means; nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> wall_of(NotedRole role, double diameter, double slack,
                                                   const HoleChain& chain) const {
    if (!is_recess(role)) return chain.own;
    for (std::size_t i = 0; i < chain.walls.size(); ++i) {
      const HoleWall& wall = chain.walls[i];
      const double doubt = 2 * (walls_.slack() + wall.doubt) + definition::same_size * diameter;
      if (i != chain.own && wall.is_cone() == (role == NotedRole::countersink) &&
          std::abs(2 * wall.widest() - diameter) <= slack + doubt)
        return i;
    }
    return std::nullopt;
  }

  static bool is_recess(NotedRole role) { return role == NotedRole::counterbore || role == NotedRole::countersink; }

  [[nodiscard]] std::string denied_recess(const NotedElement& one, const HoleChain& chain) const {
    if (wall_of(one.role, diameter_of(one), one.slack, chain)) return "";
    const bool is_bore = one.role == NotedRole::counterbore;
    const NotedRole other = is_bore ? NotedRole::countersink : NotedRole::counterbore;
    if (wall_of(other, diameter_of(one), one.slack, chain))
      return is_bore ? "a countersink there" : "a counterbore there";
    return std::string("no ") + (is_bore ? "counterbore" : "countersink") + " of ⌀" + number(diameter_of(one)) +
           " there";
  }

  // From the end of the wall to its beginning, or to the mouth; to where a mouth in a round face begins or ends.
  [[nodiscard]] std::string denied_depth(const NotedElement& one, const HoleChain& chain) const {
    const std::optional<std::size_t> at = wall_of(one.of_role, one.of, diameter_slack(one), chain);
    if (!at) return "";  // the recess itself is denied
    const HoleWall& wall = chain.walls[*at];
    const bool is_thread = one.of_role == NotedRole::thread;
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

  [[nodiscard]] std::string denied_angle(const NotedElement& one, const HoleChain& chain) const {
    std::string has;
    for (const HoleWall& wall : chain.walls) {
      if (!wall.is_cone()) continue;
      if (one.allows(wall.angle, angle_doubt)) return "";
      has = format_rounded(wall.angle, 4) + "° there";
    }
    return has.empty() ? "no cone there" : has;
  }

  // Its hole is drilled for it, or drawn as wide as the thread.
  [[nodiscard]] std::string denied_thread(const NotedElement& one, const HoleChain& chain) const {
    const double diameter = 2 * chain.walls[chain.own].widest();
    const bool is_it = one.least <= 0 || (diameter >= core_of_thread * one.least &&
                                          diameter <= one.least * (1 + features::same_size) + 2 * walls_.slack());
    return is_it ? "" : "⌀" + number(diameter) + " there";
  }

  const world::World& world_;
  const Notation& notation_;
  HoleWalls walls_;
};

}  // namespace

JudgedTexts judge_texts(std::span<const DimensionsInView> views, const world::World& world, const Notation& notation) {
  JudgedTexts found;
  Judge judge(world, notation);
  const DimensionNames names(views, notation);
  const auto add = [&found](const Verdict& verdict, const std::string& name) {
    if (!verdict.has.empty()) found.untrue.push_back(name + ": the part has " + verdict.has);
    if (verdict.has.empty() && !verdict.unsure.empty()) found.unjudged.push_back(name + ": " + verdict.unsure);
  };
  for (std::size_t view = 0; view < views.size(); ++view) {
    for (std::size_t i = 0; i < views[view].dimensions.size(); ++i)
      add(judge.judge(views[view].dimensions[i], views[view]), names.name_of({view, i}));
    for (const LeaderNote& note : views[view].notes)
      add(judge.judge(note), "'" + note.text + "' in view '" + views[view].view + "'");
  }
  return found;
}

}  // namespace epura::sheet
