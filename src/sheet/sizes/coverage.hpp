// SPDX-License-Identifier: Apache-2.0
// Which sizes of the features of the models have no dimension, and which have several.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "sheet/notation.hpp"
#include "sizes/automatic.hpp"
#include "sizes/dimensions_in_view.hpp"

namespace epura::sheet {

struct Coverage {
  std::vector<report::SizeCount> counts;  ///< of kinds that there are
  std::vector<std::string> undimensioned;
  std::vector<std::string> repeated;
  std::vector<std::string> views_to_add;  ///< each once: they show what no view shows
  std::string transform_to_add{};         ///< instead of these, where the part lies askew (own_frame.hpp)
};

/// Along each axis of the world, places of features are nodes and dimensions join them: a place that no chain of
/// dimensions joins to the ends of the models is not dimensioned, and a dimension between places that are joined
/// already repeats others. A diameter joins the middle of a circle with its sides. A text that begins with "4×" counts
/// for four equal features; a text in brackets is auxiliary (ISO 129-1) and counts for nothing. `held`: by face of the
/// only model, whether dimensions hold it, of whatever feature (free_faces.hpp); empty where nobody can tell.
Coverage find_coverage(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                       const Notation& notation, std::span<const char> held = {});

}  // namespace epura::sheet
