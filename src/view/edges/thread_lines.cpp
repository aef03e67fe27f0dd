// SPDX-License-Identifier: Apache-2.0
#include "edges/thread_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "edges/limits.hpp"
#include "edges/material_along.hpp"
#include "features/place_threads.hpp"
#include "features/round_faces.hpp"

namespace epura::edges {

namespace {

constexpr int arc_parts = 108;
constexpr int halvings = 20;  // with which the end of an arc is found

/// A threaded cylinder, as far as a cut leaves it. Heights are along its axis.
struct SeenThread {
  const features::RoundFace& round;
  const scene::ThreadedFace& thread;
  int model, triangle;  ///< one of its triangles in the world
  double root;          ///< radius on paper
  double low, high;     ///< ends of the lines of the root: chamfers are included as far as the root reaches into them
  std::optional<double> end{};  ///< of the useful length

  [[nodiscard]] double crest() const { return round.face.surface.radius; }
  [[nodiscard]] Vec3 axis() const { return round.face.surface.axis; }
};

class ThreadLines {
 public:
  ThreadLines(const world::World& world, view::ProjectedScene& view, FeatureEdges& drawn)
      : world_(world), view_(view), drawn_(drawn) {}

  void add(const SeenThread& thread) {
    const Vec3& n = view_.projection.n;
    const bool is_along = glm::length(glm::cross(n, thread.axis())) <= parallel_sine;
    if (!is_along && std::abs(glm::dot(n, thread.axis())) > parallel_sine) return;
    const BodyAxis axis{thread.round.at(0), thread.axis()};
    const MaterialAlong material(world_, thread.model, thread.triangle, axis, std::min(thread.root, thread.crest()));
    if (is_along)
      add_along(thread, material);
    else
      add_across(thread, material);
  }

 private:
  // At the end that is nearer to the viewer.
  void add_along(const SeenThread& thread, const MaterialAlong& material) {
    const bool high = glm::dot(thread.axis(), view_.projection.n) > 0;
    const auto place = [&](double height, double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return thread.round.at(height) +
             thread.root * (portable_cos(angle) * view_.projection.u + portable_sin(angle) * view_.projection.v);
    };
    const auto at = [&](double degrees) { return place(high ? thread.high : thread.low, degrees); };
    const auto angle_of = [](int i) { return arc_begin + arc_sweep * i / arc_parts; };
    const auto is_there_at = [&](double height, double degrees) {
      const auto spans = material.at(place(height, degrees));
      return !spans || holds(*spans, height);
    };
    const auto all_at = [&](double height) {
      std::vector<bool> there;
      for (int i = 0; i <= arc_parts; ++i) there.push_back(is_there_at(height, angle_of(i)));
      return there;
    };
    const double from = thread.round.from, to = thread.round.to;
    check(from < to, "a thread has a length");
    double height = high ? to - at_end * (to - from) : from + at_end * (to - from);
    std::vector<bool> there = all_at(height);
    // An end in an inclined face has little material around it.
    if (std::count(there.begin(), there.end(), true) <= arc_parts / 2) there = all_at(height = (from + to) / 2);
    for (std::size_t i = 0; i < std::size_t{arc_parts}; ++i) {
      double begin = angle_of(static_cast<int>(i)), end = angle_of(static_cast<int>(i) + 1);
      if (!there[i] && !there[i + 1]) continue;
      if (there[i] != there[i + 1]) {
        double in = there[i] ? begin : end, out = there[i] ? end : begin;
        for (int step = 0; step < halvings; ++step) {
          const double middle = (in + out) / 2;
          (is_there_at(height, middle) ? in : out) = middle;
        }
        (there[i] ? end : begin) = in;
      }
      add_line(thread, EdgeKind::thread, {at(begin), at(end)});
    }
  }

  void add_across(const SeenThread& thread, const MaterialAlong& material) {
    const Vec3& n = view_.projection.n;
    const Vec3 aside = glm::normalize(glm::cross(n, thread.axis()));
    const bool internal = thread.thread.internal;
    const double crest = thread.crest(), root = thread.root;
    const double in_front = internal ? 0 : std::sqrt(crest * crest - root * root);
    const auto at = [&](double height, double to_side, double towards) {
      return thread.round.at(height) + to_side * aside + towards * n;
    };
    for (const double side : {-root, root})
      // Behind the plane of the axis, which may be that of a section.
      for (const auto& [low, high] : parts_in(material.at(at(0, side, -at_end * crest)), thread))
        add_line(thread, EdgeKind::thread, {at(low, side, in_front), at(high, side, in_front)});
    if (!thread.end) return;
    const double half = internal ? root : crest, towards = internal ? 0 : crest;
    add_line(thread, EdgeKind::thread_end, {at(*thread.end, -half, towards), at(*thread.end, half, towards)});
  }

