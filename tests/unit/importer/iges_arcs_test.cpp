// SPDX-License-Identifier: Apache-2.0
// Circular and conic arcs of IGES files, however they lie and whatever mirrors them: of known points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "folder.hpp"
#include "support.hpp"

namespace epura::test::iges_arcs_test {
namespace {

struct Entity {
  int type, form;
  std::vector<double> values;
  int matrix = 0;  // the number of that entity, from 1
};

std::string column(int number) {
  const std::string digits = std::to_string(number);
  return std::string(8 - digits.size(), ' ') + digits;
}

// Fixed lines of 80 columns: sections S, G, D, P and T.
class IgesText {
 public:
  explicit IgesText(const std::vector<Entity>& entities) {
    add("", 'S');
    const std::string header =
        "1H,,1H;,4Hpart,8Hpart.igs,3Hown,3Hown,32,38,6,308,15,4Hpart,1.,2,2HMM,1,0.01,15H20261130.000000,1.E-6,100.,"
        "3Hown,3Hown,11,0,15H20261130.000000;";
    for (std::size_t at = 0; at < header.size(); at += 72) add(header.substr(at, 72), 'G');
    std::vector<std::string> parameters;
    for (const Entity& one : entities) {
      const int number = counts_[2] + 1, first = static_cast<int>(parameters.size()) + 1;
      std::string line = std::to_string(one.type) + ",";
      for (std::size_t i = 0; i < one.values.size(); ++i) {
        const std::string word = format_number(one.values[i]) + (i + 1 < one.values.size() ? "," : ";");
        if (line.size() + word.size() > 64) parameters.push_back(of_entity(std::exchange(line, ""), number));
        line += word;
      }
      parameters.push_back(of_entity(line, number));
      const std::string none = column(0), matrix = column(one.matrix > 0 ? 2 * one.matrix - 1 : 0);
      add(column(one.type) + column(first) + none + none + none + none + matrix + none + none, 'D');
      add(column(one.type) + none + none + column(static_cast<int>(parameters.size()) - first + 1) + column(one.form) +
              std::string(24, ' ') + none,
          'D');
    }
    for (const std::string& line : parameters) add(line, 'P');
    std::string end;
    for (int i = 0; i < 4; ++i) end += "SGDP"[i] + column(counts_[i]).substr(1);
    add(end, 'T');
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string of_entity(const std::string& values, int number) {
    return values + std::string(64 - values.size(), ' ') + column(number);
  }
  void add(const std::string& line, char section) {
    const std::size_t kind = std::string("SGDPT").find(section);
    text_ += line + std::string(72 - line.size(), ' ') + section + column(++counts_[kind]).substr(1) + "\n";
  }

  std::string text_;
  std::array<int, 5> counts_{};
};

struct Seen {
  Vec3 min{HUGE_VAL}, max{-HUGE_VAL};
  double length = 0;
};

Seen seen_of(const std::vector<Entity>& entities) {
  const Folder folder;
  const mesh::Mesh mesh = read_by_importer(folder.file("part.igs", IgesText(entities).text())).mesh;
  Seen seen;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const Vec3 a = mesh.point(edge.vertex[0]), b = mesh.point(edge.vertex[1]);
    seen.length += glm::distance(a, b);
    for (const Vec3& p : {a, b}) seen.min = glm::min(seen.min, p), seen.max = glm::max(seen.max, p);
  }
  return seen;
}

void expect_seen(const Seen& seen, const Vec3& min, const Vec3& max, double length) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(seen.min[k], min[k], 1e-9) << "axis " << k;
    EXPECT_NEAR(seen.max[k], max[k], 1e-9) << "axis " << k;
  }
  EXPECT_NEAR(seen.length, length, 2e-3 * length);
}

