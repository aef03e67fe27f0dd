// SPDX-License-Identifier: Apache-2.0
#include "construction/set_up.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/convex_hull.hpp"
#include "base/portable_math.hpp"

namespace epura::construction {

namespace {

using projection::Projection;
using projection::Quantity;

// In diagonals of the box of the models.
constexpr double plane_clearance = 0.35;  // of a plane that is moved
constexpr double plane_touches = 0.05;    // a plane nearer to the front of the models is moved
constexpr double plane_reach = 4;         // a plane farther away is moved
constexpr double centre_reach = 6;        // a centre farther away has an arrow
constexpr double ray_end = 0.45;          // of rays that end in arrows, from the plane
constexpr double axis_length = 0.3;       // of u, v, n
constexpr double arrow = 0.045;           // length of its head
constexpr double normalised_size = 0.8;   // of the unit cube
constexpr double between = 0.35;          // from the set-up to the unit cube
constexpr double min_room = 0.1;          // of the way from the models to the centre, for the plane
constexpr double frame_margin = 0.12;     // around the window

Vec3 corner_of(const Box& box, int i) {
  return {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
          (i & 4) != 0 ? box.max.z : box.min.z};
}

/// Depths and positions along the projectors. A depth is the coordinate along n from the plane's point.
class Projectors {
 public:
  explicit Projectors(const Projection& p) : p_(p) {
    slope_ = glm::dot(p.projector, p.n);
    if (p.central) eye_ = glm::dot(p.projector - p.point, p.n);
  }

  [[nodiscard]] double depth(const Vec3& at) const { return glm::dot(at - p_.point, p_.n); }
  [[nodiscard]] double eye() const { return eye_; }
  [[nodiscard]] bool is_before_viewer(const Vec3& at) const { return !p_.central || depth(at) < eye_; }
  /// From a point along its projector, as far as it rises by one in depth.
  [[nodiscard]] Vec3 step(const Vec3& from) const {
    return p_.central ? (p_.projector - from) / (eye_ - depth(from)) : p_.projector / slope_;
  }
  [[nodiscard]] Vec3 at_depth(const Vec3& from, double depth_there) const {
    return from + step(from) * (depth_there - depth(from));
  }
  [[nodiscard]] Vec3 in_plane(const Vec2& at) const { return p_.point + at.x * p_.u + at.y * p_.v; }
  [[nodiscard]] Vec2 coordinates(const Vec3& at) const {
    return {glm::dot(at - p_.point, p_.u), glm::dot(at - p_.point, p_.v)};
  }

 private:
  const Projection& p_;
  double eye_ = HUGE_VAL, slope_ = 1;
};

std::array<Vec2, 4> corners_of(const projection::Window& window) {
  return {window.min, Vec2(window.max.x, window.min.y), window.max, Vec2(window.min.x, window.max.y)};
}

// From the left of the viewer, and above the ground if the plane is not seen from behind then.
Vec3 beside(const Projection& p) {
  constexpr double turn = 55, turn_of_plan = 35;                   // degrees
  constexpr double low = 20, high = 33, below = -25, steep = 0.8;  // degrees; sine
  constexpr double too_near = 0.77;                                // cosine of the angle to the projectors
  const Vec3 level =
      std::abs(p.n.z) < steep ? Vec3(p.n.x, p.n.y, 0) : -Vec3(p.v.x, p.v.y, 0) * std::copysign(1.0, p.n.z);
  const double elevation = (p.n.z >= steep ? high : p.n.z < -0.5 ? below : low) * degree;
  const auto turned = [&](double by) {
    const double c = portable_cos(by * degree), s = portable_sin(by * degree);
    const Vec3 flat = glm::normalize(level);
    return Vec3(portable_cos(elevation) * (c * flat.x - s * flat.y),
                portable_cos(elevation) * (s * flat.x + c * flat.y), portable_sin(elevation));
  };
  const double usual = std::abs(p.n.z) < steep ? turn : turn_of_plan;
  const Vec3 towards = glm::normalize(p.central ? p.projector - p.point : p.projector);
  const double first = glm::dot(turned(usual), towards), second = glm::dot(turned(-usual), towards);
  return turned(first > too_near && second < first ? -usual : usual);
}

class Builder {
 public:
  explicit Builder(const SetUpInput& input)
      : in_(input), p_(input.projection), projectors_(input.projection), middle_(input.box.centre()) {
    const double size = glm::length(input.box.size());
    diagonal_ = size > 0 ? size : 1;
    made_.seen_from = glm::normalize(input.seen_from ? *input.seen_from : beside(p_));
    const bool is_plan = std::abs(made_.seen_from.z) > 0.999;
    right_ = glm::normalize(glm::cross(is_plan ? Vec3(0, 1, 0) : Vec3(0, 0, 1), made_.seen_from));
    up_ = glm::cross(made_.seen_from, right_);
  }

