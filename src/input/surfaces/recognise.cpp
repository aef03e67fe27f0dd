// SPDX-License-Identifier: Apache-2.0
#include "surfaces/recognise.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/angle.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "surfaces/blends.hpp"
#include "surfaces/borders.hpp"
#include "surfaces/chords.hpp"
#include "surfaces/clusters.hpp"
#include "surfaces/facets.hpp"
#include "surfaces/free_form.hpp"
#include "surfaces/limits.hpp"
#include "surfaces/region.hpp"
#include "surfaces/round_regions.hpp"

namespace epura::surfaces {

namespace {

/// Converts regions to faces, with lengths in units of the file.
class Result {
 public:
  Result(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
         const std::vector<Region>& regions)
      : mesh_(mesh), facets_(facets), region_of_(region_of), regions_(regions) {}

  [[nodiscard]] PartFaces faces() const {
    PartFaces result;
    result.tolerance = facets_.tolerance / facets_.scale;
    result.faces.resize(regions_.size());
    parallel_for(regions_.size(), grain::heavy, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) result.faces[r] = face_of(regions_[r]);
    });
    result.face_of_triangle.reserve(facets_.facet_of.size());
    for (const int facet : facets_.facet_of) result.face_of_triangle.push_back(region_of_[facet]);
    double area = 0;  // in units in which the area does not overflow, as it might in those of the file
    for (const Region& region : regions_) {
      const bool sure = is_sure(region);
      for (const int f : region.facets) {
        area += facets_.facets[f].area;
        if (sure) result.recognised += facets_.facets[f].area;
      }
    }
    if (area > 0) result.recognised /= area;
    turn_bodies(result);
    return result;
  }

 private:
  // A single triangle beside a smooth edge may be part of anything, and so may any single triangle of a large mesh.
  [[nodiscard]] bool is_sure(const Region& region) const {
    if (region.surface.kind == SurfaceKind::free_form) return false;
    if (region.surface.kind != SurfaceKind::plane || region.facets.size() > 1) return true;
    const int facet = region.facets.front();
    if (facets_.triangles_of(facet).size() > 1) return true;
    if (facets_.facets.size() > max_alone) return false;
    const int t = facets_.triangles_of(facet).front();
    for (int side = 0; side < 3; ++side)
      if (facets_.sides[t][side].neighbour >= 0 && facets_.cosine_of_fold(t, side) > smooth_cosine) return false;
    return true;
  }

  [[nodiscard]] PartFace face_of(const Region& region) const {
    PartFace face;
    const double unit = 1 / facets_.scale;
    face.surface = region.surface;
    face.surface.origin = region.surface.origin * unit + facets_.origin;
    face.surface.radius *= unit;
    face.surface.minor *= unit;
    face.residual = region.residual * unit;
    face.sagitta = region.sagitta * unit;
    face.body = mesh_.body[facets_.triangles_of(region.facets.front()).front()];
    double outwards = 0;
    for (const int f : region.facets) {
      const Facet& facet = facets_.facets[f];
      face.area += facet.area * unit * unit;
      face.triangles += static_cast<int>(facets_.triangles_of(f).size());
      outwards += facet.area * glm::dot(normal_near(region.surface, facet.middle), facet.normal);
    }
    measure_turn(region, face);
    if (region.surface.kind == SurfaceKind::plane && outwards < 0) face.surface.axis = -face.surface.axis;
    if (region.surface.kind != SurfaceKind::plane) face.inwards = outwards < 0;
    return face;
  }

  void measure_turn(const Region& region, PartFace& face) const {
    const SurfaceKind kind = region.surface.kind;
    if (!has_axis(kind)) return;
    std::vector<Vec3> points;
    for (const int f : region.facets)
      for (const int v : facets_.vertices_of(f)) points.push_back(facets_.points[v]);
    const Reach reach = reach_of(region.surface, points, allowance_of(facets_, region.sagitta));
    face.from = reach.from / facets_.scale;
    face.to = reach.to / facets_.scale;
    face.sweep = sweep_around(region.surface, reach, [&](const auto& is_over) {
      return std::any_of(region.facets.begin(), region.facets.end(), [&](int f) {
        const auto triangles = facets_.triangles_of(f);
        return std::any_of(triangles.begin(), triangles.end(), [&](int t) {
          const auto& [a, b, c] = facets_.corners[t];
          return is_over({facets_.points[a], facets_.points[b], facets_.points[c]});
        });
      });
    });
  }

