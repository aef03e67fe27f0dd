// SPDX-License-Identifier: Apache-2.0
#include "verify/line_marks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace epura::verify {

namespace {

// Multiple of the contact tolerance above which a step in depth counts as one.
constexpr double clear_step = 8;
// Multiple of the contact tolerance up to which a surface behind a face still counts as touching it, however steep the
// face is.
constexpr double still_touching = 0.5;
// Multiple of the contact tolerance up to which a surface may lie behind another one and still count as seen.
constexpr double seen_through = 32;
// A triangle is a line on the page if its width there is at most `edge_on` steps of the page's rounding, unless it is
// nearly as narrow in space: its width must be at most `narrow` times its height there.
constexpr double edge_on = 8, narrow = 0.1;
// Longest row of adjacent needles that is followed; a longer one would be a surface.
constexpr int longest_row = 64;
// Where a piece has no crossing: a depth limit cut it there, or it continues.
constexpr int cut_there = -1, goes_on = -2;

}  // namespace

LineMarks::LineMarks(const ScanScene& scene, const FoldRule& rule, const ScanLine& line, const MarkLimits& limits,
                     const MetByLine& met)
    : scene_(scene),
      rule_(rule),
      line_(line),
      limits_(limits),
      slice_(cut(scene, line, met.triangles)),
      wires_(rule.options().wire ? cut_wires(scene, line, met.wires) : std::vector<WireCrossing>()),
      seen_(upper_envelope(slice_)) {
  find_cuts_edge_on();
}

// The changes between `from` and `to`.
std::vector<LineMarks::Change> LineMarks::changes(double from, double to) const {
  std::vector<Change> list;
  const auto first = std::ranges::lower_bound(seen_, from, {}, &SeenPart::to);
  for (auto part = first; part != seen_.end() && part->from <= to; ++part) {
    const bool joined = part != seen_.begin() && std::prev(part)->to == part->from;
    const bool continued = std::next(part) != seen_.end() && std::next(part)->from == part->to;
    if (part->from >= from) list.push_back({part->from, joined ? std::prev(part)->piece : -1, part->piece});
    if (!continued && part->to <= to) list.push_back({part->to, part->piece, -1});
  }
  return list;
}

std::array<int, 2> LineMarks::crossings_between(double from, double to) const {
  const auto first = std::ranges::lower_bound(slice_.crossings, from, {}, &SliceCrossing::u);
  const auto last = std::ranges::upper_bound(slice_.crossings, to, {}, &SliceCrossing::u);
  return {static_cast<int>(first - slice_.crossings.begin()), static_cast<int>(last - slice_.crossings.begin())};
}

int LineMarks::crossing_at(int piece, double u) const {
  if (piece < 0) return cut_there;
  const SlicePiece& p = slice_.pieces[piece];
  return u == p.u[0] ? p.crossing[0] : u == p.u[1] ? p.crossing[1] : goes_on;
}

const PieceEnd* LineMarks::end_of(int crossing, int triangle) const {
  const auto ends = slice_.ends_at(crossing);
  const auto found =
      std::ranges::find_if(ends, [&](const PieceEnd& end) { return slice_.pieces[end.piece].triangle == triangle; });
  return found == ends.end() ? nullptr : &*found;
}

// Whether rounding may have moved a triangle to the other side of its edge on the page.
bool LineMarks::is_edge_on(const std::array<int, 2>& edge, int triangle) const {
  const auto line = scene_.line_of(edge);
  if (!line) return true;
  const Vec2 along = glm::normalize((*line)[1] - (*line)[0]);
  double width = 0;
  for (const int v : scene_.world.triangles[triangle]) {
    if (!scene_.is_before_viewer(v)) return false;
    const Vec2 to = scene_.position(v) - (*line)[0];
    width = std::max(width, std::abs(cross(along, to)));
  }
  const double scale = scene_.page / (1 - scene_.k * scene_.local[edge[0]].z);
  return width <= edge_on * limits_.quantum + 2 * scene_.world.rounding * scale &&
         width <= narrow * scale * rule_.height(triangle);
}

