// SPDX-License-Identifier: Apache-2.0
// Requirements as characteristics of QIF 3.0: what their definitions and nominals hold, in the order of the schema.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "importer/requirements.hpp"

namespace epura::qif {

/// Units of a document: those that all values have in it.
struct Units {
  double length = 1;  ///< mm
};

/// Ids in the document of what a requirement belongs to.
struct CharacteristicLinks {
  std::vector<int> nominal_features, feature_items;
  int datum_frame = 0;  ///< 0: it refers to no datum
};

/// `Flatness` of FlatnessCharacteristicDefinition. A requirement for which QIF has no kind, or needs what the file does
/// not say, is a UserDefinedAttribute that says it in words.
std::string kind_of(const importer::ModelRequirement& one, const CharacteristicLinks& links);

/// Adds what belongs to the definition behind its id; `words` are the whole requirement.
void add_definition(pugi::xml_node definition, const importer::ModelRequirement& one, const CharacteristicLinks& links,
                    const std::string& words, const Units& units);

/// Adds what belongs to the nominal behind the id of its definition.
void add_nominal(pugi::xml_node nominal, const importer::ModelRequirement& one, const CharacteristicLinks& links,
                 const Units& units);

/// Of modifiers in words, of a tolerance or of a datum that it refers to: "maximum material requirement, reciprocity
/// requirement" is MAXIMUM_RPR.
std::string material_of(std::string_view modifiers);

/// Helpers for elements with one text.
void add_text(pugi::xml_node node, const char* name, const std::string& text);
void add_number(pugi::xml_node node, const char* name, double value);
/// `<name n="2"><Id>4</Id><Id>7</Id></name>`; nothing if there are none.
void add_ids(pugi::xml_node node, const char* name, const std::vector<int>& ids);

}  // namespace epura::qif
