// SPDX-License-Identifier: Apache-2.0
#include "drawing/t_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/limits.hpp"
#include "drawing/make_drawing.hpp"
#include "drawing/moved_contours.hpp"
#include "search/bounds_tree.hpp"

namespace epura::drawing {

namespace {

/// Which end of an edge comes next along a contour.
struct Way {
  int edge;
  std::size_t ahead;  ///< 0 or 1
};

/// The contours of all models as they are drawn, from vertex to vertex.
class ContourWays {
 public:
  ContourWays(const visibility::ResolvedView& lines, const std::vector<Piece>& pieces) : lines_(lines) {
    const edges::FeatureEdges& drawn = lines.drawn;
    for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
      if (drawn.edges[e].kind != EdgeKind::contour) continue;
      for (const std::size_t end : {0, 1})
        ends_.push_back({drawn.edges[e].vertex[end], {static_cast<int>(e), 1 - end}});
    }
    std::sort(ends_.begin(), ends_.end(), [](const Start& a, const Start& b) {
      return std::pair(a.vertex, a.way.edge) < std::pair(b.vertex, b.way.edge);
    });
    first_.assign(drawn.edges.size() + 1, pieces.size());
    for (std::size_t i = pieces.size(); i-- > 0;) first_[static_cast<std::size_t>(pieces[i].edge)] = i;
    for (std::size_t e = drawn.edges.size(); e-- > 0;) first_[e] = std::min(first_[e], first_[e + 1]);
  }

  /// Continues a way beyond the end of its edge; nothing where the contour ends or branches.
  [[nodiscard]] std::optional<Way> next(const Way& way) const {
    const int vertex = lines_.drawn.edges[way.edge].vertex[way.ahead];
    const auto here = std::equal_range(ends_.begin(), ends_.end(), Start{vertex, {}},
                                       [](const Start& a, const Start& b) { return a.vertex < b.vertex; });
    if (here.second - here.first != 2) return std::nullopt;
    return here.first->way.edge == way.edge ? (here.first + 1)->way : here.first->way;
  }

  /// Returns the first piece of an edge along a way, or the number of pieces if it has none.
  [[nodiscard]] std::size_t begin(const Way& way) const {
    const std::size_t first = first_[static_cast<std::size_t>(way.edge)],
                      last = first_[static_cast<std::size_t>(way.edge) + 1];
    if (first == last) return first_.back();
    return way.ahead == 1 ? first : last - 1;
  }

 private:
  struct Start {
    int vertex;
    Way way;
  };

  const visibility::ResolvedView& lines_;
  std::vector<Start> ends_;         ///< by vertex
  std::vector<std::size_t> first_;  ///< piece, by edge
};

/// A piece of a contour, in the order of a walk along it.
struct Step {
  std::size_t piece;
  std::size_t ahead;  ///< its end in that order, 0 or 1
};

/// A change between visible and hidden that moves: pieces that turn, and the part of the last one that turns with them.
struct Change {
  Step visible{}, hidden{};  ///< the pieces between which it was
  std::vector<Step> turned{};
  std::optional<Step> last{};  ///< none where the contour is visible beyond the pieces that turn
  double s = 0;                ///< on the edge of the last one
  double distance = 0;         ///< from where the change was, along the contour
};

/// Where something in front of a contour crosses it.
struct Crossing {
  double t = HUGE_VAL;      ///< along a piece, 0 to 1 in the order of a walk
  bool is_outline = false;  ///< a surface ends there: what is beyond may be hidden
  int covered = 0;          ///< where that surface is: 1 beyond the crossing, -1 before it, 0 unknown
};

/// What was passed along a contour before something crosses it.
struct Search {
  std::vector<Step> passed{};
  Step crossed{};
  std::optional<Crossing> crossing{};  ///< of `crossed`
  double distance = 0;                 ///< along the contour
};

search::Bounds<2> box_around(const Vec2& a, const Vec2& b, double margin) {
  const Vec2 low = glm::min(a, b) - margin, high = glm::max(a, b) + margin;
  return {{{low.x, high.x}, {low.y, high.y}}};
}

const Vec2& end_of(const Piece& piece, std::size_t end) { return end == 0 ? piece.from : piece.to; }

/// The pieces of contours, as they follow each other.
class ContourPieces {
 public:
  ContourPieces(const visibility::ResolvedView& lines, const view::PaperMap& paper, const std::vector<Piece>& pieces)
      : lines_(lines), paper_(paper), pieces_(pieces), ways_(lines, pieces) {}

