// SPDX-License-Identifier: Apache-2.0
// Facets of B-spline faces that Open CASCADE writes here.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "at_length.hpp"
#include "base/file.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "program.hpp"
#include "support.hpp"

namespace epura::test::spline_faces_test {
namespace {

TopoDS_Face face_of(const Handle(Geom_BSplineSurface) & surface) { return BRepBuilderAPI_MakeFace(surface, 1e-7); }

importer::ReadModel read(const Folder& folder, const TopoDS_Face& face, const char* deflection) {
  const std::string path = (folder / "face.brep").string();
  EXPECT_TRUE(BRepTools::Write(face, path.c_str()));
  foreign::Assignments given;
  if (deflection != nullptr) given.emplace_back("deflection", deflection);
  return importer::read_model(path, given, {.plugin_path = {EPURA_TEST_IMPORTERS}});
}

// x^2 + y^2 - z^2 / 2 = 200 between two circles of radius 20, the upper one turned by 90 degrees. The seam is straight,
// and the surface turns along it.
Handle(Geom_BSplineSurface) hyperboloid() {
  constexpr int count = 9;
  const double across[count][2]{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  TColgp_Array2OfPnt poles(1, count, 1, 2);
  TColStd_Array2OfReal weights(1, count, 1, 2);
  for (int i = 1; i <= count; ++i) {
    const auto& [x, y] = across[i - 1];
    poles(i, 1) = gp_Pnt(20 * x, 20 * y, -20);
    poles(i, 2) = gp_Pnt(-20 * y, 20 * x, 20);
    weights(i, 1) = weights(i, 2) = i % 2 == 1 ? 1 : std::sqrt(0.5);
  }
  TColStd_Array1OfReal around(1, 5), along(1, 2);
  TColStd_Array1OfInteger times_around(1, 5), times_along(1, 2);
  for (int i = 1; i <= 5; ++i) {
    around(i) = i;
    times_around(i) = i == 1 || i == 5 ? 3 : 2;
  }
  for (int i = 1; i <= 2; ++i) {
    along(i) = i;
    times_along(i) = 2;
  }
  return new Geom_BSplineSurface(poles, weights, around, along, times_around, times_along, 2, 1);
}

// Both lie on the ruling from (20, 0, -20) to (0, 20, 20).
bool is_on_seam(const Vec3& p) { return std::abs(p.x + p.y - 20) < 1e-6 && std::abs(p.x + p.z / 2 - 10) < 1e-6; }

// A sheet of 8 m with a hill or a hollow at every pole.
Handle(Geom_BSplineSurface) rough_sheet(int count) {
  constexpr int degree = 3;
  TColgp_Array2OfPnt poles(1, count, 1, count);
  for (int i = 1; i <= count; ++i)
    for (int j = 1; j <= count; ++j)
      poles(i, j) = gp_Pnt(8000.0 * i / count, 8000.0 * j / count, (i * 7 + j * 5) % 11 * 180.0);
  const int knots = count - degree + 1;
  TColStd_Array1OfReal at(1, knots);
  TColStd_Array1OfInteger times(1, knots);
  for (int i = 1; i <= knots; ++i) {
    at(i) = i;
    times(i) = i == 1 || i == knots ? degree + 1 : 1;
  }
  return new Geom_BSplineSurface(poles, at, at, times, times, degree, degree);
}

// An L along two sides of it, which has few facets: as many are expected as of the whole.
TopoDS_Face strips_of(const Handle(Geom_BSplineSurface) & surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const double u = u0 + (u1 - u0) / 100, v = v0 + (v1 - v0) / 100;
  const std::array<gp_Pnt2d, 6> corners{{{u0, v0}, {u1, v0}, {u1, v}, {u, v}, {u, v1}, {u0, v1}}};
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < 6; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[(i + 1) % 6]).Value(), surface).Edge());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire());
  BRepLib::BuildCurves3d(face);
  return face;
}

