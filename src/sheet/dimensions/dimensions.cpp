// SPDX-License-Identifier: Apache-2.0
#include "dimensions/dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/measure.hpp"
#include "dimensions/shown_circle.hpp"
#include "dimensions/strokes.hpp"
#include "dimensions/surroundings.hpp"
#include "drawing/drawing.hpp"
#include "sheet/line_styles.hpp"
#include "sizes/anchors.hpp"

namespace epura::sheet {

namespace {

// The tip of an arrow, or the centre of a dot.
Vec2 end_of(const Fill& mark) {
  constexpr std::size_t corners_of_arrow = 3;
  const std::vector<Vec2>& ring = mark.rings.front();
  if (ring.size() <= corners_of_arrow) return ring.front();
  return std::accumulate(ring.begin(), ring.end(), Vec2(0)) / static_cast<double>(ring.size());
}

template <class Form>
void check_ends(const Form& form, const PlacedDimension& dimension) {
  for (const Fill& arrow : dimension.arrows)
    check(ends_at(form, end_of(arrow)), "a dimension ends at what it measures");
}

struct BestPlacement {
  const PlacedDimension* dimension;
  double cost;
};

// The cheapest placement if it costs less than `best`. They are in ascending order of their cost.
BestPlacement better_of(std::vector<DimensionPlacement>& placements, const Surroundings& surroundings,
                        BestPlacement best) {
  for (DimensionPlacement& placement : placements) {
    if (placement.cost >= best.cost) break;
    const PlacedDimension& drawn = placement.drawn();
    const double cost = placement.cost + surroundings.cost(drawn, best.cost - placement.cost);
    if (cost < best.cost) best = {&drawn, cost};
  }
  return best;
}

// The cheapest placement, or the first one if all are in a crowd.
BestPlacement best_of(std::vector<DimensionPlacement>& placements, const Surroundings& surroundings) {
  check(!placements.empty(), "a dimension has a place");
  return better_of(placements, surroundings, {&placements.front().drawn(), cost_in_crowd});
}

// Less usual placements, of forms that have some.
std::vector<DimensionPlacement> placements_in_crowd(const MeasuredDimension& measured,
                                                    const drawing::ViewDrawing& drawing, const DimensionStyle& style) {
  if (const auto* length = std::get_if<MeasuredLength>(&measured.form))
    return placements_in_crowd(*length, measured, drawing, style);
  if (const auto* circle = std::get_if<MeasuredCircle>(&measured.form))
    return placements_in_crowd(*circle, measured, drawing, style);
  return {};
}

void sort_by_cost(std::vector<DimensionPlacement>& placements) {
  std::stable_sort(placements.begin(), placements.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
}

// Dimensions without a choice come first; then distances, small before large; then angles; then circles.
std::vector<std::size_t> order_of(const std::vector<MeasuredDimension>& dimensions) {
  const auto rank = [&](std::size_t i) {
    const MeasuredDimension& dimension = dimensions[i];
    const auto* length = std::get_if<MeasuredLength>(&dimension.form);
    const auto* row = std::get_if<MeasuredRow>(&dimension.form);
    const double size = length ? std::abs(glm::dot(length->to - length->from, length->along)) : row ? row->size() : 0;
    return std::tuple(!dimension.offset, row ? std::size_t{0} : dimension.form.index(), size, i);
  };
  std::vector<std::size_t> order(dimensions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

/// The dimensions of a view that it shows, and their numbers among all.
struct ShownDimensions {
  std::vector<MeasuredDimension> measured;
  std::vector<std::size_t> numbers;
  std::size_t found = 0;    ///< as in DimensionedView
  std::size_t leaving = 0;  ///< how many, the first ones, may be left out: these, and what model files require

  MeasuredDimension& add(std::size_t number, const DimensionedView& view, MeasuredDimension one) {
    if (number < view.found) ++found;
    if (number < view.found || !view.dimensions[number].requirement.empty()) ++leaving;
    numbers.push_back(number);
    return measured.emplace_back(std::move(one));
  }
};

/// Places the dimensions of a view one after the other.
class Placer {
 public:
  Placer(const ShownDimensions& shown, const drawing::ViewDrawing& drawing, const DimensionStyle& style,
         const Neighbours& neighbours)
      : shown_(shown),
        dimensions_(shown.measured),
        drawing_(drawing),
        style_(style),
        neighbours_(neighbours),
        order_(order_of(dimensions_)),
        surroundings_(drawing, neighbours),
        placed_(dimensions_.size()),
        is_lost_(dimensions_.size(), false),
        stays_(dimensions_.size(), false) {}

  void place_all(const Progress& progress) {
    for (const std::size_t i : order_) {
      if (progress.is_out_of_time()) break;
      if (has_lost_twin(i))
        is_lost_[i] = true;
      else
        place(i);
      if (is_dropped(i)) lost_.try_emplace(places_of(dimensions_[i]), size_of(i));
      progress.advance(1);
    }
    const auto has_place = [this](std::size_t i) { return placed_[i].has_value() || is_dropped(i); };
    check(progress.is_out_of_time() || std::all_of(order_.begin(), order_.end(), has_place),
          "every dimension has a place");
    place_crossed_anew(progress);
  }

  /// Takes out some of those that may be left out until none of these has conflicts, and puts back those for which
  /// there is room then. If some remain, less usual places are tried. Returns the numbers of those that are left out.
  std::vector<std::size_t> leave_out(const Progress& progress) {
    const std::size_t count = shown_.leaving;
    check(!is_crowded_, "room is looked for once");
    is_searching_ = true;
    const PlacedDimensions all = placed_;
    std::vector<std::size_t> left_out = leave_out_crossed(count, progress);
    if (left_out.empty() || left_out.size() > max_in_crowd) return left_out;
    const PlacedDimensions usual = placed_;
    is_crowded_ = true;
    put_back(all);
    place_crossed_anew(progress);
    std::vector<std::size_t> others = leave_out_crossed(count, progress);
    if (others.size() < left_out.size())
      left_out = std::move(others);
    else
      put_back(usual);
    std::erase_if(left_out, [&](std::size_t i) { return !progress.is_out_of_time() && makes_room_in_crowd(i, count); });
    std::erase_if(gone_, [this](std::size_t i) { return placed_[i].has_value(); });
    left_out.insert(left_out.end(), gone_.begin(), gone_.end());
    std::sort(left_out.begin(), left_out.end());
    left_out.erase(std::unique(left_out.begin(), left_out.end()), left_out.end());
    return left_out;
  }

  PlacedDimensions result() { return std::move(placed_); }

 private:
  // Those that later ones cross are placed anew, now that all others are known. No round makes anything worse. Those
  // whose places were all in a crowd would find no better one: there are more in it now.
  void place_crossed_anew(const Progress& progress) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
      for (const std::size_t i : order_) {
        if (!placed_[i] || is_lost_[i] || progress.is_out_of_time()) continue;
        surroundings_.remove(*placed_[i]);
        const bool is_crossed = surroundings_.cost(*placed_[i], cost_of_text) >= cost_of_text;
        surroundings_.add(*placed_[i]);
        if (!is_crossed) continue;
        take(i);
        place(i);
      }
  }
  // Those with most conflicts are taken out first, and rows, which stand for many, last.
  std::vector<std::size_t> leave_out_crossed(std::size_t count, const Progress& progress) {
    std::vector<int> conflicts(count);
    for (std::size_t i = 0; i < count; ++i)
      if (placed_[i]) conflicts[i] = conflicts_of(i);
    std::vector<std::size_t> left_out;
    for (std::size_t i = 0; i < count; ++i)
      if (!placed_[i]) left_out.push_back(i);
    for (;;) {
      const std::size_t number = worst_of(conflicts);
      if (number == count || conflicts[number] == 0) break;
      check(conflicts[number] > 0 && placed_[number], "what has conflicts is placed");
      for (std::size_t i = 0; i < count; ++i)
        if (i != number && placed_[i] && do_cross(*placed_[i], *placed_[number])) --conflicts[i];
      conflicts[number] = 0;
      take(number);
      left_out.push_back(number);
    }
    std::sort(left_out.begin(), left_out.end());
    const bool are_few = left_out.size() <= max_in_crowd;
    std::erase_if(left_out, [&](std::size_t i) {
      return !progress.is_out_of_time() && !is_dropped(i) && (finds_room(i) || (are_few && makes_room(i, count)));
    });
    return left_out;
  }
  void place(std::size_t i) {
    // Rows are large, and in a search for room all are tried again and again.
    const auto [known, is_new] = usual_.try_emplace(i);
    if (is_new) known->second = placements(i);
    BestPlacement best = best_of(known->second, surroundings_);
    is_lost_[i] = best.cost >= cost_in_crowd;
    if (is_crowded_ && best.cost >= cost_of_text) best = better_of(more_placements(i), surroundings_, best);
    if (!is_dropped(i)) placed_[i] = *best.dimension;
    if (!is_searching_ && !is_row(i)) usual_.erase(known);
    if (!placed_[i]) return;
    std::visit([&](const auto& form) { check_ends(form, *placed_[i]); }, dimensions_[i].form);
    place_at_equal(i, best.cost);
    surroundings_.add(*placed_[i]);
  }
  // At another one of equal features if that is clearly better.
  void place_at_equal(std::size_t i, double cost) {
    for (const MeasuredCircle& circle : dimensions_[i].equal) {
      const double bar = cost - cost_of_crossing;
      if (bar <= cost_of_slope) return;  // hardly anything is better
      std::vector<DimensionPlacement> there = placements_of(circle, dimensions_[i], drawing_, style_);
      sort_by_cost(there);
      const BestPlacement better = better_of(there, surroundings_, {&*placed_[i], bar});
      if (better.cost == bar) continue;
      placed_[i] = *better.dimension;
      check_ends(circle, *placed_[i]);
      cost = better.cost;
    }
  }
  [[nodiscard]] std::vector<DimensionPlacement> placements(std::size_t i) const {
    const auto of_form = [&](const auto& form) { return placements_of(form, dimensions_[i], drawing_, style_); };
    std::vector<DimensionPlacement> all = std::visit(of_form, dimensions_[i].form);
    sort_by_cost(all);
    return all;
  }
  std::vector<DimensionPlacement>& more_placements(std::size_t i) {
    auto [known, is_new] = more_.try_emplace(i);
    if (is_new) known->second = placements_in_crowd(dimensions_[i], drawing_, style_);
    if (is_new) sort_by_cost(known->second);
    return known->second;
  }
  // What a model file requires takes no place that makes others hard to read. There is less room later on.
  [[nodiscard]] bool is_dropped(std::size_t i) const { return is_lost_[i] && is_required(i) && !is_crowded_; }
  [[nodiscard]] Vec2 size_of(std::size_t i) const {
    return {style_.width(dimensions_[i].text), style_.height(dimensions_[i].text)};
  }
  // What measures the same has the same places. While dimensions only come, there is none for a text that is no smaller
  // than one for which there was none.
  [[nodiscard]] bool has_lost_twin(std::size_t i) const {
    if (!is_required(i)) return false;
    const auto twin = lost_.find(places_of(dimensions_[i]));
    if (twin == lost_.end()) return false;
    const Vec2 size = size_of(i);
    return size.x >= twin->second.x && size.y >= twin->second.y;
  }
  [[nodiscard]] bool is_required(std::size_t i) const { return i >= shown_.found && i < shown_.leaving; }
  [[nodiscard]] bool is_row(std::size_t i) const { return std::holds_alternative<MeasuredRow>(dimensions_[i].form); }
  void take(std::size_t i) {
    surroundings_.remove(*placed_[i]);
    placed_[i].reset();
  }
  bool finds_room(std::size_t i) {
    place(i);
    if (!placed_[i]) return false;
    if (conflicts_of(i) == 0) return true;
    take(i);
    return false;
  }
  // Of several, the last one: overall dimensions are first.
  [[nodiscard]] std::size_t worst_of(const std::vector<int>& conflicts) const {
    std::size_t worst = conflicts.size();
    const auto rank = [&](std::size_t i) { return std::pair(conflicts[i] > 0 && !is_row(i), conflicts[i]); };
    for (std::size_t i = 0; i < conflicts.size(); ++i)
      if (worst == conflicts.size() || rank(i) >= rank(worst)) worst = i;
    return worst;
  }
  // Moves all that is where the dimension would be, and in a crowd what is where these would be, `deep` times.
  bool moves_others(std::size_t number, std::size_t count, int deep = 0) {
    const PlacedDimensions before = placed_;
    const std::size_t gone = gone_.size();
    place(number);
    std::vector<std::size_t> moved;
    bool all_move = placed_[number] && faults_of(*placed_[number], drawing_, neighbours_) == 0;
    for (std::size_t i = 0; i < placed_.size() && all_move; ++i) {
      if (i == number || !placed_[i] || !do_cross(*placed_[number], *placed_[i])) continue;
      all_move = i < count && !stays_[i];
      moved.push_back(i);
    }
    stays_[number] = true;
    if (all_move) {
      for (const std::size_t i : moved) take(i);
      all_move = std::all_of(moved.begin(), moved.end(), [&](std::size_t i) {
        return finds_room(i) || (deep > 0 && moves_others(i, count, deep - 1)) || gives_way(i, number);
      });
    }
    stays_[number] = false;
    if (!all_move) put_back(before), gone_.resize(gone);
    check(all_move == placed_[number].has_value(), "a dimension that finds no room is not placed");
    return all_move;
  }
  // To what a model file requires, one that was only found in faces.
  bool gives_way(std::size_t i, std::size_t number) {
    if (!is_required(number) || i >= shown_.found || is_row(i)) return false;
    gone_.push_back(i);
    return true;
  }
  void put_back(const PlacedDimensions& before) {
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (placed_[i]) take(i);
    placed_ = before;
    for (const std::optional<PlacedDimension>& dimension : placed_)
      if (dimension) surroundings_.add(*dimension);
  }
  void put_back(std::size_t i, const std::optional<PlacedDimension>& before) {
    if (placed_[i]) take(i);
    placed_[i] = before;
    surroundings_.add(*before);
  }
  // Moves another one of the first ones.
  bool makes_room(std::size_t i, std::size_t count) {
    if (is_row(i)) return moves_others(i, count);
    for (std::size_t other = 0; other < count; ++other) {
      if (!placed_[other] || is_row(other)) continue;
      const auto before = placed_[other];
      take(other);
      if (finds_room(i)) {
        if (finds_room(other)) return true;
        take(i);
      }
      put_back(other, before);
    }
    return false;
  }
  bool makes_room_in_crowd(std::size_t i, std::size_t count) {
    constexpr int deep = 3;
    return finds_room(i) || moves_others(i, count, deep) || (!is_row(i) && makes_room(i, count));
  }
  [[nodiscard]] int conflicts_of(std::size_t number) const {
    int count = faults_of(*placed_[number], drawing_, neighbours_);
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (i != number && placed_[i] && do_cross(*placed_[number], *placed_[i])) ++count;
    return count;
  }

  const ShownDimensions& shown_;
  const std::vector<MeasuredDimension>& dimensions_;
  const drawing::ViewDrawing& drawing_;
  const DimensionStyle& style_;
  const Neighbours& neighbours_;
  std::vector<std::size_t> order_;
  Surroundings surroundings_;
  PlacedDimensions placed_;
  std::vector<bool> is_lost_;                   ///< whether every place was in a crowd
  std::map<std::vector<double>, Vec2> lost_{};  ///< size of the first text that was, by its places
  std::vector<bool> stays_;                     ///< while others are moved
  std::vector<std::size_t> gone_{};             ///< that gave way
  std::map<std::size_t, std::vector<DimensionPlacement>> usual_, more_;
  bool is_searching_ = false;  ///< whether room is looked for
  bool is_crowded_ = false;    ///< whether less usual placements are tried, too
};

// U+2300, or the letter that replaces it.
std::string diameter_sign(const Lettering& lettering) { return lettering.covers("⌀") ? "⌀" : "Ø"; }

// U+2312, or a character that looks like it.
std::string arc_sign(const Lettering& lettering) { return lettering.covers("⌒") ? "⌒" : "∩"; }

void expect_letters(const std::string& text, const AnchoredDimension& dimension, const Lettering& lettering) {
  const std::vector<std::string> missing = lettering.missing(text);
  if (!missing.empty())
    throw Error(ErrorKind::input, dimension.where, "no installed font has '" + missing.front() + "'",
                "write the text without it");
}

template <class Ink>
InkRange append_marks(std::vector<Ink>& all, std::vector<Ink> more) {
  const std::size_t begin = all.size();
  std::move(more.begin(), more.end(), std::back_inserter(all));
  return {begin, all.size()};
}

void add_to(Layer& layer, PlacedDimension dimension, const std::string& text, const DimensionStyle& style) {
  const InkRange strokes = append_marks(layer.strokes, std::move(dimension.strokes));
  const InkRange fills = append_marks(layer.fills, std::move(dimension.arrows));
  const InkRange texts = append_marks(layer.texts, std::move(dimension.texts));
  const bool is_one = dimension.objects.size() == 1;
  check(!is_one || !dimension.text_boxes.empty(), "a dimension has a text");
  for (std::size_t i = 0; i < dimension.objects.size(); ++i) {
    DimensionObject& object = layer.dimensions.emplace_back(std::move(dimension.objects[i]));
    if (is_one) {
      object.text = text;
      object.text_middle = dimension.text_boxes.front().centre;
    }
    object.value /= scene::millimetres(style.notation.unit);
    object.text_height = style.text;
    object.arrow = style.arrow();
    object.gap = style.gap();
    object.overshoot = style.overshoot();
    object.above = style.above();
    object.strokes = i == 0 ? strokes : InkRange{strokes.end, strokes.end};
    object.fills = i == 0 ? fills : InkRange{fills.end, fills.end};
    object.texts = i == 0 ? texts : InkRange{texts.end, texts.end};
  }
}

// The lengths of a row with a common origin, in order.
DimensionText text_of(const MeasuredRow& row) {
  DimensionText all;
  for (std::size_t i = 0; i < row.texts.size(); ++i)
    if (i != row.origin) all.add((all.pieces.empty() ? "" : ", ") + row.texts[i].line());
  return all;
}

// The circles of equal features that a whole view shows.
std::vector<MeasuredCircle> shown_circles(std::span<const scene::FeatureCircle> equal, AnchoredDimension dimension,
                                          const drawing::ViewDrawing& drawing, const Notation& notation) {
  std::vector<MeasuredCircle> shown;
  if (drawing.shown.breaks.any() || dimension.offset) return shown;
  const std::size_t count = std::min(equal.size(), max_in_crowd);
  for (std::size_t i = 0; i < count; ++i) {
    const scene::FeatureCircle& one = equal[i * equal.size() / count];  // of very many, some all over the view
    dimension.circles = {{one.centre, one.axis, one.radius, one.arc, one.arc.empty()}};
    const MeasuredDimension there = measure(drawing, dimension, notation);
    const auto* circle = std::get_if<MeasuredCircle>(&there.form);
    if (circle != nullptr && shows_visible(drawing, *circle)) shown.push_back(*circle);
  }
  check(shown.size() <= max_in_crowd, "only some circles are tried");
  return shown;
}

/// Whether texts of dimensions, one after the other, are no larger than the paper is.
class PaperForTexts {
 public:
  PaperForTexts(const std::optional<Rectangle>& paper, const DimensionStyle& style)
      : style_(style), left_(paper ? paper->size().x * paper->size().y : HUGE_VAL) {}

  bool takes(const DimensionText& text) {
    left_ -= style_.width(text) * style_.height(text);
    return left_ > 0;
  }

 private:
  const DimensionStyle& style_;
  double left_;  // mm²
};

/// What is measured in a view, and with a word in `placed`, what is not.
class Measuring {
 public:
  Measuring(const DimensionedView& view, const DimensionStyle& style, PlacedLayer& placed)
      : view_(view), style_(style), placed_(placed), notation_(style.notation) {
    notation_.diameter = diameter_sign(style.lettering);
    notation_.arc = arc_sign(style.lettering);
  }

  // Those that were found in faces of the part, which the view may not show, come first; then those of model files,
  // each of which has a place on its own, but all together are no more than the paper holds.
  ShownDimensions all(const std::optional<Rectangle>& paper, const Progress& progress) {
    const std::vector<AnchoredDimension> anchored = find_anchors(view_.world, view_.dimensions, progress);
    PaperForTexts room(paper, style_);
    const std::size_t found = std::min(view_.found, anchored.size());  // fewer are anchored when time is out
    for (std::size_t i = 0; i < found; ++i) add_found(i, anchored[i]);
    for (const bool is_required : {true, false})
      for (std::size_t i = found; i < anchored.size(); ++i) {
        if (view_.dimensions[i].requirement.empty() == is_required) continue;
        MeasuredDimension measured = measured_as(anchored[i]);
        if (!is_required || room.takes(measured.text)) {
          shown_.add(i, view_, std::move(measured));
          continue;
        }
        placed_.left_out.push_back(i);
        placed_.texts_left_out.push_back(measured.text.line());
      }
    check(shown_.measured.size() + placed_.unseen.size() + placed_.left_out.size() >= anchored.size(),
          "a dimension is shown or not");
    return std::move(shown_);
  }

 private:
  [[nodiscard]] MeasuredDimension measured_as(const AnchoredDimension& dimension) const {
    MeasuredDimension measured = measure(view_.drawing, dimension, notation_);
    measured.name = dimension.name;
    expect_letters(measured.text.line(), dimension, style_.lettering);
    return measured;
  }

  void add_found(std::size_t i, const AnchoredDimension& dimension) {
    check(i < view_.found, "what the view does not show was found, not asked for");
    MeasuredDimension measured = measured_as(dimension);
    const bool is_round = dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius;
    const bool is_seen = !is_round || view_.lacks_lines || shows_circle(view_.drawing, measured);
    if (i < view_.equal.size()) measured.equal = shown_circles(view_.equal[i], dimension, view_.drawing, notation_);
    if (!is_seen && !measured.equal.empty()) {
      measured.form = measured.equal.front();
    } else if (!is_seen) {
      placed_.unseen.push_back(i);
      placed_.texts_unseen.push_back(measured.text.line());
      return;
    }
    const auto* row = std::get_if<MeasuredRow>(&measured.form);
    const bool may_part = row != nullptr && !measured.offset;
    for (const MeasuredRow& part : may_part ? on_two_sides(*row, style_) : std::vector<MeasuredRow>()) {
      MeasuredDimension& one = shown_.add(i, view_, measured);
      one.form = part;
      one.text = text_of(part);
      const Vec2 size = view_.drawing.box.max - view_.drawing.box.min;
      if (is_fan(part, std::abs(glm::dot(size, part.along)), style_)) placed_.fans.push_back(one.text.line());
    }
    if (!may_part) shown_.add(i, view_, std::move(measured));
  }

  const DimensionedView& view_;
  const DimensionStyle& style_;
  PlacedLayer& placed_;
  Notation notation_;
  ShownDimensions shown_{};
};

}  // namespace

PlacedLayer place_dimensions(const DimensionedView& view, const DimensionStyle& style, const Neighbours& neighbours,
                             const Progress& progress) {
  progress.begin("placing dimensions", view.dimensions.size());
  PlacedLayer result{empty_layer(view.drawing.name, scene::SheetLine::dimension, {2 * style.line, style.line})};
  const ShownDimensions shown =
      Measuring(view, style, result).all(neighbours.paper, progress.with_part_of_the_time(0.5));
  Placer placer(shown, view.drawing, style, neighbours);
  placer.place_all(progress);
  std::vector<std::size_t> left_out;
  if (!progress.is_out_of_time()) left_out = placer.leave_out(progress);
  PlacedDimensions placed = placer.result();
  std::vector<std::string> texts;
  for (const MeasuredDimension& one : shown.measured) texts.push_back(one.text.line());
  result.crossings = crossings_of(placed, texts, view.drawing, neighbours);
  draw_once(placed);
  interrupt_at(neighbours.letters, placed);
  std::set<std::size_t> done(result.unseen.begin(), result.unseen.end());
  done.insert(result.left_out.begin(), result.left_out.end());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    auto& dimension = placed[i];
    if (!dimension) continue;
    for (DimensionEnd& end : dimension->ends)
      if (end.arrow) *end.arrow += static_cast<int>(result.layer.fills.size());
    result.zones.insert(result.zones.end(), dimension->zones.begin(), dimension->zones.end());
    if (const std::string& name = shown.measured[i].name; !name.empty()) result.ends[name] = std::move(dimension->ends);
    if (!dimension->text_boxes.empty()) result.places.emplace_back(shown.numbers[i], dimension->text_boxes.front());
    for (DimensionObject& object : dimension->objects) object.number = static_cast<int>(shown.numbers[i]);
    add_to(result.layer, std::move(*dimension), texts[i], style);
    done.insert(shown.numbers[i]);
  }
  for (const std::size_t i : left_out) {
    done.insert(shown.numbers[i]);
    result.texts_left_out.push_back(texts[i]);
    if (result.left_out.empty() || result.left_out.back() != shown.numbers[i])
      result.left_out.push_back(shown.numbers[i]);
  }
  result.count = done.size();
  check(result.count <= view.dimensions.size(), "a dimension is drawn or left out");
  return result;
}

bool on_paper(const Layer& dimensions, const Vec2& size) {
  return std::all_of(dimensions.strokes.begin(), dimensions.strokes.end(), [&size](const Stroke& stroke) {
    return std::all_of(stroke.points.begin(), stroke.points.end(),
                       [&size](const Vec2& p) { return p.x >= 0 && p.y >= 0 && p.x <= size.x && p.y <= size.y; });
  });
}

}  // namespace epura::sheet
