// SPDX-License-Identifier: Apache-2.0
// Assembles drawings of layers into pages with optional content.
#pragma once

#include <string>
#include <vector>

namespace epura::output {

struct PdfLayer {
  std::string name;
  std::string file;  ///< a PDF file of one page, drawn by Cairo
};

/// A named view of a page.
struct PdfBookmark {
  std::string title;
  std::string view;  ///< how it fits the window: "/Fit" or "/FitR left bottom right top" in points
};

/// A page with layers, painted in order. Numbers are in their final text form.
struct PdfPage {
  std::vector<PdfLayer> layers;
  std::string media_box;  ///< "[0 0 width height]" in points
  std::string layer_box;  ///< the same for the layers' pages, in their units
  std::string placement;  ///< matrix "a b c d e f" from the layers' units to points
  PdfBookmark bookmark;
  std::vector<PdfBookmark> views;  ///< below the bookmark of the page
};

struct PdfDocument {
  std::vector<PdfPage> pages;
  std::string title, author, subject;  ///< empty: not given
};

/// Each layer becomes a form XObject in an optional content group of its name (ISO 32000-1, 8.10 and 8.11); names that
/// an earlier page already has get a number. Bookmarks are outlines (12.3.3). There is no date, and the identifier is
/// derived from the contents.
std::string join_pdf_layers(const PdfDocument& document);

}  // namespace epura::output
