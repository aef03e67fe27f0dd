// Pages become layers of one page: all that is done with qpdf. (This pair of files is C++17, see CMakeLists.txt.)
#pragma once

#include <string>
#include <vector>

namespace epura {

struct PdfLayer {
  std::string name;
  std::string file;  ///< a PDF file of one page, drawn by Cairo
};

/// The page that holds the layers. Numbers are ready to be written.
struct PdfPage {
  std::string title;
  std::string media_box;  ///< "[0 0 width height]" in points
  std::string layer_box;  ///< the same of the layers' pages in their units
  std::string placement;  ///< matrix "a b c d e f" from the layers' units to points
};

/// Each layer becomes a form XObject in an optional content group of its name (ISO 32000-1, 8.10 and 8.11). Painted in
/// order. No date, and an identifier that follows from the contents.
std::string join_pdf_layers(const std::vector<PdfLayer>& layers, const PdfPage& page);

}  // namespace epura
