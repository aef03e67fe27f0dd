// SPDX-License-Identifier: Apache-2.0
#include "svg/gradients.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "svg/basic_shapes.hpp"
#include "svg/style.hpp"

namespace epura::svg {

namespace {

struct Stop {
  double offset;
  Paint paint;
};

struct Gradient {
  std::vector<Stop> stops{};
  std::string like{};  ///< id of the one whose stops it takes over
};

Stop read_stop(const pugi::xml_node& element) {
  const Declarations style = read_declarations(element.attribute("style").value());
  const auto value = [&](const char* property) {
    const auto found = style.find(property);
    return found != style.end() ? found->second : std::string(element.attribute(property).value());
  };
  return {alpha_of(element.attribute("offset").value()).value_or(0),
          {named_colour(value("stop-color")).value_or(Colour()), alpha_of(value("stop-opacity")).value_or(1)}};
}

Colour between(const Colour& a, const Colour& b, double part) {
  const auto mix = [part](int from, int to) { return static_cast<int>(std::lround(from + part * (to - from))); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Paint middle_of(const std::vector<Stop>& stops) {
  constexpr double middle = 0.5;
  const auto after = std::find_if(stops.begin(), stops.end(), [](const Stop& stop) { return stop.offset >= middle; });
  if (after == stops.begin() || after == stops.end())
    return after == stops.end() ? stops.back().paint : stops.front().paint;
  const Stop& before = *std::prev(after);
  const double part = (middle - before.offset) / (after->offset - before.offset);
  return {between(before.paint.colour, after->paint.colour, part),
          before.paint.alpha + part * (after->paint.alpha - before.paint.alpha)};
}

void collect(const pugi::xml_node& node, std::map<std::string, Gradient>& gradients, int depth) {
  constexpr int deepest = 100;
  if (depth > deepest) return;
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (name != "linearGradient" && name != "radialGradient") {
      collect(child, gradients, depth + 1);
      continue;
    }
    Gradient& gradient = gradients[child.attribute("id").value()];
    for (const pugi::xml_node stop : child.children("stop")) gradient.stops.push_back(read_stop(stop));
    const char* link = child.attribute(child.attribute("href") ? "href" : "xlink:href").value();
    if (link[0] == '#') gradient.like = link + 1;
  }
}

}  // namespace

Colour on_white(const Paint& paint) { return between({255, 255, 255}, paint.colour, paint.alpha); }

std::optional<double> alpha_of(std::string_view text) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const auto number = parse_number(text);
  if (!number) return std::nullopt;
  const double alpha = is_percent ? *number / 100 : *number;
  return alpha >= 0 && alpha <= 1 ? std::optional(alpha) : std::nullopt;
}

Gradients gradients_of(const pugi::xml_node& svg) {
  std::map<std::string, Gradient> all;
  collect(svg, all, 0);
  Gradients middles;
  for (const auto& [id, gradient] : all) {
    const Gradient* with_stops = &gradient;
    // Each step leads to another one, unless they refer to each other in a ring.
    for (std::size_t step = 0; step < all.size() && with_stops->stops.empty(); ++step) {
      const auto next = all.find(with_stops->like);
      if (next == all.end()) break;
      with_stops = &next->second;
    }
    if (!with_stops->stops.empty()) middles.emplace(id, middle_of(with_stops->stops));
  }
  return middles;
}

std::string_view referenced_id(std::string_view paint) {
  constexpr std::string_view before = "url(#";
  if (!paint.starts_with(before)) return {};
  paint.remove_prefix(before.size());
  return paint.substr(0, std::min(paint.find(')'), paint.size()));
}

}  // namespace epura::svg
