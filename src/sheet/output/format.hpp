// SPDX-License-Identifier: Apache-2.0
// The table of output formats, and what is written of the sheets' drawings besides pictures.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "output/vector_options.hpp"
#include "report/report.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

struct FileContent;

/// One self-contained page for a browser: the sheets, and what is known of their lines. Several sheets become one page.
/// No more than 1.3 times the size of the SVG files and 40 kB. Nothing is loaded from elsewhere.
std::string to_html(const FileContent& content, const Progress& progress = {});

/// Drawing JSON, schema 1 (docs/formats.md).
std::string to_json(const sheet::Sheet& sheet, double scale, std::span<const drawing::ViewDrawing> drawings,
                    const report::Report& report, const Progress& progress = {});

/// A sheet, and its data for JSON.
struct SheetContent {
  const sheet::Sheet& sheet;
  double scale = 1;  ///< mm on paper per unit of the world
  std::span<const drawing::ViewDrawing> drawings{};
  std::string_view answers{};  ///< to the questions about its edges
};

struct FileContent {
  std::vector<SheetContent> sheets;  ///< at least one; exactly one if the format has no pages
  const VectorOptions& options;
  const report::Report& report;
  std::string_view title{};              ///< of a page; empty: that of the first sheet
  std::string_view answers_name{"Why"};  ///< what a page calls the answers
};

/// A row of the table of formats.
struct Format {
  std::string_view name;        ///< also the extension of its files
  bool has_pages;               ///< whether several sheets go into one file
  bool has_drawings;            ///< whether it contains the drawings of the sheets as data, not as pictures
  bool has_facts;               ///< whether it contains what the model tells of the lines
  bool has_attachments;         ///< whether it carries files
  bool has_pictures;            ///< whether it shows pictures of pixels, such as logos, if it shows sheets
  std::string_view instead_of;  ///< extensions that cannot be written, for which this format is suggested
  std::string (*encode)(const FileContent&, const Progress&);
  /// Largest distance between lines and what is written of them, mm. Arcs of SVG move more than their ends.
  double (*error)(const VectorOptions&, bool has_arcs);
};

/// All output formats.
std::span<const Format> formats();
/// By file extension, in any case; nothing if it is unknown.
const Format* find_format(std::string_view extension);
/// Suggests a format to use instead of an unknown one.
std::string format_hint(std::string_view extension);
/// All extensions, for help and hints.
std::vector<std::string> format_names();

}  // namespace epura::output
