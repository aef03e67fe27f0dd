// SPDX-License-Identifier: Apache-2.0
// Sheets -> the bytes of a file. Only encoding happens here.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "output/vector_options.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

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
std::string to_pdf(const Pages& sheets, const Progress& progress = {}, const VectorOptions& options = {});
std::string to_ps(const Pages& sheets, const Progress& progress = {});
std::string to_eps(const sheet::Sheet& sheet, const Progress& progress = {});
std::string to_png(const sheet::Sheet& sheet, double dpi, const Progress& progress = {});
/// In millimetres.
std::string to_dxf(const sheet::Sheet& sheet, const VectorOptions& options = {}, const Progress& progress = {});

}  // namespace epura::output
