// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "library/describe_scene.hpp"
#include "scene/scene_file.hpp"
#include "scene/toml_tree.hpp"

namespace epura {

namespace {

scene::TomlValue toml_value(const SceneValue& value);

std::vector<scene::TomlValue> toml_values(const std::vector<SceneValue>& values) {
  std::vector<scene::TomlValue> made;
  for (const SceneValue& value : values) made.push_back(toml_value(value));
  return made;
}

scene::TomlContent toml_content(const SceneValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
  if (const auto* number = std::get_if<double>(&value.content)) return *number;
  if (const auto* truth = std::get_if<bool>(&value.content)) return *truth;
  if (const auto* list = std::get_if<SceneList>(&value.content)) return scene::TomlList{toml_values(list->values)};
  return scene::TomlTable{toml_values(std::get<SceneTable>(value.content).values)};
}

scene::TomlValue toml_value(const SceneValue& value) {
  return {value.key, value.place, value.place, toml_content(value)};
}

void add_faces(const FaceArray& faces, std::size_t points, const std::string& where, mesh::Soup& soup) {
  if (faces.corners_of_each < 1 || faces.corners.size() % static_cast<std::size_t>(faces.corners_of_each) != 0)
    throw Error(ErrorKind::input, where, "has no whole number of faces");
  const int last = static_cast<int>(points) - 1;
  std::size_t number = soup.face_ends.size();
  for (std::size_t i = 0; i < faces.corners.size(); ++i) {
    const int corner = faces.corners[i];
    if (corner < 0 || corner > last)
      throw Error(ErrorKind::input, where + "[" + std::to_string(number) + "]",
                  "there is no vertex " + std::to_string(corner),
                  "they are numbered from 0 to " + std::to_string(last));
    soup.corners.push_back(corner);
    if ((i + 1) % static_cast<std::size_t>(faces.corners_of_each) != 0) continue;
    soup.end_face();
    ++number;
  }
}

std::shared_ptr<const mesh::Soup> soup_of(const ModelSource& source, const std::string& where) {
  if (source.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw Error(ErrorKind::input, where + ".vertices", "has more than 2147483647 rows");
  auto soup = std::make_shared<mesh::Soup>();
  soup->format = "memory";
  soup->single_precision = source.single_precision;
  soup->points.assign(source.points.begin(), source.points.end());
  for (const FaceArray& faces : source.faces) add_faces(faces, source.points.size(), where + ".faces", *soup);
  return soup;
}

}  // namespace

scene::SceneDescription describe_scene(const SceneValue& value, const std::vector<ModelSource>& sources) {
  scene::SceneDescription description = scene::scene_of(toml_value(value));
  for (const ModelSource& source : sources) {
    if (source.model < 0 || source.model >= static_cast<int>(description.models.size()))
      throw Error(ErrorKind::input, "sources", "there is no model " + std::to_string(source.model));
    scene::ModelDescription& model = description.models[static_cast<std::size_t>(source.model)];
    if (!source.bytes.empty()) {
      model.content = std::make_shared<const std::string>(source.bytes);
      continue;
    }
    if (!model.name.given()) model.name = model.file;
    model.file = {};
    model.soup = soup_of(source, "models[" + std::to_string(source.model) + "]");
  }
  return description;
}

}  // namespace epura