// Quarters of ellipses of 20 and 10, parabolas y2 = 20 x from the vertex, branches of x2 / 100 - y2 / 25 = 1 from it;
// each along x, and turned by quarters.
TEST(IgesArcs, ConicsLieAlongAnyAxis) {
  const double c = std::cosh(1), s = std::sinh(1), quarter = 24.2211, parabola = 29.5789, wing = 8.2697;
  struct Case {
    int form;
    std::vector<double> values;
    Vec3 min, max;
    double length;
  };
  const std::vector<Case> cases{
      {1, {1.0 / 400, 0, 0.01, 0, 0, -1, 0, 20, 0, 0, 10}, {0, 0, 0}, {20, 10, 0}, quarter},
      {1, {0.01, 0, 1.0 / 400, 0, 0, -1, 7, 10, 0, 0, 20}, {0, 0, 7}, {10, 20, 7}, quarter},
      {3, {0, 0, 1, -20, 0, 0, 0, 0, 0, 20, 20}, {0, 0, 0}, {20, 20, 0}, parabola},
      {3, {0, 0, 1, 20, 0, 0, 0, 0, 0, -20, 20}, {-20, 0, 0}, {0, 20, 0}, parabola},
      {3, {1, 0, 0, 0, -20, 0, 0, 0, 0, 20, 20}, {0, 0, 0}, {20, 20, 0}, parabola},
      {3, {1, 0, 0, 0, 20, 0, 0, 0, 0, 20, -20}, {0, -20, 0}, {20, 0, 0}, parabola},
      {2, {0.01, 0, -0.04, 0, 0, -1, 0, 10, 0, 10 * c, 5 * s}, {10, 0, 0}, {10 * c, 5 * s, 0}, wing},
      {2, {0.01, 0, -0.04, 0, 0, -1, 0, -10, 0, -10 * c, 5 * s}, {-10 * c, 0, 0}, {-10, 5 * s, 0}, wing},
      {2, {-0.04, 0, 0.01, 0, 0, -1, 0, 0, 10, 5 * s, 10 * c}, {0, 10, 0}, {5 * s, 10 * c, 0}, wing}};
  for (const Case& one : cases) {
    SCOPED_TRACE(format_number(one.values[0]) + " " + format_number(one.values[2]) + " of form " +
                 std::to_string(one.form));
    expect_seen(seen_of({{104, one.form, one.values}}), one.min, one.max, one.length);
  }
}

// A quarter of a circle above the plane, and one of an ellipse along y.
TEST(IgesArcs, MatricesMirrorThem) {
  const std::vector<std::pair<Entity, Vec3>> arcs{
      {{100, 0, {3, 0, 0, 10, 0, 0, 10}, 2}, {10, 10, 3}},
      {{104, 1, {0.01, 0, 1.0 / 400, 0, 0, -1, 3, 10, 0, 0, 20}, 2}, {10, 20, 3}}};
  for (const auto& [arc, size] : arcs)
    for (const Vec3& way : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1), Vec3(-1, -1, -1)}) {
      Entity placed = arc;
      placed.matrix = 1;
      const int form = way.x * way.y * way.z < 0 ? 1 : 0;
      const Entity matrix{124, form, {way.x, 0, 0, 5, 0, way.y, 0, 6, 0, 0, way.z, 7}};
      const Vec3 start = Vec3(5, 6, 7) + way * Vec3(size.x, 0, size.z),
                 end = Vec3(5, 6, 7) + way * Vec3(0, size.y, size.z);
      SCOPED_TRACE(std::to_string(arc.type) + " by " + format_number(way.x) + format_number(way.y) +
                   format_number(way.z));
      expect_seen(seen_of({matrix, placed}), glm::min(start, end), glm::max(start, end),
                  arc.type == 100 ? 5 * std::numbers::pi : 24.2211);
    }
}

// A quarter of an ellipse along y, and its chord, which one matrix turns by a quarter about z, and the next one mirrors
// and moves.
TEST(IgesArcs, MatricesReferToMatrices) {
  for (const double way : {1.0, -1.0}) {
    const Entity outer{124, way < 0 ? 1 : 0, {way, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}};
    const Entity inner{124, 0, {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}, 1};
    const Entity arc{104, 1, {0.01, 0, 1.0 / 400, 0, 0, -1, 3, 10, 0, 0, 20}, 2};
    const Vec3 start(5, 16, 10), end(5 - 20 * way, 6, 10);
    SCOPED_TRACE(way);
    expect_seen(seen_of({outer, inner, arc}), glm::min(start, end), glm::max(start, end), 24.2211);
    const Entity line{110, 0, {10, 0, 3, 0, 20, 3}, 2};
    expect_seen(seen_of({outer, inner, line}), glm::min(start, end), glm::max(start, end), std::sqrt(500.0));
  }
}

}  // namespace
}  // namespace epura::test::iges_arcs_test
