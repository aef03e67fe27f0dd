// SPDX-License-Identifier: Apache-2.0
// Parts with automatic dimensions in three views, of which some can be taken away or changed.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "features/assembly_features.hpp"
#include "mesh/read.hpp"
#include "sizes/automatic.hpp"
#include "sizes/free_faces.hpp"
#include "sizes/noted_dimensions.hpp"
#include "sizes/rebuilt_part.hpp"
#include "sizes/text_judge.hpp"

namespace epura::test {

inline world::World world_of(const std::string& obj) {
  world::World world = world::make_world({{std::make_shared<const mesh::Mesh>(mesh::read_mesh(obj, "part.obj"))}});
  for (world::Placed& placed : world.models)
    placed.part = std::make_shared<const surfaces::PartFaces>(surfaces::recognise_faces(*placed.mesh));
  return world;
}

inline std::vector<sheet::NamedProjection> three_views() {
  std::vector<sheet::NamedProjection> views{{"front", {}}, {"top", {}}, {"left", {}}};
  const std::array<std::array<Vec3, 2>, 3> axes{
      {{Vec3(1, 0, 0), Vec3(0, 0, 1)}, {Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, -1, 0), Vec3(0, 0, 1)}}};
  for (std::size_t i = 0; i < 3; ++i) {
    projection::Projection& view = views[i].projection;
    view.u = axes[i][0];
    view.v = axes[i][1];
    view.n = view.projector = glm::cross(view.u, view.v);
  }
  return views;
}

/// What is said of a part, and of its texts.
struct Said : sheet::FreeFaces {
  std::vector<std::string> untrue, unjudged;
};

/// A part, and its automatic dimensions in three views.
class DimensionedPart {
 public:
  explicit DimensionedPart(const std::string& obj, HoleDimensions holes = HoleDimensions::notes)
      : world_(world_of(obj)), extents_(features::true_extents(world_)) {
    const std::vector<sheet::NamedProjection> views = three_views();
    const features::PartFeatures features = features::features_to_dimension(world_);
    scene::DimensionDescription wanted;
    wanted.type = {DimensionType::automatic, ""};
    wanted.holes = {holes, ""};
    const auto plan = sheet::automatic_dimensions(wanted, views, {world_, features, extents_}, {},
                                                  std::vector<sheet::DimensionsInView>());
    omitted = plan.omitted;
    for (const sheet::NamedProjection& view : views) {
      std::vector<scene::DimensionDescription> own;
      for (const scene::DimensionDescription& one : plan.dimensions)
        if (*one.view == view.name) own.push_back(one);
      for (const sheet::AnchoredDimension& one : sheet::find_anchors(world_, own)) texts.push_back(one.text);
      views_.push_back({view.name, view.projection, sheet::find_anchors(world_, own)});
      for (const sheet::HoleTable& table : plan.tables)
        for (const sheet::HoleRow& row : table.rows)
          if (table.view == view.name) views_.back().sizes_in_tables[row.label] = row.size;
    }
  }

  std::vector<std::string> general;  ///< notes without a leader
  definition::RuleSet rules = definition::rules_of(definition::Standard::iso);

  [[nodiscard]] Said free() const { return find_in(views_); }

  /// Without one of its dimensions, counted over all views.
  [[nodiscard]] Said free_without(std::size_t number) const { return find_in(views_without(number)); }

