// SPDX-License-Identifier: Apache-2.0
// Positions and scale of the views on a sheet. ISO 5456-2.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "projection/projection.hpp"
#include "sheet/paper.hpp"
#include "sheet/projection_symbol.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/view_table.hpp"

namespace epura::sheet {

/// What a view is to the others. The first six have fixed places; `other` views share their scale (auxiliary views,
/// sections); `pictorial` ones have another scale where theirs has no room.
enum class ViewPlace { front, back, left, right, top, bottom, pictorial, other };

/// By what the projection does, whatever its name: principal where the projectors are perpendicular to the plane, along
/// a world axis, and the page stands as ISO 128-3 has it; `other` for other directions perpendicular to a world axis;
/// all else is pictorial.
ViewPlace view_place(const projection::Projection& projection);

/// A view that is to be placed. Windows of one world have a common origin.
struct ViewToPlace {
  ViewPlace place = ViewPlace::other;
  projection::Window box;          ///< of its ink in the projection plane
  std::optional<double> scale{};   ///< its own
  std::optional<Vec2> at{};        ///< required centre of its ink, mm
  Vec2 before{0, 0}, after{0, 0};  ///< mm to be kept free around the ink: left and below, right and above
};

/// Where views may be placed: in the drawing area of the paper, next to the title block.
struct DrawingRoom {
  Paper paper;                                ///< width 0: it is cut to the drawing
  std::optional<Rectangle> title_block = {};  ///< in the lower right corner
  double clearance = 0;                       ///< mm kept free inside the drawing area and around the title block
  double gap = 20;                            ///< mm between views; less where the paper is too small for it
};

/// Room above the ink of a view that is labelled, mm.
inline constexpr double label_room = 10;

struct Arrangement {
  Paper paper;                  ///< with its size settled
  double scale;                 ///< of all non-pictorial views without their own scale
  std::vector<ViewSpot> views;  ///< as they were given
  bool inside;                  ///< all in the drawing area, and nothing over anything else
};

/// In first-angle projection the view from above is below the front view, that from the left to its right; in third
/// angle projection above and to the left. The rear view is at the far right. Principal views are aligned with the
/// front view, there or not; a second view with the same place is an `other` one, and so is one with its own scale. The
/// others stand in the largest part of the sheet that is left. Each group is centred in its room. One view alone stands
/// as in place_ink. `views` has at least one. Throws Error{input} beyond `longest_side`.
Arrangement arrange(std::span<const ViewToPlace> views, const scene::ScaleChoice& choice, ProjectionAngle angle,
                    const DrawingRoom& room);

}  // namespace epura::sheet
