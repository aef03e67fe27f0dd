// SPDX-License-Identifier: Apache-2.0
#include "compare/report_pictures.hpp"

#include "compare/overlay.hpp"
#include "output/write.hpp"

namespace epura::compare {

namespace {

std::string svg_of(const sheet::Sheet& sheet) {
  output::VectorOptions options;
  options.plain = true;
  options.decimals = 3;
  return output::to_svg(sheet, options);
}

std::vector<std::string> svgs_of(const PictureFile& file) {
  std::vector<std::string> pictures;
  for (const Picture& page : file.pages) pictures.push_back(svg_of(sheet_of(page)));
  return pictures;
}

}  // namespace

ReportedCase add_pictures(ReportedCase reported, const PictureFile& expected, const PictureFile& actual,
                          const Comparison& comparison) {
  reported.expected = svgs_of(expected);
  reported.actual = svgs_of(actual);
  for (const PageComparison& page : comparison.pages) reported.overlays.push_back(svg_of(overlay_of(page)));
  return reported;
}

}  // namespace epura::compare
