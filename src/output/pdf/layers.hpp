// SPDX-License-Identifier: Apache-2.0
// Assembles drawings of layers into pages with layers.
#pragma once

#include <string>
#include <vector>

namespace epura::output {

struct PdfLayer {
  std::string name;
  std::string file;  ///< a PDF file of one page, drawn by Cairo
};

/// A place of a page under its name.
struct PdfBookmark {
  std::string title;
  std::string view;  ///< how the place fits the window: "/Fit" or "/FitR left bottom right top" in points
};

/// A page that holds layers, painted in order. Numbers are ready to be written.
struct PdfPage {
  std::vector<PdfLayer> layers;
  std::string media_box;  ///< "[0 0 width height]" in points
  std::string layer_box;  ///< the same of the layers' pages in their units
  std::string placement;  ///< matrix "a b c d e f" from the layers' units to points
  PdfBookmark bookmark;
  std::vector<PdfBookmark> views;  ///< under that of the page
};

struct PdfDocument {
  std::vector<PdfPage> pages;
  std::string title, author, subject;  ///< empty: not given
};

/// Each layer becomes a form XObject in an optional content group of its name (ISO 32000-1, 8.10 and 8.11); a name that
/// an earlier page has gets a number. Bookmarks are outlines (12.3.3). No date, and an identifier that follows from the
/// contents.
std::string join_pdf_layers(const PdfDocument& document);

}  // namespace epura::output
