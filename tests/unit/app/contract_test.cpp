// SPDX-License-Identifier: Apache-2.0
// The drawing JSON as other programs use it: schema 1, and every line found again from the model and the matrix.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../output/json_reader.hpp"
#include "base/vec.hpp"
#include "folder.hpp"
#include "mesh/read.hpp"
#include "program.hpp"

namespace epura::test::contract_test {
namespace {

constexpr double tolerance_mm = 1e-9;

template <int N>
glm::vec<N, double> vector(const Json& json) {
  EXPECT_EQ(json.type, '[');
  EXPECT_EQ(json.items.size(), static_cast<std::size_t>(N));
  glm::vec<N, double> v(0);
  for (int i = 0; i < N; ++i) v[i] = json.items.at(i).number();
  return v;
}

Mat4 matrix(const Json& json) {
  EXPECT_EQ(json.items.size(), 16U);
  Mat4 m;
  for (int i = 0; i < 16; ++i) m[i % 4][i / 4] = json.items.at(i).number();
  return m;
}

Vec2 on_page(const Mat4& world_to_page, const Vec3& p) {
  const Vec4 h = world_to_page * Vec4(p, 1);
  return Vec2(h) / h.w;
}

// A drawing of models, all of which stand at `place` in the world.
struct Case {
  std::vector<std::string> models;
  std::vector<std::string> options;
  Mat4 place{1.0};
};

class JsonDrawing {
 public:
  explicit JsonDrawing(const Case& c) : place_(c.place) {
    const Folder folder;
    std::vector<std::string> arguments{"draw", "-o", "-", "--format", "json"};
    for (const std::string& model : c.models) {
      arguments.push_back(sample(model));
      meshes_.push_back(mesh::read_mesh(sample(model)));
    }
    arguments.insert(arguments.end(), c.options.begin(), c.options.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    json_ = JsonReader(run.out).read();
  }

  void expect_all() const {
    EXPECT_EQ(json_.keys(), "epura unit sheet views report");
    EXPECT_EQ(json_["epura"].text, "1");
    EXPECT_EQ(json_["unit"].text, "mm");
    EXPECT_EQ(json_["sheet"].keys(), "size scale");
    EXPECT_GT(json_["sheet"]["scale"].number(), 0);
    ASSERT_EQ(json_["views"].items.size(), 1U);
    expect_view(json_["views"].items[0]);
    expect_report(json_["report"]);
  }

 private:
  void expect_report(const Json& report) const {
    expect_error(report["error"]);
    if (report.keys() != "meshes plan error") {
      EXPECT_EQ(report.keys(), "meshes plan tessellation error");
      const Json& tessellation = report["tessellation"];
      EXPECT_EQ(tessellation.keys(), "error on_paper");
      EXPECT_GT(tessellation["error"].number(), 0);
      const bool central = json_["views"].items[0]["viewer"].keys() == "centre";
      const double scale = central ? 0 : json_["sheet"]["scale"].number();
      EXPECT_NEAR(tessellation["on_paper"].number(), scale * tessellation["error"].number(), 1e-9);
    }
    ASSERT_EQ(report["meshes"].items.size(), meshes_.size());
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      EXPECT_EQ(report["meshes"].items[m]["vertices"].number(), meshes_[m].report.vertices);
      EXPECT_EQ(report["meshes"].items[m]["triangles"].number(), meshes_[m].report.triangles);
    }
    for (const Json& step : report["plan"].items) {
      const bool once = step.keys() == "stage run why in out";
      EXPECT_TRUE(once || step.keys() == "stage view run why in out") << step.keys();
    }
  }

  // The total is that of the terms, which are rounded up.
  void expect_error(const Json& errors) const {
    ASSERT_EQ(errors.items.size(), 1U);
    const Json& error = errors.items[0];
    EXPECT_EQ(error.keys(), "view total dominant terms");
    double sum = 0, largest = 0, dominant = 0;
    for (const Json& term : error["terms"].items) {
      EXPECT_EQ(term.keys(), "term mm by");
      sum += term["mm"].number();
      if (term["term"].text == error["dominant"].text) dominant = term["mm"].number();
      largest = std::max(largest, term["mm"].number());
    }
    EXPECT_NEAR(error["total"].number(), sum, 0.01 * sum);
    EXPECT_EQ(dominant, largest);
  }

  void expect_view(const Json& view) const {
    const std::string keys = "name projection parameters world_to_page viewer vanishing_points ";
    const bool moved = view.keys() == keys + "contours_moved segments";
    EXPECT_TRUE(moved || view.keys() == keys + "segments") << view.keys();
    // Lines that end at contours go with these.
    const double slack = tolerance_mm + (moved ? 2 * view["contours_moved"].number() : 0);
    EXPECT_EQ(view["parameters"].type, '{');
    expect_viewer(view);
    const Mat4 world_to_page = matrix(view["world_to_page"]);
    ASSERT_EQ(view["vanishing_points"].items.size(), 3U);
    for (int axis = 0; axis < 3; ++axis)
      expect_vanishing_point(view["vanishing_points"].items[axis], world_to_page[axis]);
    ASSERT_FALSE(view["segments"].items.empty());
    for (const Json& segment : view["segments"].items)
      ASSERT_NO_FATAL_FAILURE(expect_segment(segment, world_to_page, slack));
  }