  /// With another text of one of them, and with a second one of the same if `doubled`.
  [[nodiscard]] Said with_text(std::size_t number, const std::string& text, bool doubled) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) {
      if (number < view.dimensions.size()) {
        if (doubled) view.dimensions.push_back(view.dimensions[number]);
        view.dimensions[number].text = text;
        break;
      }
      number -= view.dimensions.size();
    }
    return find_in(views);
  }

  /// With another text of one of them, and a second one like it that is changed.
  [[nodiscard]] Said with_second(std::size_t number, const std::string& text,
                                 const std::function<void(sheet::AnchoredDimension&)>& change) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) {
      if (number < view.dimensions.size()) {
        view.dimensions.push_back(view.dimensions[number]);
        change(view.dimensions.back());
        view.dimensions[number].text = text;
        break;
      }
      number -= view.dimensions.size();
    }
    return find_in(views);
  }

  /// Without one of its dimensions, but with a note whose leader ends at a place.
  [[nodiscard]] Said noted_instead(std::size_t number, const std::string& text, const Vec3& at) const {
    std::vector<sheet::DimensionsInView> views = views_without(number);
    views.front().notes.push_back({text, at});
    return find_in(views);
  }

  /// The same with a note without a leader.
  [[nodiscard]] Said said_instead(std::size_t number, const std::string& text) const {
    DimensionedPart part = *this;
    part.views_ = views_without(number);
    part.general.push_back(text);
    return part.free();
  }

  /// With a note whose leader ends at a place.
  [[nodiscard]] Said with_note(const std::string& text, const Vec3& at) const {
    std::vector<sheet::DimensionsInView> views = views_;
    views.front().notes.push_back({text, at});
    return find_in(views);
  }

  /// With a note without a leader.
  [[nodiscard]] Said with_general(const std::string& text) const {
    DimensionedPart part = *this;
    part.general.push_back(text);
    return part.free();
  }

  [[nodiscard]] Said without_centre_lines() const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) view.has_centre_lines = false;
    return find_in(views);
  }

  /// With another text in the row of a label.
  [[nodiscard]] Said with_row(const std::string& label, const std::string& size) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views)
      if (view.sizes_in_tables.contains(label)) view.sizes_in_tables[label] = size;
    return find_in(views);
  }

  /// Found again from its dimensions; without one of them, counted over all views.
  [[nodiscard]] std::optional<sheet::RebuiltPart> rebuilt(std::optional<std::size_t> without = std::nullopt) const {
    return sheet::rebuild_part(without ? views_without(*without) : views_, world_, extents_, {}, rules);
  }

  /// What its lengths of a type measure from point to point, without auxiliary ones.
  [[nodiscard]] std::vector<double> lengths_of(DimensionType type) const {
    std::vector<double> lengths;
    for (const sheet::DimensionsInView& view : views_)
      for (const sheet::AnchoredDimension& dimension : view.dimensions)
        if (dimension.type == type && !dimension.text.starts_with('('))
          lengths.push_back(std::round(1e4 * glm::distance(dimension.points[0], dimension.points[1])) / 1e4);
    return lengths;
  }

  std::vector<std::string> texts;
  sheet::Omitted omitted;
  sheet::Notation notation;  ///< in which texts are read

 private:
  [[nodiscard]] Said find_in(const std::vector<sheet::DimensionsInView>& views) const {
    sheet::JudgedTexts texts_judged = sheet::judge_texts(views, general, world_, notation);
    const auto given = sheet::with_noted_sizes(views, general, world_, notation);
    return {sheet::find_free_faces(given, world_, extents_, notation, rules), std::move(texts_judged.untrue),
            std::move(texts_judged.unjudged)};
  }

  [[nodiscard]] std::vector<sheet::DimensionsInView> views_without(std::size_t number) const {
    std::vector<sheet::DimensionsInView> views = views_;
    for (sheet::DimensionsInView& view : views) {
      if (number < view.dimensions.size()) {
        view.dimensions.erase(view.dimensions.begin() + static_cast<std::ptrdiff_t>(number));
        break;
      }
      number -= view.dimensions.size();
    }
    return views;
  }

  world::World world_;
  std::array<features::Extent, 3> extents_;
  std::vector<sheet::DimensionsInView> views_;
};

// A block of 60 x 40 x 10 whose upper edge is cut off from (50, 10) to (60, 4).
inline const char* const sloped_block =
    "v 0 0 0\nv 60 0 0\nv 60 0 4\nv 50 0 10\nv 0 0 10\nv 0 40 0\nv 60 40 0\nv 60 40 4\nv 50 40 10\nv 0 40 10\n"
    "f 1 2 3 4 5\nf 10 9 8 7 6\nf 1 6 7 2\nf 2 7 8 3\nf 3 8 9 4\nf 4 9 10 5\nf 5 10 6 1\n";

}  // namespace epura::test
