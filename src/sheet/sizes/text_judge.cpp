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
#include "sizes/fits.hpp"
#include "sizes/general_notes.hpp"
#include "sizes/hole_judge.hpp"
#include "sizes/hole_walls.hpp"
#include "sizes/note_text.hpp"
#include "sizes/noted_chamfers.hpp"
#include "sizes/place_joins.hpp"
#include "sizes/stated_values.hpp"

namespace epura::sheet {

namespace {

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
      judge_hole(verdict, text, dimension.circles.front(), walls_, notation_);
    else
      judge_length(verdict, text, dimension, view);
    return verdict;
  }

  // With a leader to a place in the world.
  Verdict judge(const LeaderNote& note) {
    Verdict verdict;
    const NotedText text = read_text(note.text, notation_);
    if (text.elements.empty()) return verdict;
    if (!text.unread.empty()) verdict.doubt("'" + text.unread + "'");
    const NotedElement* size = text.size();
    const std::optional<WorldCircle> circle = walls_.circle_of(note);
    const bool is_chamfer = size != nullptr && size->sign == NotedSign::none && has_slope(text);
    if (is_chamfer && note.at) return judge_chamfer(std::move(verdict), text, *note.at);
    if (circle && size == nullptr && text.gives_thread()) {
      judge_hole(verdict, text, *circle, walls_, notation_);
      return verdict;
    }
    const bool is_round = size != nullptr && size->sign != NotedSign::degrees && size->sign != NotedSign::square;
    const double half = is_round && (size->sign == NotedSign::radius || size->sign == NotedSign::sphere_radius) ? 1 : 2;
    const double measured = circle ? half * circle->radius : 0;
    const bool is_it = is_round && circle && size->allows(measured, walls_.slack());
    // "8× 10" at a hole of 10
    if (!circle || !is_round || (size->sign == NotedSign::none && !is_it)) {
      verdict.doubt("'" + note.text + "'");
      return verdict;
    }
    if (!is_it && !is_at_recess(text, measured, walls_)) verdict.deny(number(measured));
    judge_zone(verdict, text);
    judge_hole(verdict, text, *circle, walls_, notation_);
    return verdict;
  }

  /// Of all things of a kind that no other text gives.
  Verdict judge_general(const std::string& text, std::span<const DimensionsInView> views) {
    const NotedText read = read_text(text, notation_);
    Verdict verdict;
    if (read.elements.empty()) return verdict;
    if (!read.unread.empty()) verdict.doubt("'" + read.unread + "'");
    judge_of_kind(verdict, read, given_elsewhere(views), walls_, world_, notation_);
    return verdict;
  }

 private:
  // A label stands for what its row in a table says.
  [[nodiscard]] std::string written(const AnchoredDimension& dimension, const DimensionsInView& view) const {
    const auto row = view.sizes_in_tables.find(dimension.text);
    if (dimension.is_label) return row == view.sizes_in_tables.end() ? std::string() : row->second;
    return text_of(dimension, view, notation_);
  }

  [[nodiscard]] std::string number(double millimetres) const { return number_text(millimetres, notation_); }

  // What other texts say of holes and radii.
  [[nodiscard]] std::vector<GivenSize> given_elsewhere(std::span<const DimensionsInView> views) const {
    std::vector<GivenSize> given;
    for (const DimensionsInView& view : views) {
      for (const AnchoredDimension& dimension : view.dimensions)
        for (const WorldCircle& circle : dimension.circles)
          given.push_back({circle, read_text(written(dimension, view), notation_)});
      for (const LeaderNote& note : view.notes)
        if (const auto circle = walls_.circle_of(note)) given.push_back({*circle, read_text(note.text, notation_)});
    }
    return given;
  }

  // "2×45°", "2×2"
  static bool has_slope(const NotedText& text) {
    return std::ranges::any_of(text.all_understood(), [](const NotedElement& one) {
      return (one.role == NotedRole::angle || one.role == NotedRole::length) && one.of <= 0;
    });
  }

  Verdict judge_chamfer(Verdict verdict, const NotedText& text, const Vec3& at) {
    const std::vector<ChamferLegs> chamfers = chamfers_at(at, walls_, world_);
    const bool suits = std::ranges::any_of(
        chamfers, [&](const ChamferLegs& one) { return one.suits(text, 2 * walls_.slack(), angle_doubt); });
    if (chamfers.empty()) verdict.doubt("whether a chamfer is there");
    if (!chamfers.empty() && !suits) verdict.deny(chamfers.front().text(notation_) + " there");
    if (text.count == 1 || !suits) return verdict;
    const int count = EqualLengths(walls_.parts(), world_, walls_.slack()).slopes(text.size()->least);
    if (count < text.count) verdict.deny(std::to_string(count) + " of these");
    return verdict;
  }

  // "80 H7 (80.03/80)": what the class allows.
  void judge_zone(Verdict& verdict, const NotedText& text) const {
    const NotedElement* size = text.size();
    for (const NotedElement& one : text.all_understood()) {
      if (one.role != NotedRole::limits || size == nullptr || !(size->least > 0)) continue;
      if (text.fit.empty()) {
        if (!one.allows(size->least, 0)) verdict.deny("other limits than those of its size");
        continue;
      }
      constexpr double rounded = 5e-4;  // mm, of deviations in micrometres
      try {
        const auto zone = deviations_of(parse_tolerance_class(text.fit, ""), size->least, "");
        if (std::abs(one.least - size->least - zone.lower) > one.slack + rounded ||
            std::abs(one.most - size->least - zone.upper) > one.slack + rounded)
          verdict.deny("other limits by " + text.fit + ": " + number(size->least + zone.upper) + "/" +
                       number(size->least + zone.lower));
      } catch (const Error&) {
        verdict.doubt("what " + text.fit + " allows");
      }
    }
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
    if (size != nullptr && !size->allows(of_circle * *measured, doubt) && !is_at_recess(text, *measured, walls_))
      verdict.deny(has);
    judge_zone(verdict, text);
    for (const NotedElement& one : text.all_understood()) {
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
    for (const NotedElement& one : text.all_understood()) judge_kind(verdict, one, dimension, along);
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
    if (one.role == NotedRole::circle || one.role == NotedRole::evenly) return verdict.doubt("what is on a circle");
    if (one.role == NotedRole::length) return verdict.doubt("what has a length of " + number(one.least));
    if (is_of_hole(one)) return verdict.deny("no hole there");
    if (one.role == NotedRole::angle && along) return judge_slope(verdict, one, dimension, *along);
    if (one.role != NotedRole::size || one.sign == NotedSign::none || one.sign == NotedSign::degrees) return;
    if (one.sign == NotedSign::square) {
      if (EqualLengths(walls_.parts(), world_, walls_.slack()).lengths(one.least) < 2) verdict.deny("no square there");
      return;
    }
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

  const world::World& world_;
  const Notation& notation_;
  HoleWalls walls_;
};

}  // namespace

JudgedTexts judge_texts(std::span<const DimensionsInView> views, std::span<const std::string> general,
                        const world::World& world, const Notation& notation) {
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
  for (const std::string& note : general) add(judge.judge_general(note, views), "'" + note + "'");
  return found;
}

}  // namespace epura::sheet
