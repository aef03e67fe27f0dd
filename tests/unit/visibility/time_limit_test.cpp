// What stays undecided when time is over is left out; what is decided is as without a limit.
#include <gtest/gtest.h>

#include <numeric>

#include "edges/suspects.hpp"
#include "shapes.hpp"

namespace epura::test {
namespace {

// Boxes one behind another: many edges, most of them hidden in part.
Result row_of_boxes() {
  std::vector<Shape> boxes;
  for (int i = 0; i < 40; ++i) boxes.push_back(box({0, 0, 0}, {1, 1, 1}).moved(0.3 * i, -2.0 * i, 0.1 * i));
  return draw(world_of(boxes), orthographic({1, -1, 1}));
}

HiddenSpans hidden_within(const Result& r, double time_limit) {
  ProgressBoard board;
  return find_hidden(r.world, r.view, r.drawn, contact_of(r.world, r.view, std::nullopt), Progress(board, time_limit));
}

TEST(TimeLimit, WithTimeEnoughNothingChanges) {
  const Result r = row_of_boxes();
  ASSERT_FALSE(r.hidden.spans.empty());
  const HiddenSpans limited = hidden_within(r, 1000);
  EXPECT_TRUE(limited.undecided.empty());
  EXPECT_EQ(limited.first, r.hidden.first);
  EXPECT_EQ(limited.spans, r.hidden.spans);
}

TEST(TimeLimit, WithoutTimeNothingIsDecided) {
  const Result r = row_of_boxes();
  const HiddenSpans limited = hidden_within(r, 0);
  std::vector<int> all(r.drawn.edges.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(limited.undecided, all);
}

TEST(TimeLimit, TheBoardSeesEveryEdge) {
  const Result r = row_of_boxes();
  ProgressBoard board;
  find_hidden(r.world, r.view, r.drawn, contact_of(r.world, r.view, std::nullopt), Progress(board));
  EXPECT_EQ(board.standing().work, r.drawn.edges.size());
  EXPECT_EQ(board.standing().done, r.drawn.edges.size());
}

TEST(TimeLimit, DecidedEdgesKeepTheirSpans) {
  const Result r = row_of_boxes();
  DrawnEdges drawn = r.drawn;
  HiddenSpans hidden = r.hidden;
  // As if every third edge had not been reached: it has no spans.
  hidden.spans.clear();
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    if (e % 3 == 0)
      hidden.undecided.push_back(static_cast<int>(e));
    else
      for (std::size_t i = r.hidden.first[e]; i < r.hidden.first[e + 1]; ++i) hidden.spans.push_back(r.hidden.spans[i]);
    hidden.first[e + 1] = hidden.spans.size();
  }
  keep_decided(drawn, hidden);
  EXPECT_TRUE(hidden.undecided.empty());
  ASSERT_EQ(hidden.first.size(), drawn.edges.size() + 1);
  std::size_t kept = 0;
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e) {
    if (e % 3 == 0) continue;
    EXPECT_EQ(drawn.edges[kept].vertex, r.drawn.edges[e].vertex);
    const std::size_t count = r.hidden.first[e + 1] - r.hidden.first[e];
    ASSERT_EQ(hidden.first[kept + 1] - hidden.first[kept], count);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(hidden.spans[hidden.first[kept] + i], r.hidden.spans[r.hidden.first[e] + i]);
    ++kept;
  }
  EXPECT_EQ(kept, drawn.edges.size());
}

TEST(TimeLimit, TheSearchForIntersectionsTellsHowFarItCame) {
  const World world = world_of({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {2, 2, 2})});
  ProgressBoard board;
  const FaceCrossings all = find_intersections(world, 1, 1e-9, all_triangles(world), Progress(board, 1000));
  EXPECT_EQ(all.searched, 1);
  EXPECT_FALSE(all.found.empty());
  const FaceCrossings none = find_intersections(world, 1, 1e-9, all_triangles(world), Progress(board, 0));
  EXPECT_EQ(none.searched, 0);
  EXPECT_TRUE(none.found.empty());
}

}  // namespace
}  // namespace epura::test
