// SPDX-License-Identifier: Apache-2.0
#include "definition/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/text.hpp"
#include "definition/limits.hpp"

namespace epura::definition {

namespace {

using surfaces::SurfaceKind;

// What one face does.
struct Change {
  Vec3 move{0}, turn{0};
  std::array<double, 3> sizes{};  // radius, minor, angle

  [[nodiscard]] bool has_size() const { return sizes != std::array<double, 3>{}; }
};

Change change_of(int face, const Motion& motion, const Unknowns& unknowns) {
  Change change;
  for (const Term& term : motion.change) {
    const Unknown& unknown = unknowns[term.unknown];
    if (unknown.face != face) continue;
    if (unknown.kind == UnknownKind::move)
      change.move += term.factor * unknown.along;
    else if (unknown.kind == UnknownKind::turn)
      change.turn += term.factor * unknown.along;
    else
      change.sizes[static_cast<std::size_t>(unknown.kind) - static_cast<std::size_t>(UnknownKind::radius)] =
          term.factor;
  }
  return change;
}

// "x", or "(0.6, 0.8, 0)", to one side.
std::string direction_text(Vec3 direction) {
  direction = glm::normalize(direction);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) > 1 - drawn_parallel * drawn_parallel)
      return std::array{"x", "y", "z"}[static_cast<std::size_t>(axis)];
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) > drawn_parallel) {
      if (direction[axis] < 0) direction = -direction;
      break;
    }
  const auto text = [](double value) { return format_rounded(std::abs(value) < drawn_parallel ? 0 : value, 3); };
  return "(" + text(direction.x) + ", " + text(direction.y) + ", " + text(direction.z) + ")";
}

const char* size_name(const Change& change, SurfaceKind kind) {
  if (change.sizes[2] != 0) return change.sizes[0] != 0 ? "its angle and diameter are" : "its angle is";
  if (change.sizes[1] != 0) return change.sizes[0] != 0 ? "both its radii are" : "the radius of its section is";
  return kind == SurfaceKind::torus  ? "the diameter of its ring is"
         : kind == SurfaceKind::cone ? "its diameter or place is"
                                     : "its radius is";
}

std::string more_faces(std::size_t count) {
  return count == 0 ? "" : " and " + std::to_string(count) + (count == 1 ? " more face" : " more faces");
}

struct Words {
  std::string can, add;
};

// The direction in which all move, and about which all turn, as one body; those of planes only as far as is seen of it.
Words words_for(const std::vector<Change>& changes, SurfaceKind kind) {
  Vec3 move(0), turn(0);
  bool any_size = false;
  for (const Change& change : changes) {
    if (glm::length(change.move) > glm::length(move) * (1 + same_size)) move = change.move;
    if (glm::length(change.turn) > glm::length(turn) * (1 + same_size)) turn = change.turn;
    any_size = any_size || change.has_size();
  }
  const bool turns = glm::length(turn) > 0, moves_too = glm::length(move) > 0;
  if (any_size && !turns && !moves_too)
    return {std::string(size_name(changes.front(), kind)) + " free",
            kind == SurfaceKind::cone ? "a diameter, an angle or a length" : "a radius or diameter"};
  if (turns) return {"can turn about " + direction_text(turn), "an angle"};
  const std::string along = direction_text(move);
  return any_size ? Words{"can grow as its place moves along " + along, "a radius, or a distance along " + along}
                  : Words{"can move along " + along, "a distance along " + along};
}

}  // namespace

std::string name_of_face(const Face& face, const LengthText& length) {
  const surfaces::PartSurface& surface = face.surface;
  std::string name = std::string(surfaces::surface_kind_names[static_cast<std::size_t>(surface.kind)]);
  if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::sphere)
    name += " R" + length(surface.radius);
  if (surface.kind == SurfaceKind::torus)
    name += " R" + length(surface.minor) + " around ⌀" + length(2 * surface.radius);
  return name + " face of " + format_rounded(face.area, 4) + " mm² at (" + length(face.at.x) + ", " +
         length(face.at.y) + ", " + length(face.at.z) + ")";
}

std::string sentence_of(const Motion& motion, const Part& part, const Unknowns& unknowns, const LengthText& length) {
  std::vector<Change> changes;
  int largest = -1;
  std::size_t count = 0;
  for (const int face : motion.faces) {
    const Face& one = part.faces[static_cast<std::size_t>(face)];
    changes.push_back(change_of(face, motion, unknowns));
    if (one.area <= 0) continue;
    ++count;
    if (largest < 0 || one.area > part.faces[static_cast<std::size_t>(largest)].area * (1 + same_size)) largest = face;
  }
  if (largest < 0) return "";
  const Face& named = part.faces[static_cast<std::size_t>(largest)];
  const Words words = words_for(changes, named.surface.kind);
  return name_of_face(named, length) + more_faces(count - 1) + ": " + words.can + "; add " + words.add;
}

}  // namespace epura::definition
