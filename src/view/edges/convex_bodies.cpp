// SPDX-License-Identifier: Apache-2.0
#include "edges/convex_bodies.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "edges/limits.hpp"

namespace epura::edges {

namespace {

// One edge in this many is tested before all others, which rejects most bodies that are not convex.
constexpr std::size_t sample_step = 64;

void raise(double& value, double other) {
  std::atomic_ref<double> shared(value);
  double old = shared.load(std::memory_order_relaxed);
  while (other > old && !shared.compare_exchange_weak(old, other, std::memory_order_relaxed)) {
  }
}

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::dot(glm::cross(a, b), c); }

// Zero if the vectors lie in one coordinate plane.
double rounding_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto both = [&](int i, int j) { return std::abs(a[i] * b[j]) + std::abs(a[j] * b[i]); };
  const double products = both(1, 2) * std::abs(c.x) + both(2, 0) * std::abs(c.y) + both(0, 1) * std::abs(c.z);
  return determinant_rounding * products;
}

// What is known about a body.
struct Finding {
  Vec3 sum{0};              // sum of the corners of its triangles
  int corners = 0;          // number of these corners
  int first = -1;           // its first triangle
  double reach = 0;         // greatest distance of a corner from the middle, or more
  double slimness = 0;      // greatest longest side / height of a triangle
  double flatness = 0;      // greatest reach / distance of a triangle's plane from the middle
  std::uint64_t folds = 0;  // sum of the angles of inward folds, in multiples of fold_unit
  int on_ray = 0;           // number of triangles that the ray through the first one may meet
  char refuted = 0;

  [[nodiscard]] Vec3 middle() const { return sum / static_cast<double>(corners); }
};

class ConvexityTest {
 public:
  ConvexityTest(const world::World& world, std::span<const Vec3> points, const BodyTable& bodies, double contact)
      : world_(world), points_(points), bodies_(bodies), contact_(contact), found_(bodies.box.size()) {
    for (std::size_t b = 0; b < found_.size(); ++b) found_[b].reach = glm::length(bodies.box[b].size());
  }

  void run(std::vector<char>& candidates) {
    if (std::count(candidates.begin(), candidates.end(), 1) == 0) return;
    for (std::size_t b = 0; b < found_.size(); ++b) found_[b].refuted = candidates[b] == 0 ? 1 : 0;
    test_edges([](std::size_t e) { return e % sample_step == 0; });
    for (Finding& body : found_)
      if (rise(body, 1) * sample_step / 4 > contact_) body.refuted = 1;
    if (std::all_of(found_.begin(), found_.end(), [](Finding& body) { return is_refuted(body); }))
      return candidates.assign(candidates.size(), 0);
    test_edges([](std::size_t e) { return e % sample_step != 0; });
    find_middles();
    test_triangles();
    for (std::size_t b = 0; b < found_.size(); ++b) candidates[b] = is_within(found_[b]) ? 1 : 0;
  }

 private:
  [[nodiscard]] std::array<Vec3, 3> corners(int triangle, const Vec3& origin) const {
    const auto& [a, b, c] = world_.triangles[triangle];
    return {points_[a] - origin, points_[b] - origin, points_[c] - origin};
  }

  [[nodiscard]] Finding& of(int triangle) { return found_[bodies_.of_triangle[triangle]]; }

  static bool is_refuted(Finding& body) {
    return std::atomic_ref<char>(body.refuted).load(std::memory_order_relaxed) != 0;
  }
  static void refute(Finding& body) { std::atomic_ref<char>(body.refuted).store(1, std::memory_order_relaxed); }

  void find_middles() {
    for (int t = 0; t < static_cast<int>(world_.triangles.size()); ++t) {
      Finding& body = of(t);
      if (is_refuted(body)) continue;
      if (body.first < 0) body.first = t;
      for (const int v : world_.triangles[t]) body.sum += points_[v];
      body.corners += 3;
    }
    for (std::size_t b = 0; b < found_.size(); ++b) {
      if (found_[b].corners == 0) continue;
      const Box& box = bodies_.box[b];
      const Vec3 middle = found_[b].middle();
      found_[b].reach = glm::length(glm::max(box.max - middle, middle - box.min)) * (1 + 0x1p-40);
    }
  }

