// SPDX-License-Identifier: Apache-2.0
#include "set_aside.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "draco.hpp"

namespace epura::plugin::gltf {

namespace {

constexpr std::size_t nowhere = std::string_view::npos;

/// An object or array, and where the values of members begin that compressed primitives have.
struct Open {
  std::string_view name;  ///< of it as a member
  std::size_t indices = nowhere, compression = nowhere;
};

// The place of the closing quote.
std::size_t end_of_text(std::string_view json, std::size_t quote) {
  std::size_t i = quote + 1;
  while (i < json.size() && json[i] != '"') i += json[i] == '\\' ? 2 : 1;
  return std::min(i, json.size());
}

std::vector<Open> compressed_primitives(std::string_view json) {
  std::vector<Open> open, found;
  std::string_view text;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      const std::size_t end = end_of_text(json, i);
      text = json.substr(i + 1, end - i - 1);
      i = end;
    } else if (c == '{' || c == '[') {
      open.push_back({text});
    } else if (open.empty()) {
      continue;
    } else if (c == '}' || c == ']') {
      if (open.back().indices != nowhere && open.back().compression != nowhere) found.push_back(open.back());
      open.pop_back();
    } else if (c == ':' && text == "indices") {
      open.back().indices = i + 1;
    } else if (c == ':' && text == draco_extension && open.back().name == "extensions" && open.size() > 1) {
      open[open.size() - 2].compression = i + 1;
    }
  }
  return found;
}

struct Edit {
  std::size_t place, length;
  std::string text;
};

std::vector<Edit> edits_of(std::string_view json) {
  const auto next = [&](std::size_t place) { return std::min(json.find_first_not_of(" \t\r\n", place), json.size()); };
  const auto has = [&](std::size_t place, char c) { return place < json.size() && json[place] == c; };
  std::vector<Edit> edits;
  for (const Open& primitive : compressed_primitives(json)) {
    const std::size_t number = next(primitive.indices), brace = next(primitive.compression);
    const std::size_t length = std::min(json.find_first_not_of("0123456789", number), json.size()) - number;
    if (length == 0 || !has(brace, '{') || !has(next(brace + 1), '"')) continue;
    edits.push_back({number, length, "-1"});
    edits.push_back({brace + 1, 0, "\"indices\":" + std::string(json.substr(number, length)) + ","});
  }
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.place < b.place; });
  return edits;
}

}  // namespace

std::string set_indices_aside(std::string_view json) {
  std::string edited;
  std::size_t done = 0;
  for (const Edit& edit : edits_of(json)) {
    edited += json.substr(done, edit.place - done);
    edited += edit.text;
    done = edit.place + edit.length;
  }
  edited += json.substr(done);
  return edited;
}

}  // namespace epura::plugin::gltf
