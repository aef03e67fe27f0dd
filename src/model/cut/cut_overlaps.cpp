// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "cut/limits.hpp"
#include "world/congruent.hpp"

namespace epura::cut {

namespace {

using mesh::Outlines;

/// A segment that is divided where others meet it: by parameter from 0 to 1, numbers of places.
struct Divided {
  std::array<int, 2> ends;
  std::vector<std::pair<double, int>> at;
};

// Places of both outlines, and segments of both with all points in which they meet.
class Arrangement {
 public:
  Arrangement(const Outlines& under, const Outlines& over) : under_(under), over_(over), places_(under.places) {
    Vec2 min = under.places.front(), max = min;
    for (const Outlines* one : {&under, &over})
      for (const Vec2& p : one->places) {
        min = glm::min(min, p);
        max = glm::max(max, p);
      }
    same_ = rounding_of_corners * glm::length(max - min);
    std::vector<int> numbers;
    for (const Vec2& p : over.places) numbers.push_back(number_of(p));
    for (const auto& ends : under.segments) own_.push_back(divided(ends));
    for (const auto& [a, b] : over.segments) others_.push_back(divided({numbers[a], numbers[b]}));
    for (Divided& one : own_)
      for (Divided& other : others_) meet(one, other);
  }

  // Parts that have the area on one side only.
  std::optional<OutlinesOutside> outside() {
    OutlinesOutside found;
    Outlines& result = found.outlines;
    for (const bool is_own : {true, false})
      for (Divided& one : is_own ? own_ : others_) {
        std::sort(one.at.begin(), one.at.end());
        for (std::size_t i = 1; i < one.at.size(); ++i) {
          const auto [low, high] = std::minmax(one.at[i - 1].second, one.at[i].second);
          if (low != high && (is_own || !is_known(low, high)) && bounds(low, high))
            result.segments.push_back({low, high});
          if (is_own) known_.push_back({low, high});
        }
        if (!is_own) continue;
        std::vector<int>& chain = found.divided.emplace_back();
        for (const auto& [at, place] : one.at)
          if (chain.empty() || chain.back() != place) chain.push_back(place);
      }
    result.places = std::move(places_);
    std::vector<int> degree(result.places.size(), 0);
    for (const auto& [a, b] : result.segments) {
      ++degree[a];
      ++degree[b];
    }
    if (std::any_of(degree.begin(), degree.end(), [](int count) { return count % 2 == 1; })) return std::nullopt;
    return found;
  }

 private:
  int number_of(const Vec2& p) {
    const auto near = std::find_if(places_.begin(), places_.end(),
                                   [&](const Vec2& other) { return glm::distance(p, other) <= same_; });
    if (near == places_.end()) return places_.push_back(p), static_cast<int>(places_.size()) - 1;
    return static_cast<int>(near - places_.begin());
  }
  static Divided divided(const std::array<int, 2>& ends) { return {ends, {{0, ends[0]}, {1, ends[1]}}}; }

  // Divides a segment at a place if that is on it.
  void divide(Divided& one, int place) const {
    const Vec2 from = places_[one.ends[0]], way = places_[one.ends[1]] - from, to = places_[place] - from;
    const double length = glm::length(way);
    if (!(length > 0)) return;
    const double along = glm::dot(to, way) / length;
    if (along <= same_ || along >= length - same_ || std::abs(cross(way, to)) > same_ * length) return;
    one.at.emplace_back(along / length, place);
  }

  void meet(Divided& one, Divided& other) {
    const Vec2 a = places_[one.ends[0]], b = places_[one.ends[1]], c = places_[other.ends[0]],
               d = places_[other.ends[1]];
    const Vec2 slack(same_);
    if (glm::any(glm::lessThan(glm::max(a, b) + slack, glm::min(c, d))) ||
        glm::any(glm::lessThan(glm::max(c, d) + slack, glm::min(a, b))))
      return;
    for (const int end : other.ends) divide(one, end);
    for (const int end : one.ends) divide(other, end);
    const double turn = cross(b - a, d - c);
    if (std::abs(turn) <= rounding_of_corners * glm::length(b - a) * glm::length(d - c)) return;
    const double s = cross(c - a, d - c) / turn, t = cross(c - a, b - a) / turn;
    if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return;
    const int place = number_of(a + s * (b - a));
    divide(one, place);
    divide(other, place);
  }

  [[nodiscard]] bool is_known(int low, int high) const {
    return std::find(known_.begin(), known_.end(), std::array{low, high}) != known_.end();
  }

