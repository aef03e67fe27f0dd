// SPDX-License-Identifier: Apache-2.0
// Sentences about errors in a file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace epura::plugin::gltf {

inline void refuse_if(bool is_wrong, const std::string& sentence) {
  if (is_wrong) throw std::runtime_error(sentence);
}

/// URIs may contain all the data.
inline std::string shortened(std::string_view text) {
  constexpr std::size_t most = 120;
  return text.size() <= most ? std::string(text) : std::string(text.substr(0, most)) + "...";
}

inline std::string numbered(const char* table, std::size_t number) {
  return std::string(table) + " " + std::to_string(number);
}

}  // namespace epura::plugin::gltf
