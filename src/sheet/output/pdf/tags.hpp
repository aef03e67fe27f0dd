// SPDX-License-Identifier: Apache-2.0
// What a page means, for programs that read it to people: elements in the order of reading, and which ink is whose.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace epura::output {

/// An element of the logical structure. ISO 32000-1, 14.7 and 14.8.4.
struct PdfElement {
  std::string type;     ///< "Figure"
  std::string words{};  ///< what it shows; empty: its texts say it
  int parent = -1;      ///< an earlier element of the page; -1: the page
  int columns = 1;      ///< of a table, over which a cell goes
};

/// Ink of a layer that belongs together: a run of its texts, or all its other ink.
struct PdfMark {
  int element;                                 ///< -1: an artifact, which is not read (14.8.2.2)
  std::size_t begin_texts = 0, end_texts = 0;  ///< equal: strokes, fills and pictures
};

struct PdfTags {
  std::vector<PdfElement> elements{};         ///< in the order of reading, parents before children
  std::vector<std::vector<PdfMark>> marks{};  ///< for each layer, in the order of painting; all ink has one
  std::string language = "en";                ///< of the words
};

/// The name of the tag with which marks are drawn; their number is the place in the list of the layer.
inline constexpr const char* mark_tag = "NonStruct";

}  // namespace epura::output
