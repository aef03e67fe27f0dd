// SPDX-License-Identifier: Apache-2.0
#include "edges/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "edges/dihedral.hpp"
#include "scene/placed_part.hpp"

namespace epura::edges {

namespace {

constexpr std::size_t crossings_a_look = 1024;
// Of the mean height of arcs over their facets: the highest ones.
constexpr double highest = 2;
// The cosine of the angle up to which surfaces that touch may turn away from each other.
constexpr double touching_cosine = 0.99;

/// A face of a part: the number of its model, and its own.
using FaceOfModel = std::array<int, 2>;

/// The recognised surfaces of a world, asked by its triangles and points.
class PlacedFaces {
 public:
  explicit PlacedFaces(const scene::World& world) : world_(world), models_(world.models.size()) {
    for (std::size_t m = 0; m < models_.size(); ++m) place(world.models[m], models_[m]);
  }

  [[nodiscard]] std::optional<FaceOfModel> face_of(int triangle) const {
    const int model = world_.model_of_triangle(triangle);
    const std::vector<int>& faces = models_[model].face_of_triangle;
    const int face = faces.empty() ? -1 : faces[triangle - world_.first_triangle[model]];
    return face < 0 ? std::nullopt : std::optional(FaceOfModel{model, face});
  }

  [[nodiscard]] bool has_form(const FaceOfModel& face) const {
    return face_at(face).surface.kind != features::SurfaceKind::free_form;
  }

  /// The distance of a point from the surface of a face, and how far facets may lie from it, as lengths of the world.
  [[nodiscard]] double distance(const FaceOfModel& face, const Vec3& point) const {
    return std::abs(features::signed_distance(face_at(face).surface, in_file(face, point))) * models_[face[0]].scale;
  }
  [[nodiscard]] double slack(const FaceOfModel& face) const {
    return (highest * face_at(face).sagitta + face_at(face).residual + part(face).tolerance) * models_[face[0]].scale;
  }
  [[nodiscard]] Vec3 normal(const FaceOfModel& face, const Vec3& point) const {
    const Vec3 in_world =
        Mat3(world_.models[face[0]].to_world) * features::normal_near(face_at(face).surface, in_file(face, point));
    return in_world / models_[face[0]].scale;
  }

 private:
  struct Model {
    std::vector<int> face_of_triangle;  ///< empty where no faces are recognised, or the model is stretched
    Mat4 to_file{1};
    double scale = 1;
  };

  static void place(const scene::Placed& placed, Model& model) {
    const std::optional<double> scale = scene::similarity_scale(placed.to_world);
    if (placed.part == nullptr || !scale) return;
    model = {scene::faces_of_triangles(placed), glm::inverse(placed.to_world), *scale};
  }

  [[nodiscard]] const features::PartFaces& part(const FaceOfModel& face) const { return *world_.models[face[0]].part; }
  [[nodiscard]] const features::PartFace& face_at(const FaceOfModel& face) const { return part(face).faces[face[1]]; }
  [[nodiscard]] Vec3 in_file(const FaceOfModel& face, const Vec3& point) const {
    return Vec3(models_[face[0]].to_file * Vec4(point, 1));
  }

  const scene::World& world_;
  std::vector<Model> models_;
};

class ContactJudge {
 public:
  ContactJudge(const scene::World& world, double normalisation, double crease_angle)
      : world_(world), normalisation_(normalisation), crease_angle_(crease_angle), faces_(world) {}

  /// The faces of parts that cross there, the first one's model and number lower; nothing where one is not recognised.
  [[nodiscard]] std::optional<std::array<FaceOfModel, 2>> faces_at(const FaceCrossing& crossing) const {
    auto one = faces_.face_of(crossing.triangles[0]);
    auto two = faces_.face_of(crossing.triangles[1]);
    if (!one || !two) return std::nullopt;
    if (*two < *one) std::swap(one, two);
    return std::array{*one, *two};
  }

  [[nodiscard]] bool touch(const FaceCrossing& crossing) const {
    const auto one = faces_.face_of(crossing.triangles[0]);
    const auto two = faces_.face_of(crossing.triangles[1]);
    if (!one || !two || !faces_.has_form(*one) || !faces_.has_form(*two)) return is_within_turn(crossing);
    const double slack = faces_.slack(*one) + faces_.slack(*two);
    const auto lies_on = [&](int triangle, const FaceOfModel& face) {
      const auto& corners = world_.triangles[triangle];
      return std::all_of(corners.begin(), corners.end(),
                         [&](int v) { return faces_.distance(face, world_.points[v]) <= slack; });
    };
    const Vec3 middle = (crossing.ends[0] + crossing.ends[1]) * 0.5;
    return std::abs(glm::dot(faces_.normal(*one, middle), faces_.normal(*two, middle))) >= touching_cosine &&
           (lies_on(crossing.triangles[0], *two) || lies_on(crossing.triangles[1], *one));
  }

 private:
  // Whether the facets cross by no more than their surfaces turn from facet to facet.
  [[nodiscard]] bool is_within_turn(const FaceCrossing& crossing) const {
    double turn = 0;
    for (const int triangle : crossing.triangles) {
      const int model = world_.model_of_triangle(triangle);
      turn +=
          turn_of_surface({world_, model, normalisation_}, triangle - world_.first_triangle[model], crease_angle_) / 2;
    }
    return crossing.angle <= turn * 1.001;
  }

  const scene::World& world_;
  double normalisation_, crease_angle_;
  PlacedFaces faces_;
};

double length_of(const FaceCrossing& crossing) { return glm::distance(crossing.ends[0], crossing.ends[1]); }

}  // namespace

std::vector<Contact> judge_contacts(const scene::World& world, double normalisation, double crease_angle,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress) {
  const ContactJudge judge(world, normalisation, crease_angle);
  std::vector<Contact> contacts(crossings.size(), Contact::unjudged);
  try {
    parallel_for(contacts.size(), crossings_a_look, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        contacts[i] = judge.touch(crossings[i]) ? Contact::contact : Contact::none;
    });
  } catch (const OutOfTime&) {
    return contacts;
  }
  // Two faces touch or cross as a whole.
  struct Lengths {
    double touching = 0, all = 0;
  };
  std::map<std::array<FaceOfModel, 2>, Lengths> pairs;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (const auto faces = judge.faces_at(crossings[i])) {
      Lengths& lengths = pairs[*faces];
      lengths.all += length_of(crossings[i]);
      if (contacts[i] == Contact::contact) lengths.touching += length_of(crossings[i]);
    }
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (const auto faces = judge.faces_at(crossings[i])) {
      const Lengths& lengths = pairs[*faces];
      contacts[i] = 2 * lengths.touching > lengths.all ? Contact::contact : Contact::none;
    }
  return contacts;
}

}  // namespace epura::edges
