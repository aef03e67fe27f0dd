// SPDX-License-Identifier: Apache-2.0
// `epura study` becomes another program, or says that there is none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <numbers>

#include "at_length.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "program.hpp"

namespace epura::test::study_test {
namespace {

TEST(StudyProgram, IsNamedWhereItIsNotInstalled) {
  const Folder folder;
  // A copy of epura alone.
  const Outcome run = epura({"study", "stability"}, folder / "", {}, R"(cp "$0" epura && exec ./epura "$@")");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "/epura-study")) << run.err;
  EXPECT_TRUE(contains(run.err, "hint: install the package epura-study")) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(StudyProgram, GetsTheArgumentsAsTheyAre) {
  const Folder folder;
  const Outcome run = epura({"study", "stability", "--cases", "P1 P2", "-o", "-"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--format")) << run.err;
  const Outcome wrong = epura({"study", "stability", "--cases", "P1 P2"}, folder / "");
  EXPECT_TRUE(contains(wrong.err, "'P1 P2'")) << wrong.err;
}

TEST(StudyProgram, GetsTheSignals) {
  const Folder folder;
  Running run({"study", "stability", "--size", "100"}, folder / "");
  run.signal(SIGINT);
  EXPECT_EQ(run.wait().code, 128 + SIGINT);
}

TEST(StudyProgram, HasMethodsThatDrawingsDoNotTake) {
  const Folder folder;
  for (const char* method : {"sampled", "float", "item-buffer:dpi=600", "exact:bits=24"}) {
    const Outcome run = epura({"draw", sample("elbow.obj"), "--visibility", method, "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, "'epura study accuracy' measures other methods")) << run.err;
  }
  const Outcome run = epura({"draw", sample("elbow.obj"), "--visibility", "noone", "-o", "x.svg"}, folder / "");
  EXPECT_TRUE(contains(run.err, "did you mean 'none'?")) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

Outcome draw_within(const char* allowed, std::vector<std::string> more = {}) {
  const Folder folder;
  more.insert(more.begin(), {"draw", sample("elbow.obj"), "--max-error", allowed, "-o", "x.svg"});
  return epura(more, folder / "");
}

TEST(MaxError, IsKeptAndTold) {
  const Outcome run = draw_within("3", {"--verify"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err,
                       "max-error 3 mm: lines merged within 0.391 "
                       "mm, 1 decimals in SVG; hidden lines by the exact method"))
      << run.err;
  EXPECT_TRUE(contains(run.err, "isometric: lines are within ")) << run.err;
}

TEST(MaxError, IsRefusedWhereItCannotBeKept) {
  const auto refused = [](const Outcome& outcome, const char* reason) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome.err, reason)) << outcome.err;
  };
  refused(draw_within("0.1"), "lines of view 'isometric' may be off by ");
  refused(draw_within("0.1"), " mm, or export the model with finer facets, or draw it from STEP");
  const Folder folder;
  refused(epura({"draw", sample("shaft.obj"), "--max-error", "0.5", "--join-within", "1", "-o", "x.svg"}, folder / ""),
          "may be off by ");
  refused(draw_within("0.1", {"--visibility", "none"}), "omit --visibility none");
  refused(draw_within("0"), "--max-error: is 0");
}

// Its fillets are tangent to their faces, so facets say nothing of where these meet; and at 0.2 mm, some contours end
// as those of facets do.
TEST(MaxError, IsKeptWhereFacesAreTangent) {
  const Folder folder;
  for (const char* allowed : {"0.01", "0.05", "0.2", "0.5", "2"}) {
    const Outcome run = epura({"draw", EPURA_TEST_SAMPLES "/step/clamp.step", "--views", "front,top,left", "--sheet",
                               "A3", "--scale", "2:1", "--max-error", allowed, "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

constexpr double rim = 20, height = 30;  // of a hyperboloid of one sheet, from the plane of its waist

// Of facets along its straight lines, which turn by a right angle from one rim to the other, as meshers make it.
std::string hyperboloid(int around, int rows) {
  std::string text, bottom = "f", top = "f";
  const auto number = [&](int row, int i) { return ' ' + std::to_string(row * around + i % around + 1); };
  for (int row = 0; row <= rows; ++row)
    for (int i = 0; i < around; ++i) {
      const double part = static_cast<double>(row) / rows, a = 2 * std::numbers::pi * i / around;
      const double c = std::cos(a), s = std::sin(a);
      text += "v " + format_number(rim * (c - part * (c + s))) + ' ' + format_number(rim * (s + part * (c - s))) + ' ' +
              format_number(height * (2 * part - 1)) + '\n';
    }
  for (int i = 0; i < around; ++i) {
    bottom += number(0, around - 1 - i);
    top += number(rows, i);
    for (int row = 0; row < rows; ++row) {
      const std::string a = number(row, i), c = number(row + 1, i + 1);
      text += "f" + a + number(row, i + 1) + c + "\nf" + a + c + number(row + 1, i) + '\n';
    }
  }
  return text + bottom + '\n' + top + '\n';
}

// The largest distance of ends of lines from the outline of the hyperboloid, x^2 = (rim^2 + slope^2 z^2) / 2, and its
// rims, in a drawing in which each millimetre is one of its own.
double off_hyperboloid(const std::string& json) {
  std::vector<std::vector<double>> ends;
  for (const std::string key : {"{\"from\": [", "\"to\": ["})
    for (std::size_t at = json.find(key); at != std::string::npos; at = json.find(key, at + 1)) {
      const std::size_t from = at + key.size();
      std::string numbers = json.substr(from, json.find(']', from) - from);
      std::erase(numbers, ' ');
      ends.push_back(parse_numbers(numbers).value());
    }
  const auto middle = [&](std::size_t axis) {
    const auto [low, high] = std::ranges::minmax(ends, {}, [&](const auto& end) { return end[axis]; });
    return (low[axis] + high[axis]) / 2;
  };
  const double x0 = middle(0), z0 = middle(1), slope = rim / height;
  double largest = 0;
  for (const std::vector<double>& end : ends) {
    const double x = end[0] - x0, z = end[1] - z0;
    const double value = x * x - (rim * rim + slope * slope * z * z) / 2;
    const double off = std::abs(value) / std::hypot(2 * x, slope * slope * z);
    largest = std::max(largest, std::min(off, std::abs(height - std::abs(z))));
  }
  return largest;
}

// Contours of its facets go there and back along its straight lines, and are not as far off as these are long.
TEST(MaxError, CountsHowFarContoursLeadAway) {
  const Folder folder;
  for (const auto& [around, rows] : {std::array{24, 24}, {48, 6}, {96, 12}, {192, 24}}) {
    write_file(folder / "hyperboloid.obj", hyperboloid(around, rows));
    const Outcome run = epura({"draw", "hyperboloid.obj", "--projection", "front", "--hidden", "none", "--sheet",
                               "none", "--scale", "1:1", "-o", "x.json"},
                              folder / "");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string json = read_file(folder / "x.json"), key = "\"total\": ";
    const std::size_t from = json.find(key) + key.size();
    const double stated = parse_number(json.substr(from, json.find(',', from) - from)).value();
    const double measured = off_hyperboloid(json);
    EXPECT_GT(measured, 0.01);
    EXPECT_LE(measured, stated) << around << ' ' << rows;
    EXPECT_LE(stated, 5 * measured) << around << ' ' << rows;
  }
}

TEST(MaxError, IsRefusedAtOnceWhereNothingIsCertain) {
  const Folder folder;
  const std::vector<std::string> draw{
      "draw", EPURA_TEST_SAMPLES "/step/clamp.step", "--max-error", "0.00001", "--time-limit", "20", "-o", "x.svg"};
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--sheet", "A3", "--scale", "2:1"}}) {
    std::vector<std::string> arguments = draw;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, "no part of a line shorter than a millionth of the drawing is certain")) << run.err;
    EXPECT_FALSE(contains(run.err, "hint: raise --max-error to ")) << run.err;  // a number that might take hours
  }
}

// What a refusal tells to ask for is kept, whatever was asked for before. Of facets that are made for it, see
// spline_faces_test.
TEST(MaxError, IsKeptAtTheValueOfTheHint) {
  const Folder folder;
  std::vector<std::string> models{sample("elbow.obj"), sample("shaft.obj"), sample("flange.obj")};
  if (at_length()) models.emplace_back(EPURA_TEST_SAMPLES "/step/clamp.step");  // a minute
  for (const std::string& model : models)
    for (const char* asked : {"0.001", "0.01"}) {
      const auto draw = [&](const std::string& allowed) {
        return epura({"draw", model, "--views", "front,isometric", "--max-error", allowed, "-o", "x.svg"}, folder / "");
      };
      const Outcome refused = draw(asked);
      if (refused.code == 0) continue;
      const std::string before = "hint: raise --max-error to ";
      const std::size_t from = refused.err.find(before), to = refused.err.find(" mm, or ", from);
      ASSERT_LT(from, to) << model << asked << refused.err;
      const Outcome kept = draw(refused.err.substr(from + before.size(), to - from - before.size()));
      EXPECT_EQ(kept.code, 0) << model << asked << refused.err << kept.err;
    }
}

// The coarsest decimals that keep to their share are chosen.
TEST(MaxError, ChoosesMergingAndDecimals) {
  const Folder folder;
  const auto svg = [&](const char* allowed) {
    const Outcome run =
        epura({"draw", sample("bracket.obj"), "--max-error", allowed, "-o", "-", "--format", "svg"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run;
  };
  EXPECT_TRUE(contains(svg("1").err, ", 2 decimals in SVG"));
  EXPECT_TRUE(contains(svg("0.3").err, ", 2 decimals in SVG"));
  EXPECT_TRUE(contains(svg("0.3").err, "lines merged within 0.06 mm"));
}

TEST(ErrorBudget, IsExplainedByTerms) {
  const Folder folder;
  const Outcome run = epura({"explain", sample("sombrero.obj"), "--views", "front,isometric"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "error on paper, mm")) << run.out;
  for (const char* term : {"total", "surface", "contours", "file", "grid", "hiding"})
    EXPECT_TRUE(contains(run.out, std::string("\n") + term)) << term << run.out;
}

TEST(ErrorBudget, StandsAboveTheTitleBlock) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("flange.obj"), "--frame", "full", "--error-note", "--svg-text", "text",
                             "--language", "de", "-o", "-", "--format", "svg"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Linien auf Papier auf 0.")) << run.out.substr(0, 2000);
}

}  // namespace
}  // namespace epura::test::study_test
