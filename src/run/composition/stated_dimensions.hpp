// SPDX-License-Identifier: Apache-2.0
// Dimensions that model files require -> dimensions as scenes have them, in the views that show them true.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "composition/requirement_texts.hpp"
#include "composition/seen_marks.hpp"
#include "importer/requirements.hpp"
#include "scene/description.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

/// A model whose file has requirements, and the views of a sheet in which they may stand.
struct RequirementSubject {
  const world::World& world;
  int model;
  const world::PlacedPart& part;
  const TrianglesByFace& triangles;
  std::span<const FaceView> views;
  Manner manner;

  /// From the coordinates of its file to the world.
  [[nodiscard]] Vec3 placed(const Vec3& point) const {
    return Vec3(world.models[static_cast<std::size_t>(model)].to_world * Vec4(point, 1));
  }
};

struct StatedDimension {
  scene::DimensionDescription dimension{};
  std::string why{};         ///< there is none; empty if there is
  bool is_straight = false;  ///< datums and frames may stand in line with it
  scene::NoteText beside{};  ///< instead: what stands at a leader to its faces or its edge
};

/// Values are those of the file. What the model itself measures must agree with them, or the dimension means something
/// else. `where` is for errors.
StatedDimension state_dimension(const importer::ModelRequirement& requirement, const RequirementSubject& subject,
                                const std::string& where);

/// Numbers of places at which faces are: those of one plane or of one axis are at one.
std::vector<std::vector<int>> face_places(const std::vector<int>& faces, const world::PlacedPart& part);

/// Points in order along a face that turns about an axis by less than a full turn, at a place along it with this
/// radius; empty for full turns. `points` are those of the face.
std::vector<Vec3> arc_of(const surfaces::PartFace& face, const std::vector<Vec3>& points, double along, double radius);

/// What leaders and dimensions need to be seen.
inline constexpr const char* not_seen = "no orthographic view of the sheet shows its faces: add a view or a section";
inline constexpr const char* line_not_seen =
    "no orthographic view of the sheet shows a line of its faces: add a view or a section";

}  // namespace epura::pipeline
