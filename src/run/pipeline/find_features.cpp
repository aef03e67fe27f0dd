// SPDX-License-Identifier: Apache-2.0
#include "pipeline/find_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "composition/requirement_texts.hpp"
#include "composition/stated_dimensions.hpp"
#include "features/place_threads.hpp"
#include "features/tolerances.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/recognise_parts.hpp"
#include "scene/body_styles.hpp"
#include "scene/details.hpp"
#include "scene/scene_values.hpp"
#include "sizes/anchors.hpp"
#include "sizes/datums.hpp"
#include "surfaces/numbers.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

namespace {

using scene::FeatureCircle;
using scene::FeatureName;
using surfaces::SurfaceKind;

struct FoundFeature {
  Vec3 centre;                   ///< on its axis, if it has one
  Vec3 surface;                  ///< on its rim or face
  std::vector<int> faces{};      ///< of the part; of a hole, its narrowest bore
  std::vector<int> all_faces{};  ///< of a hole, all
  std::optional<FeatureCircle> circle{};
  std::optional<FeatureCircle> rim{};  ///< of a hole, at its mouth
};

/// The features of a model as it is placed, in the order of their numbers.
struct NumberedFeatures {
  std::vector<FoundFeature> holes, faces;
};

Vec3 any_across(const Vec3& axis) {
  return glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
}

// The middle of the facet that is nearest to a place; among equally near ones, the one that most likely is seen: from
// the front, above and the left.
Vec3 facet_near(const std::vector<std::array<Vec3, 3>>& facets, const Vec3& place) {
  constexpr double alike = 1e-3;
  const Vec3 seen(-1, -2, 3);
  Vec3 best = place;
  double nearest = HUGE_VAL, most = -HUGE_VAL;
  for (const auto& [a, b, c] : facets) {
    const Vec3 middle = (a + b + c) / 3.0;
    const double far = glm::distance(middle, place), facing = glm::dot(middle - place, seen);
    if (far > nearest * (1 + alike) || (far >= nearest * (1 - alike) && facing <= most)) continue;
    nearest = std::min(nearest, far);
    most = facing;
    best = middle;
  }
  return best;
}

std::vector<FoundFeature> faces_of(const world::Placed& placed, const surfaces::PartFaces& part) {
  world::Placed with_part = placed;
  with_part.part = std::make_shared<surfaces::PartFaces>(part);
  const auto in_world = world::place_part(with_part);
  if (!in_world) return {};
  std::vector<std::vector<std::array<Vec3, 3>>> facets(part.faces.size());
  const auto at = [&](int vertex) { return Vec3(placed.to_world * Vec4(placed.mesh->point(vertex), 1)); };
  for (int t = 0; t < static_cast<int>(part.face_of_triangle.size()); ++t) {
    const auto [a, b, c] = placed.mesh->triangle(t);
    if (const int face = part.face_of_triangle[static_cast<std::size_t>(t)]; face >= 0)
      facets[static_cast<std::size_t>(face)].push_back({at(a), at(b), at(c)});
  }
  const std::vector<Vec3> middles = surfaces::middles_of_faces(*placed.mesh, part);
  std::vector<FoundFeature> faces;
  for (const int number : surfaces::numbered_faces(part, middles)) {
    const auto i = static_cast<std::size_t>(number);
    const surfaces::PartFace& face = in_world->faces[i];
    const surfaces::PartSurface& surface = face.surface;
    const Vec3 middle(placed.to_world * Vec4(middles[i], 1));
    FoundFeature found{middle, facet_near(facets[i], middle), {number}, {number}};
    if (surfaces::has_axis(surface.kind))
      found.centre = surface.origin + glm::dot(middle - surface.origin, surface.axis) * surface.axis;
    if (surface.kind == SurfaceKind::sphere) found.centre = surface.origin;
    if (surface.kind == SurfaceKind::cylinder) {
      std::vector<Vec3> points;
      for (const auto& corners : facets[i]) points.insert(points.end(), corners.begin(), corners.end());
      const double along = glm::dot(found.centre - surface.origin, surface.axis);
      found.circle =
          FeatureCircle{found.centre, surface.axis, surface.radius, arc_of(face, points, along, surface.radius)};
    }
    faces.push_back(std::move(found));
  }
  return faces;
}

std::vector<int> narrowest_bore(const surfaces::Hole& hole, const surfaces::PartFaces& part) {
  std::vector<int> faces;
  for (const int number : hole.faces) {
    const surfaces::PartSurface& surface = part.faces[static_cast<std::size_t>(number)].surface;
    if (surface.kind == SurfaceKind::cylinder && features::are_same(surface.radius, hole.diameters.front() / 2))
      faces.push_back(number);
  }
  return faces;
}

std::vector<FoundFeature> holes_of(const world::Placed& placed, const surfaces::PartFaces& part) {
  const auto scale = surfaces::similarity_scale(placed.to_world);
  if (!scale) return {};
  const std::vector<surfaces::Hole> all = surfaces::find_holes(*placed.mesh, part);
  std::vector<FoundFeature> holes;
  for (const int number : surfaces::numbered_holes(all)) {
    const surfaces::Hole& hole = all[static_cast<std::size_t>(number)];
    const Vec3 from = surfaces::mouth_of(hole), to = from == hole.from ? hole.to : hole.from;
    const Vec3 mouth(placed.to_world * Vec4(from, 1));
    const Vec3 axis = glm::normalize(Vec3(placed.to_world * Vec4(from - to, 0)));
    const double radius = *scale * hole.diameters.back() / 2;
    holes.push_back({mouth, mouth + radius * any_across(axis), narrowest_bore(hole, part), hole.faces,
                     FeatureCircle{mouth, axis, *scale * hole.diameters.front() / 2},
                     FeatureCircle{mouth, axis, radius}});
  }
  return holes;
}

/// Finds features by their names, those of each model once.
class Features {
 public:
  Features(const scene::SceneDescription& scene, const world::World& world) : scene_(scene), world_(world) {}

