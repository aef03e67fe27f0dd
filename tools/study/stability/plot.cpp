// SPDX-License-Identifier: Apache-2.0
// Errors over the parameter: both logarithmic, one curve for each way, and the allowed error.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/furniture.hpp"
#include "sheet/lettering.hpp"
#include "study/stability/write.hpp"

namespace epura::stability {

namespace {

constexpr Vec2 plot_size(112, 72);  // mm, with labels
constexpr Vec2 field_min(18, 15), field_max(108, 60);
constexpr double label_height = 2.5, mark = 0.7;
constexpr double min_decade = -18, max_decade = 2;  // of errors; values that are not finite are at the top

const std::array<sheet::LineStyle, way_names.size()> curve_styles{{{"plot-float32", 0.25, {0.6, 1.2}},
                                                                   {"plot-double", 0.25, {3, 1}},
                                                                   {"plot-epura", 0.5},
                                                                   {"plot-recognised", 0.35, {4, 1, 1.5, 1}}}};

struct Plot {
  sheet::Lettering lettering;
  sheet::Layer field{"field", {"plot-field", 0.18}, {}, {}, {}};
  sheet::Layer allowed{"allowed", {"plot-allowed", 0.13, {6, 1, 0.5, 1}}, {}, {}, {}};
  std::array<sheet::Layer, way_names.size()> curves;

  Plot() {
    for (std::size_t way = 0; way < way_names.size(); ++way) curves[way] = {"", curve_styles[way], {}, {}, {}};
  }
};

double height_of(double error) {
  const double decade = error > 0 ? std::log10(error) : min_decade;
  const double part = (std::clamp(decade, min_decade, max_decade) - min_decade) / (max_decade - min_decade);
  return field_min.y + part * (field_max.y - field_min.y);
}

// Positions of steps: by their logarithms if they span more than a decade, with zero slightly before the least; if some
// are negative, at equal distances.
class StepAxis {
 public:
  explicit StepAxis(const std::vector<Row>& rows) {
    for (const Row& row : rows) steps_.push_back(row.step);
    std::sort(steps_.begin(), steps_.end());
    const bool has_zero = std::binary_search(steps_.begin(), steps_.end(), 0.0);
    min_ = steps_[steps_.front() == 0 && steps_.size() > 1 ? 1 : 0];
    logarithmic_ = min_ > 0 && steps_.back() > 20 * min_;
    if (!logarithmic_) min_ = steps_.front();
    begin_ = field_min.x + (logarithmic_ && has_zero ? 6 : 2);
  }

  [[nodiscard]] double place(double step) const {
    const double end = field_max.x - 2;
    if (logarithmic_ && step == 0) return field_min.x + 2;
    if (!(max() > min_)) return (begin_ + end) / 2;
    return begin_ + part(step) * (end - begin_);
  }
  [[nodiscard]] double min() const { return min_; }
  [[nodiscard]] double max() const { return steps_.back(); }

 private:
  [[nodiscard]] double part(double step) const {
    if (logarithmic_) return (std::log10(step) - std::log10(min_)) / (std::log10(max()) - std::log10(min_));
    if (min_ >= 0) return (step - min_) / (max() - min_);
    const auto before = std::lower_bound(steps_.begin(), steps_.end(), step) - steps_.begin();
    return static_cast<double>(before) / static_cast<double>(steps_.size() - 1);
  }

