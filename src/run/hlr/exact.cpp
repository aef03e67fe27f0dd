// SPDX-License-Identifier: Apache-2.0
#include "hlr/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "hlr/limits.hpp"
#include "mesh/triangulate.hpp"

namespace epura::hlr {

namespace {

using Side = std::array<int, 2>;  // vertices, lower first

/// What evaluates a point: a face, or an edge.
struct Owner {
  bool is_edge;
  int number;

  auto operator<=>(const Owner&) const = default;
};

struct Question {
  Owner owner;
  Side side;  ///< whose middle is asked about; of a facet: equal
  int facet;  ///< whose centre is asked about; -1: none
  Vec3 point;
  double reach;  ///< the nearest point is no farther off
};

class ShapeFollower {
 public:
  ShapeFollower(importer::Shape& shape, std::uint32_t number, const epura_hlr_exact& exact)
      : shape_(shape), number_(number), exact_(exact), most_points_(most_points_for_one * shape.points.size()) {}

  void follow() {
    cut_polygons();
    for (std::vector<Question> asked = questions(); !asked.empty(); asked = questions()) {
      middle_.clear();
      centre_.clear();
      for (auto first = asked.begin(); first != asked.end();) {
        const auto last = std::find_if(first, asked.end(), [&](const Question& q) { return q.owner != first->owner; });
        answer({first, last});
        first = last;
      }
      divide_edges();
      divide_facets();
    }
  }

 private:
  [[nodiscard]] bool is_exact(int face) const {
    return face >= 0 && shape_.faces[static_cast<std::size_t>(face)].kind != surfaces::SurfaceKind::plane;
  }
  [[nodiscard]] Vec3 at(int point) const {
    const auto& [x, y, z] = shape_.points[static_cast<std::size_t>(point)];
    return {x, y, z};
  }
  [[nodiscard]] std::span<const int> ring(std::size_t polygon) const {
    const int begin = polygon == 0 ? 0 : shape_.polygon_ends[polygon - 1];
    return {shape_.corners.data() + begin, static_cast<std::size_t>(shape_.polygon_ends[polygon] - begin)};
  }
  static Side side_of(std::span<const int> ring, std::size_t i) {
    const auto [low, high] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
    return {low, high};
  }

  /// The polygons of the shape made anew, each as rings of the same face and body.
  template <class Rings>
  void replace_polygons(const Rings& rings_of) {
    importer::Shape made;
    for (std::size_t p = 0; p < shape_.polygon_ends.size(); ++p)
      rings_of(p, [&](std::span<const int> corners) {
        made.corners.insert(made.corners.end(), corners.begin(), corners.end());
        made.polygon_ends.push_back(static_cast<int>(made.corners.size()));
        made.face_of_polygon.push_back(shape_.face_of_polygon[p]);
        made.body_of_polygon.push_back(shape_.body_of_polygon[p]);
      });
    std::swap(shape_.corners, made.corners);
    std::swap(shape_.polygon_ends, made.polygon_ends);
    std::swap(shape_.face_of_polygon, made.face_of_polygon);
    std::swap(shape_.body_of_polygon, made.body_of_polygon);
  }

  // Facets of exact faces become triangles.
  void cut_polygons() {
    replace_polygons([&](std::size_t p, const auto& take) {
      const auto corners = ring(p);
      if (corners.size() <= 3 || !is_exact(shape_.face_of_polygon[p])) return take(corners);
      const mesh::Triangulation cut =
          mesh::triangulate({{corners.begin(), corners.end()}, {static_cast<int>(corners.size())}, {0}}, shape_.points);
      for (std::size_t t = 0; t < cut.triangles.size(); ++t) take(cut.triangles.ring(t));
    });
  }

  // Of sides that belong to an exact face: the edge, or else the first such face.
  [[nodiscard]] std::map<Side, Owner> owners_of_sides() const {
    std::map<Side, Owner> owners;
    for (std::size_t p = 0; p < shape_.polygon_ends.size(); ++p)
      if (const int face = shape_.face_of_polygon[p]; is_exact(face))
        for (std::size_t i = 0; i < ring(p).size(); ++i) owners.try_emplace(side_of(ring(p), i), Owner{false, face});
    int begin = 0;
    for (std::size_t e = 0; e < shape_.edges.size(); ++e) {
      for (int i = begin; i + 1 < shape_.edges[e].end; ++i) {
        const auto side = owners.find(side_of(std::span(shape_.edge_vertices).subspan(i, 2), 0));
        if (side != owners.end()) side->second = {true, static_cast<int>(e)};
      }
      begin = shape_.edges[e].end;
    }
    return owners;
  }

