// SPDX-License-Identifier: Apache-2.0
#include "explain/hiders.hpp"

#include <gtest/gtest.h>

#include "explain/find_subjects.hpp"
#include "studied.hpp"

namespace epura::test::hiders_test {
namespace {

std::vector<explain::Occlusion> hiders_of(const Studied& studied, const explain::ByVertices& edge) {
  const explain::Subject subject = explain::find_subjects(studied.view(), edge).at(0);
  return explain::find_hiders(studied.view(), explain::TriangleBoxes(studied.result.view), subject.drawn);
}

TEST(Hiders, AreTheFacesInFrontWithTheirPartsNearestFirst) {
  // Over the lower edge of a plate 4 long: one plate over its second half, and higher up one over its middle half.
  const Studied studied =
      study(world_of({plate(0, 0, 4, 2, 0), plate(1, -2, 3, 1, 5), plate(2, -1, 6, 1, 2)}), from_above());
  const std::vector<explain::Occlusion> hiders = hiders_of(studied, {0, {0, 1}});
  ASSERT_EQ(hiders.size(), 2U);
  EXPECT_EQ(hiders[0].face, (explain::FaceName{2, 0}));
  EXPECT_NEAR(hiders[0].ahead, 2, 1e-12);
  ASSERT_EQ(hiders[0].parts.size(), 1U) << "both triangles of a face are one part";
  EXPECT_NEAR(hiders[0].parts[0][0], 0.5, 1e-9);
  EXPECT_EQ(hiders[0].parts[0][1], 1);
  EXPECT_EQ(hiders[1].face, (explain::FaceName{1, 0}));
  EXPECT_NEAR(hiders[1].ahead, 5, 1e-12);
  EXPECT_NEAR(hiders[1].parts.at(0)[0], 0.25, 1e-9);
  EXPECT_NEAR(hiders[1].parts.at(0)[1], 0.75, 1e-9);
  EXPECT_EQ(hiders_of(studied, {2, {0, 1}}).at(0).face, (explain::FaceName{1, 0}));
}

TEST(Hiders, DistanceIsMeasuredInTheWorldAlongTheLineOfSight) {
  // From an eye above the origin at height 10, a wall at height 6 hides the middle of an edge at height 2 and x = 8:
  // along the sight line (8, 0, -8) half of the way is behind the wall.
  const Studied studied = study(world_of({plate(8, -1, 9, 1, 2), plate(3.5, -9, 4.25, 9, 6)}),
                                perspective({0, 0, 10}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}));
  const std::vector<explain::Occlusion> hiders = hiders_of(studied, {0, {0, 3}});
  ASSERT_EQ(hiders.size(), 1U);
  EXPECT_NEAR(hiders[0].ahead, std::sqrt(32.0), 1e-9);
}

TEST(Hiders, TogetherHideWhatTheSearchFoundHidden) {
  Shape boxes;
  for (int i = 0; i < 12; ++i)
    boxes.add(box({i * 0.7, i % 5 * 0.3, i % 3 * 0.4}, {i * 0.7 + 1.1, i % 5 * 0.3 + 2, i % 3 * 0.4 + 1.5}));
  boxes.add(moebius(40).moved(2, -1, 1));
  for (const projection::Projection& projection :
       {orthographic({0.4, -1, 0.6}), perspective({3, -9, 4}, {3, 0, 1}, {0, -1, 0.2}, {0, 0, 1})}) {
    const Studied studied = study(world_of(boxes), projection);
    const explain::TriangleBoxes triangles(studied.result.view);
    const visibility::HiddenSpans& hidden = studied.result.hidden;
    ASSERT_FALSE(hidden.spans.empty());
    for (std::size_t e = 0; e < studied.result.drawn.edges.size(); ++e) {
      const edges::FeatureEdge& edge = studied.result.drawn.edges[e];
      visibility::Spans all;
      for (const explain::Occlusion& hider : explain::find_hiders(studied.view(), triangles, e))
        for (const auto& part : hider.parts) visibility::add_span(all, part);
      visibility::absorb_slivers(all, visibility::min_span(studied.result.view, {edge.vertex[0], edge.vertex[1]}));
      const visibility::Spans found(hidden.spans.begin() + hidden.first[e], hidden.spans.begin() + hidden.first[e + 1]);
      EXPECT_EQ(all, found) << "edge " << e;
    }
  }
}

TEST(TriangleBoxes, FindAllTrianglesThatMeetABoxAndNoOthers) {
  Shape plates;
  for (int i = 0; i < 300; ++i) plates.add(plate(i, 0, i + 0.5, 1, 0));
  const world::World world = world_of(plates);
  const view::ProjectedScene view = view::project_scene(world, from_above(), {});
  const explain::TriangleBoxes boxes(view);
  const double unit = view.map.normalisation;
  std::vector<int> met;
  const auto page = [&](double x) { return (x - 149.75) * unit; };
  boxes.meeting({{{page(99.6), page(101.1)}, {-unit, unit}}}, [&](int t) { met.push_back(view.triangles[t].source); });
  EXPECT_EQ(met, (std::vector<int>{200, 201, 202, 203}));
  met.clear();
  boxes.meeting({{{page(0), page(300)}, {2 * unit, 3 * unit}}}, [&](int t) { met.push_back(t); });
  EXPECT_TRUE(met.empty());
}

}  // namespace
}  // namespace epura::test::hiders_test
