// SPDX-License-Identifier: Apache-2.0
#include "output/pdf/library.hpp"

// By this name the program finds it.
extern "C" {
__attribute__((visibility("default"))) extern const epura::PdfLibrary epura_pdf_library;
const epura::PdfLibrary epura_pdf_library{&epura::join_pdf_layers, &epura::read_pdf_contents};
}
