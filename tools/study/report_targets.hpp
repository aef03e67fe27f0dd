// SPDX-License-Identifier: Apache-2.0
// Output files of reports, and their formats by file name.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "views/choose.hpp"

namespace epura::study {

template <class Format>
struct ReportTarget {
  std::string path;  ///< "-" is standard output
  Format format;
};

/// Determined before any work is done. `dash_format` names the format of "-". Throws Error{input} for unknown formats.
template <class Format>
std::vector<ReportTarget<Format>> report_targets(const std::vector<std::string>& paths, const std::string& dash_format,
                                                 const std::vector<std::pair<std::string, Format>>& formats) {
  std::vector<ReportTarget<Format>> targets;
  for (const std::string& path : paths) {
    std::string name = path == "-" ? dash_format : std::filesystem::path(path).extension().string();
    if (name.starts_with(".")) name.erase(0, 1);
    targets.push_back(
        {path, pipeline::choose<Format>(path == "-" ? "--output -, --format" : path, to_lower(name), formats)});
  }
  return targets;
}

}  // namespace epura::study
