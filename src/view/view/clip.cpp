// SPDX-License-Identifier: Apache-2.0
#include "view/clip.hpp"

#include <algorithm>

namespace epura::view {

namespace {

std::uint64_t key_of(int a, int b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

}  // namespace

int Clipper::add_plane(const ClipPlane& plane) {
  planes_.push_back(plane);
  cuts_.emplace_back();
  return static_cast<int>(planes_.size()) - 1;
}

double Clipper::cut_parameter(int plane, int a, int b) const {
  const double at_a = planes_[plane](vertices[a]);
  const double at_b = planes_[plane](vertices[b]);
  return at_a / (at_a - at_b);
}

int Clipper::cut(int plane, int a, int b) {
  const auto [place, made] = cuts_[plane].try_emplace(key_of(a, b), static_cast<int>(vertices.size()));
  if (made) {
    const Mapped p = vertices[std::min(a, b)];
    const Mapped q = vertices[std::max(a, b)];
    // Weights instead of a step from p to q: where both sides have terms of one sign, as distances do, no digits
    // cancel.
    const double at_p = planes_[plane](p), at_q = planes_[plane](q);
    const double of_p = at_q / (at_q - at_p), of_q = at_p / (at_p - at_q);
    vertices.push_back({of_p * p.x + of_q * q.x, of_p * p.y + of_q * q.y, of_p * p.z + of_q * q.z,  //
                        of_p * p.w + of_q * q.w});
  }
  return place->second;
}

std::vector<int> Clipper::clip_ring(std::vector<int> polygon, std::span<const int> planes) {
  std::vector<int> kept;
  for (const int plane : planes) {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = polygon[i];
      const int b = polygon[(i + 1) % polygon.size()];
      if (inside(plane, a)) kept.push_back(a);
      if (inside(plane, a) != inside(plane, b)) kept.push_back(cut(plane, a, b));
    }
    polygon.swap(kept);
    if (polygon.size() < 3) return {};
  }
  return polygon;
}

void Clipper::clip_triangle(const std::array<int, 3>& corners, std::span<const int> planes,
                            std::vector<std::array<int, 3>>& pieces) {
  const std::vector<int> polygon = clip_ring({corners.begin(), corners.end()}, planes);
  for (std::size_t i = 2; i < polygon.size(); ++i) pieces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

std::optional<ClippedEdge> Clipper::clip_edge(int a, int b, std::span<const int> planes) {
  ClippedEdge edge{{a, b}, {0, 1}};
  for (const int plane : planes) {
    const bool first = inside(plane, edge.vertex[0]);
    const bool second = inside(plane, edge.vertex[1]);
    if (!first && !second) return std::nullopt;
    if (first && second) continue;
    const double s = cut_parameter(plane, edge.vertex[0], edge.vertex[1]);
    const int outside = first ? 1 : 0;
    edge.t[outside] = edge.t[0] + s * (edge.t[1] - edge.t[0]);
    edge.vertex[outside] = cut(plane, edge.vertex[0], edge.vertex[1]);
  }
  return edge;
}

}  // namespace epura::view