  [[nodiscard]] const Piece& piece(const Step& step) const { return pieces_[step.piece]; }

  /// The visible pieces that end where something hides the rest of their edge, with that end ahead.
  [[nodiscard]] std::vector<Step> hidden_ends() const {
    std::vector<Step> ends;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (const std::size_t ahead : {0, 1})
        if (is_hidden_beyond({i, ahead})) ends.push_back({i, ahead});
    return ends;
  }

  /// The piece after a step; nothing where the contour ends or branches, or has pieces that are left out.
  [[nodiscard]] std::optional<Step> after(const Step& step) const {
    const Piece& piece = pieces_[step.piece];
    const double s = piece.s[step.ahead];
    if (s > 0 && s < 1) {
      const std::size_t next = step.ahead == 1 ? step.piece + 1 : step.piece - 1;
      if (next >= pieces_.size() || pieces_[next].edge != piece.edge) return std::nullopt;
      return pieces_[next].s[1 - step.ahead] == s ? std::optional(Step{next, step.ahead}) : std::nullopt;
    }
    const auto way = ways_.next({piece.edge, step.ahead});
    if (!way) return std::nullopt;
    const std::size_t next = ways_.begin(*way);
    if (next == pieces_.size()) return std::nullopt;
    const double begins = pieces_[next].s[1 - way->ahead];
    return begins == (way->ahead == 1 ? 0 : 1) ? std::optional(Step{next, way->ahead}) : std::nullopt;
  }

  /// The steps from one on, as long as they are as visible as that, and go on.
  [[nodiscard]] std::vector<Step> walk(const Step& from) const {
    std::vector<Step> steps{from};
    while (steps.size() < max_walked) {
      const auto next = after(steps.back());
      if (!next || next->piece == from.piece) break;
      const Piece& piece = pieces_[next->piece];
      if (piece.visible != pieces_[from.piece].visible || turns_back(steps.back(), *next)) break;
      if (!piece.visible && edge_of(lines_, piece).hollow != 0) break;
      steps.push_back(*next);
    }
    return steps;
  }

  /// How far a change is moved at most.
  [[nodiscard]] double reach(const Step& visible) const { return crossing_within * moved(pieces_[visible.piece]); }

 private:
  [[nodiscard]] Vec2 along(const Step& step) const {
    const Piece& piece = pieces_[step.piece];
    return end_of(piece, step.ahead) - end_of(piece, 1 - step.ahead);
  }

  // Contours of facets go back and forth where those of the surface do not.
  [[nodiscard]] bool turns_back(const Step& step, const Step& next) const {
    return glm::dot(along(step), along(next)) < 0;
  }

  // Whether a visible piece of a moved contour goes on as a hidden one; not at a cusp, where the surface itself hides
  // it.
  [[nodiscard]] bool is_hidden_beyond(const Step& visible) const {
    const Piece& piece = pieces_[visible.piece];
    if (!piece.visible || !edge_of(lines_, piece).is_moved()) return false;
    const auto next = after(visible);
    return next && !pieces_[next->piece].visible && edge_of(lines_, pieces_[next->piece]).hollow == 0;
  }

  // By how much the ends of an edge are drawn beside those in the mesh.
  [[nodiscard]] double moved(const Piece& piece) const { return std::max(moved(piece, 0), moved(piece, 1)); }
  [[nodiscard]] double moved(const Piece& piece, std::size_t end) const {
    Piece edge = piece;
    edge.s = {0, 1};
    const Vec2 drawn = position_on_paper(lines_.view, paper_, edge_of(lines_, piece), edge.s[end]);
    return glm::distance(drawn, in_mesh(lines_, paper_, edge, end));
  }

