// SPDX-License-Identifier: Apache-2.0
#include "world/expect_usable.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"

namespace epura::world {

void expect_usable(const World& world) {
  const auto far = std::find_if(world.points.begin(), world.points.end(), [](const Vec3& p) { return !is_usable(p); });
  if (far == world.points.end()) return;
  const auto next = std::upper_bound(world.first_vertex.begin(), world.first_vertex.end(),
                                     static_cast<int>(far - world.points.begin()));
  const auto model = static_cast<std::size_t>(next - world.first_vertex.begin()) - 1;
  const Vec3 size = glm::abs(*far);
  throw Error(ErrorKind::input, world.models[model].mesh->report.name,
              "has a vertex at " + format_rounded(std::max({size.x, size.y, size.z}), 3) + ", allowed is up to " +
                  format_number(largest_number),
              "is the file whole, and are its unit and its transforms right?");
}

}  // namespace epura::world
