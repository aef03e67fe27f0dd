// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: the error that a drawing states. It is compared with distances from closed
// forms, which share nothing with the stages.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "study/paper/convergence.hpp"

namespace epura::study::paper_test {
namespace {

const PaperStudy laboratory{{EPURA_TEST_PLUGINS}, 2048};

class Paper : public testing::TestWithParam<std::size_t> {
 protected:
  const PaperScene form = scene_of(closed_forms()[GetParam()]);
};

// Neither is any line farther than stated, nor is the statement so large that it says nothing.
TEST_P(Paper, LinesAreWithinTheStatedError) {
  for (const PaperWay way : {PaperWay::recognised, PaperWay::triangles, PaperWay::arcs})
    for (int around : {16, 48}) {
      around = std::max(around, form.coarsest);
      const PaperRun run = draw_on_paper(form, around, way, laboratory);
      EXPECT_LE(run.error.ink(), run.error.budget.total()) << paper_ways[static_cast<std::size_t>(way)] << around;
      EXPECT_GT(run.error.ink(), 0);
      if (way == PaperWay::arcs) continue;  // far better than estimates
      // Where facets alone tell where a contour ends, coarse ones are off by a part of a facet.
      const double at_most = form.has_cusps && around < 48 ? 25 : 5;
      EXPECT_LE(run.error.budget.total(), at_most * run.error.ink())
          << paper_ways[static_cast<std::size_t>(way)] << around;
    }
}

// The outline of a recognised ball is a circle in closed form, however coarse its mesh is.
TEST(PaperArcs, AreOnTheSurfaceOfABall) {
  const PaperScene form = scene_of(closed_forms().front());
  ASSERT_EQ(form.name, "sphere");
  EXPECT_LT(draw_on_paper(form, 12, PaperWay::arcs, laboratory).error.ink(), 1e-3);
}

// Their contours end in cusps and behind each other, some of them where facets alone tell.
TEST(PaperTori, AreWithinTheStatedErrorInOtherViews) {
  struct Row {
    double tube;
    const char* direction;
    int around;
  };
  for (const auto& [tube, direction, around] : {Row{3, "1,-1,0.3", 12},
                                                {6, "0.2,-1,0.6", 48},
                                                {8, "0.2,-1,0.6", 16},
                                                {12, "0.3,-1,0.45", 12},
                                                {15, "1,-1,1", 32}}) {
    ClosedForm form{.name = "torus",
                    .projection = std::string("auxiliary:direction=") + direction,
                    .bodies = {{.kind = RoundBody::Kind::torus, .radius = 20, .tube = tube}}};
    const PaperRun run = draw_on_paper(scene_of(form), around, PaperWay::recognised, laboratory);
    EXPECT_LE(run.error.ink(), run.error.budget.total()) << tube << ' ' << direction;
  }
}

// Twice as many facets around have a quarter of the error. At a cusp, they do not.
TEST_P(Paper, ErrorsFallWithTheSquareOfTheFacets) {
  PaperSeries series{form.name, paper_ways[1]};
  for (const int around : {48, 96}) series.runs.push_back(draw_on_paper(form, around, PaperWay::triangles, laboratory));
  EXPECT_GT(series.order(), form.has_cusps ? 0.7 : 1.8);
  EXPECT_LT(series.order(), 2.5);
}

TEST_P(Paper, MaxErrorIsKeptOrRefused) {
  int kept = 0, refused = 0;
  for (const int around : {16, 256}) {
    const double allowed = 0.2;
    try {
      EXPECT_LE(draw_on_paper(form, around, PaperWay::recognised, laboratory, allowed).error.ink(), allowed);
      ++kept;
    } catch (const Error& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("--max-error"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_EQ(kept + refused, 2);
}

// Planted: a body that is 2 % larger than its mesh, and a budget that forgets what facets do.
TEST_P(Paper, ViolationsAreFound) {
  ClosedForm larger = closed_forms()[GetParam()];
  for (RoundBody& body : larger.bodies) body.radius *= 1.02, body.top *= 1.02, body.tube *= 1.02;
  const PaperRun wrong = compare_on_paper(form, scene_of(larger), 64, PaperWay::recognised, laboratory);
  EXPECT_GT(wrong.error.ink(), wrong.error.budget.total());
  EXPECT_GT(wrong.error.missed + wrong.error.phantom, 0);
  const PaperRun right = draw_on_paper(form, 64, PaperWay::recognised, laboratory);
  report::ViewError forgetful = right.error.budget;
  using report::ErrorTerm;
  for (const ErrorTerm term : {ErrorTerm::surface, ErrorTerm::intersections, ErrorTerm::contours}) forgetful[term] = 0;
  EXPECT_GT(right.error.ink(), forgetful.total());
}

INSTANTIATE_TEST_SUITE_P(ClosedForms, Paper, testing::Range<std::size_t>(0, closed_forms().size()));

}  // namespace
}  // namespace epura::study::paper_test
