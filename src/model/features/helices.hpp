// SPDX-License-Identifier: Apache-2.0
// Helices through the crests of screw threads: their hand, their pitch, and their size by ISO 261.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/range.hpp"
#include "base/vec.hpp"
#include "scene/threads.hpp"

namespace epura::features {

/// Points of a helix: turns around its axis, and heights along it.
using TurnsAndHeights = std::vector<Vec2>;

/// The vertices at the crests of a thread; lengths are in units of the file.
struct Crests {
  TurnsAndHeights points;
  double radius = 0;  ///< of the cylinder on which they lie
  bool internal = false;
  Range heights{};  ///< of the whole thread
};

/// The `i`th of numbers below `count` that are spread over all of them. Even steps might meet the same column of a mesh
/// again and again.
std::size_t scattered(std::size_t i, std::size_t count);

/// Whether no gap between points is wide. There must be at least one.
bool goes_around(TurnsAndHeights points);

/// The size whose diameter is nearest, of those whose pitch is that of the crests, with "-LH" if they are left-handed.
/// `unit` is the length of the file's unit in mm.
std::optional<scene::Thread> best_size(const Crests& crests, double unit);

/// The largest pitch of which the crests are a helix, in units of the file, if they have enough turns of it: smaller
/// ones may suit rows of vertices as well. Many more vertices than turns prevent that some pitch suits by chance.
std::optional<double> pitch_of(const Crests& crests);

}  // namespace epura::features