  // What is not known yet: middles of sides, and centres of facets whose sides are near enough.
  [[nodiscard]] std::vector<Question> questions() const {
    std::vector<Question> asked;
    const auto is_near = [&](const Side& side) { return settled_.count(side) != 0; };
    for (const auto& [side, owner] : owners_of_sides()) {
      if (is_near(side)) continue;
      const Vec3 a = at(side[0]), b = at(side[1]);
      asked.push_back({owner, side, -1, (a + b) / 2.0, glm::distance(a, b)});
    }
    for (std::size_t p = 0; p < shape_.polygon_ends.size(); ++p) {
      const auto corners = ring(p);
      if (corners.size() != 3 || !is_exact(shape_.face_of_polygon[p])) continue;
      if (settled_facets_.count({corners[0], corners[1], corners[2]}) != 0) continue;
      if (!is_near(side_of(corners, 0)) || !is_near(side_of(corners, 1)) || !is_near(side_of(corners, 2))) continue;
      const Vec3 a = at(corners[0]), b = at(corners[1]), c = at(corners[2]);
      const double reach = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      asked.push_back({{false, shape_.face_of_polygon[p]}, {}, static_cast<int>(p), (a + b + c) / 3.0, reach});
    }
    std::ranges::stable_sort(asked, {}, &Question::owner);
    return asked;
  }

  void answer(std::span<const Question> asked) {
    const Owner& owner = asked.front().owner;
    std::vector<double> points, nearest(3 * asked.size(), std::numeric_limits<double>::quiet_NaN());
    for (const Question& question : asked)
      points.insert(points.end(), {question.point.x, question.point.y, question.point.z});
    evaluate(owner, points, nearest);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const Vec3 found(nearest[3 * i], nearest[3 * i + 1], nearest[3 * i + 2]);
      const double distance = glm::distance(found, asked[i].point);
      if (!std::isfinite(distance)) refuse(owner, "answers with a coordinate that is not finite");
      if (distance > asked[i].reach)
        refuse(owner, "answers with a point that is farther from a facet than this is long");
      take(asked[i], distance > exact_.tolerance ? std::optional(found) : std::nullopt);
    }
  }

  void take(const Question& question, const std::optional<Vec3>& moved) {
    if (!moved) {
      if (question.facet < 0) {
        settled_.insert(question.side);
      } else {
        const auto corners = ring(static_cast<std::size_t>(question.facet));
        settled_facets_.insert({corners[0], corners[1], corners[2]});
      }
      return;
    }
    if (shape_.points.size() >= most_points_)
      refuse(question.owner, "has more than " + std::to_string(most_points_) + " points and is not near enough",
             "allow a greater tolerance, and declare edges where faces meet at an angle");
    if (question.facet < 0)
      middle_[question.side] = static_cast<int>(shape_.points.size());
    else
      centre_[question.facet] = static_cast<int>(shape_.points.size());
    shape_.points.push_back({moved->x, moved->y, moved->z});
  }

  void evaluate(const Owner& owner, const std::vector<double>& points, std::vector<double>& nearest) const {
    int code = 0;
    try {
      code = (owner.is_edge ? exact_.edge : exact_.face)(exact_.host, number_, static_cast<std::uint32_t>(owner.number),
                                                         points.size() / 3, points.data(), nearest.data());
    } catch (...) {
      refuse(owner, "throws an exception across the C interface");
    }
    if (code != 0) refuse(owner, "fails with " + std::to_string(code));
  }

  [[noreturn]] void refuse(const Owner& owner, const std::string& reason, const std::string& remedy = "") const {
    refuse_input("exact",
                 std::string(owner.is_edge ? "edge " : "face ") + std::to_string(owner.number) + " of shape " +
                     std::to_string(number_) + ": " + reason,
                 remedy);
  }

  void divide_edges() {
    divide_parameters();
    std::vector<int> vertices;
    int begin = 0;
    for (surfaces::DeclaredEdge& edge : shape_.edges) {
      for (int i = begin; i < edge.end; ++i) {
        vertices.push_back(shape_.edge_vertices[static_cast<std::size_t>(i)]);
        if (const int middle = i + 1 == edge.end ? -1 : middle_after(i); middle >= 0) vertices.push_back(middle);
      }
      begin = edge.end;
      edge.end = static_cast<int>(vertices.size());
    }
    shape_.edge_vertices = std::move(vertices);
  }

