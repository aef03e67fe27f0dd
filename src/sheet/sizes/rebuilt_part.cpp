// SPDX-License-Identifier: Apache-2.0
#include "sizes/rebuilt_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "definition/rebuild.hpp"
#include "definition/words.hpp"
#include "sizes/sheet_reading.hpp"
#include "surfaces/numbers.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using definition::Unknowns;
using surfaces::PartSurface;

constexpr double beside = 0.01;     // relative to the size of the part, or in radians
constexpr double of_radius = 0.1;   // of the smallest radius at most: beyond it, another surface may be meant
constexpr double one_place = 1e-6;  // relative to it: faces that far apart are one

/// The triangles of the model, with the faces around each corner.
struct Corners {
  std::vector<Vec3> at;
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 3>> triangles;
};

Corners corners_of(const world::World& world) {
  const std::vector<int> face_of = world::faces_of_triangles(world.models[0]);
  Corners corners{{world.points.begin(), world.points.end()},
                  std::vector<std::vector<int>>(world.points.size()),
                  {world.triangles.begin(), world.triangles.end()}};
  for (std::size_t t = 0; t < corners.triangles.size(); ++t)
    for (const int corner : corners.triangles[t]) {
      std::vector<int>& faces = corners.faces[static_cast<std::size_t>(corner)];
      if (face_of[t] >= 0 && std::find(faces.begin(), faces.end(), face_of[t]) == faces.end())
        faces.push_back(face_of[t]);
    }
  return corners;
}

std::vector<PartSurface> surfaces_of(const Unknowns& changed, std::size_t count) {
  std::vector<PartSurface> surfaces;
  for (std::size_t face = 0; face < count; ++face) surfaces.push_back(changed.changed(static_cast<int>(face)));
  return surfaces;
}

// Where the faces around a corner meet now, near to where it was: by going to one after the other.
Vec3 moved_corner(Vec3 at, const std::vector<int>& faces, const std::vector<PartSurface>& surfaces) {
  constexpr int rounds = 50;
  for (int round = 0; round < rounds; ++round)
    for (const int face : faces) {
      const PartSurface& surface = surfaces[static_cast<std::size_t>(face)];
      if (surface.kind == surfaces::SurfaceKind::free_form) continue;
      const surfaces::Nearness near = surfaces::nearness_of(surface, at);
      at -= near.distance * near.normal;
    }
  return at;
}

double volume_of(const std::vector<Vec3>& at, const std::vector<std::array<int, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += glm::dot(at[static_cast<std::size_t>(a)],
                    glm::cross(at[static_cast<std::size_t>(b)], at[static_cast<std::size_t>(c)]));
  return sum / 6;
}

// The largest |off(face, corner)| of each face.
template <class Off>
std::vector<double> largest_at(const Corners& corners, const std::vector<PartSurface>& surfaces, const Off& off_at) {
  std::vector<double> largest(surfaces.size(), 0.0);
  for (std::size_t i = 0; i < corners.at.size(); ++i)
    for (const int number : corners.faces[i])
      if (const auto face = static_cast<std::size_t>(number); surfaces[face].kind != surfaces::SurfaceKind::free_form)
        largest[face] = std::max(largest[face], std::abs(off_at(face, corners.at[i])));
  return largest;
}