// Needles have no plane: the triangle that continues beyond them counts.
LineMarks::Beyond LineMarks::beyond(int crossing, int triangle, FoldRule::Needle needle) const {
  for (int step = 0; step < longest_row; ++step) {
    const PieceEnd* end = end_of(crossing, triangle);
    if (end == nullptr) return {};
    const SlicePiece& piece = slice_.pieces[end->piece];
    if (!rule_.is_needle(triangle, needle)) return {triangle, end->end == 0};
    crossing = piece.crossing[1 - end->end];
    if (crossing < 0 || piece.width() > limits_.reach) return {};
    const auto sheets = rule_.sheets_at(slice_.crossings[crossing].edge).bodies;
    const auto both = std::ranges::find_if(
        sheets, [&](const std::vector<int>& body) { return std::ranges::count(body, triangle) > 0; });
    if (both == sheets.end() || both->size() != 2) return {};
    triangle = (*both)[0] == triangle ? (*both)[1] : (*both)[0];
  }
  return {};
}

Need LineMarks::pair(int crossing, const std::vector<int>& sheets, FoldRule::Needle needle) const {
  const Beyond one = beyond(crossing, sheets[0], needle), two = beyond(crossing, sheets[1], needle);
  if (one.triangle < 0 || two.triangle < 0 || one.triangle == two.triangle) return Need::possible;
  const std::array<int, 2>& edge = slice_.crossings[crossing].edge;
  const Need fold = rule_.fold(edge, one.triangle, two.triangle);
  if (fold != Need::none || !rule_.options().contour) return fold;
  // An outline is required where depth jumps.
  const bool may_be_outline =
      one.right == two.right || is_edge_on(edge, one.triangle) || is_edge_on(edge, two.triangle);
  return may_be_outline ? Need::possible : Need::none;
}

Need LineMarks::need_at(int crossing) const {
  const FoldRule::Sheets sheets = rule_.sheets_at(slice_.crossings[crossing].edge);
  if (sheets.edge == nullptr) return Need::possible;
  if (sheets.edge->wire && rule_.options().wire) return Need::asked;
  if (sheets.edge->cut == mesh::CutEdge::inside) return Need::none;
  if (sheets.edge->cut == mesh::CutEdge::outline) return Need::asked;
  if (rule_.ends_at_cut(sheets) || scene_.is_left_out(slice_.crossings[crossing].edge)) return Need::possible;
  Need strongest = Need::none;
  for (const std::vector<int>& body : sheets.bodies) {
    Need need = body.size() == 1         ? rule_.options().boundary ? Need::asked : Need::none
                : rule_.options().crease ? Need::asked
                                         : Need::none;
    if (body.size() == 2) {
      need = pair(crossing, body, FoldRule::Needle::perhaps);
      if (need != pair(crossing, body, FoldRule::Needle::hardly_seen)) need = Need::possible;
    }
    strongest = std::max(strongest, need);
  }
  return strongest;
}

// Whether the surface continues from a crossing to a piece through pieces that are lines on the page.
bool LineMarks::continues(int crossing, int piece) const {
  if (piece < 0) return false;
  std::vector<int> open{crossing}, met{crossing};
  while (!open.empty() && met.size() < longest_row) {
    const int next = open.back();
    open.pop_back();
    for (const PieceEnd& end : slice_.ends_at(next)) {
      if (end.piece == piece) return true;
      const SlicePiece& other = slice_.pieces[end.piece];
      const int far = other.crossing[1 - end.end];
      if (far < 0 || other.width() > limits_.reach || std::ranges::count(met, far) > 0) continue;
      open.push_back(far);
      met.push_back(far);
    }
  }
  return false;
}

