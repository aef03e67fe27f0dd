// SPDX-License-Identifier: Apache-2.0
// What positions along the axes of the world are measured from.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "sizes/automatic.hpp"
#include "sizes/round_ends.hpp"

namespace epura::sheet {

struct Datum {
  double at = 0;
  std::optional<Vec3> centre{};  ///< of a round end, a hole or a shaft, where extension lines begin
};

/// Along each axis, in all views: the left or lower end of the models in the first view that shows the axis. Where that
/// end is round, and a view shows it so, the other one; the centre of the round one where both are.
std::array<Datum, 3> usual_datums(const DimensionSubject& subject, std::span<const RoundEnd> ends,
                                  std::span<const NamedProjection* const> views);

/// Whether a place can be a datum: it is on a face, at a vertex, or where three plane faces would meet, as at a corner
/// that is rounded off.
bool is_on_models(const world::World& world, const Vec3& place);

/// What automatic dimensions are wanted from: an axis, or along each axis of the world the plane or the end of the
/// models at a place; nothing along axes of which that says nothing. Throws Error{input} if nothing is there.
using ChosenDatums = std::array<std::optional<Datum>, 3>;
ChosenDatums chosen_datums(const scene::DimensionDescription& wanted, const DimensionSubject& subject);

}  // namespace epura::sheet
