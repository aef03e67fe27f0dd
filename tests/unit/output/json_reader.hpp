// SPDX-License-Identifier: Apache-2.0
// A strict reader of JSON (RFC 8259) that keeps the order of keys and the text of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"

namespace epura {

struct Json {
  char type = 'n';                 ///< { [ " 0 t f n
  std::string text;                ///< of a string or a number
  std::vector<std::string> names;  ///< of an object, one for each item
  std::vector<Json> items;

  [[nodiscard]] const Json& operator[](std::string_view key) const {
    const auto found = std::find(names.begin(), names.end(), key);
    if (found == names.end()) throw std::runtime_error("no key " + std::string(key));
    return items.at(static_cast<std::size_t>(found - names.begin()));
  }
  [[nodiscard]] double number() const { return parse_number(text).value(); }
  [[nodiscard]] std::string keys() const {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
    return list;
  }
};

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  Json read() {
    Json json = value();
    space();
    require(text_.empty());
    return json;
  }

 private:
  static void require(bool good) {
    if (!good) throw std::runtime_error("this is no JSON");
  }
  void space() { text_.remove_prefix(std::min(text_.find_first_not_of(" \n\r\t"), text_.size())); }
  bool take(std::string_view word) {
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }

  Json value() {
    space();
    require(!text_.empty());
    if (take("true")) return {'t', {}, {}, {}};
    if (take("false")) return {'f', {}, {}, {}};
    if (take("null")) return {};
    if (text_[0] == '"') return {'"', string(), {}, {}};
    if (text_[0] == '{' || text_[0] == '[') return collection(text_[0]);
    return {'0', number(), {}, {}};
  }

  Json collection(char type) {
    const std::string_view end = type == '{' ? "}" : "]";
    Json json{type, {}, {}, {}};
    text_.remove_prefix(1);
    for (space(); !take(end); space()) {
      if (!json.items.empty()) require(take(","));
      space();
      if (type == '{') {
        json.names.push_back(string());
        space();
        require(take(":"));
      }
      json.items.push_back(value());
    }
    return json;
  }

  std::string string() {
    require(take("\""));
    std::string result;
    while (!take("\"")) {
      require(!text_.empty() && static_cast<unsigned char>(text_[0]) >= ' ');
      if (take("\\u00")) {
        const auto code = parse_integer(std::to_string(std::stoi(std::string(text_.substr(0, 2)), nullptr, 16)));
        result += static_cast<char>(code.value());
        text_.remove_prefix(2);
        continue;
      }
      if (take("\\")) require(text_[0] == '"' || text_[0] == '\\');
      result += text_[0];
      text_.remove_prefix(1);
    }
    return result;
  }

  std::string digits() {
    const std::string_view found = text_.substr(0, text_.find_first_not_of("0123456789"));
    require(!found.empty());
    text_.remove_prefix(found.size());
    return std::string(found);
  }

  std::string number() {
    std::string result = take("-") ? "-" : "";
    const std::string whole = digits();
    require(whole.size() == 1 || whole[0] != '0');
    result += whole;
    if (take(".")) result += "." + digits();
    if (take("e")) {
      result += "e";
      if (take("-"))
        result += "-";
      else if (take("+"))
        result += "+";
      result += digits();
    }
    return result;
  }

  std::string_view text_;
};

}  // namespace epura
