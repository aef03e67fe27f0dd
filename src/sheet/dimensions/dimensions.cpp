// SPDX-License-Identifier: Apache-2.0
#include "dimensions/dimensions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/forms.hpp"
#include "dimensions/measure.hpp"
#include "dimensions/obstacles.hpp"
#include "dimensions/shown_circle.hpp"
#include "dimensions/strokes.hpp"
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

/// The dimensions of a view that it shows, and their numbers among all.
struct ShownDimensions {
  std::vector<MeasuredDimension> measured;
  std::vector<std::size_t> numbers;
  std::vector<ItemRank> ranks;

  MeasuredDimension& add(std::size_t number, const DimensionedView& view, MeasuredDimension one) {
    const bool is_required = !view.dimensions[number].requirement.empty();
    numbers.push_back(number);
    ranks.push_back(number < view.found ? ItemRank::found : is_required ? ItemRank::required : ItemRank::drawn);
    return measured.emplace_back(std::move(one));
  }
};

// Less usual placements, of forms that have some.
PlacementItem::Places places_in_crowd(const MeasuredDimension& measured, const drawing::ViewDrawing& drawing,
                                      const DimensionStyle& style) {
  const auto of = [&](const auto& form) {
    return [&](const PlacedDimension*) { return placements_in_crowd(form, measured, drawing, style); };
  };
  if (const auto* length = std::get_if<MeasuredLength>(&measured.form)) return of(*length);
  if (const auto* circle = std::get_if<MeasuredCircle>(&measured.form)) return of(*circle);
  return {};
}

// Dimensions without a choice come first; then distances, small before large; then angles; then circles. The item
// refers to all of these.
PlacementItem item_of(const MeasuredDimension& measured, ItemRank rank, const drawing::ViewDrawing& drawing,
                      const DimensionStyle& style) {
  const auto* length = std::get_if<MeasuredLength>(&measured.form);
  const auto* row = std::get_if<MeasuredRow>(&measured.form);
  const double size = length ? std::abs(glm::dot(length->to - length->from, length->along)) : row ? row->size() : 0;
  PlacementItem item;
  item.usual = [&](const PlacedDimension*) {
    return std::visit([&](const auto& form) { return placements_of(form, measured, drawing, style); }, measured.form);
  };
  item.in_crowd = places_in_crowd(measured, drawing, style);
  for (const MeasuredCircle& circle : measured.equal)
    item.elsewhere.push_back([&](const PlacedDimension*) { return placements_of(circle, measured, drawing, style); });
  item.order = {measured.offset ? 0.0 : 1.0, row ? 0.0 : static_cast<double>(measured.form.index()), size};
  item.rank = rank;
  item.is_many = row != nullptr;
  if (!row && rank == ItemRank::required) item.like = places_of(measured);
  item.size = {style.width(measured.text), style.height(measured.text)};
  check(item.size.x >= 0 && item.size.y >= 0, "a text has a size");
  return item;
}

// Those at a dimension stand at the last one of its name.
std::vector<PlacementItem> items_of(const ShownDimensions& shown, const DimensionedView& view,
                                    const DimensionStyle& style) {
  std::vector<PlacementItem> items;
  std::map<std::string, std::size_t> by_name;
  for (std::size_t i = 0; i < shown.measured.size(); ++i) {
    items.push_back(item_of(shown.measured[i], shown.ranks[i], view.drawing, style));
    by_name[shown.measured[i].name] = i;
  }
  for (const ItemBeside& beside : view.beside) {
    items.push_back(beside.item);
    if (const auto host = by_name.find(beside.dimension); !beside.dimension.empty() && host != by_name.end())
      items.back().host = host->second;
  }
  return items;
}

void check_ends(const MeasuredDimension& measured, const PlacedDimension& dimension) {
  const auto ends_here = [&](const auto& form) {
    return std::all_of(dimension.arrows.begin(), dimension.arrows.end(),
                       [&](const Fill& arrow) { return ends_at(form, end_of(arrow)); });
  };
  check(std::visit(ends_here, measured.form) || std::any_of(measured.equal.begin(), measured.equal.end(), ends_here),
        "a dimension ends at what it measures");
}

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

