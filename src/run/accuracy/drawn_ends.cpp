// SPDX-License-Identifier: Apache-2.0
#include "accuracy/drawn_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "accuracy/judged_view.hpp"
#include "accuracy/seen_ink.hpp"
#include "drawing/limits.hpp"
#include "drawing/moved_contours.hpp"
#include "drawing/settled_pieces.hpp"

namespace epura::accuracy {

namespace {

using drawing::Piece;

// Ink goes on beyond an end if it is within this part of the way.
constexpr double beside = 1.0 / 8;

using SurfaceKind = surfaces::SurfaceKind;

// Surfaces that curve in two directions, and those of them that may hide their own contours: no sphere does.
constexpr std::array curved{SurfaceKind::sphere, SurfaceKind::torus, SurfaceKind::free_form};
constexpr std::array folded{SurfaceKind::torus, SurfaceKind::free_form};

// Whether a contour of a mesh edge lies inside recognised faces, one of them on such a surface.
bool is_on_surface(const world::World& world, const edges::FeatureEdge& edge, std::span<const SurfaceKind> kinds) {
  const world::Placed& placed = world.models[static_cast<std::size_t>(edge.model)];
  if (edge.kind != EdgeKind::contour || edge.mesh_edge < 0 || placed.part == nullptr) return false;
  if (!is_inside_part(placed, edge.mesh_edge)) return false;
  const std::span<const int> triangles = placed.mesh->whole().triangles_of(*edge_of_part(placed, edge.mesh_edge));
  return triangles.size() == 2 && std::ranges::any_of(triangles, [&](int t) {
           const int face = placed.part->face_of_triangle[static_cast<std::size_t>(t)];
           return face < 0 ||
                  std::ranges::find(kinds, placed.part->faces[static_cast<std::size_t>(face)].surface.kind) !=
                      kinds.end();
         });
}

/// Where a contour ends because another line hides the rest of it, it is off by its distance from that line: the true
/// one ends where both cross. Elsewhere, facets alone tell that it ends, as in cusps: there, the image of a contour is
/// a semicubical parabola (Koenderink & van Doorn, The shape of smooth objects and the way contours end, Perception 11,
/// 1982), both of whose branches facets may show, up to a corner that is on neither. So the last edge is in doubt, and
/// off by its distance from ink that is not; what is hidden beside it is off by its distance from any ink.
class DrawnEnds : JudgedView {
 public:
  DrawnEnds(const ViewToJudge& judged, const visibility::ResolvedView& lines, const drawing::SettledPieces& settled)
      : JudgedView(judged),
        lines_(lines),
        settled_(settled),
        visible_(visible_pieces()),
        ink_(lines_of([](const Piece& piece) {
          return PaperLine{piece.from, piece.to};
        })),
        in_mesh_(lines_of([&](const Piece& piece) {
          return PaperLine{place_in_mesh(piece, 0), place_in_mesh(piece, 1)};
        })),
        rims_(vertices_of_rims()),
        first_(first_pieces()) {
    const auto& edges = judged_.edges.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (const std::size_t end : {0, 1})
        if (edges[e].kind == EdgeKind::contour) starts_.push_back({edges[e].vertex[end], e, end});
    std::ranges::sort(starts_, {}, [](const Start& start) { return std::tuple(start.vertex, start.edge, start.end); });
  }

  [[nodiscard]] double off() const {
    const double size = judged_.view.extent * judged_.paper.scale;
    const double least_searched = guaranteed_part * size;
    double largest = 0;
    std::vector<End> doubtful;
    std::vector<char> is_doubtful(settled_.pieces.size(), 0);
    for (const End& end : last_ends()) {
      if (goes_on(end)) continue;
      if (const std::vector<std::size_t> hiding = lines_through(end); !hiding.empty()) {
        double distance = HUGE_VAL;
        for (const std::size_t other : hiding) distance = std::min(distance, distance_to(place(end), other));
        largest = std::max({largest, distance, off_bent(end, std::max(largest, least_searched))});
      } else if (is_on_surface(judged_.world, edge_of(end), folded)) {
        doubtful.push_back(end);
        for (const std::size_t piece : last_pieces(end)) is_doubtful[piece] = 1;
      }
    }
    const bool is_any_certain = std::ranges::any_of(visible_, [&](std::size_t i) { return is_doubtful[i] == 0; });
    if (!doubtful.empty()) largest = std::max(largest, least_searched);
    const auto is_certain = [&](std::size_t i) { return is_doubtful[visible_[i]] == 0; };
    for (const std::size_t i : visible_) {
      const Piece& piece = settled_.pieces[i];
      if (is_doubtful[i] != 0)
        largest =
            ink_.farthest_from({piece.from, piece.to}, largest, is_any_certain ? size : length_of(piece), is_certain);
    }
    for (const End& end : doubtful)
      for (const PaperLine& hidden : hidden_beyond(end))
        largest = ink_.farthest_from(hidden, largest, std::max(largest, glm::distance(hidden[0], hidden[1])),
                                     [](std::size_t) { return true; });
    return largest;
  }

