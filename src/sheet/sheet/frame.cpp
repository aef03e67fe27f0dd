// SPDX-License-Identifier: Apache-2.0
#include "sheet/frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double grid_strip = 5;  // outside the frame
constexpr double field_length = 50;
constexpr double letter_height = 3.5;
constexpr double mark_inside = 10;  // of the centring marks
constexpr double trimming_long = 10, trimming_short = 5;
constexpr Vec2 a5(210, 148);
constexpr double longer_side_of_a4 = 297;

bool has_iso_margins(const Paper& paper) { return paper.left == binding_margin && paper.other == plain_margin; }

// Ends of the fields between `min` and `max`, the ends of the frame.
std::vector<double> field_ends(double length, double min, double max) {
  const int fields = static_cast<int>(std::round(length / 2 / field_length));
  std::vector<double> ends = {min};
  for (int i = 1 - fields; i < fields; ++i) ends.push_back(length / 2 + i * field_length);
  ends.push_back(max);
  check(std::is_sorted(ends.begin(), ends.end()), "the fields of a frame are in order");
  return ends;
}

// 0, 1, 2 ... as A, B, C ... Z, AA, AB ... without I and O.
std::string letters(int number) {
  constexpr std::string_view alphabet = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  std::string text;
  for (int rest = number + 1; rest > 0; rest = (rest - 1) / int(alphabet.size()))
    text.insert(text.begin(), alphabet[std::size_t(rest - 1) % alphabet.size()]);
  return text;
}

// Of a field along one side, counted from the left or from below: numbers increase to the right, letters downwards.
std::string name_of_field(std::size_t field, std::size_t fields, int axis) {
  return axis == 0 ? std::to_string(field + 1) : letters(static_cast<int>(fields - 1 - field));
}

// The same on sheets of ASME Y14.1, where both count from the lower right corner.
std::string name_of_ansi_field(int field, int fields, int axis) {
  return axis == 0 ? std::to_string(fields - field) : letters(field);
}

int ansi_fields(const Paper& paper, const AnsiSheet& sheet, int axis) {
  return (axis == 0) == (paper.height > paper.width) ? sheet.short_zones : sheet.long_zones;
}

// One strip of fields along the frame, between `inner` (on the frame) and `outer`. Axis 0 is horizontal.
void add_strip(Furniture& all, const std::vector<double>& ends, double inner, double outer, int axis) {
  const auto point = [axis](double along, double across) {
    return axis == 0 ? Vec2(along, across) : Vec2(across, along);
  };
  const double middle = (inner + outer) / 2;
  const std::size_t fields = ends.size() - 1;
  for (std::size_t i = 0; i < fields; ++i) {
    if (i > 0) all.medium.push_back(line(point(ends[i], inner), point(ends[i], outer)));
    const std::string text = name_of_field(i, fields, axis);
    const Vec2 centre = point((ends[i] + ends[i + 1]) / 2, middle);
    all.texts.push_back({text, centre - Vec2(0, letter_height / 2), letter_height, 0, Align::middle, "grid-reference"});
  }
}

void add_grid(Furniture& all, const Paper& paper) {
  const Rectangle in = drawing_area(paper), out = in.grown(grid_strip);
  const std::vector<double> across = field_ends(paper.width, in.min.x, in.max.x);
  const std::vector<double> up = field_ends(paper.height, in.min.y, in.max.y);
  add_strip(all, across, in.max.y, out.max.y, 0);
  add_strip(all, up, in.max.x, out.max.x, 1);
  if (std::max(paper.width, paper.height) <= longer_side_of_a4) {
    all.medium.push_back(
        {{{in.min.x, in.max.y}, {in.min.x, out.max.y}, out.max, {out.max.x, in.min.y}, {in.max.x, in.min.y}}});
    return;
  }
  add_strip(all, across, in.min.y, out.min.y, 0);
  add_strip(all, up, in.min.x, out.min.x, 1);
  all.medium.push_back(outline(out));
}

void add_centring_marks(Furniture& all, const Paper& paper, const std::optional<Rectangle>& title_block) {
  const Rectangle in = drawing_area(paper), out = in.grown(grid_strip);
  const Vec2 middle = Vec2(paper.width, paper.height) / 2.0;
  const auto add = [&](const Vec2& from, const Vec2& frame, const Vec2& to) {
    const Rectangle reach = {glm::min(frame, to) - wide_line, glm::max(frame, to) + wide_line};
    all.wide.push_back(line(from, title_block && title_block->overlaps(reach) ? frame : to));
  };
  add({middle.x, out.max.y}, {middle.x, in.max.y}, {middle.x, in.max.y - mark_inside});
  add({middle.x, out.min.y}, {middle.x, in.min.y}, {middle.x, in.min.y + mark_inside});
  add({out.min.x, middle.y}, {in.min.x, middle.y}, {in.min.x + mark_inside, middle.y});
  add({out.max.x, middle.y}, {in.max.x, middle.y}, {in.max.x - mark_inside, middle.y});
}