// One that would take half a million facets, and minutes, gets fewer, and says so.
TEST(SplineFaces, AreAsFineAsTheyCanBeMadeInAMinute) {
  const Folder folder;
  const auto notes_about_facets = [](const importer::ReadModel& model) {
    const std::vector<std::string>& notes = model.mesh.report.notes;
    return std::count_if(notes.begin(), notes.end(),
                         [](const std::string& note) { return contains(note, "a free form would take about"); });
  };
  EXPECT_EQ(notes_about_facets(read(folder, strips_of(rough_sheet(40)), nullptr)), 1);
  EXPECT_EQ(notes_about_facets(read(folder, face_of(rough_sheet(5)), nullptr)), 0);
  if (!at_length()) return;  // half a minute
  const importer::ReadModel model = read(folder, face_of(rough_sheet(40)), nullptr);
  EXPECT_EQ(notes_about_facets(model), 1);
  EXPECT_GT(model.mesh.report.triangles, 20'000);
  EXPECT_LT(model.mesh.report.triangles, 300'000);
}

// Facets become finer until they would be too many; what the refusal tells to ask for is kept.
TEST(SplineFaces, AreAsFineAsHintsOfErrorsTell) {
  const Folder folder;
  ASSERT_TRUE(BRepTools::Write(strips_of(rough_sheet(8)), (folder / "part.brep").c_str()));
  const auto draw = [&](const std::string& allowed) {
    return epura({"draw", "part.brep", "--views", "front,isometric", "--max-error", allowed, "-o", "x.svg"},
                 folder / "");
  };
  const Outcome refused = draw("0.002");
  ASSERT_EQ(refused.code, 2) << refused.err;
  const std::string before = "hint: raise --max-error to ";
  const std::size_t from = refused.err.find(before), to = refused.err.find(" mm, or ", from);
  ASSERT_LT(from, to) << refused.err;
  const Outcome kept = draw(refused.err.substr(from + before.size(), to - from - before.size()));
  EXPECT_EQ(kept.code, 0) << refused.err << kept.err;
}

TEST(SplineFaces, FacetsAtTheSeamOfARuledFaceFaceAsItDoes) {
  const Folder folder;
  const importer::ReadModel model = read(folder, face_of(hyperboloid()), "0.01");
  int at_seam = 0;
  for (int t = 0; t < model.mesh.report.triangles; ++t) {
    std::array<Vec3, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = model.mesh.point(model.mesh.triangle(t)[i]);
    if (std::count_if(at.begin(), at.end(), is_on_seam) < 2) continue;
    ++at_seam;
    const Vec3 facet = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
    for (const Vec3& p : at) {
      const Vec3 normal = glm::normalize(Vec3(p.x, p.y, -p.z / 2));
      EXPECT_GT(std::abs(glm::dot(facet, normal)), std::cos(20 * std::numbers::pi / 180)) << p.x << ' ' << p.z;
    }
  }
  // The normal turns by 71 degrees from end to end.
  EXPECT_GE(at_seam, 8);
}

// A hill over a square of 80 mm. x and y are those of u and v.
Handle(Geom_BSplineSurface) hill(double height) {
  constexpr int degree = 3, spans = 20, count = spans + degree;
  TColStd_Array1OfReal at(1, spans + 1);
  TColStd_Array1OfInteger times(1, spans + 1);
  for (int i = 1; i <= spans + 1; ++i) {
    at(i) = 80.0 * (i - 1) / spans - 40;
    times(i) = i == 1 || i == spans + 1 ? degree + 1 : 1;
  }
  const auto place = [&](int pole) {
    double sum = 0;
    for (int k = 0; k < degree; ++k) sum += at(std::clamp(pole + k - degree + 1, 1, spans + 1));
    return sum / degree;
  };
  TColgp_Array2OfPnt poles(1, count, 1, count);
  for (int i = 1; i <= count; ++i)
    for (int j = 1; j <= count; ++j) {
      const double x = place(i), y = place(j);
      poles(i, j) = gp_Pnt(x, y, height * std::exp(-(x * x + y * y) / 250));
    }
  return new Geom_BSplineSurface(poles, at, at, times, times, degree, degree);
}

using Line = std::array<Vec2, 2>;

// The contour of a hill that is seen along (0, -1, 1/2), where dz/dy = -1/2, up to its cusps, d^2z/dy^2 = 0: in short
// pieces, from columns to which x and y are nearly linear.
std::vector<Line> contour_of(const Handle(Geom_BSplineSurface) & surface, const std::vector<double>& map) {
  constexpr int columns = 4000, rows = 160;
  std::vector<Line> contour;
  std::optional<Vec2> before;
  for (int i = 0; i <= columns; ++i) {
    const double u = 40.0 * i / columns - 20;
    const auto slope = [&](double v) {
      gp_Pnt at;
      gp_Vec along, across;
      surface->D1(u, v, at, along, across);
      return across.Z() / across.Y() + 0.5;
    };
    std::optional<Vec2> here;
    for (int j = 0; j < rows && !here; ++j) {
      double low = 20.0 * j / rows, high = 20.0 * (j + 1) / rows;
      if (!(slope(low) > 0 && slope(high) <= 0)) continue;  // it becomes steeper: the hill hides the rest
      for (int k = 0; k < 40; ++k) {
        const double middle = (low + high) / 2;
        (slope(middle) > 0 ? low : high) = middle;
      }
      const gp_Pnt p = surface->Value(u, low);
      const auto row = [&](std::size_t k) {
        return map[k] * p.X() + map[k + 1] * p.Y() + map[k + 2] * p.Z() + map[k + 3];
      };
      here = Vec2(row(0), row(4));
    }
    if (before && here) contour.push_back({*before, *here});
    before = here;
  }
  return contour;
}

double farthest(const std::vector<Line>& lines, const std::vector<Line>& others) {
  double largest = 0;
  for (const Line& line : lines)
    for (int i = 0; i <= 8; ++i) {
      double least = HUGE_VAL;
      for (const Line& other : others)
        least = std::min(least, distance_to_segment(line[0] + i / 8.0 * (line[1] - line[0]), other[0], other[1]));
      largest = std::max(largest, least);
    }
  return largest;
}

std::vector<double> numbers_after(const std::string& json, const std::string& key, std::size_t from) {
  const std::size_t begin = json.find(key, from) + key.size();
  std::string list = json.substr(begin, json.find_first_of("]}", begin) - begin);
  std::erase(list, ' ');
  return parse_numbers(list).value();
}

std::vector<Line> contours_in(const std::string& json) {
  std::vector<Line> lines;
  const std::string begin = "{\"from\"";
  for (std::size_t at = json.find(begin); at != std::string::npos; at = json.find(begin, at + 1)) {
    if (!contains(json.substr(at, json.find('}', at) - at), "\"kind\": \"contour\"")) continue;
    const std::vector<double> from = numbers_after(json, "\"from\": [", at), to = numbers_after(json, "\"to\": [", at);
    lines.push_back({Vec2(from[0], from[1]), Vec2(to[0], to[1])});
  }
  return lines;
}

// Facets go on beyond the cusps of a free form, by up to a side of a facet. For a hill of 20 mm, what is stated, 1.78
// mm, is an estimate 4 % too small.
TEST(SplineFaces, ContoursAreOffBeyondCusps) {
  for (const double height : {30.0, 40.0}) {
    const Folder folder;
    const Handle(Geom_BSplineSurface) surface = hill(height);
    ASSERT_TRUE(BRepTools::Write(face_of(surface), (folder / "hill.brep").c_str()));
    const Outcome run = epura({"draw", "hill.brep", "--projection", "auxiliary:direction=0,-1,0.5", "--hidden", "none",
                               "--sheet", "none", "--scale", "2:1", "-o", "x.json"},
                              folder / "");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string json = read_file(folder / "x.json"), key = "\"total\": ";
    const std::size_t from = json.find(key) + key.size();
    const double stated = parse_number(json.substr(from, json.find(',', from) - from)).value();
    const std::vector<Line> drawn = contours_in(json),
                            contour = contour_of(surface, numbers_after(json, "\"world_to_page\": [", 0));
    ASSERT_FALSE(drawn.empty());
    ASSERT_FALSE(contour.empty());
    const double off = std::max(farthest(drawn, contour), farthest(contour, drawn));
    EXPECT_LE(off, stated) << height;
    EXPECT_LE(stated, 5 * off) << height;
  }
}

}  // namespace
}  // namespace epura::test::spline_faces_test
