// SPDX-License-Identifier: Apache-2.0
#include "scene/toml_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/toml_library.hpp"

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

/// Returns the line, from 1, of the first key with more than `max_dots` dots. Dots in strings and comments do not
/// count.
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

constexpr std::uintmax_t max_bytes = 2'000'000;
constexpr std::size_t max_dots = 100;

std::string place(const std::string& file, const toml::source_position& position) {
  return file + ":" + std::to_string(position.line) + ":" + std::to_string(position.column);
}

std::string text_of(const toml::date& date) {
  std::string text = "0000-00-00";
  const auto put = [&text](std::size_t place, unsigned number) {
    for (std::size_t i = place; number > 0; --i, number /= 10) text[i] = static_cast<char>('0' + number % 10);
  };
  put(3, date.year);
  put(6, date.month);
  put(9, date.day);
  return text;
}

/// A key in the file, and its value.
struct Entry {
  const toml::key* key;
  const toml::node* node;
};

class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] TomlTable table(const toml::table& source) const {
    std::vector<Entry> entries;
    for (const auto& [key, node] : source) entries.push_back({&key, &node});
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.key->source().begin < b.key->source().begin; });
    TomlTable result;
    for (const auto& [key, node] : entries) {
      const std::string where = place(file_, key->source().begin);
      const std::string name(key->str());
      if (name.empty() || std::any_of(name.begin(), name.end(), is_control))
        throw Error(ErrorKind::input, where, "a key is empty or has a control character");
      result.values.push_back(value(*node, name, where));
    }
    return result;
  }

 private:
  [[nodiscard]] TomlValue value(const toml::node& node, const std::string& key, const std::string& key_where) const {
    return {key, place(file_, node.source().begin), key_where, content(node, key, key_where)};
  }

  [[nodiscard]] TomlContent content(const toml::node& node, const std::string& key,
                                    const std::string& key_where) const {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* number = node.as_integer()) return static_cast<double>(number->get());
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* date = node.as_date()) return TomlDate{text_of(date->get())};
    if (const auto* entries = node.as_table()) return table(*entries);
    const auto* elements = node.as_array();
    if (elements == nullptr) return TomlTime{};
    TomlList list;
    for (const toml::node& element : *elements) list.values.push_back(value(element, key, key_where));
    return list;
  }

  std::string file_;
};

// toml++ limits the nesting of values, but not of dotted keys, which would exhaust the stack.
void refuse_deep_keys(std::string_view text, const std::string& file) {
  if (const auto line = line_of_deep_key(text, max_dots))
    throw Error(ErrorKind::input, file + ":" + std::to_string(*line), "has more than 100 dots in a key",
                "dots in a key nest tables; write a shorter key");
}

// Turns "Error while parsing string: ..." into a sentence, without hints for users of the library and without line
// breaks of the file.
std::string sentence_of(const toml::parse_error& error) {
  constexpr std::string_view head = "Error ";
  std::string_view text = error.description();
  if (text.starts_with(head)) text.remove_prefix(head.size());
  std::string sentence = to_lower(text.substr(0, 1)) + std::string(text.substr(1, text.find(" (TOML_") - 1));
  std::replace_if(sentence.begin(), sentence.end(), is_control, ' ');
  return "is not valid TOML: " + sentence;
}

}  // namespace

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

TomlValue read_toml(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string text = read_file(path, {}, max_bytes);
  refuse_deep_keys(text, file);
  try {
    return {"", file, file, Reader(file).table(toml::parse(text))};
  } catch (const toml::parse_error& error) {
    throw Error(ErrorKind::input, place(file, error.source().begin), sentence_of(error),
                "values are like \"text\", 1.5, true or [1, 2]; see toml.io");
  }
}

}  // namespace epura::scene
