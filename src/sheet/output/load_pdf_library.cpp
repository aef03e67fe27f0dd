// SPDX-License-Identifier: Apache-2.0
#include "base/shared_library.hpp"
#include "output/pdf/library.hpp"

namespace epura::output {

const PdfLibrary& pdf_library() {
  return own_table<PdfLibrary>(EPURA_PDF_LIBRARY, "epura_pdf_library", "epura needs it for PDF files");
}

}  // namespace epura::output