  // Whether the area outside is on one side of a part of a segment.
  [[nodiscard]] bool bounds(int low, int high) const {
    const Vec2 from = places_[low], to = places_[high], middle = (from + to) / 2.0;
    const Vec2 off = beside_outline * same_ * left_of(glm::normalize(to - from));
    const auto has = [&](const Vec2& p) { return mesh::is_inside(under_, p) && !mesh::is_inside(over_, p); };
    return has(middle + off) != has(middle - off);
  }

  const Outlines &under_, &over_;
  std::vector<Vec2> places_;
  double same_ = 0;
  std::vector<Divided> own_, others_;
  std::vector<std::array<int, 2>> known_;  ///< parts of the outlines below
};

// Area times centroid.
Vec2 moment_of(const FlatArea& area) { return area.size * area.middle; }

}  // namespace

FlatArea area_of(Outlines outlines) {
  FlatArea area;
  Vec2 moment(0);
  for (const auto& [i, j, k] : mesh::fill_even_odd(outlines)) {
    const Vec2 &a = outlines.places[i], &b = outlines.places[j], &c = outlines.places[k];
    const double size = std::abs(cross(b - a, c - a)) / 2;
    area.size += size;
    moment += size * (a + b + c) / 3.0;
  }
  if (area.size > 0) area.middle = moment / area.size;
  check(area.size >= 0, "no area is negative");
  return area;
}

// Both together are the even-odd area of all outlines and twice what they have in common.
FlatArea common_area(const Outlines& a, const Outlines& b) {
  Outlines all = a;
  const int shift = static_cast<int>(a.places.size());
  all.places.insert(all.places.end(), b.places.begin(), b.places.end());
  for (const auto& [from, to] : b.segments) all.segments.push_back({from + shift, to + shift});
  const FlatArea one = area_of(a), other = area_of(b), apart = area_of(std::move(all));
  FlatArea common;
  common.size = std::max(0.0, (one.size + other.size - apart.size) / 2);
  if (common.size > 0) common.middle = (moment_of(one) + moment_of(other) - moment_of(apart)) / (2 * common.size);
  check(common.size <= std::min(one.size, other.size) * (1 + 1e-6), "what two areas share is in both");
  return common;
}

std::optional<OutlinesOutside> part_outside(const Outlines& under, const Outlines& over) {
  check(!under.segments.empty() && !over.segments.empty(), "areas have outlines");
  return Arrangement(under, over).outside();
}

namespace {

/// The closed outlines of one body in the plane.
struct BodyOutlines {
  ModelCut* cut;
  int body;
  FlatOutlines flat;
  std::vector<Vec2> on_rings{};  ///< a corner of each
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};
};

std::vector<BodyOutlines> outlines_of(std::vector<ModelCut>& cuts) {
  std::vector<BodyOutlines> all;
  for (ModelCut& cut : cuts)
    visit_bodies(cut.cut.segments, [&](int body, std::span<const CutSegment> segments) {
      BodyOutlines& one = all.emplace_back(BodyOutlines{&cut, body, flatten(segments, cut.places(), cut.frame)});
      for (const std::vector<int>& ring : rings_of(segments))
        one.on_rings.push_back(cut.frame.flat(cut.places()[ring.front()]));
      for (const Vec2& p : one.flat.outlines.places) {
        one.min = glm::min(one.min, p);
        one.max = glm::max(one.max, p);
      }
    });
  return all;
}

bool have_boxes_in_common(const BodyOutlines& a, const BodyOutlines& b) {
  return glm::all(glm::lessThan(a.min, b.max)) && glm::all(glm::lessThan(b.min, a.max));
}

/// A segment, from left to right.
using Way = std::array<Vec2, 2>;

// Those of one body that reach into the box of another one, in the order of their left ends.
std::vector<Way> ways_near(const BodyOutlines& one, const BodyOutlines& other) {
  std::vector<Way> ways;
  for (const auto& [from, to] : one.flat.outlines.segments) {
    const Vec2 &a = one.flat.outlines.places[from], &b = one.flat.outlines.places[to];
    if (glm::all(glm::lessThanEqual(glm::min(a, b), other.max)) &&
        glm::all(glm::lessThanEqual(other.min, glm::max(a, b))))
      ways.push_back(a.x < b.x ? Way{a, b} : Way{b, a});
  }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a[0].x < b[0].x; });
  return ways;
}

bool do_cross(const Way& one, const Way& other) {
  const auto side = [](const Way& way, const Vec2& p) { return cross(way[1] - way[0], p - way[0]); };
  return side(one, other[0]) * side(one, other[1]) < 0 && side(other, one[0]) * side(other, one[1]) < 0;
}

