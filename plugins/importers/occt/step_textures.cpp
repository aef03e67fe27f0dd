// SPDX-License-Identifier: Apache-2.0
#include "step_textures.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "measures.hpp"

namespace occt {

namespace {

constexpr std::string_view of_parameter = "SURFACE_TEXTURE_REPRESENTATION";
constexpr double micrometre = 1e-3, inch = 25.4, microinch = 1e-6 * inch;  // mm

bool has_word(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

// "3.20", "63 µin": in micrometres, or of files in inches in microinches, with the decimals of the file.
std::string printed_roughness(const Measure& measure) {
  const bool is_inch = measure.unit == inch || measure.unit == microinch;
  const double by = is_inch ? microinch : micrometre, value = measure.value / by;
  std::string number = printed_length(value);
  if (measure.decimals >= 0 && measure.unit == by) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, measure.decimals);
    if (end.ec == std::errc()) number.assign(text.data(), end.ptr);
  }
  return number + (is_inch ? " µin" : "");
}

class TextureReader {
 public:
  TextureReader(const StepGraph& graph, const RequirementIndex& index, std::size_t& items_left,
                std::set<EntityNumber>& read)
      : graph_(graph), index_(index), length_unit_(length_unit_in(graph)), items_left_(items_left), read_(read) {}

  std::vector<Requirement> all() {
    std::set<EntityNumber> parts;
    for (const auto& [whole, some] : index_.property_parts)
      if (is_texture(whole)) parts.insert(some.begin(), some.end());
    std::vector<Requirement> textures;
    for (const auto& [number, statement] : graph_.statements())
      if (const Record* property = record_of(statement, "PROPERTY_DEFINITION"))
        if (is_texture(number) && parts.count(number) == 0) textures.push_back(texture(number, *property));
    for (const auto& [number, statement] : graph_.statements()) {
      if (record_of(statement, of_parameter) == nullptr || read_.count(number) != 0) continue;
      textures.push_back(begun(number));
      read_parameter(number, textures.back());
      append(textures.back().missing, "the surface that it belongs to");
    }
    return textures;
  }

 private:
  [[nodiscard]] Requirement begun(EntityNumber number) const {
    Requirement texture;
    texture.length_unit = length_unit_;
    texture.kind = EPURA_SURFACE_TEXTURE;
    texture.id = "#" + std::to_string(number);
    texture.type = "surface texture";
    return texture;
  }

  [[nodiscard]] const Record* found(EntityNumber number, std::string_view keyword) const {
    const Statement* statement = graph_.find(number);
    return statement == nullptr ? nullptr : record_of(*statement, keyword);
  }

  [[nodiscard]] bool has_parameter(EntityNumber property) const {
    for (const EntityNumber one : listed(index_.representations, property))
      if (found(one, of_parameter) != nullptr) return true;
    return false;
  }

  [[nodiscard]] bool is_texture(EntityNumber number) const {
    const Record* property = found(number, "PROPERTY_DEFINITION");
    if (property == nullptr) return false;
    if (has_parameter(number) || lower_case(unquoted(argument_of(*property, 0))) == "surface texture") return true;
    for (const EntityNumber part : listed(index_.property_parts, number))
      if (has_parameter(part)) return true;
    return false;
  }

  Requirement texture(EntityNumber number, const Record& property) {
    Requirement texture = begun(number);
    texture.name = unquoted(argument_of(property, 0));
    const EntityNumber about = reference_in(argument_of(property, 2));
    if (found(about, "PRODUCT_DEFINITION_SHAPE") == nullptr) {
      texture.items = items_of(index_, about, items_left_);
      if (texture.items.empty()) append(texture.missing, "a face that it belongs to");
    }
    std::vector<EntityNumber> properties = listed(index_.property_parts, number);
    properties.insert(properties.begin(), number);
    for (const EntityNumber one : properties)
      for (const EntityNumber representation : listed(index_.representations, one)) {
        if (found(representation, of_parameter) != nullptr)
          read_parameter(representation, texture);
        else if (const Record* general = found(representation, "REPRESENTATION"))
          for (const EntityNumber item : references_in(argument_of(*general, 1))) read_manner(item, texture);
      }
    return texture;
  }

