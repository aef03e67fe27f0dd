// SPDX-License-Identifier: Apache-2.0
#include "explain/find_subjects.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "studied.hpp"

namespace epura::test::find_subjects_test {
namespace {

TEST(EdgeQuestion, NamesVerticesFacesOrAPlace) {
  const auto edge = std::get<explain::ByVertices>(explain::parse_edge_question("2:7-3"));
  EXPECT_EQ(edge.model, 2);
  EXPECT_EQ(edge.vertex, (std::array{3, 7})) << "in either order";
  EXPECT_EQ(std::get<explain::ByVertices>(explain::parse_edge_question("3-7")).model, 0);
  const auto line = std::get<explain::ByFaces>(explain::parse_edge_question("0:12x1:4"));
  EXPECT_EQ(line.faces[0], (explain::FaceName{0, 12}));
  EXPECT_EQ(line.faces[1], (explain::FaceName{1, 4}));
  EXPECT_EQ(std::get<explain::ByPlace>(explain::parse_edge_question("@12.5,-3")).place, Vec2(12.5, -3));
}

TEST(EdgeQuestion, RefusesEverythingElse) {
  for (const char* text : {"", "3", "3-", "-3", "3--7", "a-b", "0:1:2-3", "-1:2-3", "1.5-2", "0:1x2", "0:1x1:2x2:3",
                           "@", "@1", "@1,2,3", "@nan,1", "@inf,1", "99999999999-1"}) {
    const Error error = error_of([&] { explain::parse_edge_question(text); });
    EXPECT_TRUE(contains(error.what(), "does not name an edge")) << text;
    EXPECT_TRUE(contains(error.hint(), "@X,Y"));
  }
}

TEST(Subjects, NearestToAPlaceOfThePage) {
  const Studied studied = study(world_of(plate(0, 0, 4, 2, 0)), from_above());
  const explain::ExplainInput view = studied.view();
  // The page starts from the middle (2, 1), in view units; a place near the lower edge, to the right.
  const Vec2 place = Vec2(1.5, -0.9) * studied.result.view.map.normalisation;
  const std::vector<explain::Subject> subjects = explain::find_subjects(view, explain::ByPlace{place});
  ASSERT_EQ(subjects.size(), 3U);
  EXPECT_EQ(explain::name_of(view, subjects[0]), "0:0-1");
  EXPECT_EQ(explain::name_of(view, subjects[1]), "0:1-2");
  EXPECT_EQ(explain::name_of(view, subjects[2]), "0:2-3");
}

TEST(Subjects, ThatDoNotExistAreAnErrorWithWhatThereIs) {
  const Studied studied = study(world_of(box({0, 0, 0}, {1, 1, 1})), from_above());
  const auto error = [&](const explain::EdgeQuestion& question) {
    return error_of([&] { explain::find_subjects(studied.view(), question); });
  };
  EXPECT_TRUE(contains(error(explain::ByVertices{1, {0, 1}}).what(), "there is no model 1"));
  EXPECT_TRUE(contains(error(explain::ByVertices{0, {0, 8}}).what(), "has no vertex 8"));
  EXPECT_EQ(error(explain::ByVertices{0, {0, 8}}).hint(), "its vertices are numbered from 0 to 7");
  const Error no_edge = error(explain::ByVertices{0, {0, 7}});
  EXPECT_TRUE(contains(no_edge.what(), "connects vertices 0 and 7"));
  EXPECT_EQ(no_edge.hint().substr(0, 24), "edges at 0: 0-1 0-2 0-3 ");
  EXPECT_TRUE(contains(no_edge.hint(), "; edges at 7: "));
  EXPECT_TRUE(contains(error(explain::ByFaces{{explain::FaceName{0, 0}, explain::FaceName{0, 1}}}).what(),
                       "no intersection line"));
}

}  // namespace
}  // namespace epura::test::find_subjects_test
