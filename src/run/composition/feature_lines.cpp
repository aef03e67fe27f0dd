// SPDX-License-Identifier: Apache-2.0
#include "composition/feature_lines.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "composition/feature_groups.hpp"
#include "sheet/phrases.hpp"
#include "surfaces/numbers.hpp"

namespace epura::pipeline {

namespace {

/// Finds the groups of lines and dimensions by the faces of the models.
class GroupFinder {
 public:
  GroupFinder(const world::World& world, const features::PartFeatures& features,
              const std::vector<FeatureGroup>& groups)
      : world_(world) {
    for (int model = 0; model < static_cast<int>(world.models.size()); ++model)
      of_face_.push_back(groups_of_faces(world, model, features, groups));
    if (world.models.size() == 1 && world.models.front().part != nullptr)
      numbered_ = surfaces::numbered_faces(
          *world.models.front().part,
          surfaces::middles_of_faces(world.models.front().mesh->whole(), *world.models.front().part));
  }

  // -1 if there is none.
  [[nodiscard]] int group_of(const sheet::Stroke& stroke) const {
    std::vector<int> common;
    for (std::size_t i = 0; i < stroke.edges.size(); ++i) {
      const std::vector<int> groups = groups_at(stroke.edges[i]);
      if (i == 0)
        common = groups;
      else
        std::erase_if(common, [&](int one) { return std::ranges::find(groups, one) == groups.end(); });
      if (common.empty()) return -1;
    }
    return common.empty() ? -1 : *std::ranges::min_element(common);
  }

  [[nodiscard]] int group_of(const sheet::DimensionObject& dimension) const {
    int first = -1;
    for (const int number : dimension.faces) {
      if (number < 1 || static_cast<std::size_t>(number) > numbered_.size()) continue;
      const int face = numbered_[static_cast<std::size_t>(number) - 1];
      const int group = of_face_.front()[static_cast<std::size_t>(face)];
      if (group >= 0 && (first < 0 || group < first)) first = group;
    }
    return first;
  }

 private:
  // Of the faces at an edge.
  [[nodiscard]] std::vector<int> groups_at(const sheet::ModelEdge& edge) const {
    const std::vector<int>& of_face = of_face_[static_cast<std::size_t>(edge.model)];
    const world::Placed& placed = world_.models[static_cast<std::size_t>(edge.model)];
    const mesh::Mesh& mesh = placed.mesh->whole();
    std::vector<int> groups;
    const mesh::MeshEdge* found = of_face.empty() ? nullptr : mesh.edge_between(edge.vertex);
    if (found == nullptr) return groups;
    for (const int triangle : mesh.triangles_of(*found)) {
      const int face = placed.part->face_of_triangle[static_cast<std::size_t>(triangle)];
      if (face >= 0 && of_face[static_cast<std::size_t>(face)] >= 0)
        groups.push_back(of_face[static_cast<std::size_t>(face)]);
    }
    return groups;
  }

  const world::World& world_;
  std::vector<std::vector<int>> of_face_{};  ///< by model
  std::vector<int> numbered_{};              ///< of the only model, by number in scenes
};

std::string words_of(const FeatureGroup& group, std::string_view language) {
  const std::string words = group.are_holes ? sheet::phrase("hole", language, std::array{group.words}) : group.words;
  return counted(group.features.size(), words);
}

}  // namespace

void add_features(sheet::Sheet& sheet, const world::World& world, const features::PartFeatures& features,
                  const sheet::FeatureTable& table, const sheet::Notation& notation, std::string_view language) {
  const std::vector<FeatureGroup> groups = feature_groups(features, table, notation, language);
  const GroupFinder finder(world, features, groups);
  using Key = std::pair<std::string, int>;  // view and group
  std::map<Key, int> numbers;
  std::vector<std::pair<int*, Key>> found;
  for (sheet::Layer& layer : sheet.layers) {
    const std::size_t slash = layer.name.rfind('/');
    if (slash == std::string::npos) continue;
    const auto note = [&](auto& one) {
      if (const int group = finder.group_of(one); group >= 0)
        found.emplace_back(&one.feature, Key(layer.name.substr(0, slash), group));
    };
    for (sheet::Stroke& stroke : layer.strokes) note(stroke);
    for (sheet::DimensionObject& dimension : layer.dimensions) note(dimension);
  }
  for (const auto& [feature, key] : found) numbers.emplace(key, 0);
  for (auto& [key, number] : numbers) {
    number = static_cast<int>(sheet.features.size());
    sheet.features.push_back({key.first, words_of(groups[static_cast<std::size_t>(key.second)], language)});
  }
  for (const auto& [feature, key] : found) *feature = numbers.at(key);
}

}  // namespace epura::pipeline
