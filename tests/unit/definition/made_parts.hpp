// SPDX-License-Identifier: Apache-2.0
// Parts by their faces, and dimensions between these.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "definition/account.hpp"
#include "definition/words.hpp"

namespace epura::definition {

inline Face plane(const Vec3& at, const Vec3& normal, double area) {
  return {{.kind = surfaces::SurfaceKind::plane, .origin = at, .axis = glm::normalize(normal)}, at, area};
}

inline Face cylinder(const Vec3& on_axis, const Vec3& axis, double radius, double area) {
  const Vec3 unit = glm::normalize(axis);
  return {{.kind = surfaces::SurfaceKind::cylinder, .origin = on_axis, .axis = unit, .radius = radius}, on_axis, area};
}

inline Face cone(const Vec3& on_axis, const Vec3& axis, double radius, double slope, double area) {
  Face face = cylinder(on_axis, axis, radius, area);
  face.surface.kind = surfaces::SurfaceKind::cone;
  face.surface.slope = slope;
  return face;
}

inline Face sphere(const Vec3& centre, double radius, double area) {
  return {{.kind = surfaces::SurfaceKind::sphere, .origin = centre, .radius = radius}, centre, area};
}

inline Face torus(const Vec3& centre, const Vec3& axis, double radius, double minor, double area) {
  Face face = cylinder(centre, axis, radius, area);
  face.surface.kind = surfaces::SurfaceKind::torus;
  face.surface.minor = minor;
  return face;
}

/// From the origin: x-, x+, y-, y+, z-, z+.
inline Part box(const Vec3& size) {
  const Vec3 h = size / 2.0;
  Part part{{plane({0, h.y, h.z}, {-1, 0, 0}, size.y * size.z), plane({size.x, h.y, h.z}, {1, 0, 0}, size.y * size.z),
             plane({h.x, 0, h.z}, {0, -1, 0}, size.x * size.z), plane({h.x, size.y, h.z}, {0, 1, 0}, size.x * size.z),
             plane({h.x, h.y, 0}, {0, 0, -1}, size.x * size.y), plane({h.x, h.y, size.z}, {0, 0, 1}, size.x * size.y)}};
  part.size = glm::length(size);
  return part;
}

inline constexpr int left = 0, right = 1, front = 2, back = 3, bottom = 4, top = 5;

/// A part, and what a sheet says of it.
class MadeSheet {
 public:
  explicit MadeSheet(const Part& part, Marks marks_of_sheet = {}, const RuleSet& applied = rules_of(Standard::iso))
      : directions(find_directions(part.faces)),
        part(with_common_directions(part, directions)),
        marks(std::move(marks_of_sheet)),
        unknowns(this->part, directions),
        rules(state_rules(this->part, directions, unknowns, marks, applied)) {}
  MadeSheet(const MadeSheet&) = delete;
  MadeSheet& operator=(const MadeSheet&) = delete;

  /// Between planes, axes and centres; the direction is that of a face.
  MadeSheet& distance(int from, int to, int direction) {
    const Vec3 along = surface(direction).axis;
    dimensions.push_back({name("distance"), {length(unknowns, part, {end(from), end(to)}, along, direction)}});
    return *this;
  }
  MadeSheet& size(int face, UnknownKind kind = UnknownKind::radius) {
    dimensions.push_back({name("size"), {unknowns.growth(face, kind)}});
    return *this;
  }
  MadeSheet& angle(int from, int to, const Vec3& sight) {
    dimensions.push_back({name("angle"), {definition::angle(unknowns, {end(from), end(to)}, sight)}});
    return *this;
  }

  [[nodiscard]] Account account() const { return take_account(part, unknowns, rules, dimensions); }
  [[nodiscard]] int needed() const { return account().needed; }
  [[nodiscard]] std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const Motion& motion : account().motions)
      all.push_back(sentence_of(definition::words_of(motion, part, unknowns), part,
                                [](double value) { return format_number(value); }));
    return all;
  }

  Directions directions;
  Part part;
  Marks marks;
  Unknowns unknowns;
  std::vector<Statement> rules, dimensions;

 private:
  [[nodiscard]] const surfaces::PartSurface& surface(int face) const { return part.faces[std::size_t(face)].surface; }
  [[nodiscard]] End end(int face) const {
    return {unknowns.anchor(face), {face}, surface(face).kind != surfaces::SurfaceKind::plane};
  }
  [[nodiscard]] std::string name(const char* kind) const { return kind + std::to_string(dimensions.size()); }
};

}  // namespace epura::definition