  // The new point between a vertex of an edge and the next one; -1: none.
  [[nodiscard]] int middle_after(int i) const {
    const auto found =
        middle_.find(side_of(std::span(shape_.edge_vertices).subspan(static_cast<std::size_t>(i), 2), 0));
    return found == middle_.end() ? -1 : found->second;
  }

  // Those of new points on the curves of edges: of the points of these that are nearest.
  void divide_parameters() {
    for (importer::EdgeSpline& curve : shape_.splines) {
      if (curve.is_wire) continue;
      const int first = curve.number == 0 ? 0 : shape_.edges[static_cast<std::size_t>(curve.number) - 1].end;
      std::vector<double> divided;
      for (std::size_t i = 0; i < curve.parameters.size(); ++i) {
        divided.push_back(curve.parameters[i]);
        const bool is_last = i + 1 == curve.parameters.size();
        const int middle = is_last ? -1 : middle_after(first + static_cast<int>(i));
        if (middle < 0) continue;
        divided.push_back(
            nearest_parameter(curve.spline, curve.parameters[i], curve.parameters[i + 1],
                              [&](const Vec4& on_it) { return glm::distance(Vec3(on_it) / on_it.w, at(middle)); }));
      }
      curve.parameters = std::move(divided);
    }
  }

  void divide_facets() {
    replace_polygons([&](std::size_t p, const auto& take) {
      const auto corners = ring(p);
      std::vector<int> middles;  // of each side; -1: it stays
      int split = 0;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto found = middle_.find(side_of(corners, i));
        middles.push_back(found == middle_.end() ? -1 : found->second);
        split += middles.back() >= 0;
      }
      const auto centre = centre_.find(static_cast<int>(p));
      if (corners.size() == 3 && is_exact(shape_.face_of_polygon[p])) {
        if (split > 0) return divide_triangle({corners[0], corners[1], corners[2]}, middles, split, take);
        if (centre == centre_.end()) return take(corners);
        for (std::size_t i = 0; i < 3; ++i) take(std::array{corners[i], corners[(i + 1) % 3], centre->second});
        return;
      }
      std::vector<int> longer;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        longer.push_back(corners[i]);
        if (middles[i] >= 0) longer.push_back(middles[i]);
      }
      take(longer);
    });
  }

  template <class Take>
  void divide_triangle(std::array<int, 3> c, std::vector<int> m, int split, const Take& take) const {
    const auto turn = [&] {
      std::rotate(c.begin(), c.begin() + 1, c.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    };
    if (split == 3) {
      for (std::size_t i = 0; i < 3; ++i) take(std::array{c[i], m[i], m[(i + 2) % 3]});
      return take(std::array{m[0], m[1], m[2]});
    }
    if (split == 1) {
      while (m[0] < 0) turn();
      take(std::array{c[0], m[0], c[2]});
      return take(std::array{m[0], c[1], c[2]});
    }
    while (m[2] >= 0) turn();
    take(std::array{m[0], c[1], m[1]});
    if (glm::distance(at(c[0]), at(m[1])) <= glm::distance(at(m[0]), at(c[2]))) {
      take(std::array{c[0], m[0], m[1]});
      return take(std::array{c[0], m[1], c[2]});
    }
    take(std::array{c[0], m[0], c[2]});
    take(std::array{m[0], m[1], c[2]});
  }

  importer::Shape& shape_;
  std::uint32_t number_;
  const epura_hlr_exact& exact_;
  std::size_t most_points_;
  std::set<Side> settled_;                       ///< near enough to their surface or edge
  std::set<std::array<int, 3>> settled_facets_;  ///< likewise, by corners
  std::map<Side, int> middle_;                   ///< new points on sides
  std::map<int, int> centre_;                    ///< and in facets, of this round
};

}  // namespace

void follow_surfaces(importer::Document& document, const epura_hlr_exact& exact) {
  for (std::size_t i = 0; i < document.shapes.size(); ++i)
    ShapeFollower(document.shapes[i], static_cast<std::uint32_t>(i), exact).follow();
}

}  // namespace epura::hlr
