// SPDX-License-Identifier: Apache-2.0
// Tables of jobs: CSV files, and TOML files with [[job]].
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/toml_tree.hpp"

namespace epura {

/// One row: names of columns and values, those of empty cells left out.
struct TableRow {
  std::string where;  ///< "jobs.csv:3"
  std::vector<std::pair<std::string, scene::TomlValue>> cells;
};

/// Returns the rows of a file, whose extension decides: .toml, or else CSV (RFC 4180; separated by commas, semicolons
/// or tabs, whichever comes first in the heading). Throws Error{input} with the line.
std::vector<TableRow> read_job_table(const std::string& path);

}  // namespace epura