// Two rectangles in each corner of the sheet, as one area.
void add_trimming_marks(Furniture& all, const Paper& paper) {
  constexpr double a = trimming_long, b = trimming_short;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    std::vector<Vec2> ring = {{0, 0}, {a, 0}, {a, b}, {b, b}, {b, a}, {0, a}};
    for (Vec2& p : ring) p = corner * Vec2(paper.width, paper.height) + p * (1.0 - 2.0 * corner);
    all.fills.push_back({{ring}});
  }
}

// Zones count from the lower right corner and fill the margin. They divide the sheet, not the frame.
void add_ansi_zones(Furniture& all, const Paper& paper, const AnsiSheet& sheet) {
  constexpr double usual_height = 0.24 * 25.4, part_of_margin = 0.55;
  const Rectangle in = drawing_area(paper), out{{0, 0}, {paper.width, paper.height}};
  check(out.holds(in), "the frame is on the paper");
  for (const int axis : {0, 1}) {
    const int other = 1 - axis, fields = ansi_fields(paper, sheet, axis);
    const double length = axis == 0 ? paper.width : paper.height;
    const auto point = [axis](double along, double across) {
      return axis == 0 ? Vec2(along, across) : Vec2(across, along);
    };
    for (const auto& [inner, outer] : {std::pair(in.min[other], out.min[other]), {in.max[other], out.max[other]}}) {
      const double height = std::min(usual_height, part_of_margin * std::abs(outer - inner));
      for (int i = 0; i < fields; ++i) {
        if (i > 0) all.medium.push_back(line(point(length * i / fields, inner), point(length * i / fields, outer)));
        const std::string text = name_of_ansi_field(i, fields, axis);
        const Vec2 centre = point(length * (i + 0.5) / fields, (inner + outer) / 2);
        all.texts.push_back({text, centre - Vec2(0, height / 2), height, 0, Align::middle, "grid-reference"});
      }
    }
  }
}

}  // namespace

Paper with_frame_margins(const Paper& paper) {
  if (paper.area) return paper;
  const Vec2 sides(std::max(paper.width, paper.height), std::min(paper.width, paper.height));
  if (sides.x < a5.x || sides.y < a5.y || ansi_sheet(paper) != nullptr) return paper;
  return {paper.width, paper.height, binding_margin, plain_margin};
}

Furniture frame(const Paper& paper, FrameKind kind, const std::optional<Rectangle>& title_block) {
  Furniture all;
  if (kind == FrameKind::none) return all;
  const Rectangle area = drawing_area(paper);
  all.wide.push_back(outline(area));
  const AnsiSheet* ansi = ansi_sheet(paper);
  if (kind == FrameKind::full && ansi != nullptr) add_ansi_zones(all, paper, *ansi);
  if (kind == FrameKind::plain || !has_iso_margins(paper)) return all;
  add_grid(all, paper);
  add_centring_marks(all, paper, title_block);
  add_trimming_marks(all, paper);
  const std::string name = paper_name(paper);
  const double inset = (grid_strip - letter_height) / 2;
  const Vec2 place = Vec2(area.max.x, area.min.y - grid_strip) + Vec2(-inset, inset);
  if (name.starts_with('A')) all.texts.push_back({name, place, letter_height, 0, Align::right, "grid-reference"});
  return all;
}

std::string zone_at(const Paper& paper, FrameKind kind, const Vec2& point) {
  const AnsiSheet* ansi = ansi_sheet(paper);
  if (kind != FrameKind::full || (ansi == nullptr && !has_iso_margins(paper))) return "";
  const Rectangle area = drawing_area(paper);
  std::string letter_and_number;
  for (const int axis : {1, 0}) {
    const double length = axis == 0 ? paper.width : paper.height;
    if (ansi != nullptr) {
      const int fields = ansi_fields(paper, *ansi, axis);
      if (fields == 0) return "";
      const int field = std::clamp(static_cast<int>(std::floor(point[axis] / length * fields)), 0, fields - 1);
      letter_and_number += name_of_ansi_field(field, fields, axis);
      continue;
    }
    const std::vector<double> ends = field_ends(length, area.min[axis], area.max[axis]);
    const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, point[axis]);
    letter_and_number += name_of_field(static_cast<std::size_t>(after - ends.begin()) - 1, ends.size() - 1, axis);
  }
  check(!letter_and_number.empty(), "a field has a name");
  return letter_and_number;
}

}  // namespace epura::sheet
