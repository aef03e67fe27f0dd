// SPDX-License-Identifier: Apache-2.0
#include "construction/epura.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace epura::construction::epura_test {
namespace {

constexpr double scale = 2, ground = 100;

// Plan and elevation at 2:1; the horizontal plane is z = -5, the vertical plane y = 20.
Epura epura() {
  Epura sheet;
  sheet.plan.world_to_page =
      rows({scale, 0, 0, 50}, {0, scale, 0, ground - 20 * scale}, {0, 0, scale, 0}, {0, 0, 0, 1});
  sheet.elevation.world_to_page =
      rows({scale, 0, 0, 50}, {0, 0, scale, ground + 5 * scale}, {0, -scale, 0, 0}, {0, 0, 0, 1});
  sheet.ground = ground;
  sheet.ends = {40, 90};
  return sheet;
}

Request request(const std::string& text, const std::vector<Vec3>& elements = {}) {
  return {scene::parse_construction(text, "test"), "test", elements};
}

const Point& find(const Figure& figure, const std::string& symbol) {
  const auto found = std::find_if(figure.points.begin(), figure.points.end(), [&](const Point& p) {
    return p.symbol.text() == symbol ||
           std::any_of(p.also.begin(), p.also.end(), [&](const Symbol& s) { return s.text() == symbol; });
  });
  if (found == figure.points.end()) throw std::runtime_error("no point " + symbol);
  return *found;
}

const std::vector<Vec3> cube{{0, 0, 0},  {10, 0, 0},  {10, 10, 0},  {0, 10, 0},
                             {0, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10}};

TEST(Epura, PlanAndElevationLieOnCorrespondenceLines) {
  const std::vector<Vec3> corners{{1, 2, 3}, {4, 9, 1}, {-3, 0, 7}};
  const Figure f = epura_figure(epura(), std::vector{request("corners")}, {corners, {}});
  for (const char* name : {"A", "B", "C"}) {
    const Vec2 plan = find(f, std::string(name) + "_1").at, elevation = find(f, std::string(name) + "_2").at;
    EXPECT_NEAR(plan.x, elevation.x, 1e-9);
    EXPECT_LT(plan.y, ground);
    EXPECT_GT(elevation.y, ground);
    EXPECT_TRUE(std::any_of(f.lines.begin(), f.lines.end(),
                            [&](const Line& line) { return line.from == plan && line.to == elevation; }));
  }
  EXPECT_NEAR(find(f, "A_1").at.y, ground - scale * 18, 1e-9) << "18 in front of the vertical plane";
  EXPECT_NEAR(find(f, "A_2").at.y, ground + scale * 8, 1e-9) << "8 above the horizontal plane";
}

// The corners of a cube coincide in pairs; the one that is seen is named first.
TEST(Epura, CoincidingPointsAreNamedTogether) {
  const Figure f = epura_figure(epura(), std::vector{request("corners")}, {cube, {}});
  const Point &plan = find(f, "A_1"), &elevation = find(f, "D_2");
  EXPECT_EQ(plan.symbol.text(), "E_1");
  ASSERT_EQ(plan.also.size(), 1U);
  EXPECT_EQ(plan.also[0].text(), "A_1");
  EXPECT_EQ(elevation.symbol.text(), "A_2");
  const auto vertical = std::count_if(f.lines.begin(), f.lines.end(), [](const Line& line) {
    return line.from.x == line.to.x && line.to.y > ground && line.from.y < ground;
  });
  EXPECT_EQ(vertical, 2) << "one line for the four points on each side";
}

TEST(Epura, RotationShowsTheTrueLength) {
  const std::vector<Vec3> edge{{1, 2, 3}, {7, 10, 8}};
  const Figure f = epura_figure(epura(), std::vector{request("true-length:0-1", edge)}, {});
  const double length = glm::length(edge[1] - edge[0]);
  EXPECT_NEAR(glm::length(find(f, "B'_2").at - find(f, "A_2").at), scale * length, 1e-9);
  EXPECT_NEAR(find(f, "B'_2").at.y, find(f, "B_2").at.y, 1e-12) << "the height stays";
  EXPECT_NEAR(find(f, "B'_1").at.y, find(f, "A_1").at.y, 1e-12) << "parallel to the vertical plane";
  EXPECT_NEAR(find(f, "B'_1").at.x, find(f, "B'_2").at.x, 1e-12);
  EXPECT_TRUE(std::any_of(f.lines.begin(), f.lines.end(), [](const Line& l) { return l.symbol.base == "(3)"; }));
}

// Both traces of a plane meet on LT, and the point of each is in the plane.
TEST(Epura, TracesOfAPlaneMeetOnTheGroundLine) {
  const std::vector<Vec3> face{{0, 0, 0}, {9, 2, 1}, {4, 6, 8}};
  const Figure f = epura_figure(epura(), std::vector{request("traces:0", face)}, {});
  std::vector<Line> traces;
  for (const Line& line : f.lines)
    if (!line.symbol.empty()) traces.push_back(line);
  ASSERT_EQ(traces.size(), 2U);
  EXPECT_NEAR(glm::length(traces[0].from - traces[1].from), 0, 1e-9);
  EXPECT_NEAR(traces[0].from.y, ground, 1e-12);
  const Vec3 n = glm::cross(face[1] - face[0], face[2] - face[0]);
  // In plan y = (page - ground)/scale + 20 and z = -5; in elevation y = 20 and z = (page - ground)/scale - 5.
  const Vec2 plan = traces[0].from + 7.0 * (traces[0].to - traces[0].from);
  const Vec2 elevation = traces[1].from + 7.0 * (traces[1].to - traces[1].from);
  EXPECT_NEAR(glm::dot(n, Vec3((plan.x - 50) / scale, (plan.y - ground) / scale + 20, -5)), 0, 1e-9);
  EXPECT_NEAR(glm::dot(n, Vec3((elevation.x - 50) / scale, 20, (elevation.y - ground) / scale - 5)), 0, 1e-9);
  EXPECT_LT(plan.y, ground);
  EXPECT_GT(elevation.y, ground);
}

// The rabatted face is congruent with the auxiliary view along the normal of the face.
TEST(Epura, RabatmentEqualsTheAuxiliaryView) {
  const std::vector<std::vector<Vec3>> faces{{{0, 0, 0}, {10, 0, 0}, {8, 4, 5}, {2, 4, 5}},
                                             {{0, 0, 1}, {3, 7, 2}, {1, 8, 9}},
                                             {{0, 0, 0}, {4, 3, 0}, {4, 3, 6}, {0, 0, 6}}};
  for (const std::vector<Vec3>& face : faces) {
    const Rabatment turned = rabatment(epura(), face);
    ASSERT_EQ(turned.shape.size(), face.size());
    const Vec3 n = glm::normalize(glm::cross(face[1] - face[0], face[2] - face[0]));
    const Vec3 u = glm::normalize(glm::cross(Vec3(0.3, 0.1, 0.9), n)), v = glm::cross(n, u);
    const auto auxiliary = [&](const Vec3& p) { return scale * Vec2(glm::dot(p, u), glm::dot(p, v)); };
    for (std::size_t i = 0; i < face.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_NEAR(glm::length(turned.shape[i] - turned.shape[j]),
                    glm::length(auxiliary(face[i]) - auxiliary(face[j])), 1e-9);
  }
}

// The last auxiliary view is congruent with the face, and with its rabatment; the one before shows it edge-on.
TEST(Epura, ChangeOfPlanesShowsTheTrueShape) {
  const std::vector<std::vector<Vec3>> faces{{{0, 0, 0}, {10, 0, 0}, {8, 4, 5}, {2, 4, 5}},
                                             {{0, 0, 1}, {3, 7, 2}, {1, 8, 9}},
                                             {{0, 0, 0}, {4, 3, 0}, {4, 3, 6}, {0, 0, 6}}};
  for (const std::vector<Vec3>& face : faces) {
    const std::vector<AuxiliaryView> views = change_of_planes(epura(), face, {});
    const bool is_upright = &face == &faces[2];
    ASSERT_EQ(views.size(), is_upright ? 1U : 2U);
    const std::vector<Vec2>& shape = views.back().points;
    const Rabatment turned = rabatment(epura(), face);
    ASSERT_EQ(shape.size(), face.size());
    for (std::size_t i = 0; i < face.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NEAR(glm::length(shape[i] - shape[j]), scale * glm::length(face[i] - face[j]), 1e-9);
        EXPECT_NEAR(glm::length(shape[i] - shape[j]), glm::length(turned.shape[i] - turned.shape[j]), 1e-9);
      }
    if (is_upright) continue;
    const std::vector<Vec2>& edge_on = views.front().points;
    const Vec2 along = edge_on[1] - edge_on.back();
    for (const Vec2& p : edge_on) EXPECT_NEAR(along.x * (p.y - edge_on[0].y) - along.y * (p.x - edge_on[0].x), 0, 1e-9);
    // As far behind the new ground line as the elevation is above LT, on a perpendicular to it through the plan.
    const Vec2 line = views[0].ground[1] - views[0].ground[0], across = Vec2(-line.y, line.x) / glm::length(line);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const EpuraPoint p = epura_point(epura(), face[i]);
      EXPECT_NEAR(std::abs(glm::dot(edge_on[i] - views[0].ground[0], across)), p.elevation.y - ground, 1e-9);
      EXPECT_NEAR(glm::dot(edge_on[i] - p.plan, line), 0, 1e-9);
    }
  }
  const std::vector<Vec3> level{{0, 0, 3}, {5, 0, 3}, {0, 5, 3}};
  EXPECT_TRUE(change_of_planes(epura(), level, {}).empty()) << "the plan shows it";
}

TEST(Epura, ChangeOfPlanesShowsTheTrueLength) {
  const std::vector<Vec3> edge{{1, 2, 3}, {7, 10, 8}};
  const Figure f = epura_figure(epura(), std::vector{request("true-length:0-1:auxiliary", edge)}, {});
  EXPECT_NEAR(glm::length(find(f, "A_3").at - find(f, "B_3").at), scale * glm::length(edge[1] - edge[0]), 1e-9);
  const std::vector<Vec3> face{{0, 0, 1}, {3, 7, 2}, {1, 8, 9}};
  const Figure g = epura_figure(epura(), std::vector{request("true-shape:0:auxiliary", face)}, {});
  EXPECT_NEAR(glm::length(find(g, "A_4").at - find(g, "C_4").at), scale * glm::length(face[2] - face[0]), 1e-9);
  EXPECT_TRUE(std::any_of(g.terms.begin(), g.terms.end(), [](const Term& t) {
    return t.meaning == "distances from LT1, behind LT2: ABC in true shape";
  }));
}

// A line through the middle of a tetrahedron, and the plane of a face through a triangle.
TEST(Epura, LinesAndPlanesMeetFaces) {
  const Vec3 a(0, 0, 0), b(12, 0, 0), c(0, 12, 0), d(0, 0, 12);
  const std::vector<FaceTriangles> faces{{{{a, b, c}}}, {{{a, b, d}}}, {{{a, c, d}}}, {{{b, c, d}}}};
  const Figure f = epura_figure(epura(), std::vector{request("piercing:0-1", {{1, 1, -3}, {2, 2, 4}})}, {{}, faces});
  // It enters through z = 0 at t = 3/7 and leaves through x + y + z = 12 at 2 + 2t - 3 + 7t = 12.
  const auto on_page = [](const Vec3& p) { return Vec2(50 + scale * p.x, ground + scale * (p.z + 5)); };
  const auto at = [](double t) { return Vec3(1, 1, -3) + t * Vec3(1, 1, 7); };
  EXPECT_NEAR(glm::length(find(f, "C_2").at - on_page(at(3.0 / 7))), 0, 1e-9);
  EXPECT_NEAR(glm::length(find(f, "D_2").at - on_page(at(13.0 / 9))), 0, 1e-9);
  const std::vector<Vec3> level{{20, 0, 3}, {30, 0, 3}, {20, 9, 3}};
  const Figure s = epura_figure(epura(), std::vector{request("section:0", level)}, {{}, faces});
  std::vector<double> lengths;
  for (const Line& line : s.lines)
    if (line.from.y < ground && line.to.y < ground - 1.5 && line.extent == Extent::segment)
      lengths.push_back(glm::length(line.to - line.from) / scale);
  std::sort(lengths.begin(), lengths.end());
  ASSERT_GE(lengths.size(), 3U);
  EXPECT_NEAR(lengths[0], 9, 1e-9) << "at a quarter of the height, three quarters of the legs are left";
  EXPECT_NEAR(lengths[1], 9, 1e-9);
  EXPECT_NEAR(lengths[2], 9 * std::sqrt(2), 1e-9);
  EXPECT_THROW(epura_figure(epura(), std::vector{request("piercing:0-1", {{50, 1, -3}, {50, 2, 4}})}, {{}, faces}),
               Error);
}

TEST(Epura, TooManyCornersAreRefused) {
  std::vector<Vec3> many;
  for (int i = 0; i < 60; ++i) many.emplace_back(i, 0, 0);
  EXPECT_THROW(epura_figure(epura(), std::vector{request("corners")}, {many, {}}), Error);
}

}  // namespace
}  // namespace epura::construction::epura_test