  // All projectors pass through the viewer: rows 0, 1 and 3 send it to nothing. Towards it depth grows.
  void expect_viewer(const Json& view) const {
    const Mat4 m = matrix(view["world_to_page"]);
    const bool central = view["viewer"].keys() == "centre";
    const Vec3 viewer = vector<3>(view["viewer"][central ? "centre" : "direction"]);
    const Vec4 image = m * Vec4(viewer, central ? 1 : 0);
    const double size = glm::length(glm::transpose(m)[0]) * glm::length(viewer);
    for (const int row : {0, 1, 3}) EXPECT_NEAR(image[row], 0, 1e-11 * size) << row;

    const Vec3 point = placed(meshes_[0].point(meshes_[0].edges[0].vertex[0]));
    const Vec4 there = m * Vec4(point, 1);
    const Vec4 nearer = m * Vec4(point + 1e-3 * (central ? viewer - point : viewer), 1);
    EXPECT_GT(there.w, 0);
    EXPECT_GT(nearer.z / nearer.w, there.z / there.w);
  }

  static void expect_vanishing_point(const Json& point, const Vec4& image) {
    if (point.type == 'n') {
      EXPECT_NEAR(image.w, 0, 1e-12 * glm::length(image));
      return;
    }
    const Vec2 expected = Vec2(image) / image.w;
    EXPECT_LT(glm::distance(vector<2>(point), expected), tolerance_mm + 1e-12 * glm::length(expected));
  }

  void expect_segment(const Json& segment, const Mat4& world_to_page, double slack) const {
    static const std::set<std::string> kinds{"contour", "crease",  "boundary", "intersection",
                                             "section", "tangent", "smooth"};
    EXPECT_TRUE(segment["visible"].type == 't' || segment["visible"].type == 'f');
    EXPECT_TRUE(kinds.contains(segment["kind"].text)) << segment["kind"].text;
    const auto t = vector<2>(segment["t"]);
    EXPECT_TRUE(t[0] >= 0 && t[0] <= t[1] && t[1] <= 1) << t[0] << " " << t[1];
    const bool is_in_face = segment["edge"].type == 'n';
    const auto ends = is_in_face ? ends_in_faces(segment) : ends_of_edge(segment, t);
    // Contours that are moved run along each other, to where the surface has them.
    if (slack > tolerance_mm && segment["kind"].text == "contour" && !is_in_face)
      slack += length_of_edge(segment, world_to_page);
    ASSERT_LT(glm::distance(on_page(world_to_page, ends[0]), vector<2>(segment["from"])), slack);
    // A link leads from a point of the edge to ink within the distance at which lines are one.
    const bool is_link = t[0] == t[1];
    ASSERT_LT(glm::distance(on_page(world_to_page, ends[1]), vector<2>(segment["to"])), is_link ? slack + 0.2 : slack);
  }

  // Those of all segments, and then `more`.
  void expect_keys(const Json& segment, const std::string& more) const {
    const mesh::MeshReport& report = meshes_.at(static_cast<std::size_t>(segment["model"].number())).report;
    const bool named = !report.body_names.empty();
    EXPECT_EQ(segment.keys(), "from to visible kind model " + std::string(named ? "body " : "") + more);
    EXPECT_TRUE(!named || segment["body"].number() < report.bodies);
  }

  [[nodiscard]] std::array<Vec3, 2> ends_of_edge(const Json& segment, const Vec2& t) const {
    expect_keys(segment, "edge t");
    const mesh::Mesh& mesh = meshes_.at(static_cast<std::size_t>(segment["model"].number()));
    const auto edge = vector<2>(segment["edge"]);
    EXPECT_TRUE(edge[0] < edge[1] && edge[1] < mesh.report.vertices);
    const Vec3 a = placed(mesh.point(static_cast<int>(edge[0])));
    const Vec3 b = placed(mesh.point(static_cast<int>(edge[1])));
    return {a + t[0] * (b - a), a + t[1] * (b - a)};
  }

  [[nodiscard]] double length_of_edge(const Json& segment, const Mat4& world_to_page) const {
    const auto ends = ends_of_edge(segment, {0, 1});
    return glm::distance(on_page(world_to_page, ends[0]), on_page(world_to_page, ends[1]));
  }