  const visibility::ResolvedView& lines_;
  const view::PaperMap& paper_;
  const std::vector<Piece>& pieces_;
  ContourWays ways_;
};

/// Visible lines near changes between visible and hidden, which may cross the contours there in front of them.
class LinesInFront {
 public:
  /// Those near the ends of visible pieces.
  LinesInFront(const visibility::ResolvedView& lines, const view::PaperMap& paper, const std::vector<Piece>& pieces,
               const ContourPieces& contours, const std::vector<Step>& ends)
      : lines_(lines), paper_(paper), pieces_(pieces) {
    const search::BoundsTree<2> wanted(ends.size(), [&](std::size_t i) {
      const Vec2& end = end_of(pieces_[ends[i].piece], ends[i].ahead);
      return box_around(end, end, contours.reach(ends[i]));
    });
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (!pieces_[i].visible) continue;
      wanted.visit(box_around(pieces_[i].from, pieces_[i].to, 0), [&](std::size_t) {
        near_.push_back(i);
        return false;
      });
    }
    near_tree_ = search::BoundsTree<2>(
        near_.size(), [&](std::size_t i) { return box_around(pieces_[near_[i]].from, pieces_[near_[i]].to, 0); });
  }

  /// Returns where along a piece visible lines in front of it first cross it as drawn.
  [[nodiscard]] std::optional<Crossing> crossing_of(const Step& step) const {
    const Piece& own = pieces_[step.piece];
    const Vec2 from = end_of(own, 1 - step.ahead), along = end_of(own, step.ahead) - from;
    Crossing first;
    near_tree_.visit(box_around(own.from, own.to, 0), [&](std::size_t number) {
      const Piece& other = pieces_[near_[number]];
      if (are_joined(own, other)) return true;
      const Vec2 across = other.to - other.from, way = other.from - from;
      const double area = cross(along, across);
      if (!(std::abs(area) > crossing_sine * glm::length(along) * glm::length(across))) return true;
      const double t = cross(way, across) / area, u = cross(way, along) / area;
      if (!(t >= 0 && t < first.t && t <= 1 && u >= 0 && u <= 1)) return true;
      if (depth_at(other, u) > depth_at(own, step.ahead == 1 ? t : 1 - t))
        first = {t, other.kind == EdgeKind::contour || other.kind == EdgeKind::boundary,
                 surface_side(other) * (area < 0 ? 1 : -1)};
      return true;
    });
    return first.t <= 1 ? std::optional(first) : std::nullopt;
  }

 private:
  // Whether two pieces are of one edge, or their edges meet in a vertex.
  [[nodiscard]] bool are_joined(const Piece& a, const Piece& b) const {
    const auto &p = edge_of(lines_, a).vertex, &q = edge_of(lines_, b).vertex;
    return a.edge == b.edge || p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1];
  }

  // Depth, growing towards the viewer, of a part of a piece as it is drawn.
  [[nodiscard]] double depth_at(const Piece& piece, double part) const {
    const edges::FeatureEdge& edge = edge_of(lines_, piece);
    const auto depth = [&](std::size_t end) { return lines_.view.vertices[edge.drawn_vertex(end)].depth; };
    const double s = piece.s[0] + part * (piece.s[1] - piece.s[0]);
    return depth(0) + s * (depth(1) - depth(0));
  }

  // Returns on which side of an outline, as it lies in the mesh, its surface is: 1 to the left of the way along its
  // edge, -1 to the right; 0 if that is unknown, as where a corner is behind the viewer.
  [[nodiscard]] int surface_side(const Piece& outline) const {
    const edges::FeatureEdge& edge = edge_of(lines_, outline);
    if (edge.mesh_edge < 0) return 0;
    bool is_seen = true;
    const auto place = [&](int number) {
      const view::PageVertex& vertex = lines_.view.vertices[static_cast<std::size_t>(number)];
      is_seen = is_seen && vertex.w > 0;
      return paper_(vertex);
    };
    const Vec2 from = place(edge.vertex[0]), along = place(edge.vertex[1]) - from;
    const mesh::Mesh& mesh = *lines_.world.models[edge.model].mesh;
    double side = 0;
    for (const int t : mesh.triangles_of(mesh.edges[static_cast<std::size_t>(edge.mesh_edge)]))
      for (const int v : mesh.triangle(t))
        side += cross(along, place(lines_.world.first_vertex[edge.model] + v) - from);
    return !is_seen ? 0 : side > 0 ? 1 : side < 0 ? -1 : 0;
  }

  const visibility::ResolvedView& lines_;
  const view::PaperMap& paper_;
  const std::vector<Piece>& pieces_;
  std::vector<std::size_t> near_;  ///< visible pieces near the ends, and a tree over them
  search::BoundsTree<2> near_tree_;
};

