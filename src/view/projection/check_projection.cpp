// SPDX-License-Identifier: Apache-2.0
#include "projection/check_projection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/answer.hpp"
#include "projection/matrices.hpp"
#include "projection/probes.hpp"

namespace epura::projection {

namespace {

// Sine of the angle by which a line may bend; also the least length of its image, relative to the distance of that
// image.
constexpr double min_bend = 1e-9;
// A line whose image is shorter than its length times this has no direction: it is seen end on.
constexpr double end_on = 1e-5;

/// A projection under test. `answer` is the answer to the defaults; once it has no fault, `projection` is set.
struct Subject {
  const ProjectionEntry& entry;
  ParameterValues values = default_values(entry.parameters);
  PluginAnswer answer{};
  Projection projection{};
};

std::optional<Projection> projection_for(const ProjectionEntry& entry, const ParameterValues& values, const Box& box) {
  const PluginAnswer answer = ask_plugin(entry, values, box);
  if (answer.refusal || !fault_of(answer.view).empty()) return std::nullopt;
  return projection_of(answer.view);
}

bool same(const Projection& a, const Projection& b) {
  const auto window = [](const Projection& p) { return p.window.value_or(Window{Vec2(0), Vec2(0)}); };
  return a.point == b.point && a.u == b.u && a.n == b.n && a.central == b.central && a.projector == b.projector &&
         a.scale == b.scale && window(a).min == window(b).min && window(a).max == window(b).max && a.front == b.front &&
         a.back == b.back;
}

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + format_number(value);
  return text;
}

std::string assignment(const Parameter& parameter, const std::vector<double>& value) {
  const bool word = parameter.type == ParameterType::choice;
  return parameter.name + "=" + (word ? parameter.choices[static_cast<std::size_t>(value[0])] : numbers(value));
}

/// Position on the plane, and depth.
Vec3 image_of(const Projection& p, const Vec3& x) {
  const Vec4 h = view_matrix(p) * Vec4(x, 1);
  return Vec3(h) / h.w;
}

/// Sine of the angle between two directions; NaN if one of them has length 0.
double bend(const Vec3& a, const Vec3& b) { return glm::length(glm::cross(glm::normalize(a), glm::normalize(b))); }

std::string answers(Subject& subject) {
  subject.answer = ask_plugin(subject.entry, subject.values, probe_box());
  return subject.answer.refusal ? "they are rejected: " + *subject.answer.refusal : "";
}

std::string finite_numbers(Subject& subject) { return fault_of_numbers(subject.answer.view); }

std::string plane(Subject& subject) { return fault_of_plane(subject.answer.view); }

std::string picture(Subject& subject) {
  std::string fault = fault_of_picture(subject.answer.view);
  if (fault.empty()) subject.projection = projection_of(subject.answer.view);
  return fault;
}

std::string repeats(Subject& subject) {
  const auto again = projection_for(subject.entry, subject.values, probe_box());
  return again && same(*again, subject.projection) ? "" : "the second answer to the defaults differs";
}

std::string lines(Subject& subject) {
  const auto corners = points_before_viewer(subject.projection, probe_box());
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 a = corners[i], b = corners[7 - i];
    const Vec3 from = image_of(subject.projection, a), to = image_of(subject.projection, b);
    if (!finite(from) || !finite(to)) return "a corner of the model is drawn at infinity";
    if (!(glm::length(to - from) > min_bend * std::max(glm::length(from), glm::length(to))))
      return "a line is drawn as a point: the plane lies too far from the model";
    for (const double t : {0.1, 0.5, 0.8})
      if (!(bend(to - from, image_of(subject.projection, a + t * (b - a)) - from) < min_bend))
        return "a straight line is bent: the plane lies too far from the model";
  }
  return {};
}

std::string depth(Subject& subject) {
  const Projection& p = subject.projection;
  for (const Vec3& corner : points_before_viewer(p, probe_box())) {
    const Vec3 step = p.central ? 0.1 * (p.projector - corner) : p.projector;
    for (int i = -5; i < 5; ++i)
      if (!(image_of(p, corner + double(i) * step).z < image_of(p, corner + (i + 1.0) * step).z))
        return "depth does not grow along a projector";
  }
  return {};
}

/// Whether the images of parallels to an axis lead to its vanishing point, or are parallel if it has none.
bool meet(const Projection& p, const Vec3& axis, const std::optional<Vec2>& vanishing_point) {
  std::optional<Vec3> first;
  const double step = p.central ? glm::dot(p.projector - p.point, p.n) / 4 : 1;  // so that points stay in front of the
                                                                                 // viewer
  for (const Vec3& corner : points_before_viewer(p, probe_box())) {
    const auto on_plane = [&p](const Vec3& x) { return Vec3(Vec2(image_of(p, x)), 0); };
    const Vec3 from = on_plane(corner), along = on_plane(corner + step * axis) - from;
    if (glm::length(along) < end_on * step) continue;
    const Vec3 wanted = vanishing_point ? Vec3(*vanishing_point, 0) - from : first.value_or(along);
    if (glm::length(wanted) > end_on * step && !(bend(along, wanted) < min_bend)) return false;
    first = along;
  }
  return true;
}

