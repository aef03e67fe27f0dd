// SPDX-License-Identifier: Apache-2.0
// Sheets -> the bytes of a file. Only encoding happens here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "report/report.hpp"
#include "scene/choices.hpp"
#include "sheet/sheet.hpp"

template <>
struct epura::scene::Words<epura::SvgText> {
  static constexpr std::array list{"outlines", "text"};
};

namespace epura::output {

/// AutoCAD 2007 (AC1021), the first version with texts in UTF-8, or 2000 (AC1015), the first with line weights.
enum class DxfVersion { r2007, r2000 };

/// Arcs among other lines as bulges of their polylines, and ellipses as such; or all arcs as entities whose ends are
/// those of their neighbours, and ellipses as polylines, for programs that do not know the others.
enum class DxfArcs { bulges, entities };

/// Dashes as a property of their line, or each as a stroke of its own (sheet/real_dashes.hpp).
enum class Strokes { dashed, real };

}  // namespace epura::output

template <>
struct epura::scene::Words<epura::output::DxfVersion> {
  static constexpr std::array list{"2007", "2000"};
};
template <>
struct epura::scene::Words<epura::output::Strokes> {
  static constexpr std::array list{"dashed", "real"};
};
template <>
struct epura::scene::Words<epura::output::DxfArcs> {
  static constexpr std::array list{"bulges", "entities"};
};

namespace epura::output {

/// What is one entity in DXF, instead of single lines, fills and texts.
struct DxfEntities {
  bool dimensions = false, hatches = false;
};

struct VectorOptions {
  bool plain = false;             ///< omit the origin of lines
  std::optional<double> dpi{};    ///< PNG only; usually 300
  std::optional<int> decimals{};  ///< of coordinates in millimetres, SVG only; usually 4: no point is off by more than
                                  ///< 0.0001 mm
  SvgText text = SvgText::outlines;
  Strokes strokes = Strokes::dashed;  ///< of all formats with lines
  DxfVersion dxf_version = DxfVersion::r2007;
  DxfArcs dxf_arcs = DxfArcs::bulges;
  bool dxf_blocks = false;  ///< DXF: each view is a block
  DxfEntities dxf_entities{};
  bool is_inline = false;   ///< SVG as an element of an HTML page, as wide as what contains it
  std::string id_prefix{};  ///< of ids and classes in SVG; empty: derived from the content of the sheet
};

/// Returns the prefix. Throws Error{input} that names its origin `where`, unless it is a letter followed by letters,
/// digits, hyphens and underscores, 64 characters in all.
std::string checked_id_prefix(std::string prefix, const std::string& where);

inline constexpr double usual_dpi = 300;
inline constexpr int usual_decimals = 4, most_decimals = 5;

struct FileContent;

/// Sheets that become pages of one file, at least one.
using Pages = std::vector<const sheet::Sheet*>;

// The same sheet always gives the same bytes: no clock, no counter, no locale. A file is written as a whole, or
// OutOfTime is thrown.
std::string to_svg(const sheet::Sheet& sheet, const VectorOptions& options, const Progress& progress = {});
/// The same for a page of its own (to_html): views, layers and lines have their names and facts as attributes, lines
/// have no ids, and there is no style sheet, which a strict policy would refuse. Without `lines`,
/// layers of edges are empty.
std::string svg_of_page(const sheet::Sheet& sheet, const VectorOptions& options, bool lines,
                        const Progress& progress = {});
std::string to_pdf(const Pages& sheets, const Progress& progress = {});
std::string to_ps(const Pages& sheets, const Progress& progress = {});
std::string to_eps(const sheet::Sheet& sheet, const Progress& progress = {});
std::string to_png(const sheet::Sheet& sheet, double dpi, const Progress& progress = {});
/// In millimetres.
std::string to_dxf(const sheet::Sheet& sheet, const VectorOptions& options = {}, const Progress& progress = {});

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
