// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/library.hpp"

// By this name the program finds it.
extern "C" {
__attribute__((visibility("default"))) extern const epura::output::PdfLibrary epura_pdf_library;
const epura::output::PdfLibrary epura_pdf_library{&epura::output::join_pdf_layers, &epura::output::read_pdf_contents};
}
