// SPDX-License-Identifier: Apache-2.0
// Measures how well drawings of tessellated parts represent the parts:
//   part [--surfaces mesh] [--finenesses] [--only TEXT] [--jobs N] [--time-limit SECONDS] [FOLDER|FILE...]
//
// Built-in parts, and those in STEP, IGES and BREP files, are tessellated as for STL and drawn by epura, and their ink
// is compared with the lines that Open CASCADE's exact hidden-line removal finds on the surfaces themselves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <epura/epura.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "apart.hpp"
#include "base/text.hpp"
#include "part_drawing.hpp"
#include "part_geometry.hpp"
#include "part_invariance.hpp"
#include "part_score.hpp"

namespace {

using namespace epura;
using namespace epura::bench;

struct Options {
  Surfaces surfaces = Surfaces::automatic;
  bool finenesses = false;
  std::string only{};
  Limits limits{static_cast<int>(std::max(1U, std::thread::hardware_concurrency())), 60};
  std::vector<std::string> paths{};
};

Ink ink_of(const DrawnView& view) {
  Ink ink;
  for (const Line& line : view.lines)
    (line.visible ? ink.visible : ink.hidden)
        .push_back({Vec2(line.from[0], line.from[1]), Vec2(line.to[0], line.to[1])});
  return ink;
}

PageLines on_page(const std::vector<PlaneLine>& lines, const ExactView& exact, const DrawnView& view) {
  const std::array<double, 16>& m = view.world_to_page;
  const auto place = [&](const Vec2& at) {
    const Vec3 p = at.x * exact.right + at.y * exact.up;
    const auto row = [&](std::size_t i) { return m[i] * p.x + m[i + 1] * p.y + m[i + 2] * p.z + m[i + 3]; };
    return Vec2(row(0), row(4)) / row(12);
  };
  PageLines placed;
  for (const PlaneLine& line : lines) placed.push_back({place(line[0]), place(line[1])});
  return placed;
}

/// One row: a part seen from one direction.
struct Row {
  Score score;
  double strokes;
  double lost;  ///< curves of Open CASCADE that could not be followed, and so do not count as missing
};
static_assert(sizeof(Row) % sizeof(double) == 0);

Numbers numbers_of(const Row& row) {
  Numbers numbers(sizeof(Row) / sizeof(double));
  std::memcpy(numbers.data(), &row, sizeof(Row));
  return numbers;
}

Row row_of(const Numbers& numbers) {
  Row row{};
  if (numbers.size() != sizeof(Row) / sizeof(double)) throw std::logic_error("a row has another number of columns");
  std::memcpy(&row, numbers.data(), sizeof(Row));
  return row;
}

// The exact lines are used unchanged, even where they are known to be wrong: for the thread of an M6 screw, Open
// CASCADE shows hidden lines as visible, which reduces recall. A judge that omits inconvenient evidence proves nothing.
Numbers judge(const Part& part, const Direction& direction, Surfaces surfaces, const Stage& stage) {
  stage("the part");
  const TopoDS_Shape shape = part.make();
  stage("its triangles");
  const Polygons polygons = tessellate(shape, usual_fineness);
  stage("its exact lines");
  const auto& [x, y, z] = direction.viewer;
  mark_tangent_edges(shape);
  const ExactView exact = exact_view(shape, {x, y, z});
  stage("the drawing");
  const Drawing drawing = drawing_of({.polygons = polygons, .surfaces = surfaces}, direction);
  stage("the score");
  const DrawnView& view = drawing.views().at(0);
  const auto placed = [&](const std::vector<PlaneLine>& lines) { return on_page(lines, exact, view); };
  const ExactLines lines{placed(exact.visible), placed(exact.hidden), placed(exact.smooth_visible),
                         placed(exact.smooth_hidden)};
  return numbers_of({score_of(ink_of(view), lines), strokes_of(drawing), static_cast<double>(exact.lost)});
}

double ink_ratio(const Row& row) {
  if (row.score.exact > 0) return row.score.ink / row.score.exact;
  return row.score.ink > 0 ? HUGE_VAL : 1;
}

std::string row_text(const std::string& part, const Direction& direction, const Row& row) {
  const Score& s = row.score;
  std::string text = "| " + part + " | " + direction.name;
  for (const double share : {s.recall, s.precision, s.recall_hidden, s.precision_hidden})
    text += " | " + format_fixed(share, 4) + (share < 0.99 ? " *" : "");
  return text + " | " + format_fixed(ink_ratio(row), 3) + " | " + format_fixed(s.loose_ends, 0) + " | " +
         format_fixed(row.strokes, 0) + " |";
}

/// A line of the table of means.
struct Measure {
  const char* name;
  double (*value)(const Row& row);
  double aim;         ///< target for the mean
  double limit;       ///< bound for a good view
  double good_share;  ///< target percentage of good views; 0: none
  bool more_is_better;
};

constexpr std::array<Measure, 6> measures{{
    {"recall of visible lines", [](const Row& r) { return r.score.recall; }, 0.993, 0.99, 92, true},
    {"precision of visible lines", [](const Row& r) { return r.score.precision; }, 0.998, 0.99, 95, true},
    {"recall of hidden lines", [](const Row& r) { return r.score.recall_hidden; }, 0.99, 0.99, 90, true},
    {"precision of hidden lines", [](const Row& r) { return r.score.precision_hidden; }, 0.99, 0.99, 90, true},
    {"visible ink, of the exact lines", ink_ratio, 1.03, 1.03, 0, false},
    {"loose ends a sheet", [](const Row& r) { return r.score.loose_ends; }, 5, 5, 0, false},
}};

/// The ratio of ink is that of the total lengths: a view of few lines has little weight.
double mean_of(const Measure& measure, const std::vector<Row>& rows) {
  double sum = 0, exact = 0;
  for (const Row& row : rows) {
    sum += measure.value == ink_ratio ? row.score.ink : measure.value(row);
    exact += row.score.exact;
  }
  return sum / (measure.value == ink_ratio ? exact : static_cast<double>(rows.size()));
}

void print_means(const std::vector<Row>& rows, std::size_t views) {
  print("\n| " + std::to_string(rows.size()) + " views | mean | aim | share of views | aim |\n|---|---|---|---|---|");
  for (const Measure& measure : measures) {
    const char* sign = measure.more_is_better ? "≥ " : "≤ ";
    const auto good = std::count_if(rows.begin(), rows.end(), [&](const Row& row) {
      return measure.more_is_better ? measure.value(row) >= measure.limit : measure.value(row) <= measure.limit;
    });
    print(std::string("| ") + measure.name + " | " + format_fixed(mean_of(measure, rows), 4) + " | " + sign +
          format_fixed(measure.aim, 3) + " | " + sign + format_fixed(measure.limit, 2) + ": " +
          percent(static_cast<std::size_t>(good), rows.size()) + " | " +
          (measure.good_share > 0 ? format_fixed(measure.good_share, 0) + " %" : "") + " |");
  }
  double strokes = 0, lost = 0;
  for (const Row& row : rows) {
    strokes += row.strokes;
    lost += row.lost;
  }
  print("\nStrokes: " + format_fixed(strokes, 0) + ". Exact curves that Open CASCADE cannot follow: " +
        format_fixed(lost, 0) + ". Views without a result: " + std::to_string(views - rows.size()) + ".");
}

bool judge_all(const std::vector<Part>& parts, const Options& options) {
  std::vector<Work> works;
  for (const Part& part : parts)
    for (const Direction& direction : directions)
      works.emplace_back([&part, &direction, &options](const Stage& stage) {
        return judge(part, direction, options.surfaces, stage);
      });
  print("| part | view | recall | precision | recall, hidden | precision, hidden | ink ratio | loose ends | strokes |");
  print("|---|---|---|---|---|---|---|---|---|");
  std::vector<Row> rows;
  run_apart(works, options.limits, [&](std::size_t i, const Outcome& outcome) {
    const std::string& part = parts[i / directions.size()].name;
    const Direction& direction = directions[i % directions.size()];
    if (outcome.trouble) {
      print("| " + part + " | " + direction.name + " | " + sentence_of(outcome) + " |");
    } else {
      rows.push_back(row_of(outcome.numbers));
      print(row_text(part, direction, rows.back()));
    }
  });
  if (!rows.empty()) print_means(rows, works.size());
  return !rows.empty();
}

[[noreturn]] void refuse(const std::string& reason) {
  std::fprintf(stderr,
               "part: %s\nusage: part [--surfaces mesh] [--finenesses] [--only TEXT] [--jobs N] [--time-limit SECONDS]"
               " [FOLDER|FILE...]\n",
               reason.c_str());
  std::exit(2);
}

Options options_of(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&]() -> const std::string& {
      if (++i == words.size()) refuse(word + " needs a value");
      return words[i];
    };
    const auto number = [&] {
      const auto parsed = parse_number(value());
      if (!parsed || !(*parsed >= 1 && *parsed <= 1e6)) refuse(words[i] + " is no number from 1 to a million");
      return *parsed;
    };
    if (word == "--finenesses")
      options.finenesses = true;
    else if (word == "--only")
      options.only = value();
    else if (word == "--jobs")
      options.limits.at_once = static_cast<int>(number());
    else if (word == "--time-limit")
      options.limits.seconds = number();
    else if (word == "--surfaces" && (value() == "mesh" || words[i] == "auto"))
      options.surfaces = words[i] == "mesh" ? Surfaces::mesh : Surfaces::automatic;
    else if (word.starts_with("-"))
      refuse(words[i] + " is not known");
    else
      options.paths.push_back(word);
  }
  return options;
}

std::vector<Part> wanted_parts(const Options& options) {
  std::vector<Part> parts = made_parts();
  for (const std::string& path : options.paths) {
    const std::vector<Part> found = parts_in(path);
    if (found.empty()) refuse("no parts in STEP, IGES or BREP files in " + path);
    parts.insert(parts.end(), found.begin(), found.end());
  }
  std::erase_if(parts, [&](const Part& part) { return part.name.find(options.only) == std::string::npos; });
  return parts;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = options_of({argv + 1, argv + argc});
  const std::vector<Part> parts = wanted_parts(options);
  const bool any =
      options.finenesses ? compare_tessellations(parts, options.surfaces, options.limits) : judge_all(parts, options);
  return any ? 0 : 1;
}
