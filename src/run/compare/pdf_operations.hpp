// SPDX-License-Identifier: Apache-2.0
// The operators of PDF content streams. ISO 32000-1, 7.8.2.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace epura::compare {

/// A string among the operands of an operator, without escapes.
struct PdfString {
  std::string bytes;
  std::size_t numbers;  ///< how many of the operator's numbers stand before it
};

/// An operator with its operands.
struct PdfOperation {
  std::string_view name{};           ///< "l", "cm" ...
  std::vector<double> numbers{};     ///< including those in lists
  std::vector<std::string> words{};  ///< names, with their slash
  std::vector<PdfString> strings{};  ///< including those in lists
};

/// In order; `take` may use the operation only during the call. Dictionaries and comments are skipped.
void for_each_operation(std::string_view content, const std::function<void(const PdfOperation&)>& take);

}  // namespace epura::compare
