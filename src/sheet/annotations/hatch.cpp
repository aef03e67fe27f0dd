// SPDX-License-Identifier: Apache-2.0
#include "annotations/hatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"
#include "mesh/even_odd.hpp"
#include "sheet/dash.hpp"

namespace epura::sheet {

namespace {

using Ring = std::vector<Vec2>;
using Line = std::array<Vec2, 2>;

constexpr double min_spacing = 1, max_spacing = 4;
constexpr double spacings_a_side = 16;  // along the side of a square
constexpr double thin_width = 1;
constexpr double nearest = 0.7;               // parts closer than this touch
constexpr double shortest_hatch_line = 1e-3;  // mm; shorter hatching lines are omitted
constexpr double faces_meet = 1e-9;           // mm; rounding between faces that meet
constexpr double alike_degrees = 10;          // a hatching line within this angle of an outline looks like one
constexpr double max_alike = 0.3 + 1e-6;      // part of the outlines that may be so, or across; never k/n of n sides
constexpr double min_ratio = 1.4;             // of two distinguishable spacings

/// In order of preference; the factor applies to the spacing. If the first few do not distinguish a part from its
/// neighbours by angle, the spacing must.
struct Variant {
  double angle, factor;
};
constexpr int usual_variants = 2;
constexpr std::array<Variant, 14> variants = {{{45, 1},
                                               {135, 1},
                                               {45, 1.6},
                                               {135, 1.6},
                                               {30, 1},
                                               {60, 1},
                                               {120, 1},
                                               {150, 1},
                                               {30, 1.6},
                                               {60, 1.6},
                                               {120, 1.6},
                                               {150, 1.6},
                                               {45, 2.2},
                                               {135, 2.2}}};

template <class Visit>
void visit_sides(const std::vector<Ring>& rings, const Visit& visit) {
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
}

// The parts of the line n . p = offset inside the rings. A corner on the line counts as before it, for both its sides.
void add_hatch_line(const std::vector<Ring>& rings, const Vec2& along, double offset, std::vector<Line>& lines) {
  const Vec2 n(-along.y, along.x);
  std::vector<double> crossings;
  visit_sides(rings, [&](const Vec2& a, const Vec2& b) {
    const double before = glm::dot(n, a) - offset, behind = glm::dot(n, b) - offset;
    if ((before <= 0) == (behind <= 0)) return;
    crossings.push_back(glm::dot(along, a) + before / (before - behind) * glm::dot(along, b - a));
  });
  check(crossings.size() % 2 == 0, "a line leaves a face as often as it enters it");
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t begin = 0, end = 1; end < crossings.size(); begin = end + 1, end += 2) {
    // Faces on both sides of a step meet without a line between them.
    while (end + 2 < crossings.size() && crossings[end + 1] - crossings[end] < faces_meet) end += 2;
    if (crossings[end] - crossings[begin] > shortest_hatch_line)
      lines.push_back({crossings[begin] * along + offset * n, crossings[end] * along + offset * n});
  }
}

Vec2 direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {portable_cos(angle), portable_sin(angle)};
}

// What a line on paper has in a triangle: places along it.
std::optional<std::array<double, 2>> part_in(const drawing::PaperTriangle& triangle, const Vec2& along, double offset) {
  const Vec2 n(-along.y, along.x);
  double from = HUGE_VAL, to = -HUGE_VAL;
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    const Vec2 &a = triangle[i], &b = triangle[(i + 1) % triangle.size()];
    const double before = glm::dot(n, a) - offset, behind = glm::dot(n, b) - offset;
    if ((before <= 0) == (behind <= 0)) continue;
    const double place = glm::dot(along, a) + before / (before - behind) * glm::dot(along, b - a);
    from = std::min(from, place);
    to = std::max(to, place);
  }
  return from < to ? std::optional(std::array{from, to}) : std::nullopt;
}

// The rest of lines of one direction outside all of `covers`.
std::vector<Line> uncovered(const std::vector<Line>& lines, double degrees,
                            const std::vector<drawing::PaperTriangle>& covers) {
  if (covers.empty()) return lines;
  const Vec2 along = direction(degrees), n(-along.y, along.x);
  std::vector<Line> rest;
  for (const Line& line : lines) {
    const double offset = glm::dot(n, line[0]), end = glm::dot(along, line[1]);
    std::vector<std::array<double, 2>> covered;
    for (const drawing::PaperTriangle& triangle : covers)
      if (const auto part = part_in(triangle, along, offset)) covered.push_back(*part);
    std::sort(covered.begin(), covered.end());
    double at = glm::dot(along, line[0]);
    const auto keep_until = [&](double place) {
      if (std::min(place, end) - at > shortest_hatch_line)
        rest.push_back({at * along + offset * n, std::min(place, end) * along + offset * n});
    };
    for (const auto& [from, to] : covered) {
      check(from <= to, "a covered part goes forwards");
      keep_until(from);
      at = std::max(at, to);
    }
    keep_until(end);
  }
  return rest;
}

