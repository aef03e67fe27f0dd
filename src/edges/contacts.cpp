// SPDX-License-Identifier: Apache-2.0
#include "edges/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "edges/dihedral.hpp"
#include "world/placed_part.hpp"

namespace epura::edges {

namespace {

constexpr std::size_t crossings_a_look = 1024;
// Greatest height of an arc over its facet, as a multiple of the mean height.
constexpr double highest = 1.5;
// Most triangles of a face that are tested.
constexpr std::size_t most_asked = 256;

/// A face of a part: the number of its model, and its number in the part.
using FaceOfModel = std::array<int, 2>;

/// The recognised surfaces of a world, found by its triangles.
class PlacedFaces {
 public:
  explicit PlacedFaces(const world::World& world) : world_(world), models_(world.models.size()) {
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

  /// Whether one of two faces lies on the surface of the other, within the accuracy of the facets.
  [[nodiscard]] bool touch(const FaceOfModel& one, const FaceOfModel& two) const {
    const double slack = this->slack(one) + this->slack(two);
    return lies_on(one, two, slack) || lies_on(two, one, slack);
  }

 private:
  struct Model {
    std::vector<int> face_of_triangle;  ///< empty if no faces are recognised, or if the model is scaled non-uniformly
    Groups<int> triangles;              ///< by face; numbers in the uncut mesh
    Mat4 to_file{1};
    double scale = 1;
  };

  static void place(const world::Placed& placed, Model& model) {
    const std::optional<double> scale = world::similarity_scale(placed.to_world);
    if (placed.part == nullptr || !scale) return;
    const std::vector<int>& faces = placed.part->face_of_triangle;
    const Groups<int> triangles(placed.part->faces.size(), [&](const auto& visit) {
      for (std::size_t t = 0; t < faces.size(); ++t) visit(static_cast<std::size_t>(faces[t]), static_cast<int>(t));
    });
    check(triangles.size() == placed.part->faces.size(), "every face has its triangles");
    model = {world::faces_of_triangles(placed), triangles, glm::inverse(placed.to_world), *scale};
  }

  // Greatest distance between facets and their surface, in units of the world.
  [[nodiscard]] double slack(const FaceOfModel& face) const {
    return (highest * face_at(face).sagitta + face_at(face).residual + part(face).tolerance) * models_[face[0]].scale;
  }

  [[nodiscard]] bool lies_on(const FaceOfModel& face, const FaceOfModel& other, double slack) const {
    const world::Placed& placed = world_.models[face[0]];
    const mesh::Mesh& mesh = placed.mesh->whole();
    const Mat4 to_other = models_[other[0]].to_file * placed.to_world;
    const auto is_near = [&](int vertex) {
      const Vec3 point(to_other * Vec4(mesh.point(vertex), 1));
      return std::abs(features::signed_distance(face_at(other).surface, point)) * models_[other[0]].scale <= slack;
    };
    const auto triangles = models_[face[0]].triangles[static_cast<std::size_t>(face[1])];
    const std::size_t step = triangles.size() / most_asked + 1;
    for (std::size_t i = 0; i < triangles.size(); i += step)
      for (const int v : mesh.triangle(triangles[i]))
        if (!is_near(v)) return false;
    return true;
  }

  [[nodiscard]] const features::PartFaces& part(const FaceOfModel& face) const { return *world_.models[face[0]].part; }
  [[nodiscard]] const features::PartFace& face_at(const FaceOfModel& face) const { return part(face).faces[face[1]]; }

  const world::World& world_;
  std::vector<Model> models_;
};

class ContactJudge {
 public:
  ContactJudge(const world::World& world, double normalisation, double crease_angle)
      : world_(world), normalisation_(normalisation), crease_angle_(crease_angle), faces_(world) {}

  /// The two faces that cross there, in ascending order of model and number; nothing if one of them is not recognised.
  [[nodiscard]] std::optional<std::array<FaceOfModel, 2>> faces_at(const FaceCrossing& crossing) const {
    auto one = faces_.face_of(crossing.triangles[0]);
    auto two = faces_.face_of(crossing.triangles[1]);
    if (!one || !two) return std::nullopt;
    if (*two < *one) std::swap(one, two);
    return std::array{*one, *two};
  }

  /// Whether the faces touch; nothing if one of them is a free form.
  [[nodiscard]] std::optional<bool> touch(const std::array<FaceOfModel, 2>& faces) const {
    if (!faces_.has_form(faces[0]) || !faces_.has_form(faces[1])) return std::nullopt;
    return faces_.touch(faces[0], faces[1]);
  }

  /// Whether two facets cross at an angle that the turn of their surfaces from facet to facet explains.
  [[nodiscard]] bool is_within_turn(const FaceCrossing& crossing) const {
    double turn = 0;
    for (const int triangle : crossing.triangles) {
      const int model = world_.model_of_triangle(triangle);
      turn +=
          turn_of_surface({world_, model, normalisation_}, triangle - world_.first_triangle[model], crease_angle_) / 2;
    }
    return crossing.angle <= turn * 1.001;
  }

 private:
  const world::World& world_;
  double normalisation_, crease_angle_;
  PlacedFaces faces_;
};

double length_of(const FaceCrossing& crossing) { return glm::distance(crossing.ends[0], crossing.ends[1]); }

// Free forms touch if most of the length of their crossings does.
void judge_faces(const ContactJudge& judge, const std::vector<FaceCrossing>& crossings,
                 std::vector<Contact>& contacts) {
  struct Pair {
    double touching = 0, all = 0;  ///< lengths
    bool touch = false;
  };
  using Faces = std::array<FaceOfModel, 2>;
  std::vector<std::optional<Faces>> faces;
  std::map<Faces, Pair> pairs;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    faces.push_back(judge.faces_at(crossings[i]));
    if (!faces[i]) continue;
    Pair& pair = pairs[*faces[i]];
    pair.all += length_of(crossings[i]);
    if (contacts[i] == Contact::contact) pair.touching += length_of(crossings[i]);
  }
  for (const auto& [two, pair] : pairs) check(pair.touching <= pair.all, "a part is not longer than the whole");
  for (auto& [two, pair] : pairs) pair.touch = judge.touch(two).value_or(2 * pair.touching > pair.all);
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (faces[i]) contacts[i] = pairs[*faces[i]].touch ? Contact::contact : Contact::none;
}

}  // namespace

std::vector<Contact> judge_contacts(const world::World& world, double normalisation, double crease_angle,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress) {
  if (crossings.empty()) return {};
  const ContactJudge judge(world, normalisation, crease_angle);
  std::vector<Contact> contacts(crossings.size(), Contact::unjudged);
  try {
    parallel_for(contacts.size(), crossings_a_look, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        contacts[i] = judge.is_within_turn(crossings[i]) ? Contact::contact : Contact::none;
    });
  } catch (const OutOfTime&) {
    return contacts;
  }
  judge_faces(judge, crossings, contacts);
  return contacts;
}

}  // namespace epura::edges