  const FoundFeature& find(const FeatureName& name, const std::string& where) {
    const int model = model_of(name, where);
    const auto [known, is_new] = of_models_.try_emplace(model);
    if (is_new) known->second = numbered(model);
    const auto [kind, number] = scene::parse_feature(name.text, where);
    const std::vector<FoundFeature>& list = kind == "hole" ? known->second.holes : known->second.faces;
    if (number > list.size())
      refuse_input(
          where, "'" + scene::name_of(scene_.models[static_cast<std::size_t>(model)]) + "' has no " + name.text,
          list.empty() ? "no " + kind + " of it is recognised"
                       : "it has " + kind + " 1" + (list.size() > 1 ? " to " + std::to_string(list.size()) : "") +
                             "; epura info says where");
    return list[number - 1];
  }

  const FeatureCircle& circle(const FeatureName& name, const std::string& where) {
    const FoundFeature& found = find(name, where);
    if (!found.circle)
      refuse_input(where, name.text + " is not cylindrical and has no circle", "name a hole or a cylinder");
    return *found.circle;
  }

  [[nodiscard]] int model_of(const FeatureName& name, const std::string& where) const {
    const int count = static_cast<int>(scene_.models.size());
    std::vector<std::string> names;
    for (const scene::ModelDescription& model : scene_.models) names.push_back(scene::name_of(model));
    if (const int* number = std::get_if<int>(&name.model)) {
      if (*number >= 0 && *number < count) return *number;
      if (*number < 0 && count == 1) return 0;
      refuse_input(where,
                   *number < 0 ? "there are " + std::to_string(count) + " models that have '" + name.text + "'"
                               : "there is no model " + std::to_string(*number),
                   "name one of them: [\"" + names.front() + "\", \"" + name.text + "\"]");
    }
    const auto& wanted = std::get<std::string>(name.model);
    if (std::count(names.begin(), names.end(), wanted) > 1)
      refuse_input(where, "several models are called '" + wanted + "'", "give them different names, or use a number");
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end()) refuse_input(where, "there is no model '" + wanted + "'", did_you_mean(wanted, names));
    return static_cast<int>(found - names.begin());
  }

 private:
  [[nodiscard]] NumberedFeatures numbered(int model) const {
    const world::Placed& placed = world_.models[static_cast<std::size_t>(model)];
    const surfaces::PartFaces part = placed.part != nullptr ? *placed.part : surfaces::recognise_faces(*placed.mesh);
    return {holes_of(placed, part), faces_of(placed, part)};
  }