/// Looks for the place of a change between visible and hidden, along a contour as it is drawn.
class ChangeSearch {
 public:
  ChangeSearch(const ContourPieces& contours, const LinesInFront& in_front)
      : contours_(contours), in_front_(in_front) {}

  /// Returns how a change at the end of a visible piece moves; nothing if it stays.
  [[nodiscard]] std::optional<Change> change_at(const Step& visible) const {
    const auto hidden = contours_.after(visible);
    const auto onwards = crossing_along(*hidden, contours_.reach(visible));
    const auto back = crossing_along({visible.piece, 1 - visible.ahead}, contours_.reach(visible));
    const bool goes_on = onwards && (!back || onwards->distance <= back->distance);
    std::optional<Change> change = goes_on ? onwards : back;
    if (!change) change = covered_along(visible, *hidden, contours_.reach(visible));
    if (change) {
      change->visible = visible;
      change->hidden = *hidden;
    }
    return change;
  }

 private:
  // The pieces from a step on that nothing crosses, all as visible as that, and what crosses the one after them;
  // nothing if they are longer than `farthest`.
  [[nodiscard]] std::optional<Search> search_along(const Step& from, double farthest) const {
    Search search;
    for (const Step& step : contours_.walk(from)) {
      const double length = length_of(contours_.piece(step));
      search.crossing = in_front_.crossing_of(step);
      search.distance += search.crossing ? search.crossing->t * length : length;
      if (search.distance > farthest) return std::nullopt;
      if (search.crossing) {
        check(search.crossing->t >= 0 && search.crossing->t <= 1, "a crossing lies on the line that is crossed");
        search.crossed = step;
        return search;
      }
      search.passed.push_back(step);
    }
    return search;
  }

  // Whether a search ended at a piece that is as visible as wanted.
  [[nodiscard]] bool ends_at(const Search& search, bool visible) const {
    const auto next = search.crossing ? std::nullopt : contours_.after(search.passed.back());
    return next && contours_.piece(*next).visible == visible;
  }

  // Looks for the first outline that crosses the contour from a step on: a hidden way leads into the surface that hides
  // it, a visible one out of that. Hidden pieces that nothing crosses, between visible ones, are hidden by the facets
  // alone.
  [[nodiscard]] std::optional<Change> crossing_along(const Step& from, double farthest) const {
    const auto search = search_along(from, farthest);
    const bool visible = contours_.piece(from).visible;
    if (!search) return std::nullopt;
    Change change{.turned = search->passed, .distance = search->distance};
    if (!search->crossing) return !visible && ends_at(*search, true) ? std::optional(change) : std::nullopt;
    const int inwards = visible ? -1 : 1;
    if (!search->crossing->is_outline || search->crossing->covered == -inwards) return std::nullopt;
    const Piece& piece = contours_.piece(search->crossed);
    const std::size_t ahead = search->crossed.ahead;
    change.last = search->crossed;
    change.s = piece.s[1 - ahead] + search->crossing->t * (piece.s[ahead] - piece.s[1 - ahead]);
    return change;
  }

  // Visible pieces between hidden ones which nothing crosses, but where the next thing that crosses the contour is an
  // outline that it passes on the way out from behind its surface: they are visible between facets alone.
  [[nodiscard]] std::optional<Change> covered_along(const Step& visible, const Step& hidden, double farthest) const {
    const auto beyond = search_along(hidden, farthest);
    if (!beyond || !beyond->crossing || !beyond->crossing->is_outline || beyond->crossing->covered >= 0)
      return std::nullopt;
    const auto back = search_along({visible.piece, 1 - visible.ahead}, farthest);
    if (!back || !ends_at(*back, false)) return std::nullopt;
    return Change{.turned = back->passed, .distance = back->distance};
  }

  const ContourPieces& contours_;
  const LinesInFront& in_front_;
};

/// Turns pieces where changes move, and divides them there.
class TurnedPieces {
 public:
  TurnedPieces(const visibility::ResolvedView& lines, const view::PaperMap& paper, std::vector<Piece>& pieces,
               const ContourPieces& contours)
      : lines_(lines),
        paper_(paper),
        pieces_(pieces),
        contours_(contours),
        settled_(pieces.size(), {false, false}),
        changed_(pieces.size(), 0) {}

