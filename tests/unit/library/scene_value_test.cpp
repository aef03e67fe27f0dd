// SPDX-License-Identifier: Apache-2.0
// Scenes in the words of scene files, projections of the calling program, and comparison, as other programs use them.
#include <gtest/gtest.h>

#include <array>
#include <epura/epura.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace epura::test::scene_value_test {
namespace {

Settings settings() { return {.plugin_path = {EPURA_TEST_PLUGINS}}; }

const std::vector<std::array<double, 3>> points{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},
                                                {0, 0, 9}, {9, 0, 9}, {9, 9, 9}, {0, 9, 9}};
const std::vector<int> quads{3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5};
const std::vector<int> triangles{2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};

std::vector<ModelSource> cube() { return {{.model = 0, .points = points, .faces = {{quads, 4}, {triangles, 3}}}}; }

SceneValue text(const std::string& key, const std::string& place, const std::string& word) {
  return {key, place, word};
}

/// A scene with one model and one view.
SceneValue scene_of(std::vector<SceneValue> view, const std::string& file = "cube") {
  const SceneValue model{"model", "models[0]", SceneTable{{text("file", "models[0].file", file)}}};
  return {"", "scene",
          SceneTable{{{"model", "models", SceneList{{model}}},
                      {"view", "views", SceneList{{{"view", "views[0]", SceneTable{std::move(view)}}}}}}}};
}

SceneValue isometric() { return scene_of({text("projection", "views[0].projection", "isometric")}); }

template <class Call>
Failure failure_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Failure& failure) {
    return failure;
  }
  return {Failure::Kind::input, "", "no failure", ""};
}

TEST(SceneValues, DrawBorrowedArrays) {
  const Drawing drawing = draw(isometric(), cube(), settings());
  int visible = 0;
  for (const Line& line : drawing.views().at(0).lines) visible += line.visible ? 1 : 0;
  EXPECT_EQ(visible, 9);
}

TEST(SceneValues, AreRefusedAtTheirPlace) {
  const auto draw_view = [](std::vector<SceneValue> view) {
    return failure_of([&] { return draw(scene_of(std::move(view)), cube(), settings()); });
  };
  const SceneValue projection = text("projection", "views[0].projection", "front");
  const Failure unknown = draw_view({projection, text("hiden", "views[0].hiden", "none")});
  EXPECT_EQ(unknown.place(), "views[0].hiden");
  EXPECT_NE(unknown.hint().find("hidden"), std::string::npos) << unknown.hint();
  EXPECT_EQ(draw_view({projection, text("hidden", "views[0].hidden", "dotted")}).place(), "views[0].hidden");
  EXPECT_EQ(draw_view({projection, {"sheet", "views[0].sheet", 1.5}}).place(), "views[0].sheet");
}

TEST(SceneValues, RefuseWrongFaces) {
  const auto draw_faces = [](const std::vector<int>& corners, int each) {
    return failure_of([&] {
      return draw(isometric(), {{.model = 0, .points = points, .faces = {{quads, 4}, {corners, each}}}}, settings());
    });
  };
  EXPECT_EQ(draw_faces({0, 1, 2, 0, 8, 2}, 3).place(), "models[0].faces[5]");
  EXPECT_EQ(draw_faces({0, -1, 2}, 3).place(), "models[0].faces[4]");
  EXPECT_EQ(draw_faces({0, 1}, 3).place(), "models[0].faces");
  EXPECT_EQ(draw_faces({0, 1}, 0).place(), "models[0].faces");
  EXPECT_EQ(failure_of([] { return draw(isometric(), {{.model = 1}}, settings()); }).place(), "sources");
}

TEST(SceneValues, ReadBytes) {
  const std::vector<ModelSource> sources{{.model = 0, .bytes = "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n"}};
  const SceneValue scene = scene_of({text("projection", "views[0].projection", "front")}, "face.obj");
  EXPECT_EQ(draw(scene, sources, settings()).views().at(0).lines.size(), 3U);
}

/// Looks along y from the front.
std::optional<std::string> look_along_y(const std::vector<double>& values, const epura_scene& box, epura_view& view) {
  if (values.at(0) > 5) return "is more than this test wants";
  if (values.at(0) < 0) throw std::runtime_error("raised an error");
  view.point[0] = box.least[0];
  view.normal[1] = view.projector[1] = -1;
  view.up[2] = 1;
  view.scale = values.at(0);
  return std::nullopt;
}

OwnProjection own() {
  return {
      .name = "own", .place = "class Own", .parameters = {{.name = "zoom", .initial = {2}}}, .project = look_along_y};
}

Settings with(OwnProjection projection) {
  Settings all = settings();
  all.projections.push_back(std::move(projection));
  return all;
}

Failure failure_with(const std::string& request, const Settings& all) {
  return failure_of([&] { return draw(scene_of({text("projection", "views[0].projection", request)}), cube(), all); });
}

TEST(OwnProjections, AreUsedByName) {
  const Scene scene{.models = {{.file = EPURA_TEST_SAMPLES "/models/bracket.obj"}}, .views = {{.projection = "own"}}};
  EXPECT_EQ(draw(scene, with(own())).views().at(0).projection, "own");
  EXPECT_EQ(failure_with("own", settings()).kind(), Failure::Kind::input);
  EXPECT_NE(failure_with("owm", with(own())).hint().find("own"), std::string::npos);
}

TEST(OwnProjections, TellWhatIsWrong) {
  const Failure refused = failure_with("own:zoom=6", with(own()));
  EXPECT_EQ(refused.kind(), Failure::Kind::input);
  EXPECT_NE(std::string(refused.what()).find("more than this test wants"), std::string::npos);
  const Failure thrown = failure_with("own:zoom=-1", with(own()));
  EXPECT_EQ(thrown.kind(), Failure::Kind::plugin);
  EXPECT_NE(std::string(thrown.what()).find("class Own"), std::string::npos) << thrown.what();
  EXPECT_NE(std::string(thrown.what()).find("raised an error"), std::string::npos);
  OwnProjection nameless = own();
  nameless.name = "Own";
  EXPECT_EQ(failure_with("isometric", with(nameless)).place(), "class Own");
  OwnProjection twofold = own();
  twofold.parameters.push_back(twofold.parameters.front());
  EXPECT_EQ(failure_with("isometric", with(twofold)).kind(), Failure::Kind::plugin);
}

TEST(Comparisons, TellDifferences) {
  const std::string one = to_svg(draw(isometric(), cube(), settings()));
  EXPECT_TRUE(compare_drawings({"a.svg", one}, {"b.svg", one}).is_same);
  const SceneValue front = scene_of({text("projection", "views[0].projection", "front")});
  const Comparison found = compare_drawings({"a.svg", one}, {"b.svg", to_svg(draw(front, cube(), settings()))});
  EXPECT_FALSE(found.is_same);
  EXPECT_NE(found.words.find("removed"), std::string::npos) << found.words;
  EXPECT_EQ(found.json.front(), '{');
  EXPECT_NE(found.page.find("Content-Security-Policy"), std::string::npos);
  EXPECT_EQ(failure_of([&] { return compare_drawings({"a.png", one}, {"b.svg", one}); }).place(), "a.png");
  EXPECT_EQ(failure_of([&] { return compare_drawings({"a.svg", one}, {"b.svg", one}, 0); }).place(), "tolerance");
}

}  // namespace
}  // namespace epura::test::scene_value_test
