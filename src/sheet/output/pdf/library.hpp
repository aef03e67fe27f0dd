// SPDX-License-Identifier: Apache-2.0
// Everything that uses qpdf. It is a separate library, loaded when a PDF file is first written or read: qpdf and its
// ten dependencies would take a third of the time and a quarter of the memory of a small drawing.
//
// The files in this folder are C++17, see ../CMakeLists.txt.
#pragma once

#include <string>
#include <vector>

#include "output/pdf/contents.hpp"
#include "output/pdf/layers.hpp"

namespace epura::output {

struct PdfLibrary {
  decltype(&join_pdf_layers) join_layers;
  decltype(&read_pdf_contents) read_contents;
  decltype(&read_pdf_attachments) read_attachments;
};

/// Throws Error{output} if the library is not where it was installed.
const PdfLibrary& pdf_library();

}  // namespace epura::output
