// SPDX-License-Identifier: Apache-2.0
// Dimensions that can be given of a face, whatever feature it belongs to.
#pragma once

#include <optional>
#include <vector>

#include "sizes/planning.hpp"
#include "sizes/sheet_reading.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

/// What a dimension measures of a face; the first is what an office would rather give.
enum class Measure : unsigned char { size, place, angle, width, edge };

struct FaceDimension {
  Measure measure;
  Planned planned;  ///< one dimension or place
};

class FaceDimensions {
 public:
  /// Of the only model. It refers to what it is given.
  FaceDimensions(const Planning& plan, const SheetReading& reading);

  /// All that views show in true form.
  [[nodiscard]] std::vector<FaceDimension> of(int face) const;
  /// The faces that touch one, in the order of their contacts; a face may be there twice.
  [[nodiscard]] std::vector<int> beside(int face) const;

 private:
  [[nodiscard]] const definition::Face& face_of(int number) const {
    return reading_.drawn.part.faces[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] std::vector<Vec3> points_of(int face) const;
  [[nodiscard]] bool is_fillet(int face) const;
  void add_size(std::vector<FaceDimension>& found, int face) const;
  void add_tube(std::vector<FaceDimension>& found, int face) const;
  void add_ball(std::vector<FaceDimension>& found, int face) const;
  void add_places(std::vector<FaceDimension>& found, int face) const;
  void add_slant(std::vector<FaceDimension>& found, int face) const;
  void add_places_on_slope(std::vector<FaceDimension>& found, int face) const;
  void add_angles(std::vector<FaceDimension>& found, int face) const;
  void add_cone_angle(std::vector<FaceDimension>& found, int face) const;
  void add_rims(std::vector<FaceDimension>& found, int face) const;
  void add_edges(std::vector<FaceDimension>& found, int face) const;
  void add_corners(std::vector<FaceDimension>& found, int face) const;
  void add_widths(std::vector<FaceDimension>& found, int face) const;
  void add_widths_of_arm(std::vector<FaceDimension>& found, int face) const;
  [[nodiscard]] int boss_beside(int face, const surfaces::PartSurface& axis) const;
  void add_width(std::vector<FaceDimension>& found, Measure measure, int face, const Vec3& to) const;
  void add(std::vector<FaceDimension>& found, Measure measure, scene::DimensionDescription dimension) const;
  void add_slanted(std::vector<FaceDimension>& found, Measure measure, const Planned& places) const;

  const Planning& plan_;
  const SheetReading& reading_;
  std::optional<world::PlacedPart> part_;
  std::vector<Vec3> all_points_;
  std::vector<std::vector<int>> contacts_;  // of each face, their numbers
  double slack_;
};

}  // namespace epura::sheet
