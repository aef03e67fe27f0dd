// SPDX-License-Identifier: Apache-2.0
#include "composition/summary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "composition/annotations.hpp"
#include "composition/feature_groups.hpp"
#include "composition/feature_lines.hpp"
#include "features/assembly_features.hpp"
#include "features/true_extents.hpp"
#include "scene/choices.hpp"
#include "scene/line_roles.hpp"
#include "sheet/captions.hpp"
#include "sheet/notation.hpp"
#include "sheet/phrases.hpp"
#include "sizes/feature_table.hpp"
#include "surfaces/part_surface.hpp"
#include "world/items.hpp"

namespace epura::pipeline {

namespace {

using Texts = std::vector<std::string>;

constexpr std::size_t most_listed = 8;  // of features and parts, in a sentence

/// What is said of the models on every sheet, by the faces and features that dimensions measure.
struct ModelFacts {
  const world::World& world;
  const scene::SceneDescription& scene;
  std::array<features::Extent, 3> extents;
  features::PartFeatures features;
  std::vector<world::Item> items{};  ///< of an assembly
};

std::string list_of(const Texts& texts, std::string_view separator = "; ") {
  std::string list;
  for (const std::string& text : texts) list.append(list.empty() ? "" : separator).append(text);
  return list;
}

/// The sentences of a sheet in one language.
class Account {
 public:
  Account(std::string_view language, const FinishedSheet& finished, const scene::SheetDescription& description,
          const ModelFacts& facts)
      : language_(language),
        finished_(finished),
        description_(description),
        facts_(facts),
        notation_(notation_of(facts.world, description)) {}

  sheet::Summary take() {
    tell_kind();
    if (!facts_.world.triangles.empty()) tell_size();
    tell_faces();
    tell_material();
    tell_views();
    tell_special_views();
    if (!facts_.features.of_assembly) tell_features();
    tell_annotations();
    tell_parts();
    tell_views_without_hidden();
    tell_what_is_missing();
    check(sentences_.size() <= most_sentences, "a sheet is described in at most twelve sentences");
    return {std::string(language_), std::move(sentences_)};
  }

 private:
  [[nodiscard]] std::string say(std::string_view key, const Texts& texts = {}) const {
    return sheet::phrase(key, language_, texts);
  }
  void tell(std::string_view key, const Texts& texts) { sentences_.push_back(say(key, texts)); }
  void tell_list(std::string_view key, const Texts& texts) {
    if (!texts.empty()) tell(key, {list_of(texts)});
  }
  [[nodiscard]] std::string length(double value) const { return sheet::length_text(value, notation_); }
  [[nodiscard]] std::string unit() const { return std::string(scene::word_of(notation_.unit)); }
  // The first ones of a long list.
  [[nodiscard]] Texts shortened(Texts texts) const {
    if (texts.size() <= most_listed + 1) return texts;
    const std::size_t more = texts.size() - most_listed;
    texts.resize(most_listed);
    texts.push_back(say("more", {std::to_string(more)}));
    return texts;
  }

  void tell_kind();
  void tell_size();
  void tell_faces();
  void tell_material();
  void tell_views();
  void tell_special_views();
  void tell_features();
  void tell_annotations();
  void tell_parts();
  void tell_views_without_hidden();
  void tell_what_is_missing();
  [[nodiscard]] std::string name_of(const sheet::ViewFrame& view) const;

