// SPDX-License-Identifier: Apache-2.0
// Notes and symbols beside a view, with leaders into it. ISO 128-22.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dimensions/dimensions.hpp"
#include "drawing/view_drawing.hpp"
#include "scene/description.hpp"
#include "sheet/marks.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The rim of a hole as a view shows it: an ellipse with two conjugate radii, mm.
struct RimOnPaper {
  Vec2 centre, u, v;

  /// Its point in a direction from the centre.
  [[nodiscard]] Vec2 towards(const Vec2& along) const {
    const Vec2 part = Vec2(cross(along, v), cross(u, along)) / cross(u, v);
    return centre + along / glm::length(part);
  }
};

/// Where a leader ends.
struct CalloutTarget {
  Vec2 point;                       ///< on paper
  LeaderEnd end{LeaderEnd::dot};    ///< not automatic
  std::optional<Vec2> normal{};     ///< of the line there; length 1
  bool is_border = false;           ///< leaders come from the side of the normal: from outside
  bool in_line = false;             ///< leaders run along the normal: in line with a dimension line
  std::optional<RimOnPaper> rim{};  ///< leaders end where they come to it, on their way to its centre
};

/// How a leader reaches a callout: as a reference line below it; by a short horizontal line beside it; or from the
/// triangle of a datum, perpendicular to the line on which that stands.
enum class LeaderForm { reference, landing, datum };

/// A text or symbol; its lower left corner is the origin until it has its place. Millimetres.
struct Callout {
  std::string name{};         ///< for messages
  std::string requirement{};  ///< of a model file that it draws
  std::vector<Text> texts{};
  std::vector<Stroke> strokes{};  ///< as wide as the lines of the lettering
  std::vector<Fill> fills{};
  std::vector<ToleranceObject> tolerances{};  ///< their ink is that of the callout
  Vec2 size{0, 0};
  LeaderForm form = LeaderForm::reference;
  double attach = 0;                         ///< height at which a landing meets it
  std::optional<CalloutTarget> target{};     ///< without one, it has no leader, or stands at a dimension
  std::vector<CalloutTarget> others{};       ///< where the leader may end instead
  std::string dimension{};                   ///< name of that with whose dimension line it is in line
  std::size_t end = 0;                       ///< which of its free ends, and
  bool is_alone = false;                     ///< whether the other one will do
  std::optional<Vec2> at{};                  ///< its upper left corner, if that is given
  bool all_around = false;                   ///< a circle at the bend of its leader
  std::optional<scene::DatumTarget> area{};  ///< that it means
};

/// The layers of a view with callouts: leaders with texts, and the lines of symbols.
struct CalloutLayers {
  Layer notes, symbols;
};
CalloutLayers callout_layers(const std::string& view, const DimensionStyle& style);

/// Lines of text. With a leader, they stand on its reference line.
Callout note_callout(const std::vector<std::string>& lines, bool has_leader, const DimensionStyle& style);

/// Numbered notes below a heading, with lines that are broken at blanks to be no longer than `width`, if possible.
Callout general_notes(const std::string& heading, std::span<const std::vector<std::string>> notes, double width,
                      const DimensionStyle& style);

/// The box of one with a given position.
Rectangle box_at(const Callout& callout, const Vec2& upper_left);

/// Adds one without a leader.
void draw_at(CalloutLayers& layers, const Callout& callout, const Vec2& upper_left);

/// Boxes of the outlines of cut faces, on whose hatching nothing stands.
std::vector<Rectangle> hatched_boxes(const drawing::ViewDrawing& drawing);

/// How far a point is from the border of a view, mm: items with leaders are placed in this order, since those of the
/// first ones are short and leave the others ways between them.
double inside_by(const Vec2& point, const drawing::ViewDrawing& view);

/// Room beside a view for callouts of this height, mm.
double callout_room(double height);

/// Items to be placed with the dimensions of the view: outside it if possible. Leaders of texts are oblique, those of
/// frames and datums perpendicular to the line at which they end if possible. They refer to the callouts, the view and
/// the style.
std::vector<ItemBeside> callout_items(std::span<const Callout> callouts, const drawing::ViewDrawing& view,
                                      const DimensionStyle& style);

/// Takes out arrows outside, in whose places something is in line with a dimension line, before the layer is drawn.
void take_out_replaced(PlacedLayer& placed, std::span<const Callout> callouts);

/// What is drawn, and what is not.
struct CalloutFaults {
  std::vector<std::size_t> without_place;                   ///< numbers of those that are left out
  std::vector<std::pair<std::size_t, TurnedBox>> places{};  ///< numbers of those that are drawn, and their boxes
};

/// Draws the callouts where their items are.
CalloutFaults draw_callouts(CalloutLayers& layers, std::span<const Callout> callouts, const PlacedLayer& placed,
                            const DimensionStyle& style);

}  // namespace epura::sheet
