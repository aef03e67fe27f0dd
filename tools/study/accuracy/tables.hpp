// SPDX-License-Identifier: Apache-2.0
// Measurements as tables of texts: CSV, JSON and HTML are made from the same table.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sheet/sheet.hpp"
#include "study/accuracy/measure.hpp"

namespace epura::study {

struct Table {
  struct Column {
    std::string name;     ///< in CSV and JSON: E_max_mm
    std::string meaning;  ///< a sentence
    bool number = true;
    bool printed = false;  ///< also on pages, which are narrower
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
};

/// A row for each method with each set of parameters.
Table table_of(std::span<const ViewMeasurements> views);

/// RFC 4180.
std::string to_csv(const Table& table);
/// A list of objects; numbers remain numbers, and infinite or unknown ones become null.
std::string to_json_list(const Table& table);
/// A page with the columns that fit.
sheet::Sheet to_sheet(const Table& table, const std::string& title);
/// <table>
std::string to_html(const Table& table);
}  // namespace epura::study
