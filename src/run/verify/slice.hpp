// SPDX-License-Identifier: Apache-2.0
// The scene over one line of the page: its section by the plane through that line and the viewer.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "verify/scan_scene.hpp"

namespace epura::verify {

/// The segment in which the plane cuts a triangle, from left to right along the line.
struct SlicePiece {
  int triangle;
  std::array<double, 2> u, depth;  ///< of the ends, mm
  std::array<int, 2> crossing;     ///< ends as indices of Slice::crossings; -1: a depth limit cut the triangle

  [[nodiscard]] double width() const { return u[1] - u[0]; }
  [[nodiscard]] double slope() const { return (depth[1] - depth[0]) / width(); }
  /// From the nearer end: beside the viewer, the other one may lie a billion metres away.
  [[nodiscard]] double depth_at(double at) const {
    const std::size_t end = at - u[0] <= u[1] - at ? 0 : 1;
    return depth[end] + (at - u[end]) / width() * (depth[1] - depth[0]);
  }
};

/// Where the plane cuts an edge of the mesh; computed once for all triangles of the edge.
struct SliceCrossing {
  std::array<int, 2> edge;  ///< vertices of the world, ascending
  double u, depth;
  int first, count;  ///< range of its ends in Slice::ends
};

/// Where the plane cuts a wire.
struct WireCrossing {
  std::array<int, 2> wire;  ///< vertices of the world, ascending
  double u, depth;
};

struct PieceEnd {
  int piece, end;
};

struct Slice {
  std::vector<SlicePiece> pieces;
  std::vector<SliceCrossing> crossings;  ///< ascending in u
  std::vector<PieceEnd> ends;            ///< grouped by crossing: the ends of pieces that meet there

  [[nodiscard]] std::span<const PieceEnd> ends_at(int crossing) const {
    return {ends.data() + crossings[crossing].first, static_cast<std::size_t>(crossings[crossing].count)};
  }
};

Slice cut(const ScanScene& scene, const ScanLine& line, std::span<const int> triangles);

/// Of the wires of the world with these numbers, in their order.
std::vector<WireCrossing> cut_wires(const ScanScene& scene, const ScanLine& line, std::span<const int> wires);

}  // namespace epura::verify
