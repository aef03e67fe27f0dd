// SPDX-License-Identifier: Apache-2.0
#include "part_invariance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "compare/comparison.hpp"

namespace epura::bench {

namespace {

constexpr double same_strokes = 0.05;

struct Tessellation {
  const char* name;
  double fineness;  ///< 0: by gmsh
};
constexpr std::array<Tessellation, 5> tessellations{
    {{"1/1500", usual_fineness}, {"1/400", 400}, {"1/5000", 5000}, {"1/15000", 15000}, {"gmsh", 0}}};
constexpr int around_by_gmsh = 48;

/// A part seen from one direction, from one tessellation.
struct Seen {
  double strokes = -1;   ///< -1 if there is no such tessellation
  double tolerance = 0;  ///< mm: how far the facets of both tessellations may move lines
  double differing = 0;  ///< mm of ink farther than that from the other drawing's
};
using SeenByTessellation = std::array<Seen, tessellations.size()>;
using SeenPart = std::array<SeenByTessellation, directions.size()>;

std::optional<Model> model_of(const TopoDS_Shape& shape, const Tessellation& tessellation, Surfaces surfaces) {
  if (tessellation.fineness > 0)
    return Model{.polygons = tessellate(shape, tessellation.fineness), .surfaces = surfaces};
  std::optional<std::string> stl = stl_by_gmsh(shape, around_by_gmsh);
  if (!stl) return std::nullopt;
  return Model{.file = "part.stl", .content = std::move(*stl), .surfaces = surfaces};
}

/// The ink of a view, in mm from the image of the world's origin: the place of a view on its sheet depends on its size,
/// and thus on the tessellation.
compare::PictureFile picture_of(const DrawnView& view) {
  const std::array<double, 16>& m = view.world_to_page;
  const Vec2 origin = Vec2(m[3], m[7]) / m[15];
  compare::PictureFile file;
  file.is_in_place = true;
  compare::Picture& picture = file.pages.emplace_back();
  picture.looks = {{.name = "visible", .width = 0.5}, {.name = "hidden", .visible = false, .width = 0.25}};
  picture.views = {view.name};
  for (const Line& line : view.lines)
    picture.pieces.push_back({Vec2(line.from[0], line.from[1]) - origin, Vec2(line.to[0], line.to[1]) - origin,
                              line.visible ? 0 : 1, 0, -1});
  return file;
}

/// How far a view's lines may be from those of another tessellation, as stated: by the heights of surfaces over facets,
/// by merging of lines, and by the grid. Ends of contours at cusps, and lines where surfaces nearly touch, may be
/// farther away; this is not granted here.
double tolerance_of(const DrawnView& view) {
  double sum = 0;
  for (const ErrorTerm& term : view.error.terms)
    if (term.term == "surface" || term.term == "merging" || term.term == "grid") sum += term.mm;
  return sum;
}

double differing_ink(const DrawnView& usual, const DrawnView& other, double tolerance) {
  double length = 0;
  for (const compare::Difference& found : compare::compare(picture_of(usual), picture_of(other), tolerance).differences)
    length += found.length;
  return length;
}

Numbers see(const Part& part, Surfaces surfaces, const Stage& stage) {
  stage("the part");
  const TopoDS_Shape shape = part.make();
  SeenPart seen;
  std::vector<DrawnView> usual;
  for (std::size_t t = 0; t < tessellations.size(); ++t) {
    stage(std::string("the triangles, ") + tessellations[t].name);
    const std::optional<Model> model = model_of(shape, tessellations[t], surfaces);
    if (!model) continue;
    stage(std::string("the drawing, ") + tessellations[t].name);
    for (std::size_t d = 0; d < directions.size(); ++d) {
      const Drawing drawing = drawing_of(*model, directions[d]);
      const DrawnView& view = drawing.views().at(0);
      if (t == 0) usual.push_back(view);
      const double tolerance = tolerance_of(view) + tolerance_of(usual[d]);
      seen[d][t] = {strokes_of(drawing), tolerance, differing_ink(usual[d], view, tolerance)};
    }
  }
  Numbers numbers;
  for (const SeenByTessellation& view : seen)
    for (const Seen& one : view) numbers.insert(numbers.end(), {one.strokes, one.tolerance, one.differing});
  return numbers;
}

SeenPart seen_of(const Numbers& numbers) {
  SeenPart seen;
  std::size_t at = 0;
  for (SeenByTessellation& view : seen)
    for (Seen& one : view) {
      one = {numbers.at(at), numbers.at(at + 1), numbers.at(at + 2)};
      at += 3;
    }
  return seen;
}

bool has_result(const Seen& seen) { return seen.strokes >= 0; }

bool are_as_many(const SeenByTessellation& view) {
  const double usual = view.front().strokes;
  return std::all_of(view.begin(), view.end(), [&](const Seen& seen) {
    return !has_result(seen) || std::abs(seen.strokes - usual) <= same_strokes * usual;
  });
}

/// Prints the rows of parts, and counts what is the same.
class Table {
 public:
  Table() {
    std::string head = "| part | view", rule = "|---|---|";
    for (const Tessellation& tessellation : tessellations) head += std::string(" | strokes ") + tessellation.name;
    head += " | as many";
    for (std::size_t t = 1; t < tessellations.size(); ++t)
      head += std::string(" | mm beyond mm, ") + tessellations[t].name;
    for (std::size_t column = 0; column < 2 * tessellations.size(); ++column) rule += "---|";
    print(head + " |\n" + rule);
  }

