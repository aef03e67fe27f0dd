// SPDX-License-Identifier: Apache-2.0
// What a 3MF package builds, read by lib3mf.
#pragma once

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace epura::plugin::threemf {

/// An object, placed.
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
  std::size_t beams = 0;
  bool has_slices = false;
};

struct Model {
  double millimetres = 1;  ///< of its unit
  std::map<std::uint32_t, Object> objects;
  std::vector<Placed> items;  ///< what is built
  std::vector<std::string> warnings;
};

/// `goes_on` is told how much is done, from 0 to 1, and whether to go on. Throws std::runtime_error with a sentence.
Model read_model(const std::string& package, const std::function<bool(double)>& goes_on);

}  // namespace epura::plugin::threemf
