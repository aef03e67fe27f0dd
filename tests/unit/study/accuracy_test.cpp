// SPDX-License-Identifier: Apache-2.0
// The truth knows what each method gets wrong; methods converge as theory says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>

#include "oracle/span_sets.hpp"
#include "shapes.hpp"
#include "study/accuracy/measure.hpp"

namespace epura::test::accuracy_test {
namespace {

constexpr double mm = 40;  // of paper per view unit

struct Scene {
  Result result;
  view::ViewLimits limits{};

  [[nodiscard]] study::StudiedView view() const {
    return {"scene", "view", result.world, result.view, limits, result.drawn, {mm, Vec2(0)}};
  }
  [[nodiscard]] visibility::HiddenSpans by(const char* method) const {
    return study::contender(view(), study::parse_method(method, "")).run();
  }
};

// Slabs of many sizes and turns before a comb of bars: ends of spans at all places, and short spans, too.
Shape slabs() {
  std::mt19937 random(7);
  const auto number = [&random](double min, double max) {
    return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
  };
  Shape shape;
  for (int i = 0; i < 24; ++i) {
    const double x = number(-3, 3), y = number(-3, 3), z = 0.5 + 0.03 * i, a = number(0, 3), size = number(0.02, 0.7);
    const double c = size * std::cos(a), s = size * std::sin(a);
    shape.add({{{x + c, y + s, z}, {x - s, y + c, z}, {x - c, y - s, z}, {x + s, y - c, z}}, {{0, 1, 2, 3}}, {}});
  }
  for (int i = -7; i <= 7; ++i) shape.add(box({-3, i * 0.41 - 0.05, -1 - 0.01 * i}, {3, i * 0.41 + 0.06, -0.5}));
  return shape;
}

Scene scene(const projection::Projection& projection = orthographic({0.13, -0.21, 1})) {
  return {draw(world_of(slabs()), projection)};
}

study::Errors errors_by(const Scene& scene, const std::vector<EdgeTruth>& truth, const char* method) {
  return study::errors_of(scene.view(), truth, scene.by(method));
}

TEST(Truth, AgreesWithTheExactMethod) {
  for (const projection::Projection& projection :
       {orthographic({0.13, -0.21, 1}), from_above(), orthographic({1, -1, 1}),
        perspective({5, -4, 6}, {0, 0, 0}, {5, -4, 6}, {0, 0, 1}),
        perspective({0.4, 0.2, 1.9}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0})}) {
    const Scene s = scene(projection);
    const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
    EXPECT_EQ(truth.size(), s.result.drawn.edges.size());
    const study::Errors errors = study::errors_of(s.view(), truth, s.result.hidden);
    EXPECT_EQ(errors.longest, 0);
    EXPECT_EQ(errors.ink, 0);
    EXPECT_EQ(errors.missed + errors.phantom + errors.cracks, 0);
    EXPECT_GT(study::errors_of(s.view(), truth, visibility::nothing_hidden(s.result.drawn)).sum, 100);
  }
}

TEST(Truth, LeavesLittleUndecided) {
  const Scene s = scene();
  double undecided = 0, hidden = 0;
  const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
  for (const EdgeTruth& edge : truth) {
    for (const auto& [from, to] : without(edge.perhaps, edge.surely)) undecided += to - from;
    for (const auto& [from, to] : edge.surely) hidden += to - from;
  }
  EXPECT_GT(hidden, 10);
  EXPECT_LT(undecided, 1e-6 * static_cast<double>(truth.size()));
}

TEST(Truth, FindsAPlantedErrorWithItsLength) {
  const Scene s = scene();
  const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
  const Result& r = s.result;
  int planted = 0;
  for (std::size_t e = 0; e < r.drawn.edges.size() && planted < 20; ++e) {
    const visibility::Spans spans = hidden_parts(r.hidden, e);
    if (spans.size() != 1 || spans[0][0] == 0 || spans[0][1] == 1) continue;
    visibility::HiddenSpans wrong = r.hidden;
    wrong.spans.erase(wrong.spans.begin() + static_cast<std::ptrdiff_t>(r.hidden.first[e]));
    for (std::size_t i = e + 1; i < wrong.first.size(); ++i) --wrong.first[i];
    const view::PageVertex& p = r.view.vertices[r.drawn.edges[e].vertex[0]];
    const view::PageVertex& q = r.view.vertices[r.drawn.edges[e].vertex[1]];
    const double length = (spans[0][1] - spans[0][0]) * std::hypot(p.x - q.x, p.y - q.y) * mm;
    const study::Errors errors = study::errors_of(s.view(), truth, wrong);
    EXPECT_NEAR(errors.longest, length, 1e-5);
    EXPECT_NEAR(errors.sum, length, 1e-5);
    EXPECT_EQ(errors.edges, 1);
    ++planted;
  }
  EXPECT_GE(planted, 8);
}

TEST(Truth, OfManyEdgesASampleIsJudged) {
  const Scene s = scene();
  const std::vector<EdgeTruth> some = study::truth_of(s.view(), {.pairs = 1});
  EXPECT_LT(some.size(), s.result.drawn.edges.size());
  EXPECT_GT(some.size(), 100U);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; }));
}

// Slope of log error over log knob, by least squares.
double slope(const std::vector<double>& knobs, const std::vector<double>& errors) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(knobs.size());
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    const double a = std::log(knobs[i]), b = std::log(errors[i]);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

struct Sweep {
  std::vector<double> knobs, longest, sum, end_point;
};