 private:
  struct End {
    std::size_t piece, end;
  };
  /// Of a contour.
  struct Start {
    int vertex;
    std::size_t edge, end;
  };

  [[nodiscard]] const Piece& piece_of(const End& end) const { return settled_.pieces[end.piece]; }
  [[nodiscard]] const edges::FeatureEdge& edge_of(const End& end) const {
    return drawing::edge_of(lines_, piece_of(end));
  }
  [[nodiscard]] Vec2 place_in_mesh(const Piece& piece, std::size_t end) const {
    return drawing::in_mesh(lines_, judged_.paper, piece, end);
  }
  [[nodiscard]] Vec2 place(const End& end) const { return end.end == 0 ? piece_of(end).from : piece_of(end).to; }
  [[nodiscard]] Vec2 outwards(const End& end) const { return place(end) - place({end.piece, 1 - end.end}); }
  [[nodiscard]] double distance_to(const Vec2& at, std::size_t piece) const {
    return distance_to_segment(at, settled_.pieces[piece].from, settled_.pieces[piece].to);
  }
  [[nodiscard]] bool is_inner(const End& end) const {
    const double s = piece_of(end).s[end.end];
    return s > 0 && s < 1;
  }

  [[nodiscard]] std::vector<End> last_ends() const {
    std::vector<End> ends;
    for (const std::size_t piece : visible_)
      for (const std::size_t end : {0, 1})
        if (is_on_surface(judged_.world, edge_of({piece, end}), curved) && is_last({piece, end}))
          ends.push_back({piece, end});
    return ends;
  }

  [[nodiscard]] std::vector<std::size_t> visible_pieces() const {
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < settled_.pieces.size(); ++i)
      if (settled_.pieces[i].visible) visible.push_back(i);
    return visible;
  }

  template <class LineOf>
  [[nodiscard]] std::vector<PaperLine> lines_of(const LineOf& line_of) const {
    std::vector<PaperLine> lines;
    lines.reserve(visible_.size());
    for (const std::size_t i : visible_) lines.push_back(line_of(settled_.pieces[i]));
    return lines;
  }

  // By edge, and the number of pieces.
  [[nodiscard]] std::vector<std::size_t> first_pieces() const {
    std::vector<std::size_t> first(judged_.edges.edges.size() + 1, settled_.pieces.size());
    for (std::size_t i = settled_.pieces.size(); i-- > 0;) first[static_cast<std::size_t>(settled_.pieces[i].edge)] = i;
    for (std::size_t e = first.size() - 1; e-- > 0;) first[e] = std::min(first[e], first[e + 1]);
    return first;
  }

  [[nodiscard]] std::span<const Start> starts_at(int vertex) const {
    return {std::ranges::lower_bound(starts_, vertex, {}, &Start::vertex),
            std::ranges::upper_bound(starts_, vertex, {}, &Start::vertex)};
  }

  // The visible pieces of an edge up to one of its ends.
  [[nodiscard]] std::vector<std::size_t> last_pieces(const End& end) const {
    std::vector<std::size_t> pieces{end.piece};
    for (;;) {
      const Piece& last = settled_.pieces[pieces.back()];
      const std::size_t next = end.end == 0 ? pieces.back() + 1 : pieces.back() - 1;
      if (next >= settled_.pieces.size() || settled_.pieces[next].edge != last.edge || !settled_.pieces[next].visible ||
          settled_.pieces[next].s[end.end] != last.s[1 - end.end])
        return pieces;
      pieces.push_back(next);
    }
  }

  // Whether nothing visible of the same contour follows, and no rim of the face, no cusp of a known surface and no
  // settled end is there. Where a contour turns back in a vertex, none of its ends is settled.
  [[nodiscard]] bool is_last(const End& end) const {
    const Piece& piece = piece_of(end);
    const edges::FeatureEdge& edge = edge_of(end);
    const bool is_settled = settled_.settled[end.piece][end.end];
    if (is_inner(end)) {
      const std::size_t next = end.end == 1 ? end.piece + 1 : end.piece - 1;
      const bool is_followed = next < settled_.pieces.size() && settled_.pieces[next].edge == piece.edge &&
                               settled_.pieces[next].visible &&
                               settled_.pieces[next].s[1 - end.end] == piece.s[end.end];
      return !is_settled && !is_followed && !is_cusp(edge, piece.s[end.end]);
    }
    const int vertex = edge.vertex[end.end];
    if (rims_[static_cast<std::size_t>(vertex)] != 0) return false;
    bool turns_back = false;
    for (const Start& start : starts_at(vertex)) {
      const edges::FeatureEdge& other = judged_.edges.edges[start.edge];
      if (start.edge == static_cast<std::size_t>(piece.edge)) continue;
      if (is_hollow_from(other, start.end)) return false;
      const std::optional<std::size_t> first = visible_from(start);
      if (!first || other.by_chance) continue;
      if (glm::dot(outwards(end), outwards({*first, start.end})) <= 0) return false;
      turns_back = true;
    }
    return turns_back || !is_settled;
  }

