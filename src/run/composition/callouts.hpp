// SPDX-License-Identifier: Apache-2.0
// Notes and symbols with leaders: what they point at, in views that are drawn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "annotations/callouts.hpp"
#include "drawing/view_drawing.hpp"
#include "scene/description.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// A note or symbol of a view.
struct ViewCallout {
  scene::CalloutDescription description;
  std::variant<Vec3, Vec2> to;  ///< in the world, or on the sheet, mm
  bool is_moved = false;        ///< an aligned section turned it there
};

/// A callout for messages: its first words.
std::string name_of(const scene::CalloutDescription& callout);

struct CalloutTargets {
  /// In the order of the callouts; nothing where the view does not show the point of a requirement.
  std::vector<std::optional<sheet::CalloutTarget>> targets;
  std::vector<std::string> warnings;  ///< of points that the view hides
};

/// Where the leaders of a view end; by default with an arrow on a line and with a dot on a face. `world` is what the
/// view shows. Throws Error{input} for points that the view does not show: outside of its bodies and lines, left out,
/// or behind the viewer; and for datums that are not on a line; but not in a partial view, which may lack that line,
/// and not for requirements of files, for which nobody chose the point.
CalloutTargets find_targets(const world::World& world, const drawing::ViewDrawing& drawing,
                            std::span<const ViewCallout> callouts, bool is_partial);

/// The name of the view in which a callout with a leader or at a dimension stands.
const std::string& view_of_callout(const scene::CalloutDescription& callout, const scene::SceneDescription& scene);

/// Throws Error{input} for tolerances that refer to datums which are not on their sheets, and for two datums with one
/// letter on a sheet. The views of callouts must exist.
void expect_datums(const scene::SceneDescription& scene);

/// The height of its text or symbol, mm.
double height_of(const scene::CalloutDescription& callout, double text_height);

/// A callout without its leader.
sheet::Callout drawn(const scene::CalloutDescription& callout, const sheet::DimensionStyle& style);

}  // namespace epura::pipeline
