// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: edges drawn where a fillet runs smoothly into a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "shapes.hpp"

namespace epura::test::borders_test {
namespace {

/// A fillet in the corner between a wall and a floor whose radius grows along it, so that it is a free form. Its first
/// facets beside the wall are twice as wide where a random vertex is missing there.
Part growing_fillet(unsigned seed) {
  constexpr int columns = 5, rows = 7;
  std::mt19937 random(seed);
  Part part;
  std::vector<int> wall, floor, previous, angles_before;
  for (int i = 0; i < columns; ++i) {
    std::vector<int> column, angles;
    const double radius = 6 + 0.4 * i * i, x = 16 * i;
    for (int j = 0; j <= rows; ++j) {
      if (j == rows - 1 && random() % 2 == 0) continue;
      const double a = 0.5 * pi * j / rows;
      column.push_back(part.add(Vec3(x, radius - radius * std::sin(a), radius - radius * std::cos(a))));
      angles.push_back(j);
    }
    floor.push_back(column.front());
    wall.push_back(column.back());
    for (std::size_t j = 0, k = 0; !previous.empty() && (j + 1 < previous.size() || k + 1 < column.size());) {
      const bool left = k + 1 == column.size() || (j + 1 < previous.size() && angles_before[j + 1] <= angles[k + 1]);
      if (left)
        part.faces.push_back({previous[j], column[k], previous[j + 1]});
      else
        part.faces.push_back({previous[j], column[k], column[k + 1]});
      ++(left ? j : k);
    }
    previous = std::exchange(column, {});
    angles_before = std::exchange(angles, {});
  }
  const auto close = [&](std::vector<int> side, const Vec3& next, const Vec3& last) {
    side.push_back(part.add(next));
    side.push_back(part.add(last));
    part.faces.push_back(std::move(side));
  };
  constexpr double length = 16 * (columns - 1);
  close(wall, {length, 0, 40}, {0, 0, 40});
  close({floor.rbegin(), floor.rend()}, {0, 40, 0}, {length, 40, 0});
  return part.round_to_float();
}

// Over a quarter of the border, the normals that are estimated from such facets may be off by more than 5 degrees.
TEST(Borders, TiltedFacetsDoNotMakeAFilletEndSharply) {
  for (unsigned seed = 0; seed < 64; ++seed) {
    const surfaces::PartFaces faces = surfaces::recognise_faces(growing_fillet(seed).mesh());
    EXPECT_EQ(std::count_if(
                  faces.faces.begin(), faces.faces.end(),
                  [](const surfaces::PartFace& face) { return face.surface.kind == surfaces::SurfaceKind::free_form; }),
              1);
    for (const surfaces::PartBorder& border : faces.borders)
      EXPECT_NE(border.kind, surfaces::BorderKind::sharp) << seed << ": " << border.angle;
  }
}

/// A boss on a plate with a fillet of 10 around its foot, of so many rows of facets. The circle between the fillet and
/// the plate lies off the torus by `off`; beyond it, a plain slope of so many degrees leads `width` far to the plate.
Part boss(int rows, double off, double slope = 0, double width = 0) {
  const double floor = -off - width * std::tan(slope * pi / 180);
  std::vector<Vec2> profile{{160, floor}, {139.6 + width, floor}};
  if (width > 0) profile.push_back({139.6, -off});
  const std::vector<Vec2> fillet = arc({139.6, 10}, 10, -90, -180, rows);
  profile.insert(profile.end(), fillet.begin() + 1, fillet.end());
  profile.push_back({129.6, 40});
  return revolved(profile, 72).triangulate().round_to_float();
}

std::vector<double> sharp_angles(const Part& part) {
  std::vector<double> angles;
  for (const surfaces::PartBorder& border : surfaces::recognise_faces(part.mesh()).borders)
    if (border.kind == surfaces::BorderKind::sharp) angles.push_back(border.angle);
  return angles;
}

// Its first row is exactly a cone, of which 75 mm stood in the drawing of a pump's cover.
TEST(Borders, RowsOfAnInexactFilletAreNoCones) {
  for (const int rows : {4, 5, 6})
    for (const double off : {0.001, 0.002}) {
      const surfaces::PartFaces faces = surfaces::recognise_faces(boss(rows, off).mesh());
      EXPECT_EQ(faces.faces.size(), 3U) << rows << ' ' << off;
      EXPECT_EQ(sharp_angles(boss(rows, off)), std::vector<double>()) << rows << ' ' << off;
    }
}

TEST(Borders, SlopesBesideAFilletAreCones) {
  for (const double slope : {10.0, 20.0, 45.0})
    for (const double width : {0.5, 2.0}) {
      const std::vector<double> angles = sharp_angles(boss(6, 0, slope, width));
      ASSERT_EQ(angles.size(), 2U) << slope << ' ' << width;
      for (const double angle : angles) EXPECT_NEAR(angle, slope, 0.1);
    }
}

/// The foot of that boss with a fillet of 5 whose vertices lie off any torus; `edge` degrees between it and the plate.
Part wavy_boss(int rows, double off, double edge) {
  Part part = boss(rows, 0);
  return part
      .move([&](const Vec3& p) {
        const double away = std::hypot(p.x, p.y), around = std::atan2(p.y, p.x);
        if (away > 139.599) return Vec3(p.x, p.y, -(away - 139.6) * std::tan(edge * pi / 180));
        const double height = p.z > 9.999 ? p.z - 5 : p.z / 2, from = p.z > 9.999 ? away + 5 : (away + 139.6) / 2;
        const bool inside = p.z > 0.001 && p.z < 9.999;
        const double moved = from + (inside ? off * std::sin(3 * around + 40 * p.z) : 0);
        return Vec3(p.x * moved / away, p.y * moved / away, height);
      })
      .round_to_float();
}

// The two halves of a quadrilateral are not one facet there, and only one of them has the next row beside it.
TEST(Borders, AFreeFormTurnsAsFarAsTheNextRowTells) {
  for (const int rows : {5, 6, 8})
    for (const double off : {0.004, 0.008}) EXPECT_EQ(sharp_angles(wavy_boss(rows, off, 0)), std::vector<double>());
}

TEST(Borders, AFreeFormMeetsASlopeSharply) {
  for (const int rows : {5, 6, 8})
    for (const double edge : {20.0, 30.0}) {
      const std::vector<double> angles = sharp_angles(wavy_boss(rows, 0.008, edge));
      EXPECT_EQ(angles.size(), 1U) << rows << ' ' << edge;
    }
}

// A rounded plug in a housing: where flats run into fillets on the face at which they touch, four triangles meet.
TEST(Borders, OfBodiesThatTouchAreThoseOfEach) {
  constexpr int steps = 8;
  const std::vector<Vec2> outline = joined({arc({7, 7}, 5, 0, 90, steps), arc({-7, 7}, 5, 90, 180, steps),
                                            arc({-7, -7}, 5, 180, 270, steps), arc({7, -7}, 5, 270, 360, steps)});
  const Part plug = prism(outline, 10);
  Part both = plug;
  const int n = static_cast<int>(outline.size()), first = static_cast<int>(both.points.size());
  for (const double z : {0.0, 10.0})
    for (const Vec2& p : outline) both.add({2 * p.x, 2 * p.y, z});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    both.faces.push_back({j, i, n + i, n + j});
    both.faces.push_back({first + i, first + j, first + n + j, first + n + i});
    both.faces.push_back({i, j, first + j, first + i});
    both.faces.push_back({n + j, n + i, first + n + i, first + n + j});
  }
  const auto borders = [](const surfaces::PartFaces& part, surfaces::BorderKind kind) {
    return std::count_if(part.borders.begin(), part.borders.end(), [&](const auto& b) { return b.kind == kind; });
  };
  for (const Part& part : {both, Part(both).triangulate()}) {
    const surfaces::PartFaces faces = surfaces::recognise_faces(part.mesh());
    EXPECT_EQ(faces.faces.size(), 28U);
    EXPECT_EQ(borders(faces, surfaces::BorderKind::tangent), 16);
    EXPECT_EQ(borders(faces, surfaces::BorderKind::open), 0);
    for (const surfaces::PartBorder& border : faces.borders)
      if (border.kind == surfaces::BorderKind::sharp) {
        EXPECT_NEAR(border.angle, 90, 1e-6);
      }
  }
}

// A block with rounded edges, as sums of a block and a polygon have them: the first facet is a whole step from the
// plane, but the surface half a step. An edge of the part turns farther.
TEST(Borders, RoundedEdgesThatBeginHalfAStepLateAreTangent) {
  for (const double late : {0.5, 2.0}) {
    constexpr double step = 15;
    std::vector<Vec2> outline;
    for (int corner = 0; corner < 4; ++corner) {
      const Vec2 centre(corner == 0 || corner == 3 ? 30 : 0, corner < 2 ? 20 : 0);
      const std::vector<Vec2> round =
          arc(centre, 4, 90 * corner + late * step, 90 * (corner + 1) - late * step, static_cast<int>(6 - 2 * late));
      outline.insert(outline.end(), round.begin(), round.end());
    }
    const surfaces::PartFaces part = surfaces::recognise_faces(prism(outline, 10).mesh());
    EXPECT_EQ(count(part, surfaces::BorderKind::tangent), late < 1 ? 8 : 0) << late;
  }
}

}  // namespace
}  // namespace epura::test::borders_test
