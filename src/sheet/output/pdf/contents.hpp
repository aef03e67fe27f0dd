// SPDX-License-Identifier: Apache-2.0
// The raw content of a PDF file written by epura.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "output/attachments.hpp"

namespace epura::output {

struct PdfGlyph {
  std::string words;  ///< what it stands for, UTF-8
  double width;       ///< thousandths of the font's size
};

/// What a font shows for the bytes of a string. ISO 32000-1, 9.4.3.
struct PdfFont {
  std::size_t bytes = 1;                     ///< of each glyph
  std::map<std::string, PdfGlyph> glyphs{};  ///< by their bytes
};

/// Content streams are uncompressed. ISO 32000-1, 7.8.2.
struct PdfContent {
  double width = 0, height = 0;  ///< points
  std::string page{};
  std::map<std::string, std::string> layers{};  ///< names of optional content by "/layer0"
  std::map<std::string, std::string> forms{};   ///< content by "/layer0"
  std::map<std::string, PdfFont> fonts{};       ///< by "/f-0-0"
};

/// One for each page. Throws Error{input}, also for files that unpack to more data than drawings have.
std::vector<PdfContent> read_pdf_contents(const std::string& bytes, const std::string& where);

/// The files that it carries, by name; the names may be any. Throws the same.
std::vector<Attachment> read_pdf_attachments(const std::string& bytes, const std::string& where);

}  // namespace epura::output