  // How the surface is made.
  void read_manner(EntityNumber item, Requirement& texture) const {
    const Record* words = found(item, "DESCRIPTIVE_REPRESENTATION_ITEM");
    const std::string name =
        lower_case(words == nullptr ? measure_of(graph_, item).name : unquoted(argument_of(*words, 0)));
    const std::string text = words == nullptr ? std::string() : lower_case(unquoted(argument_of(*words, 1)));
    if (words != nullptr && name == "material removal condition") {
      if (has_word(text, "required")) append(texture.modifiers, "material removal required");
      if (has_word(text, "no ") || has_word(text, "prohibited"))
        append(texture.modifiers, "material removal prohibited");
    } else if (words != nullptr && (has_word(name, "process") || has_word(name, "manufacturing method"))) {
      append(texture.modifiers, "made by " + text);
    } else {
      append(texture.missing, "'" + name + "'");
    }
  }

  // "Ra 3.2", or "U Ra 3.2" and "L Ra 0.8" (ISO 21920-1).
  void read_parameter(EntityNumber representation, Requirement& texture) {
    read_.insert(representation);
    const Record& record = *found(representation, of_parameter);
    std::string method;
    std::vector<Measure> measures;
    for (const EntityNumber item : references_in(argument_of(record, 1))) {
      if (const Record* words = found(item, "DESCRIPTIVE_REPRESENTATION_ITEM"))
        append(method, unquoted(argument_of(*words, 1)), " ");
      else if (const Statement* range = graph_.find(item); range != nullptr && is_range(*range))
        for (const Record& part : range->records)
          for (const EntityNumber bound : references_in(part.arguments)) measures.push_back(measured(bound));
      else
        measures.push_back(measured(item));
    }
    if (measures.empty()) append(texture.missing, "a value");
    for (const Measure& measure : measures) add_value(measure, method, texture);
  }

  static bool is_range(const Statement& statement) { return record_of(statement, "VALUE_RANGE") != nullptr; }

  [[nodiscard]] Measure measured(EntityNumber item) const {
    Measure measure = measure_of(graph_, item);
    qualify(measure, graph_, listed(index_.qualifiers, item));
    return measure;
  }

  static void add_value(const Measure& measure, const std::string& method, Requirement& texture) {
    const std::string name = lower_case(measure.name);
    if (std::isnan(measure.value) || measure.is_angle)
      return append(texture.missing, measure.has_unit ? "a value" : "the unit of a value");
    const bool is_upper = has_word(name, "upper") || has_word(name, "maximum");
    const bool is_lower = has_word(name, "lower") || has_word(name, "minimum");
    if (!is_upper && !is_lower && !name.empty() && !has_word(name, "value") && !has_word(name, "parameter"))
      return append(texture.missing, "'" + name + "'");
    const bool is_first = texture.text.empty();
    std::string line = is_upper ? "U" : is_lower ? "L" : "";
    append(line, method, " ");
    append(line, printed_roughness(measure), " ");
    append(texture.text, line, "; ");
    texture.value = is_first ? measure.value : std::nan("");
    texture.unit = is_first ? measure.unit : 0;
    texture.decimals = is_first ? measure.decimals : -1;
  }

  const StepGraph& graph_;
  const RequirementIndex& index_;
  const double length_unit_;
  std::size_t& items_left_;
  std::set<EntityNumber>& read_;
};

}  // namespace

std::vector<Requirement> textures_in_step(const StepGraph& graph, const RequirementIndex& index,
                                          std::size_t& items_left, std::set<EntityNumber>& read) {
  return TextureReader(graph, index, items_left, read).all();
}

}  // namespace occt
