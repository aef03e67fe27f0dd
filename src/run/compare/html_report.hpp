// SPDX-License-Identifier: Apache-2.0
// HTML pages for reviewing differences: old drawing, overlay and new drawing side by side.
#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace epura::compare {

/// One drawing, or one case of a suite. Pictures are complete SVG documents.
struct ReportedCase {
  std::string name;
  bool good;
  std::string words;                                          ///< findings, line by line
  std::vector<std::string> expected{}, overlays{}, actual{};  ///< by page; empty if there is no drawing
};

/// Adds the pictures of both files and of their differences to a case.
ReportedCase add_pictures(ReportedCase reported, const PictureFile& expected, const PictureFile& actual,
                          const Comparison& comparison);

/// One page for browsers (output::to_html): the differences of each page, then the pages before and after, as sheets,
/// and the differences in words.
std::string overlay_page(const std::string& title, const std::string& words, const PictureFile& before,
                         const PictureFile& after, const Comparison& comparison);

/// A self-contained HTML page: cases with differences first, and those without as a list of names.
std::string html_report(const std::string& title, const std::vector<ReportedCase>& cases);

}  // namespace epura::compare