std::string vanishing(Subject& subject) {
  const auto points = vanishing_points(subject.projection);
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    if (!meet(subject.projection, axis, points[static_cast<std::size_t>(i)]))
      return std::string("parallels to ") + "xyz"[i] + " do not";
  }
  return {};
}

/// Whether some value of the parameter changes the answer to `values`.
bool matters(const ProjectionEntry& entry, std::size_t parameter, ParameterValues values) {
  const auto before = projection_for(entry, values, probe_box());
  if (!before) return false;
  for (const std::vector<double>& value : probe_values(entry.parameters[parameter])) {
    values[parameter] = value;
    const auto after = projection_for(entry, values, probe_box());
    if (after && !same(*before, *after)) return true;
  }
  return false;
}

/// Some parameters have an effect only for certain values of another one.
bool matters_in_company(const ProjectionEntry& entry, std::size_t parameter, const ParameterValues& values) {
  for (std::size_t other = 0; other < values.size(); ++other) {
    if (other == parameter) continue;
    ParameterValues beside = values;
    for (const std::vector<double>& value : probe_values(entry.parameters[other])) {
      beside[other] = value;
      if (matters(entry, parameter, beside)) return true;
    }
  }
  return false;
}

std::string parameters(Subject& subject) {
  for (std::size_t i = 0; i < subject.values.size(); ++i)
    if (!matters(subject.entry, i, subject.values) && !matters_in_company(subject.entry, i, subject.values))
      return subject.entry.parameters[i].name + " changes nothing";
  return {};
}

std::string fault_at(const ProjectionEntry& entry, const ParameterValues& values) {
  const PluginAnswer answer = ask_plugin(entry, values, probe_box());
  if (answer.refusal) return answer.refusal->empty() ? "is rejected without a message" : "";
  return fault_of_numbers(answer.view);
}

std::string bounds(Subject& subject) {
  for (std::size_t i = 0; i < subject.values.size(); ++i) {
    const Parameter& parameter = subject.entry.parameters[i];
    for (const std::vector<double>& value : end_values(parameter)) {
      ParameterValues values = subject.values;
      values[i] = value;
      const std::string fault = fault_at(subject.entry, values);
      if (!fault.empty()) return assignment(parameter, value) + ": " + fault;
    }
  }
  return {};
}

std::string models(Subject& subject) {
  for (const Box& box : extreme_boxes()) {
    const PluginAnswer answer = ask_plugin(subject.entry, subject.values, box);
    const std::string fault = answer.refusal ? *answer.refusal : fault_of(answer.view);
    if (fault.empty()) continue;
    return box.empty() ? "without a model: " + fault
                       : "for a model from " + format_number(box.min.x) + " to " + format_number(box.max.x) +
                             " along x: " + fault;
  }
  return {};
}

struct Check {
  const char* name;
  const char* what;
  std::string (*fault)(Subject&);
  bool is_ground;  ///< whether its failure leaves no projection to continue with
};

constexpr Check checks[] = {
    {"answers", "the defaults are accepted", answers, true},
    {"finite", "the answer has finite numbers", finite_numbers, true},
    {"plane", "plane, up and projectors are independent", plane, true},
    {"picture", "scale, window and limits leave something to draw", picture, true},
    {"repeats", "the same values give the same answer", repeats, false},
    {"lines", "straight lines stay straight lines", lines, false},
    {"depth", "depth grows towards the viewer", depth, false},
    {"vanishing", "parallels meet in their vanishing point, or stay parallel", vanishing, false},
    {"parameters", "each parameter matters", parameters, false},
    {"bounds", "the ends of each range are accepted, or rejected with a message", bounds, false},
    {"models", "no model, points, tiny and huge models get an answer", models, false},
};

std::string fault_of_check(const Check& check, Subject& subject) {
  try {
    return check.fault(subject);
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

std::vector<CheckResult> check_projection(const ProjectionEntry& entry, const foreign::TellResult& tell) {
  Subject subject{entry};
  std::vector<CheckResult> results;
  bool has_ground = true;
  for (const Check& check : checks) {
    const std::string fault = has_ground ? fault_of_check(check, subject) : "";
    const Verdict verdict = !has_ground ? Verdict::skipped : fault.empty() ? Verdict::passed : Verdict::failed;
    results.push_back({check.name, check.what, verdict, fault});
    if (tell) tell(results.back());
    if (check.is_ground && verdict == Verdict::failed) has_ground = false;
  }
  return results;
}

}  // namespace epura::projection
