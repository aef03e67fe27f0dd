// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/placeholders.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/hash.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 4> known{"name", "folder", "number", "hash"};

bool is_known(std::string_view word) { return std::find(known.begin(), known.end(), word) != known.end(); }

// Calls `literal(text)` for what stands between braces and `inside(word)` for words in them.
template <class Literal, class Inside>
void visit_parts(std::string_view text, const Literal& literal, const Inside& inside) {
  while (!text.empty()) {
    const std::size_t open = text.find('{');
    const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
    if (close == std::string_view::npos) return literal(text);
    literal(text.substr(0, open));
    inside(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

std::string folder_of(const std::string& model) {
  fs::path folder;
  for (const fs::path& step : fs::path(model).lexically_normal().parent_path().relative_path())
    if (step != ".." && step != ".") folder /= step;
  return folder.string();
}

// A model called "...obj" has the stem "..", which would lead a path upwards.
std::string name_of(const fs::path& model) {
  const std::string stem = model.stem().string();
  return stem == "." || stem == ".." ? model.filename().string() : stem;
}

}  // namespace

bool has_placeholder(std::string_view text) {
  bool has = false;
  visit_parts(
      text, [](std::string_view) {}, [&](std::string_view word) { has = has || is_known(word); });
  return has;
}

void expect_known_placeholders(std::string_view text, const std::string& where) {
  const auto check = [&](std::string_view word) {
    const std::vector<std::string> names(known.begin(), known.end());
    if (!is_known(word))
      throw Error(ErrorKind::input, where, "unknown placeholder '{" + std::string(word) + "}'",
                  did_you_mean(word, names));
  };
  visit_parts(
      text, [](std::string_view) {}, check);
}

PlaceholderValues values_for(const std::string& request, std::size_t number) {
  const std::string model = importer::parse_model_request(request).path;
  return {{"name", [=] { return name_of(model); }},
          {"folder", [=] { return folder_of(model); }},
          {"number", [=] { return std::to_string(number); }},
          {"hash", [=] { return hash_of_file(model); }}};
}

std::string filled(std::string_view text, const PlaceholderValues& values) {
  std::string result;
  const auto value_of = [&](std::string_view word) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == word; });
    return found != values.end() ? found->second() : "{" + std::string(word) + "}";
  };
  visit_parts(
      text, [&](std::string_view literal) { result += literal; },
      [&](std::string_view word) { result += value_of(word); });
  return result;
}

std::string filled_path(std::string_view text, const PlaceholderValues& values) {
  const std::string path = filled(text, values);
  const bool leads_to_root = path.starts_with('/') && !text.starts_with('/');
  return fs::path(leads_to_root ? path.substr(1) : path).lexically_normal().string();
}

}  // namespace epura