  static bool is_cusp(const edges::FeatureEdge& edge, double s) {
    const double cusp = edge.hollow_part()[edge.hollow > 0 ? 1 : 0];
    return edge.hollow != 0 && std::abs(s - cusp) <= drawing::rounding_part;
  }

  static bool is_hollow_from(const edges::FeatureEdge& edge, std::size_t end) {
    return edge.hollow != 0 && edge.hollow_part()[end] == static_cast<double>(end);
  }

  // The piece at the beginning of another edge, if that is visible.
  [[nodiscard]] std::optional<std::size_t> visible_from(const Start& start) const {
    for (std::size_t i = first_[start.edge]; i < first_[start.edge + 1]; ++i)
      if (settled_.pieces[i].visible && settled_.pieces[i].s[start.end] == static_cast<double>(start.end)) return i;
    return std::nullopt;
  }

  // Whether certain ink of another edge runs on beyond an end for as long as the piece is: contours of facets take
  // detours.
  [[nodiscard]] bool goes_on(const End& end) const {
    const Vec2 way = outwards(end);
    const double within = beside * glm::length(way) + drawing::on_line_mm;
    return std::ranges::all_of(std::array{0.25, 0.5, 1.0}, [&](double part) {
      return ink_.to_nearest(place(end) + part * way, 2 * within, [&](std::size_t i) {
        return settled_.pieces[visible_[i]].edge != piece_of(end).edge;
      }) <= within;
    });
  }

  // The visible pieces of lines that pass an end in the mesh, and do not begin in a vertex of its edge.
  [[nodiscard]] std::vector<std::size_t> lines_through(const End& end) const {
    std::vector<std::size_t> through;
    const std::array<int, 2>& own = edge_of(end).vertex;
    for (const std::size_t i : in_mesh_.lines_at(place_in_mesh(piece_of(end), end.end), settled_.meeting)) {
      const std::array<int, 2>& other = edge_of({visible_[i], 0}).vertex;
      if (std::ranges::find_first_of(own, other) == own.end()) through.push_back(visible_[i]);
    }
    return through;
  }

  // Where the last piece was bent to meet the line that hides its rest, the true one goes on in its own direction up to
  // that line: how far it is from other ink, and what it would be from any, if that is more than `known`. Else 0.
  [[nodiscard]] double off_bent(const End& end, double known) const {
    const Piece& piece = piece_of(end);
    const auto straight_on = [&](std::size_t k) {
      return drawing::position_on_paper(judged_.view, judged_.paper, edge_of(end), piece.s[k]);
    };
    const PaperLine straight{straight_on(0), straight_on(1)};
    const double bent = distance_to_segment(place(end), straight[0], straight[1]);
    if (!(bent > known)) return 0;
    const double off = ink_.farthest_from({piece.from, piece.to}, known, bent,
                                          [&](std::size_t i) { return visible_[i] != end.piece; });
    return ink_.farthest_from(straight, off, bent, [](std::size_t) { return true; });
  }

  // What facets hide of contours from an end on, as it would be drawn, up to the ends of their edges.
  [[nodiscard]] std::vector<PaperLine> hidden_beyond(const End& end) const {
    const auto place_of_end = [&](const edges::FeatureEdge& edge, std::size_t k) {
      return drawing::position_on_paper(judged_.view, judged_.paper, edge, static_cast<double>(k));
    };
    if (is_inner(end)) return {{place(end), place_of_end(edge_of(end), end.end)}};
    std::vector<PaperLine> hidden;
    for (const Start& start : starts_at(edge_of(end).vertex[end.end])) {
      const edges::FeatureEdge& edge = judged_.edges.edges[start.edge];
      if (start.edge != static_cast<std::size_t>(piece_of(end).edge) && !edge.by_chance)
        hidden.push_back({place_of_end(edge, start.end), place_of_end(edge, 1 - start.end)});
    }
    return hidden;
  }

  const visibility::ResolvedView& lines_;
  const drawing::SettledPieces& settled_;
  std::vector<std::size_t> visible_;
  SeenInk ink_, in_mesh_;  ///< of the visible pieces
  std::vector<char> rims_;
  std::vector<std::size_t> first_;
  std::vector<Start> starts_;  ///< by vertex
};

}  // namespace

double longest_drawn(const ViewToJudge& judged) {
  double longest = 0;
  for (const edges::FeatureEdge& edge : judged.edges.edges)
    if (is_on_surface(judged.world, edge, curved))
      longest = std::max(longest, glm::distance(drawing::position_on_paper(judged.view, judged.paper, edge, 0),
                                                drawing::position_on_paper(judged.view, judged.paper, edge, 1)));
  return longest;
}

double off_at_drawn_ends(const ViewToJudge& judged, const Progress& progress) {
  const auto& edges = judged.edges.edges;
  if (std::ranges::none_of(edges, [&](const auto& edge) { return is_on_surface(judged.world, edge, curved); }))
    return 0;
  const visibility::ResolvedView lines{judged.world, judged.view, judged.edges, judged.hidden};
  const drawing::SettledPieces settled = drawing::settled_pieces(lines, judged.paper, judged.options, progress);
  return DrawnEnds(judged, lines, settled).off();
}

}  // namespace epura::accuracy
