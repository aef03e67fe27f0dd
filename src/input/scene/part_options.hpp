// SPDX-License-Identifier: Apache-2.0
// The options of the parts of a scene. docs/scenes.md is generated from these tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/option.hpp"

namespace epura::scene {

/// A dimension whose anchors are listed by key, with models not yet resolved.
struct DimensionWords {
  DimensionDescription description;
  std::vector<std::pair<std::string, AnchorWords>> anchors;
};

/// A thread, with the model of its position not yet resolved.
struct ThreadWords {
  ThreadDescription description;
  Located<AnchorWords> at;
};

/// A note or symbol beside a view, with the model of its target not yet resolved.
struct CalloutWords {
  CalloutDescription description;
  Located<LeaderWords> to;
};

/// A requirement, with the models of its features not yet resolved.
struct RequirementWords {
  RequirementDescription description;
  Located<AnchorWords> feature, to;
};

/// What is accepted of a feature, with its model not yet resolved.
struct AcceptedWords {
  AcceptedDescription description;
  Located<AnchorWords> feature;
};

/// Returns a function that finds a member of the description in parsed words.
template <class Member>
auto in_description(Member member) {
  return [member](auto& words) -> auto& { return words.description.*member; };
}

Options<ModelDescription> model_options();
Options<StyleDescription> style_options();
Options<SectionDescription> section_options();
Options<DetailDescription> detail_options();
Options<BrokenOutDescription> broken_out_options();
Options<RevolvedDescription> revolved_options();
Options<ExplodeDescription> explode_options();
Options<ViewDescription> view_options();
Options<ViewDescription> line_options();  ///< of views: what is drawn, and how
Options<DimensionWords> dimension_options();
Options<ThreadWords> thread_options();
Options<CalloutWords> note_options();
Options<CalloutWords> tolerance_frame_options();
Options<CalloutWords> datum_options();
Options<CalloutWords> texture_options();
Options<RequirementWords> requirement_options();
Options<AcceptedWords> accepted_options();
Options<TableDescription> table_options();
Options<RevisionDescription> revision_options();
Options<PartsListDescription> parts_list_options();
Options<SheetDescription> sheet_options();
Options<TitleBlockFields> title_block_options();

/// Copies the values that were given in `other`.
template <class Part>
void overrule(Part& part, const Part& other, const Options<Part>& options) {
  for (const Option<Part>& one : options)
    if (one.overrule) one.overrule(part, other);
}

/// Sets a field, and removes earlier fields with this name.
void set_field(TitleBlockFields& fields, const std::string& name, const LocatedText& text);

}  // namespace epura::scene
