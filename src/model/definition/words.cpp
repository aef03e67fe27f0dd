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

// The direction in which all move, and about which all turn, as one body; those of planes only as far as is seen of it.
void say_what(Words& words, const std::vector<Change>& changes, const surfaces::PartSurface& surface) {
  Vec3 move(0), turn(0);
  bool any_size = false;
  for (const Change& change : changes) {
    if (glm::length(change.move) > glm::length(move) * (1 + same_size)) move = change.move;
    if (glm::length(change.turn) > glm::length(turn) * (1 + same_size)) turn = change.turn;
    any_size = any_size || change.has_size();
  }
  const bool turns = glm::length(turn) > 0;
  words.is_move = !turns && glm::length(move) > 0;
  if (turns) {
    words.along = glm::normalize(turn);
    words.can = "can turn about " + direction_text(turn);
    words.add = "an angle";
  } else if (words.is_move) {
    const std::string along = direction_text(move);
    words.along = glm::normalize(move);
    words.can = any_size ? "can grow as its place moves along " + along : "can move along " + along;
    words.add = std::string(any_size ? "a radius, or " : "") + "a distance along " + along;
  } else if (any_size) {
    if (surfaces::has_axis(surface.kind)) words.along = surface.axis;
    words.can = std::string(size_name(changes.front(), surface.kind)) + " free";
    words.add = surface.kind == SurfaceKind::cone ? "a diameter, an angle or a length" : "a radius or diameter";
  }
}

}  // namespace

std::string name_of_face(const Face& face, const LengthText& length, int number) {
  const surfaces::PartSurface& surface = face.surface;
  std::string name = std::string(surfaces::surface_kind_names[static_cast<std::size_t>(surface.kind)]);
  if (surface.kind == SurfaceKind::cylinder || surface.kind == SurfaceKind::sphere)
    name += " R" + length(surface.radius);
  if (surface.kind == SurfaceKind::torus)
    name += " R" + length(surface.minor) + " around ⌀" + length(2 * surface.radius);
  name += " face" + (number > 0 ? " " + std::to_string(number) : "");
  return name + " of " + format_rounded(face.area, 4) + " mm² at (" + length(face.at.x) + ", " + length(face.at.y) +
         ", " + length(face.at.z) + ")";
}

Words words_of(const Motion& motion, const Part& part, const Unknowns& unknowns) {
  Words words{-1, 0, "", "", Vec3(0), false};
  std::vector<Change> changes;
  std::size_t count = 0;
  for (const int face : motion.faces) {
    const Face& one = part.faces[static_cast<std::size_t>(face)];
    changes.push_back(change_of(face, motion, unknowns));
    if (one.area <= 0) continue;
    ++count;
    if (words.face < 0 || one.area > part.faces[static_cast<std::size_t>(words.face)].area * (1 + same_size))
      words.face = face;
  }
  if (words.face < 0) return words;
  words.others = count - 1;
  say_what(words, changes, part.faces[static_cast<std::size_t>(words.face)].surface);
  return words;
}

std::string sentence_of(const Words& words, const Part& part, const LengthText& length, int number) {
  return name_of_face(part.faces[static_cast<std::size_t>(words.face)], length, number) + more_faces(words.others) +
         ": " + words.can + "; add " + words.add;
}

}  // namespace epura::definition
