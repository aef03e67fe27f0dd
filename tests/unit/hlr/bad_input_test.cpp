// SPDX-License-Identifier: Apache-2.0
// Whatever is wrong is refused by name, and nothing grows from call to call.
#include <malloc.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "shapes.hpp"

namespace epura::test::bad_input_test {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

class BadHlrInput : public testing::Test {
 protected:
  BadHlrInput() {
    add_box(box_, {1, 2, 3});
    box_.finish();
  }

  // Expects that drawing fails at a place.
  void expect_refused(const epura_hlr_request& request, const std::string& place, int code = EPURA_HLR_INPUT) const {
    epura_hlr_error error = no_error();
    const Drawing drawing(epura_hlr_draw(box_.model.get(), &request, &error));
    EXPECT_EQ(drawing, nullptr);
    EXPECT_EQ(error.code, static_cast<std::uint32_t>(code)) << error.reason;
    EXPECT_EQ(std::string(error.place), place) << error.reason;
    EXPECT_NE(std::string(error.reason), "");
  }

  const HlrModel box_;
};

TEST_F(BadHlrInput, OfTheModelFailsAtItsEnd) {
  const auto finish = [](const HlrModel& model) {
    epura_hlr_error error = no_error();
    EXPECT_EQ(epura_hlr_finish(model.model.get(), nullptr, &error), EPURA_HLR_INPUT);
    return std::string(error.place) + ": " + error.reason;
  };
  {
    const HlrModel model;
    EXPECT_EQ(finish(model), "model: holds no faces");
  }
  {
    const HlrModel model;
    const double point[]{0, 0, 0};
    EXPECT_NE(model.sink->points(model.sink->host, 1, point), 0);
    EXPECT_EQ(finish(model), "sink: a call hands over a part of a shape before any shape");
  }
  {
    const HlrModel model;
    model.shape("part");
    model.points({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::uint64_t end = 3;
    const std::uint32_t corners[]{0, 1, 3};
    EXPECT_NE(model.sink->polygons(model.sink->host, 1, &end, corners), 0);
    EXPECT_NE(finish(model).find("a corner that is no point of the shape"), std::string::npos);
  }
  {
    const HlrModel model;
    model.shape("part");
    EXPECT_NE(model.sink->points(model.sink->host, 3, nullptr), 0);
    EXPECT_EQ(finish(model), "sink: a call hands over no points where it says so");
  }
  {
    const HlrModel model;
    add_box(model, {1, 2, 3});
    epura_node node{};
    node.size = sizeof node;
    node.parent = EPURA_NONE;
    node.shape = 1;
    EXPECT_EQ(model.sink->node(model.sink->host, &node), 0);
    EXPECT_EQ(finish(model), "sink: a call hands over a node of a shape that none begins");
  }
  {
    const HlrModel model;
    model.shape("part");
    model.points({0, 0, 0, 1, 0, 0, 0, 1, nan_value});
    model.polygon({0, 1, 2});
    EXPECT_EQ(finish(model), "model: none of its faces can be drawn: 1 with coordinates that are not finite");
  }
  {
    const HlrModel model;
    model.shape("part");
    model.points({0, 0, 0, 1e300, 0, 0, 0, 1, 0});
    model.polygon({0, 1, 2});
    EXPECT_NE(finish(model).find("model"), std::string::npos);
  }
}

TEST_F(BadHlrInput, OfTheRequestIsNamed) {
  epura_hlr_request request = request_for(isometric);
  request.matrix = nullptr;
  expect_refused(request, "request");
  const epura_view view{};
  request = request_for(isometric);
  request.view = &view;
  expect_refused(request, "request");
  request.matrix = nullptr;
  expect_refused(request, "view");
  request = request_for(isometric);
  request.size = 8;
  expect_refused(request, "request");
  request = request_for(isometric);
  request.kinds = 1U << 20;
  expect_refused(request, "kinds");
  for (const auto& [member, place] :
       {std::pair(&epura_hlr_request::crease_angle, "crease_angle"), std::pair(&epura_hlr_request::scale, "scale"),
        std::pair(&epura_hlr_request::join_within, "join_within"), std::pair(&epura_hlr_request::arcs, "arcs")})
    for (const double value : {-1.0, nan_value, std::numeric_limits<double>::infinity()}) {
      request = request_for(isometric);
      request.*member = value;
      expect_refused(request, place);
    }
  std::array matrix = isometric;
  matrix[5] = nan_value;
  expect_refused(request_for(matrix), "matrix");
}

TEST_F(BadHlrInput, OfAProjectionIsNamed) {
  epura_projection row{};
  row.size = sizeof row;
  row.project = [](const double*, const epura_scene*, epura_view*) -> const char* { return "no such height"; };
  epura_hlr_request request{};
  request.size = sizeof request;
  request.projection = &row;
  expect_refused(request, "values");
  row.project = [](const double*, const epura_scene*, epura_view*) -> const char* { return nullptr; };
  expect_refused(request, "projection");
  row.project = [](const double*, const epura_scene*, epura_view*) -> const char* { throw std::runtime_error("no"); };
  expect_refused(request, "projection", EPURA_HLR_PLUGIN);
  row.project = nullptr;
  expect_refused(request, "projection");
}

TEST_F(BadHlrInput, OfTheOrderOfCallsIsNamed) {
  EXPECT_EQ(epura_hlr_model_new(EPURA_HLR_VERSION + 1), nullptr);
  EXPECT_EQ(epura_hlr_sink(nullptr), nullptr);
  EXPECT_NE(box_.sink->shape(box_.sink->host, "late"), 0) << "it is finished";
  EXPECT_EQ(epura_hlr_finish(nullptr, nullptr, nullptr), EPURA_HLR_INPUT);
  EXPECT_EQ(epura_hlr_finish(box_.model.get(), nullptr, nullptr), EPURA_HLR_INPUT);
  EXPECT_EQ(epura_hlr_draw(box_.model.get(), nullptr, nullptr), nullptr);
  EXPECT_EQ(epura_hlr_result_of(nullptr), nullptr);
  epura_hlr_model_free(nullptr);
  epura_hlr_drawing_free(nullptr);
  const HlrModel empty;
  epura_hlr_error error = no_error();
  const epura_hlr_request request = request_for(isometric);
  EXPECT_EQ(epura_hlr_draw(empty.model.get(), &request, &error), nullptr);
  EXPECT_EQ(std::string(error.reason), "is not finished");
}

TEST_F(BadHlrInput, IsNotACallThatWasStopped) {
  epura_hlr_request request = request_for(isometric);
  request.progress = [](void*, const char*, double) { return 1; };
  expect_refused(request, "progress", EPURA_HLR_STOPPED);
  request.progress = [](void*, const char*, double) -> int { throw std::runtime_error("no"); };
  expect_refused(request, "progress");
  request.progress = [](void*, const char*, double) -> int { throw 1; };
  expect_refused(request, "progress");
}

TEST_F(BadHlrInput, AndGoodOneLeaveNoMemoryBehind) {
  const auto draw_often = [&] {
    for (int i = 0; i < 5000; ++i) {
      const HlrModel model;
      add_box(model, {1, 2, 3});
      add_parabola(model, 4);
      model.finish();
      epura_hlr_request request = request_for(isometric);
      request.all_types = 1;
      EXPECT_GT(curves_of(model.draw(request)).size(), 0U);
      epura_hlr_request wrong = request_for(isometric);
      wrong.kinds = 1U << 20;
      EXPECT_EQ(epura_hlr_draw(model.model.get(), &wrong, nullptr), nullptr);
    }
    return mallinfo2().uordblks;
  };
  const std::size_t before = draw_often();
  EXPECT_LE(draw_often(), before + 4096);
}

}  // namespace
}  // namespace epura::test::bad_input_test
