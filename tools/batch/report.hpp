// SPDX-License-Identifier: Apache-2.0
// What became of the jobs of a batch, as a page and for CI servers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/manifest.hpp"

namespace epura {

/// A page with the drawings of all jobs, their warnings, times and failures, and a search by name. It holds no picture:
/// the drawings, or the pictures of those that browsers cannot show, are shown from their places relative to that of
/// the page, which is at `file`.
std::string batch_page(const std::vector<JobRecord>& records, const std::filesystem::path& file);

/// Whether the page can show a file by itself.
bool is_picture(const std::string& path);

/// JUnit XML: a job without a right drawing is an error.
std::string batch_junit(const std::vector<JobRecord>& records);

}  // namespace epura
