// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "cut/limits.hpp"

namespace epura::cut {

namespace {

double signed_area(const Vec2& a, const Vec2& b) { return cross(a, b) / 2; }

/// A set of connected outlines.
struct Piece {
  int body;
  mesh::Outlines outlines;  ///< from first to second end; vertices are not shared
  std::vector<int> senses;
  bool unsure = false;  ///< the area that it bounds is unknown
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};
  Vec2 sample{0.0};
  double directed = 0, around = 0, length = 0;  ///< areas: on the left minus on the right, and by the even-odd rule

  void add(const Vec2& a, const Vec2& b, int sense) {
    const int first = static_cast<int>(outlines.places.size());
    outlines.places.insert(outlines.places.end(), {a, b});
    outlines.segments.push_back({first, first + 1});
    senses.push_back(sense);
  }
  void measure();
  [[nodiscard]] bool is_line() const { return around <= area_of_line * length * length; }
  [[nodiscard]] int sense() const { return std::abs(directed) < one_sense * around ? 0 : directed > 0 ? 1 : -1; }
  [[nodiscard]] bool holds(const Vec2& p) const {
    return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && mesh::is_inside(outlines, p);
  }
};

void Piece::measure() {
  for (const Vec2& p : outlines.places) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  sample = (outlines.places[0] + outlines.places[1]) / 2.0;
  for (std::size_t s = 0; s < outlines.segments.size(); ++s) {
    const Vec2 a = outlines.places[2 * s], b = outlines.places[2 * s + 1];
    length += glm::distance(a, b);
    directed += senses[s] * signed_area(a - sample, b - sample);
  }
  mesh::Outlines filled = outlines;
  for (const auto& [a, b, c] : mesh::fill_even_odd(filled))
    around += std::abs(signed_area(filled.places[b] - filled.places[a], filled.places[c] - filled.places[a]));
}

struct Chord {
  std::array<int, 2> ends;
  int sense;
};

// Straight lines that close outlines between the nearest ends, with the orientation of these outlines.
std::vector<Chord> chords(const FlatOutlines& flat, std::span<const CutSegment> segments) {
  std::vector<int> degree(flat.vertices.size(), 0), arriving(flat.vertices.size(), 0), ends;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& [a, b] = flat.outlines.segments[s];
    ++degree[a];
    ++degree[b];
    arriving[a] -= segments[s].sense;
    arriving[b] += segments[s].sense;
  }
  for (std::size_t v = 0; v < degree.size(); ++v)
    if (degree[v] % 2 == 1) ends.push_back(static_cast<int>(v));
  std::vector<Chord> chosen;
  if (ends.size() > max_ends) return chosen;
  std::vector<std::tuple<double, int, int>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j)
      pairs.emplace_back(glm::distance(flat.outlines.places[ends[i]], flat.outlines.places[ends[j]]), ends[i], ends[j]);
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [distance, a, b] : pairs) {
    if (degree[a] % 2 == 0 || degree[b] % 2 == 0) continue;
    ++degree[a];
    ++degree[b];
    chosen.push_back({{a, b}, arriving[a] > 0 && arriving[b] < 0 ? 1 : arriving[a] < 0 && arriving[b] > 0 ? -1 : 0});
  }
  return chosen;
}

/// The connected pieces of outlines, and the piece of each segment.
struct Pieces {
  std::vector<Piece> pieces;
  std::vector<int> of_segment;

  void add_body(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame);
};

