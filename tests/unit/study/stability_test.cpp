// SPDX-License-Identifier: Apache-2.0
// The stability study: its table is complete, its verdicts follow from its numbers, and epura is right.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "study/stability/exact_places.hpp"
#include "study/stability/forms.hpp"
#include "study/stability/write.hpp"

namespace epura::stability::stability_test {
namespace {

// The families of cases and how many each has.
const std::vector<std::pair<char, int>> numbers{{'P', 16}, {'V', 13}, {'M', 37}, {'R', 9}, {'S', 3}, {'D', 5}};

TEST(StabilityCases, AreAllThereInOrderWithEnoughSteps) {
  const std::vector<Case> cases = all_cases();
  std::size_t at = 0;
  for (const auto& [family, last] : numbers)
    for (int number = 1; number <= last; ++number, ++at) {
      ASSERT_LT(at, cases.size());
      EXPECT_EQ(cases[at].id, family + std::to_string(number));
      EXPECT_GE(cases[at].steps.size(), 8U) << cases[at].id;
      const std::set<double> different(cases[at].steps.begin(), cases[at].steps.end());
      EXPECT_EQ(different.size(), cases[at].steps.size()) << cases[at].id;
    }
  EXPECT_EQ(at, cases.size());
}

// In the table of the documentation, with which the one of a run is compared (stability_command_test).
TEST(StabilityCases, EpuraGetsThemRightAndOthersDoNot) {
  constexpr std::size_t columns = 66, width = 10;  // of the ways, then of the verdict
  const std::string page = read_file(test::root() / "docs/numerics.md");
  const std::size_t begin = page.find("$ epura study stability\n"), end = page.find("```", begin);
  ASSERT_LT(begin, end);
  std::size_t rows = 0, single = 0, composed = 0;
  for (const std::string_view row : split(std::string_view(page).substr(begin, end - begin), '\n')) {
    if (row.size() <= columns + 4 * width || row.starts_with(' ')) continue;
    ++rows;
    const auto fails = [&](int way) { return row[columns + width * static_cast<std::size_t>(way)] != '-'; };
    const std::string_view verdict = row.substr(columns + 4 * width);
    EXPECT_TRUE(verdict == "right" || verdict == "limited") << row;
    for (const int way : {2, 3}) EXPECT_EQ(fails(way), verdict == "limited") << row;
    single += fails(0) ? 1 : 0;
    composed += fails(1) ? 1 : 0;
  }
  EXPECT_EQ(rows, all_cases().size());
  EXPECT_GE(single, 10);
  EXPECT_GE(composed, 2);
}

// One case of one quantity that is off by the step.
Case off_by_the_step(double rounding) {
  Case one{"P1", "planted", "error", {1e-9, 1e-7, 1e-5, 1e-3}, {}};
  one.measure = [rounding](const Lab&, double step) {
    return Measured{count("pieces", 3, 3), {"length", 2, 2 + 2 * step, 2, guaranteed_part, rounding}};
  };
  return one;
}

TEST(StabilityVerdicts, FollowFromErrors) {
  const std::vector<Case> cases{off_by_the_step(0)};
  const CaseReport found = run(cases, 1).front();
  EXPECT_EQ(found.breaks_at(Way::own), 1e-5);
  EXPECT_EQ(found.verdict(Way::own), Verdict::broken);
  const Outcome& outcome = found.rows[2].outcomes[0];
  EXPECT_EQ(outcome.worst()->name, "length");
  EXPECT_NEAR(outcome.error(), 1e-5, 1e-12);
}

TEST(StabilityVerdicts, AreLimitedWhereTheRoundingOfTheInputExplainsTheError) {
  const std::vector<Case> cases{off_by_the_step(1e-4)};
  const CaseReport found = run(cases, 1).front();
  EXPECT_EQ(found.rows[1].outcomes[2].verdict(), Verdict::right);
  EXPECT_EQ(found.rows[2].outcomes[2].verdict(), Verdict::limited);
  EXPECT_EQ(found.rows[3].outcomes[2].verdict(), Verdict::broken);
}

TEST(StabilityVerdicts, AreBrokenWhereNothingComesOut) {
  Case one = off_by_the_step(0);
  one.measure = [](const Lab& lab, double step) -> Measured {
    if (lab.arithmetic == Arithmetic::single) throw Error(ErrorKind::input, "map", "nothing, \"really\"");
    return {count("pieces", 0, step > 1e-4 ? std::numeric_limits<double>::quiet_NaN() : 0)};
  };
  const Report report = run(std::vector<Case>{one}, 1);
  EXPECT_EQ(report[0].breaks_at(Way::single), 1e-9);
  EXPECT_EQ(report[0].breaks_at(Way::own), 1e-3);
  EXPECT_TRUE(test::contains(to_csv(report), "P1,1e-09,float32,,,,inf,,,broken,\"map: nothing, \"\"really\"\"\""));
  EXPECT_TRUE(test::contains(to_json(report, false), "\"error\": null"));
}

TEST(StabilityLimits, StepsGoOnAsTheyBegan) {
  const auto beyond = [](std::vector<double> steps) { return step_beyond(steps); };
  EXPECT_EQ(beyond({1, 1e-3, 1e-6}), 1e-7);
  EXPECT_EQ(beyond({0.5, 20.5, 1e3}), 1e4);
  EXPECT_EQ(beyond({5, 10, 100}), 200) << "counts are doubled";
  EXPECT_EQ(beyond({8, 6, 4}), 2);
  EXPECT_EQ(beyond({1, 1e7}), 1e8);
  EXPECT_EQ(beyond({2, 1}), std::nullopt) << "there is no count below one";
  EXPECT_EQ(beyond({1e-15, 0}), std::nullopt);
  EXPECT_EQ(beyond({1, 2, -3}), std::nullopt);
}

// Steps beyond those of the case are wrong, refused or limited.
TEST(StabilityLimits, AreWhereACaseFails) {
  Case one{"P1", "planted", "error", {1e-12, 1e-11, 1e-10}, {}};
  one.measure = [](const Lab& lab, double step) -> Measured {
    EXPECT_EQ(lab.arithmetic, Arithmetic::own);
    return {length("length", 2, 2 + 2 * step, 2)};
  };
  Case refuses = one, limited = one, kinds = one;
  refuses.measure = [](const Lab&, double step) -> Measured {
    if (step > 1e-8) throw Error(ErrorKind::input, "map", "nothing in front");
    return {count("pieces", 1, 1)};
  };
  limited.measure = [](const Lab&, double step) -> Measured { return {{"length", 0, step, 1, 1e-9, 1}}; };
  kinds.kinds = true;
  const std::vector<CaseLimit> limits = find_limits(std::vector<Case>{one, refuses, limited, kinds}, 1, 100);
  EXPECT_EQ(limits[0].end, End::wrong);
  EXPECT_NEAR(limits[0].right, 1e-6, 1e-12);
  EXPECT_NEAR(limits[0].first.value_or(0), 1e-5, 1e-12);
  EXPECT_EQ(limits[1].end, End::refused);
  EXPECT_EQ(limits[2].end, End::limited);
  EXPECT_NEAR(limits[2].right, 1e-9, 1e-15);
  EXPECT_EQ(limits[3].end, End::kinds);
  EXPECT_EQ(limits[3].right, 1e-10);
  const std::string text = to_text(limits);
  for (const char* part : {"wrong: length 2.00002 instead of 2", "refused: map: nothing in front",
                           "limited by rounding", "nothing lies beyond"})
    EXPECT_TRUE(test::contains(text, part)) << text;
}

TEST(StabilityLimits, AreToldWhereNothingFails) {
  Case one{"P1", "planted", "size", {1, 1e10, 1e20}, {}};
  one.measure = [](const Lab&, double) { return Measured{count("pieces", 1, 1)}; };
  const CaseLimit limit = find_limits({&one, 1}, 1, 100).front();
  EXPECT_EQ(limit.end, End::numbers);
  EXPECT_FALSE(limit.first);
  EXPECT_EQ(find_limits({&one, 1}, 1, 0).front().end, End::slow);
}

// A planted error of one line in a drawing that is right without it.
TEST(StabilityVerdicts, FindALineThatIsMissing) {
  const std::vector<Case> cases = all_cases();
  Result result = Lab().draw(world_of(box({0, 0, 0}, {1, 1, 1})), {orthographic({1, 1, 1})});
  const double visible = result.visible(), hidden = result.hidden_length();
  const auto verdict = [&] { return Outcome{lengths(result, visible, hidden), {}}.verdict(); };
  EXPECT_EQ(verdict(), Verdict::right);
  result.drawing.segments.back().visible = !result.drawing.segments.back().visible;
  EXPECT_EQ(verdict(), Verdict::broken);
}

TEST(StabilityPlaces, AreFoundWrongByAsMuchAsTheyAreMoved) {
  Result result = Lab().draw(world_of(box({0, 0, 0}, {1, 1, 1})), {orthographic({1, 2, 3})});
  EXPECT_LT(places(result).error(), 1e-15);
  result.view.vertices[5].x += 1e-3 * result.view.extent;
  EXPECT_NEAR(places(result).error(), 1e-3, 1e-12);
}

struct Reports : ::testing::Test {
  Report report = run(std::vector<Case>{all_cases().front(), all_cases().back()}, 0.1);
};

TEST_F(Reports, AgreeWithEachOther) {
  const Json json = JsonReader(to_json(report, false)).read();
  const std::string csv = to_csv(report), text = to_text(report, true), html = to_html(report);
  ASSERT_EQ(json["cases"].items.size(), report.size());
  for (std::size_t i = 0; i < report.size(); ++i) {
    const Json& one = json["cases"].items[i];
    EXPECT_EQ(one["id"].text, report[i].id);
    EXPECT_EQ(one["rows"].items.size(), report[i].rows.size());
    for (const std::string* other : {&csv, &text, &html}) EXPECT_TRUE(test::contains(*other, report[i].id));
  }
  std::size_t quantities = 0;
  for (const CaseReport& one : report)
    for (const Row& row : one.rows)
      for (const Outcome& outcome : row.outcomes) quantities += std::max<std::size_t>(1, outcome.measured.size());
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), quantities + 1);
}

TEST_F(Reports, PlotEveryStepOfEveryArithmetic) {
  const sheet::Sheet sheet = to_sheet(report.front());
  std::size_t marks = 0;
  for (const sheet::Layer& layer : sheet.layers) {
    for (const sheet::Stroke& stroke : layer.strokes)
      for (const Vec2& p : stroke.points)
        EXPECT_TRUE(p.x >= 0 && p.x <= sheet.width && p.y >= 0 && p.y <= sheet.height) << layer.name;
    marks += layer.fills.size();
  }
  std::size_t right = 0;
  for (const Row& row : report.front().rows)
    for (const Outcome& outcome : row.outcomes) right += outcome.verdict() == Verdict::right ? 1 : 0;
  EXPECT_EQ(marks, right);
}

TEST_F(Reports, ThePageNeedsNothingElse) {
  const std::string html = to_html(report);
  for (const char* reference : {" src=", "<link", "@import", "url(", "<?xml"})
    EXPECT_FALSE(test::contains(html, reference)) << reference;
  std::size_t pictures = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) ++pictures;
  EXPECT_EQ(pictures, report.size() + 1) << "of each case, and a table of all";
}

}  // namespace
}  // namespace epura::stability::stability_test
