// SPDX-License-Identifier: Apache-2.0
// A view as automatic dimensions see it: what it shows in true length, and where.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cut/cutting_surface.hpp"
#include "projection/projection.hpp"

namespace epura::sheet {

struct NamedProjection {
  std::string name;  ///< of the view
  projection::Projection projection;
  const cut::CuttingSurface* section = nullptr;  ///< that it shows; null if it shows the whole
  double slack = 0;                              ///< up to which points are on the planes of the section
  std::function<bool(const Vec3&)> shows{};      ///< whether nothing hides a point of the models; empty: as if nothing
                                                 ///< hid any
  bool shows_inside = true;                      ///< a section, or with hidden lines

  /// Of an aligned section, which shows parts of the models elsewhere.
  [[nodiscard]] bool aligned() const { return section != nullptr && section->aligned; }
};

/// Whether a view shows what is at a point of the models, seen or hidden.
bool keeps(const NamedProjection& view, const Vec3& point);

/// Where a view shows what is at a point of the models: an aligned section may turn it. Nothing if it leaves it out.
std::optional<Vec3> shown_point(const NamedProjection& view, const Vec3& point);

/// Whether a view shows what is around an axis through a point where it is: an aligned section does around the axes of
/// its turns, and in the plane that is not turned.
bool shows_in_place(const NamedProjection& view, const Vec3& point, const Vec3& axis);

/// Whether positions along an axis of the world have their true distances in a view, if it shows them as lengths.
bool keeps_positions(const NamedProjection& view, int axis);

}  // namespace epura::sheet
