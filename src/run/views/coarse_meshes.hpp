// SPDX-License-Identifier: Apache-2.0
// Meshes that stand for a smooth surface, and are too coarse for the size at which they are drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "scene/description.hpp"
#include "views/draw_view.hpp"

namespace epura::pipeline {

/// Whether models are parts, as far as that was asked; by number in the scene.
using PartsByModel = std::map<int, bool>;

/// Those of the views of a sheet.
class CoarseMeshes {
 public:
  /// What is found out about models is kept in `parts`.
  CoarseMeshes(const scene::SceneDescription& scene, PartsByModel& parts);

  /// Looks for models whose outlines are visibly angular in a view, or whose mesh is drawn by edges of the kind
  /// `smooth` where its outlines seem to be wanted. Parts, whose faces are recognised, are none of them, and neither
  /// are machines of many bodies.
  void look(const ViewInput& input, const drawing::ViewDrawing& drawing, const Progress& progress);

  /// Returns a warning, with a remedy, for each model that was found.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  struct Coarse {
    std::string name;  ///< of its file
    bool is_angular = false, has_smooth = false, has_creases = false;
  };

  bool is_part(int model, const mesh::Mesh& mesh, const Progress& progress);

  const scene::SceneDescription& scene_;
  PartsByModel& parts_;
  std::map<int, Coarse> coarse_;  ///< by number in the scene
};

}  // namespace epura::pipeline
