// SPDX-License-Identifier: Apache-2.0
// Tables of texts, as studies report them: CSV, JSON and sheets are made from the same table.
#pragma once

#include <string>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::study {

struct Table {
  struct Column {
    std::string name;     ///< in CSV and JSON: E_max_mm
    std::string meaning;  ///< a sentence
    bool number = true;
    bool printed = false;  ///< also on paper, which is narrower
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
};

/// RFC 4180.
std::string to_csv(const Table& table);
/// A list of objects; numbers remain numbers, and infinite or unknown ones become null.
std::string to_json_list(const Table& table);

enum class Columns { all, printed };
sheet::Sheet to_sheet(const Table& table, const std::string& title, Columns columns);

}  // namespace epura::study
