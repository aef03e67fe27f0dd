// SPDX-License-Identifier: Apache-2.0
#include "drawing/cut_covers.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/even_odd.hpp"

namespace epura::drawing {

namespace {

constexpr double least_overlap = 0.1;  // mm; what overlaps less is due to facets and fits

struct FaceBox {
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};

  [[nodiscard]] double area() const { return (max.x - min.x) * (max.y - min.y); }
};

FaceBox box_of(const CutFace& face) {
  FaceBox box;
  for (const std::vector<Vec2>& ring : face.rings)
    for (const Vec2& p : ring) box = {glm::min(box.min, p), glm::max(box.max, p)};
  return box;
}

bool do_overlap(const FaceBox& a, const FaceBox& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// Calls visit(a, b) for the sides of the outlines while it returns true.
template <class Visit>
bool visit_sides(const CutFace& face, const Visit& visit) {
  for (const std::vector<Vec2>& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (!visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0])) return false;
  return true;
}

double distance_to_side(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = glm::dot(along, along);
  const double part = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
  return glm::distance(p, a + part * along);
}

bool is_deep_inside(const CutFace& face, const Vec2& p) {
  bool inside = false;
  const bool is_far = visit_sides(face, [&](const Vec2& a, const Vec2& b) {
    if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) inside = !inside;
    return distance_to_side(p, a, b) > least_overlap;
  });
  return is_far && inside;
}

bool reaches_into(const CutFace& one, const CutFace& other) {
  return !visit_sides(one, [&](const Vec2& a, const Vec2& b) {
    return !is_deep_inside(other, a) && !is_deep_inside(other, (a + b) / 2.0);
  });
}

// What is much smaller is inserted into the other one; of two that pass through each other, the one that comes later.
bool is_under(const std::vector<FaceBox>& boxes, std::size_t i, std::size_t j) {
  constexpr double much = 2;
  const double one = boxes[i].area(), other = boxes[j].area();
  return one >= much * other || (i < j && other < much * one);
}

}  // namespace

std::vector<CoveredFace> covered_faces(std::span<const CutFace> faces) {
  std::vector<FaceBox> boxes;
  for (const CutFace& face : faces) boxes.push_back(box_of(face));
  std::vector<CoveredFace> covered;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = 0; j < faces.size(); ++j) {
      if (i == j || !is_under(boxes, i, j) || !do_overlap(boxes[i], boxes[j])) continue;
      if (reaches_into(faces[i], faces[j]) || reaches_into(faces[j], faces[i])) covered.push_back({i, j});
    }
  return covered;
}

std::vector<PaperTriangle> triangles_of(const CutFace& face) {
  mesh::Outlines outlines;
  for (const std::vector<Vec2>& ring : face.rings) {
    const int first = static_cast<int>(outlines.places.size()), count = static_cast<int>(ring.size());
    outlines.places.insert(outlines.places.end(), ring.begin(), ring.end());
    for (int i = 0; i < count; ++i) outlines.segments.push_back({first + i, first + (i + 1) % count});
  }
  std::vector<PaperTriangle> triangles;
  for (const auto& corners : mesh::fill_even_odd(outlines)) {
    PaperTriangle& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = outlines.places[static_cast<std::size_t>(corners[i])];
  }
  return triangles;
}

std::vector<std::array<double, 2>> parts_inside(const CutFace& face, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  std::vector<double> crossings{0, 1};
  visit_sides(face, [&](const Vec2& a, const Vec2& b) {
    const double before = cross(way, a - from), behind = cross(way, b - from);
    if ((before > 0) == (behind > 0)) return true;
    const Vec2 at = a + before / (before - behind) * (b - a);
    const double part = glm::dot(at - from, way) / glm::dot(way, way);
    if (part > 0 && part < 1) crossings.push_back(part);
    return true;
  });
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::array<double, 2>> parts;
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const double begin = crossings[i - 1], end = crossings[i];
    if (!(begin < end) || !is_deep_inside(face, from + (begin + end) / 2 * way)) continue;
    if (!parts.empty() && parts.back()[1] == begin)
      parts.back()[1] = end;
    else
      parts.push_back({begin, end});
  }
  return parts;
}

}  // namespace epura::drawing
