// SPDX-License-Identifier: Apache-2.0
#include "world/explosion_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "world/placed_part.hpp"

namespace epura::world {

namespace {

constexpr double parallel_axes = 1e-4;           // sine
constexpr double off_axis = 0.1;                 // between the axes of a pin and its hole, in radii of the pin
constexpr double loosest = 0.5, tightest = 1.3;  // radius of a shaft, in radii of its hole
constexpr double of_head = 1.15;                 // radius of a head, at least, in radii of its shank
constexpr double near_end = 0.25;                // of the length of a pin: where its head is

using Number = std::array<int, 2>;  // of a model, and of a body in it

/// A cylinder of a body, outside or of a hole.
struct Cylinder {
  Number body;
  surfaces::PartFace face;

  [[nodiscard]] Vec3 at(double height) const { return face.surface.origin + height * face.surface.axis; }
};

struct Interval {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double middle() const { return (low + high) / 2; }
};

/// A body in holes of others; heights are along `axis` from `at`.
struct Pin {
  Number body;
  Vec3 at, axis;
  double radius;
  std::map<Number, Interval> holes;  ///< by the bodies that have them
};

/// A body along the axis of a pin.
struct Along {
  Interval reach;
  double radius_low = 0, radius_high = 0;  ///< largest ones near the ends
};

std::vector<Cylinder> cylinders_of(const World& world) {
  std::vector<Cylinder> cylinders;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const std::optional<PlacedPart> part = place_part(world.models[m]);
    if (!part) continue;
    for (const surfaces::PartFace& face : part->faces)
      if (face.surface.kind == surfaces::SurfaceKind::cylinder)
        cylinders.push_back({{static_cast<int>(m), face.body}, face});
  }
  return cylinders;
}

// The part of a hole that a pin is in, as heights along the pin.
std::optional<Interval> hole_around(const Cylinder& pin, const Cylinder& hole) {
  const surfaces::PartSurface &inner = pin.face.surface, &outer = hole.face.surface;
  if (!may_be_in(inner.radius, outer.radius)) return std::nullopt;
  if (glm::length(glm::cross(inner.axis, outer.axis)) > parallel_axes) return std::nullopt;
  if (glm::length(glm::cross(outer.origin - inner.origin, inner.axis)) > off_axis * inner.radius) return std::nullopt;
  Interval along;
  for (const double end : {hole.face.from, hole.face.to}) along.add(glm::dot(hole.at(end) - inner.origin, inner.axis));
  if (std::min(along.high, pin.face.to) - std::max(along.low, pin.face.from) <= parallel_axes * inner.radius)
    return std::nullopt;
  return along;
}

// Of a body with several cylinders in holes, the one in most of them, then the thickest, is what it is held by.
std::map<Number, Pin> pins_of(const std::vector<Cylinder>& cylinders) {
  std::map<Number, Pin> pins;
  for (const Cylinder& one : cylinders) {
    if (one.face.inwards) continue;
    const surfaces::PartSurface& surface = one.face.surface;
    Pin pin{one.body, surface.origin, surface.axis, surface.radius, {}};
    for (const Cylinder& other : cylinders) {
      if (!other.face.inwards || other.body == one.body) continue;
      if (const auto around = hole_around(one, other)) {
        pin.holes[other.body].add(around->low);
        pin.holes[other.body].add(around->high);
      }
    }
    if (pin.holes.empty()) continue;
    const auto [known, is_new] = pins.try_emplace(one.body, pin);
    const auto rank = [](const Pin& p) { return std::pair(p.holes.size(), p.radius); };
    if (!is_new && rank(pin) > rank(known->second)) known->second = std::move(pin);
  }
  return pins;
}

class Order {
 public:
  Order(const World& world, Bodies& bodies, const std::map<Number, Pin>& pins)
      : world_(world), bodies_(bodies), pins_(pins) {}

  // The bodies of a pin that hang on it alone move with it; the others are where the pin belongs.
  void move(const Pin& pin) {
    std::vector<Number> hanging;
    std::optional<Number> place;
    Interval holes;  // of bodies that do not hang on the pin, in the assembly
    Interval apart;  // the same, moved
    for (const auto& [number, hole] : pin.holes) {
      if (hangs_on(number, pin)) {
        hanging.push_back(number);
        continue;
      }
      if (!place || size_of(number) > size_of(*place)) place = number;
      for (const double end : {hole.low, hole.high}) {
        holes.add(end);
        apart.add(end + glm::dot(body(number).move, pin.axis));
      }
    }
    if (!place || !(body(pin.body).factor > 0)) return;
    std::array<std::vector<Number>, 2> sides;  // of what hangs on it, from the holes outwards
    for (const Number& number : hanging)
      sides[reach_of(number, pin).reach.middle() > holes.middle() ? 1 : 0].push_back(number);
    for (const std::size_t side : {0U, 1U})
      std::sort(sides[side].begin(), sides[side].end(), [&](const Number& a, const Number& b) {
        const double way = side == 1 ? 1 : -1;
        return way * reach_of(a, pin).reach.middle() < way * reach_of(b, pin).reach.middle();
      });
    const Vec3 with = body(*place).move;
    const int leaves = side_of(pin, sides, holes);
    const Along own = reach_of(pin.body, pin);
    if (leaves == 0) {
      const double along = glm::dot(with, pin.axis);
      set(pin.body, pin, with, along, with);
      apart.add(own.reach.low + along);
      apart.add(own.reach.high + along);
    }
    for (const int way : {-1, 1}) {
      std::vector<Number> row = sides[way > 0 ? 1 : 0];
      if (leaves == way) row.push_back(pin.body);
      stack(row, way > 0 ? apart.high : apart.low, way, pin, with);
    }
  }

