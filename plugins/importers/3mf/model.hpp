// SPDX-License-Identifier: Apache-2.0
// The build of a 3MF package, read by lib3mf.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace epura::plugin::threemf {

/// A positioned object.
struct Placed {
  std::uint32_t object;
  Transform transform;
  std::string name{};  ///< of a build item: its part number
};

/// A mesh or a set of other objects.
struct Object {
  std::string name;
  std::vector<Point> points{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  std::vector<Placed> components{};
  std::optional<std::array<double, 3>> colour{};  ///< sRGB, each part from 0 to 1
  std::size_t beams = 0;
  bool has_slices = false;
};

struct Model {
  double millimetres = 1;  ///< length of its unit
  std::map<std::uint32_t, Object> objects;
  std::vector<Placed> items;  ///< objects to build
  std::vector<std::string> warnings;
};

/// `goes_on` is called with the progress from 0 to 1, and returns whether to continue. Throws std::runtime_error with a
/// sentence.
Model read_model(const std::string& package, const std::function<bool(double)>& goes_on);

}  // namespace epura::plugin::threemf
