// SPDX-License-Identifier: Apache-2.0
// A scene in the words of scene files, for programs that hand over what others write: bindings, forms, databases. Keys,
// values and defaults are those of docs/scenes.md.
#pragma once

#include <array>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace epura {

struct SceneValue;

struct SceneList {
  std::vector<SceneValue> values;
};

struct SceneTable {
  std::vector<SceneValue> values;  ///< with their keys
};

/// A value of a scene. The scene itself is a table.
struct SceneValue {
  std::string key;    ///< in its table; of an element, that of its list
  std::string place;  ///< as errors call it: "views[1].hidden"
  std::variant<std::string, double, bool, SceneList, SceneTable> content;
};

/// Faces with the same number of corners, one after the other: indices of points, counterclockwise as seen from
/// outside.
struct FaceArray {
  std::span<const int> corners;
  int corners_of_each = 3;
};

/// The content of a model in memory, instead of its file. The arrays are borrowed while the scene is drawn.
struct ModelSource {
  int model = 0;        ///< its number in the scene
  std::string bytes{};  ///< of a file; the model's `file` gives its name and format
  std::span<const std::array<double, 3>> points{};
  std::vector<FaceArray> faces{};  ///< instead of bytes
  bool single_precision = false;   ///< as in Polygons
};

}  // namespace epura
