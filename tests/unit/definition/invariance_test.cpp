// SPDX-License-Identifier: Apache-2.0
// The order of faces, the unit and the place of a part in space change nothing; and ranks are those of exact
// arithmetic.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <random>

#include "made_parts.hpp"

namespace epura::definition::invariance_test {

namespace {

const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

// A block with a slope, a bore and a step, whose dimensions leave four motions.
Part block() {
  Part part = box({60, 40, 10});
  for (const Face& face : {plane({55, 20, 8}, {1, 0, 1.5}, 300), cylinder({20, 15, 5}, z, 4, 250),
                           plane({12, 20, 8}, x, 70), plane({6, 20, 6}, z, 400)})
    part.faces.push_back(face);
  return part;
}

// `place` is that of each face among those of block().
std::vector<std::string> words_of(const Part& part, const std::vector<int>& place, const Marks& marks = {}) {
  MadeSheet sheet(part, marks);
  const auto at = [&](int face) { return place[static_cast<std::size_t>(face)]; };
  sheet.distance(at(left), at(right), at(left)).distance(at(front), at(back), at(front));
  sheet.distance(at(bottom), at(top), at(bottom))
      .distance(at(left), at(7), at(left))
      .distance(at(left), at(8), at(left));
  std::vector<std::string> sentences = sheet.sentences();
  std::sort(sentences.begin(), sentences.end());
  return sentences;
}

std::vector<int> in_order(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

Part moved_part(Part part, const Mat4& transform, double scale) {
  for (Face& face : part.faces) {
    face.surface = surfaces::moved(face.surface, transform, scale);
    face.at = Vec3(transform * Vec4(face.at, 1));
    face.area *= scale * scale;
  }
  part.size *= scale;
  return part;
}

// Planes in rational numbers: normals of length 1, and distances from the origin.
struct ExactPlane {
  std::array<mpq_class, 3> normal;
  mpq_class at;
};

using ExactRow = std::vector<mpq_class>;

int rank_of(std::vector<ExactRow> rows) {
  int rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    const auto first = rows.begin() + rank;
    const auto pivot = std::find_if(first, rows.end(), [&](const ExactRow& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(*first, *pivot);
    for (auto row = first + 1; row != rows.end(); ++row) {
      const mpq_class factor = (*row)[column] / (*first)[column];
      for (std::size_t i = column; factor != 0 && i < row->size(); ++i) (*row)[i] -= factor * (*first)[i];
    }
    if (++rank == static_cast<int>(rows.size())) break;
  }
  return rank;
}

// Of unknowns n.x, n.y, n.z and n·p of each plane.
class ExactSheet {
 public:
  explicit ExactSheet(std::vector<ExactPlane> all) : planes(std::move(all)) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      ExactRow unit = none();
      for (std::size_t axis = 0; axis < 3; ++axis) unit[4 * i + axis] = planes[i].normal[axis];
      rows.push_back(unit);
      for (std::size_t j = 0; j < i; ++j) relate(i, j);
    }
  }
  // Opposite normals count offsets to opposite sides.
  void hold_distance(std::size_t i, std::size_t j) {
    ExactRow row = none();
    row[4 * i + 3] = 1;
    row[4 * j + 3] = -cosine(i, j);
    rows.push_back(row);
  }
  [[nodiscard]] mpq_class cosine(std::size_t i, std::size_t j) const {
    mpq_class sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += planes[i].normal[axis] * planes[j].normal[axis];
    return sum;
  }
  [[nodiscard]] int free() const { return static_cast<int>(4 * planes.size()) - rank_of(rows) - 6; }

  std::vector<ExactPlane> planes;
  std::vector<ExactRow> rows;

 private:
  [[nodiscard]] ExactRow none() const { return ExactRow(4 * planes.size()); }
  void relate(std::size_t i, std::size_t j) {
    const mpq_class c = cosine(i, j);
    if (c == 0) {
      ExactRow row = none();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        row[4 * i + axis] = planes[j].normal[axis];
        row[4 * j + axis] = planes[i].normal[axis];
      }
      rows.push_back(row);
    }
    if (c != 1 && c != -1) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ExactRow row = none();
      row[4 * i + axis] = 1;
      row[4 * j + axis] = -c;
      rows.push_back(row);
    }
    if (planes[i].at == c * planes[j].at) hold_distance(i, j);
  }
};