  const scene::SceneDescription& scene_;
  const world::World& world_;
  std::map<int, NumberedFeatures> of_models_;
};

void find_anchors_of(scene::DimensionDescription& dimension, Features& features) {
  const DimensionType type = dimension.type.value_or(DimensionType::automatic);
  const bool is_round = type == DimensionType::radius || type == DimensionType::diameter || type == DimensionType::arc;
  const bool is_datum = type == DimensionType::automatic;
  for (scene::Anchor& anchor : dimension.anchors) {
    const auto* name = std::get_if<FeatureName>(&anchor);
    if (name == nullptr) continue;
    if (is_round) dimension.circle = features.circle(*name, dimension.where);
    const FoundFeature& found = features.find(*name, dimension.where);
    if (is_datum) dimension.circle = found.circle;
    const Vec3 place = is_datum ? found.surface : found.centre;
    anchor = place;
  }
}

// As people write them.
std::string words_of(const Vec3& place) {
  constexpr int digits = 7;
  return format_rounded(place.x, digits) + "," + format_rounded(place.y, digits) + "," +
         format_rounded(place.z, digits);
}

Vec3 nearest_vertex(const world::World& world, const Vec3& place) {
  Vec3 nearest(HUGE_VAL);
  for (const auto& corners : world.triangles)
    for (const int corner : corners)
      if (const Vec3& point = world.points[static_cast<std::size_t>(corner)];
          glm::distance(point, place) < glm::distance(nearest, place))
        nearest = point;
  return nearest;
}

}  // namespace

void place_datums(scene::SceneDescription& scene, const world::World& world) {
  for (scene::DimensionDescription& dimension : scene.dimensions) {
    if (dimension.type.value != DimensionType::automatic) continue;
    const bool is_of_file = !dimension.of_file.empty();
    const Mat4 to_world = is_of_file ? world.models.front().to_world : Mat4(1);
    for (scene::Anchor& anchor : dimension.anchors) {
      const auto* point = std::get_if<Vec3>(&anchor);
      if (point == nullptr) continue;
      const Vec3 place(to_world * Vec4(*point, 1));
      if (!sheet::is_on_models(world, place))
        refuse_input(
            is_of_file ? dimension.of_file : dimension.where,
            words_of(*point) + " is not on " +
                (world.models.size() == 1 ? world.models.front().mesh->report.name : std::string("the models")) +
                ", so no positions can be measured from there",
            "the nearest vertex is " + words_of(Vec3(glm::inverse(to_world) * Vec4(nearest_vertex(world, place), 1))) +
                "; a feature may be named instead, as 'hole 1' or 'face 2' of epura info");
      anchor = place;
    }
  }
}

void find_features(scene::SceneDescription& scene, const world::World& world) {
  Features features(scene, world);
  const auto point = [&features](const scene::Located<FeatureName>& at, auto& place) {
    if (at.given()) place = features.find(*at, at.where).centre;
  };
  for (scene::SectionDescription& one : scene.sections) point(one.at, one.point);
  for (scene::DetailDescription& one : scene.details) point(one.at, one.centre.value);
  for (scene::BrokenOutDescription& one : scene.broken_outs) point(one.at, one.point.value);
  for (scene::RevolvedDescription& one : scene.revolved) point(one.at, one.point.value);
  for (scene::DimensionDescription& one : scene.dimensions) find_anchors_of(one, features);
  for (scene::ThreadDescription& one : scene.threads)
    if (const auto* name = std::get_if<FeatureName>(&*one.at)) {
      const Vec3 centre = features.find(*name, one.at.where).centre;
      one.at.value = centre;
    }
  for (scene::CalloutDescription& one : scene.callouts) {
    const auto* anchor = one.to.given() ? std::get_if<scene::Anchor>(&*one.to) : nullptr;
    if (anchor == nullptr) continue;
    if (const auto* name = std::get_if<FeatureName>(anchor)) {
      const FoundFeature& found = features.find(*name, one.to.where);
      one.rim = found.rim;
      one.to.value = scene::LeaderTarget(scene::Anchor(found.surface));
    }
  }
}

