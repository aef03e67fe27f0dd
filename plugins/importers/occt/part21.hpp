// SPDX-License-Identifier: Apache-2.0
// The statements of a STEP file as text (ISO 10303-21): for what Open CASCADE skips without a word.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace occt {

/// "#12=KEYWORD(arguments);", or one of the records of "#12=(KEYWORD(arguments)KEYWORD(arguments));".
struct Record {
  std::string_view keyword;
  std::string_view arguments;  ///< between the parentheses
};

struct Statement {
  unsigned long long number = 0;
  std::vector<Record> records{};
};

/// Calls visit for each statement of the data sections. What is no statement is skipped.
void visit_statements(std::string_view text, const std::function<void(const Statement&)>& visit);

/// The arguments of a record, or the elements of a list with its parentheses.
std::vector<std::string_view> arguments_of(std::string_view text);

/// The arguments of a record, of which the first may be a list.
std::vector<std::string_view> separated(std::string_view text);

/// The number of "#12"; 0 if it is none.
unsigned long long reference_in(std::string_view text);

/// The whole file.
std::string text_of(const std::string& path);

}  // namespace occt