// Three faces along the axes, and others by lot.
std::vector<ExactPlane> planes_by_lot(std::mt19937& lot) {
  const std::vector<std::array<mpq_class, 3>> normals{{1, 0, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {mpq_class(3, 5), 0, mpq_class(4, 5)},
                                                      {mpq_class(-4, 5), 0, mpq_class(3, 5)},
                                                      {0, mpq_class(5, 13), mpq_class(12, 13)},
                                                      {mpq_class(2, 3), mpq_class(1, 3), mpq_class(2, 3)}};
  std::vector<ExactPlane> planes{{normals[0], 0}, {normals[1], 0}, {normals[2], 0}};
  for (int i = 0; i < 12; ++i) {
    ExactPlane plane{normals[lot() % normals.size()], static_cast<int>(lot() % 9) - 4};
    if (lot() % 2 == 0)
      for (mpq_class& value : plane.normal) value = -value;
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace

TEST(DefinitionInvariance, The_order_of_faces_does_not_matter) {
  const Part part = block();
  const std::vector<std::string> words = words_of(part, in_order(part.faces.size()));
  ASSERT_EQ(words.size(), 5U);
  std::mt19937 lot(7);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<int> order = in_order(part.faces.size()), place = order;
    std::shuffle(order.begin(), order.end(), lot);
    Part other = part;
    for (std::size_t i = 0; i < order.size(); ++i) {
      other.faces[i] = part.faces[static_cast<std::size_t>(order[i])];
      place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    }
    EXPECT_EQ(words_of(other, place), words);
  }
}

TEST(DefinitionInvariance, Neither_the_unit_nor_the_place_matters) {
  const Part part = block();
  const std::size_t motions = words_of(part, in_order(part.faces.size())).size();
  for (const double scale : {1e-3, 25.4, 1e4}) {
    Mat4 transform =
        glm::rotate(glm::translate(Mat4(1), Vec3(300, -20, 7) * scale), 0.7, glm::normalize(Vec3(1, 2, 3)));
    Marks marks;
    for (Vec3& axis : marks.axes) axis = Vec3(transform * Vec4(axis, 0));
    transform = glm::scale(transform, Vec3(scale));
    const Part other = moved_part(part, transform, scale);
    EXPECT_EQ(words_of(other, in_order(part.faces.size()), marks).size(), motions);
    EXPECT_EQ(MadeSheet(other, marks).needed(), MadeSheet(part).needed());
  }
}

TEST(DefinitionInvariance, Ranks_are_those_of_exact_arithmetic) {
  std::mt19937 lot(11);
  for (int trial = 0; trial < 60; ++trial) {
    ExactSheet exact(planes_by_lot(lot));
    Part part{{}, {}, 20};
    for (const ExactPlane& one : exact.planes) {
      const Vec3 normal(one.normal[0].get_d(), one.normal[1].get_d(), one.normal[2].get_d());
      part.faces.push_back(plane(one.at.get_d() * normal, normal, static_cast<double>(1 + lot() % 50)));
    }
    MadeSheet sheet(part);
    EXPECT_EQ(sheet.needed(), exact.free());
    for (std::size_t i = 0; i < exact.planes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const mpq_class c = exact.cosine(i, j); (c == 1 || c == -1) && lot() % 3 == 0) {
          exact.hold_distance(i, j);
          sheet.distance(static_cast<int>(i), static_cast<int>(j), static_cast<int>(i));
        }
    const Account account = sheet.account();
    EXPECT_EQ(static_cast<int>(account.motions.size()), exact.free()) << "trial " << trial;
    EXPECT_TRUE(account.is_certain);
    // Each dimension either holds a motion or says what others say.
    EXPECT_EQ(account.repeated.size(),
              sheet.dimensions.size() + account.motions.size() - static_cast<std::size_t>(account.needed));
  }
}

}  // namespace epura::definition::invariance_test