std::vector<HatchLines> hatch_families(HatchPattern pattern, const Hatching& hatching) {
  constexpr double pair = 0.3;  // distance between the lines of a pair, as a part of the spacing
  const double angle = hatching.angle, spacing = hatching.spacing;
  switch (pattern) {
    case HatchPattern::steel:
      return {{angle, spacing, 0}, {angle, spacing, pair * spacing}};
    case HatchPattern::bronze:
      return {{angle, 2 * spacing, 0}, {angle, 2 * spacing, spacing, true}};
    case HatchPattern::nonmetal:
      return {{angle, spacing, 0}, {angle + 90, spacing, 0}};
    default:
      return {{angle, spacing, 0}};
  }
}

// The lines of all faces of a part in a view belong to one family, counted from the origin of the sheet.
std::vector<Line> lines_of(const drawing::CutFace& face, const HatchLines& family, const Progress& progress) {
  const Vec2 along = direction(family.angle), n(-along.y, along.x);
  double min = HUGE_VAL, max = -HUGE_VAL;
  visit_sides(face.rings, [&](const Vec2& a, const Vec2&) {
    min = std::min(min, glm::dot(n, a));
    max = std::max(max, glm::dot(n, a));
  });
  check(family.spacing > 0, "lines of a hatching have a distance");
  const double first = std::ceil((min - family.start) / family.spacing);
  const double count = std::floor((max - family.start) / family.spacing) - first + 1;
  std::vector<std::vector<Line>> found(count > 0 ? static_cast<std::size_t>(count) : 0);
  parallel_for(found.size(), 16, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      add_hatch_line(face.rings, along, (first + static_cast<double>(i)) * family.spacing + family.start, found[i]);
  });
  std::vector<Line> lines;
  for (const std::vector<Line>& part : found) lines.insert(lines.end(), part.begin(), part.end());
  return lines;
}

mesh::Outlines outlines_in(const drawing::CutFace& face) {
  mesh::Outlines outlines;
  for (const Ring& ring : face.rings) {
    const int first = static_cast<int>(outlines.places.size()), count = static_cast<int>(ring.size());
    outlines.places.insert(outlines.places.end(), ring.begin(), ring.end());
    for (int i = 0; i < count; ++i) outlines.segments.push_back({first + i, first + (i + 1) % count});
  }
  return outlines;
}

double area_within(const drawing::CutFace& face) {
  mesh::Outlines outlines = outlines_in(face);
  double area = 0;
  for (const auto& [i, j, k] : mesh::fill_even_odd(outlines)) {
    const Vec2 ab = outlines.places[j] - outlines.places[i], ac = outlines.places[k] - outlines.places[i];
    area += cross(ab, ac) / 2;
  }
  return area;
}

double outline_length_of(const drawing::CutFace& face) {
  double length = 0;
  visit_sides(face.rings, [&](const Vec2& a, const Vec2& b) { length += glm::distance(a, b); });
  return length;
}

// A strip of width w and length l >> w has the area w l and an outline of length 2 l.
bool is_thin(const drawing::CutFace& face) { return 2 * area_within(face) < thin_width * outline_length_of(face); }

struct Frame {
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};

  void add(const Vec2& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  [[nodiscard]] bool meets(const Vec2& from, const Vec2& to) const {
    return from.x <= max.x + nearest && to.x >= min.x - nearest && from.y <= max.y + nearest && to.y >= min.y - nearest;
  }
};

/// The common data of the cut faces of one part.
struct Part {
  int model, body;
  std::vector<std::pair<int, const drawing::CutFace*>> faces;  ///< with the numbers of their drawings
  double largest = 0;                                          ///< mm2
};

Frame frame_of(const drawing::CutFace& face) {
  Frame frame;
  visit_sides(face.rings, [&](const Vec2& a, const Vec2&) { frame.add(a); });
  return frame;
}

std::vector<Line> sides_near(const drawing::CutFace& face, const Frame& frame) {
  std::vector<Line> near;
  visit_sides(face.rings, [&](const Vec2& a, const Vec2& b) {
    if (frame.meets(glm::min(a, b), glm::max(a, b))) near.push_back({a, b});
  });
  return near;
}

