// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include "base/error.hpp"
#include "base/text.hpp"
#include "compare/align_views.hpp"
#include "compare/comparison.hpp"
#include "compare/page_differences.hpp"

namespace epura::compare {

namespace {

constexpr double same_size = 1e-3;  // of sheets, mm: PDF points are rounded

std::string format_size(const Vec2& size) { return format_fixed(size.x, 3) + " x " + format_fixed(size.y, 3) + " mm"; }

// A page that only one drawing has is compared with an empty one. `any_dashes`: all dash patterns count as the same.
Picture page_of(const PictureFile& file, std::size_t page, bool any_dashes) {
  Picture picture = page < file.pages.size() ? file.pages[page] : Picture{Vec2(0, 0)};
  for (PictureLook& look : picture.looks)
    if (any_dashes && !look.dashes.empty()) look.dashes = look.is_short ? std::vector<double>() : some_dashes;
  return picture;
}

// `in_place`: views stand where the space of their models puts them.
void compare_page(Picture before, const Picture& after, double tolerance, bool in_place, Comparison& comparison) {
  PageComparison page{glm::max(before.size, after.size)};
  std::vector<Difference> found;
  if (!in_place) found = align_views(before, after, tolerance);
  if (glm::distance(before.size, after.size) > same_size) {
    Difference& size = found.emplace_back();
    size.change = Change::size;
    size.before = format_size(before.size);
    size.after = format_size(after.size);
  }
  InkDifferences ink = compare_ink(before, after, tolerance);
  page.pieces = std::move(ink.marked);
  found.insert(found.end(), ink.differences.begin(), ink.differences.end());
  if (comparison.compares_texts) {
    TextDifferences texts = compare_texts(before, after, tolerance);
    page.texts = std::move(texts.marked);
    found.insert(found.end(), texts.differences.begin(), texts.differences.end());
  }
  comparison.followers += take_followers(found, tolerance);
  const auto key = [](const Difference& d) {
    return std::tuple(!d.is_view, d.change, std::tie(d.view, d.before, d.after), d.from.x, d.from.y, d.to.x, d.to.y);
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Difference& a, const Difference& b) { return key(a) < key(b); });
  comparison.pages.push_back(std::move(page));
  for (Difference& difference : found) {
    difference.page = static_cast<int>(comparison.pages.size());
    comparison.differences.push_back(std::move(difference));
  }
}

}  // namespace

std::string_view name_of(Change change) {
  constexpr std::array<std::string_view, 7> names = {"size",       "removed",  "added", "moved",
                                                     "visibility", "restyled", "text"};
  return names[static_cast<std::size_t>(change)];
}

Comparison compare(const PictureFile& before, const PictureFile& after, double tolerance) {
  if (before.is_json != after.is_json)
    throw Error(ErrorKind::input, "compare",
                "drawing JSON has views without their sheet, and the other file has sheets",
                "compare JSON with JSON, and SVG or PDF with SVG or PDF");
  Comparison comparison;
  const bool any_pdf = before.is_pdf || after.is_pdf;
  comparison.compares_texts = before.is_pdf == after.is_pdf;
  for (std::size_t i = 0; i < std::max(before.pages.size(), after.pages.size()); ++i)
    compare_page(page_of(before, i, any_pdf), page_of(after, i, any_pdf), tolerance,
                 before.is_in_place || after.is_in_place, comparison);
  comparison.requirements = compare_requirements(before.requirements, after.requirements);
  return comparison;
}

}  // namespace epura::compare