namespace {

// Of files and scenes.
std::vector<std::string> datum_letters(const std::vector<FileRequirements>& required,
                                       const scene::SceneDescription& scene) {
  std::vector<std::string> letters;
  for (const FileRequirements& file : required)
    for (const importer::ModelRequirement& one : file.all)
      if (one.kind == importer::RequirementKind::datum) letters.push_back(one.datums);
  for (const scene::RequirementDescription& one : scene.requirements)
    if (one.letter.given()) letters.push_back(*one.letter);
  for (const scene::CalloutDescription& callout : scene.callouts)
    if (const auto* datum = std::get_if<scene::DatumFeature>(&callout.content)) letters.push_back(datum->letter);
  return letters;
}

}  // namespace

void state_by_features(std::vector<FileRequirements>& required, const scene::SceneDescription& scene,
                       const world::World& world) {
  Features features(scene, world);
  const std::vector<std::string> letters = datum_letters(required, scene);
  const Unit unit = scene.sheets.front().dimension_unit.value_or(Unit::mm);
  for (std::size_t i = 0; i < scene.requirements.size(); ++i) {
    const scene::RequirementDescription& words = scene.requirements[i];
    const int model = features.model_of(*words.feature, words.feature.where);
    const auto& part = world.models[static_cast<std::size_t>(model)].part;
    if (part == nullptr)
      refuse_input(words.where, "no faces of the model are recognised, of which something could be required",
                   "--surfaces auto recognises those of parts");
    for (const std::string& letter : words.frame.letters)
      if (std::find(letters.begin(), letters.end(), letter) == letters.end())
        refuse_input(words.where, "there is no datum " + letter + ", to which the " + *words.type + " refers",
                     letters.empty() ? "add a [[requirement]] of type \"datum\"" : did_you_mean(letter, letters));
    importer::ModelRequirement one = requirement_of(words, unit);
    one.id = words.name.value_or("requirement " + std::to_string(i + 1));
    one.faces = features.find(*words.feature, words.feature.where).faces;
    if (words.to.given()) {
      if (features.model_of(*words.to, words.to.where) != model)
        refuse_input(words.to.where, "the two features are of different models", "name two of one model");
      const std::vector<int>& more = features.find(*words.to, words.to.where).faces;
      one.faces.insert(one.faces.end(), more.begin(), more.end());
    }
    std::sort(one.faces.begin(), one.faces.end());
    auto file = std::find_if(required.begin(), required.end(), [&](const auto& known) { return known.model == model; });
    if (file == required.end()) file = required.insert(file, FileRequirements{model, {}, part});
    file->by_scene = std::min(file->by_scene, file->all.size());
    file->all.push_back(std::move(one));
  }
  for (FileRequirements& file : required) begin_ledger(file, scene);
}

std::vector<FileRequirements> requirements_of_scene(const scene::SceneDescription& scene, const RunOptions& options,
                                                    const Messages& messages) {
  report::Report report;
  ReadWorld read = read_models(scene, reading_of(scene, options), report.meshes, messages, {});
  recognise_parts(read.world, scene, options, report, {});
  if (!scene.requirements.empty()) state_by_features(read.required, scene, read.world);
  for (FileRequirements& file : read.required)
    file.unit = glm::length(Vec3(read.world.models[static_cast<std::size_t>(file.model)].to_world[0]));
  return std::move(read.required);
}

std::vector<AcceptedFaces> accepted_faces(const scene::SceneDescription& scene, const world::World& world) {
  Features features(scene, world);
  std::vector<AcceptedFaces> accepted;
  for (const scene::AcceptedDescription& one : scene.accepted)
    accepted.push_back({features.model_of(*one.feature, one.feature.where), one.feature->text,
                        features.find(*one.feature, one.feature.where).all_faces, *one.reason});
  return accepted;
}

void find_details(SheetOfViews& sheet, const scene::SceneDescription& scene) {
  for (PlannedView& view : sheet.plans)
    if (std::optional<scene::DetailDescription>& detail = view.options.detail)
      detail->centre = scene::find_detail(scene, *detail->name)->centre;
}

void find_threads(world::World& world, const scene::SceneDescription& scene) {
  std::vector<Vec3> positions;
  for (const scene::ThreadDescription& thread : scene.threads)
    positions.push_back(sheet::position_of(world, *thread.at, thread.at.where));
  features::place_threads(world, scene.threads, positions);
}

}  // namespace epura::pipeline