Sweep sweep(const std::string& method, const std::string& rest, const std::vector<double>& knobs) {
  const Scene s = scene();
  const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
  Sweep result{knobs, {}, {}, {}};
  for (const double knob : knobs) {
    const study::Errors errors = errors_by(s, truth, (method + std::to_string(knob) + rest).c_str());
    result.longest.push_back(errors.longest);
    result.sum.push_back(errors.sum);
    result.end_point.push_back(errors.end_point);
  }
  return result;
}

TEST(Methods, SampledConvergeWithTheDistanceOfPoints) {
  const Sweep points = sweep("sampled:density=", ":halvings=0", {1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64});
  EXPECT_NEAR(slope(points.knobs, points.longest), -1, 0.15) << "a maximum, which scatters more";
  EXPECT_NEAR(slope(points.knobs, points.sum), -1, 0.1);
  EXPECT_NEAR(slope(points.knobs, points.end_point), -1, 0.1);
  for (std::size_t i = 0; i < points.knobs.size(); ++i)
    EXPECT_LE(points.longest[i], 1 / points.knobs[i]) << "the bound";
}

TEST(Methods, BisectedChangesLeaveOnlyMissedSpans) {
  const Sweep bisected = sweep("sampled:density=", "", {1, 2, 4, 8, 16});
  const Sweep plain = sweep("sampled:density=", ":halvings=0", {1, 2, 4, 8, 16});
  for (std::size_t i = 0; i < bisected.knobs.size(); ++i) {
    EXPECT_LE(bisected.longest[i], 1 / bisected.knobs[i]) << "the bound";
    EXPECT_LT(bisected.sum[i], 0.5 * plain.sum[i]);
  }
}

TEST(Methods, HalvingsHalveTheError) {
  const Scene s = scene();
  const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
  const double none = errors_by(s, truth, "sampled:density=64:halvings=0").end_point;
  const double five = errors_by(s, truth, "sampled:density=64:halvings=5").end_point;
  EXPECT_NEAR(std::log2(none / five), 5, 0.7);
}

TEST(Methods, ItemBuffersConvergeWithTheSizeOfPixels) {
  const Sweep pixels = sweep("item-buffer:dpi=", "", {50, 100, 200, 400, 800, 1600});
  EXPECT_NEAR(slope(pixels.knobs, pixels.sum), -1, 0.15);
  EXPECT_NEAR(slope(pixels.knobs, pixels.end_point), -1, 0.3);
}

TEST(Methods, GridBitsHalveTheError) {
  const Scene s = scene();
  const std::vector<EdgeTruth> truth = study::truth_of(s.view(), {});
  std::vector<double> cells, sums;
  for (const int bits : {8, 10, 12, 14}) {
    cells.push_back(std::exp2(bits));
    sums.push_back(errors_by(s, truth, ("exact:bits=" + std::to_string(bits)).c_str()).sum);
  }
  EXPECT_LT(sums.back(), 0.1 * sums.front());
}

TEST(Measure, RanksAPlantedSlowMethodLast) {
  const Scene s = scene();
  const study::StudiedView view = s.view();
  std::vector<study::Contender> contenders{study::contender(view, study::parse_method("exact", "")),
                                           {"slow", "",
                                            [&] {
                                              std::this_thread::sleep_for(std::chrono::milliseconds(300));
                                              return s.result.hidden;
                                            }},
                                           study::contender(view, study::parse_method("none", ""))};
  const study::ViewMeasurements found = study::measure(view, contenders, {.runs = 5});
  ASSERT_EQ(found.methods.size(), 3U);
  const auto slowest = std::max_element(found.methods.begin(), found.methods.end(),
                                        [](const auto& a, const auto& b) { return a.median < b.median; });
  EXPECT_EQ(slowest->method, "slow");
  EXPECT_GE(slowest->median, 0.3);
  EXPECT_EQ(slowest->seconds.size(), 5U);
  EXPECT_FALSE(slowest->on_front) << "the exact method is as right, and faster";
  EXPECT_TRUE(found.methods[0].on_front);
  EXPECT_GT(found.methods[2].errors.longest, 1);
}

TEST(Measure, TellsMemory) {
  const Scene s = scene();
  const study::StudiedView view = s.view();
  std::vector<study::Contender> contenders{{"hungry", "", [&] {
                                              const std::vector<char> bytes(64 << 20, 1);
                                              visibility::HiddenSpans found = s.result.hidden;
                                              if (bytes[12345] == 0) found = {};
                                              return found;
                                            }}};
  const study::ViewMeasurements found = study::measure(view, contenders, {.runs = 5});
  if (!found.methods[0].memory) GTEST_SKIP() << "this system does not tell the memory of a process";
  EXPECT_GT(*found.methods[0].memory, 60e6);
  EXPECT_LT(*found.methods[0].memory, 120e6);
}

TEST(Measure, Medians) {
  EXPECT_EQ(study::median_of({3, 1, 2}), 2);
  EXPECT_EQ(study::median_of({4, 1, 2, 3}), 2.5);
}

TEST(Measure, Quartiles) {
  EXPECT_EQ(study::quartiles_of({}), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(study::quartiles_of({7}), (std::array<double, 2>{7, 7}));
  EXPECT_EQ(study::quartiles_of({5, 1, 2, 4, 3}), (std::array<double, 2>{2, 4}));
  EXPECT_EQ(study::quartiles_of({4, 1, 2, 3}), (std::array<double, 2>{1.75, 3.25}));
}

}  // namespace
}  // namespace epura::test::accuracy_test
