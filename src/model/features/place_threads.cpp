// SPDX-License-Identifier: Apache-2.0
#include "features/place_threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/error.hpp"
#include "base/text.hpp"
#include "features/hole_features.hpp"
#include "features/tolerances.hpp"
#include "scene/standard_threads.hpp"
#include "surfaces/limits.hpp"

namespace epura::features {

namespace {

using surfaces::PartFace;
using surfaces::SurfaceKind;

/// A cylinder of a part.
struct Cylinder {
  int model = -1, face = -1;
  const PartFace* part_face = nullptr;
  double low = 0, high = 0;  ///< heights of its ends, with a chamfer or countersink

  [[nodiscard]] const surfaces::PartSurface& surface() const { return part_face->surface; }
  [[nodiscard]] double height_of(const Vec3& point) const { return glm::dot(point - surface().origin, surface().axis); }
  /// Distance of a point from the cylinder or from its axis, whichever is nearer; chamfers belong to both.
  [[nodiscard]] double distance_to(const Vec3& point) const {
    const double height = height_of(point);
    const double past = std::max({low - height, height - high, 0.0});
    const double from_axis = glm::length(point - surface().origin - height * surface().axis);
    return std::hypot(past, std::min(from_axis, std::abs(from_axis - surface().radius)));
  }
  /// Whether its axis leads through a point.
  [[nodiscard]] bool is_around(const Vec3& point) const {
    return distance_from_line(point, surface().origin, surface().axis) <= near_cylinder * surface().radius;
  }
  [[nodiscard]] std::string name() const {
    const Vec3 middle = surface().origin + (part_face->from + part_face->to) / 2 * surface().axis;
    return std::string(part_face->inwards ? "the hole ⌀" : "the shaft ⌀") + format_rounded(2 * surface().radius, 4) +
           " around [" + format_rounded(middle.x, 4) + ", " + format_rounded(middle.y, 4) + ", " +
           format_rounded(middle.z, 4) + "]";
  }
};

class ThreadPlacer {
 public:
  explicit ThreadPlacer(const world::World& world)
      : world_(world), parts_(world.models.size()), threads_(world.models.size()) {
    for (int model = 0; model < static_cast<int>(parts_.size()); ++model) {
      const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
      if (placed.part == nullptr) continue;
      std::optional<world::PlacedPart>& part = parts_[static_cast<std::size_t>(model)];
      part = world::place_part(placed);
      for (int f = 0; part && f < static_cast<int>(part->faces.size()); ++f)
        if (const PartFace& face = part->faces[static_cast<std::size_t>(f)];
            face.surface.kind == SurfaceKind::cylinder && face.sweep >= surfaces::whole_turn)
          cylinders_.push_back({model, f, &face, end_of(*part, f, false), end_of(*part, f, true)});
    }
  }

  [[nodiscard]] std::optional<double> depth_between(double radius, const Vec3& begin, const Vec3& end) const {
    for (const Cylinder& one : cylinders_) {
      const double height = one.height_of(end);
      if (!are_same(one.surface().radius, radius) || !one.is_around(end) || height < one.low || height > one.high)
        continue;
      return one.height_of(begin) > height ? one.high - height : height - one.low;
    }
    return std::nullopt;
  }

  /// Those of a model that were placed.
  [[nodiscard]] const std::vector<scene::ThreadedFace>& threads_of(std::size_t model) const { return threads_[model]; }

  void place(const scene::ThreadDescription& description, int number, const Vec3& position) {
    const scene::Thread thread = scene::parse_thread(*description.thread, description.thread.where);
    const Cylinder cylinder = cylinder_at(description, thread, position);
    expect_size(description, thread, cylinder);
    const bool from_high = begins_high(cylinder, position);
    const Vec3 out = (from_high ? 1.0 : -1.0) * cylinder.surface().axis;
    add(description, number, thread, cylinder, from_high);
    if (!description.equal.value_or(false)) return;
    for (const Cylinder& other : cylinders_)
      if (other.part_face != cylinder.part_face && are_equal(other, cylinder))
        add(description, number, thread, other, begins_at(other, out));
  }

 private:
  // Height of an end, with the cone that continues the cylinder there.
  static double end_of(const world::PlacedPart& part, int face, bool high) {
    const auto cone = continuation_of(part, face, high);
    const PartFace& cylinder = part.faces[static_cast<std::size_t>(face)];
    return high ? cylinder.to + (cone ? cone->height : 0) : cylinder.from - (cone ? cone->height : 0);
  }

  [[nodiscard]] const world::PlacedPart& part_of(const Cylinder& cylinder) const {
    return *parts_[static_cast<std::size_t>(cylinder.model)];
  }

  // The cylinder at a position that suits the thread best.
  [[nodiscard]] Cylinder cylinder_at(const scene::ThreadDescription& description, const scene::Thread& thread,
                                     const Vec3& position) const {
    const Cylinder *best = nullptr, *nearest = nullptr;
    for (const Cylinder& one : cylinders_) {
      const double distance = one.distance_to(position);
      if (nearest == nullptr || distance < nearest->distance_to(position)) nearest = &one;
      if (distance > near_cylinder * one.surface().radius) continue;
      const auto off = [&](const Cylinder& c) {
        return std::abs(2 * c.surface().radius - (c.part_face->inwards ? thread.minor() : thread.diameter));
      };
      if (best == nullptr || off(one) < off(*best)) best = &one;
    }
    if (best != nullptr) return *best;
    throw Error(
        ErrorKind::input, description.at.where,
        "the thread " + thread.text + " is at no round face: there is neither a hole nor a shaft at " +
            format_rounded(position.x, 4) + ", " + format_rounded(position.y, 4) + ", " + format_rounded(position.z, 4),
        nearest == nullptr ? "no full cylinder is recognised in the models" : "the nearest is " + nearest->name());
  }