void Pieces::add_body(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame) {
  const FlatOutlines flat = flatten(segments, places, frame);
  const std::vector<Chord> closing = chords(flat, segments);
  DisjointSets joined(flat.vertices.size());
  std::vector<int> degree(flat.vertices.size(), 0);
  const auto join = [&](const std::array<int, 2>& ends) {
    joined.join(ends[0], ends[1]);
    for (const int v : ends) ++degree[v];
  };
  for (const auto& segment : flat.outlines.segments) join(segment);
  for (const Chord& chord : closing) join(chord.ends);
  const bool unsure = std::any_of(degree.begin(), degree.end(), [](int d) { return d % 2 == 1; });

  const std::size_t first = pieces.size();
  std::vector<int> number(flat.vertices.size(), -1);
  const auto add = [&](const std::array<int, 2>& ends, int sense) {
    int& piece = number[joined.root(ends[0])];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.push_back({segments.front().body, {}, {}, unsure});
    }
    pieces[piece].add(flat.outlines.places[ends[0]], flat.outlines.places[ends[1]], sense);
    return piece;
  };
  for (std::size_t s = 0; s < segments.size(); ++s)
    of_segment.push_back(add(flat.outlines.segments[s], segments[s].sense));
  for (const Chord& chord : closing) add(chord.ends, chord.sense);
  for (std::size_t p = first; p < pieces.size(); ++p) pieces[p].measure();
}

Pieces pieces_of(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame) {
  Pieces pieces;
  visit_bodies(segments, [&](int, std::span<const CutSegment> of_body) { pieces.add_body(of_body, places, frame); });
  return pieces;
}

// Whether one piece bounds a hole where the other one bounds material, or may do so.
bool contradict(const Piece& loose, const Piece& closed) {
  const int product = loose.sense() * closed.sense();
  return product < 0 || (product == 0 && loose.body == closed.body);
}

// Marks the closed pieces that one loose piece makes doubtful: those in which it may be a hole or, if there are none,
// those that may be holes in it.
void doubt(const Piece& loose, std::span<const Piece> closed, std::vector<char>& doubted) {
  std::map<int, std::vector<std::size_t>> around;  // pieces around the loose one, by body
  for (std::size_t c = 0; c < closed.size(); ++c) {
    if (loose.unsure && loose.body == closed[c].body) doubted[c] = 1;
    if (!loose.unsure && closed[c].holds(loose.sample)) around[closed[c].body].push_back(c);
  }
  bool is_hole = false;
  for (const auto& [body, pieces] : around) {
    if (pieces.size() % 2 == 0) continue;  // it lies in a hole
    const std::size_t outermost = *std::max_element(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) {
      return closed[a].around < closed[b].around;
    });
    if (!contradict(loose, closed[outermost])) continue;
    doubted[outermost] = 1;
    is_hole = true;
  }
  if (loose.unsure || is_hole) return;
  for (std::size_t c = 0; c < closed.size(); ++c)
    if (contradict(loose, closed[c]) && loose.holds(closed[c].sample)) doubted[c] = 1;
}

}  // namespace

std::vector<char> doubtful(std::span<const CutSegment> closed, std::span<const CutSegment> loose,
                           const CutPlaces& places, const PlaneFrame& frame) {
  if (closed.empty() || loose.empty()) return std::vector<char>(closed.size(), 0);
  const Pieces sound = pieces_of(closed, places, frame), open = pieces_of(loose, places, frame);
  std::vector<char> doubted(sound.pieces.size(), 0);
  for (const Piece& piece : open.pieces)
    if (piece.unsure || !piece.is_line()) doubt(piece, sound.pieces, doubted);

  // A hole is as doubtful as the piece around it.
  DisjointSets nested(sound.pieces.size());
  for (std::size_t i = 0; i < sound.pieces.size(); ++i)
    for (std::size_t j = 0; j < sound.pieces.size(); ++j)
      if (i != j && sound.pieces[i].body == sound.pieces[j].body && sound.pieces[i].holds(sound.pieces[j].sample))
        nested.join(static_cast<int>(i), static_cast<int>(j));
  std::vector<char> of_nest(sound.pieces.size(), 0);
  for (std::size_t p = 0; p < doubted.size(); ++p)
    if (doubted[p] != 0) of_nest[nested.root(static_cast<int>(p))] = 1;
  std::vector<char> result;
  for (const int piece : sound.of_segment) result.push_back(of_nest[nested.root(piece)]);
  return result;
}

double directed_area(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame) {
  double sum = 0;
  for (const CutSegment& segment : segments) {
    const Vec2 a = frame.flat(places[segment.vertex[0]]), b = frame.flat(places[segment.vertex[1]]);
    sum += segment.sense * signed_area(a, b);
  }
  return sum;
}

}  // namespace epura::cut
