// SPDX-License-Identifier: Apache-2.0
#include "construction/perspective.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>

#include "base/portable_math.hpp"
#include "base/text.hpp"

namespace epura::construction {

namespace {

using scene::ConstructionKind;

const Vec3 up(0, 0, 1);
constexpr double on_line = 1e-9;  // sine of the angle between a direction and a plane in which it lies

Vec3 axis(int i) {
  Vec3 direction(0);
  direction[i] = 1;
  return direction;
}

// Both ways along an axis and at any length, its name: they have one vanishing point.
std::string index_of(const Vec3& direction) {
  constexpr double along = 1e-12;  // sine
  for (int i = 0; i < 3; ++i)
    if (glm::length(glm::cross(glm::normalize(direction), axis(i))) <= along) return std::string(1, "xyz"[i]);
  return format_number(direction.x) + "," + format_number(direction.y) + "," + format_number(direction.z);
}

class Perspective {
 public:
  Perspective(const PicturePlane& plane, std::span<const Request> requests, const Surroundings& around)
      : plane_(plane), requests_(requests), around_(around), horizon_(vanishing_line(plane, up)) {}

  Figure made() {
    for (const Request& request : requests_) make(request);
    return std::move(figure_);
  }

 private:
  void make(const Request& request);
  [[nodiscard]] bool has(ConstructionKind kind) const;
  const PictureLine* expect_horizon(const Request& request) const;
  std::optional<Vec2> expect_vanishing_point(const Request& request, const Vec3& direction) const;
  [[nodiscard]] std::vector<Vec3> directions_of(const Request& request) const;
  [[nodiscard]] std::vector<Vec3> axes_on_horizon() const;
  void add_line_across(const PictureLine& line, const Symbol& symbol);
  void add_vanishing_point(const Vec3& direction, const Vec2& at);
  void add_rays(const Request& request);
  void add_ray(const std::array<Vec3, 2>& edge, const Vec2& at);
  void add_station(const Request& request);
  void add_distance_points(const Request& request);
  void add_measuring_points(const Request& request);
  void add_true_length(const Request& request);
  void add_vanishing_lines(const Request& request);
  void add_ground_line(const Request& request);
  void add_trace(const Request& request);
  void add_cone(const Request& request);
  void add_principal_point();

