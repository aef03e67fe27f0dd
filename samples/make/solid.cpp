// SPDX-License-Identifier: Apache-2.0
#include "solid.hpp"

#include <cmath>
#include <stdexcept>

#include "triangulate.hpp"

namespace samples {

namespace {

double rounded(double x) { return std::round(x * 1e6) / 1e6 + 0.0; }  // + 0.0 turns -0 into 0

bool convex(const Loop& loop, const Point& normal) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point& b = loop[(i + 1) % n];
    if (dot(cross(b - loop[i], loop[(i + 2) % n] - b), normal) <= 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

Loop Solid::corners(const std::vector<int>& face) const {
  Loop loop;
  for (const int i : face) {
    loop.push_back(points_[i]);
  }
  return loop;
}

std::vector<int> Solid::indices(const Loop& loop) {
  std::vector<int> result;
  for (const Point& p : loop) {
    const Point q = {rounded(p[0]), rounded(p[1]), rounded(p[2])};
    const auto [place, is_new] = number_of_.try_emplace(q, static_cast<int>(points_.size()));
    if (is_new) {
      points_.push_back(q);
    }
    result.push_back(place->second);
  }
  return result;
}

void Solid::face(const Loop& outer, const std::vector<Loop>& holes) {
  const std::vector<int> boundary = indices(outer);
  const Point normal = area_vector(corners(boundary));
  if (holes.empty() && convex(corners(boundary), normal)) {
    faces_.push_back(boundary);
    return;
  }
  std::vector<std::vector<int>> inner;
  for (const Loop& hole : holes) {
    inner.push_back(indices(dot(area_vector(hole), normal) > 0 ? reversed(hole) : hole));
  }
  for (const auto& triangle : triangulate(points_, boundary, inner, normal)) {
    faces_.emplace_back(triangle.begin(), triangle.end());
  }
}

void Solid::strip(const Loop& from, const Loop& to) {
  if (from.size() != to.size()) {
    throw std::logic_error("a strip needs loops of as many points");
  }
  const std::vector<int> a = indices(from);
  const std::vector<int> b = indices(to);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = (i + 1) % a.size();
    if (is_planar(corners({a[i], a[j], b[j], b[i]}))) {
      faces_.push_back({a[i], a[j], b[j], b[i]});
    } else {
      faces_.push_back({a[i], a[j], b[j]});
      faces_.push_back({a[i], b[j], b[i]});
    }
  }
}

void Solid::rings(const std::vector<Loop>& loops, bool closed) {
  for (std::size_t i = 0; i + 1 < loops.size(); ++i) {
    strip(loops[i], loops[i + 1]);
  }
  if (closed) {
    strip(loops.back(), loops.front());
  } else {
    face(reversed(loops.front()));
    face(loops.back());
  }
}

void Solid::prism(const Loop& base, const Point& step, const std::vector<Loop>& holes) {
  std::vector<Loop> top_holes;
  for (const Loop& hole : holes) {
    top_holes.push_back(shifted(hole, step));
    strip(top_holes.back(), hole);
  }
  face(reversed(base), holes);
  face(shifted(base, step), top_holes);
  strip(base, shifted(base, step));
}

}  // namespace samples