  // The parts of the line of a root that are in the material; its ends are where the surface ends.
  static std::vector<std::array<double, 2>> parts_in(const std::optional<std::vector<std::array<double, 2>>>& spans,
                                                     const SeenThread& thread) {
    if (!spans) return {{thread.low, thread.high}};
    const double slack = at_end * (thread.high - thread.low);
    std::vector<std::array<double, 2>> parts;
    for (const auto& [from, to] : *spans) {
      const double low = from < thread.low + slack ? thread.low : from,
                   high = to > thread.high - slack ? thread.high : to;
      if (high - low > slack) parts.push_back({low, high});
    }
    return parts;
  }

  void add_line(const SeenThread& thread, EdgeKind kind, const std::array<Vec3, 2>& ends) {
    const int from = view::add_point(view_, ends[0]), to = view::add_point(view_, ends[1]);
    const auto part = view::clip_edge(view_, from, to);
    if (!part) return;
    const int crossing = static_cast<int>(drawn_.crossings.size());
    drawn_.crossings.push_back({ends, {thread.triangle, thread.triangle}, 0});
    drawn_.edges.push_back({part->vertex, part->t, kind, thread.model, -1, crossing});
  }

  const world::World& world_;
  view::ProjectedScene& view_;
  FeatureEdges& drawn_;
};

int first_triangle_of(const world::World& world, int model, const world::PlacedPart& part, int face) {
  const auto found = std::find(part.face_of_triangle.begin(), part.face_of_triangle.end(), face);
  return world.first_triangle[static_cast<std::size_t>(model)] +
         static_cast<int>(found - part.face_of_triangle.begin());
}

// Whether a cone that continues a threaded cylinder is the chamfer with which the thread begins or ends.
bool is_chamfer_of(const SeenThread& thread, const features::Continuation& cone) {
  const double far = thread.crest() + cone.widening * cone.height;
  return thread.thread.internal ? cone.widening > 0 && far <= widest_countersink * thread.root
                                : cone.widening < 0 && far >= min_chamfer * thread.root;
}

/// The chamfers of threads that are seen along their axes: the cylinder of each cone.
using Chamfers = std::map<int, int>;

void add_chamfers(const world::PlacedPart& part, const SeenThread& thread, Chamfers& chamfers) {
  for (const bool high : {false, true})
    if (const auto cone = features::continuation_of(part, thread.thread.face, high);
        cone && is_chamfer_of(thread, *cone))
      chamfers.emplace(cone->face, thread.thread.face);
}

// Whether an edge is at the end of a chamfer that is away from its cylinder.
bool is_far_end(std::span<const int> triangles, const world::PlacedPart& part, const Chamfers& chamfers) {
  const auto face_of = [&](int triangle) { return part.face_of_triangle[static_cast<std::size_t>(triangle)]; };
  for (const int triangle : triangles) {
    const auto chamfer = chamfers.find(face_of(triangle));
    if (chamfer == chamfers.end()) continue;
    return std::all_of(triangles.begin(), triangles.end(),
                       [&](int other) { return face_of(other) != chamfer->second; }) &&
           std::any_of(triangles.begin(), triangles.end(), [&](int other) { return face_of(other) != chamfer->first; });
  }
  return false;
}

void add_circles(const world::World& world, int model, const world::PlacedPart& part, const Chamfers& chamfers,
                 std::vector<MeshEdgeOfModel>& circles) {
  const mesh::Mesh& mesh = *world.models[static_cast<std::size_t>(model)].mesh;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (const mesh::MeshEdge& edge = mesh.edges[e];
        edge.cut == mesh::CutEdge::none && !edge.wire && is_far_end(mesh.triangles_of(edge), part, chamfers))
      circles.push_back({model, static_cast<int>(e)});
}

// How far the root reaches into a chamfer at one end of the cylinder, if the thread and what a cut leaves reach that
// end.
double reach_into(const world::PlacedPart& part, const SeenThread& thread, bool high) {
  const features::RoundFace& round = thread.round;
  const double end = high ? round.face.to : round.face.from;
  const double slack = 1e-6 * (round.face.to - round.face.from);
  if (std::abs((high ? thread.high : thread.low) - end) > slack) return 0;
  const auto chamfer = features::continuation_of(part, thread.thread.face, high);
  const double outwards = thread.thread.internal ? 1 : -1;  // how the radius changes from crest to root
  if (!chamfer || !(outwards * chamfer->widening > 0)) return 0;
  return std::min(chamfer->height, std::abs(thread.root - thread.crest()) / std::abs(chamfer->widening));
}

std::optional<SeenThread> seen_thread(const world::World& world, int model, const world::PlacedPart& part,
                                      const features::RoundFace& round, const scene::ThreadedFace& threaded,
                                      double depth) {
  if (!round.has_its_axis()) return std::nullopt;
  const double crest = round.face.surface.radius;
  const double true_root = (threaded.internal ? threaded.thread.diameter : threaded.thread.minor()) / 2;
  const double off = std::max(std::abs(true_root - crest), depth);
  if (off > largest_depth * crest) return std::nullopt;
  const double way = threaded.from_high ? -1 : 1;
  const double begin = threaded.from_high ? round.face.to : round.face.from, end = begin + way * threaded.length;
  SeenThread thread{round,
                    threaded,
                    model,
                    first_triangle_of(world, model, part, round.number),
                    crest + (threaded.internal ? off : -off),
                    std::max(std::min(begin, end), round.from),
                    std::min(std::max(begin, end), round.to)};
  if (!(thread.low < thread.high)) return std::nullopt;
  if (threaded.is_partial && end > round.from && end < round.to) thread.end = end;
  thread.low -= reach_into(part, thread, false);
  thread.high += reach_into(part, thread, true);
  check(thread.low < thread.high, "a thread is no shorter for reaching into its chamfers");
  return thread;
}

bool is_along(const projection::Projection& projection, const SeenThread& thread) {
  return glm::length(glm::cross(projection.n, thread.axis())) <= parallel_sine;
}

// Calls `visit(model, part, thread)` for the threads of a world, and `done(model, part)` after those of each model.
template <class Visit, class Done>
void for_each_thread(const world::World& world, double depth, Visit&& visit, Done&& done) {
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
    if (placed.threads.empty()) continue;
    const auto part = world::place_part(placed);
    if (!part) continue;
    const std::vector<features::RoundFace> rounds = features::find_round_faces(world, model, *part);
    for (const scene::ThreadedFace& thread : placed.threads) {
      const auto round = std::find_if(rounds.begin(), rounds.end(),
                                      [&](const features::RoundFace& one) { return one.number == thread.face; });
      if (round == rounds.end()) continue;
      if (const auto seen = seen_thread(world, model, *part, *round, thread, depth)) visit(*part, *seen);
    }
    done(model, *part);
  }
}

}  // namespace