// Closer than `nearest`, or overlapping. (Outlines that only cross come close at a corner, or each has corners inside
// the other.)
bool touch(const drawing::CutFace& one, const drawing::CutFace& two) {
  const Frame of_one = frame_of(one), of_two = frame_of(two);
  if (!of_one.meets(of_two.min, of_two.max)) return false;
  const std::vector<Line> first = sides_near(one, of_two), second = sides_near(two, of_one);
  for (const Line& a : first)
    for (const Line& b : second)
      if (distance_to_segment(a[0], b[0], b[1]) < nearest || distance_to_segment(b[0], a[0], a[1]) < nearest)
        return true;
  return mesh::is_inside(outlines_in(one), two.rings[0][0]) || mesh::is_inside(outlines_in(two), one.rings[0][0]);
}

bool touch(const Part& one, const Part& two) {
  for (const auto& [drawing, face] : one.faces)
    for (const auto& [other_drawing, other_face] : two.faces)
      if (drawing == other_drawing && touch(*face, *other_face)) return true;
  return false;
}

// Identifies parts by their position on the sheet alone, whatever their numbers: the bounding box of their faces in the
// first drawing, in thousandths of a millimetre because equal positions may differ by rounding, and then all corners.
using PlaceOnSheet = std::pair<std::array<double, 5>, std::vector<std::array<double, 2>>>;

PlaceOnSheet place_of(const Part& part) {
  constexpr double step = 1e-3;
  const int first = part.faces.front().first;
  Frame frame;
  PlaceOnSheet place;
  for (const auto& [drawing, face] : part.faces)
    visit_sides(face->rings, [&, is_first = drawing == first](const Vec2& a, const Vec2&) {
      if (is_first) frame.add(a);
      place.second.push_back({a.x, a.y});
    });
  const auto steps = [&](double x) { return std::nearbyint(x / step); };
  place.first = {static_cast<double>(first), steps(frame.min.x), steps(frame.min.y), steps(frame.max.x),
                 steps(frame.max.y)};
  std::sort(place.second.begin(), place.second.end());
  return place;
}

// The order is independent of how files number their bodies and faces.
std::vector<Part> parts_of(std::span<const drawing::ViewDrawing* const> drawings) {
  std::map<std::pair<int, int>, Part> parts;
  for (std::size_t d = 0; d < drawings.size(); ++d)
    for (const drawing::CutFace& face : drawings[d]->cuts.faces) {
      Part& part = parts.try_emplace({face.model, face.body}, Part{face.model, face.body, {}}).first->second;
      part.faces.emplace_back(static_cast<int>(d), &face);
      part.largest = std::max(part.largest, area_within(face));
    }
  std::vector<std::pair<PlaceOnSheet, Part>> placed;
  for (auto& [key, part] : parts) placed.emplace_back(place_of(part), std::move(part));
  std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Part> list;
  for (auto& [place, part] : placed) list.push_back(std::move(part));
  return list;
}

// The fraction of the outlines that runs within `alike_degrees` of an angle.
double share_along(const Part& part, double angle) {
  const Vec2 along = direction(angle);
  const double sine = portable_sin(alike_degrees * std::numbers::pi / 180);
  double alike = 0, all = 0;
  for (const auto& [drawing, face] : part.faces)
    visit_sides(face->rings, [&](const Vec2& a, const Vec2& b) {
      const Vec2 side = b - a;
      const double length = glm::length(side);
      all += length;
      if (std::abs(cross(along, side)) < sine * length) alike += length;
    });
  return all > 0 ? alike / all : 0;
}

double spacing_of(const Part& part) {
  const double spacing = std::clamp(std::sqrt(part.largest) / spacings_a_side, min_spacing, max_spacing);
  // Rounded so that faces of similar size look alike. The limits avoid whole millimetres, where rounding would decide.
  return std::round(spacing * 4 - 1e-6) / 4;
}

// Patterns with more lines than the general one have wider spacings.
double pattern_factor(const HatchStyle& wish) {
  const HatchPattern pattern = wish.pattern.value_or(HatchPattern::general);
  return pattern == HatchPattern::steel || pattern == HatchPattern::nonmetal ? 1.5 : 1;
}

