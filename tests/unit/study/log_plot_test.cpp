// SPDX-License-Identifier: Apache-2.0
#include "study/log_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sheet/boxes.hpp"

namespace epura::study::log_plot_test {
namespace {

struct Labelled {
  std::string text;
  sheet::TurnedBox box;
};

std::vector<Labelled> labels_of(const sheet::Sheet& sheet, const sheet::Lettering& lettering) {
  std::vector<Labelled> labels;
  for (const sheet::Layer& layer : sheet.layers)
    for (const sheet::Text& text : layer.texts)
      if (text.role == "label" || text.role == "limit") labels.push_back({text.text, box_of(text, lettering)});
  return labels;
}

LogPlot crowded(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto decade = [&](double from, double to) {
    return std::pow(10.0, std::uniform_real_distribution<double>(from, to)(random));
  };
  LogPlot plot{"plot", "Crowded", "x", "y", {}};
  for (int curve = 0; curve < 5; ++curve) {
    plot.curves.push_back({"curve " + std::to_string(curve), {}});
    for (int i = 0; i < 5; ++i) {
      const double x = decade(-4, -2);
      plot.curves.back().points.push_back(
          {{x, i == 4 ? 0 : decade(-6, 0)}, "setting=" + std::to_string(i), i == 4, {x / 1.2, x * 1.2}});
    }
  }
  plot.marks = {{"a limit", 1e-6, false}, {"another limit", 1e-3, true}};
  return plot;
}

TEST(LogPlot, NoLabelLiesOnALineOrAnotherLabel) {
  const sheet::Lettering lettering;
  for (int seed = 1; seed <= 12; ++seed) {
    const sheet::Sheet sheet = to_sheet(crowded(seed));
    const std::vector<Labelled> labels = labels_of(sheet, lettering);
    EXPECT_GT(labels.size(), 20U) << "all points have labels";
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(overlap(labels[i].box, labels[k].box)) << seed << labels[i].text << labels[k].text;
      for (const sheet::Layer& layer : sheet.layers) {
        if (!layer.texts.empty() || layer.name.ends_with("grid")) continue;
        for (const sheet::TurnedBox& ink : boxes_of(layer, lettering))
          EXPECT_FALSE(overlap(labels[i].box, ink)) << seed << labels[i].text << " on " << layer.name;
      }
    }
  }
}

TEST(LogPlot, MarksOnOneAnotherShareALabel) {
  LogPlot plot{"plot", "", "x", "y", {{"curve", {{{1, 1}, "bits=14"}, {{1.001, 1}, "bits=18"}, {{50, 9}, "bits=24"}}}}};
  std::vector<std::string> texts;
  for (const Labelled& label : labels_of(to_sheet(plot), sheet::Lettering())) texts.push_back(label.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"bits=14, 18", "bits=24"}));
}

TEST(LogPlot, TheFrontDescends) {
  LogPlot plot{"plot", "", "x", "y", {{"curve", {{{1, 9}, "", true}, {{90, 1}, "", true}, {{30, 3}, "", false}}}}};
  for (const sheet::Layer& layer : to_sheet(plot).layers) {
    if (layer.name != "plot/front") continue;
    ASSERT_EQ(layer.strokes.size(), 1U);
    const std::vector<Vec2>& steps = layer.strokes.front().points;
    ASSERT_EQ(steps.size(), 4U) << "along, down, and along to the border";
    EXPECT_EQ(steps[0].y, steps[1].y);
    EXPECT_EQ(steps[1].x, steps[2].x);
    EXPECT_LT(steps[2].y, steps[1].y);
    return;
  }
  FAIL() << "no front";
}

}  // namespace
}  // namespace epura::study::log_plot_test