  // Its ends stand there; they must lie in both faces that cross, or in that of which it is the contour. Contours are
  // on the surface, and there faces cross as it does.
  [[nodiscard]] std::array<Vec3, 2> ends_in_faces(const Json& segment) const {
    expect_keys(segment, "edge t faces world");
    EXPECT_EQ(segment["faces"].items.size(), segment["kind"].text == "contour" ? 1U : 2U);
    const std::array<Vec3, 2> ends{vector<3>(segment["world"].items.at(0)), vector<3>(segment["world"].items.at(1))};
    const Json& report = json_["report"];
    const bool is_refined = json_["views"].items[0].keys().find("contours_moved") != std::string::npos;
    const double scale = std::cbrt(std::abs(glm::determinant(Mat3(place_))));
    const double off = is_refined ? scale * report["tessellation"]["error"].number() : 0;
    for (const Json& face : segment["faces"].items)
      for (const Vec3& end : ends) EXPECT_LT(distance_to_face(vector<2>(face), end), 1e-6 + off);
    return ends;
  }

  // From the planes of the triangles of a face: of the nearest of them.
  [[nodiscard]] double distance_to_face(const Vec2& face, const Vec3& p) const {
    const mesh::Mesh& mesh = meshes_.at(static_cast<std::size_t>(face[0]));
    double nearest = HUGE_VAL;
    for (int f = 0; f < static_cast<int>(mesh.polygon.size()); ++f) {
      if (mesh.polygon[f] != static_cast<int>(face[1])) continue;
      std::array<Vec3, 3> c;
      for (int i = 0; i < 3; ++i) c[i] = placed(mesh.point(mesh.triangle(f)[i]));
      const Vec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
      nearest = std::min(nearest, std::abs(glm::dot(normal, p - c[0])) / glm::length(normal));
    }
    return nearest;
  }

  [[nodiscard]] Vec3 placed(const Vec3& p) const { return Vec3(place_ * Vec4(p, 1)); }

  Mat4 place_;
  std::vector<mesh::Mesh> meshes_;
  Json json_;
};

const std::vector<std::string>& models() {
  static const std::vector<std::string> names{"bearing.obj",  "bracket.obj", "cylinders.obj", "elbow.obj",
                                              "flange.obj",   "gear.stl",    "house.obj",     "shaft.obj",
                                              "sombrero.obj", "stairs.obj"};
  return names;
}

// An eye to the right, before and above the model, so near that the plane through its middle cuts it.
std::vector<std::string> look_at_with_near_plane(const std::string& model) {
  const mesh::Mesh mesh = mesh::read_mesh(sample(model));
  Box box;
  for (int v = 0; v < mesh.report.vertices; ++v) box.add(mesh.point(v));
  const double size = glm::length(box.size());
  const Vec3 eye = box.centre() + size * Vec3(0.7, -1, 0.5);
  std::string text;
  for (int i = 0; i < 3; ++i) text += (i == 0 ? "" : ",") + format_number(eye[i]);
  return {"--projection", "look-at:eye=" + text, "--near", format_number(glm::distance(eye, box.centre()))};
}

class EverySample : public testing::TestWithParam<std::string> {};

TEST_P(EverySample, IsFoundAgainOnThePage) {
  for (const char* projection : {"isometric", "front", "cavalier", "two-point"}) {
    SCOPED_TRACE(projection);
    JsonDrawing({{GetParam()}, {"--projection", projection}}).expect_all();
  }
}

TEST_P(EverySample, IsFoundAgainWhenCutByANearPlane) {
  JsonDrawing({{GetParam()}, look_at_with_near_plane(GetParam())}).expect_all();
}

INSTANTIATE_TEST_SUITE_P(Contract, EverySample, testing::ValuesIn(models()),
                         [](const auto& of) { return of.param.substr(0, of.param.find('.')); });

TEST(Contract, HoldsForPlacedModels) {
  // Inches, y up, and moved: (x, y, z) -> 25.4 (x, -z, y), turned by a quarter about z, shifted.
  const Mat4 place = rows({0, 0, 25.4, 7}, {25.4, 0, 0, -3}, {0, 25.4, 0, 11}, {0, 0, 0, 1});
  JsonDrawing(
      {{"bracket.obj", "cylinders.obj"},
       {"--unit", "in", "--up", "y", "--transform", "rotate:z,90 translate:7,-3,11", "--projection", "three-point"},
       place})
      .expect_all();
}

TEST(Contract, HoldsForSheetsScalesAndEdges) {
  JsonDrawing({{"cylinders.obj"}, {"--sheet", "none", "--edges", "contour,smooth,crease,boundary"}}).expect_all();
  JsonDrawing({{"bracket.obj"}, {"--sheet", "A0", "--portrait", "--scale", "3:1", "--hidden", "none"}}).expect_all();
  JsonDrawing({{"house.obj"}, {"--visibility", "none", "--projection", "one-point"}}).expect_all();
}

}  // namespace
}  // namespace epura::test::contract_test
