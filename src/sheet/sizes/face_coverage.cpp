// SPDX-License-Identifier: Apache-2.0
#include "sizes/face_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/text.hpp"
#include "features/face_owners.hpp"
#include "features/tolerances.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/equal_features.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using features::FaceOwner;
using features::OwnerKind;
using surfaces::SurfaceKind;

// In the order of SurfaceKind.
constexpr std::array<const char*, 6> kind_names = {
    "plane faces", "cylindrical faces", "conical faces", "spherical faces", "toroidal faces", "free forms",
};

class FaceCounter {
 public:
  FaceCounter(const DimensionSubject& subject, std::span<const RoundEnd> ends, const GivenSizes& given,
              const Notation& notation)
      : subject_(subject), given_(given), notation_(notation), ends_(ends) {}

  FaceCoverage count() {
    const world::World& world = subject_.world;
    for (std::size_t model = 0; model < world.models.size(); ++model) {
      if (world.models[model].part == nullptr) continue;
      const auto part = world::place_part(world.models[model]);
      if (!part) continue;
      const auto owners = features::owners_of_faces(world, static_cast<int>(model), *part, subject_.features);
      for (std::size_t face = 0; face < owners.size(); ++face) count(part->faces[face], owners[face], face);
    }
    for (std::size_t kind = 0; kind < all_.size(); ++kind)
      if (all_[kind] > 0) found_.counts.push_back({kind_names[kind], with_[kind], all_[kind]});
    return std::move(found_);
  }

 private:
  void count(const surfaces::PartFace& face, const FaceOwner& owner, std::size_t place) {
    const SurfaceKind kind = face.surface.kind;
    if (kind == SurfaceKind::free_form || owner.kind == OwnerKind::letter) return;
    const auto number = static_cast<std::size_t>(kind);
    ++all_[number];
    if (is_given(face, owner, place < given_.held.size() && given_.held[place] != 0)) ++with_[number];
  }

  bool is_given(const surfaces::PartFace& face, const FaceOwner& owner, bool is_held) {
    if (face.surface.kind == SurfaceKind::plane) return has_plane(face, owner, is_held);
    if (face.surface.kind == SurfaceKind::sphere || face.surface.kind == SurfaceKind::torus)
      return is_held || given_.has_doubly_curved(face);
    return has_round(face);
  }

  // Of no feature, it is what dimensions of whatever faces hold.
  bool has_plane(const surfaces::PartFace& face, const FaceOwner& owner, bool is_held) {
    const auto number = static_cast<std::size_t>(owner.number);
    if (const auto given = given_.owners.find({owner.kind, owner.number}); given != given_.owners.end())
      return given->second;
    if (owner.kind == OwnerKind::bevel) return given_.bevels[number];
    const surfaces::PartSurface& plane = face.surface;
    if (const int axis = world_axis(plane.axis); axis >= 0) return given_.has_place(axis, plane.origin[axis]);
    if (is_between_round_ends(face)) return true;
    for (const HexagonChamfer& one : given_.hexagon_chamfers)
      if (one.is_face(plane.origin, plane.axis)) return given_.bevels[static_cast<std::size_t>(one.bevel)];
    bool is_side = false;
    for (const KnownPrism& one : given_.prisms)
      if (one.prism.has_side(plane.origin, plane.axis)) {
        if (one.is_given) return true;
        is_side = true;
      }
    if (is_side) return false;
    if (is_held) return true;
    miss("inclined plane face", face, "place and angle");
    return false;
  }

  // A face that touches two round ends follows from them.
  [[nodiscard]] bool is_between_round_ends(const surfaces::PartFace& face) const {
    const Vec3& normal = face.surface.axis;
    const RoundEnd* first = nullptr;
    for (const RoundEnd& end : ends_) {
      const double off = glm::dot(face.surface.origin - end.centre, normal),
                   slack = 10 * features::same_size * end.radius;
      if (std::abs(glm::dot(normal, end.axis)) > features::parallel || std::abs(off - end.radius) > slack) continue;
      if (first != nullptr && features::distance_from_line(end.centre, first->centre, first->axis) > slack) return true;
      if (first == nullptr) first = &end;
    }
    return false;
  }

  // Of a cone, one end: the other one, an angle or a length follows from the places of its ends.
  bool has_round(const surfaces::PartFace& face) {
    const surfaces::PartSurface& surface = face.surface;
    std::vector<double> radii{surface.radius};
    if (surface.kind == SurfaceKind::cone)
      radii = {surface.radius + surface.slope * face.from, surface.radius + surface.slope * face.to};
    bool is_known = false;
    for (const SizedCircle& circle : given_.circles)
      for (const double radius : radii)
        if (is_on(face, radius, circle)) {
          if (circle.is_given) return true;
          is_known = true;
        }
    const auto is_it = [&](double given) {
      return std::any_of(radii.begin(), radii.end(), [&](double radius) { return are_one(face, radius, given); });
    };
    if (std::any_of(given_.radii.begin(), given_.radii.end(), is_it)) return !is_known;
    if (!is_known) miss(surface.kind == SurfaceKind::cone ? "conical face" : "cylindrical face", face, "size");
    return false;
  }

  [[nodiscard]] bool are_one(const surfaces::PartFace& face, double radius, double given) const {
    return radius > 0 &&
           (are_written_alike(given, radius, notation_) || std::abs(given - radius) <= features::radius_doubt(face));
  }

  [[nodiscard]] bool is_on(const surfaces::PartFace& face, double radius, const SizedCircle& circle) const {
    return are_one(face, radius, circle.radius) && features::are_parallel(circle.axis, face.surface.axis) &&
           features::distance_from_line(circle.centre, face.surface.origin, face.surface.axis) <=
               10 * features::same_size * radius;
  }

  void miss(const std::string& kind, const surfaces::PartFace& face, const std::string& what) {
    const Vec3 p = face.surface.origin;
    const auto text = [this](double value) { return length_text(value, notation_); };
    found_.unaccounted.push_back(kind + " of " + format_rounded(face.area, 4) + " mm² at (" + text(p.x) + ", " +
                                 text(p.y) + ", " + text(p.z) + "): " + what);
  }

  const DimensionSubject& subject_;
  const GivenSizes& given_;
  const Notation& notation_;
  std::span<const RoundEnd> ends_;
  std::array<int, kind_names.size()> all_{}, with_{};  // by kind
  FaceCoverage found_;
};

}  // namespace

FaceCoverage cover_faces(const DimensionSubject& subject, std::span<const RoundEnd> ends, const GivenSizes& given,
                         const Notation& notation) {
  if (subject.features.of_assembly) return {};
  return FaceCounter(subject, ends, given, notation).count();
}

}  // namespace epura::sheet
