// SPDX-License-Identifier: Apache-2.0
// The model of a 3MF package: its objects, what is built of them, and what slicers say of their parts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epura::plugin::threemf {

class Package;

/// What a piece is for. All but the part tell a slicer how to print.
enum class Role { part, modifier, negative, blocker, enforcer, support, other };

/// A positioned object.
struct Placed {
  std::uint32_t object;  ///< index in Model::objects
  Transform transform;
  std::string name{};  ///< of a build item its part number, of a component that of the slicer
  Role role = Role::part;
};

/// Triangles of an object that a slicer takes for one piece.
struct Volume {
  std::size_t first, last;  ///< indices of triangles
  std::string name;
  Role role;
};

using Triangle = std::array<std::uint32_t, 3>;

/// A mesh or a set of other objects.
struct Object {
  std::string name{};
  Role role = Role::part;
  std::vector<Point> points{};
  std::vector<Triangle> triangles{};  ///< two corners may be equal
  std::vector<Volume> volumes{};      ///< empty: it is one piece
  std::vector<Placed> components{};
  std::optional<std::array<double, 3>> colour{};  ///< sRGB, each part from 0 to 1
  std::size_t beams = 0;
  bool has_slices = false;
  std::string unread{};  ///< what it is made of, if that is neither a mesh nor components
};

struct Model {
  double millimetres = 1;  ///< length of its unit
  std::vector<Object> objects{};
  std::vector<Placed> items{};                               ///< objects to build
  std::vector<std::pair<std::string, std::string>> words{};  ///< metadata that are for people: its place, and the text
};

/// `tell` receives the progress from 0 to 1. Throws std::runtime_error with a sentence.
Model read_model(const Package& package, const std::function<void(double)>& tell);

}  // namespace epura::plugin::threemf
