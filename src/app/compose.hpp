// Drawings in their places -> sheets of paper.
#pragma once

#include <span>
#include <vector>

#include "app/pipeline.hpp"
#include "app/targets.hpp"
#include "scene/description.hpp"
#include "sheet/paper.hpp"

namespace epura {

/// A sheet before anything is drawn on it.
struct SheetPlan {
  Paper paper;
  std::vector<PlaceOnPage> places;  ///< of its views, in their order
  double scale = 1;                 ///< main scale
  bool inside = true;               ///< all ink keeps the margins
};

/// Where the views of a sheet stand. `boxes` are of their ink in the projection plane.
SheetPlan plan_sheet(const SheetDescription& sheet, std::span<const ViewDescription> views,
                     std::span<const Window> boxes);

/// The drawings of one sheet, in order of its views, with all that belongs to them, and what a sheet has around.
FinishedSheet compose(const SceneDescription& scene, const SheetPlan& plan, std::vector<ViewResult>& views,
                      std::span<const ViewWish> wishes, int sheet);

}  // namespace epura
