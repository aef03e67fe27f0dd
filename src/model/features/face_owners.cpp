// SPDX-License-Identifier: Apache-2.0
#include "features/face_owners.hpp"

#include <cstddef>

#include "features/cavities.hpp"
#include "features/engraving.hpp"
#include "features/plane_faces.hpp"

namespace epura::features {

namespace {

FaceOwner owner_of(int model, int face, const PlaneFace& plane, const std::vector<Cavity>& cavities,
                   const PartFeatures& features) {
  if (plane.corners.empty()) return {};
  if (const auto cavity = cavity_around(cavities, plane.normal, plane.corners))
    return {cavity->is_hole ? OwnerKind::hole : OwnerKind::slot, cavity->number};
  for (std::size_t i = 0; i < features.hexagons.size(); ++i)
    if (features.hexagons[i].model == model && features.hexagons[i].has_flat(plane.vertices))
      return {OwnerKind::hexagon, static_cast<int>(i)};
  for (std::size_t i = 0; i < features.bevels.size(); ++i)
    if (features.bevels[i].model == model && features.bevels[i].face == face)
      return {OwnerKind::bevel, static_cast<int>(i)};
  return {};
}

}  // namespace

std::vector<FaceOwner> owners_of_faces(const world::World& world, int model, const world::PlacedPart& part,
                                       const PartFeatures& features) {
  const std::vector<char> letters = walls_of_letters(world.models[static_cast<std::size_t>(model)], part);
  const std::vector<PlaneFace> planes = find_plane_faces(world, model, part);
  const std::vector<Cavity> cavities = cavities_of(features, model);
  std::vector<FaceOwner> owners;
  for (std::size_t face = 0; face < part.faces.size(); ++face)
    owners.push_back(letters[face] != 0 ? FaceOwner{OwnerKind::letter}
                                        : owner_of(model, static_cast<int>(face), planes[face], cavities, features));
  return owners;
}

}  // namespace epura::features
