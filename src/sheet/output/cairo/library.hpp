// SPDX-License-Identifier: Apache-2.0
// Everything that uses Cairo. It is a separate library, loaded when a file is first drawn by Cairo: with its
// dependencies, which are those of screens, it takes a sixth of the time of a small drawing.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "output/pdf/layers.hpp"
#include "output/write.hpp"

namespace epura::output {

/// What is joined to a PDF file.
PdfDocument make_pdf_layers(const Pages& sheets, PdfKind kind, const Progress& progress);

// The functions of output/write.hpp with names that begin with `to`.
std::string make_ps(const Pages& sheets, const Progress& progress);
std::string make_eps(const sheet::Sheet& sheet, const Progress& progress);
std::string make_png(const sheet::Sheet& sheet, double dpi, const Progress& progress);

struct CairoLibrary {
  decltype(&output::make_pdf_layers) make_pdf_layers;
  decltype(&output::make_ps) make_ps;
  decltype(&output::make_eps) make_eps;
  decltype(&output::make_png) make_png;
};

}  // namespace epura::output
