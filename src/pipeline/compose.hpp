// SPDX-License-Identifier: Apache-2.0
// Drawings in their places -> sheets of paper.
#pragma once

#include <span>
#include <vector>

#include "pipeline/annotations.hpp"
#include "pipeline/budget.hpp"
#include "pipeline/draw_view.hpp"
#include "pipeline/finished_sheet.hpp"
#include "pipeline/layout.hpp"
#include "pipeline/view_plan.hpp"
#include "scene/description.hpp"

namespace epura {

/// The drawings of one sheet, in order of its views, with all that belongs to them, and what a sheet has around.
/// What there is no time for is left out, and noted in the budget.
FinishedSheet compose(const World& world, const SceneDescription& scene, const SheetOfViews& views,
                      const SheetPlan& plan, std::vector<ViewResult>& results,
                      const std::vector<Annotations>& annotations, const Budget& budget);

}  // namespace epura
