// SPDX-License-Identifier: Apache-2.0
// Reads the content of a page or a layer of a PDF file, operation by operation.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace epura::compare {

/// An operator of a content stream with its operands. ISO 32000-1, 7.8.2.
struct PdfOperation {
  std::string_view name{};           ///< "l", "cm" ...
  std::vector<double> numbers{};     ///< including those in lists
  std::vector<std::string> words{};  ///< names, with their slash
};

/// In order; `take` may use the operation only during the call. Texts, dictionaries and comments are skipped.
void for_each_operation(std::string_view content, const std::function<void(const PdfOperation&)>& take);

}  // namespace epura::compare
