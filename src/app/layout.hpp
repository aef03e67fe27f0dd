// Descriptions of sheets and what their views look like -> where everything stands.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "app/view_dimensions.hpp"
#include "scene/description.hpp"
#include "sheet/paper.hpp"
#include "sheet/projection_symbol.hpp"

namespace epura {

enum class FrameKind { none, plain, full };

/// A sheet before anything is drawn on it.
struct SheetPlan {
  Paper paper;
  FrameKind frame = FrameKind::none;
  ProjectionAngle angle = ProjectionAngle::first;
  std::vector<PlaceOnPage> places;  ///< of its views, in their order
  double scale = 1;                 ///< main scale, mm of paper per unit of the world
  bool chosen = false;              ///< the scale is the largest of ISO 5455 that fits
  bool inside = true;               ///< all ink keeps the margins
};

/// Height of the texts of dimensions, mm: 2.5 for several views on A4, 3.5 elsewhere. ISO 3098.
double dimension_text_height(const Paper& paper, std::size_t views);

/// Where the views of a sheet stand, with room for their dimensions. Throws Error{input} for words that say nothing.
SheetPlan plan_sheet(const World& world, const SheetDescription& sheet, std::span<const ViewDescription> descriptions,
                     std::span<const View> views, const DimensionsByView& dimensions);

}  // namespace epura