  /// What was turned before, from the other side, stays.
  void apply(const Change& change) {
    const auto is_changed = [&](const Step& step) { return changed_[step.piece] != 0; };
    if (std::any_of(change.turned.begin(), change.turned.end(), is_changed)) return;
    if (change.last && is_changed(*change.last)) return;
    // What was visible only as far as here goes on now, or nothing is visible on either side.
    settle(change.visible.piece, change.visible.ahead);
    settle(change.hidden.piece, 1 - change.hidden.ahead);
    if (change.last)
      divide(*change.last, change.s);
    else if (const auto beyond = contours_.after(change.turned.back()))
      settle(beyond->piece, 1 - beyond->ahead);
    for (const Step& step : change.turned) {
      changed_[step.piece] = 1;
      pieces_[step.piece].visible = !pieces_[step.piece].visible;
      for (const std::size_t end : {0, 1}) settle(step.piece, end);
    }
  }

  /// Puts what was divided off in its place, and returns which ends are settled.
  std::vector<SettledEnds> finish() {
    insert_added();
    return std::move(settled_);
  }

 private:
  void settle(std::size_t piece, std::size_t end) {
    check(piece < settled_.size() && end < 2, "a piece has two ends");
    settled_[piece][end] = true;
  }

  // The part of a piece up to a place on its edge turns.
  void divide(const Step& step, double s) {
    Piece& rest = pieces_[step.piece];
    const std::size_t begin = 1 - step.ahead;
    Piece part = rest;
    part.visible = !rest.visible;
    part.s[step.ahead] = rest.s[begin] = s;
    const Vec2 place = position_on_paper(lines_.view, paper_, edge_of(lines_, rest), s);
    (step.ahead == 1 ? part.to : part.from) = (begin == 1 ? rest.to : rest.from) = place;
    added_.push_back({step.piece + (step.ahead == 1 ? 0 : 1), part});
    changed_[step.piece] = 1;
    settle(step.piece, begin);
  }

  // Each before the piece that it precedes on its edge.
  void insert_added() {
    if (added_.empty()) return;
    const auto order = [](const Added& one) { return std::tuple(one.before, one.piece.edge, one.piece.s[0]); };
    std::sort(added_.begin(), added_.end(), [&](const Added& a, const Added& b) { return order(a) < order(b); });
    std::vector<Piece> all;
    std::vector<SettledEnds> settled;
    all.reserve(pieces_.size() + added_.size());
    settled.reserve(all.capacity());
    auto next = added_.begin();
    for (std::size_t i = 0; i <= pieces_.size(); ++i) {
      for (; next != added_.end() && next->before == i; ++next) {
        all.push_back(next->piece);
        settled.push_back({true, true});
      }
      if (i == pieces_.size()) break;
      all.push_back(pieces_[i]);
      settled.push_back(settled_[i]);
    }
    check(all.size() == pieces_.size() + added_.size(), "every part of a piece has its place");
    pieces_ = std::move(all);
    settled_ = std::move(settled);
  }

  struct Added {
    std::size_t before;
    Piece piece;
  };

  const visibility::ResolvedView& lines_;
  const view::PaperMap& paper_;
  std::vector<Piece>& pieces_;
  const ContourPieces& contours_;
  std::vector<SettledEnds> settled_;
  std::vector<char> changed_;  ///< by piece
  std::vector<Added> added_;
};

}  // namespace

std::vector<SettledEnds> move_t_junctions(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                          std::vector<Piece>& pieces) {
  if (std::ranges::none_of(lines.drawn.edges, &edges::FeatureEdge::is_moved))
    return std::vector<SettledEnds>(pieces.size());
  const ContourPieces contours(lines, paper, pieces);
  const std::vector<Step> ends = contours.hidden_ends();
  if (ends.empty()) return std::vector<SettledEnds>(pieces.size());
  const LinesInFront in_front(lines, paper, pieces, contours, ends);
  const ChangeSearch search(contours, in_front);
  std::vector<std::optional<Change>> changes(ends.size());
  parallel_for(ends.size(), grain::heavy, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) changes[i] = search.change_at(ends[i]);
  });
  TurnedPieces turned(lines, paper, pieces, contours);
  for (const auto& change : changes)
    if (change) turned.apply(*change);
  std::vector<SettledEnds> settled = turned.finish();
  check(settled.size() == pieces.size(), "each piece tells whether its ends are settled");
  return settled;
}

}  // namespace epura::drawing
