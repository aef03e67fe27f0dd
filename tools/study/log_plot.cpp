// SPDX-License-Identifier: Apache-2.0
#include "study/log_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "sheet/boxes.hpp"
#include "sheet/lettering.hpp"

namespace epura::study {

namespace {

constexpr double width = 205, height = 120;  // of the sheet, mm
constexpr Vec2 min(22, 18), max(140, 108);   // of the diagram
constexpr double mark_size = 1.1;
constexpr double small = 1.8, normal = 2.5, large = 3.5;  // heights of capitals, ISO 3098

const std::array<sheet::Dashes, 6> curve_dashes{{{}, {3, 1}, {1, 0.7}, {5, 1, 0.3, 1}, {5, 1, 0.3, 2}, {2, 2}}};
// Okabe and Ito's, which people with any kind of colour blindness tell apart.
constexpr std::array<Colour, 6> curve_colours{
    {{0, 0, 0}, {213, 94, 0}, {0, 114, 178}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}}};
constexpr Colour grey{150, 150, 150};

// Decades from ... to.
struct Axis {
  double from, to;

  [[nodiscard]] double part(double value) const { return (std::log10(value) - from) / (to - from); }
};

Axis axis_of(double smallest, double greatest) {
  const double from = std::floor(std::log10(smallest));
  return {from, std::max(std::ceil(std::log10(greatest)), from + 1)};
}

std::string power_of_ten(double decade) { return decade == 0 ? "1" : "1e" + format_number(decade); }

/// The corners, around the origin, of the mark of a curve.
std::vector<Vec2> mark_of(std::size_t curve) {
  constexpr std::array<int, 5> corners{24, 4, 3, 4, 3};
  constexpr std::array<double, 5> turns{0, 0.25, 0.5, 0, 0};  // in units of pi
  const std::size_t kind = curve % corners.size();
  const double first = kind == 2 || kind == 4 ? (kind == 2 ? 0.5 : -0.5) : turns[kind];
  std::vector<Vec2> points;
  for (int i = 0; i < corners[kind]; ++i) {
    const double a = (first + 2.0 * i / corners[kind]) * std::numbers::pi;
    points.emplace_back(mark_size * Vec2(std::cos(a), std::sin(a)));
  }
  return points;
}

/// "bits=14", "bits=18" become "bits=14, 18".
std::string joined(const std::vector<std::string>& labels) {
  std::string text = labels.front();
  const std::string key = text.substr(0, text.find('=') + 1);
  for (std::size_t i = 1; i < labels.size(); ++i)
    text += ", " + (!key.empty() && labels[i].starts_with(key) ? labels[i].substr(key.size()) : labels[i]);
  return text;
}

class Plotter {
 public:
  explicit Plotter(const LogPlot& plot) : plot_(plot) {
    double x0 = HUGE_VAL, x1 = 0, y0 = HUGE_VAL, y1 = 0;
    const auto add_x = [&](double x) { x0 = std::min(x0, x), x1 = std::max(x1, x); };
    const auto add_y = [&](double y) { y0 = std::min(y0, y), y1 = std::max(y1, y); };
    for (const PlotCurve& curve : plot.curves)
      for (const PlotPoint& point : curve.points) {
        for (const double x : point.spread) add_x(x);
        add_y(raised(point.at.y));
      }
    for (const PlotMark& mark : plot.marks) mark.vertical ? add_x(mark.at) : add_y(raised(mark.at));
    x_ = x1 > 0 ? axis_of(x0, x1) : Axis{0, 1};
    y_ = y1 > 0 ? axis_of(y0, y1) : Axis{0, 1};
  }

