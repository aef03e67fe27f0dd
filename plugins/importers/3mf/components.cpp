// SPDX-License-Identifier: Apache-2.0
#include "components.hpp"

#include <algorithm>
#include <stdexcept>

namespace epura::plugin::threemf {

namespace {

constexpr int deepest = 500;
constexpr std::string_view blanks = " \t\r\n";

std::string_view without_prefix(std::string_view name) { return name.substr(name.find(':') + 1); }

std::string without_slash(std::string_view path) {
  return std::string(path.substr(std::min(path.find_first_not_of('/'), path.size())));
}

}  // namespace

// `place` is after the '<', and is moved past the '>'.
Components::Tag Components::tag_at(std::string_view text, std::size_t& place) {
  const auto to = [&](std::size_t found) { return std::min(found, text.size()); };
  const std::size_t name_end = to(text.find_first_of(" \t\r\n/>", place));
  Tag tag{without_prefix(text.substr(place, name_end - place)), {}, {}, {}};
  place = name_end;
  while (true) {
    place = to(text.find_first_not_of(" \t\r\n/", place));
    if (place == text.size() || text[place] == '>') return tag;
    const std::size_t equals = to(text.find_first_of("=>", place));
    if (equals == text.size() || text[equals] == '>') {
      place = equals;
      continue;
    }
    std::string_view name = text.substr(place, equals - place);
    name = without_prefix(name.substr(0, name.find_first_of(blanks)));
    const std::size_t quote = to(text.find_first_not_of(blanks, equals + 1));
    if (quote == text.size()) return tag;
    const std::size_t end = to(text.find(text[quote], quote + 1));
    const std::string_view value = text.substr(quote + 1, end - std::min(end, quote + 1));
    if (name == "id") tag.id = value;
    if (name == "objectid") tag.object = value;
    if (name == "path") tag.path = value;
    place = to(end + 1);
  }
}

void Components::scan(const std::string& part, std::string_view text) {
  const std::string own = without_slash(part);
  std::vector<Id>* held = nullptr;
  for (std::size_t place = text.find('<'); place != std::string_view::npos; place = text.find('<', place)) {
    ++place;
    if (text.substr(place, 3) == "!--") {
      place = std::min(text.find("-->", place), text.size());
      continue;
    }
    // Nearly all tags are vertices and triangles.
    if (text.substr(place, 6) == "vertex" || text.substr(place, 8) == "triangle") continue;
    const Tag tag = tag_at(text, place);
    if (tag.name == "object") held = &components_[{own, std::string(tag.id)}];
    if (tag.name == "component" && held != nullptr)
      held->emplace_back(tag.path.empty() ? own : without_slash(tag.path), std::string(tag.object));
  }
}

// A missing object counts as one: lib3mf will report it.
Components::Held Components::count(const Id& id, int depth, std::map<Id, Held>& counts) const {
  const auto known = counts.find(id);
  if (known != counts.end()) return known->second;
  Held held{1, 1};
  const auto found = components_.find(id);
  const bool is_set = found != components_.end();
  for (std::size_t i = 0; is_set && i < found->second.size(); ++i) {
    const Held one = depth < deepest ? count(found->second[i], depth + 1, counts) : Held{0, deepest};
    held.parts += one.parts;
    held.levels = std::max(held.levels, one.levels + 1);
    if (held.levels > deepest)
      throw std::runtime_error("has components in more than " + std::to_string(deepest) + " levels, or in a circle");
    if (held.parts > most_parts)
      throw std::runtime_error("puts down more than " + std::to_string(most_parts) + " parts");
  }
  counts.emplace(id, held);
  return held;
}

void Components::expect_few() const {
  std::map<Id, Held> counts;
  for (const auto& [id, held] : components_) count(id, 1, counts);
}

}  // namespace epura::plugin::threemf
