// SPDX-License-Identifier: Apache-2.0
// What people read of requirements.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "importer/requirements.hpp"

namespace epura::pipeline {

/// Millimetres or degrees in the unit in which its numbers are written: that of the file, where it has a name.
double written_unit(const importer::ModelRequirement& requirement);

/// How many decimals a number needs to be what the file states.
int needed_decimals(double written);

/// The items of a list that is one text, such as the modifiers and datums of a requirement; none of an empty one.
std::vector<std::string> items_of(std::string_view text, std::string_view separator);

/// Of the word of a modifier, "target diameter 4 mm", the length behind these letters, mm.
std::optional<double> length_in(std::string_view word, std::string_view before);

/// "diameter 35 -0.2/+0 mm", "position 0.75 mm to A | B | C", in the unit and with the decimals of the file.
std::string requirement_sentence(const importer::ModelRequirement& requirement);

/// The number by which an inspection calls each: from 1 in their order, those that are to be measured; 0 of datums and
/// of auxiliary dimensions, which are not.
std::vector<int> characteristic_numbers(const std::vector<importer::ModelRequirement>& requirements);

/// For each kind, how many there are and of which types: {"dimensions", "12: 9 diameter, 2 linear distance, 1 angle"}.
std::vector<std::pair<std::string, std::string>> requirement_lines(
    const std::vector<importer::ModelRequirement>& requirements);

}  // namespace epura::pipeline