  SetUp made() {
    place_plane();
    add_axes();
    add_centre();
    add_image();
    add_plane();
    add_volume();
    add_rays();
    add_normalised();
    return std::move(made_);
  }

 private:
  void place_plane();
  void add_image();
  void add_plane();
  void add_volume();
  void add_centre();
  void add_rays();
  void add_ray(const Vec3& point);
  void add_axes();
  void add_normalised();
  void add_normalised_volume(const Mat4& place);
  void add(SetUpPart part, const Vec3& from, const Vec3& to) {
    for (SetUpLines& lines : made_.lines)
      if (lines.part == part) return lines.segments.push_back({from, to});
    made_.lines.push_back({part, {{from, to}}});
  }
  void add_ring(SetUpPart part, const std::array<Vec3, 4>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add(part, ring[i], ring[(i + 1) % ring.size()]);
  }
  void add_arrow(SetUpPart part, const Vec3& from, const Vec3& to);
  void name(const std::string& symbol, const Vec3& at, std::optional<Quantity> quantity, bool marked,
            const std::optional<Vec3>& away_from = {}) {
    made_.points.push_back({{symbol, at, {}, marked, away_from}, quantity});
  }
  [[nodiscard]] Vec3 shown(const Vec2& at) const { return Vec3(made_.to_image * Vec4(at, 0, 1)); }
  [[nodiscard]] bool is_near(const Vec3& at, double reach) const {
    return glm::length(at - middle_) <= reach * diagonal_;
  }
  // As far from the middle of the models as possible for who looks at it, where they do not hide it.
  [[nodiscard]] Vec3 outermost(const std::array<Vec3, 4>& ring) const {
    const auto distance = [&](const Vec3& at) { return glm::length(glm::cross(at - middle_, made_.seen_from)); };
    return *std::max_element(ring.begin(), ring.end(),
                             [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  }
  [[nodiscard]] std::array<Vec3, 4> at_depth(double depth) const {
    std::array<Vec3, 4> ring;
    const auto window = corners_of(in_.model.volume.window);
    for (std::size_t i = 0; i < 4; ++i) ring[i] = projectors_.at_depth(projectors_.in_plane(window[i]), depth);
    return ring;
  }

  const SetUpInput& in_;
  const Projection& p_;
  Projectors projectors_;
  Vec3 middle_;
  double diagonal_ = 1;
  Vec3 right_, up_;  ///< for who looks at all of it
  SetUp made_{};
};

// Where the plane is drawn, and the map of its own coordinates to there.
void Builder::place_plane() {
  double front = -HUGE_VAL, back = HUGE_VAL;
  for (int i = 0; i < 8; ++i) {
    front = std::max(front, projectors_.depth(corner_of(in_.box, i)));
    back = std::min(back, projectors_.depth(corner_of(in_.box, i)));
  }
  const double room = projectors_.eye() - front;
  const bool cuts = front > -plane_touches * diagonal_ && back < -1e-9 * diagonal_;
  const bool far = front < -plane_reach * diagonal_ || back > plane_reach * diagonal_;
  if (back > plane_reach * diagonal_)
    made_.plane = back - plane_clearance * diagonal_;
  else if ((far || (cuts && !in_.keeps_plane)) && room > min_room * diagonal_)
    made_.plane = front + std::min(plane_clearance * diagonal_, room / 2);
  // Along the projectors: by p / (n.p), or towards the centre.
  const double ratio = p_.central ? 1 - made_.plane / projectors_.eye() : 1;
  const Vec3 origin = projectors_.at_depth(p_.point, made_.plane);
  made_.to_image = Mat4(Vec4(ratio * p_.u, 0), Vec4(ratio * p_.v, 0), Vec4(p_.n, 0), Vec4(origin, 1));
  const auto corners = corners_of(in_.model.volume.window);
  made_.has_window = std::all_of(corners.begin(), corners.end(),
                                 [&](const Vec2& corner) { return is_near(shown(corner), centre_reach); });
}

void Builder::add_image() {
  for (const auto& [from, to] : in_.image)
    if (is_near(shown(from), centre_reach) && is_near(shown(to), centre_reach))
      add(SetUpPart::image, shown(from), shown(to));
}

void Builder::add_plane() {
  if (!made_.has_window) return;
  const projection::Window& window = in_.model.volume.window;
  const auto corners = corners_of(window);
  const Vec2 size = window.max - window.min, margin(frame_margin * std::max(size.x, size.y));
  const auto outer = corners_of({window.min - margin, window.max + margin});
  std::array<Vec3, 4> frame, inner;
  for (std::size_t i = 0; i < 4; ++i) {
    frame[i] = shown(outer[i]);
    inner[i] = shown(corners[i]);
  }
  add_ring(SetUpPart::plane, frame);
  add_ring(SetUpPart::plane, inner);
  const Vec3 middle = (frame[0] + frame[2]) / 2.0;
  name("view plane", frame[3], std::nullopt, false, middle);
  name("umin, vmin", inner[0], Quantity::window, true, middle);
  name("umax, vmax", inner[2], Quantity::window, true, middle);
}

void Builder::add_volume() {
  if (!made_.has_window) return;
  const std::array<Vec3, 4> front = at_depth(in_.model.volume.front), back = at_depth(in_.model.volume.back);
  add_ring(SetUpPart::volume, front);
  add_ring(SetUpPart::volume, back);
  for (std::size_t i = 0; i < 4; ++i) add(SetUpPart::volume, back[i], front[i]);
  name("F", outermost(front), Quantity::front, true, middle_);
  name("B", outermost(back), Quantity::back, true, middle_);
}

void Builder::add_arrow(SetUpPart part, const Vec3& from, const Vec3& to) {
  add(part, from, to);
  const Vec3 along = glm::normalize(to - from), across = glm::cross(along, made_.seen_from);
  if (!(glm::length(across) > 1e-6)) return;
  const double head = arrow * diagonal_;
  for (const double side : {-0.3, 0.3}) add(part, to, to - head * along + side * head * glm::normalize(across));
}

// The centre if it is near; otherwise an arrow from the middle of the window towards it, or along the projectors.
void Builder::add_centre() {
  const projection::Window& window = in_.model.volume.window;
  const Vec3 middle = made_.has_window ? shown((window.min + window.max) / 2.0) : shown({0, 0});
  if (p_.central && is_near(p_.projector, centre_reach)) {
    name("PRP", p_.projector, Quantity::projector, true, middle);
    // Its perpendicular, which shows how far it is from where the picture is.
    const Vec3 foot = p_.projector - (projectors_.eye() - made_.plane) * p_.n;
    add(SetUpPart::plane, p_.projector, foot);
    name("PP", foot, std::nullopt, true, middle);
    if (made_.has_window)
      for (const Vec3& corner : at_depth(in_.model.volume.front)) add(SetUpPart::rays, corner, p_.projector);
    return;
  }
  if (p_.central) made_.far = glm::length(p_.projector - middle_);
  const Vec3 along = glm::normalize(projectors_.step(middle));
  const Vec3 tip = middle + 1.6 * ray_end * diagonal_ * along;
  add_arrow(SetUpPart::rays, middle, tip);
  name("PRP", tip, Quantity::projector, false, middle);
}

void Builder::add_ray(const Vec3& point) {
  if (!projectors_.is_before_viewer(point)) return;
  const Vec3 image = projectors_.at_depth(point, made_.plane);
  if (!is_near(image, centre_reach)) return;
  made_.rays.push_back({point, image});
  const bool is_behind = projectors_.depth(point) > made_.plane;
  const Vec3 &first = is_behind ? image : point, &second = is_behind ? point : image;
  if (glm::length(second - first) > 1e-9 * diagonal_) add(SetUpPart::rays, first, second);
  if (p_.central && !made_.far) return add(SetUpPart::rays, second, p_.projector);
  add_arrow(SetUpPart::rays, second, second + ray_end * diagonal_ * glm::normalize(projectors_.step(second)));
}

void Builder::add_rays() {
  for (const Vec3& point : in_.points) add_ray(point);
}

void Builder::add_axes() {
  const Vec3 origin = shown({0, 0});
  if (!is_near(origin, centre_reach)) return;
  name(made_.plane == 0 ? "VRP" : "VRP'", origin, Quantity::point, true);
  const auto add_axis = [&](const char* symbol, const Vec3& axis, std::optional<Quantity> quantity) {
    const Vec3 tip = origin + axis_length * diagonal_ * axis;
    add_arrow(SetUpPart::plane, origin, tip);
    name(symbol, tip, quantity, false, origin);
  };
  add_axis("u", p_.u, std::nullopt);
  add_axis("v", p_.v, Quantity::up);
  add_axis("n", p_.n, Quantity::normal);
}

// On the right of everything else for who looks at it, in the directions of u, v, n.
void Builder::add_normalised() {
  const auto on_page = [&](const Vec3& at) { return Vec2(glm::dot(at, right_), glm::dot(at, up_)); };
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  const auto hold = [&](const Vec3& at) {
    min = glm::min(min, on_page(at));
    max = glm::max(max, on_page(at));
  };
  for (int i = 0; i < 8; ++i) hold(corner_of(in_.box, i));
  for (const SetUpLines& lines : made_.lines)
    for (const auto& [from, to] : lines.segments) {
      hold(from);
      hold(to);
    }
  const double size = normalised_size * diagonal_;
  Box cube;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = corner_of({Vec3(0), Vec3(1)}, i) * size;
    cube.add(Vec3(on_page(corner.x * p_.u + corner.y * p_.v + corner.z * p_.n), 0));
  }
  const Vec2 at(max.x + between * diagonal_ - cube.min.x, (min.y + max.y - cube.min.y - cube.max.y) / 2);
  const Vec3 origin = at.x * right_ + at.y * up_ + glm::dot(middle_, made_.seen_from) * made_.seen_from;
  const Mat4 place(Vec4(size * p_.u, 0), Vec4(size * p_.v, 0), Vec4(size * p_.n, 0), Vec4(origin, 1));
  add_normalised_volume(place);
  made_.normalised = place * in_.model.steps[1].matrix * in_.model.steps[0].matrix;
}

void Builder::add_normalised_volume(const Mat4& place) {
  const projection::ViewVolume& volume = in_.model.volume;
  const double top = p_.central ? (volume.front - volume.back) / (volume.prp.z - volume.back) : 1;
  const double inset = p_.central ? top / 2 : 0;
  const auto at = [&](const Vec3& normalised) { return Vec3(place * Vec4(normalised, 1)); };
  std::array<Vec3, 4> base, lid;
  const auto low = corners_of({{0, 0}, {1, 1}}), high = corners_of({Vec2(inset), Vec2(1 - inset)});
  for (std::size_t i = 0; i < 4; ++i) {
    base[i] = at({low[i], 0});
    lid[i] = at({high[i], top});
  }
  constexpr double flattest = 1e-6;
  made_.is_flat = top < flattest;
  add_ring(SetUpPart::normalised, base);
  add_ring(SetUpPart::normalised, lid);
  const Vec3 apex = at({0.5, 0.5, 1});
  for (std::size_t i = 0; i < 4; ++i) {
    add(SetUpPart::normalised, base[i], lid[i]);
    if (p_.central) add(SetUpPart::rays, lid[i], apex);
  }
  if (p_.central) name("1/2, 1/2, 1", apex, std::nullopt, true, at({0.5, 0.5, 0}));
  const std::array<std::pair<const char*, Vec3>, 2> axes{{{"r", {1, 0, 0}}, {"s", {0, 1, 0}}}};
  for (const auto& [symbol, axis] : axes) {
    add_arrow(SetUpPart::plane, at(axis), at(1.25 * axis));
    name(symbol, at(1.25 * axis), std::nullopt, false, at({0, 0, 0}));
  }
  add_arrow(SetUpPart::plane, at({0, 0, 0}), at({0, 0, 1.25}));
  name("t", at({0, 0, 1.25}), std::nullopt, false, at({0, 0, 0}));
  // Below its lowest corner.
  const auto height = [&](const Vec3& corner) { return glm::dot(corner, up_); };
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = base[i];
    corners[i + 4] = lid[i];
  }
  const Vec3 lowest = *std::min_element(corners.begin(), corners.end(),
                                        [&](const Vec3& a, const Vec3& b) { return height(a) < height(b); });
  name(p_.central ? "N_per" : "N_par", lowest, std::nullopt, false, lowest + up_);
}

struct Candidate {
  Vec2 image;
  Vec3 point;
};

}  // namespace

SetUp set_up(const SetUpInput& input) { return Builder(input).made(); }

std::vector<Vec3> outline_points(const Projection& projection, const projection::ViewVolume& volume,
                                 std::span<const Vec3> points, std::size_t most) {
  constexpr double slack = 1e-9;  // of the window and of the depths
  const Projectors projectors(projection);
  const Vec2 margin = slack * (volume.window.max - volume.window.min);
  const double deep = slack * (volume.front - volume.back);
  std::vector<Candidate> candidates;
  for (const Vec3& point : points) {
    const double depth = projectors.depth(point);
    if (!(depth <= volume.front + deep && depth >= volume.back - deep) || !projectors.is_before_viewer(point)) continue;
    const Vec2 image = projectors.coordinates(projectors.at_depth(point, 0));
    const Vec2 nearest = glm::clamp(image, volume.window.min - margin, volume.window.max + margin);
    if (image == nearest) candidates.push_back({image, point});
  }
  std::vector<Candidate> hull =
      convex_hull(std::move(candidates), [](const Candidate& one) -> const Vec2& { return one.image; });
  // The corner that cuts off least goes first.
  while (hull.size() > most) {
    const auto area = [&hull](std::size_t i) {
      const std::size_t n = hull.size();
      return std::abs(turn(hull[(i + n - 1) % n].image, hull[i].image, hull[(i + 1) % n].image));
    };
    std::size_t least = 0;
    for (std::size_t i = 1; i < hull.size(); ++i)
      if (area(i) < area(least)) least = i;
    hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(least));
  }
  std::vector<Vec3> chosen;
  for (const Candidate& corner : hull) chosen.push_back(corner.point);
  return chosen;
}

}  // namespace epura::construction
