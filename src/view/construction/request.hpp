// SPDX-License-Identifier: Apache-2.0
// What is to be constructed in a view.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "scene/construction_choice.hpp"

namespace epura::construction {

struct Request {
  scene::ConstructionItem item;
  std::string where;             ///< for errors
  std::vector<Vec3> elements{};  ///< the ends of the edge, the vertex, the corners of the face in order, or three
                                 ///< points of the plane
  bool optional = false;         ///< part of "all": nothing is drawn if it does not exist
};

/// What constructions refer to.
struct Surroundings {
  Box box;                                        ///< of the models
  double reach = 0;                               ///< mm: from the principal point to the farthest ink
  std::vector<std::array<Vec3, 2>> axis_edges{};  ///< visible edges along an axis of the world
};

/// The name of a plane, of which there are some already: α, β ...
inline std::string plane_name(int before) {
  constexpr std::array greek{"α", "β", "γ", "δ", "ε"};
  return greek[static_cast<std::size_t>(before) % greek.size()];
}

/// "of face 2", or "with the normal 0,0,1" if it is not that of a face.
inline std::string plane_text(const Request& request) {
  if (request.item.has_element) return "of face " + std::to_string(request.item.numbers[0]);
  const Vec3& n = *request.item.direction;
  return "with the normal " + format_number(n.x) + "," + format_number(n.y) + "," + format_number(n.z);
}

[[noreturn]] inline void refuse(const Request& request, const std::string& reason, const std::string& hint) {
  throw Error(ErrorKind::input, request.where, "'" + request.item.text + "' " + reason, hint);
}

}  // namespace epura::construction