  void add(const std::string& part, const Outcome& outcome) {
    if (outcome.trouble) {
      ++failed_;
      return print("| " + part + " | " + sentence_of(outcome) + " |");
    }
    const SeenPart seen = seen_of(outcome.numbers);
    bool all_as_many = true;
    for (std::size_t d = 0; d < directions.size(); ++d) {
      print("| " + part + " | " + directions[d].name + columns_of(seen[d]));
      all_as_many = count(seen[d]) && all_as_many;
    }
    ++parts_;
    as_many_parts_ += all_as_many ? 1 : 0;
  }

  void print_shares() const {
    print("\nAs many strokes as at " + std::string(tessellations.front().name) +
          ", within 5 %: " + percent(as_many_views_, views_) + " of " + std::to_string(views_) +
          " views, all views of " + percent(as_many_parts_, parts_) + " of " + std::to_string(parts_) +
          " parts. The same ink, within the sum of their sagittas: " + percent(same_, pairs_) + " of " +
          std::to_string(pairs_) + " pairs; differing by up to 2 mm of ink: " + percent(nearly_same_, pairs_) +
          ". Parts without a result: " + std::to_string(failed_) + ".");
  }

  [[nodiscard]] bool any() const { return parts_ > 0; }

 private:
  static std::string columns_of(const SeenByTessellation& view) {
    std::string columns;
    for (const Seen& seen : view) columns += " | " + (has_result(seen) ? format_number(seen.strokes) : "-");
    columns += are_as_many(view) ? " | yes" : " | no";
    for (std::size_t t = 1; t < view.size(); ++t)
      columns += " | " + (has_result(view[t])
                              ? format_fixed(view[t].differing, 2) + " beyond " + format_fixed(view[t].tolerance, 3)
                              : "-");
    return columns + " |";
  }

  // Returns whether there are as many strokes.
  bool count(const SeenByTessellation& view) {
    constexpr double little = 2;  // mm
    for (std::size_t t = 1; t < view.size(); ++t) {
      if (!has_result(view[t])) continue;
      ++pairs_;
      same_ += view[t].differing == 0 ? 1 : 0;
      nearly_same_ += view[t].differing <= little ? 1 : 0;
    }
    const bool as_many = are_as_many(view);
    ++views_;
    as_many_views_ += as_many ? 1 : 0;
    return as_many;
  }

  std::size_t views_ = 0, as_many_views_ = 0, parts_ = 0, as_many_parts_ = 0, pairs_ = 0, same_ = 0, nearly_same_ = 0,
              failed_ = 0;
};

}  // namespace

bool compare_tessellations(const std::vector<Part>& parts, Surfaces surfaces, const Limits& limits) {
  std::vector<Work> works;
  for (const Part& part : parts)
    works.emplace_back([&part, surfaces](const Stage& stage) { return see(part, surfaces, stage); });
  Table table;
  run_apart(works, limits, [&](std::size_t i, const Outcome& outcome) { table.add(parts[i].name, outcome); });
  table.print_shares();
  return table.any();
}

}  // namespace epura::bench
