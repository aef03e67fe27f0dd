// SPDX-License-Identifier: Apache-2.0
#include "composition/free_forms.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <variant>

#include "base/text.hpp"
#include "composition/annotations.hpp"
#include "sheet/captions.hpp"
#include "sizes/anchors.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

namespace {

constexpr double all = 0.999;  // of the area of a model

bool has_no_faces(const world::Placed& placed) { return placed.part == nullptr && placed.mesh->triangle_count() > 0; }

// Of a scan or a sculpture, no face is recognised: all of it is one free form.
bool is_unrecognised(const scene::SceneDescription& scene, const world::World& world, std::size_t model) {
  return has_no_faces(world.models[model]) &&
         scene.models[model].surfaces.value_or(Surfaces::automatic) == Surfaces::automatic;
}

bool has_free_forms(const scene::SceneDescription& scene, const world::World& world, std::size_t model) {
  const world::Placed& placed = world.models[model];
  return is_unrecognised(scene, world, model) ||
         (placed.part != nullptr && placed.part->recognised > 0 && placed.part->recognised < all);
}

bool is_surface_profile(const scene::CalloutDescription& callout) {
  const auto* frame = std::get_if<scene::ToleranceFrame>(&callout.content);
  const auto is_one = [](const scene::ToleranceFrame& one) {
    return one.characteristic == Characteristic::surface_profile;
  };
  return frame != nullptr && (is_one(*frame) || std::any_of(frame->also.begin(), frame->also.end(), is_one));
}

// Whether a point is on a triangle, up to a distance.
bool is_on(const std::array<Vec3, 3>& corners, const Vec3& point, double slack) {
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double doubled_area = glm::length(normal);
  if (!(doubled_area > 0) || std::abs(glm::dot(point - corners[0], normal)) > slack * doubled_area) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = corners[(i + 1) % 3] - corners[i];
    if (glm::dot(glm::cross(side, point - corners[i]), normal) < -slack * glm::length(side) * doubled_area)
      return false;
  }
  return true;
}

/// The faces of free form of one model.
class FreeForms {
 public:
  FreeForms(const world::World& world, int model) : world_(world), model_(model) {
    const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
    if (placed.part == nullptr) {
      face_of_triangle_.assign(static_cast<std::size_t>(placed.mesh->triangle_count()), 0);
      open_ = {true};
      areas_ = {1};
      return;
    }
    face_of_triangle_ = world::faces_of_triangles(placed);
    for (const surfaces::PartFace& face : placed.part->faces) {
      open_.push_back(face.surface.kind == surfaces::SurfaceKind::free_form);
      areas_.push_back(face.area);
    }
  }

  // The faces at a point have a tolerance.
  void cover(const Vec3& point) {
    constexpr double on_face = 1e-3;  // of the size: points are given with few decimals
    const double slack = on_face * glm::length(world_.box.size());
    const int first = world_.first_triangle[static_cast<std::size_t>(model_)];
    for (std::size_t t = 0; t < face_of_triangle_.size(); ++t) {
      const int face = face_of_triangle_[t];
      if (face < 0 || !open_[static_cast<std::size_t>(face)]) continue;
      const std::array<int, 3>& triangle = world_.triangles[static_cast<std::size_t>(first) + t];
      std::array<Vec3, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = world_.points[static_cast<std::size_t>(triangle[i])];
      if (is_on(corners, point, slack)) open_[static_cast<std::size_t>(face)] = false;
    }
  }

  /// The share of the area that has no tolerance.
  [[nodiscard]] double open_share() const {
    double open = 0, sum = 0;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      sum += areas_[i];
      if (open_[i]) open += areas_[i];
    }
    return sum > 0 ? open / sum : 0;
  }

 private:
  const world::World& world_;
  int model_;
  std::vector<int> face_of_triangle_;
  std::vector<bool> open_;     ///< by face
  std::vector<double> areas_;  ///< by face
};

// Names of the files, once each.
std::string files_of(const std::vector<std::size_t>& models, const scene::SceneDescription& scene) {
  std::vector<std::string> names;
  for (const std::size_t model : models) {
    const std::string name = std::filesystem::path(scene.models[model].file.value_or("")).filename().string();
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? " " : ", ") + name;
  return text;
}

// The share of the area of a model on free forms that no tolerance refers to.
double open_share(const scene::SceneDescription& scene, const world::World& world, std::size_t model) {
  FreeForms forms(world, static_cast<int>(model));
  for (const scene::CalloutDescription& callout : scene.callouts) {
    if (!is_surface_profile(callout)) continue;
    if (!callout.to.given() && !callout.dimension.given()) return 0;
    if (!callout.to.given()) continue;
    if (const auto* anchor = std::get_if<scene::Anchor>(&*callout.to))
      forms.cover(sheet::position_of(world, *anchor, callout.to.where));
  }
  return forms.open_share();
}

}  // namespace

bool refer_to_models(scene::SceneDescription& scene, const world::World& world) {
  if (!dimensions_features(scene)) return false;
  std::vector<std::size_t> models;
  for (std::size_t model = 0; model < world.models.size(); ++model)
    if (has_free_forms(scene, world, model) && open_share(scene, world, model) > 0) models.push_back(model);
  if (models.empty()) return false;
  scene::CalloutDescription note;
  const std::string language = scene.sheets.front().field("language");
  note.content = scene::NoteText{{std::string(sheet::caption("free_forms", language)) + files_of(models, scene)}};
  scene.callouts.push_back(std::move(note));
  return true;
}

void warn_of_unrecognised(const Messages& messages, const scene::SceneDescription& scene, const world::World& world) {
  for (std::size_t model = 0; model < world.models.size(); ++model)
    if (is_unrecognised(scene, world, model))
      messages.warn("model " + std::to_string(model) +
                    ": nothing is recognised, so none of its features has a size, and a note refers to its file");
}

std::vector<std::string> free_forms_without_tolerance(const scene::SceneDescription& scene, const world::World& world,
                                                      bool noted) {
  std::vector<std::string> sentences;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    const std::string name = "model " + std::to_string(model);
    const bool is_free = has_free_forms(scene, world, model);
    const double share = is_free && !noted ? open_share(scene, world, model) : 0;
    if (has_no_faces(world.models[model]) && (share > 0 || !is_free))
      sentences.push_back(name + ": nothing is recognised, so only overall sizes are checked");
    else if (share > 0)
      sentences.push_back(name + ": faces of free form, " + format_fixed(100 * share, 1) + " % of its area");
  }
  return sentences;
}

}  // namespace epura::pipeline