// Whether a face of a part goes on behind its own facets, no farther than these are deep: as near the end of a contour,
// or where a tessellation turns facets over; on a torus twice as far, as beyond a cusp.
bool LineMarks::is_fold_of_face(int crossing, int back, double step) const {
  const std::array<int, 2>& edge = slice_.crossings[crossing].edge;
  if (back < 0 || !rule_.are_one_face(edge, slice_.pieces[back].triangle)) return false;
  double nearest = -HUGE_VAL, farthest = HUGE_VAL;
  for (const std::vector<int>& body : rule_.sheets_at(edge).bodies)
    for (const int triangle : body)
      for (const int v : scene_.world.triangles[triangle]) {
        if (!scene_.is_before_viewer(v)) return false;
        const double depth = scene_.depth_of(scene_.local[v]);
        nearest = std::max(nearest, depth);
        farthest = std::min(farthest, depth);
      }
  return step <= (rule_.is_of_torus(slice_.pieces[back].triangle) ? 2 : 1) * (nearest - farthest);
}

bool LineMarks::is_vague(const Change& change) const {
  return (change.left >= 0 && scene_.is_vague(slice_.pieces[change.left].triangle)) ||
         (change.right >= 0 && scene_.is_vague(slice_.pieces[change.right].triangle));
}

LineMarks::Jump LineMarks::jump_at(const Change& change) const {
  const auto depth = [&](int piece) { return piece < 0 ? -HUGE_VAL : slice_.pieces[piece].depth_at(change.u); };
  const auto slope = [&](int piece) { return piece < 0 ? 0 : std::abs(slice_.pieces[piece].slope()); };
  const bool left = depth(change.left) >= depth(change.right);
  const int front = left ? change.left : change.right, back = left ? change.right : change.left;
  const double step = depth(front) - depth(back);
  const double rounding = edge_on * limits_.quantum * (slope(front) + slope(back));
  return {front, back, step, step > clear_step * limits_.contact + rounding, crossing_at(front, change.u)};
}

void LineMarks::add_marks(const Change& change, std::vector<LineMark>& marks) const {
  const auto mark = [&](int crossing, bool jump) {
    const auto edge = crossing < 0 ? std::array{-1, -1} : slice_.crossings[crossing].edge;
    if (marks.empty() || marks.back().u != change.u || marks.back().edge != edge)
      marks.push_back({change.u, jump, edge, {triangle_of(change.left), triangle_of(change.right)}});
  };
  const auto [front, back, step, is_clear, end] = jump_at(change);
  if (front < 0) return;  // a depth that is no number
  if (is_clear) {
    if (end >= 0 && !continues(end, back) && !is_fold_of_face(end, back, step) &&
        !scene_.is_left_out(slice_.crossings[end].edge) && !scene_.is_at_limit(slice_.crossings[end].edge) &&
        rule_.outline(slice_.crossings[end].edge) == Need::asked)
      mark(end, true);
  } else if (end == goes_on && crossing_at(back, change.u) == goes_on) {
    const double contact = clear_step * limits_.contact / scene_.page;
    if (rule_.crossing(triangle_of(front), triangle_of(back), contact) == Need::asked) mark(-1, false);
  }
  const double nearest = slice_.pieces[front].depth_at(change.u);
  for (const int piece : {change.left, change.right}) {
    const int crossing = crossing_at(piece, change.u);
    if (crossing >= 0 && slice_.crossings[crossing].depth >= nearest && need_at(crossing) == Need::asked)
      mark(crossing, false);
  }
}

std::vector<LineMark> LineMarks::asked() const {
  std::vector<LineMark> marks;
  for (const Change& change : changes(-HUGE_VAL, HUGE_VAL))
    if (!is_vague(change)) add_marks(change, marks);
  for (const WireCrossing& crossing : wires_)
    if (is_surely_seen(crossing)) marks.push_back({crossing.u, false, crossing.wire, {-1, -1}});
  return marks;
}

