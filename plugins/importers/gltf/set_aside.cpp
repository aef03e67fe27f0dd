// SPDX-License-Identifier: Apache-2.0
#include "set_aside.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "draco.hpp"
#include "meshopt.hpp"

namespace epura::plugin::gltf {

namespace {

constexpr std::size_t nowhere = std::string_view::npos;

/// An object or array, and where the values of members begin that compressed primitives and empty buffers have.
struct Open {
  std::string_view name;  ///< of it as a member
  std::size_t begin;
  std::size_t indices = nowhere, compression = nowhere, length = nowhere, fallback = nowhere, uri = nowhere;
  bool is_view = false;
};

// The place of the closing quote.
std::size_t end_of_text(std::string_view json, std::size_t quote) {
  std::size_t i = quote + 1;
  while (i < json.size() && json[i] != '"') i += json[i] == '\\' ? 2 : 1;
  return std::min(i, json.size());
}

bool is_compressed_primitive(const Open& one) { return one.indices != nowhere && one.compression != nowhere; }

bool is_buffer(const Open& one) { return one.length != nowhere && one.uri == nowhere && !one.is_view; }

// Notes where the value of a member of the last object begins.
void note_member(std::vector<Open>& open, std::string_view member, std::size_t value) {
  if (member == "indices") open.back().indices = value;
  if (member == "byteLength") open.back().length = value;
  if (member == "uri") open.back().uri = value;
  if (member == "buffer") open.back().is_view = true;
  const bool is_extension = open.back().name == "extensions" && open.size() > 1;
  if (is_extension && member == draco_extension) open[open.size() - 2].compression = value;
  const bool is_in_extension = open.size() > 2 && open.back().name == meshopt_extension;
  if (is_in_extension && member == "fallback") open[open.size() - 3].fallback = value;
}

std::vector<Open> found_in(std::string_view json) {
  std::vector<Open> open, found;
  std::string_view text;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      const std::size_t end = end_of_text(json, i);
      text = json.substr(i + 1, end - i - 1);
      i = end;
    } else if (c == '{' || c == '[') {
      open.push_back({text, i});
    } else if (open.empty()) {
      continue;
    } else if (c == '}' || c == ']') {
      if (is_compressed_primitive(open.back()) || is_buffer(open.back())) found.push_back(open.back());
      open.pop_back();
    } else if (c == ':') {
      note_member(open, text, i + 1);
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
  const auto digits = [&](std::size_t place) {
    return std::min(json.find_first_not_of("0123456789", place), json.size()) - place;
  };
  std::vector<Edit> edits;
  for (const Open& one : found_in(json)) {
    const std::size_t length_at = is_buffer(one) ? next(one.length) : json.size();
    const bool is_zero = has(length_at, '0') && digits(length_at) == 1;
    if (is_zero || (is_buffer(one) && one.fallback != nowhere)) {
      edits.push_back({length_at, digits(length_at), "1"});
      edits.push_back({one.begin + 1, 0, "\"uri\":\"data:application/octet-stream;base64,AA==\","});
    }
    if (!is_compressed_primitive(one) || !reads_draco()) continue;
    const std::size_t number = next(one.indices), brace = next(one.compression);
    const std::size_t length = digits(number);
    if (length == 0 || !has(brace, '{') || !has(next(brace + 1), '"')) continue;
    edits.push_back({number, length, "-1"});
    edits.push_back({brace + 1, 0, "\"indices\":" + std::string(json.substr(number, length)) + ","});
  }
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.place < b.place; });
  return edits;
}

}  // namespace

std::string set_aside(std::string_view json) {
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
