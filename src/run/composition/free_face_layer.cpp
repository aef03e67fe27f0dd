// SPDX-License-Identifier: Apache-2.0
#include "composition/free_face_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

namespace {

constexpr double spacing = 1.2;      // mm, closer than cut faces of that size have it
constexpr double text_height = 2.5;  // mm. ISO 3098
constexpr Colour red{200, 0, 0};

/// A corner of a facet in a frame in which lines of the hatching are level.
struct Corner {
  double along, across, depth;
};

struct Facet {
  std::array<Corner, 3> corners;
  int face;  ///< that is to be hatched; -1: another one
};

/// Where a facet covers a line of the hatching.
struct Cover {
  double from, to;
  double depth_from, depth_to;  ///< growing towards the viewer
  int face;

  [[nodiscard]] double depth(double at) const {
    return to > from ? depth_from + (depth_to - depth_from) * (at - from) / (to - from) : depth_from;
  }
};

/// A piece of a line on a face.
struct Piece {
  double from, to;
  int face;
};

const double half = std::sqrt(0.5);

Vec2 on_page(double along, double across) { return {half * (along - across), half * (along + across)}; }

std::vector<Facet> facets_of(const drawing::ViewDrawing& drawing, const world::World& world,
                             const std::vector<int>& faces) {
  std::vector<Facet> facets;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    const std::vector<int> of_triangles = world.number_in_scene(static_cast<int>(model)) == 0
                                              ? world::faces_of_triangles(world.models[model])
                                              : std::vector<int>();
    const auto first = static_cast<std::size_t>(world.first_triangle[model]);
    const std::size_t end = model + 1 < world.models.size() ? static_cast<std::size_t>(world.first_triangle[model + 1])
                                                            : world.triangles.size();
    for (std::size_t t = first; t < end; ++t) {
      Facet facet{{}, -1};
      bool is_before_viewer = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec4 p = drawing.world_to_page * Vec4(world.points[static_cast<std::size_t>(world.triangles[t][i])], 1);
        is_before_viewer = is_before_viewer && p.w > 0;
        facet.corners[i] = {half * (p.x + p.y) / p.w, half * (p.y - p.x) / p.w, p.z / p.w};
      }
      if (!is_before_viewer) continue;
      if (t - first < of_triangles.size() &&
          std::find(faces.begin(), faces.end(), of_triangles[t - first]) != faces.end())
        facet.face = of_triangles[t - first];
      facets.push_back(facet);
    }
  }
  return facets;
}

// Nothing of a facet that only touches the line.
void add_cover(std::vector<Cover>& covers, const Facet& facet, double across) {
  std::array<Corner, 2> ends{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &a = facet.corners[i], &b = facet.corners[(i + 1) % 3];
    if ((a.across > across) == (b.across > across)) continue;
    const double t = (across - a.across) / (b.across - a.across);
    ends[count++] = {a.along + t * (b.along - a.along), across, a.depth + t * (b.depth - a.depth)};
  }
  check(count == 0 || count == 2, "a line enters a triangle and leaves it");
  if (count == 0) return;
  if (ends[1].along < ends[0].along) std::swap(ends[0], ends[1]);
  if (ends[1].along > ends[0].along)
    covers.push_back({ends[0].along, ends[1].along, ends[0].depth, ends[1].depth, facet.face});
}

// What is seen of the faces to be hatched, from end to end of facets: between two ends, the nearest facet is one.
std::vector<Piece> seen_pieces(std::vector<Cover> covers) {
  std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return a.from < b.from; });
  std::vector<double> ends;
  for (const Cover& one : covers) ends.insert(ends.end(), {one.from, one.to});
  std::sort(ends.begin(), ends.end());
  std::vector<Piece> pieces;
  std::vector<Cover> open;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    while (next < covers.size() && covers[next].from <= ends[i]) open.push_back(covers[next++]);
    std::erase_if(open, [&](const Cover& one) { return one.to <= ends[i]; });
    const double middle = (ends[i] + ends[i + 1]) / 2;
    const auto nearest = std::max_element(
        open.begin(), open.end(), [&](const Cover& a, const Cover& b) { return a.depth(middle) < b.depth(middle); });
    if (nearest == open.end() || nearest->face < 0 || !(ends[i + 1] > ends[i])) continue;
    if (!pieces.empty() && pieces.back().face == nearest->face && pieces.back().to == ends[i])
      pieces.back().to = ends[i + 1];
    else
      pieces.push_back({ends[i], ends[i + 1], nearest->face});
  }
  return pieces;
}

/// The longest piece on a face.
struct Longest {
  Piece piece;
  double across;
};

}  // namespace

sheet::Layer free_face_layer(const drawing::ViewDrawing& drawing, const world::World& world,
                             const HatchedFaces& hatched, double line_width) {
  sheet::Layer layer{drawing.name + "/free", {"free", line_width, {}, red}, {}};
  if (drawing.shown.detail || drawing.shown.breaks.any()) return layer;
  const std::vector<Facet> facets = facets_of(drawing, world, hatched.faces);
  std::map<int, std::vector<Cover>> lines;  // by number
  const auto line_after = [](double across) { return static_cast<int>(std::ceil(across / spacing)); };
  const auto span_of = [](const Facet& facet) {
    const auto [low, high] = std::minmax_element(facet.corners.begin(), facet.corners.end(),
                                                 [](const Corner& a, const Corner& b) { return a.across < b.across; });
    return std::array{low->across, high->across};
  };
  for (const bool is_hatched : {true, false})
    for (const Facet& facet : facets) {
      if ((facet.face >= 0) != is_hatched) continue;
      const auto [low, high] = span_of(facet);
      for (int line = line_after(low); line * spacing < high; ++line)
        if (is_hatched || lines.contains(line)) add_cover(lines[line], facet, line * spacing);
    }
  std::map<int, Longest> longest;
  for (const auto& [line, covers] : lines)
    for (const Piece& piece : seen_pieces(covers)) {
      layer.strokes.push_back({{on_page(piece.from, line * spacing), on_page(piece.to, line * spacing)}});
      const auto [known, is_new] = longest.try_emplace(piece.face, Longest{piece, line * spacing});
      if (!is_new && piece.to - piece.from > known->second.piece.to - known->second.piece.from)
        known->second = {piece, line * spacing};
    }
  for (const auto& [face, one] : longest)
    layer.texts.push_back({std::to_string(hatched.numbers[static_cast<std::size_t>(face)]),
                           on_page((one.piece.from + one.piece.to) / 2, one.across) - Vec2(0, text_height / 2),
                           text_height, 0, sheet::Align::middle, "free"});
  return layer;
}

void hatch_free_faces(std::span<FinishedSheet> sheets, const scene::SceneDescription& scene, const ShownWorlds& worlds,
                      const HatchedFaces& hatched) {
  for (FinishedSheet& sheet : sheets)
    for (const drawing::ViewDrawing& drawing : sheet.drawings) {
      const auto view = std::find_if(scene.views.begin(), scene.views.end(),
                                     [&drawing](const auto& one) { return one.name.value == drawing.name; });
      if (view == scene.views.end()) continue;
      sheet::Layer layer =
          free_face_layer(drawing, worlds.seen_in(*view), hatched, sheet::line_widths(sheet.paper).narrow);
      if (!layer.strokes.empty()) sheet.sheet.layers.insert(sheet.sheet.layers.begin(), std::move(layer));
    }
}

}  // namespace epura::pipeline
