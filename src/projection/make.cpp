// A request and the table of its projection become values, the plugin's answer to them becomes a Projection.
#include <epura/projection_abi.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/catalogue.hpp"

namespace epura {

namespace {

// Sine of the least angle between up and normal, and between projector and plane.
constexpr double least_sine = 1e-9;

[[noreturn]] void refuse_value(const std::string& where, const std::string& reason, const std::string& hint = {}) {
  throw Error(Trouble::input, where, reason, hint);
}

std::string range_of(const Parameter& parameter) {
  const std::string unit = parameter.unit.empty() || parameter.unit == "1" ? "" : " " + parameter.unit;
  if (std::isinf(parameter.least)) return format_number(parameter.most) + unit + " or less";
  if (std::isinf(parameter.most)) return format_number(parameter.least) + unit + " or more";
  return format_number(parameter.least) + " to " + format_number(parameter.most) + unit;
}

std::vector<double> choice_value(const Parameter& parameter, const std::string& text, const std::string& where) {
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
  if (found != parameter.choices.end()) return {static_cast<double>(found - parameter.choices.begin())};
  std::string list;
  for (const std::string& choice : parameter.choices) {
    if (!list.empty()) list += ", ";
    list += choice;
  }
  refuse_value(where, "'" + text + "' is not one of " + list);
}

std::vector<double> value_of(const Parameter& parameter, const std::string& text, const std::string& where) {
  if (parameter.type == ParameterType::choice) return choice_value(parameter, text, where);
  const auto numbers = parse_numbers(text);
  if (!numbers) refuse_value(where, "'" + text + "' is not a number" + (parameter.initial.size() > 1 ? " list" : ""));
  if (numbers->size() != parameter.initial.size())
    refuse_value(where, "takes " + std::to_string(parameter.initial.size()) + " numbers with commas between, not " +
                            std::to_string(numbers->size()));
  for (const double number : *numbers) {
    if (!std::isfinite(number)) refuse_value(where, "must be finite");
    if (number < parameter.least || number > parameter.most)
      refuse_value(where, "is " + format_number(number) + ", allowed is " + range_of(parameter));
  }
  return *numbers;
}

std::vector<std::vector<double>> values_of(const ProjectionEntry& entry, const ProjectionRequest& request) {
  std::vector<std::vector<double>> values;
  std::vector<std::string> names;
  for (const Parameter& parameter : entry.parameters) {
    values.push_back(parameter.initial);
    names.push_back(parameter.name);
  }
  for (const auto& [key, text] : request.assignments) {
    const std::string where = entry.name + ":" + key;
    const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin());
    if (names.empty()) refuse_value(where, "this projection has no parameters");
    if (place == names.size()) refuse_value(where, "no such parameter", did_you_mean(key, names));
    values[place] = value_of(entry.parameters[place], text, where);
  }
  return values;
}

/// A plugin must answer for its own defaults; what the user gave is the user's to mend.
[[noreturn]] void refuse_answer(const ProjectionEntry& entry, const ProjectionRequest& request,
                                const std::string& reason) {
  if (!request.assignments.empty()) refuse_value(entry.name, reason);
  throw Error(Trouble::plugin, entry.plugin.string(), "'" + entry.name + "': " + reason);
}

/// The plugin's answer. Limits and window are preset, so that a simple projection need not speak of them.
epura_view ask(const ProjectionEntry& entry, const ProjectionRequest& request,
               const std::vector<std::vector<double>>& values, const Box& scene) {
  std::vector<double> flat;
  for (const std::vector<double>& value : values) flat.insert(flat.end(), value.begin(), value.end());
  const Box box = scene.empty() ? Box{Vec3(0), Vec3(0)} : scene;
  const epura_scene known{
      sizeof(epura_scene), {box.least.x, box.least.y, box.least.z}, {box.most.x, box.most.y, box.most.z}};
  epura_view view{};
  view.size = sizeof(epura_view);
  view.scale = 1;
  view.front = HUGE_VAL;
  view.back = -HUGE_VAL;
  const auto* definition = static_cast<const epura_projection*>(entry.definition);
  const char* sentence = nullptr;
  try {
    sentence = definition->project(flat.data(), &known, &view);
  } catch (...) {
    throw Error(Trouble::plugin, entry.plugin.string(), "'" + entry.name + "' threw an exception across the border");
  }
  if (sentence != nullptr) refuse_answer(entry, request, sentence);
  return view;
}

Vec3 vector_of(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Scaled first: squares of large or small components would leave the range of doubles.
Vec3 unit_vector(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : Vec3(0);
}

/// What keeps an answer from being a projection; empty if nothing does.
std::string fault_of(const epura_view& view) {
  const Vec3 point = vector_of(view.point), projector = vector_of(view.projector);
  if (view.projectors > EPURA_CENTRAL) return "its projectors are neither parallel nor central";
  if (!finite(point)) return "the point of the plane is not finite";
  if (!finite(vector_of(view.normal))) return "the normal of the plane is not finite";
  if (!finite(vector_of(view.up))) return "the up direction is not finite";
  if (!finite(projector)) return "the projector is not finite";
  const Vec3 n = unit_vector(vector_of(view.normal)), up = unit_vector(vector_of(view.up));
  if (n == Vec3(0)) return "the normal of the plane is zero";
  if (up == Vec3(0)) return "the up direction is zero";
  if (glm::length(glm::cross(up, n)) < least_sine) return "the up direction is parallel to the normal of the plane";
  const bool central = view.projectors == EPURA_CENTRAL;
  const Vec3 line = unit_vector(central ? projector - point : projector);
  if (!(std::abs(glm::dot(line, n)) >= least_sine))
    return central ? "the plane contains the centre of projection" : "the plane contains the direction of projection";
  if (!(view.scale > 0 && std::isfinite(view.scale))) return "the scale is not a positive number";
  const bool whole = std::all_of(view.window, view.window + 4, [](double w) { return w == 0; });
  const bool bounded = std::all_of(view.window, view.window + 4, [](double w) { return std::isfinite(w); });
  if (!whole && !(bounded && view.window[0] < view.window[2] && view.window[1] < view.window[3]))
    return "the window is empty: its least corner must be below its most corner";
  if (!(view.front > view.back)) return "the front plane must lie before the back plane";
  return {};
}

Projection projection_of(const epura_view& view) {
  Projection p;
  p.point = vector_of(view.point);
  p.central = view.projectors == EPURA_CENTRAL;
  p.projector = vector_of(view.projector);
  if (!p.central) p.projector = unit_vector(p.projector);
  p.n = unit_vector(vector_of(view.normal));
  if (glm::dot(p.n, p.central ? p.projector - p.point : p.projector) < 0) p.n = -p.n;
  p.u = glm::normalize(glm::cross(unit_vector(vector_of(view.up)), p.n));
  p.v = glm::cross(p.n, p.u);
  p.scale = view.scale;
  if (view.window[0] < view.window[2])
    p.window = Window{{view.window[0], view.window[1]}, {view.window[2], view.window[3]}};
  p.front = view.front;
  p.back = view.back;
  return p;
}

}  // namespace

ProjectionRequest parse_request(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ':');
  const std::string where(text);
  ProjectionRequest request{std::string(parts[0]), {}};
  if (request.name.empty()) refuse_value(where, "a projection has a name", "NAME[:key=value]...");
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    if (equals == std::string_view::npos || equals == 0)
      refuse_value(where, std::string("'").append(parts[i]) + "' is no key=value", "NAME[:key=value]...");
    const std::string key(parts[i].substr(0, equals));
    for (const auto& [earlier, value] : request.assignments)
      if (earlier == key) refuse_value(request.name + ":" + key, "is given twice");
    request.assignments.emplace_back(key, parts[i].substr(equals + 1));
  }
  return request;
}

Projection make_projection(const ProjectionEntry& entry, const ProjectionRequest& request, const Box& scene) {
  const std::vector<std::vector<double>> values = values_of(entry, request);
  const epura_view view = ask(entry, request, values, scene);
  if (const std::string fault = fault_of(view); !fault.empty()) refuse_answer(entry, request, fault);
  Projection projection = projection_of(view);
  projection.name = entry.name;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::all_of(values[i].begin(), values[i].end(), [](double v) { return std::isfinite(v); }))
      projection.values.emplace_back(entry.parameters[i].name, values[i]);
  return projection;
}

}  // namespace epura