  // If all triangles of a body are oriented the other way, its inside and outside are exchanged.
  void turn_bodies(PartFaces& result) const {
    if (mesh_.body.empty()) return;
    std::vector<double> volume(static_cast<std::size_t>(*std::max_element(mesh_.body.begin(), mesh_.body.end())) + 1);
    for (std::size_t t = 0; t < facets_.corners.size(); ++t) {
      const auto& [a, b, c] = facets_.corners[t];
      volume[mesh_.body[t]] += glm::dot(facets_.points[a], glm::cross(facets_.points[b], facets_.points[c]));
    }
    for (PartFace& face : result.faces) {
      if (!(volume[face.body] < 0)) continue;
      if (face.surface.kind == SurfaceKind::plane)
        face.surface.axis = -face.surface.axis;
      else if (face.surface.kind != SurfaceKind::free_form)
        face.inwards = !face.inwards;
    }
  }

  const mesh::Mesh& mesh_;
  const Facets& facets_;
  const std::vector<int>& region_of_;
  const std::vector<Region>& regions_;
};

// Whether so little of the area lies on round surfaces and in planes of several triangles that no part will be
// recognised.
bool is_scan(const Facets& facets, const std::vector<int>& region_of) {
  if (facets.facets.size() <= max_alone) return false;
  double all = 0, sure = 0;
  for (std::size_t f = 0; f < facets.facets.size(); ++f) {
    all += facets.facets[f].area;
    if (region_of[f] >= 0 || facets.triangles_of(static_cast<int>(f)).size() > 1) sure += facets.facets[f].area;
  }
  return sure < min_recognised * all;
}

// Finds cylinders none of whose facets has all its vertices on the surface, to the precision of the file: CAD kernels
// trim faces along inexact curves, and a fillet between two of these has no other vertices.
Regions find_inexact_cylinders(const Facets& facets, Regions found, const Progress& progress) {
  std::vector<Region>& regions = found.regions;
  std::vector<int>& region_of = found.region_of;
  const auto is_left = [&](int f) { return region_of[f] < 0 && !facets.facets[f].is_plane; };
  std::vector<int> left;
  for (int f = 0; f < static_cast<int>(region_of.size()); ++f) {
    bool goes_on = false;
    if (is_left(f))
      facets.for_sides(f, [&](int t, int side, int other) {
        goes_on = goes_on || (is_left(other) && facets.cosine_of_fold(t, side) > smooth_cosine);
      });
    if (goes_on) left.push_back(f);
  }
  if (left.empty()) return found;
  Facets loose = part_of(facets, left);
  loose.tolerance *= usual_slack;
  const std::size_t first = regions.size();
  for (Region& region : find_round_regions(loose, progress, Wanted::cylinders).regions) {
    if (region.surface.kind != SurfaceKind::cylinder) continue;  // a patch of a free form is nearly a cone
    for (int& f : region.facets) {
      f = left[f];
      region_of[f] = static_cast<int>(regions.size());
    }
    regions.push_back(std::move(region));
  }
  return dissolve_rows(facets, std::move(found), first);
}

}  // namespace

PartFaces recognise_faces(const mesh::Mesh& mesh, const RecogniseOptions& options, const Progress& progress) {
  const Facets facets = make_facets(mesh);
  Regions found = find_round_regions(facets, progress);
  progress.expect_time();
  found = grow_blends(facets, std::move(found));
  // The few flat places of a scan or an artist's mesh do not belong to a part.
  PartFaces nothing{{}, std::vector<int>(mesh.polygon.size(), -1), {}, {}, facets.tolerance / facets.scale, 0};
  if (is_scan(facets, found.region_of)) return nothing;
  found = merge_regions(facets, std::move(found));
  progress.expect_time();
  found = dissolve_rows(facets, std::move(found));
  found = take_chords(facets, std::move(found));
  found = find_inexact_cylinders(facets, std::move(found), progress);
  progress.expect_time();
  found = complete_regions(facets, std::move(found));
  progress.expect_time();
  found = merge_regions(facets, std::move(found));
  PartFaces result = Result(mesh, facets, found.region_of, found.regions).faces();
  nothing.recognised = result.recognised;
  if (result.recognised < min_recognised) return nothing;
  result.borders = find_borders(mesh, facets, found.region_of, found.regions, options.tangent_angle);
  result.border_of_edge.assign(mesh.edges.size(), -1);
  for (std::size_t b = 0; b < result.borders.size(); ++b)
    for (const int edge : result.borders[b].edges) result.border_of_edge[edge] = static_cast<int>(b);
  return result;
}

bool has_shallow_folds(const mesh::Mesh& mesh, double least) {
  const double shallow_min = portable_tan(least * degree);
  const auto normal = [&](int triangle) {
    const auto [a, b, c] = mesh.triangle(triangle);
    return glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
  };
  return std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const mesh::MeshEdge& edge) {
    if (edge.count != 2) return false;
    const auto triangles = mesh.triangles_of(edge);
    const Vec3 one = normal(triangles[0]), two = normal(triangles[1]);
    const double sine = glm::length(glm::cross(one, two)), cosine = std::abs(glm::dot(one, two));
    return sine > shallow_min * cosine && sine < certain_edge_tangent * cosine;
  });
}

}  // namespace epura::surfaces
