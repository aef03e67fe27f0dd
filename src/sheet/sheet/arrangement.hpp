// SPDX-License-Identifier: Apache-2.0
// Positions and scale of the views on a sheet. ISO 5456-2.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "projection/projection.hpp"
#include "sheet/paper.hpp"
#include "sheet/projection_symbol.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/view_table.hpp"

namespace epura::sheet {

/// The role of a view among the others. The first six have fixed positions; `other` views (auxiliary views, sections)
/// have the same scale; `pictorial` views get another scale if there is no room for them at that one.
enum class ViewPlace { front, back, left, right, top, bottom, pictorial, other };

/// Depends on the projection itself, not on its name: principal if the projectors are perpendicular to the plane and
/// along a world axis, and up on the page is as in ISO 128-3; `other` for other orthographic views perpendicular to a
/// world axis; otherwise pictorial.
ViewPlace view_place(const projection::Projection& projection);

/// A view to be positioned. Windows of one world have a common origin.
struct ViewToPlace {
  ViewPlace place = ViewPlace::other;
  projection::Window box;         ///< of its ink, in the projection plane
  std::optional<double> scale{};  ///< the view's own
  std::optional<Vec2> at{};       ///< required centre of its ink, mm
  /// The number of its parent, and the direction on the page in which it is placed from there; length 1.
  std::optional<std::pair<std::size_t, Vec2>> beside{};
  Vec2 before{0, 0}, after{0, 0};  ///< mm to be kept free around the ink: left and below, right and above
  bool labelled = false;  ///< a label stands above the ink, in the gap to what is there if that is large enough
};

/// Where views may be positioned: in the drawing area of the paper, outside the title block.
struct DrawingRoom {
  Paper paper;                                ///< width 0: cut to the drawing
  std::optional<Rectangle> title_block = {};  ///< in the lower right corner
  double clearance = 0;                       ///< mm kept free inside the drawing area and around the title block
  double gap = 20;                            ///< mm between views; less if the paper is too small for it
};

/// Room above the ink of a labelled view, mm.
inline constexpr double label_room = 10;

struct Arrangement {
  Paper paper;                      ///< with its final size
  double scale;                     ///< of all non-pictorial views without their own scale
  std::vector<ViewSpot> views;      ///< in the order given
  bool inside;                      ///< everything is in the drawing area, and nothing overlaps
  bool on_paper = true;             ///< no ink is beyond the paper
  std::optional<double> fitting{};  ///< largest standard scale that fits: if not all is inside, or if it is larger
                                    ///< than `scale`, which leaves pictorial views more room, or if it is `crowded`
  bool crowded = false;  ///< at a given scale, all is inside, but nearer to each other or to the frame than usual
};

/// In first-angle projection, the view from above is below the front view and the view from the left to its right; in
/// third-angle projection, they are above it and to its left. The rear view is at the far right. Principal views are
/// aligned with the front view, even if that is absent; a second view with the same position, or a view with its own
/// scale, is treated as `other`. A view beside
/// a principal view, or one with a given position, is aligned with it in its direction if there is room at a good
/// scale, and is otherwise treated as `other`. The remaining views are placed in the largest free part of the sheet.
/// Each group is centred in its room. A single view is positioned as by place_ink. `views` must not be empty. Throws
/// Error{input} beyond `longest_side`.
Arrangement arrange(std::span<const ViewToPlace> views, const scene::ScaleChoice& choice, ProjectionAngle angle,
                    const DrawingRoom& room);

}  // namespace epura::sheet
