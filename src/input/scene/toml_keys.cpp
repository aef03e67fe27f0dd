// SPDX-License-Identifier: Apache-2.0
#include "scene/toml_keys.hpp"

#include <algorithm>

namespace epura::scene {

namespace {

// Returns the position after the string that begins at `at`. An unterminated string ends at the end of its line; the
// TOML library reports it as an error.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view rest = text.substr(at);
  const bool many_lines = rest.starts_with(quote == '"' ? "\"\"\"" : "'''");
  const std::string_view mark = rest.substr(0, many_lines ? 3 : 1);
  for (at += mark.size(); at < text.size(); ++at) {
    if (!many_lines && text[at] == '\n') return at;
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text.substr(at).starts_with(mark)) {
      at += mark.size();
      // Up to two quotes before the closing ones are part of the string.
      for (int more = 0; many_lines && more < 2 && text.substr(at).starts_with(quote); ++more) ++at;
      return at;
    }
  }
  return text.size();
}

}  // namespace

std::optional<std::size_t> line_of_deep_key(std::string_view text, std::size_t max_dots) {
  constexpr std::string_view between_keys = "=,[]{}\n";
  std::size_t line = 1, dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      line += static_cast<std::size_t>(
          std::count(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(at), '\n'));
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else {
      if (c == '.' && ++dots > max_dots) return line;
      if (between_keys.find(c) != std::string_view::npos) dots = 0;
      if (c == '\n') ++line;
      ++at;
    }
  }
  return std::nullopt;
}

}  // namespace epura::scene
