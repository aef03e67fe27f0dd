// SPDX-License-Identifier: Apache-2.0
#include "base/shared_library.hpp"
#include "output/cairo/library.hpp"
#include "output/pdf/library.hpp"
#include "output/write.hpp"

namespace epura::output {

namespace {

const CairoLibrary& cairo_library() {
  return own_table<CairoLibrary>(EPURA_CAIRO_LIBRARY, "epura_cairo_library", "epura needs it for PDF, PS, EPS and PNG");
}

}  // namespace

const PdfLibrary& pdf_library() {
  return own_table<PdfLibrary>(EPURA_PDF_LIBRARY, "epura_pdf_library", "epura needs it for PDF files");
}

std::string to_pdf(const Pages& sheets, const Progress& progress, const VectorOptions& options) {
  const PdfLibrary& library = pdf_library();  // before work that would be lost without it
  PdfDocument document = cairo_library().make_pdf_layers(sheets, options.pdf, progress);
  document.attachments = options.attachments;
  return library.join_layers(document);
}

std::string to_ps(const Pages& sheets, const Progress& progress) { return cairo_library().make_ps(sheets, progress); }

std::string to_eps(const sheet::Sheet& sheet, const Progress& progress) {
  return cairo_library().make_eps(sheet, progress);
}

std::string to_png(const sheet::Sheet& sheet, double dpi, const Progress& progress) {
  return cairo_library().make_png(sheet, dpi, progress);
}

}  // namespace epura::output