// Outlines that do not cross are apart, or rings of one are within the other: most bodies only touch.
bool may_overlap(const BodyOutlines& a, const BodyOutlines& b) {
  const std::vector<Way> ways = ways_near(a, b), others = ways_near(b, a);
  for (std::size_t i = 0, first = 0; i < ways.size(); ++i) {
    while (first < others.size() && others[first][1].x < ways[i][0].x) ++first;
    for (std::size_t k = first; k < others.size() && others[k][0].x <= ways[i][1].x; ++k)
      if (do_cross(ways[i], others[k])) return true;
  }
  const auto is_within = [](const BodyOutlines& inner, const BodyOutlines& outer) {
    return std::any_of(inner.on_rings.begin(), inner.on_rings.end(),
                       [&](const Vec2& p) { return mesh::is_inside(outer.flat.outlines, p); });
  };
  return is_within(a, b) || is_within(b, a);
}

double volume_of(const BodyOutlines& one) {
  const ModelCut& cut = *one.cut;
  std::vector<int> triangles;
  for (std::size_t t = 0; t < cut.mesh().body.size(); ++t)
    if (cut.mesh().body[t] == one.body) triangles.push_back(cut.world.first_triangle[cut.model] + static_cast<int>(t));
  return std::abs(world::shape_of(cut.world, triangles).volume);
}

// Whether the first of two bodies is between parts of the other one, as a screw is in its hole, or else the smaller
// one.
bool is_inner(const BodyOutlines& one, const BodyOutlines& other, const Vec2& middle) {
  const bool is_in_one = mesh::is_inside(one.flat.outlines, middle),
             is_in_other = mesh::is_inside(other.flat.outlines, middle);
  return is_in_one == is_in_other ? volume_of(one) < volume_of(other) : is_in_one;
}

// By their ends, the lower vertex first.
std::map<std::array<int, 2>, std::vector<int>> chains_of(std::span<const std::vector<int>> divided,
                                                         const std::vector<int>& vertices) {
  std::map<std::array<int, 2>, std::vector<int>> chains;
  for (const std::vector<int>& places : divided) {
    std::vector<int> chain;
    for (const int place : places) chain.push_back(vertices[place]);
    if (chain.front() > chain.back()) std::reverse(chain.begin(), chain.end());
    chains[{chain.front(), chain.back()}] = std::move(chain);
  }
  return chains;
}

// Leaves the part of a body's cut outside that of another one; returns whether that is closed.
bool leave_outside(BodyOutlines& under, const BodyOutlines& over) {
  const auto rest = part_outside(under.flat.outlines, over.flat.outlines);
  if (!rest) return false;
  ModelCut& cut = *under.cut;
  std::vector<int>& vertices = under.flat.vertices;
  for (std::size_t i = vertices.size(); i < rest->outlines.places.size(); ++i) {
    vertices.push_back(cut.file_vertices() + static_cast<int>(cut.cut.points.size()));
    cut.cut.points.push_back(cut.frame.in_space(rest->outlines.places[i]));
    cut.cut.vertices.push_back({{-1, -1}, 0});
  }
  cut.divide_sides(chains_of(rest->divided, vertices));
  std::erase_if(cut.cut.segments, [&](const CutSegment& segment) { return segment.body == under.body; });
  for (const auto& [a, b] : rest->outlines.segments) {
    const auto [low, high] = std::minmax(vertices[a], vertices[b]);
    cut.cut.segments.push_back({under.body, {low, high}});
  }
  std::sort(cut.cut.segments.begin(), cut.cut.segments.end());
  under.flat.outlines = std::move(rest->outlines);
  check(vertices.size() == under.flat.outlines.places.size(), "every place of an outline is a vertex");
  return true;
}

}  // namespace

std::vector<OverlappingBodies> settle_overlaps(std::vector<ModelCut>& cuts, const Progress& progress) {
  std::vector<OverlappingBodies> found;
  std::vector<BodyOutlines> all = outlines_of(cuts);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      BodyOutlines *over = &all[i], *under = &all[j];
      if (!have_boxes_in_common(*over, *under)) continue;
      progress.expect_time();
      if (!may_overlap(*over, *under)) continue;
      const FlatArea common = common_area(over->flat.outlines, under->flat.outlines);
      const double least = std::min(area_of(over->flat.outlines).size, area_of(under->flat.outlines).size);
      if (!(common.size > least_overlap * least)) continue;
      if (is_inner(*under, *over, common.middle)) std::swap(over, under);
      if (!leave_outside(*under, *over)) continue;
      const PlaneFrame& frame = over->cut->frame;
      found.push_back({over->cut->model, over->body, under->cut->model, under->body,
                       common.size / (frame.normalisation * frame.normalisation), frame.in_space(common.middle)});
    }
  return found;
}

}  // namespace epura::cut