Hatching hatching_of(const Part& part, const HatchStyle& wish, const std::vector<Hatching>& neighbours) {
  const double spacing = spacing_of(part) * pattern_factor(wish);
  const auto angle_of = [&](const Variant& variant) { return wish.angle.value_or(variant.angle); };
  const auto spacing_with = [&](const Variant& variant) { return wish.pitch.value_or(variant.factor * spacing); };
  // Hatching lines perpendicular to an outline look like a separate pattern.
  const auto suits = [&](const Variant& variant) {
    return wish.angle || share_along(part, variant.angle) + share_along(part, variant.angle + 90) <= max_alike;
  };
  const auto differs_by_angle = [&](const Variant& variant) {
    return std::none_of(neighbours.begin(), neighbours.end(),
                        [&](const Hatching& there) { return there.angle == angle_of(variant); });
  };
  const auto differs = [&](const Variant& variant) {
    return std::none_of(neighbours.begin(), neighbours.end(), [&](const Hatching& there) {
      const double ratio = spacing_with(variant) / there.spacing;
      return there.angle == angle_of(variant) && ratio < min_ratio && ratio * min_ratio > 1;
    });
  };
  const auto usual = variants.begin() + usual_variants;
  auto best = std::find_if(variants.begin(), usual, [&](const auto& v) { return suits(v) && differs_by_angle(v); });
  if (best == usual)
    best = std::find_if(variants.begin(), variants.end(), [&](const auto& v) { return suits(v) && differs(v); });
  if (best == variants.end()) best = std::find_if(variants.begin(), variants.end(), differs);
  if (best == variants.end()) best = variants.begin();
  return {part.model, part.body, angle_of(*best), spacing_with(*best)};
}

bool are_same(const std::vector<Line>& one, const std::vector<Line>& two) {
  return std::equal(one.begin(), one.end(), two.begin(), two.end(), [](const Line& a, const Line& b) {
    return glm::distance(a[0], b[0]) < faces_meet && glm::distance(a[1], b[1]) < faces_meet;
  });
}

// What keeps hatching lines from a view.
struct HatchCovers {
  const std::vector<drawing::PaperTriangle>& before;  ///< hides cut faces
  std::vector<TurnedBox> texts;                       ///< apart from each other, with some room around
  std::vector<drawing::PaperTriangle> all;
};

// A face whose lines are drawn.
struct FaceToHatch {
  const HatchCovers& covers;
  const drawing::CutFace& face;
  double width;
  const Progress& progress;
};

Ring corners_of(const TurnedBox& box) {
  const Vec2 along = box.half.x * box.along, up = box.half.y * Vec2(-box.along.y, box.along.x);
  return {box.centre - along - up, box.centre + along - up, box.centre + along + up, box.centre - along + up};
}

// The box around two that lie in one direction.
TurnedBox united(const TurnedBox& one, const TurnedBox& other) {
  const Vec2 up(-one.along.y, one.along.x);
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (const TurnedBox* box : {&one, &other})
    for (const Vec2& p : corners_of(*box)) {
      const Vec2 at(glm::dot(p, one.along), glm::dot(p, up));
      min = glm::min(min, at);
      max = glm::max(max, at);
    }
  const Vec2 middle = (min + max) / 2.0;
  return {middle.x * one.along + middle.y * up, one.along, (max - min) / 2.0};
}

// The lines of a note have one box.
std::vector<TurnedBox> united_texts(const std::vector<TurnedBox>& texts) {
  constexpr double same_direction = 1e-9;
  std::vector<TurnedBox> apart;
  for (TurnedBox text : texts) {
    const auto is_on = [&text](const TurnedBox& other) {
      return std::abs(cross(text.along, other.along)) <= same_direction && overlap(text, other);
    };
    for (auto on = std::find_if(apart.begin(), apart.end(), is_on); on != apart.end();
         on = std::find_if(apart.begin(), apart.end(), is_on)) {
      text = united(text, *on);
      apart.erase(on);
    }
    apart.push_back(text);
  }
  return apart;
}

HatchCovers covers_of(const HatchedView& view) {
  constexpr double room = 0.7;  // mm
  HatchCovers covers{view.drawing.cuts.before, {}, view.drawing.cuts.before};
  for (TurnedBox text : view.texts) {
    text.half += Vec2(room);
    const Ring corners = corners_of(text);
    covers.all.push_back({corners[0], corners[1], corners[2]});
    covers.all.push_back({corners[0], corners[2], corners[3]});
    covers.texts.push_back(text);
  }
  covers.texts = united_texts(covers.texts);
  return covers;
}

