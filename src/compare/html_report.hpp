// SPDX-License-Identifier: Apache-2.0
// HTML pages for reviewing differences: old drawing, overlay and new drawing side by side.
#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace epura::compare {

/// One drawing, or one case of a suite. Pictures are whole SVG documents.
struct ReportedCase {
  std::string name;
  bool good;
  std::string words;                                          ///< what was found, in lines
  std::vector<std::string> expected{}, overlays{}, actual{};  ///< by page; empty if there is no drawing
};

/// The case with the pictures of both files and of what differs.
ReportedCase add_pictures(ReportedCase reported, const PictureFile& expected, const PictureFile& actual,
                          const Comparison& comparison);

/// A page of HTML that needs no other file: cases with differences first, those that are good as a list of names.
std::string html_report(const std::string& title, const std::vector<ReportedCase>& cases);

}  // namespace epura::compare
