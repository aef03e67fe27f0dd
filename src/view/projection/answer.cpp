// SPDX-License-Identifier: Apache-2.0
#include "projection/answer.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/kept_arithmetic.hpp"

namespace epura::projection {

namespace {

// Sine of the least angle between up and normal, and between projector and plane.
constexpr double min_sine = 1e-9;

Vec3 vector_of(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Scaled first, since squares of large or small components would exceed the range of doubles.
Vec3 unit_vector(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : Vec3(0);
}

}  // namespace

/// Limits and window are preset, so that a simple projection need not mention them.
PluginAnswer call_function(const MakeView& make, const std::vector<double>& values, const Box& scene) {
  const Box box = scene.empty() ? Box{Vec3(0), Vec3(0)} : scene;
  const epura_scene known{sizeof(epura_scene), {box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
  PluginAnswer answer{};
  answer.view.size = sizeof(epura_view);
  answer.view.scale = 1;
  answer.view.front = HUGE_VAL;
  answer.view.back = -HUGE_VAL;
  const KeptArithmetic arithmetic;
  answer.refusal = make(values, known, answer.view);
  if (arithmetic.is_changed())
    throw Error(ErrorKind::plugin, "", "leaves another rounding mode, or flushes subnormal numbers to zero");
  return answer;
}

PluginAnswer call_plugin(const epura_projection& definition, const std::vector<double>& values, const Box& scene) {
  const auto make = [&](const std::vector<double>& numbers, const epura_scene& box,
                        epura_view& view) -> std::optional<std::string> {
    try {
      const char* sentence = definition.project(numbers.data(), &box, &view);
      return sentence == nullptr ? std::nullopt : std::optional<std::string>(sentence);
    } catch (...) {
      throw Error(ErrorKind::plugin, "", "threw an exception across the C interface");
    }
  };
  return call_function(make, values, scene);
}

PluginAnswer ask_plugin(const ProjectionEntry& entry, const ParameterValues& values, const Box& scene) {
  try {
    return entry.ask(foreign::flattened(values), scene);
  } catch (const Error& error) {
    throw Error(ErrorKind::plugin, entry.plugin.string(), "'" + entry.name + "' " + error.what());
  }
}

std::string fault_of_numbers(const epura_view& view) {
  if (!finite(vector_of(view.point))) return "the point of the plane is not finite";
  if (!finite(vector_of(view.normal))) return "the normal of the plane is not finite";
  if (!finite(vector_of(view.up))) return "the up direction is not finite";
  if (!finite(vector_of(view.projector))) return "the projector is not finite";
  if (!std::isfinite(view.scale)) return "the scale is not finite";
  for (const double w : view.window)
    if (!std::isfinite(w)) return "the window is not finite";
  if (std::isnan(view.front) || std::isnan(view.back)) return "the front or the back plane is not a number";
  return {};
}

std::string fault_of_plane(const epura_view& view) {
  if (view.projectors > EPURA_CENTRAL) return "its projectors are neither parallel nor central";
  const Vec3 n = unit_vector(vector_of(view.normal)), up = unit_vector(vector_of(view.up));
  if (n == Vec3(0)) return "the normal of the plane is zero";
  if (up == Vec3(0)) return "the up direction is zero";
  if (glm::length(glm::cross(up, n)) < min_sine) return "the up direction is parallel to the normal of the plane";
  const bool central = view.projectors == EPURA_CENTRAL;
  const Vec3 projector = vector_of(view.projector);
  const Vec3 line = unit_vector(central ? projector - vector_of(view.point) : projector);
  if (!(std::abs(glm::dot(line, n)) >= min_sine))
    return central ? "the plane contains the centre of projection" : "the plane contains the direction of projection";
  return {};
}

std::string fault_of_picture(const epura_view& view) {
  if (!(view.scale > 0)) return "the scale is not a positive number";
  const bool whole = std::all_of(view.window, view.window + 4, [](double w) { return w == 0; });
  if (!whole && !(view.window[0] < view.window[2] && view.window[1] < view.window[3]))
    return "the window is empty: its minimum must be below its maximum";
  if (!(view.front > view.back)) return "the front plane must lie in front of the back plane";
  return {};
}

std::string fault_of(const epura_view& view) {
  for (const auto& fault : {fault_of_numbers, fault_of_plane, fault_of_picture})
    if (std::string sentence = fault(view); !sentence.empty()) return sentence;
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

}  // namespace epura::projection