 private:
  [[nodiscard]] MovedBody& body(const Number& number) {
    return bodies_[static_cast<std::size_t>(number[0])][static_cast<std::size_t>(number[1])];
  }
  [[nodiscard]] double size_of(const Number& number) {
    const Vec3 size = body(number).box.size();
    return size.x * size.y * size.z;
  }
  // Smaller than the pin, and on no other one.
  [[nodiscard]] bool hangs_on(const Number& number, const Pin& pin) {
    return body(number).factor > 0 && size_of(number) < size_of(pin.body) && !pins_.contains(number) &&
           std::none_of(pins_.begin(), pins_.end(), [&](const auto& other) {
             return other.first != pin.body && other.second.holes.contains(number);
           });
  }

  const Along& reach_of(const Number& number, const Pin& pin) {
    const auto [known, is_new] = reach_.try_emplace({number, pin.body});
    Along& along = known->second;
    if (!is_new) return along;
    std::vector<std::array<double, 2>> places;  // height and distance from the axis
    visit_points(number, [&](const Vec3& point) {
      const Vec3 off = point - pin.at;
      const double height = glm::dot(off, pin.axis);
      along.reach.add(height);
      places.push_back({height, glm::length(off - height * pin.axis)});
    });
    const double end = near_end * (along.reach.high - along.reach.low);
    for (const auto& [height, radius] : places) {
      if (height < along.reach.low + end) along.radius_low = std::max(along.radius_low, radius);
      if (height > along.reach.high - end) along.radius_high = std::max(along.radius_high, radius);
    }
    return along;
  }

  template <class Visit>
  void visit_points(const Number& number, const Visit& visit) const {
    const auto model = static_cast<std::size_t>(number[0]);
    const std::vector<int>& body = world_.models[model].mesh->body;
    for (std::size_t t = 0; t < body.size(); ++t)
      if (body[t] == number[1])
        for (const int v : world_.triangles[static_cast<std::size_t>(world_.first_triangle[model]) + t])
          visit(world_.points[static_cast<std::size_t>(v)]);
  }

  // On which side of its holes a pin leaves; 0: on none.
  int side_of(const Pin& pin, const std::array<std::vector<Number>, 2>& sides, const Interval& holes) {
    const Along& own = reach_of(pin.body, pin);
    const double head = of_head * pin.radius;
    if (own.radius_high > head && own.radius_low <= head) return 1;
    if (own.radius_low > head && own.radius_high <= head) return -1;
    if (!sides[0].empty() && !sides[1].empty()) return 0;
    if (!sides[0].empty()) return 1;
    if (!sides[1].empty()) return -1;
    const double along = glm::dot(body(pin.body).move, pin.axis), off = own.reach.middle() - holes.middle();
    return (along != 0 ? along : off) < 0 ? -1 : 1;
  }

  // Bodies one after the other along the axis, the first one beyond `end`, not nearer than they would be otherwise.
  void stack(const std::vector<Number>& row, double end, int way, const Pin& pin, const Vec3& with) {
    Vec3 held = with;
    for (const Number& number : row) {
      const Interval& reach = reach_of(number, pin).reach;
      const double gap = 2 * pin.radius * body(number).factor;
      const double needed = way * end + gap - (way > 0 ? reach.low : -reach.high);
      const double along = way * std::max(needed, way * glm::dot(body(number).move, pin.axis));
      set(number, pin, with, along, held);
      end = (way > 0 ? reach.high : reach.low) + along;
      held = body(number).move;
    }
  }

  // Sideways with the holes.
  void set(const Number& number, const Pin& pin, const Vec3& with, double along, const Vec3& held) {
    check(std::isfinite(along), "a body moves along the axis of its pin");
    body(number).move = with + (along - glm::dot(with, pin.axis)) * pin.axis;
    body(number).start = held;
  }

  const World& world_;
  Bodies& bodies_;
  const std::map<Number, Pin>& pins_;
  std::map<std::array<Number, 2>, Along> reach_;
};

}  // namespace

bool may_be_in(double shaft, double hole) {
  const double play = shaft / hole;
  return play >= loosest && play <= tightest;
}

void order_by_holes(const World& world, Bodies& bodies) {
  const auto is_outward = [](const MovedBody& body) { return body.factor > 0; };
  if (std::none_of(bodies.begin(), bodies.end(), [&](const std::vector<MovedBody>& of_model) {
        return std::any_of(of_model.begin(), of_model.end(), is_outward);
      }))
    return;
  const std::map<Number, Pin> pins = pins_of(cylinders_of(world));
  Order order(world, bodies, pins);
  // What pins are in comes before them.
  std::vector<const Pin*> sorted;
  for (const auto& [number, pin] : pins) sorted.push_back(&pin);
  const auto depth = [&](const Pin* pin) {
    return std::count_if(pin->holes.begin(), pin->holes.end(),
                         [&](const auto& hole) { return pins.contains(hole.first); });
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Pin* a, const Pin* b) { return depth(a) < depth(b); });
  for (const Pin* pin : sorted) order.move(*pin);
}

}  // namespace epura::world
