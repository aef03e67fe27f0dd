// SPDX-License-Identifier: Apache-2.0
// What is to be constructed in a view.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "scene/construction_choice.hpp"

namespace epura::construction {

struct Request {
  scene::ConstructionItem item;
  std::string where;             ///< for errors
  std::vector<Vec3> elements{};  ///< the ends of the edge, the vertex, or the corners of the face in order
  bool optional = false;         ///< part of "all": nothing is drawn if it does not exist
};

/// What constructions refer to.
struct Surroundings {
  Box box;                                        ///< of the models
  double reach = 0;                               ///< mm: from the principal point to the farthest ink
  std::vector<std::array<Vec3, 2>> axis_edges{};  ///< visible edges along an axis of the world
};

/// "true-shape:2:auxiliary", "true-length:0-1:auxiliary"
inline bool by_change_of_planes(const Request& request) { return request.item.text.ends_with(":auxiliary"); }

[[noreturn]] inline void refuse(const Request& request, const std::string& reason, const std::string& hint) {
  throw Error(ErrorKind::input, request.where, "'" + request.item.text + "' " + reason, hint);
}

}  // namespace epura::construction
