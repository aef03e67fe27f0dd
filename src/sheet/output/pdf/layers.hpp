// SPDX-License-Identifier: Apache-2.0
// Assembles drawings of layers into pages with optional content.
#pragma once

#include <string>
#include <vector>

#include "output/attachments.hpp"
#include "output/pdf/tags.hpp"

namespace epura::output {

/// A named view of a page.
struct PdfBookmark {
  std::string title;
  std::string view;  ///< how it fits the window: "/Fit" or "/FitR left bottom right top" in points
};

/// A page with layers, painted in order. Numbers are in their final text form.
struct PdfPage {
  std::string file;                 ///< a PDF file with one page for each layer, drawn by Cairo
  std::vector<std::string> layers;  ///< their names
  std::string media_box;            ///< "[0 0 width height]" in points
  std::string placement;            ///< matrix "a b c d e f" from the layers' units to points
  PdfBookmark bookmark;
  std::vector<PdfBookmark> views;  ///< below the bookmark of the page
  PdfTags tags{};                  ///< of an archive
};

struct PdfDocument {
  std::vector<PdfPage> pages;
  std::string title, author, subject;     ///< empty: not given
  std::vector<Attachment> attachments{};  ///< sorted by name
  bool is_archive = false;                ///< PDF/A-3b and PDF/UA-1; the title is not empty then
  std::string language{};                 ///< of the texts: "en" (RFC 3066)
};

/// Each layer is a content stream of its page, in an optional content group of its name (ISO 32000-1, 7.7.3 and 8.11);
/// names that an earlier page already has get a number. (Simple programs find no texts in form XObjects.) Bookmarks are
/// outlines (12.3.3). Attachments are embedded files of the document with their relation (ISO 19005-3, 6.8). There is
/// no date, and the identifier is derived from the contents.
std::string join_pdf_layers(const PdfDocument& document);

}  // namespace epura::output