  const PicturePlane& plane_;
  std::span<const Request> requests_;
  const Surroundings& around_;
  std::optional<PictureLine> horizon_;
  int planes_ = 0, lengths_ = 0;
  Figure figure_{};
};

void Perspective::make(const Request& request) {
  switch (request.item.kind) {
    case ConstructionKind::horizon:
      if (const PictureLine* line = expect_horizon(request)) add_line_across(*line, {"HL"});
      add_term(figure_, "HL", "horizon: vanishing line of horizontal planes");
      return;
    case ConstructionKind::vanishing_point:
      for (const Vec3& direction : directions_of(request))
        if (const auto at = expect_vanishing_point(request, direction)) add_vanishing_point(direction, *at);
      return;
    case ConstructionKind::to_vanishing_point:
      return add_rays(request);
    case ConstructionKind::principal_point:
      return add_principal_point();
    case ConstructionKind::station_point:
      return add_station(request);
    case ConstructionKind::distance_points:
      return add_distance_points(request);
    case ConstructionKind::measuring_points:
      return add_measuring_points(request);
    case ConstructionKind::true_length:
      return add_true_length(request);
    case ConstructionKind::vanishing_line:
      return add_vanishing_lines(request);
    case ConstructionKind::ground_line:
      return add_ground_line(request);
    case ConstructionKind::traces:
      return add_trace(request);
    case ConstructionKind::cone:
      return add_cone(request);
    default:
      return;
  }
}

bool Perspective::has(ConstructionKind kind) const {
  return std::any_of(requests_.begin(), requests_.end(), [kind](const Request& r) { return r.item.kind == kind; });
}

const PictureLine* Perspective::expect_horizon(const Request& request) const {
  if (horizon_) return &*horizon_;
  if (!request.optional)
    refuse(request, "needs a horizon, which is at infinity: the picture is horizontal",
           "choose a projection whose picture plane is not parallel to the ground, such as two-point");
  return nullptr;
}

std::optional<Vec2> Perspective::expect_vanishing_point(const Request& request, const Vec3& direction) const {
  const auto at = vanishing_point(plane_, direction);
  if (!at && !request.optional)
    refuse(request,
           "has its vanishing point at infinity: the direction " + index_of(direction) +
               " is parallel to the picture, where its lines stay parallel",
           "choose a direction that meets the picture plane; 'vp' alone draws those of the axes that do");
  return at;
}

// Without a direction: the axes that meet the picture.
std::vector<Vec3> Perspective::directions_of(const Request& request) const {
  if (request.item.direction) return {*request.item.direction};
  std::vector<Vec3> directions;
  for (int i = 0; i < 3; ++i)
    if (vanishing_point(plane_, axis(i))) directions.push_back(axis(i));
  return directions;
}

std::vector<Vec3> Perspective::axes_on_horizon() const {
  std::vector<Vec3> axes;
  for (const int i : {0, 1})
    if (horizon_ && vanishing_point(plane_, axis(i))) axes.push_back(axis(i));
  return axes;
}

void Perspective::add_line_across(const PictureLine& line, const Symbol& symbol) {
  figure_.lines.push_back({line.foot, line.foot + line.along, Extent::line, symbol});
}

// Points of the horizon are looked for along it, others from the principal point.
void Perspective::add_vanishing_point(const Vec3& direction, const Vec2& at) {
  const bool is_horizontal = std::abs(glm::normalize(direction).z) <= on_line;
  add_point(figure_, {{"VP", index_of(direction)}, at, is_horizontal && horizon_ ? horizon_->foot : plane_.origin});
  add_term(figure_, "VP", "vanishing point of the direction in its index");
}

void Perspective::add_ray(const std::array<Vec3, 2>& edge, const Vec2& at) {
  std::optional<Vec2> nearest;
  for (const Vec3& end : edge)
    if (const auto image = image_of(plane_, end))
      if (!nearest || glm::length(*image - at) < glm::length(*nearest - at)) nearest = image;
  if (nearest) figure_.lines.push_back({*nearest, at});
}

// Of edges on one line, that nearest to the vanishing point is continued.
void Perspective::add_rays(const Request& request) {
  if (request.item.has_element) {
    const Vec3 direction = request.elements[1] - request.elements[0];
    const auto at = expect_vanishing_point(request, direction);
    if (!at) return;
    add_vanishing_point(direction, *at);
    return add_ray({request.elements[0], request.elements[1]}, *at);
  }
  constexpr double same = 1e6;  // steps of the angle for a unit of length
  std::map<std::array<long long, 3>, std::pair<double, std::array<Vec3, 2>>> longest;
  for (const std::array<Vec3, 2>& edge : around_.axis_edges) {
    const Vec3 d = glm::normalize(edge[1] - edge[0]);
    const int i = std::abs(d.x) > 0.5 ? 0 : std::abs(d.y) > 0.5 ? 1 : 2;
    const auto at = vanishing_point(plane_, axis(i));
    const auto image = image_of(plane_, edge[0]), other = image_of(plane_, edge[1]);
    if (!at || !image || !other) continue;
    const Vec2 ray = glm::normalize((*image + *other) / 2.0 - *at);
    const double distance = std::min(glm::length(*image - *at), glm::length(*other - *at));
    const std::array<long long, 3> key{i, std::llround(ray.x * same), std::llround(ray.y * same)};
    const auto [known, is_new] = longest.emplace(key, std::pair(distance, edge));
    if (!is_new && distance < known->second.first) known->second = {distance, edge};
  }
  for (const auto& [key, found] : longest) {
    const Vec3 direction = axis(static_cast<int>(key[0]));
    const Vec2 at = *vanishing_point(plane_, direction);
    add_vanishing_point(direction, at);
    add_ray(found.second, at);
  }
}

void Perspective::add_principal_point() {
  add_point(figure_, {{"PP"}, plane_.origin, plane_.origin});
  add_term(figure_, "PP", "principal point: foot of the perpendicular from the eye");
}

// The eye folded into the picture, with the rays to the vanishing points, which are parallel to the axes.
void Perspective::add_station(const Request& request) {
  const PictureLine* line = expect_horizon(request);
  if (line == nullptr) return;
  const Vec2 eye = folded_eye(plane_, *line);
  add_point(figure_, {{"SP"}, eye, line->foot});
  add_term(figure_, "SP", "station point: the eye, folded about HL into the picture");
  figure_.lines.push_back({line->foot, eye});
  if (!has(ConstructionKind::vanishing_point) && !has(ConstructionKind::measuring_points)) return;
  for (const Vec3& direction : axes_on_horizon()) figure_.lines.push_back({eye, *vanishing_point(plane_, direction)});
}

void Perspective::add_distance_points(const Request& request) {
  const PictureLine* line = expect_horizon(request);
  if (line == nullptr) return;
  const double distance = glm::length(folded_eye(plane_, *line) - line->foot);
  add_point(figure_, {{"D", "1"}, line->foot - distance * line->along, line->foot});
  add_point(figure_, {{"D", "2"}, line->foot + distance * line->along, line->foot});
  add_term(figure_, "D", "distance points: as far on HL as the eye is from it");
}

void Perspective::add_measuring_points(const Request& request) {
  const PictureLine* line = expect_horizon(request);
  if (line == nullptr) return;
  for (const Vec3& direction : axes_on_horizon()) {
    const Vec2 vp = *vanishing_point(plane_, direction), at = measuring_point(plane_, *line, vp);
    add_vanishing_point(direction, vp);
    add_point(figure_, {{"M", index_of(direction)}, at, line->foot});
    if (!has(ConstructionKind::station_point)) continue;
    // The arc that carries the length from SP to M around the vanishing point.
    const Vec2 eye = folded_eye(plane_, *line) - vp, radius = at - vp;
    const double a = portable_atan2(eye.y, eye.x), b = portable_atan2(radius.y, radius.x);
    const double turn = std::remainder(b - a, 2 * std::numbers::pi);
    const double r = glm::length(radius);
    figure_.curves.push_back({vp, {r, 0}, {0, r}, std::min(a, a + turn), std::max(a, a + turn)});
  }
  add_term(figure_, "M", "measuring point: as far from VP as SP is");
}

// The length of an edge, cut off on the line through its trace parallel to the horizon by lines through M.
void Perspective::add_true_length(const Request& request) {
  if (request.item.by_change_of_planes)
    refuse(request, "is a change of planes, which only an épura has", "omit ':auxiliary', or draw --views epura");
  const PictureLine* line = expect_horizon(request);
  if (line == nullptr) return;
  const Vec3 direction = request.elements[1] - request.elements[0];
  if (std::abs(glm::normalize(direction).z) > on_line)
    refuse(request, "is an edge that is not horizontal, and measuring points are for horizontal lines",
           "choose an edge whose ends are equally high");
  const auto vp = expect_vanishing_point(request, direction);
  const auto trace = trace_of_line(plane_, request.elements[0], request.elements[1]);
  if (!vp || !trace) return;
  const Vec2 m = measuring_point(plane_, *line, *vp);
  const std::string index = ++lengths_ > 1 ? std::to_string(lengths_) : "";
  add_vanishing_point(direction, *vp);
  add_point(figure_, {{"M", index_of(direction)}, m, line->foot});
  add_point(figure_, {{"T", index}, *trace, plane_.origin});
  std::vector<Vec2> ends;
  for (const Vec3& end : request.elements) {
    const auto image = image_of(plane_, end);
    if (!image) return;
    const double t = glm::dot(*trace - m, line->across()) / glm::dot(*image - m, line->across());
    ends.push_back(m + t * (*image - m));
    figure_.lines.push_back({m, glm::length(ends.back() - m) > glm::length(*image - m) ? ends.back() : *image});
  }
  figure_.lines.push_back({*trace, *vp});
  const double a = glm::dot(ends[0] - *trace, line->along), b = glm::dot(ends[1] - *trace, line->along);
  figure_.lines.push_back({*trace + std::min({a, b, 0.0}) * line->along, *trace + std::max({a, b, 0.0}) * line->along});
  add_point(figure_, {{"a", index}, ends[0], ends[1]});
  add_point(figure_, {{"b", index}, ends[1], ends[0]});
  figure_.points.push_back(
      {{"TL " + format_rounded(glm::length(direction), 6)}, (ends[0] + ends[1]) / 2.0, ends[0], false, true});
  add_term(figure_, "T", "trace: where the line of the edge meets the picture");
  add_term(figure_, "TL", "true length, between a and b");
  add_term(figure_, "M", "measuring point: as far from VP as SP is");
}

void Perspective::add_vanishing_lines(const Request& request) {
  const std::array<std::pair<int, const char*>, 3> planes{{{0, "yz"}, {1, "zx"}, {2, "xy"}}};
  if (request.item.direction) {
    const auto line = vanishing_line(plane_, *request.item.direction);
    if (!line)
      refuse(request, "has its vanishing line at infinity: planes with this normal are parallel to the picture",
             "choose another normal");
    add_line_across(*line, {"VL", index_of(*request.item.direction)});
  } else {
    for (const auto& [normal, index] : planes)
      if (const auto line = vanishing_line(plane_, axis(normal))) add_line_across(*line, {"VL", index});
  }
  add_term(figure_, "VL", "vanishing line of the planes in its index, or with that normal");
}

void Perspective::add_ground_line(const Request& request) {
  const Vec3 ground(0, 0, around_.box.min.z);
  const auto line = trace_of_plane(plane_, ground, up);
  if (!line) {
    expect_horizon(request);
    return;
  }
  add_line_across(*line, {"GL"});
  add_term(figure_, "GL", "ground line: where the picture meets the ground below the models");
}

// The lines of the plane meet the picture on its trace; those that are parallel vanish on a parallel to it.
void Perspective::add_trace(const Request& request) {
  const std::vector<Vec3>& ring = request.elements;
  Vec3 normal(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) normal += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  const auto line = trace_of_plane(plane_, ring[0], glm::normalize(normal));
  if (!line) refuse(request, "has no trace: the plane is parallel to the picture", "choose another plane");
  const std::string name = plane_name(planes_++);
  add_line_across(*line, {name});
  add_term(figure_, name, "trace in the picture of the plane " + plane_text(request));
}

void Perspective::add_cone(const Request& request) {
  const double half =
      request.item.degrees ? *request.item.degrees * std::numbers::pi / 360 : portable_atan2(around_.reach, plane_.eye);
  const double radius = plane_.eye * portable_tan(half);
  const double degrees = request.item.degrees.value_or(half * 360 / std::numbers::pi);
  figure_.curves.push_back(
      {plane_.origin, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi, {"CV " + format_rounded(degrees, 3) + "°"}});
  add_principal_point();
  add_term(figure_, "CV", "cone of vision, with its full angle at the eye");
}

}  // namespace

Vec2 folded_eye(const PicturePlane& plane, const PictureLine& line) {
  return line.foot - std::hypot(plane.eye, glm::length(line.foot - plane.origin)) * line.across();
}

// Towards the foot of the line, where it is between the vanishing points of perpendicular directions.
Vec2 measuring_point(const PicturePlane& plane, const PictureLine& line, const Vec2& vanishing_point) {
  const double a = glm::dot(vanishing_point - line.foot, line.along);
  const double distance = glm::length(folded_eye(plane, line) - vanishing_point);
  return vanishing_point - (a < 0 ? -distance : distance) * line.along;
}

Figure perspective_figure(const PicturePlane& plane, std::span<const Request> requests, const Surroundings& around) {
  return Perspective(plane, requests, around).made();
}

}  // namespace epura::construction