std::vector<LineMark> LineMarks::jumps() const {
  std::vector<LineMark> marks;
  for (const Change& change : changes(-HUGE_VAL, HUGE_VAL)) {
    const Jump jump = jump_at(change);
    if (is_vague(change) || !jump.is_clear || jump.end < 0) continue;
    const std::array<int, 2>& edge = slice_.crossings[jump.end].edge;
    if (!scene_.is_at_limit(edge) && rule_.outline(edge) == Need::asked)
      marks.push_back({change.u, true, edge, {triangle_of(change.left), triangle_of(change.right)}});
  }
  return marks;
}

// Where both pieces that end at a crossing lie on one side of it: the triangle of the nearer one. Beside a triangle
// that is a line on the page, the other one.
int LineMarks::front_of_fold(int crossing) const {
  const auto ends = slice_.ends_at(crossing);
  if (ends.size() != 2) return -1;
  const SlicePiece &one = slice_.pieces[ends[0].piece], &two = slice_.pieces[ends[1].piece];
  const double line = edge_on * limits_.quantum;
  if (one.width() <= line || two.width() <= line) return one.width() >= two.width() ? one.triangle : two.triangle;
  if (ends[0].end != ends[1].end) return -1;
  const double u = slice_.crossings[crossing].u, width = std::min(one.width(), two.width());
  const double beside = ends[0].end == 0 ? u + width : u - width;
  return one.depth_at(beside) >= two.depth_at(beside) ? one.triangle : two.triangle;
}

EdgePlace LineMarks::place_of(int crossing) const {
  const std::array<int, 2>& edge = slice_.crossings[crossing].edge;
  const auto aside = [&](int v) {
    const Vec3& p = scene_.local[v];
    return scene_.page * glm::dot(line_.across(), Vec2(p)) -
           glm::dot(line_.across(), line_.middle) * (1 - scene_.k * p.z);
  };
  const double from = aside(edge[0]), to = aside(edge[1]);
  return {edge, from / (from - to), -1};
}

// Up to two pieces to both sides of a fold.
std::vector<EdgePlace> LineMarks::path_around(int crossing) const {
  std::vector<EdgePlace> path{place_of(crossing)};
  for (const PieceEnd& start : slice_.ends_at(crossing)) {
    PieceEnd way = start;
    for (int step = 0; step < 2; ++step) {
      const int far = slice_.pieces[way.piece].crossing[1 - way.end];
      if (far < 0) break;
      path.push_back(place_of(far));
      path.back().triangle = slice_.pieces[way.piece].triangle;
      const auto ends = slice_.ends_at(far);
      const auto next = std::ranges::find_if(ends, [&](const PieceEnd& end) { return end.piece != way.piece; });
      if (next == ends.end()) break;
      way = *next;
    }
  }
  return path;
}

// Notes whether two pieces change places somewhere between two positions, and whether that is seen. Neighbours in a
// surface do not.
void LineMarks::note_crossings(double from, double to, Around& around) const {
  struct There {
    const SlicePiece* piece;
    double nearest, farthest;
  };
  std::vector<There> there;
  for (const SlicePiece& piece : slice_.pieces) {
    if (piece.u[0] >= to || piece.u[1] <= from || !(piece.width() > 0)) continue;
    const auto [farthest, nearest] =
        std::minmax({piece.depth_at(std::max(from, piece.u[0])), piece.depth_at(std::min(to, piece.u[1]))});
    const bool is_known = farthest <= nearest;  // a depth may be no number
    there.push_back(
        {&piece, is_known ? nearest + limits_.contact : HUGE_VAL, is_known ? farthest - limits_.contact : -HUGE_VAL});
  }
  // Only pieces with a depth in common change places.
  std::ranges::stable_sort(there, std::greater(), &There::nearest);
  for (std::size_t i = 0; i < there.size(); ++i)
    for (std::size_t j = i + 1; j < there.size() && !around.seen_crossing; ++j) {
      if (there[j].nearest < there[i].farthest) break;
      const auto [one, two] = std::minmax(there[i].piece, there[j].piece);
      note_crossing({one, two}, {from, to}, around);
    }
}