// The texts inside a face, as outlines of islands; nothing if one is only partly inside, or on another one.
std::optional<std::vector<Ring>> islands_in(const drawing::CutFace& face, const std::vector<TurnedBox>& texts) {
  std::vector<Ring> islands;
  std::vector<const TurnedBox*> inside;
  const mesh::Outlines outlines = outlines_in(face);
  for (const TurnedBox& text : texts) {
    bool crosses = false;
    visit_sides(face.rings, [&](const Vec2& a, const Vec2& b) { crosses = crosses || overlap(text, line_box(a, b)); });
    if (crosses) return std::nullopt;
    if (!mesh::is_inside(outlines, text.centre)) continue;
    if (std::any_of(inside.begin(), inside.end(), [&](const TurnedBox* other) { return overlap(text, *other); }))
      return std::nullopt;
    inside.push_back(&text);
    islands.push_back(corners_of(text));
  }
  return islands;
}

// A face of which something is hidden is lines only: as a whole, it would be hatched everywhere. Texts are islands.
void draw_hatch_lines(Layer& layer, HatchedFace hatched, const FaceToHatch& what) {
  const auto islands = islands_in(what.face, what.covers.texts);
  bool is_whole = islands.has_value();
  hatched.strokes.begin = layer.strokes.size();
  for (const HatchLines& family : hatched.lines) {
    const std::vector<Line> lines = lines_of(what.face, family, what.progress);
    std::vector<Line> seen = uncovered(lines, family.angle, what.covers.before);
    check(seen.size() >= lines.size() || !what.covers.before.empty(), "nothing hides lines without covers");
    is_whole = is_whole && are_same(seen, lines);
    if (!what.covers.texts.empty()) seen = uncovered(lines, family.angle, what.covers.all);
    for (const Line& line : seen) {
      Stroke& stroke = layer.strokes.emplace_back(Stroke{{line[0], line[1]}});
      if (family.is_dashed) stroke.dashes = fit_open(glm::distance(line[0], line[1]), what.width);
    }
  }
  hatched.strokes.end = layer.strokes.size();
  if (!is_whole || hatched.strokes.begin == hatched.strokes.end) return;
  hatched.face.rings.insert(hatched.face.rings.end(), islands->begin(), islands->end());
  layer.hatched.push_back(std::move(hatched));
}

}  // namespace

std::vector<Hatching> choose_hatching(std::span<const drawing::ViewDrawing* const> drawings, const HatchRequest& wish,
                                      const Progress& progress) {
  const std::vector<Part> parts = parts_of(drawings);
  std::vector<HatchStyle> wishes;
  for (const Part& part : parts)
    wishes.push_back(wish ? wish(static_cast<std::size_t>(part.faces.front().first), part.model, part.body)
                          : HatchStyle());
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(), [&](std::size_t p) { return wishes[p].angle || wishes[p].pitch; });
  std::vector<Hatching> chosen;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<Hatching> neighbours;
    progress.expect_time();
    for (std::size_t q = 0; q < p; ++q)
      if (touch(parts[order[p]], parts[order[q]])) neighbours.push_back(chosen[q]);
    chosen.push_back(hatching_of(parts[order[p]], wishes[order[p]], neighbours));
    check(chosen.back().spacing > 0, "hatching lines have a distance");
  }
  std::sort(chosen.begin(), chosen.end(), [](const Hatching& a, const Hatching& b) {
    return std::pair(a.model, a.body) < std::pair(b.model, b.body);
  });
  return chosen;
}

Layer hatch_layer(const HatchedView& view, std::span<const Hatching> hatching, const LineWidths& widths,
                  const Progress& progress) {
  Layer layer = empty_layer(view.drawing.name, scene::SheetLine::hatch, widths);
  const HatchCovers covers = covers_of(view);
  for (const drawing::CutFace& face : view.drawing.cuts.faces) {
    const auto found = std::find_if(hatching.begin(), hatching.end(),
                                    [&](const Hatching& h) { return h.model == face.model && h.body == face.body; });
    check(found != hatching.end(), "every part that is cut has a hatching");
    progress.expect_time();
    progress.advance(1);
    const HatchPattern pattern = view.styles(face.model, face.body).hatch.pattern.value_or(HatchPattern::general);
    if (pattern == HatchPattern::none) continue;
    if (pattern == HatchPattern::solid || is_thin(face)) {
      layer.fills.push_back({face.rings});
      continue;
    }
    draw_hatch_lines(layer, {{face.rings}, pattern, found->angle, found->spacing, hatch_families(pattern, *found), {}},
                     {covers, face, widths.narrow, progress});
  }
  return layer;
}

}  // namespace epura::sheet