  std::vector<double> steps_;  // ascending, at least one
  double min_, begin_;
  bool logarithmic_;
};

void add_text(Plot& plot, const std::string& text, const Vec2& at, sheet::Align align, double height = label_height) {
  plot.field.texts.push_back({text, at, height, 0, align, "plot"});
}

void add_field(Plot& plot, const Vec2& origin, const CaseReport& one, const StepAxis& axis) {
  plot.field.strokes.push_back(sheet::outline({origin + field_min, origin + field_max}));
  for (int decade = -16; decade <= 0; decade += 4) {
    const double y = height_of(std::pow(10.0, decade));
    plot.field.strokes.push_back(sheet::line(origin + Vec2(field_min.x - 1, y), origin + Vec2(field_min.x, y)));
    add_text(plot, decade == 0 ? "1" : "1e" + std::to_string(decade), origin + Vec2(field_min.x - 2, y - 1.2),
             sheet::Align::right);
  }
  const double below = field_min.y - 4.5;
  add_text(plot, format_rounded(axis.min(), 3), origin + Vec2(axis.place(axis.min()), below), sheet::Align::middle);
  if (axis.max() > axis.min())
    add_text(plot, format_rounded(axis.max(), 3), origin + Vec2(axis.place(axis.max()), below), sheet::Align::right);
  add_text(plot, one.parameter, origin + Vec2((field_min.x + field_max.x) / 2, below - 5), sheet::Align::middle);
  const sheet::FittedText title =
      sheet::fit_text(one.id + " " + one.what, field_max.x - field_min.x, 2.5, plot.lettering);
  for (std::size_t i = 0; i < title.lines.size(); ++i) {
    const double above = 2 + 1.6 * title.height * static_cast<double>(title.lines.size() - 1 - i);
    add_text(plot, title.lines[i], origin + Vec2(field_min.x, field_max.y + above), sheet::Align::left, title.height);
  }
}

// A filled square if it is right, a cross if it is not.
void add_mark(sheet::Layer& layer, const Vec2& at, Verdict verdict) {
  const Vec2 up(mark, mark), down(mark, -mark);
  if (verdict == Verdict::right)
    layer.fills.push_back({{{at - up, at + down, at + up, at - down}}});
  else
    layer.strokes.insert(layer.strokes.end(), {sheet::line(at - up, at + up), sheet::line(at - down, at + down)});
}

void add_curve(sheet::Layer& layer, std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
  if (points.size() > 1) layer.strokes.push_back({std::move(points), false, layer.style.dashes});
}

void add_plot(Plot& plot, const Vec2& origin, const CaseReport& one) {
  const StepAxis axis(one.rows);
  add_field(plot, origin, one, axis);
  for (std::size_t way = 0; way < way_names.size(); ++way) {
    std::vector<Vec2> errors, allowed;
    for (const Row& row : one.rows) {
      const Outcome& outcome = row.outcomes[way];
      const Quantity* quantity = outcome.worst();
      errors.push_back(origin + Vec2(axis.place(row.step), height_of(outcome.error())));
      add_mark(plot.curves[way], errors.back(), outcome.verdict());
      if (quantity != nullptr && quantity->allowed > 0)
        allowed.push_back(origin + Vec2(axis.place(row.step), height_of(quantity->allowed)));
    }
    add_curve(plot.curves[way], std::move(errors));
    if (static_cast<Way>(way) == Way::own) add_curve(plot.allowed, std::move(allowed));
  }
}

sheet::Sheet finished(Plot plot, const std::string& name, const Vec2& size) {
  sheet::Sheet sheet{size.x, size.y, "stability " + name, {}, {}, {}};
  plot.field.name = name + "/field";
  plot.allowed.name = name + "/allowed";
  sheet.layers = {plot.field, plot.allowed};
  for (std::size_t way = 0; way < way_names.size(); ++way) {
    plot.curves[way].name = name + "/" + std::string(way_names[way]);
    sheet.layers.push_back(plot.curves[way]);
  }
  return sheet;
}

}  // namespace

sheet::Sheet to_sheet(const CaseReport& report) {
  Plot plot;
  add_plot(plot, Vec2(0), report);
  return finished(std::move(plot), report.id, plot_size);
}

sheet::Sheet to_sheet(const Report& report) {
  const std::size_t columns = std::clamp<std::size_t>(report.size(), 1, 6);
  const std::size_t rows = std::max<std::size_t>(1, (report.size() + columns - 1) / columns);
  Plot plot;
  for (std::size_t i = 0; i < report.size(); ++i) {
    const Vec2 place(static_cast<double>(i % columns), static_cast<double>(rows - 1 - i / columns));
    add_plot(plot, place * plot_size, report[i]);
  }
  return finished(std::move(plot), "study", Vec2(static_cast<double>(columns), static_cast<double>(rows)) * plot_size);
}

}  // namespace epura::stability