void LineMarks::note_crossing(const std::array<const SlicePiece*, 2>& pieces, const std::array<double, 2>& within,
                              Around& around) const {
  const SlicePiece &one = *pieces[0], &two = *pieces[1];
  const double low = std::max({within[0], one.u[0], two.u[0]}), high = std::min({within[1], one.u[1], two.u[1]});
  if (!(low < high)) return;
  const double at_low = one.depth_at(low) - two.depth_at(low), at_high = one.depth_at(high) - two.depth_at(high);
  if (at_low * at_high > 0 || std::max(std::abs(at_low), std::abs(at_high)) <= clear_step * limits_.contact) return;
  const auto& own = scene_.world.triangles[one.triangle];
  if (std::ranges::any_of(scene_.world.triangles[two.triangle], [&](int v) { return std::ranges::count(own, v) > 0; }))
    return;
  around.any_crossing = true;
  around.seen_crossing = is_seen(low, one.depth_at(low)) || is_seen(high, one.depth_at(high));
}

// Finds where faces that are lines on the page are seen where a depth limit cuts them.
void LineMarks::find_cuts_edge_on() {
  for (const SlicePiece& piece : slice_.pieces) {
    if (piece.width() > edge_on * limits_.quantum) continue;
    const auto is_seen_cut = [&](int end) {
      return piece.crossing[end] == cut_there && is_seen(piece.u[end], piece.depth[end]);
    };
    if (is_seen_cut(0) || is_seen_cut(1)) cuts_edge_on_.push_back(piece.u);
  }
}

bool LineMarks::is_cut_edge_on(double from, double to) const {
  return std::ranges::any_of(cuts_edge_on_, [&](const auto& u) { return u[0] <= to && u[1] >= from; });
}

Around LineMarks::around(double u, double reach) const {
  const double from = u - reach, to = u + reach;
  Around around;
  around.at_limit = is_cut_edge_on(from, to);
  for (auto part = std::ranges::lower_bound(seen_, from, {}, &SeenPart::to); part != seen_.end() && part->from <= to;
       ++part)
    around.is_vague = around.is_vague || scene_.is_vague(slice_.pieces[part->piece].triangle);
  for (const Change& change : changes(from, to))
    around.at_limit = around.at_limit || (change.left >= 0 && crossing_at(change.left, change.u) == cut_there) ||
                      (change.right >= 0 && crossing_at(change.right, change.u) == cut_there);
  const auto [first, last] = crossings_between(from, to);
  for (int i = first; i < last; ++i) {
    const SliceCrossing& crossing = slice_.crossings[i];
    MetEdge met{crossing.edge, is_seen(crossing.u, crossing.depth), front_of_fold(i)};
    if (met.front >= 0) met.path = path_around(i);
    around.edges.push_back(std::move(met));
  }
  around.wire =
      std::ranges::any_of(wires_, [&](const WireCrossing& crossing) { return std::abs(crossing.u - u) <= reach; });
  note_crossings(from, to, around);
  return around;
}

bool LineMarks::is_break(const Change& change) const {
  const int one = crossing_at(change.left, change.u), two = crossing_at(change.right, change.u);
  if (change.left < 0 || change.right < 0 || one == cut_there || two == cut_there) return true;
  if (one >= 0 && one == two) return false;
  return !(one >= 0 && continues(one, change.right)) && !(two >= 0 && continues(two, change.left));
}

