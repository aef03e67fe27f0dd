// SPDX-License-Identifier: Apache-2.0
#include "verify/slice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace epura::verify {

namespace {

// A corner of a piece before its position on the page is known.
struct End {
  Vec3 local;
  std::array<int, 2> edge;  ///< {-1, -1}: cut by a depth limit
};

class Cutter {
 public:
  Cutter(const ScanScene& scene, const ScanLine& line)
      : scene_(scene), line_(line), across_(line.across()), offset_(glm::dot(across_, line.middle)) {}

  [[nodiscard]] std::optional<std::array<End, 2>> cut(int triangle) const {
    const auto& corner = scene_.world.triangles[triangle];
    std::array<End, 2> ends;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(corner[i], corner[(i + 1) % 3]);
      if (const auto place = place_on(a, b)) ends[count++] = {*place, {a, b}};
    }
    if (count != 2 || !clip(ends, scene_.max, 1) || !clip(ends, scene_.min, -1)) return std::nullopt;
    return ends;
  }

  [[nodiscard]] std::optional<Vec3> cut_wire(const std::array<int, 2>& wire) const {
    const auto place = place_on(wire[0], wire[1]);
    return place && place->z <= scene_.max && place->z >= scene_.min ? place : std::nullopt;
  }

  [[nodiscard]] double u_of(const Vec3& local) const {
    return glm::dot(line_.along, scene_.to_page(local) - line_.middle);
  }

 private:
  [[nodiscard]] std::optional<Vec3> place_on(int a, int b) const {
    const double at_a = height(a), at_b = height(b);
    if ((at_a >= 0) == (at_b >= 0)) return std::nullopt;
    return scene_.local[a] + at_a / (at_a - at_b) * (scene_.local[b] - scene_.local[a]);
  }

  // Distance from the plane through the line and the viewer, in mm times 1 - k c.
  [[nodiscard]] double height(int vertex) const {
    const Vec3& p = scene_.local[vertex];
    return scene_.page * (across_.x * p.x + across_.y * p.y) - offset_ * (1 - scene_.k * p.z);
  }

  // Keeps the part with sign * c <= sign * limit.
  static bool clip(std::array<End, 2>& ends, double limit, double sign) {
    if (!std::isfinite(limit)) return true;
    const double first = sign * (limit - ends[0].local.z), second = sign * (limit - ends[1].local.z);
    if (first < 0 && second < 0) return false;
    if ((first < 0) == (second < 0)) return true;
    End& outer = ends[first < 0 ? 0 : 1];
    outer.local = ends[0].local + first / (first - second) * (ends[1].local - ends[0].local);
    outer.edge = {-1, -1};
    return true;
  }

  const ScanScene& scene_;
  const ScanLine& line_;
  Vec2 across_;
  double offset_;
};

struct OpenEnd {
  std::array<int, 2> edge;
  PieceEnd at;
  double u, depth;
};

// Sorts crossings along the line, each with all the ends that meet there.
void join(Slice& slice, std::vector<OpenEnd>& open) {
  std::ranges::sort(open, [](const OpenEnd& a, const OpenEnd& b) {
    return std::tie(a.u, a.edge, a.at.piece, a.at.end) < std::tie(b.u, b.edge, b.at.piece, b.at.end);
  });
  for (const OpenEnd& end : open) {
    if (slice.crossings.empty() || slice.crossings.back().edge != end.edge)
      slice.crossings.push_back({end.edge, end.u, end.depth, static_cast<int>(slice.ends.size()), 0});
    ++slice.crossings.back().count;
    slice.ends.push_back(end.at);
    slice.pieces[end.at.piece].crossing[end.at.end] = static_cast<int>(slice.crossings.size()) - 1;
  }
}

}  // namespace

Slice cut(const ScanScene& scene, const ScanLine& line, std::span<const int> triangles) {
  const Cutter cutter(scene, line);
  Slice slice;
  std::vector<OpenEnd> open;
  for (const int triangle : triangles) {
    auto ends = cutter.cut(triangle);
    if (!ends) continue;
    std::array<double, 2> u{cutter.u_of((*ends)[0].local), cutter.u_of((*ends)[1].local)};
    if (!std::isfinite(u[0]) || !std::isfinite(u[1])) continue;
    if (u[0] > u[1]) {
      std::swap(u[0], u[1]);
      std::swap((*ends)[0], (*ends)[1]);
    }
    SlicePiece piece{triangle, u, {scene.depth_of((*ends)[0].local), scene.depth_of((*ends)[1].local)}, {-1, -1}};
    for (int i = 0; i < 2; ++i)
      if ((*ends)[i].edge[0] >= 0)
        open.push_back({(*ends)[i].edge, {static_cast<int>(slice.pieces.size()), i}, piece.u[i], piece.depth[i]});
    slice.pieces.push_back(piece);
  }
  join(slice, open);
  return slice;
}

std::vector<WireCrossing> cut_wires(const ScanScene& scene, const ScanLine& line, std::span<const int> wires) {
  const Cutter cutter(scene, line);
  std::vector<WireCrossing> crossings;
  for (const int number : wires) {
    const std::array<int, 2>& wire = scene.world.wires[static_cast<std::size_t>(number)];
    const auto place = cutter.cut_wire(wire);
    if (!place) continue;
    const double u = cutter.u_of(*place);
    if (std::isfinite(u)) crossings.push_back({wire, u, scene.depth_of(*place)});
  }
  return crossings;
}

}  // namespace epura::verify
