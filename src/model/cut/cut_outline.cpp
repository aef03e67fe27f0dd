// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_outline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace epura::cut {

namespace {

using Pair = std::array<int, 2>;

// Labels triangles: those connected through sides without an outline have one label, the number of one of them.
std::vector<int> patches(std::span<const std::array<int, 3>> triangles, std::span<const CutSegment> segments) {
  std::vector<std::pair<Pair, int>> sides;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      sides.push_back({{low, high}, static_cast<int>(t)});
    }
  std::sort(sides.begin(), sides.end());
  DisjointSets joined(triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Pair& side = sides[i].first;
    if (side != sides[i - 1].first) continue;
    const auto found = std::lower_bound(segments.begin(), segments.end(), side,
                                        [](const CutSegment& s, const Pair& vertex) { return s.vertex < vertex; });
    if (found != segments.end() && found->vertex == side) continue;
    joined.join(sides[i].second, sides[i - 1].second);
  }
  return std::move(joined).roots();
}

}  // namespace

PlaneFrame::PlaneFrame(const world::World& world, const scene::CuttingPlane& cutting_plane, double normalisation_factor)
    : plane(cutting_plane), normalisation(normalisation_factor), origin(world.box.centre() * normalisation_factor) {
  origin += glm::dot(plane.normal, plane.point * normalisation - origin) * plane.normal;
}

FlatOutlines flatten(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame) {
  FlatOutlines flat;
  for (const CutSegment& segment : segments)
    flat.vertices.insert(flat.vertices.end(), segment.vertex.begin(), segment.vertex.end());
  std::sort(flat.vertices.begin(), flat.vertices.end());
  flat.vertices.erase(std::unique(flat.vertices.begin(), flat.vertices.end()), flat.vertices.end());
  const auto number_of = [&](int vertex) {
    const auto found = std::lower_bound(flat.vertices.begin(), flat.vertices.end(), vertex);
    return static_cast<int>(found - flat.vertices.begin());
  };
  for (const int vertex : flat.vertices) flat.outlines.places.push_back(frame.flat(places[vertex]));
  for (const CutSegment& segment : segments)
    flat.outlines.segments.push_back({number_of(segment.vertex[0]), number_of(segment.vertex[1])});
  return flat;
}

std::vector<std::vector<int>> rings_of(std::span<const CutSegment> segments) {
  std::vector<Pair> ends;  // vertex, segment
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const int vertex : segments[s].vertex) ends.push_back({vertex, static_cast<int>(s)});
  std::sort(ends.begin(), ends.end());
  std::vector<bool> used(segments.size(), false);
  // The other end of an unused segment at this vertex.
  const auto go_on = [&](int vertex) {
    auto end = std::lower_bound(ends.begin(), ends.end(), Pair{vertex, 0});
    while (used[(*end)[1]]) ++end;
    used[(*end)[1]] = true;
    const auto& [a, b] = segments[(*end)[1]].vertex;
    return a == vertex ? b : a;
  };
  std::vector<std::vector<int>> rings;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (used[s]) continue;
    const int start = segments[s].vertex[0];
    std::vector<int>& ring = rings.emplace_back();
    int at = start;
    do {
      ring.push_back(at);
      at = go_on(at);
    } while (at != start);
  }
  return rings;
}

std::vector<bool> lie_inside(std::span<const std::array<int, 3>> triangles, std::span<const CutSegment> segments,
                             const CutPlaces& places, const PlaneFrame& frame) {
  const mesh::Outlines outlines = flatten(segments, places, frame).outlines;
  const std::vector<int> label = patches(triangles, segments);
  std::vector<std::pair<double, Vec2>> largest(triangles.size(), {-1, Vec2(0)});  // by label: area and centroid
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [i, j, k] = triangles[t];
    const Vec2 a = frame.flat(places[i]), b = frame.flat(places[j]), c = frame.flat(places[k]);
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (area > largest[label[t]].first) largest[label[t]] = {area, (a + b + c) / 3.0};
  }
  std::vector<bool> inside(triangles.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (label[t] == static_cast<int>(t)) inside[t] = mesh::is_inside(outlines, largest[t].second);
  for (std::size_t t = 0; t < triangles.size(); ++t) inside[t] = inside[label[t]];
  return inside;
}

}  // namespace epura::cut