  std::string_view language_;
  const FinishedSheet& finished_;
  const scene::SheetDescription& description_;
  const ModelFacts& facts_;
  sheet::Notation notation_;
  Texts sentences_{};
};

void Account::tell_kind() {
  int bodies = 0;
  bool is_closed = true;
  for (const world::Placed& placed : facts_.world.models) {
    bodies += placed.mesh->report.bodies;
    is_closed = is_closed && placed.mesh->report.open_edges == 0;
  }
  const std::string& title = finished_.sheet.title;
  const std::string called = title.empty() ? "" : " \"" + title + "\"";
  if (facts_.world.triangles.empty()) return tell("wires", {called});
  if (features::is_assembly(facts_.world)) return tell("assembly", {called, std::to_string(bodies)});
  tell(is_closed ? "part" : "open", {called});
}

void Account::tell_size() {
  const auto& [width, depth, height] = facts_.extents;
  const auto size = [&](const features::Extent& extent) { return length(extent.size()); };
  if (width.is_same_as(depth) && depth.is_same_as(height)) return tell("ball", {size(width), unit()});
  for (std::size_t along = 0; along < 3; ++along) {
    const features::Extent &one = facts_.extents[(along + 1) % 3], &other = facts_.extents[(along + 2) % 3];
    if (one.is_same_as(other)) return tell("turned", {size(one), size(facts_.extents[along]), unit()});
  }
  tell("box", {size(width), size(depth), size(height), unit()});
}

void Account::tell_faces() {
  std::array<std::size_t, surfaces::surface_kind_names.size()> counts{};
  for (const world::Placed& placed : facts_.world.models) {
    if (placed.part == nullptr) return;
    for (const surfaces::PartFace& face : placed.part->faces) ++counts[static_cast<std::size_t>(face.surface.kind)];
  }
  Texts texts;
  for (std::size_t kind = 0; kind < counts.size(); ++kind)
    if (counts[kind] > 0) texts.push_back(say(surfaces::surface_kind_names[kind], {std::to_string(counts[kind])}));
  if (!texts.empty()) tell("faces", {list_of(texts, ", ")});
}

// As the title block says it.
void Account::tell_material() {
  Texts texts;
  for (const char* field : {"material", "mass"})
    if (const std::string value = description_.field(field); !value.empty())
      texts.push_back(std::string(sheet::caption(field, language_)) + " " + value);
  if (!texts.empty()) sentences_.push_back(list_of(texts) + ".");
}

std::string Account::name_of(const sheet::ViewFrame& view) const {
  const std::string words = sheet::projection_in_words(view.projection, language_);
  return view.projection.empty() ? view.name : view.name == view.projection ? words : view.name + " (" + words + ")";
}

void Account::tell_views() {
  Texts texts;
  for (const sheet::ViewFrame& view : finished_.sheet.views)
    texts.push_back(name_of(view) + (view.scale.empty() ? "" : " " + view.scale));
  tell_list("views", texts);
}

void Account::tell_special_views() {
  Texts sections, details, texts;
  for (const sheet::ViewFrame& frame : finished_.sheet.views)
    for (const scene::ViewDescription& view : facts_.scene.views) {
      if (view.name.value != frame.name) continue;
      if (view.detail.given())
        details.push_back(*view.detail);
      else if (view.section.given())
        sections.push_back(say("section", {*view.section + "-" + *view.section, frame.name}));
    }
  if (!sections.empty()) texts.push_back(say("sections", {list_of(sections, ", ")}));
  if (!details.empty()) texts.push_back(say("details", {list_of(details, ", ")}));
  tell_list("special", texts);
}

// Of chamfers, the count alone is known beyond doubt.
void Account::tell_features() {
  const features::PartFeatures& all = facts_.features;
  const sheet::FeatureTable table = sheet::feature_table({facts_.world, all, facts_.extents}, notation_);
  Texts holes, others;
  for (const FeatureGroup& group : feature_groups(all, table, notation_, language_))
    (group.are_holes ? holes : others).push_back(counted(group.features.size(), group.words));
  const auto bevels = static_cast<std::size_t>(
      std::ranges::count_if(all.bevels, [](const features::BevelFeature& one) { return one.is_chamfer; }));
  if (const std::size_t count = bevels + all.chamfers.size(); count > 0)
    others.push_back(counted(count, say("chamfer")));
  tell_list("holes", shortened(std::move(holes)));
  tell_list("others", shortened(std::move(others)));
}

void Account::tell_annotations() {
  std::array<std::size_t, 4> counts{};
  for (const sheet::Layer& layer : finished_.sheet.layers) {
    counts[0] += layer.dimensions.size();
    for (const sheet::ToleranceObject& one : layer.tolerances) counts[1] += one.rows.size();
    for (const sheet::LeaderObject& one : layer.leaders) counts[2] += one.lines.empty() ? 0 : 1;
    for (const sheet::TableObject& one : layer.tables)
      counts[3] += one.rows.size() - (one.rows.front().size() == 1 ? 1 : 0);
  }
  Texts texts;
  constexpr std::array keys{"dimensions", "tolerances", "notes", "rows"};
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) texts.push_back(say(keys[i], {std::to_string(counts[i])}));
  tell_list("annotations", texts);
}

void Account::tell_parts() {
  Texts texts;
  for (const world::Item& item : facts_.items)
    texts.push_back(counted(static_cast<std::size_t>(item.quantity), item.name));
  tell_list("parts", shortened(std::move(texts)));
}

void Account::tell_views_without_hidden() {
  const auto has_hidden = [&](const sheet::ViewFrame& view) {
    return std::ranges::any_of(finished_.sheet.layers, [&](const sheet::Layer& layer) {
      const scene::SheetLineRow* row = scene::find_line(layer.style.name);
      return row != nullptr && row->is_hidden && layer.name.starts_with(view.name + "/") && !layer.strokes.empty();
    });
  };
  Texts texts;
  for (const sheet::ViewFrame& view : finished_.sheet.views)
    if (!has_hidden(view)) texts.push_back(name_of(view));
  if (!texts.empty()) tell("no hidden", {list_of(texts, ", ")});
}

void Account::tell_what_is_missing() {
  std::size_t dimensions = 0;
  for (const std::vector<std::size_t>& of_view : finished_.left_out) dimensions += of_view.size();
  Texts texts;
  const auto add = [&](const char* key, std::size_t count) {
    if (count > 0) texts.push_back(say(key, {std::to_string(count)}));
  };
  add("dimensions without room", dimensions);
  add("texts without room", finished_.without_room);
  add("requirements", finished_.unplaced.size());
  if (finished_.lacks_lines) texts.push_back(say("some lines"));
  tell_list("not drawn", texts);
}

ModelFacts facts_of(const DescribedModels& models, const Progress& progress) {
  const world::World& world = models.world;
  ModelFacts facts{world, models.scene, features::true_extents(world),
                   features::features_to_dimension(world, progress)};
  if (features::is_assembly(world)) facts.items = world::find_items(world, models.scene.models, models.parts).items;
  return facts;
}

std::vector<sheet::Summary> summaries_of(const FinishedSheet& finished, const scene::SheetDescription& description,
                                         const ModelFacts& facts) {
  std::vector<sheet::Summary> summaries;
  const std::string_view own = sheet::language_of_phrases(description.field("language"));
  const auto add = [&](std::string_view language) {
    summaries.push_back(Account(language, finished, description, facts).take());
  };
  add(own);
  for (const std::string_view language : sheet::languages_of_phrases)
    if (language != own) add(language);
  return summaries;
}

}  // namespace

void describe(std::span<FinishedSheet> sheets, const std::vector<SheetOfViews>& views, const DescribedModels& models,
              const Budget& budget) {
  check(sheets.size() == views.size(), "each sheet has its views");
  auto summaries = budget.or_nothing([&](const Progress& progress) {
    progress.begin("describing");
    const ModelFacts facts = facts_of(models, progress);
    std::vector<std::vector<sheet::Summary>> all;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      const scene::SheetDescription& description = models.scene.sheets[static_cast<std::size_t>(views[i].sheet)];
      all.push_back(summaries_of(sheets[i], description, facts));
      if (!models.names_features || facts.features.of_assembly) continue;
      const sheet::Notation notation = notation_of(facts.world, description);
      add_features(sheets[i].sheet, facts.world, facts.features,
                   sheet::feature_table({facts.world, facts.features, facts.extents}, notation), notation,
                   all.back().front().language);
    }
    return all;
  });
  for (std::size_t i = 0; i < summaries.size(); ++i) sheets[i].sheet.summaries = std::move(summaries[i]);
}

}  // namespace epura::pipeline
