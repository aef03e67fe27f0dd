// SPDX-License-Identifier: Apache-2.0
// Descriptions of sheets and the drawings of their views -> positions of everything.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "annotations/balloons.hpp"
#include "composition/annotations.hpp"
#include "scene/description.hpp"
#include "sheet/paper.hpp"
#include "sheet/projection_symbol.hpp"
#include "sheet/sheet_layers.hpp"
#include "views/draw_view.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Of the sizes from which "auto" chooses, in ascending order from 0.
inline constexpr int largest_size_rank = 4;

/// The layout of a sheet, before anything is drawn on it.
struct SheetPlan {
  sheet::SheetFurniture furniture;  ///< with its paper, without labels of views
  std::vector<PlaceOnPage> places;  ///< of its views, in their order
  double scale = 1;                 ///< main scale, mm on paper per unit of the world
  bool chosen = false;              ///< the scale is the largest of ISO 5455 that fits
  bool inside = true;               ///< all ink is within the margins
  bool on_paper = true;             ///< no ink is beyond the paper
  std::optional<double> fitting{};  ///< as in Arrangement
  std::optional<int> next_size{};   ///< the least size of a larger sheet, if "auto" may choose that
  bool crowded = false;             ///< as in Arrangement

  [[nodiscard]] int size_rank() const { return next_size ? *next_size - 1 : largest_size_rank; }
};

/// Parts of the estimated room for dimensions: the first one is often enough; with the other one, views are crowded.
inline constexpr std::array smaller_rooms{0.5, 0.25};

/// Layouts with the larger part of the estimated room for dimensions, best first, that may be better than the usual
/// one.
std::vector<LayoutRequest> better_layouts(const scene::SheetDescription& sheet, const SheetPlan& usual);

/// Layouts to be tried in turn while the usual one leaves something out: larger sheets, if the size is chosen,
/// otherwise the next larger scale with less room around the views, where what has no place may find one, and smaller
/// scales.
std::vector<LayoutRequest> roomier_layouts(const scene::SheetDescription& sheet, const SheetPlan& usual);

/// Whether one layout has a smaller sheet than the other, or a larger scale on the same one.
bool is_better(const SheetPlan& one, const SheetPlan& other);

/// Whether the size of the sheet is to be chosen.
bool is_sized_by_scale(const scene::SheetDescription& sheet);

/// The usual paper for so many views unless their scale needs a larger one, and the largest one that they may get.
scene::PaperChoice usual_size(const scene::SheetDescription& sheet, std::size_t views);
scene::PaperChoice largest_size(const scene::SheetDescription& sheet, std::size_t views);

/// Height of dimension texts, mm: 2.5 for several views on A4, otherwise 3.5. ISO 3098.
double dimension_text_height(const sheet::Paper& paper, std::size_t views);

/// Positions the views on a sheet, with room for their annotations. Throws Error{input} for invalid words.
SheetPlan plan_sheet(const world::World& world, const scene::SceneDescription& scene, const SheetOfViews& sheet,
                     std::span<const view::ProjectedScene> views, const std::vector<Annotations>& annotations);

/// However small the scale, the two lines of a thread are apart on paper.
void set_least_threads(SheetOfViews& views, const SheetPlan& plan);

/// A sheet with positioned views, as input for drawing on it.
struct SheetInput {
  const world::World& world;
  const scene::SceneDescription& scene;
  const SheetOfViews& views;
  const SheetPlan& plan;
  const std::vector<Annotations>& annotations;                              ///< by view
  std::vector<std::vector<std::optional<sheet::CalloutTarget>>> targets{};  ///< of callouts, by view
  std::vector<std::vector<sheet::BalloonTarget>> balloons{};                ///< by view
  std::map<std::string, int> characteristics{};  ///< numbers of requirements that have balloons, by their keys
  std::optional<std::size_t> max_left_out{};     ///< dimensions without room; with more, the sheet is of no use

  [[nodiscard]] const scene::SheetDescription& sheet() const {
    return scene.sheets[static_cast<std::size_t>(views.sheet)];
  }
};

}  // namespace epura::pipeline