// With the lines of a circle.
MeasuredDimension measured_in(const DimensionedView& view, const AnchoredDimension& dimension,
                              const Notation& notation) {
  MeasuredDimension measured = measure(view.drawing, dimension, notation);
  if (auto* circle = std::get_if<MeasuredCircle>(&measured.form))
    circle->lines = lines_along(view.drawing, *circle, view.is_turned ? nullptr : &view.world);
  return measured;
}

// The circles of equal features that a whole view shows.
std::vector<MeasuredCircle> shown_circles(std::span<const scene::FeatureCircle> equal, AnchoredDimension dimension,
                                          const DimensionedView& view, const Notation& notation) {
  std::vector<MeasuredCircle> shown;
  if (view.drawing.shown.breaks.any() || dimension.offset) return shown;
  const std::size_t count = std::min(equal.size(), max_in_crowd);
  for (std::size_t i = 0; i < count; ++i) {
    const scene::FeatureCircle& one = equal[i * equal.size() / count];  // of very many, some all over the view
    dimension.circles = {{one.centre, one.axis, one.radius, one.arc, one.arc.empty()}};
    if (dimension.type != DimensionType::radius) dimension.type = DimensionType::diameter;
    const MeasuredDimension there = measured_in(view, dimension, notation);
    const auto* circle = std::get_if<MeasuredCircle>(&there.form);
    if (circle != nullptr && shows_visible(*circle)) shown.push_back(*circle);
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
    MeasuredDimension measured = measured_in(view_, dimension, notation_);
    measured.name = dimension.name;
    expect_letters(measured.text.line(), dimension, style_.lettering);
    return measured;
  }

  void add_found(std::size_t i, const AnchoredDimension& dimension) {
    check(i < view_.found, "what the view does not show was found, not asked for");
    MeasuredDimension measured = measured_as(dimension);
    const bool is_round = dimension.type == DimensionType::diameter || dimension.type == DimensionType::radius;
    const bool has_circles = i < view_.equal.size() && !view_.equal[i].empty();
    if (has_circles) measured.equal = shown_circles(view_.equal[i], dimension, view_, notation_);
    const bool is_whole = !view_.drawing.shown.breaks.any();
    bool is_seen = view_.lacks_lines || (is_round ? shows_circle(view_.drawing, measured) : !has_circles || !is_whole);
    if (!is_round && !measured.equal.empty()) {
      is_seen = true;
      measured.equal.clear();
    }
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
  const Obstacles obstacles(view.drawing, neighbours);
  PlacedDimensions placed = place_items(items_of(shown, view, style), obstacles, progress);
  const bool is_complete = !progress.is_out_of_time();
  std::vector<std::string> texts;
  for (const MeasuredDimension& one : shown.measured) texts.push_back(one.text.line());
  result.has_conflicts = have_conflicts(placed, obstacles);
  const auto dimensions_end = placed.begin() + static_cast<std::ptrdiff_t>(shown.measured.size());
  result.beside.assign(std::make_move_iterator(dimensions_end), std::make_move_iterator(placed.end()));
  placed.erase(dimensions_end, placed.end());
  draw_once(placed);
  interrupt_at(neighbours.letters, placed);
  std::set<std::size_t> done(result.unseen.begin(), result.unseen.end());
  done.insert(result.left_out.begin(), result.left_out.end());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    auto& dimension = placed[i];
    if (dimension || is_complete) done.insert(shown.numbers[i]);
    if (!dimension && is_complete) {
      result.texts_left_out.push_back(texts[i]);
      if (result.left_out.empty() || result.left_out.back() != shown.numbers[i])
        result.left_out.push_back(shown.numbers[i]);
    }
    if (!dimension) continue;
    check_ends(shown.measured[i], *dimension);
    for (DimensionEnd& end : dimension->ends)
      if (end.arrow) *end.arrow += static_cast<int>(result.layer.fills.size());
    result.zones.insert(result.zones.end(), dimension->zones.begin(), dimension->zones.end());
    if (const std::string& name = shown.measured[i].name; !name.empty()) result.ends[name] = std::move(dimension->ends);
    if (!dimension->text_boxes.empty()) result.places.emplace_back(shown.numbers[i], dimension->text_boxes.front());
    for (DimensionObject& object : dimension->objects) object.number = static_cast<int>(shown.numbers[i]);
    add_to(result.layer, std::move(*dimension), texts[i], style);
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