std::vector<MeshEdgeOfModel> chamfer_circles(const world::World& world, const projection::Projection& projection,
                                             double depth) {
  std::vector<MeshEdgeOfModel> circles;
  if (!is_orthographic(projection)) return circles;
  Chamfers chamfers;
  for_each_thread(
      world, depth,
      [&](const world::PlacedPart& part, const SeenThread& thread) {
        if (is_along(projection, thread)) add_chamfers(part, thread, chamfers);
      },
      [&](int model, const world::PlacedPart& part) {
        if (!chamfers.empty()) add_circles(world, model, part, chamfers, circles);
        chamfers.clear();
      });
  return circles;
}

void add_thread_lines(const world::World& world, view::ProjectedScene& view, double depth, FeatureEdges& drawn) {
  if (!is_orthographic(view.projection)) return;
  if (const auto circles = chamfer_circles(world, view.projection, depth); !circles.empty())
    std::erase_if(drawn.edges, [&](const FeatureEdge& edge) {
      return std::binary_search(circles.begin(), circles.end(), MeshEdgeOfModel{edge.model, edge.mesh_edge});
    });
  ThreadLines lines(world, view, drawn);
  for_each_thread(
      world, depth, [&](const world::PlacedPart&, const SeenThread& thread) { lines.add(thread); },
      [](int, const world::PlacedPart&) {});
}

}  // namespace epura::edges
