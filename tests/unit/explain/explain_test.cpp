// SPDX-License-Identifier: Apache-2.0
#include "explain/explain.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "errors.hpp"
#include "explain/find_subjects.hpp"
#include "mesh/read.hpp"
#include "skewed_torus.hpp"
#include "studied.hpp"

namespace epura::test::explain_test {
namespace {

std::string story(const explain::ExplainInput& view, const explain::EdgeQuestion& question) {
  return explain::explain(view, explain::TriangleBoxes(view.view), explain::find_subjects(view, question).at(0));
}

TEST(Explain, NamesSpansAndWhatHidesThem) {
  const Studied studied = study(world_of({plate(0, 0, 4, 2, 0), plate(1, -1, 3, 1, 5)}), from_above());
  const std::string text = story(studied.view(), explain::ByVertices{0, {0, 1}});
  EXPECT_TRUE(text.starts_with("0:0-1 of shape, (0, 0, 0) to (4, 0, 0)\n  drawn as boundary: ")) << text;
  EXPECT_TRUE(contains(text, "\n  visible t 0 to 0.25, ")) << text;
  EXPECT_TRUE(contains(text, "\n  hidden  t 0.25 to 0.75, ")) << text;
  EXPECT_TRUE(contains(text, "\n    by face 1:0 of shape, 5 in front, t 0.25 to 0.75\n")) << text;
  EXPECT_TRUE(contains(text, "\n  visible t 0.75 to 1, ")) << text;
  EXPECT_FALSE(contains(text, "no ink")) << text;
}

TEST(Explain, NamesBodies) {
  const std::string plates =
      "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 1 -1 5\nv 3 -1 5\nv 3 1 5\nv 1 1 5\n"
      "o base\nf 1 2 3 4\no lid\nf 5 6 7 8\n";
  world::Placed model;
  model.mesh = std::make_shared<const mesh::Mesh>(mesh::make_mesh(mesh::read_obj(plates, "plates"), "plates.obj"));
  const Studied studied = study(world::make_world({model}), from_above());
  const std::string text = story(studied.view(), explain::ByVertices{0, {0, 1}});
  EXPECT_TRUE(text.starts_with("0:0-1 of 'base' in plates.obj, ")) << text;
  EXPECT_TRUE(contains(text, "by face 0:1 of 'lid' in plates.obj, 5 in front")) << text;
}

TEST(Explain, TellsWhatOnlyFacetsHide) {
  const Studied studied = study(recognised(world_of(torus(24, 60, 0.3))), orthographic({1, -1, 1}));
  const auto& by_facets = studied.view().hidden.by_facets;
  ASSERT_FALSE(by_facets.empty());
  const edges::FeatureEdge& edge = studied.view().drawn.edges[by_facets[0].edge];
  const auto& ends = studied.view().world.models[0].mesh->edges[edge.mesh_edge].vertex;
  const std::string text = story(studied.view(), explain::ByVertices{0, ends});
  EXPECT_TRUE(contains(text, "only facets of its own face, whose surface does not, hide t ")) << text;
}

TEST(Explain, CountsWhatItDoesNotName) {
  std::vector<Shape> stack;
  for (int i = 0; i < 8; ++i) stack.push_back(plate(-i, -i, 1 + i, 1 + i, i));
  const Studied studied = study(world_of(stack), from_above());
  const std::string text = story(studied.view(), explain::ByVertices{0, {0, 1}});
  EXPECT_TRUE(contains(text, "by face 5:0 of shape, 5 in front")) << text;
  EXPECT_FALSE(contains(text, "by face 6:0")) << text;
  EXPECT_TRUE(contains(text, "\n    and by 2 more\n")) << text;
}

TEST(Explain, SaysWhoseInkLiesOnAnEdge) {
  // Seen from above, the lower rim of a box lies under the upper one; of equal lines the earlier edge has the ink.
  const Studied studied = study(world_of(box({0, 0, 0}, {1, 1, 1})), from_above());
  const std::string lower = story(studied.view(), explain::ByVertices{0, {0, 1}});
  const std::string upper = story(studied.view(), explain::ByVertices{0, {4, 5}});
  EXPECT_NE(contains(lower, "no ink"), contains(upper, "no ink")) << lower << upper;
  EXPECT_TRUE(contains(lower + upper, ": visible contour 0:")) << lower << upper;
  EXPECT_TRUE(contains(story(studied.view(), explain::ByVertices{0, {0, 4}}), "no ink: a point on the sheet"));
}

TEST(Explain, SaysThatHiddenLinesAreNotWanted) {
  const Studied studied = study(world_of({plate(0, 0, 4, 2, 0), plate(1, -1, 3, 1, 5)}), from_above());
  explain::ExplainInput view{studied.view()};
  view.keep_hidden = false;
  EXPECT_TRUE(contains(story(view, explain::ByVertices{0, {0, 1}}), "no ink: hidden lines are switched off"));
}

}  // namespace
}  // namespace epura::test::explain_test
