// SPDX-License-Identifier: Apache-2.0
// Annotations of the views on a sheet, placed without collisions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "composition/annotations.hpp"
#include "composition/layout.hpp"
#include "report/report.hpp"
#include "views/budget.hpp"
#include "views/draw_view.hpp"

namespace epura::pipeline {

/// Where a dimension or callout is.
struct RequirementPlace {
  std::string requirement;  ///< that it draws; empty: none
  std::size_t view;
  sheet::TurnedBox box;  ///< of the text or symbol, on paper
};

struct AnnotationLayers {
  std::vector<sheet::Layer> layers;  ///< dimensions of each view that has any, then the marks of sections
  std::vector<std::vector<sheet::Layer>> constructions;  ///< by view, to be painted first
  std::vector<std::vector<std::size_t>> left_out;  ///< by view: numbers of dimensions for which the sheet has no room
  std::vector<std::vector<std::size_t>> unseen;    ///< by view: of those that measure what the view does not show
  std::vector<std::string> unplaced{};             ///< requirements of dimensions and callouts that are not drawn
  std::vector<RequirementPlace> places{};          ///< of dimensions and callouts that are drawn
  std::size_t without_room = 0;                    ///< notes, symbols, tables, rows of hole tables, likewise
  bool is_crowded = false;                         ///< something has a place where it meets something else
  std::vector<std::string> warnings;
  std::vector<std::string> unseen_warnings;  ///< no other sheet helps
  std::vector<report::Finding> findings;

  [[nodiscard]] bool leaves_out_more_than(const std::optional<std::size_t>& most) const;
};

/// `views` are in the order of the sheet; `labels` are above them. Throws Error{input} for dimensions that cannot be
/// drawn. Returns as soon as it leaves out more dimensions than `input` permits. Opens no font if there is nothing to
/// write.
AnnotationLayers annotation_layers(const SheetInput& input, std::span<const ViewResult> views,
                                   const std::vector<sheet::Text>& labels, const Budget& budget);

}  // namespace epura::pipeline