  template <class Choose>
  void test_edges(Choose choose) {
    for (int model = 0; model < static_cast<int>(world_.models.size()); ++model) {
      const auto& edges = world_.models[model].mesh->edges;
      parallel_for(edges.size(), grain::light, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
          if (choose(e)) test_edge(model, edges[e]);
      });
    }
  }

  // Also tests that the body is closed: every edge has two triangles that traverse it in opposite directions.
  void test_edge(int model, const mesh::MeshEdge& edge) {
    const auto all = world_.models[model].mesh->triangles_of(edge);
    if (all.empty()) return;
    const int first = world_.first_triangle[model];
    Finding& body = of(first + all[0]);
    if (all.size() == 2 && is_refuted(body)) return;
    const int u = world_.first_vertex[model] + edge.vertex[0];
    const int v = world_.first_vertex[model] + edge.vertex[1];
    std::optional<int> forth, back;
    if (all.size() == 2 && &body == &of(first + all[1]))
      for (const int t : all) {
        if (const auto apex = apex_of(first + t, u, v)) forth = apex;
        if (const auto apex = apex_of(first + t, v, u)) back = apex;
      }
    if (!forth || !back) {
      for (const int t : all) refute(of(first + t));
      return;
    }
    test_fold(body, points_[v] - points_[u], points_[*forth] - points_[u], points_[*back] - points_[u]);
  }

  // The third corner of a triangle that traverses its side from u to v.
  [[nodiscard]] std::optional<int> apex_of(int triangle, int u, int v) const {
    const auto& c = world_.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] == u && c[(i + 1) % 3] == v) return c[(i + 2) % 3];
    return std::nullopt;
  }

  // `along` is an edge, `left` and `right` are the corners on its two sides as seen from outside, all relative to one
  // end of the edge.
  static void test_fold(Finding& body, const Vec3& along, const Vec3& left, const Vec3& right) {
    const double over = determinant(along, left, right) + rounding_of(along, left, right);
    if (over <= 0) return;
    const double areas = glm::length(glm::cross(along, left)) * glm::length(glm::cross(along, right));
    const double fold = over * glm::length(along) / areas;  // slightly more than its sine
    if (!(fold <= parallel_sine)) return refute(body);
    std::atomic_ref<std::uint64_t>(body.folds)
        .fetch_add(static_cast<std::uint64_t>(fold / fold_unit) + 1, std::memory_order_relaxed);
  }

  void test_triangles() {
    parallel_for(world_.triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        if (!is_refuted(of(static_cast<int>(t)))) test_triangle(static_cast<int>(t));
    });
  }

  void test_triangle(int triangle) {
    Finding& body = of(triangle);
    const auto [a, b, c] = corners(triangle, body.middle());
    const Vec3 ab = b - a, ac = c - a;
    const double area = glm::length(glm::cross(ab, ac));
    const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
    const double volume = determinant(a, b, c);
    if (!(volume > 16 * rounding_of(a, b, c)) || !(area > 0)) return refute(body);
    check(body.reach > 0, "a triangle with a volume is not in the middle of its body");
    raise(body.slimness, longest * longest / area);
    raise(body.flatness, body.reach * area / (0.9 * volume));
    const auto first = corners(body.first, body.middle());
    const Vec3 ray = first[0] + first[1] + first[2];
    const auto may_lie_left = [&](const Vec3& p, const Vec3& q) {
      return determinant(ray, p, q) >= -rounding_of(ray, p, q);
    };
    if (may_lie_left(a, b) && may_lie_left(b, c) && may_lie_left(c, a))
      std::atomic_ref<int>(body.on_ray).fetch_add(1, std::memory_order_relaxed);
  }

  // Greatest distance by which a corner may lie in front of the plane of a triangle, given the inward folds.
  static double rise(const Finding& body, double flatness) {
    const double turns = std::numbers::pi / 2 * flatness * static_cast<double>(body.folds) * fold_unit;
    return 1.1 * std::numbers::pi * body.reach * flatness * turns;
  }

  [[nodiscard]] bool is_within(const Finding& body) const {
    if (body.refuted != 0 || body.on_ray != 1) return false;
    const double rounding = 2 * body.reach * normal_rounding * body.slimness + normal_rounding;
    return rise(body, body.flatness) + rounding <= contact_;
  }

  const world::World& world_;
  std::span<const Vec3> points_;
  const BodyTable& bodies_;
  double contact_;
  std::vector<Finding> found_;
};

}  // namespace

BodyTable bodies_of(const world::World& world, std::span<const Vec3> points) {
  BodyTable bodies;
  bodies.of_triangle.reserve(world.triangles.size());
  for (const world::Placed& model : world.models) {
    const int first = static_cast<int>(bodies.box.size());
    for (const int body : model.mesh->body) {
      const int number = first + body;
      if (number >= static_cast<int>(bodies.box.size())) bodies.box.resize(static_cast<std::size_t>(number) + 1);
      for (const int v : world.triangles[bodies.of_triangle.size()]) bodies.box[number].add(points[v]);
      bodies.of_triangle.push_back(number);
    }
  }
  check(bodies.of_triangle.size() == world.triangles.size(), "every triangle is of a body");
  return bodies;
}

void keep_convex(const world::World& world, std::span<const Vec3> points, const BodyTable& bodies, double contact,
                 std::vector<char>& candidates) {
  check(candidates.size() == bodies.box.size(), "every body is marked or not");
  ConvexityTest(world, points, bodies, contact).run(candidates);
}

}  // namespace epura::edges
