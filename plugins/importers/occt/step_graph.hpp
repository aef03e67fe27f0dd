// SPDX-License-Identifier: Apache-2.0
// The statements of a STEP file that tell what the part is required to be, by number.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "part21.hpp"

namespace occt {

using EntityNumber = unsigned long long;

class StepGraph {
 public:
  /// Keeps statements about shape aspects, dimensions, tolerances, datums, measures, units and annotations; geometry is
  /// skipped.
  /// They refer to the text, which must remain.
  explicit StepGraph(std::string_view text);

  /// Null if the file has no such statement, or it is skipped.
  [[nodiscard]] const Statement* find(EntityNumber number) const;
  [[nodiscard]] const std::map<EntityNumber, Statement>& statements() const { return statements_; }

 private:
  std::map<EntityNumber, Statement> statements_;
};

/// Goes through the records of a statement and of those to which it leads, each statement once. `find` returns the
/// statement with a number, or null; `follows` sees each record and says whether its references lead on.
void visit_parts(EntityNumber root, const std::function<const Statement*(EntityNumber number)>& find,
                 const std::function<bool(EntityNumber owner, const Record& record)>& follows);

/// The record of this kind; null if the statement has none.
const Record* record_of(const Statement& statement, std::string_view keyword);

bool has_record(const Statement& statement, bool (*is_one)(std::string_view keyword));

/// The argument at this place, from 0; empty if there are fewer.
std::string_view argument_of(const Record& record, std::size_t place);

/// The last argument, which a kind has of its own, whether the record has those that it inherits or not; empty if there
/// are none.
std::string_view last_argument_of(const Record& record);

/// All numbers "#12" in a text, in its order.
std::vector<EntityNumber> references_in(std::string_view text);

/// The names of all enumerations ".MAXIMUM_MATERIAL." in a text, as words: "maximum material".
std::vector<std::string> enumerations_in(std::string_view text);

/// The text between apostrophes in UTF-8; empty if there are none.
std::string unquoted(std::string_view text);

/// With small letters from A to Z.
std::string lower_case(std::string text);

/// "SURFACE_PROFILE" as "surface profile".
std::string words_of(std::string_view keyword);

/// Adds a word to a list of them, unless it is empty.
void append(std::string& list, std::string_view word, std::string_view between = ", ");

}  // namespace occt
