// SPDX-License-Identifier: Apache-2.0
// Positions of features along the axes of the world, and the dimensions that fix them from one end of the models.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "sheet/dimensions/automatic.hpp"

namespace epura::sheet {

/// A place along an axis of the world that a view dimensions.
struct Station {
  const NamedProjection* view;
  int axis;
  double at;
  Vec3 point;          ///< where its extension line begins
  bool in_row = true;  ///< may be one of equally spaced ones
};

/// Returns the axis of the world, 0 to 2, to which a unit vector is parallel; -1 if there is none.
int world_axis(const Vec3& direction);

/// Whether a view shows lengths parallel to its plane in true length.
bool is_plain(const projection::Projection& projection);

/// Collects stations, each once.
class Stations {
 public:
  explicit Stations(const DimensionSubject& subject);

  /// Notes that a place follows from other dimensions.
  void know(int axis, double at);
  [[nodiscard]] bool is_known(int axis, double at) const;
  /// Adds a place unless it is known. Of points at the same place in one view, the one farthest below counts, or for
  /// vertical dimensions farthest on the right: on that side the dimension line is expected.
  void add(const Station& station);

  /// Dimensions of all stations, from the left or lower end of the models in their view.
  [[nodiscard]] std::vector<scene::DimensionDescription> dimensions(const std::string& where, int decimals) const;

 private:
  [[nodiscard]] Vec3 base_of(const NamedProjection& view, int axis) const;

  const DimensionSubject& subject_;
  double slack_;
  std::array<std::vector<double>, 3> known_;
  std::vector<Station> stations_;
};

}  // namespace epura::sheet
