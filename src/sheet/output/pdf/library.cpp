// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/library.hpp"

// The program finds the library's functions by this name.
extern "C" {
__attribute__((visibility("default"))) extern const epura::output::PdfLibrary epura_pdf_library;
const epura::output::PdfLibrary epura_pdf_library{&epura::output::join_pdf_layers, &epura::output::read_pdf_contents,
                                                  &epura::output::read_pdf_attachments};
}
