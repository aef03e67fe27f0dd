// SPDX-License-Identifier: Apache-2.0
// Sheets -> the bytes of a file. Nothing is computed here but the encoding.
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

namespace epura {

enum class Format { svg, pdf, ps, eps, png, dxf, json };

/// By file extension, in any case; nothing when unknown.
std::optional<Format> format_of(std::string_view extension);
/// What to write instead of a format that is unknown.
std::string format_hint(std::string_view extension);
/// All extensions, for help and hints.
const std::vector<std::string>& format_names();

template <>
struct Words<SvgText> {
  static constexpr std::array list{"outlines", "text"};
};

struct VectorOptions {
  bool plain = false;  ///< leave the origin of lines out
  double dpi = 300;    ///< PNG only
  int decimals = 4;    ///< of coordinates in millimetres, SVG only: no point is off by more than 0.0001 mm
  SvgText text = SvgText::outlines;
};

/// Sheets that become pages of one file, at least one.
using Pages = std::vector<const Sheet*>;

// The same sheet gives the same bytes, always: no clock, no counter, no locale. A file is written as a whole, or
// OutOfTime is thrown.
std::string to_svg(const Sheet& sheet, const VectorOptions& options, const Progress& progress = {});
std::string to_pdf(const Pages& sheets, const Progress& progress = {});
std::string to_ps(const Pages& sheets, const Progress& progress = {});
std::string to_eps(const Sheet& sheet, const Progress& progress = {});
std::string to_png(const Sheet& sheet, double dpi, const Progress& progress = {});
/// AutoCAD 2000 (AC1015), in millimetres.
std::string to_dxf(const Sheet& sheet, const Progress& progress = {});

/// Drawing JSON, schema 1 (docs/formats.md).
std::string to_json(const Sheet& sheet, double scale, std::span<const ViewDrawing> drawings, const Report& report,
                    const Progress& progress = {});

}  // namespace epura
