// SPDX-License-Identifier: Apache-2.0
#include "edges/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "edges/dihedral.hpp"
#include "edges/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::edges {

namespace {

constexpr std::size_t crossings_a_look = 1024;
// Steps of Newton's method, which halve the distance to a line of contact, and find one of crossing in fewer.
constexpr int max_steps = 16;

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
    return surface(face).kind != surfaces::SurfaceKind::free_form;
  }

  /// Whether two surfaces touch near a place: no farther away than `reach`, they meet nowhere at more than
  /// `part_angle` degrees.
  [[nodiscard]] bool touch(const std::array<FaceOfModel, 2>& faces, const Vec3& place, double reach,
                           double part_angle) const {
    const surfaces::PartSurface &one = surface(faces[0]), &two = surface(faces[1]);
    const auto is_plane = [](const surfaces::PartSurface& s) { return s.kind == surfaces::SurfaceKind::plane; };
    if (is_plane(one) && is_plane(two)) return false;  // facets of planes cross where the planes do, at any angle
    check(reach > 0, "facets that cross have a length");
    Vec3 p = place;
    for (int step = 0; step < max_steps; ++step) {
      const double from_one = surfaces::signed_distance(one, p), from_two = surfaces::signed_distance(two, p);
      const Vec3 n1 = surfaces::normal_near(one, p), n2 = surfaces::normal_near(two, p);
      const double cosine = glm::dot(n1, n2), sine = glm::length(glm::cross(n1, n2));
      if (std::abs(from_one) + std::abs(from_two) <= on_both * reach)
        return portable_atan2(sine, std::abs(cosine)) * degrees <= part_angle;
      const Vec3 way = (cosine * from_two - from_one) * n1 + (cosine * from_one - from_two) * n2;
      if (!(glm::length(way) <= sine * sine * reach)) return true;
      p += way / (sine * sine);
      if (glm::distance(p, place) > reach) return true;
    }
    return true;
  }

 private:
  struct Model {
    std::vector<int> face_of_triangle;  ///< empty if no faces are recognised, or if the model is scaled non-uniformly
    std::vector<surfaces::PartSurface> surfaces;  ///< of the faces, in the world
  };

  static void place(const world::Placed& placed, Model& model) {
    const std::optional<double> scale = world::similarity_scale(placed.to_world);
    if (placed.part == nullptr || !scale) return;
    model.face_of_triangle = world::faces_of_triangles(placed);
    for (const surfaces::PartFace& face : placed.part->faces)
      model.surfaces.push_back(surfaces::moved(face.surface, placed.to_world, *scale));
  }

  [[nodiscard]] const surfaces::PartSurface& surface(const FaceOfModel& face) const {
    return models_[static_cast<std::size_t>(face[0])].surfaces[static_cast<std::size_t>(face[1])];
  }

  const world::World& world_;
  std::vector<Model> models_;
};

class ContactJudge {
 public:
  ContactJudge(const world::World& world, double normalisation, const ContactLimits& limits)
      : world_(world), normalisation_(normalisation), limits_(limits), faces_(world) {}

  /// The two faces that cross there, in ascending order of model and number; nothing if one of them is not recognised.
  [[nodiscard]] std::optional<std::array<FaceOfModel, 2>> faces_at(const FaceCrossing& crossing) const {
    auto one = faces_.face_of(crossing.triangles[0]);
    auto two = faces_.face_of(crossing.triangles[1]);
    if (!one || !two) return std::nullopt;
    if (*two < *one) std::swap(one, two);
    return std::array{*one, *two};
  }

  [[nodiscard]] Contact contact_at(const FaceCrossing& crossing) const {
    const auto faces = faces_at(crossing);
    const bool have_form = faces && faces_.has_form((*faces)[0]) && faces_.has_form((*faces)[1]);
    const bool touch = have_form ? faces_.touch(*faces, (crossing.ends[0] + crossing.ends[1]) / 2.0,
                                                size_of_facets(crossing), limits_.part_angle)
                                 : is_within_turn(crossing);
    return touch ? Contact::contact : Contact::none;
  }

 private:
  [[nodiscard]] double size_of_facets(const FaceCrossing& crossing) const {
    double longest = 0;
    for (const int triangle : crossing.triangles) {
      const auto& c = world_.triangles[triangle];
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, glm::distance(world_.points[c[i]], world_.points[c[(i + 1) % 3]]));
    }
    return longest;
  }

  // Whether two facets cross at an angle that the turn of their surfaces from facet to facet explains.
  [[nodiscard]] bool is_within_turn(const FaceCrossing& crossing) const {
    double turn = 0;
    for (const int triangle : crossing.triangles) {
      const int model = world_.model_of_triangle(triangle);
      turn += turn_of_surface({world_, model, normalisation_}, triangle - world_.first_triangle[model],
                              limits_.crease_angle) /
              2;
    }
    return crossing.angle <= turn * 1.001;
  }

  const world::World& world_;
  double normalisation_;
  ContactLimits limits_;
  PlacedFaces faces_;
};

double length_of(const FaceCrossing& crossing) { return glm::distance(crossing.ends[0], crossing.ends[1]); }

// Faces touch if most of the length of their crossings does.
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
  for (auto& [two, pair] : pairs) pair.touch = 2 * pair.touching > pair.all;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (faces[i]) contacts[i] = pairs[*faces[i]].touch ? Contact::contact : Contact::none;
}

}  // namespace

std::vector<Contact> judge_contacts(const world::World& world, double normalisation, const ContactLimits& limits,
                                    const std::vector<FaceCrossing>& crossings, const Progress& progress) {
  if (crossings.empty()) return {};
  const ContactJudge judge(world, normalisation, limits);
  std::vector<Contact> contacts(crossings.size(), Contact::unjudged);
  try {
    parallel_for(contacts.size(), crossings_a_look, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) contacts[i] = judge.contact_at(crossings[i]);
    });
  } catch (const OutOfTime&) {
    return contacts;
  }
  judge_faces(judge, crossings, contacts);
  return contacts;
}

}  // namespace epura::edges