// Whether a piece in front of a point certainly hides it.
bool LineMarks::is_hidden_by(const SeenPart& part, double u, double depth) const {
  const SlicePiece& piece = slice_.pieces[part.piece];
  const double slack = (seen_through * limits_.contact + limits_.reach) * (1 + std::abs(piece.slope()));
  return piece.depth_at(u) > depth + slack;
}

bool LineMarks::is_seen(double u, double depth) const {
  const auto right = std::ranges::upper_bound(seen_, u, {}, &SeenPart::to);
  const auto left = std::ranges::lower_bound(seen_, u, {}, &SeenPart::to);
  if (right == seen_.end() || left == seen_.end() || right->from > u || left->from >= u) return true;
  return !is_hidden_by(*left, u, depth) || !is_hidden_by(*right, u, depth);
}

// Whether nothing near a position on a wire may hide it. A face that shares an end with the wire hides it however
// little it lies in front.
bool LineMarks::is_surely_seen(const WireCrossing& crossing) const {
  const auto& [wire, u, depth] = crossing;
  if (scene_.is_vague(wire)) return false;
  for (auto part = std::ranges::lower_bound(seen_, u - limits_.reach, {}, &SeenPart::to);
       part != seen_.end() && part->from <= u + limits_.reach; ++part) {
    const SlicePiece& piece = slice_.pieces[part->piece];
    const auto& corners = scene_.world.triangles[piece.triangle];
    const bool is_joined = std::ranges::any_of(wire, [&](int v) { return std::ranges::count(corners, v) > 0; });
    const double slack = is_joined ? -clear_step * limits_.contact : still_touching * limits_.contact;
    if (piece.depth_at(std::clamp(u, part->from, part->to)) > depth + slack) return false;
  }
  return true;
}

// Whether two faces cross or touch at a position, in front or hardly behind what is seen.
bool LineMarks::faces_meet(double u, double reach) const {
  std::vector<std::array<double, 2>> depths;
  for (const SlicePiece& piece : slice_.pieces) {
    const double depth = piece.depth_at(u);
    if (!(piece.u[0] < u && piece.u[1] > u) || !is_seen(u, depth)) continue;
    const double touching = (clear_step * limits_.contact + reach) * (1 + std::abs(piece.slope()));
    depths.push_back({depth - touching, depth + touching});
  }
  std::ranges::sort(depths);
  return std::ranges::adjacent_find(depths, [](const auto& low, const auto& high) { return low[1] >= high[0]; }) !=
         depths.end();
}

bool LineMarks::allows(EdgeKind kind, double u, double reach) const {
  if (kind == EdgeKind::thread || kind == EdgeKind::thread_end) return true;  // a convention, which no face explains
  for (auto part = std::ranges::lower_bound(seen_, u - reach, {}, &SeenPart::to);
       part != seen_.end() && part->from <= u + reach; ++part)
    if (scene_.is_vague(slice_.pieces[part->piece].triangle)) return true;
  if (std::ranges::any_of(changes(u - reach, u + reach), [&](const Change& c) { return is_break(c); })) return true;
  if (is_cut_edge_on(u - reach, u + reach)) return true;
  const auto [first, last] = crossings_between(u - reach, u + reach);
  for (int i = first; i < last; ++i) {
    if (!is_seen(slice_.crossings[i].u, slice_.crossings[i].depth)) continue;
    if (need_at(i) != Need::none) return true;
    const FoldRule::Sheets sheets = rule_.sheets_at(slice_.crossings[i].edge);
    if (edges::is_within_surface(kind) && !sheets.edge->diagonal && sheets.edge->cut != mesh::CutEdge::inside)
      return true;
  }
  if (kind == EdgeKind::wire)
    return std::ranges::any_of(wires_, [&](const WireCrossing& crossing) {
      return std::abs(crossing.u - u) <= reach && is_seen(crossing.u, crossing.depth);
    });
  return kind == EdgeKind::intersection && faces_meet(u, reach);
}