  static void expect_size(const scene::ThreadDescription& description, const scene::Thread& thread,
                          const Cylinder& cylinder) {
    const bool internal = cylinder.part_face->inwards;
    if (scene::suits(thread, 2 * cylinder.surface().radius, internal)) return;
    throw Error(ErrorKind::input, description.thread.where, thread.text + " does not suit " + cylinder.name(),
                std::string(internal ? "its core hole, the minor diameter of ISO 724, has ⌀"
                                     : "its shaft, the major diameter, has ⌀") +
                    format_rounded(internal ? thread.minor() : thread.diameter, 4));
  }

  // A blind hole begins at its mouth, all else at the end that is nearer to the position.
  [[nodiscard]] bool begins_high(const Cylinder& cylinder, const Vec3& position) const {
    if (cylinder.part_face->inwards)
      for (const HoleFeature& hole : describe_holes(world_, cylinder.model, part_of(cylinder)).holes)
        if (!hole.through && are_same(hole.diameter, 2 * cylinder.surface().radius) && cylinder.is_around(hole.mouth))
          return glm::dot(hole.axis, cylinder.surface().axis) > 0;
    const double height = cylinder.height_of(position);
    return height > (cylinder.part_face->from + cylinder.part_face->to) / 2;
  }

  static bool begins_at(const Cylinder& cylinder, const Vec3& out) {
    return glm::dot(cylinder.surface().axis, out) > 0;
  }

  static bool are_equal(const Cylinder& a, const Cylinder& b) {
    return a.model == b.model && a.part_face->inwards == b.part_face->inwards &&
           are_same(a.surface().radius, b.surface().radius) && are_parallel(a.surface().axis, b.surface().axis) &&
           are_same(a.part_face->to - a.part_face->from, b.part_face->to - b.part_face->from);
  }

  void add(const scene::ThreadDescription& description, int number, const scene::Thread& thread,
           const Cylinder& cylinder, bool from_high) {
    std::vector<scene::ThreadedFace>& threads = threads_[static_cast<std::size_t>(cylinder.model)];
    for (const scene::ThreadedFace& other : threads)
      if (other.face == cylinder.face)
        throw Error(ErrorKind::input, description.where,
                    cylinder.name() + " has the thread " + other.thread.text + " already", "remove one of them");
    const double whole = cylinder.part_face->to - cylinder.part_face->from;
    // A length is measured from the end of the part, a chamfer included.
    const auto chamfer = continuation_of(part_of(cylinder), cylinder.face, from_high);
    const double before = chamfer ? chamfer->height : 0;
    const double wanted = description.depth.value_or(whole + before) - before;
    if (!(wanted > 0) || wanted > whole * (1 + same_size))
      throw Error(ErrorKind::input, description.depth.where,
                  "the thread is " + format_number(*description.depth) + " long, and " + cylinder.name() + " is " +
                      format_rounded(whole + before, 5) + " long",
                  "give a smaller depth, or none for all of it");
    const bool is_partial = wanted < whole * (1 - same_size);
    threads.push_back({cylinder.face, cylinder.part_face->inwards, from_high, is_partial ? wanted : whole, is_partial,
                       number, thread});
  }

  const world::World& world_;
  std::vector<std::optional<world::PlacedPart>> parts_;    // by model
  std::vector<std::vector<scene::ThreadedFace>> threads_;  // by model
  std::vector<Cylinder> cylinders_;
};

}  // namespace

std::optional<Continuation> continuation_of(const world::PlacedPart& part, int cylinder, bool at_high_end) {
  const PartFace& face = part.faces[static_cast<std::size_t>(cylinder)];
  const surfaces::PartSurface& surface = face.surface;
  const Vec3 end = surface.origin + (at_high_end ? face.to : face.from) * surface.axis;
  const Vec3 out = (at_high_end ? 1.0 : -1.0) * surface.axis;
  const double slack = slack_of(part.tolerance, surface.radius);
  for (int f = 0; f < static_cast<int>(part.faces.size()); ++f) {
    const PartFace& cone = part.faces[static_cast<std::size_t>(f)];
    if (cone.surface.kind != SurfaceKind::cone || cone.inwards != face.inwards || cone.sweep < surfaces::whole_turn)
      continue;
    if (!are_parallel(cone.surface.axis, surface.axis)) continue;
    if (distance_from_line(cone.surface.origin, end, surface.axis) > slack) continue;
    const double way = glm::dot(cone.surface.axis, out) > 0 ? 1 : -1;
    const double near = way > 0 ? cone.from : cone.to, height = cone.to - cone.from;
    const double begin = glm::dot(cone.surface.origin + near * cone.surface.axis - end, out);
    const double radius = cone.surface.radius + cone.surface.slope * near;
    if (std::abs(begin) > slack || std::abs(radius - surface.radius) > slack) continue;
    return Continuation{f, height, way * cone.surface.slope};
  }
  return std::nullopt;
}

void place_threads(world::World& world, std::span<const scene::ThreadDescription> threads,
                   std::span<const Vec3> positions) {
  for (world::Placed& placed : world.models) placed.threads.clear();
  if (threads.empty()) return;
  ThreadPlacer placer(world);
  for (std::size_t i = 0; i < threads.size(); ++i) placer.place(threads[i], static_cast<int>(i), positions[i]);
  for (std::size_t model = 0; model < world.models.size(); ++model)
    world.models[model].threads = placer.threads_of(model);
}

std::optional<double> depth_of_thread(const world::World& world, double radius, const Vec3& begin, const Vec3& end) {
  return ThreadPlacer(world).depth_between(radius, begin, end);
}

}  // namespace epura::features
