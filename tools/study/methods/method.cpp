// SPDX-License-Identifier: Apache-2.0
#include "study/methods/method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "study/methods/item_buffer.hpp"
#include "study/methods/rounded_view.hpp"
#include "study/methods/sampled.hpp"

namespace epura {

namespace {

struct Knob {
  Way way;
  std::string key;
  double Method::*value;
  double min, max;
  bool whole;
  bool always_said;
};

const std::vector<std::pair<std::string, Way>>& ways() {
  static const std::vector<std::pair<std::string, Way>> all{{"exact", Way::exact},
                                                            {"float", Way::floats},
                                                            {"sampled", Way::sampled},
                                                            {"item-buffer", Way::item_buffer},
                                                            {"none", Way::none}};
  return all;
}

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> all{{Way::exact, "bits", &Method::bits, 4, 30, true, false},
                                     {Way::sampled, "density", &Method::density, 1e-6, 1e6, false, true},
                                     {Way::sampled, "halvings", &Method::halvings, 0, 60, true, false},
                                     {Way::item_buffer, "dpi", &Method::dpi, 1, 1e5, false, true}};
  return all;
}

Way way_of(std::string_view name, const std::string& where) {
  std::vector<std::string> names;
  for (const auto& [known, way] : ways()) {
    if (known == name) return way;
    names.push_back(known);
  }
  throw Error(ErrorKind::input, where, "unknown value '" + std::string(name) + "'", did_you_mean(name, names));
}

void turn(Method& method, std::string_view assignment, const std::string& where) {
  const std::string_view key = assignment.substr(0, assignment.find('='));
  std::vector<std::string> names;
  for (const Knob& knob : knobs()) {
    if (knob.way != method.way) continue;
    names.push_back(knob.key);
    if (knob.key != key) continue;
    const auto value = parse_number(assignment.substr(std::min(key.size() + 1, assignment.size())));
    if (!value || !(*value >= knob.min && *value <= knob.max) || (knob.whole && *value != std::floor(*value)))
      throw Error(ErrorKind::input, where, "'" + std::string(assignment) + "' is not possible",
                  knob.key + " is a " + (knob.whole ? "whole " : "") + "number from " + format_number(knob.min) +
                      " to " + format_number(knob.max));
    method.*knob.value = *value;
    return;
  }
  throw Error(ErrorKind::input, where, name_of(method.way) + " has no knob '" + std::string(key) + "'",
              names.empty() ? "it has none" : did_you_mean(key, names));
}

}  // namespace

Method parse_method(std::string_view text, const std::string& where) {
  const std::vector<std::string_view> parts = split(text, ':');
  Method method;
  method.way = way_of(parts.front(), where);
  for (std::size_t i = 1; i < parts.size(); ++i) turn(method, parts[i], where);
  return method;
}

std::string name_of(Way way) {
  for (const auto& [name, known] : ways())
    if (known == way) return name;
  return {};
}

std::string knobs_of(const Method& method) {
  std::string text;
  for (const Knob& knob : knobs()) {
    if (knob.way != method.way || (!knob.always_said && method.*knob.value == Method().*knob.value)) continue;
    text += (text.empty() ? "" : ":") + knob.key + "=" + format_number(method.*knob.value);
  }
  return text;
}

std::string text_of(const Method& method) {
  const std::string turned = knobs_of(method);
  return name_of(method.way) + (turned.empty() ? "" : ":") + turned;
}

HiddenSpans find_hidden(const World& world, const ProjectedScene& view, const FeatureEdges& drawn, const Method& method,
                        double mm, Progress progress) {
  switch (method.way) {
    case Way::exact:
      if (method.bits == Method().bits) return find_hidden(world, view, drawn, progress);
      return find_hidden(world, on_coarser_grid(view, static_cast<int>(method.bits)), drawn, progress);
    case Way::floats:
      return find_hidden(world, in_floats(view), drawn, progress);
    case Way::sampled:
      return find_hidden_by_samples(world, view, drawn, {method.density * mm, static_cast<int>(method.halvings)},
                                    progress);
    case Way::item_buffer:
      return find_hidden_by_item_buffer(world, view, drawn, mm * method.dpi / 25.4, progress);
    case Way::none:
      return nothing_hidden(drawn);
  }
  return nothing_hidden(drawn);
}

}  // namespace epura
