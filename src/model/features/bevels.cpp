// SPDX-License-Identifier: Apache-2.0
#include "features/bevels.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/range.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

/// What a slope meets at one of its ends.
struct Neighbour {
  std::size_t face;  ///< a plane
  bool rounded;      ///< across an arc
};

class BevelFinder {
 public:
  explicit BevelFinder(const ModelFaces& faces) : faces_(faces), slack_(1e-5 * glm::length(faces.world.box.size())) {}

  [[nodiscard]] std::optional<BevelFeature> bevel_of(std::size_t face, int along) const {
    const PlaneFace& plane = faces_.planes[face];
    const Vec3 up = glm::normalize(glm::cross(Mat3(1)[along], plane.normal));
    const Range reach = reach_of(face, up);
    BevelFeature bevel{faces_.model, along, {}, {-1, -1}, faces_.part.faces[face].area};
    bevel.normal = plane.normal;
    bevel.face = static_cast<int>(face);
    std::array<std::size_t, 2> neighbours{};
    for (const std::size_t end : {0U, 1U}) {
      const double at = end == 0 ? reach.from : reach.to;
      const std::optional<Neighbour> next = neighbour_at(face, along, up, at);
      if (!next) return std::nullopt;
      neighbours[end] = next->face;
      bevel.across[end] = axis_along(faces_.planes[next->face].normal);
      bevel.rounded[end] = next->rounded;
      bevel.ends[end] = next->rounded ? meeting_of(face, next->face, along) : corner_at(face, up, at);
    }
    // The flanks of a lever meet in one corner, beyond the eyes at both ends, of whose places and radii they follow.
    const bool is_flank = bevel.rounded[0] && bevel.rounded[1] && neighbours[0] == neighbours[1];
    if (is_flank || (bevel.across[0] < 0 && bevel.across[1] < 0)) return std::nullopt;
    bevel.ends[1][along] = bevel.ends[0][along];
    bevel.is_chamfer = is_chamfer(bevel, neighbours);
    return bevel;
  }

 private:
  [[nodiscard]] Range reach_of(std::size_t face, const Vec3& direction) const {
    Range reach;
    for (const Vec3& p : faces_.planes[face].corners) reach.add(glm::dot(p, direction));
    return reach;
  }

  [[nodiscard]] Vec3 corner_at(std::size_t face, const Vec3& up, double at) const {
    const std::vector<Vec3>& corners = faces_.planes[face].corners;
    return *std::min_element(corners.begin(), corners.end(), [&](const Vec3& p, const Vec3& q) {
      return std::abs(glm::dot(p, up) - at) < std::abs(glm::dot(q, up) - at);
    });
  }

  [[nodiscard]] bool is_corner(std::size_t face, const Vec3& p) const {
    const std::vector<Vec3>& corners = faces_.planes[face].corners;
    return std::find(corners.begin(), corners.end(), p) != corners.end();
  }

  // A plane along the same axis that is not parallel to the face.
  [[nodiscard]] bool is_across(std::size_t face, std::size_t other, int along) const {
    const PlaneFace& plane = faces_.planes[other];
    return other != face && !plane.corners.empty() && std::abs(plane.normal[along]) <= parallel &&
           !are_parallel(plane.normal, faces_.planes[face].normal);
  }

  // The plane behind the end of a face, with which it shares an edge there.
  [[nodiscard]] std::optional<Neighbour> neighbour_at(std::size_t face, int along, const Vec3& up, double at) const {
    const auto is_at_end = [&](const Vec3& p) { return std::abs(glm::dot(p, up) - at) <= slack_; };
    for (const FaceBorder& next : faces_.borders[face]) {
      const auto other = static_cast<std::size_t>(next.other);
      if (!is_across(face, other, along)) continue;
      const std::vector<Vec3>& corners = faces_.planes[other].corners;
      const auto shared = std::count_if(corners.begin(), corners.end(),
                                        [&](const Vec3& p) { return is_at_end(p) && is_corner(face, p); });
      if (shared >= 2) return Neighbour{other, false};
    }
    return neighbour_behind_arc(face, along, up, at);
  }

  [[nodiscard]] std::optional<Neighbour> neighbour_behind_arc(std::size_t face, int along, const Vec3& up,
                                                              double at) const {
    for (const FaceBorder& round : faces_.borders[face]) {
      const surfaces::PartSurface& surface = faces_.part.faces[static_cast<std::size_t>(round.other)].surface;
      if (!round.tangent || surface.kind != SurfaceKind::cylinder || axis_along(surface.axis) != along) continue;
      // It touches the plane where its axis stands above it.
      if (std::abs(glm::dot(surface.origin, up) - at) > same_size * surface.radius + slack_) continue;
      for (const FaceBorder& next : faces_.borders[static_cast<std::size_t>(round.other)])
        if (const auto other = static_cast<std::size_t>(next.other); next.tangent && is_across(face, other, along))
          return Neighbour{other, true};
    }
    return std::nullopt;
  }

  // Where two planes along an axis of the world meet.
  [[nodiscard]] Vec3 meeting_of(std::size_t face, std::size_t other, int along) const {
    const Vec3 &n = faces_.planes[face].normal, &m = faces_.planes[other].normal, axis = Mat3(1)[along];
    const Vec3 p = faces_.planes[face].corners.front(), q = faces_.planes[other].corners.front();
    const Vec3 line = glm::cross(n, m);
    Vec3 point = (glm::dot(n, p) * glm::cross(m, line) + glm::dot(m, q) * glm::cross(line, n)) / glm::dot(line, line);
    point += (p[along] - point[along]) * axis;
    return point;
  }

  // Of 45 degrees, and not larger than what it leaves of the faces at the corner that it takes off.
  [[nodiscard]] bool is_chamfer(const BevelFeature& bevel, const std::array<std::size_t, 2>& neighbours) const {
    if (bevel.across[0] < 0 || bevel.across[1] < 0 || bevel.across[0] == bevel.across[1]) return false;
    if (bevel.rounded[0] || bevel.rounded[1]) return false;
    const int b = bevel.across[0], c = bevel.across[1];
    const Vec3 span = bevel.ends[1] - bevel.ends[0];
    if (std::abs(std::abs(span[b]) - std::abs(span[c])) > slack_) return false;
    Vec3 corner = bevel.ends[0];
    corner[c] = bevel.ends[1][c];
    if (glm::dot(corner - bevel.ends[0], bevel.normal) <= 0) return false;
    return std::abs(span[c]) <= reach_of(neighbours[0], Mat3(1)[c]).size() &&
           std::abs(span[b]) <= reach_of(neighbours[1], Mat3(1)[b]).size();
  }

  const ModelFaces& faces_;
  double slack_;
};

}  // namespace

double BevelFeature::leg() const { return std::abs(ends[1][(along + 1) % 3] - ends[0][(along + 1) % 3]); }

std::vector<BevelFeature> find_bevels(const ModelFaces& faces, const std::function<bool(std::size_t)>& is_other) {
  const BevelFinder finder(faces);
  std::vector<BevelFeature> bevels;
  for (std::size_t f = 0; f < faces.planes.size(); ++f) {
    const Vec3& normal = faces.planes[f].normal;
    if (faces.planes[f].corners.empty() || axis_along(normal) >= 0 || is_other(f)) continue;
    for (int along = 0; along < 3; ++along)
      if (std::abs(normal[along]) <= parallel)
        if (const auto bevel = finder.bevel_of(f, along)) bevels.push_back(*bevel);
  }
  return bevels;
}

}  // namespace epura::features
