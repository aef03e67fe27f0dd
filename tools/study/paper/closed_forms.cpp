// SPDX-License-Identifier: Apache-2.0
#include "study/paper/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/text.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::study {

namespace {

constexpr double pi = std::numbers::pi;
// Meshes are turned by this, so that no vertex lies on a contour by chance.
constexpr double turned = 0.1;
// A body hides what it covers by more than this, in its units.
constexpr double min_depth = 1e-9;

using Kind = RoundBody::Kind;

Vec3 on_circle(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Viewer in_frame(const RoundBody& body, const Viewer& viewer) {
  return {viewer.central, body.to_frame(viewer.eye), body.direction_to_frame(viewer.towards)};
}

// Contours of a cone or cylinder: its normal (cos, sin, -slope) is perpendicular to the projectors at the same angles
// for all heights.
std::vector<SpaceCurve> contours_of_frustum(const RoundBody& body, const Viewer& viewer) {
  const double slope = (body.top - body.radius) / body.height;
  const Vec3& at = viewer.central ? viewer.eye : viewer.towards;
  const double across = std::hypot(at.x, at.y), middle = std::atan2(at.y, at.x);
  const double cosine = ((viewer.central ? body.radius : 0) + slope * at.z) / across;
  if (!(std::abs(cosine) < 1)) return {};
  std::vector<SpaceCurve> curves;
  for (const double side : {-1.0, 1.0}) {
    const double angle = middle + side * std::acos(cosine);
    curves.emplace_back([body, angle](double s) {
      return body.to_world(on_circle(body.radius + s * (body.top - body.radius), angle, s * body.height));
    });
  }
  return curves;
}

// The circle around the foot of the viewer's polar plane.
SpaceCurve contour_of_sphere(const RoundBody& body, const Viewer& viewer) {
  const double distance = viewer.central ? glm::length(viewer.eye) : HUGE_VAL;
  const Vec3 axis = glm::normalize(viewer.central ? viewer.eye : viewer.towards);
  const double height = body.radius * body.radius / distance;
  const double radius = std::sqrt(body.radius * body.radius - height * height);
  const std::array<Vec3, 2> across = surfaces::square_to(axis);
  return [body, axis, across, height, radius](double s) {
    const double a = 2 * pi * s;
    return body.to_world(height * axis + radius * (std::cos(a) * across[0] + std::sin(a) * across[1]));
  };
}

// For a direction (d, 0, z) in the plane of the meridian at an angle, the normal (cos t, sin t) is perpendicular where
// tan t = -d / z. Parallel projection only.
std::vector<SpaceCurve> contours_of_torus(const RoundBody& body, const Viewer& viewer) {
  const Vec3 towards = viewer.towards;
  std::vector<SpaceCurve> curves;
  for (const double side : {-1.0, 1.0})
    curves.emplace_back([body, towards, side](double s) {
      const double a = 2 * pi * s;
      const double d = std::cos(a) * towards.x + std::sin(a) * towards.y;
      const double t = std::atan2(-side * d, side * towards.z);
      return body.to_world(on_circle(body.radius + body.tube * std::cos(t), a, body.tube * std::sin(t)));
    });
  return curves;
}

// Half the turns of the sombrero's profile up to its rim.
constexpr double waves = 4;

double profile_of_sombrero(const RoundBody& body, double r) {
  const double s = waves * pi * r / body.radius;
  return s == 0 ? body.height : body.height * std::sin(s) / s;
}

double slope_of_sombrero(const RoundBody& body, double r) {
  const double k = waves * pi / body.radius, s = k * r;
  return s < 1e-4 ? -body.height * k * s / 3 : body.height * k * (s * std::cos(s) - std::sin(s)) / (s * s);
}

// A normal is (-f'(r) cos a, -f'(r) sin a, 1): perpendicular to (d cos m, d sin m, z) where cos(a - m) is
// z / (d f'(r)). For each range of radii in which there are such angles, a closed curve. Parallel projection only.
std::vector<SpaceCurve> contours_of_sombrero(const RoundBody& body, const Viewer& viewer) {
  constexpr int samples = 4096, halvings = 60;
  const Vec3 towards = viewer.towards;
  const double across = std::hypot(towards.x, towards.y), middle = std::atan2(towards.y, towards.x);
  const auto cosine = [=](double r) { return towards.z / (across * slope_of_sombrero(body, r)); };
  const auto is_within = [&](double r) { return std::abs(cosine(r)) <= 1; };
  std::vector<SpaceCurve> curves;
  double begin = 0;
  for (int i = 1; i <= samples; ++i) {
    double low = body.radius * (i - 1) / samples, high = body.radius * i / samples;
    const bool was = is_within(low), is = is_within(high);
    if (was == is) continue;
    for (int k = 0; k < halvings; ++k) (is_within((low + high) / 2) == was ? low : high) = (low + high) / 2;
    if (is) {
      begin = high;
      continue;
    }
    curves.emplace_back([=, end = low](double s) {
      const double r = (begin + end) / 2 - (end - begin) / 2 * std::cos(2 * pi * s);
      const double turn = std::acos(std::clamp(cosine(r), -1.0, 1.0));
      return body.to_world(on_circle(r, middle + (s < 0.5 ? turn : -turn), profile_of_sombrero(body, r)));
    });
  }
  return curves;
}

// The values of the parameter at which a ray is inside the ball, cylinder or cone of a quadric a t^2 + 2 b t + c < 0.
struct Span {
  double from, to;
};
std::optional<Span> inside(double a, double b, double c) {
  if (a == 0) return std::nullopt;
  const double root = b * b - a * c;
  if (!(root > 0) || a < 0) return std::nullopt;
  return Span{(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

std::optional<Span> inside_frustum(const RoundBody& body, const Vec3& p, const Vec3& d) {
  const double slope = (body.top - body.radius) / body.height, r = body.radius + slope * p.z, e = slope * d.z;
  auto span = inside(d.x * d.x + d.y * d.y - e * e, p.x * d.x + p.y * d.y - r * e, p.x * p.x + p.y * p.y - r * r);
  if (!span) return std::nullopt;
  if (d.z == 0) return p.z > 0 && p.z < body.height ? span : std::nullopt;
  const double one = -p.z / d.z, other = (body.height - p.z) / d.z;
  return Span{std::max(span->from, std::min(one, other)), std::min(span->to, std::max(one, other))};
}

// The distance from the surface of a torus, negative inside.
double outside_torus(const RoundBody& body, const Vec3& p) {
  return std::hypot(std::hypot(p.x, p.y) - body.radius, p.z) - body.tube;
}

// Samples the ray and descends to the minimum between samples. Close to the beginning, a contour touches its own body.
bool enters_torus(const RoundBody& body, const Vec3& p, const Vec3& d) {
  constexpr int samples = 400, steps = 40;
  const double reach = 2.2 * (body.radius + body.tube), step = reach / samples;
  const auto at = [&](double t) { return outside_torus(body, p + t * d); };
  double before = at(0), here = at(step);
  for (int i = 1; i < samples; ++i) {
    const double after = at((i + 1) * step);
    if (here < -min_depth) return true;
    if (here <= before && here <= after) {
      double low = (i - 1) * step, high = (i + 1) * step;
      for (int k = 0; k < steps; ++k) {
        const double one = low + 0.382 * (high - low), other = low + 0.618 * (high - low);
        at(one) < at(other) ? high = other : low = one;
      }
      if (at((low + high) / 2) < -min_depth) return true;
    }
    before = here;
    here = after;
  }
  return false;
}

// A point of the sheet is in front of another if the ray from that one passes to its other side before the rim.
bool crosses_sombrero(const RoundBody& body, const Vec3& p, const Vec3& d) {
  constexpr int samples = 2000;
  int side = 0;
  for (int i = 1; i <= samples; ++i) {
    const Vec3 q = p + d * (2.5 * body.radius * i / samples);
    const double r = std::hypot(q.x, q.y);
    if (r > body.radius) continue;
    const double above = q.z - profile_of_sombrero(body, r);
    if (std::abs(above) < min_depth) continue;
    const int now = above > 0 ? 1 : -1;
    if (side != 0 && now != side) return true;
    side = now;
  }
  return false;
}

// A span is deep where the ray is inside by more than rounding: half of its length, squared, over the size.
bool covers(const RoundBody& body, const Viewer& viewer, const Vec3& point) {
  const Vec3 p = body.to_frame(point);
  const Vec3 d =
      glm::normalize(viewer.central ? body.to_frame(viewer.eye) - p : body.direction_to_frame(viewer.towards));
  if (body.kind == Kind::torus) return enters_torus(body, p, d);
  if (body.kind == Kind::sombrero) return crosses_sombrero(body, p, d);
  const auto span = body.kind == Kind::sphere ? inside(1, glm::dot(p, d), glm::dot(p, p) - body.radius * body.radius)
                                              : inside_frustum(body, p, d);
  if (!span) return false;
  const double length = span->to - std::max(span->from, 0.0);
  return length > 0 && length * length > 8 * min_depth * body.radius;
}

std::vector<Vec3> profile_of(const RoundBody& body, int around) {
  std::vector<Vec3> profile;  // x, z
  const auto add = [&](double r, double z) { profile.emplace_back(r, 0, z); };
  if (body.kind == Kind::frustum) {
    add(body.radius, 0);
    add(body.top, body.height);
  } else if (body.kind == Kind::sombrero) {
    const int rings = std::max(2, around / 3);
    for (int i = 0; i <= rings; ++i) {
      const double r = body.radius * i / rings;
      add(r, profile_of_sombrero(body, r));
    }
  } else if (body.kind == Kind::sphere) {
    const int bands = std::max(2, around / 2);
    for (int i = 0; i <= bands; ++i) {
      const double t = -pi / 2 + pi * i / bands;
      add(i == 0 || i == bands ? 0 : body.radius * std::cos(t), body.radius * std::sin(t));
    }
  } else {
    for (int i = 0; i < around; ++i) {
      const double t = 0.3 + 2 * pi * i / around;
      add(body.radius + body.tube * std::cos(t), body.tube * std::sin(t));
    }
  }
  return profile;
}

}  // namespace

Vec3 RoundBody::to_world(const Vec3& p) const { return origin + (lying ? Vec3(p.z, p.x, p.y) : p); }
Vec3 RoundBody::direction_to_frame(const Vec3& d) const { return lying ? Vec3(d.y, d.z, d.x) : d; }
Vec3 RoundBody::to_frame(const Vec3& p) const { return direction_to_frame(p - origin); }

std::vector<ClosedForm> closed_forms() {
  const RoundBody ball{Kind::sphere, 20};
  const RoundBody post{.kind = Kind::frustum, .radius = 20, .top = 20, .height = 60, .origin = {0, 0, -30}};
  RoundBody bar{.kind = Kind::frustum, .radius = 12, .top = 12, .height = 70, .origin = {-35, 0, 0}};
  bar.lying = true;
  RoundBody beside = bar;
  beside.origin.y = -32 - 1e-6;
  const RoundBody drum{.kind = Kind::frustum, .radius = 19.5, .top = 19.5, .height = 50, .origin = {0, 0, -25}};
  std::vector<SpaceCurve> pipes, caps;
  for (const double side : {-1.0, 1.0}) {
    pipes.emplace_back([side](double s) {
      const double y = 12 * std::cos(2 * pi * s), z = 12 * std::sin(2 * pi * s);
      return Vec3(side * std::sqrt(400 - y * y), y, z);
    });
    caps.emplace_back([side](double s) { return on_circle(19.5, 2 * pi * s, side * std::sqrt(400 - 19.5 * 19.5)); });
  }
  return {{"sphere", "isometric", {ball}},
          {"cylinder", "isometric", {post}},
          {"cone", "isometric", {{.kind = Kind::frustum, .radius = 20, .top = 8, .height = 40}}},
          {.name = "torus",
           .projection = "isometric",
           .bodies = {{.kind = Kind::torus, .radius = 20, .tube = 8}},
           .has_cusps = true},
          {.name = "sombrero",
           .projection = "isometric",
           .bodies = {{.kind = Kind::sombrero, .radius = 24, .height = 16}},
           .coarsest = 96,
           .has_cusps = true},
          {"ball before a cone",
           "isometric",
           {{.kind = Kind::frustum, .radius = 20, .top = 8, .height = 40},
            {.kind = Kind::sphere, .radius = 9, .origin = {30, -14, 40}}}},
          {"ball above a drum", "isometric", {drum, {.kind = Kind::sphere, .radius = 12, .origin = {0, 0, 37 + 1e-6}}}},
          {"cylinders side by side", "isometric", {post, beside}},
          {"along its axis", "auxiliary:direction=3,-2,90", {post}},
          {"crossing cylinders", "isometric", {post, bar}, pipes},
          {"nearly tangent", "isometric", {ball, drum}, caps, 48},
          {"wide-angle", "look-at:eye=20,-9,12:ref=0,0,0", {ball}}};
}

mesh::Soup mesh_of(const RoundBody& body, int fineness) {
  const std::vector<Vec3> profile = profile_of(body, fineness);
  // About as long as around the tube.
  const int around =
      body.kind == Kind::torus ? static_cast<int>(std::lround(fineness * body.radius / body.tube)) : fineness;
  const int rings = static_cast<int>(profile.size());
  mesh::Soup soup;
  std::vector<int> first;  // vertex of each ring; rings on the axis have one
  for (const Vec3& p : profile) {
    first.push_back(static_cast<int>(soup.points.size()));
    for (int i = 0; i < (p.x == 0 ? 1 : around); ++i) {
      const Vec3 q = body.to_world(on_circle(p.x, turned + 2 * pi * i / around, p.z));
      soup.points.push_back({q.x, q.y, q.z});
    }
  }
  const auto corner = [&](int ring, int i) { return first[ring] + (profile[ring].x == 0 ? 0 : i % around); };
  const int last = body.kind == Kind::torus ? rings : rings - 1;
  for (int ring = 0; ring < last; ++ring)
    for (int i = 0; i < around; ++i) {
      const int above = (ring + 1) % rings;
      const std::array<int, 4> face{corner(ring, i), corner(ring, i + 1), corner(above, i + 1), corner(above, i)};
      for (std::size_t k = 0; k < 4; ++k)
        if (face[k] != face[(k + 1) % 4]) soup.corners.push_back(face[k]);
      soup.end_face();
    }
  if (body.kind != Kind::frustum) return soup;
  for (int i = around - 1; i >= 0; --i) soup.corners.push_back(corner(0, i));
  soup.end_face();
  for (int i = 0; i < around; ++i) soup.corners.push_back(corner(rings - 1, i));
  soup.end_face();
  return soup;
}

std::string describe_bodies(const ClosedForm& form, const Mat3& turn) {
  std::string text;
  const auto add = [&](const std::vector<double>& numbers) {
    for (const double number : numbers) text += ' ' + format_number(number);
  };
  for (const RoundBody& body : form.bodies) {
    switch (body.kind) {
      case Kind::sphere:
        text += "sphere";
        add({body.radius});
        break;
      case Kind::frustum:
        text += "frustum";
        add({body.radius, body.top, body.height});
        break;
      case Kind::torus:
        text += "torus";
        add({body.radius, body.tube});
        break;
      case Kind::sombrero:
        text += "sombrero";
        add({body.radius, body.height});
    }
    for (const Vec3& v : {turn * body.origin, turn * (body.to_world({0, 0, 1}) - body.origin),
                          turn * (body.to_world({1, 0, 0}) - body.origin)})
      add({v.x, v.y, v.z});
    text += '\n';
  }
  return text;
}

std::vector<SpaceCurve> lines_of(const ClosedForm& form, const Viewer& viewer) {
  std::vector<SpaceCurve> lines = form.crossings;
  const auto add = [&](std::vector<SpaceCurve> more) { lines.insert(lines.end(), more.begin(), more.end()); };
  for (const RoundBody& body : form.bodies) {
    const Viewer own = in_frame(body, viewer);
    if (body.kind == Kind::sphere) add({contour_of_sphere(body, own)});
    if (body.kind == Kind::torus) add(contours_of_torus(body, own));
    if (body.kind == Kind::sombrero) {
      add(contours_of_sombrero(body, own));
      add({[body](double s) {
        return body.to_world(on_circle(body.radius, 2 * pi * s, profile_of_sombrero(body, body.radius)));
      }});
    }
    if (body.kind != Kind::frustum) continue;
    add(contours_of_frustum(body, own));
    add({[body](double s) { return body.to_world(on_circle(body.radius, 2 * pi * s, 0)); },
         [body](double s) { return body.to_world(on_circle(body.top, 2 * pi * s, body.height)); }});
  }
  return lines;
}

bool is_hidden(const ClosedForm& form, const Viewer& viewer, const Vec3& point) {
  return std::any_of(form.bodies.begin(), form.bodies.end(),
                     [&](const RoundBody& body) { return covers(body, viewer, point); });
}

std::vector<std::vector<Vec3>> visible_lines(const ClosedForm& form, const Viewer& viewer, int points) {
  constexpr int tests = 1024, halvings = 40;
  std::vector<std::vector<Vec3>> all;
  for (const SpaceCurve& line : lines_of(form, viewer)) {
    const auto hidden = [&](double s) { return is_hidden(form, viewer, line(s)); };
    const auto add = [&](double from, double to) {
      std::vector<Vec3>& part = all.emplace_back();
      const int count = std::max(2, static_cast<int>(std::ceil((to - from) * points)));
      for (int i = 0; i <= count; ++i) part.push_back(line(from + (to - from) * i / count));
    };
    double begin = 0;
    bool was_hidden = hidden(0);
    for (int i = 1; i <= tests; ++i) {
      double low = double(i - 1) / tests, high = double(i) / tests;
      const bool is = hidden(high);
      if (is == was_hidden) continue;
      for (int k = 0; k < halvings; ++k) (hidden((low + high) / 2) == was_hidden ? low : high) = (low + high) / 2;
      if (!was_hidden) add(begin, low);
      begin = high;
      was_hidden = is;
    }
    if (!was_hidden) add(begin, 1);
  }
  return all;
}

}  // namespace epura::study
