// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/log_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text.hpp"

namespace epura::study {

namespace {

constexpr double width = 205, height = 120;  // of the sheet, mm
constexpr Vec2 min(22, 18), max(140, 108);   // of the diagram
constexpr double mark_size = 1.1;
constexpr double small = 1.8, normal = 2.5, large = 3.5;  // heights of capitals, ISO 3098

const std::array<sheet::Dashes, 6> curve_dashes{{{}, {3, 1}, {1, 0.7}, {5, 1, 0.3, 1}, {5, 1, 0.3, 2}, {2, 2}}};

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

class Plotter {
 public:
  explicit Plotter(const LogPlot& plot) : plot_(plot) {
    double x0 = HUGE_VAL, x1 = 0, y0 = HUGE_VAL, y1 = 0;
    const auto add_x = [&](double x) { x0 = std::min(x0, x), x1 = std::max(x1, x); };
    const auto add_y = [&](double y) { y0 = std::min(y0, y), y1 = std::max(y1, y); };
    for (const PlotCurve& curve : plot.curves)
      for (const PlotPoint& point : curve.points) add_x(point.at.x), add_y(raised(point.at.y));
    for (const PlotMark& mark : plot.marks) mark.vertical ? add_x(mark.at) : add_y(raised(mark.at));
    x_ = x1 > 0 ? axis_of(x0, x1) : Axis{0, 1};
    y_ = y1 > 0 ? axis_of(y0, y1) : Axis{0, 1};
  }

  sheet::Sheet sheet() {
    sheet::Sheet sheet{width, height, plot_.title, {}};
    draw_axes();
    draw_marks();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) draw_curve(i);
    if (!plot_.note.empty()) texts_.push_back({plot_.note, {min.x, 3}, small, 0, sheet::Align::left, "note"});
    texts_.push_back({plot_.title, {min.x, max.y + 4}, large, 0, sheet::Align::left, "title"});
    const auto named = [&](const char* role) { return plot_.name + "/" + role; };
    sheet.layers.push_back({named("grid"), {"plot-grid", 0.09}, std::move(grid_)});
    sheet.layers.push_back({named("axes"), {"plot-axis", 0.25}, std::move(axes_)});
    sheet.layers.push_back({named("limits"), {"plot-limit", 0.25, {2, 1}}, std::move(limits_)});
    for (std::size_t i = 0; i < curves_.size(); ++i)
      sheet.layers.push_back(
          {named(("curve-" + std::to_string(i)).c_str()),
           {"plot-curve-" + std::to_string(i % curve_dashes.size()), 0.35, curve_dashes[i % curve_dashes.size()]},
           std::move(curves_[i])});
    sheet.layers.push_back({named("points"), {"plot-point", 0.25}, std::move(points_), std::move(fills_)});
    sheet.layers.push_back({named("text"), {"plot-text", 0.25}, {}, {}, std::move(texts_)});
    std::erase_if(sheet.layers, [](const sheet::Layer& layer) {
      return layer.strokes.empty() && layer.fills.empty() && layer.texts.empty();
    });
    return sheet;
  }

 private:
  [[nodiscard]] double raised(double y) const { return std::max(y, plot_.least_y); }

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
      if (mark.vertical) {
        limits_.push_back(line({at.x, min.y}, {at.x, max.y}, {2, 1}));
        texts_.push_back({mark.label, {at.x - 0.8, max.y - 2}, small, 90, sheet::Align::right, "limit"});
      } else {
        limits_.push_back(line({min.x, at.y}, {max.x, at.y}, {2, 1}));
        texts_.push_back({mark.label, {max.x - 1, at.y + 0.8}, small, 0, sheet::Align::right, "limit"});
      }
    }
  }

  void draw_point(const Vec2& at, std::size_t curve, bool full) {
    std::vector<Vec2> mark = mark_of(curve);
    for (Vec2& corner : mark) corner += at;
    if (full) fills_.push_back({{mark}});
    points_.push_back({std::move(mark), true});
  }

  void draw_curve(std::size_t number) {
    const PlotCurve& curve = plot_.curves[number];
    const sheet::Dashes& dashes = curve_dashes[number % curve_dashes.size()];
    std::vector<sheet::Stroke>& strokes = curves_.emplace_back();
    sheet::Stroke stroke{{}, false, dashes};
    for (const PlotPoint& point : curve.points) {
      const Vec2 at = position(point.at);
      stroke.points.push_back(at);
      draw_point(at, number, point.full);
      if (!point.label.empty())
        texts_.push_back({point.label, at + Vec2(1.6, 0.6), small, 0, sheet::Align::left, "label"});
    }
    if (stroke.points.size() > 1) strokes.push_back(std::move(stroke));
    const Vec2 key(max.x + 5, max.y - 3 - 6.0 * static_cast<double>(number));
    strokes.push_back(line(key - Vec2(2.5, 0), key + Vec2(4.5, 0), dashes));
    draw_point(key + Vec2(1, 0), number, false);
    texts_.push_back({curve.name, key + Vec2(6, -normal / 2), normal, 0, sheet::Align::left, "key"});
  }

  const LogPlot& plot_;
  Axis x_{}, y_{};
  std::vector<sheet::Stroke> grid_, axes_, limits_, points_;
  std::vector<std::vector<sheet::Stroke>> curves_;
  std::vector<sheet::Fill> fills_;
  std::vector<sheet::Text> texts_;
};

}  // namespace

sheet::Sheet to_sheet(const LogPlot& plot) { return Plotter(plot).sheet(); }

}  // namespace epura::study
