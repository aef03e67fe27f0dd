// SPDX-License-Identifier: Apache-2.0
// Checks JSON against a schema: the keywords of JSON Schema that the schemas of epura use.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "../unit/output/json_reader.hpp"

namespace epura::test {

class Schema {
 public:
  explicit Schema(const std::string& text) : root_(JsonReader(text).read()) {}

  /// What of the value is not as the schema says, with its place; empty: it is.
  [[nodiscard]] std::string fault_of(const Json& value) const { return fault(value, root_, "value"); }

 private:
  static bool has(const Json& rule, const std::string& key) {
    return std::find(rule.names.begin(), rule.names.end(), key) != rule.names.end();
  }
  static bool are_same(const Json& a, const Json& b) { return a.type == b.type && a.text == b.text; }

  static bool is_of(const Json& value, const std::string& type) {
    if (type == "object") return value.type == '{';
    if (type == "array") return value.type == '[';
    if (type == "string") return value.type == '"';
    if (type == "boolean") return value.type == 't' || value.type == 'f';
    if (type == "integer") return value.type == '0' && value.number() == std::floor(value.number());
    if (type == "number") return value.type == '0';
    throw std::runtime_error("the checker does not know the type " + type);
  }

  [[nodiscard]] std::string fault(const Json& value, const Json& rule, const std::string& place) const {
    for (const std::string& key : rule.names)
      if (std::string(" $schema $defs $ref title description type const enum minimum required properties items "
                      "additionalProperties minItems maxItems ")
              .find(" " + key + " ") == std::string::npos)
        throw std::runtime_error("the checker does not know the keyword " + key);
    if (has(rule, "$ref")) return fault(value, root_["$defs"][rule["$ref"].text.substr(8)], place);
    if (has(rule, "type") && !is_of(value, rule["type"].text)) return place + " is not of type " + rule["type"].text;
    if (has(rule, "const") && !are_same(value, rule["const"])) return place + " is not " + rule["const"].text;
    if (has(rule, "enum")) {
      const auto& list = rule["enum"].items;
      if (std::none_of(list.begin(), list.end(), [&](const Json& one) { return are_same(one, value); }))
        return place + " is '" + value.text + "'";
    }
    if (has(rule, "minimum") && value.number() < rule["minimum"].number()) return place + " is too small";
    if (value.type == '[') return fault_of_items(value, rule, place);
    return value.type == '{' ? fault_of_object(value, rule, place) : "";
  }

  [[nodiscard]] std::string fault_of_items(const Json& value, const Json& rule, const std::string& place) const {
    const auto count = static_cast<double>(value.items.size());
    if (has(rule, "minItems") && count < rule["minItems"].number()) return place + " has too few items";
    if (has(rule, "maxItems") && count > rule["maxItems"].number()) return place + " has too many items";
    for (std::size_t i = 0; i < value.items.size(); ++i)
      if (const std::string found = fault(value.items[i], rule["items"], place + "[" + std::to_string(i) + "]");
          !found.empty())
        return found;
    return "";
  }

  [[nodiscard]] std::string fault_of_object(const Json& value, const Json& rule, const std::string& place) const {
    if (has(rule, "required"))
      for (const Json& key : rule["required"].items)
        if (!has(value, key.text)) return place + " lacks " + key.text;
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      const std::string& key = value.names[i];
      const bool is_known = has(rule, "properties") && has(rule["properties"], key);
      if (!is_known && rule["additionalProperties"].type == 'f') return place + " has a key " + key;
      const Json& of_item = is_known ? rule["properties"][key] : rule["additionalProperties"];
      if (const std::string found = fault(value.items[i], of_item, place + "." + key); !found.empty()) return found;
    }
    return "";
  }

  Json root_;
};

}  // namespace epura::test
