// SPDX-License-Identifier: Apache-2.0
#include "svg/element.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "svg/basic_shapes.hpp"

namespace epura::svg {

namespace {

// Properties that would change what is seen, and the values that do not.
struct Effect {
  std::string_view property;
  std::array<std::string_view, 3> none;
  const char* hint;
};
constexpr std::array<Effect, 6> effects = {{
    {"clip-path", {"none", "none", "none"}, "in Inkscape: Object > Clip > Release, or Path > Intersection"},
    {"mask", {"none", "none", "none"}, "in Inkscape: Object > Mask > Release"},
    {"filter", {"none", "none", "none"}, "in Inkscape: Filters > Remove Filters"},
    {"marker-start", {"none", "none", "none"}, "in Inkscape: Path > Stroke to Path"},
    {"marker-end", {"none", "none", "none"}, "in Inkscape: Path > Stroke to Path"},
    {"vector-effect", {"none", "none", "none"}, "widths of lines grow with their groups"},
}};

void expect_no_effect(const Source& source, const pugi::xml_node& element, const Style& style, const Effect& effect) {
  const std::string_view value = style.of(effect.property);
  if (!value.empty() && std::find(effect.none.begin(), effect.none.end(), value) == effect.none.end())
    source.refuse(element, "has '" + std::string(effect.property) + ": " + std::string(value) + "', which is not drawn",
                  effect.hint);
}

double opacity(const Source& source, const pugi::xml_node& element, const Style& style, std::string_view property) {
  const std::string_view value = style.of(property);
  if (value.empty() || value == "inherit") return 1;
  const auto alpha = alpha_of(value);
  if (!alpha)
    source.refuse(element, "has '" + std::string(property) + ": " + std::string(value) + "'",
                  "give a number from 0 to 1");
  return *alpha;
}

}  // namespace

Source::Source(std::string_view bytes, std::string file) : where(std::move(file)) {
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos; end = bytes.find('\n', end + 1))
    line_ends.push_back(static_cast<std::ptrdiff_t>(end));
}

std::string Source::line_at(std::ptrdiff_t offset) const {
  const auto line = std::lower_bound(line_ends.begin(), line_ends.end(), offset);
  return where + ":" + std::to_string(1 + (line - line_ends.begin()));
}

void Source::refuse(const pugi::xml_node& at, const std::string& what, const std::string& hint) const {
  throw Error(ErrorKind::input, line_of(at), what, hint);
}

double Source::length_in(const pugi::xml_node& node, const char* name) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return 0;
  const auto length = length_of(attribute.value());
  if (!length) refuse(node, "'" + std::string(name) + "' is no length: '" + attribute.value() + "'");
  return *length;
}

Rules style_sheets_in(const pugi::xml_node& node, const Source& source, int depth) {
  if (depth > deepest) source.refuse(node, "has too many groups in groups");
  Rules rules;
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (name == "defs" || name == "g") rules.merge(style_sheets_in(child, source, depth + 1));
    if (name != "style") continue;
    rules.merge(read_rules(child.text().get()));
    if (!rules.others.empty())
      source.refuse(child, "the style sheet has the selector '" + rules.others.front() + "'",
                    "use elements, classes and ids alone, or attributes");
  }
  return rules;
}

Context inside(const pugi::xml_node& element, const Context& parent, const Definitions& all) {
  Context context = parent;
  if (++context.depth > deepest) all.source.refuse(element, "has too many groups in groups");
  // Not inherited.
  for (const Effect& effect : effects)
    if (const auto found = context.style.properties.find(effect.property); found != context.style.properties.end())
      context.style.properties.erase(found);
  context.style.properties.erase("opacity");
  context.style = style_of(element, context.style, all.rules);
  context.alpha *= opacity(all.source, element, context.style, "opacity");
  for (const Effect& effect : effects) expect_no_effect(all.source, element, context.style, effect);
  for (const pugi::xml_attribute attribute : element.attributes())
    if (std::string_view(attribute.name()).starts_with("on")) all.source.refuse(element, "has a script", "remove it");
  if (const pugi::xml_attribute transform = element.attribute("transform")) {
    const auto map = read_transform(transform.value());
    if (!map) all.source.refuse(element, "has an unknown transform: '" + std::string(transform.value()) + "'");
    context.map = parent.map.after(*map);
  }
  return context;
}

Painted paint_of(const pugi::xml_node& element, const Context& context, const Definitions& all,
                 const std::string& property, std::string_view usual) {
  constexpr double nothing = 1.0 / 512;  // of a colour that has 255 steps
  std::string_view word = context.style.of(property);
  if (word.empty()) word = usual;
  if (word == "none") return {};
  const double alpha = context.alpha * opacity(all.source, element, context.style, property + "-opacity");
  const auto gradient = all.gradients.find(referenced_id(word));
  const bool is_graded = gradient != all.gradients.end();
  const auto colour = is_graded ? gradient->second.colour : named_colour(word);
  if (!colour)
    all.source.refuse(element, "has the " + property + " '" + std::string(word) + "'",
                      "use a flat colour such as #003366");
  const Paint seen{*colour, alpha * (is_graded ? gradient->second.alpha : 1)};
  if (seen.alpha < nothing) return {};
  return {on_white(seen), is_graded, alpha < 1 - nothing && *colour != Colour{255, 255, 255}};
}

}  // namespace epura::svg
