// SPDX-License-Identifier: Apache-2.0
#include "invalid.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "refuse.hpp"

namespace epura::plugin::gltf {

namespace {

// The digits behind a word.
std::string number_after(std::string_view text, std::string_view word) {
  const std::size_t found = text.find(word);
  if (found == std::string_view::npos) return {};
  const std::string_view rest = text.substr(found + word.size());
  return std::string(rest.substr(0, std::min(rest.find_first_not_of("0123456789"), rest.size())));
}

// What stands between the first quotes or backquotes.
std::string quoted_in(std::string_view text) {
  const std::size_t begin = text.find_first_of("'`");
  const std::size_t end = begin == std::string_view::npos ? begin : text.find_first_of("'`", begin + 1);
  if (end == std::string_view::npos) return {};
  const std::string_view word = text.substr(begin + 1, end - begin - 1);
  const bool is_word = std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  return is_word ? std::string(word) : std::string();
}

}  // namespace

std::string sentence_for(const std::string& error) {
  const std::string_view first = std::string_view(error).substr(0, error.find('\n'));
  const auto says = [&](std::string_view words) { return first.find(words) != std::string_view::npos; };
  const std::string line = number_after(first, "line "), column = number_after(first, "column ");
  if (says("parse error") && !line.empty())
    return "its JSON is damaged or cut short in line " + line + ", column " + column;
  const std::string member = quoted_in(first);
  if (!member.empty() && says("missing")) return "'" + member + "' is missing in one of its tables";
  if (!member.empty() && says("is not a")) return "'" + member + "' in one of its tables is of a wrong kind";
  if (says("buffer") || says("Buffer") || says("uri")) return "the bytes of one of its buffers cannot be read";
  return "its tables break the rules of glTF, which a validator of glTF names";
}

}  // namespace epura::plugin::gltf
