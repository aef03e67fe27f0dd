// SPDX-License-Identifier: Apache-2.0
#include "sizes/placed_balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

std::vector<int> find_placed_balls(const features::PartFeatures& features, const Notation& notation) {
  std::vector<int> placed;
  for (std::size_t i = 0; i < features.balls.size(); ++i) {
    const features::BallFeature& ball = features.balls[i];
    const auto is_alike = [&](const auto& one) {
      return one.model == ball.model &&
             (are_written_alike(one.radius, ball.radius, notation) || std::abs(one.radius - ball.radius) <= ball.doubt);
    };
    if (std::none_of(features.arcs.begin(), features.arcs.end(), is_alike) &&
        std::none_of(features.rounds.begin(), features.rounds.end(), is_alike))
      placed.push_back(static_cast<int>(i));
  }
  return placed;
}

bool ends_models(const features::BallFeature& ball, int axis, const features::Extent& extent) {
  check(ball.radius > 0 && axis >= 0 && axis < 3, "a ball has a radius");
  const double slack = 10 * features::same_size * ball.radius + ball.doubt, at = ball.centre[axis];
  return std::abs(at + ball.radius - extent.to) <= slack || std::abs(at - ball.radius - extent.from) <= slack;
}

}  // namespace epura::sheet
