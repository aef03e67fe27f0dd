// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: a part drawn otherwise after it went through another program.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <string>
#include <tuple>

#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::order_test {
namespace {

using namespace test;

/// The same part in another file: vertices and faces in another order, faces that begin at other corners, axes that
/// have other names or directions, another unit.
struct Variant {
  unsigned order = 0;  ///< 0 as it is
  std::array<int, 3> axes{0, 1, 2};
  std::array<double, 3> factors{1, 1, 1};

  [[nodiscard]] bool is_mirrored() const {
    const bool odd = (axes[0] > axes[1]) != ((axes[1] > axes[2]) != (axes[0] > axes[2]));
    return odd != (factors[0] * factors[1] * factors[2] < 0);
  }
};

struct Varied {
  Part part;
  std::vector<int> original;  ///< by vertex
};

Varied varied(const Part& part, const Variant& variant) {
  Varied result{part, {}};
  for (int v = 0; v < static_cast<int>(part.points.size()); ++v) result.original.push_back(v);
  std::mt19937 random(variant.order);
  if (variant.order > 0) {
    std::shuffle(result.original.begin(), result.original.end(), random);
    result.part.shuffle(variant.order);
  }
  std::vector<int> place(part.points.size());
  for (std::size_t i = 0; i < result.original.size(); ++i) {
    const Vec3& p = part.points[result.original[i]];
    place[result.original[i]] = static_cast<int>(i);
    for (int k = 0; k < 3; ++k) result.part.points[i][k] = variant.factors[k] * p[variant.axes[k]];
  }
  for (auto& face : result.part.faces)
    for (int& v : face) v = place[v];
  if (variant.is_mirrored()) result.part.turn_inside_out();
  return result;
}

using Place = std::array<double, 3>;

/// Kinds of triangles, and borders as sets of edges; both by where corners lie in the file as it was.
struct Recognised {
  std::map<std::vector<Place>, surfaces::SurfaceKind> triangles;
  std::vector<std::tuple<surfaces::BorderKind, bool, std::vector<std::array<Place, 2>>>> borders;
  std::vector<std::tuple<surfaces::SurfaceKind, int>> faces;
  bool operator==(const Recognised&) const = default;
};

Recognised recognised(const Part& part, const Variant& variant) {
  const Varied other = varied(part, variant);
  const mesh::Mesh mesh = other.part.mesh();
  const surfaces::PartFaces found = surfaces::recognise_faces(mesh);
  const auto place = [&](int v) {
    const Vec3& p = part.points[other.original[v]];
    return Place{p.x, p.y, p.z};
  };
  Recognised result;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    std::vector<Place> corners;
    for (const int v : mesh.triangle(t)) corners.push_back(place(v));
    std::sort(corners.begin(), corners.end());
    const int face = found.face_of_triangle[t];
    result.triangles[corners] = face < 0 ? surfaces::SurfaceKind::free_form : found.faces[face].surface.kind;
  }
  for (const surfaces::PartBorder& border : found.borders) {
    std::vector<std::array<Place, 2>> edges;
    for (const int e : border.edges) {
      std::array ends{place(mesh.edges[e].vertex[0]), place(mesh.edges[e].vertex[1])};
      std::sort(ends.begin(), ends.end());
      edges.push_back(ends);
    }
    std::sort(edges.begin(), edges.end());
    result.borders.emplace_back(border.kind, border.closed, edges);
  }
  std::sort(result.borders.begin(), result.borders.end());
  for (const surfaces::PartFace& face : found.faces) result.faces.emplace_back(face.surface.kind, face.triangles);
  std::sort(result.faces.begin(), result.faces.end());
  return result;
}

Part sample(const std::string& name) {
  const mesh::Mesh mesh = mesh::read_mesh(EPURA_TEST_SAMPLES "/models/" + name);
  Part part;
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) part.points.push_back(mesh.point(v));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    part.faces.push_back({a, b, c});
  }
  part.is_float = mesh.report.single_precision;
  return part;
}

