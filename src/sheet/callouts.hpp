// SPDX-License-Identifier: Apache-2.0
// Notes and symbols beside a view, with leaders into it. ISO 128-22.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "scene/description.hpp"
#include "sheet/dimensions/dimensions.hpp"
#include "sheet/dimensions/marks.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Where a leader ends.
struct CalloutTarget {
  Vec2 point;                                   ///< on paper
  scene::LeaderEnd end{scene::LeaderEnd::dot};  ///< not automatic
};

/// A text or symbol; its lower left corner is the origin until it has its place. Millimetres.
struct Callout {
  std::string name{};  ///< for messages
  std::vector<Text> texts{};
  Vec2 size{0, 0};
  bool underlined = false;                ///< its leader continues as a reference line below it
  std::optional<CalloutTarget> target{};  ///< without one, it has no leader
  std::optional<Vec2> at{};               ///< its upper left corner, if that is given
};

/// Lines of text. With a leader, they stand on its reference line.
Callout note_callout(const std::vector<std::string>& lines, bool has_leader, const DimensionStyle& style);

/// Numbered notes below a heading, with lines that are broken at blanks to be no longer than `width`, if possible.
Callout general_notes(const std::string& heading, std::span<const std::vector<std::string>> notes, double width,
                      const DimensionStyle& style);

/// The box of one with a given position.
Rectangle box_at(const Callout& callout, const Vec2& upper_left);

/// Adds the texts of one without a leader.
void draw_at(Layer& layer, const Callout& callout, const Vec2& upper_left);

/// Room beside a view for callouts of this height, mm.
double callout_room(double height);

/// What `place_callouts` could not do.
struct CalloutFaults {
  std::vector<std::string> without_place;  ///< names of those that are left out
  std::vector<std::string> crossings;      ///< names of those at a given position on something else
};

/// Places callouts with leaders one after another, those with given positions first: outside the view if possible,
/// clear of its lines and of the neighbours; leaders are oblique, cross no lettering, and other lines only if there is
/// no other way.
CalloutFaults place_callouts(Layer& layer, std::span<const Callout> callouts, const drawing::ViewDrawing& view,
                             const DimensionStyle& style, const Neighbours& neighbours);

}  // namespace epura::sheet