bool LineMarks::same_line(const std::array<int, 2>& first, const std::array<int, 2>& second, double u,
                          double reach) const {
  const auto [from, to] = crossings_between(u - reach, u + reach);
  for (int i = from; i < to; ++i) {
    if (slice_.crossings[i].edge != first) continue;
    for (const PieceEnd& end : slice_.ends_at(i)) {
      const SlicePiece& piece = slice_.pieces[end.piece];
      const int far = piece.crossing[1 - end.end];
      if (far >= 0 && slice_.crossings[far].edge == second && rule_.is_needle(piece.triangle, FoldRule::Needle::surely))
        return true;
    }
  }
  return false;
}

namespace {

class Merger {
 public:
  explicit Merger(const Slice& slice) : slice_(slice) {}

  [[nodiscard]] std::vector<SeenPart> envelope(const std::vector<int>& pieces, std::size_t begin,
                                               std::size_t end) const {
    if (begin == end) return {};
    if (end - begin == 1) {
      const SlicePiece& piece = slice_.pieces[pieces[begin]];
      return {{piece.u[0], piece.u[1], pieces[begin]}};
    }
    const std::size_t middle = begin + (end - begin) / 2;
    return merge(envelope(pieces, begin, middle), envelope(pieces, middle, end));
  }

 private:
  static void add(std::vector<SeenPart>& list, double from, double to, int piece) {
    if (!(from < to)) return;
    if (!list.empty() && list.back().piece == piece && list.back().to == from)
      list.back().to = to;
    else
      list.push_back({from, to, piece});
  }

  // For an interval that both pieces cover: two straight lines, which cross at most once.
  void add_nearer(std::vector<SeenPart>& list, double from, double to, int a, int b) const {
    const SlicePiece &first = slice_.pieces[a], &second = slice_.pieces[b];
    const double at_from = first.depth_at(from) - second.depth_at(from);
    const double at_to = first.depth_at(to) - second.depth_at(to);
    if (at_from >= 0 && at_to >= 0) return add(list, from, to, a);
    if (at_from <= 0 && at_to <= 0) return add(list, from, to, b);
    const double cross = std::clamp(from + at_from / (at_from - at_to) * (to - from), from, to);
    add(list, from, cross, at_from > 0 ? a : b);
    add(list, cross, to, at_from > 0 ? b : a);
  }

  [[nodiscard]] std::vector<SeenPart> merge(const std::vector<SeenPart>& a, const std::vector<SeenPart>& b) const {
    std::vector<SeenPart> result;
    std::size_t i = 0, j = 0;
    double at = -HUGE_VAL;
    while (i < a.size() || j < b.size()) {
      const bool in_a = i < a.size() && a[i].from <= at, in_b = j < b.size() && b[j].from <= at;
      double next = HUGE_VAL;
      if (i < a.size()) next = std::min(next, in_a ? a[i].to : a[i].from);
      if (j < b.size()) next = std::min(next, in_b ? b[j].to : b[j].from);
      if (in_a && in_b)
        add_nearer(result, at, next, a[i].piece, b[j].piece);
      else if (in_a || in_b)
        add(result, at, next, in_a ? a[i].piece : b[j].piece);
      at = next;
      while (i < a.size() && a[i].to <= at) ++i;
      while (j < b.size() && b[j].to <= at) ++j;
    }
    return result;
  }

  const Slice& slice_;
};

}  // namespace

std::vector<SeenPart> upper_envelope(const Slice& slice) {
  std::vector<int> wide;
  for (std::size_t i = 0; i < slice.pieces.size(); ++i)
    if (slice.pieces[i].width() > 0) wide.push_back(static_cast<int>(i));
  // Adjacent pieces first: halves that do not overlap are merged without comparisons.
  std::ranges::stable_sort(wide, {}, [&](int i) { return slice.pieces[i].u[0]; });
  return Merger(slice).envelope(wide, 0, wide.size());
}

}  // namespace epura::verify