/// A tube along a circle and on along its tangents.
Part elbow(int around, int along, double ratio) {
  Part part;
  std::vector<std::vector<int>> rings;
  const auto add = [&](const Vec3& centre, double turn) {
    rings.emplace_back();
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * i / around, r = 3 * std::cos(a), z = 3 * std::sin(a);
      rings.back().push_back(part.add(centre + Vec3(r * std::cos(turn), r * std::sin(turn), z)));
    }
  };
  const double radius = 3 * ratio;
  add({radius, -8, 0}, 0);
  for (int i = 0; i <= along; ++i) {
    const double a = pi / 2 * i / along;
    add(radius * Vec3(std::cos(a), std::sin(a), 0), a);
  }
  add({-8, radius, 0}, pi / 2);
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (int i = 0; i < around; ++i) {
      const int j = (i + 1) % around;
      part.faces.push_back({rings[k][i], rings[k + 1][i], rings[k + 1][j], rings[k][j]});
    }
  part.faces.push_back(rings.front());
  part.faces.push_back({rings.back().rbegin(), rings.back().rend()});
  return part.turn_inside_out();
}

std::map<std::string, Part> zoo() {
  std::map<std::string, Part> parts;
  for (const char* name : {"bearing.obj", "bracket.obj", "cylinders.obj", "elbow.obj", "flange.obj", "gear.stl",
                           "house.obj", "shaft.obj", "sombrero.obj", "stairs.obj"})
    parts[name] = sample(name);
  for (const int steps : {2, 5})
    parts["fillets " + std::to_string(steps)] = revolved(joined({{{0, 0}, {9, 0}, {10, 1}},
                                                                 {{10, 10}},
                                                                 arc({12, 10}, 2, 180, 90, steps),
                                                                 {{19, 12}},
                                                                 arc({19, 13}, 1, -90, 0, steps),
                                                                 {{20, 30}, {0, 30}}}),
                                                         36)
                                                    .triangulate()
                                                    .round_to_float();
  parts["plate"] = plate_with_hole(20, 5, 8, 8).triangulate();
  parts["ball"] = revolved(joined({{{0, -3}}, arc({0, 0}, 3, -85, 85, 17), {{0, 3}}}), 40).triangulate();
  parts["rounded box"] = prism(joined({arc({8, 3}, 2, 0, 90, 4), arc({-8, 3}, 2, 90, 180, 4),
                                       arc({-8, -3}, 2, 180, 270, 4), arc({8, -3}, 2, 270, 360, 4)}),
                               30)
                             .triangulate();
  for (const double ratio : {1.5, 4.0})
    for (const int around : {16, 24})
      parts["elbow " + std::to_string(ratio) + " " + std::to_string(around)] =
          elbow(around, 9, ratio).triangulate().round_to_float();
  parts["lid"] = coarsely_bordered([](double x, double y) { return 0.1 * x * x - 0.07 * y * y + 0.01 * x * x * x; });
  return parts;
}

TEST(OrderOfAFile, DoesNotMatter) {
  for (const auto& [name, part] : zoo()) {
    const Recognised plain = recognised(part, {});
    for (const unsigned order : {1U, 2U, 3U, 4U})
      EXPECT_TRUE(recognised(part, {order}) == plain) << name << " " << order;
  }
}

TEST(OrderOfAFile, NorDoesWhichWayTrianglesTurn) {
  for (auto& [name, part] : zoo()) {
    const Recognised plain = recognised(part, {});
    for (std::size_t f = 0; f < part.faces.size(); f += 2) std::ranges::reverse(part.faces[f]);
    EXPECT_TRUE(recognised(part, {}) == plain) << name;
  }
}

TEST(OrderOfAFile, NeitherDoNamesOfAxesAndTheUnit) {
  const std::vector<Variant> variants{{1, {1, 2, 0}, {1, 1, 1}},          {2, {2, 0, 1}, {1, 1, 1}},
                                      {3, {1, 0, 2}, {1, 1, 1}},          {4, {0, 1, 2}, {-1, 1, 1}},
                                      {5, {0, 1, 2}, {1, -1, -1}},        {6, {2, 1, 0}, {1, 1, -1}},
                                      {7, {0, 1, 2}, {1024, 1024, 1024}}, {8, {0, 1, 2}, {0.125, 0.125, 0.125}}};
  for (const auto& [name, part] : zoo()) {
    const Recognised plain = recognised(part, {});
    for (const Variant& variant : variants)
      EXPECT_TRUE(recognised(part, variant) == plain) << name << " " << variant.order;
  }
}

}  // namespace
}  // namespace epura::order_test
