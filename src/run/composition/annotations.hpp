// SPDX-License-Identifier: Apache-2.0
// Dimensions and sections of a scene -> annotations of each view on a sheet.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "composition/callouts.hpp"
#include "scene/description.hpp"
#include "sheet/notation.hpp"
#include "sizes/automatic.hpp"
#include "sizes/hole_table.hpp"
#include "sizes/matches.hpp"
#include "view/projected_scene.hpp"
#include "views/sections.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// The letter of an auxiliary view, and the image of the direction in which it is seen; length 1.
struct ViewArrow {
  std::string letter;
  Vec2 sight;
};

/// Automatic sizes, and what the scene says more of them by their texts.
struct MatchedSizes {
  std::vector<std::string> texts{};  ///< of all sizes
  std::vector<std::string> where{};  ///< the places of [[dimension]]s whose pattern is met
  std::vector<sheet::OtherMatch> others{};

  void add(const MatchedSizes& more) {
    texts.insert(texts.end(), more.texts.begin(), more.texts.end());
    where.insert(where.end(), more.where.begin(), more.where.end());
    others.insert(others.end(), more.others.begin(), more.others.end());
  }
};

struct Annotations {
  std::vector<scene::DimensionDescription> dimensions;
  std::size_t found = 0;  ///< how many of them, the first ones, the scene does not ask for one by one
  std::vector<std::vector<scene::FeatureCircle>> equal{};  ///< by dimension found: where it may stand instead
  std::vector<scene::DimensionDescription> unturned{};     ///< of an aligned section: the same on the models themselves
  std::vector<cut::CuttingSurface> planes;                 ///< of sections marked in this view
  std::vector<sheet::HoleTable> tables{};                  ///< of holes in this view
  std::vector<scene::DetailDescription> details{};         ///< of this view, shown by other views of the scene
  std::vector<ViewArrow> arrows{};                         ///< of auxiliary views beside this one
  std::vector<ViewCallout> callouts{};                     ///< with leaders into this view
  std::vector<scene::CalloutDescription> attached{};       ///< in line with dimensions of this view
  bool balloons = false;                                   ///< the view may have balloons
  std::optional<Vec3> centre_of_gravity{};                 ///< of the models, if its symbol is wanted
  std::array<std::size_t, 3> unplaced{};                   ///< as in features::PartFeatures, in the first view
  sheet::Omitted omitted{};                                ///< of automatic dimensions, in the first view
  MatchedSizes sizes{};                                    ///< if the scene says more of automatic ones by their text
};

/// By view of the sheet; `seen` has the projected views in the same order. A dimension without a view belongs to the
/// first view of the scene; overall dimensions without view and direction are on the first sheet. A section shown by
/// some view of the sheet is marked in the first uncut view that sees its plane edge-on. Throws Error{input} for
/// overall dimensions that no view shows, and for dimensions and leaders to points of the models in exploded views,
/// where positions differ from `world`.
std::vector<Annotations> annotate(const world::World& world, const scene::SceneDescription& scene,
                                  const SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                                  const SectionSurfaces& sections);

/// Whether the standard in its title block is one of ASME: signs are those of ASME Y14.5 where ISO has others.
bool follows_asme(const scene::SheetDescription& sheet);

/// How dimensions of a sheet are written.
sheet::Notation notation_of(const world::World& world, const scene::SheetDescription& sheet);

/// Throws Error{input} for dimensions, leaders and balloons in views that do not exist, and for lists and notes on such
/// sheets.
void expect_views_of_annotations(const scene::SceneDescription& scene);

}  // namespace epura::pipeline