  sheet::Sheet sheet() {
    sheet::Sheet sheet{width, height, plot_.title, {}};
    draw_axes();
    draw_marks();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) draw_curve(i);
    draw_front();
    draw_mark_labels();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) draw_labels(i);
    if (!plot_.note.empty()) texts_.push_back({plot_.note, {min.x, 3}, small, 0, sheet::Align::left, "note"});
    texts_.push_back({plot_.title, {min.x, max.y + 4}, large, 0, sheet::Align::left, "title"});
    const auto named = [&](const char* role) { return plot_.name + "/" + role; };
    sheet.layers.push_back({named("grid"), {"plot-grid", 0.09}, std::move(grid_)});
    sheet.layers.push_back({named("axes"), {"plot-axis", 0.25}, std::move(axes_)});
    sheet.layers.push_back({named("limits"), {"plot-limit", 0.25, {2, 1}}, std::move(limits_)});
    sheet.layers.push_back({named("front"), {"plot-front", 0.7, {}, grey}, std::move(front_)});
    for (std::vector<sheet::Layer>* layers : {&curves_, &marks_})
      for (sheet::Layer& layer : *layers) sheet.layers.push_back(std::move(layer));
    sheet.layers.push_back({named("leaders"), {"plot-leader", 0.13}, std::move(leaders_)});
    sheet.layers.push_back({named("text"), {"plot-text", 0.25}, {}, {}, std::move(texts_)});
    std::erase_if(sheet.layers, [](const sheet::Layer& layer) {
      return layer.strokes.empty() && layer.fills.empty() && layer.texts.empty();
    });
    return sheet;
  }

 private:
  [[nodiscard]] double raised(double y) const { return std::max(y, plot_.min_y); }

  [[nodiscard]] Vec2 position(const Vec2& value) const {
    return min + Vec2(x_.part(value.x), y_.part(raised(value.y))) * (max - min);
  }

  static sheet::Stroke line(const Vec2& from, const Vec2& to, const sheet::Dashes& dashes = {}) {
    return {{from, to}, false, dashes};
  }

  void draw_axes() {
    axes_.push_back({{min, {max.x, min.y}, max, {min.x, max.y}}, true});
    const double step_x = std::ceil((x_.to - x_.from) / 12), step_y = std::ceil((y_.to - y_.from) / 14);
    for (double d = x_.from; d <= x_.to; d += step_x) {
      const double x = position({std::pow(10, d), 1}).x;
      if (d > x_.from && d < x_.to) grid_.push_back(line({x, min.y}, {x, max.y}));
      texts_.push_back({power_of_ten(d), {x, min.y - 4}, normal, 0, sheet::Align::middle, "tick"});
    }
    for (double d = y_.from; d <= y_.to; d += step_y) {
      const double y = position({1, std::pow(10, d)}).y;
      if (d > y_.from && d < y_.to) grid_.push_back(line({min.x, y}, {max.x, y}));
      texts_.push_back({power_of_ten(d), {min.x - 1.5, y - normal / 2}, normal, 0, sheet::Align::right, "tick"});
    }
    texts_.push_back({plot_.x_axis, {(min.x + max.x) / 2, min.y - 10}, normal, 0, sheet::Align::middle, "axis"});
    texts_.push_back({plot_.y_axis, {6, (min.y + max.y) / 2}, normal, 90, sheet::Align::middle, "axis"});
  }

  void draw_marks() {
    for (const PlotMark& mark : plot_.marks) {
      const Vec2 at = position({mark.vertical ? mark.at : 1, mark.vertical ? 1 : mark.at});
      const std::array<Vec2, 2> ends = mark.vertical ? std::array{Vec2(at.x, min.y), Vec2(at.x, max.y)}
                                                     : std::array{Vec2(min.x, at.y), Vec2(max.x, at.y)};
      limits_.push_back(line(ends[0], ends[1], {2, 1}));
    }
    occupy(limits_);
  }

  // Beside their lines, as near to the upper or right end as there is room.
  void draw_mark_labels() {
    constexpr double step = 0.5, air = 0.8;
    for (std::size_t i = 0; i < plot_.marks.size(); ++i) {
      const PlotMark& mark = plot_.marks[i];
      const Vec2 from = limits_[i].points[1], back = glm::normalize(limits_[i].points[0] - from);
      const Vec2 across = mark.vertical ? Vec2(-1, 0) : Vec2(0, 1);
      const Vec2 half(lettering_.width(mark.label, small) / 2, small / 2);
      const double length = glm::distance(limits_[i].points[0], from) - 2 * half.x;
      sheet::TurnedBox box{};
      const auto stands = [&](double away, double side) {
        box = {from + (away + half.x) * back + side * (half.y + air) * across, -back, half};
        return is_free(box);
      };
      bool found = false;
      for (double away = 1; away < length && !found; away += step) found = stands(away, 1) || stands(away, -1);
      if (!found) stands(1, 1);
      const Vec2 base = box.centre - half.y * (mark.vertical ? Vec2(-1, 0) : Vec2(0, 1));
      texts_.push_back({mark.label, base, small, mark.vertical ? 90.0 : 0, sheet::Align::middle, "limit"});
      occupied_.push_back(box);
      written_.push_back(box);
    }
  }

  void draw_point(const Vec2& at, std::size_t curve, bool full) {
    std::vector<Vec2> mark = mark_of(curve);
    for (Vec2& corner : mark) corner += at;
    if (full) marks_[curve].fills.push_back({{mark}});
    marks_[curve].strokes.push_back({std::move(mark), true});
  }

  void draw_curve(std::size_t number) {
    const PlotCurve& curve = plot_.curves[number];
    const sheet::Dashes& dashes = curve_dashes[number % curve_dashes.size()];
    const Colour& colour = curve_colours[number % curve_colours.size()];
    const std::string name = std::to_string(number), style = std::to_string(number % curve_dashes.size());
    sheet::Layer& lines = curves_.emplace_back(
        sheet::Layer{plot_.name + "/curve-" + name, {"plot-curve-" + style, 0.35, dashes, colour}, {}});
    marks_.push_back({plot_.name + "/points-" + name, {"plot-point-" + style, 0.25, {}, colour}, {}});
    sheet::Stroke stroke{{}, false, dashes};
    for (const PlotPoint& point : curve.points) {
      const Vec2 at = position(point.at);
      stroke.points.push_back(at);
      draw_point(at, number, point.on_front);
      occupied_.push_back({at, {1, 0}, Vec2(mark_size)});
      if (point.spread[1] > point.spread[0])
        marks_[number].strokes.push_back(
            line(position({point.spread[0], point.at.y}), position({point.spread[1], point.at.y})));
    }
    occupy(marks_[number].strokes);
    if (stroke.points.size() > 1) lines.strokes.push_back(std::move(stroke));
    occupy(lines.strokes);
    draw_key(number, lines);
  }

  void draw_key(std::size_t number, sheet::Layer& lines) {
    const Vec2 key(max.x + 5, max.y - 3 - 6.0 * static_cast<double>(number));
    lines.strokes.push_back(line(key - Vec2(2.5, 0), key + Vec2(4.5, 0), lines.style.dashes));
    draw_point(key + Vec2(1, 0), number, false);
    texts_.push_back({plot_.curves[number].name, key + Vec2(6, -normal / 2), normal, 0, sheet::Align::left, "key"});
  }

  // The least error that is had for each time.
  void draw_front() {
    std::vector<Vec2> corners;
    for (const PlotCurve& curve : plot_.curves)
      for (const PlotPoint& point : curve.points)
        if (point.on_front) corners.push_back(position(point.at));
    std::sort(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    if (corners.empty()) return;
    sheet::Stroke steps{{corners.front()}};
    for (std::size_t i = 1; i < corners.size(); ++i) {
      steps.points.emplace_back(corners[i].x, steps.points.back().y);
      steps.points.push_back(corners[i]);
    }
    steps.points.emplace_back(max.x, steps.points.back().y);
    front_.push_back(std::move(steps));
    occupy(front_);
  }

  void draw_labels(std::size_t number) {
    const std::vector<PlotPoint>& points = plot_.curves[number].points;
    for (std::size_t i = 0; i < points.size();) {
      const Vec2 at = position(points[i].at);
      std::vector<std::string> labels;
      for (; i < points.size() && glm::distance(position(points[i].at), at) < 2 * mark_size; ++i)
        if (!points[i].label.empty()) labels.push_back(points[i].label);
      if (!labels.empty()) draw_label(joined(labels), at);
    }
  }

  // In the nearest free place around a mark; if there is none, over the diagram.
  void draw_label(const std::string& label, const Vec2& at) {
    constexpr double air = 0.4, beside = mark_size + 0.6, farthest = 60, step = 1;
    constexpr int directions = 32;
    const Vec2 half = Vec2(lettering_.width(label, small), small) / 2.0 + air;
    for (double away = beside; away < farthest; away += step)
      for (int i = 0; i < directions; ++i)
        for (const double shift : {0.0, 0.5, 1.0, 1.5, 1.9}) {
          const double turn = (0.5 + i) * 2 * std::numbers::pi / directions;
          const Vec2 direction(std::cos(turn), std::sin(turn)), to = at + away * direction;
          // The label touches a circle around the mark.
          const Vec2 side = glm::sign(direction) * glm::min(Vec2(1), 2.0 * glm::abs(direction));
          const sheet::TurnedBox box{to + half * (side - Vec2(shift * side.x, 0)), {1, 0}, half};
          const sheet::TurnedBox leader = sheet::line_box(at + beside * direction, to);
          const bool is_led = away > beside;
          // Leaders may cross lines, but no label.
          if (!is_free(box) || (is_led && (overlap(box, leader) || meets(leader, written_)))) continue;
          if (is_led) leaders_.push_back(line(at + mark_size * direction, to));
          if (is_led) occupied_.push_back(leader);
          return write_label(label, box);
        }
    write_label(label, {at, {1, 0}, half});
  }

  void write_label(const std::string& label, const sheet::TurnedBox& box) {
    texts_.push_back({label, box.centre - Vec2(0, small / 2), small, 0, sheet::Align::middle, "label"});
    occupied_.push_back(box);
    written_.push_back(box);
  }

  static bool meets(const sheet::TurnedBox& box, const std::vector<sheet::TurnedBox>& others) {
    return std::any_of(others.begin(), others.end(),
                       [&](const sheet::TurnedBox& other) { return sheet::overlap(box, other); });
  }

  [[nodiscard]] bool is_free(const sheet::TurnedBox& box) const {
    const sheet::Rectangle around = sheet::around(box);
    if (around.min.x < min.x || around.max.x > max.x || around.min.y < min.y || around.max.y > max.y) return false;
    return !meets(box, occupied_);
  }

  void occupy(const std::vector<sheet::Stroke>& strokes) {
    for (const sheet::Stroke& stroke : strokes)
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        if (stroke.points[i - 1] != stroke.points[i])
          occupied_.push_back(sheet::line_box(stroke.points[i - 1], stroke.points[i]));
  }

  const LogPlot& plot_;
  Axis x_{}, y_{};
  sheet::Lettering lettering_;
  std::vector<sheet::Stroke> grid_, axes_, limits_, front_, leaders_;
  std::vector<sheet::Layer> curves_, marks_;  ///< by curve
  std::vector<sheet::Text> texts_;
  std::vector<sheet::TurnedBox> occupied_;  ///< where no label may lie
  std::vector<sheet::TurnedBox> written_;   ///< the labels among them
};

}  // namespace

sheet::Sheet to_sheet(const LogPlot& plot) { return Plotter(plot).sheet(); }

}  // namespace epura::study
