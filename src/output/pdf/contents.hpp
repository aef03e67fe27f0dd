// What stands in a PDF file that epura wrote, before it is understood.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace epura {

/// An operator of a content stream with its operands. ISO 32000-1, 7.8.2.
struct PdfOperation {
  std::string name;                  ///< "l", "cm" ...
  std::vector<double> numbers{};     ///< those in lists, too
  std::vector<std::string> words{};  ///< names, with their slash
};

struct PdfContent {
  double width = 0, height = 0;  ///< points
  std::vector<PdfOperation> operations{};
  std::map<std::string, std::string> layers{};               ///< names of optional content by "/layer0"
  std::map<std::string, std::vector<PdfOperation>> forms{};  ///< by "/layer0"
};

/// One of each page. Throws Error{input}.
std::vector<PdfContent> read_pdf_contents(const std::string& bytes, const std::string& where);

}  // namespace epura