double perturbation(const definition::Part& part) {
  double off = beside;
  for (const definition::Face& face : part.faces) {
    const PartSurface& surface = face.surface;
    const double radius = surface.kind == surfaces::SurfaceKind::torus ? surface.minor : surface.radius;
    const bool is_round = surface.kind == surfaces::SurfaceKind::torus ||
                          surface.kind == surfaces::SurfaceKind::cylinder ||
                          surface.kind == surfaces::SurfaceKind::sphere;
    if (is_round) off = std::min(off, of_radius * radius / part.size);
  }
  check(off > 0, "radii are above 0");
  return off;
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

std::optional<RebuiltPart> rebuild_part(std::span<const DimensionsInView> views, const world::World& world,
                                        const std::array<features::Extent, 3>& extents, const Notation& notation,
                                        const definition::RuleSet& rules) {
  std::optional<DrawnPart> on_sheets = part_on_sheets(views, world, extents);
  if (!on_sheets) return std::nullopt;
  if (on_sheets->faces > most_faces)
    throw Error(ErrorKind::input, "the model",
                "it has " + std::to_string(on_sheets->faces) + " faces, of which at most " +
                    std::to_string(most_faces) + " are found again",
                "rebuild one of its parts");
  const SheetReading reading(std::move(*on_sheets), views, notation);
  const DrawnPart* drawn = &reading.drawn;
  const Unknowns& unknowns = reading.unknowns;
  RebuiltPart found;
  const std::vector<definition::Row> base = definition::base_rows(drawn->part, unknowns, reading.account(rules).states);
  const DimensionNames names(views, notation);
  for (const DimensionPlace& place : reading.said.unread) found.unread.push_back(names.name_of(place));
  const auto state_all = [&](const Unknowns& changed) {
    std::vector<definition::Statement> all = reading.rules(rules, changed);
    FaceStatements now = state_dimensions(views, *drawn, reading.directions, changed, notation);
    std::ranges::move(definition::with_counts(std::move(now.statements), rules), std::back_inserter(all));
    return all;
  };
  const Corners corners = corners_of(world);
  check(corners.at.size() == corners.faces.size(), "each corner has its faces");
  const world::Placed& placed = world.models[0];
  const std::vector<int> numbers = surfaces::numbers_in(
      surfaces::numbered_faces(*placed.part, surfaces::middles_of_faces(placed.mesh->whole(), *placed.part)));
  const auto surfaces_at = [&](const std::vector<double>& values) {
    return surfaces_of(unknowns.changed_by(values), drawn->faces);
  };
  const auto farthest = [&corners](const std::vector<PartSurface>& surfaces) {
    return largest_of(largest_at(corners, surfaces, [&](std::size_t face, const Vec3& corner) {
      return surfaces::signed_distance(surfaces[face], corner);
    }));
  };
  const double off = perturbation(drawn->part);
  std::vector<std::vector<PartSurface>> results;
  for (const unsigned seed : {1U, 2U}) {
    const definition::Rebuilt one = definition::rebuild(unknowns, base, state_all, off, seed);
    found.is_settled = found.is_settled && one.is_settled;
    found.perturbed = std::max(found.perturbed, farthest(surfaces_at(one.begun)));
    results.push_back(surfaces_at(one.values));
    found.deviation = std::max(found.deviation, farthest(results.back()));
  }
  const std::vector<double> spread = largest_at(corners, results[0], [&results](std::size_t face, const Vec3& corner) {
    return surfaces::signed_distance(results[0][face], corner) - surfaces::signed_distance(results[1][face], corner);
  });
  found.spread = largest_of(spread);
  const auto length = [&](double value) { return length_text(value, notation); };
  found.faces = static_cast<int>(drawn->faces);
  for (std::size_t face = 0; face < drawn->faces; ++face) {
    const definition::Face& one = drawn->part.faces[face];
    if (one.surface.kind == surfaces::SurfaceKind::free_form) ++found.by_model;
    if (found.is_settled && spread[face] > one_place * drawn->part.size)
      found.free.push_back({definition::name_of_face(one, length, numbers[face]), numbers[face], spread[face]});
  }
  std::stable_sort(found.free.begin(), found.free.end(),
                   [](const OffFace& a, const OffFace& b) { return a.off > b.off; });
  std::vector<Vec3> moved;
  for (std::size_t i = 0; i < corners.at.size(); ++i)
    moved.push_back(moved_corner(corners.at[i], corners.faces[i], results[0]));
  found.of_part = volume_of(corners.at, corners.triangles);
  found.volume = volume_of(moved, corners.triangles);
  return found;
}

}  // namespace epura::sheet
