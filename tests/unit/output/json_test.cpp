// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cfloat>

#include "base/broken.hpp"
#include "json_reader.hpp"
#include "output/format.hpp"
#include "report/report.hpp"

namespace epura::json_test {
namespace {

drawing::ViewDrawing example() {
  drawing::ViewDrawing drawing{};
  drawing.name = "front \"A\"";
  drawing.scale = 0.5;
  drawing.projection.name = "look-at";
  drawing.projection.values = {{"eye", {4, -9, 5}}, {"fovy", {30}}};
  drawing.projection.projector = {4, -9, 5};
  drawing.projection.central = true;
  drawing.world_to_page = rows({1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16});
  drawing.aids.vanishing_points[1] = Vec2(-1.5, 1e300);
  drawing.segments.push_back({{0.1, 1.0 / 3}, {1e-300, -DBL_MAX}, true, EdgeKind::crease, 2, {7, 3}, -1, {0, 1}});
  drawing.segments.push_back({{1, 2}, {3, 4}, false, EdgeKind::intersection, 0, {-1, -1}, 0, {0, 1}});
  drawing.crossings.push_back({{{{0, 5}, {1, 6}}}, {Vec3(1, 2, 3), Vec3(4, 5, 6.5)}});
  return drawing;
}

Json parse(const std::string& text) { return JsonReader(text).read(); }

TEST(Json, HasTheKeysOfSchemaOneInOrder) {
  report::Report report;
  report.meshes.emplace_back();
  report.plan.push_back({"clip", false, "all inside", 12, 34});
  const Json json = parse(output::to_json({420, 297, "", {}}, 0.5, std::array{example()}, report));
  EXPECT_EQ(json.keys(), "epura unit sheet views report");
  EXPECT_EQ(json["epura"].number(), 1);
  EXPECT_EQ(json["unit"].text, "mm");
  EXPECT_EQ(json["sheet"].keys(), "size scale");
  EXPECT_EQ(json["sheet"]["size"].items[0].number(), 420);
  const Json& view = json["views"].items.at(0);
  EXPECT_EQ(view.keys(), "name projection parameters world_to_page viewer vanishing_points segments");
  EXPECT_EQ(view["segments"].items.at(0).keys(), "from to visible kind model edge t");
  EXPECT_EQ(view["segments"].items.at(1).keys(), "from to visible kind model edge t faces world");
  // A view says its scale where it is not that of the sheet.
  const Json other = parse(output::to_json({420, 297, "", {}}, 0.25, std::array{example()}, report));
  EXPECT_EQ(other["views"].items.at(0)["scale"].number(), 0.5);
  EXPECT_EQ(json["report"].keys(), "meshes plan");
  EXPECT_EQ(
      json["report"]["meshes"].items.at(0).keys(),
      "name format vertices faces triangles bodies open_edges non_manifold_edges misoriented_edges welded_vertices "
      "dropped_degenerate dropped_duplicates non_finite_vertices dropped_non_finite weld_distance single_precision "
      "resolution "
      "notes");
  EXPECT_EQ(json["report"]["plan"].items.at(0).keys(), "stage run why in out");
  EXPECT_EQ(json["report"]["plan"].items.at(0)["out"].number(), 34);
}

TEST(Json, SaysWhatTheViewIs) {
  const Json json = parse(output::to_json({420, 297, "", {}}, 0.5, std::array{example()}, {}));
  const Json& view = json["views"].items.at(0);
  EXPECT_EQ(view["name"].text, "front \"A\"");
  EXPECT_EQ(view["parameters"]["fovy"].number(), 30);
  EXPECT_EQ(view["parameters"]["eye"].items.at(1).number(), -9);
  EXPECT_EQ(view["viewer"].keys(), "centre");
  ASSERT_EQ(view["world_to_page"].items.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(view["world_to_page"].items[i].number(), static_cast<double>(i + 1));
  EXPECT_EQ(view["vanishing_points"].items.at(0).type, 'n');
  EXPECT_EQ(view["vanishing_points"].items.at(1).items.at(0).number(), -1.5);

  drawing::ViewDrawing parallel = example();
  parallel.projection.central = false;
  EXPECT_EQ(parse(output::to_json({1, 1, "", {}}, 1, std::array{parallel}, {}))["views"].items[0]["viewer"].keys(),
            "direction");
}

TEST(Json, NumbersComeBackExactly) {
  const drawing::ViewDrawing drawing = example();
  const Json json = parse(output::to_json({420, 297, "", {}}, 1 / 3.0, std::array{drawing}, {}));
  const Json& segment = json["views"].items.at(0)["segments"].items.at(0);
  EXPECT_EQ(json["sheet"]["scale"].number(), 1 / 3.0);
  EXPECT_EQ(segment["from"].items[0].number(), 0.1);
  EXPECT_EQ(segment["from"].items[1].number(), 1.0 / 3);
  EXPECT_EQ(segment["to"].items[0].number(), 1e-300);
  EXPECT_EQ(segment["to"].items[1].number(), -DBL_MAX);
  EXPECT_EQ(segment["visible"].type, 't');
  EXPECT_EQ(segment["kind"].text, "crease");
  EXPECT_EQ(segment["model"].number(), 2);
  EXPECT_EQ(segment["edge"].items[0].number(), 7);
}

TEST(Json, IntersectionLinesNameTheirFacesAndPlaces) {
  const Json json = parse(output::to_json({420, 297, "", {}}, 1, std::array{example()}, {}));
  const Json& segment = json["views"].items.at(0)["segments"].items.at(1);
  EXPECT_EQ(segment["edge"].type, 'n');
  EXPECT_EQ(segment["faces"].items.at(1).items.at(0).number(), 1);
  EXPECT_EQ(segment["faces"].items.at(1).items.at(1).number(), 6);
  EXPECT_EQ(segment["world"].items.at(1).items.at(2).number(), 6.5);
}

TEST(Json, SegmentsStandOnLinesOfTheirOwn) {
  const std::string text = output::to_json({420, 297, "", {}}, 1, std::array{example()}, {});
  for (std::size_t at = text.find("{\"from\""); at != std::string::npos; at = text.find("{\"from\"", at + 1))
    EXPECT_EQ(text[text.find_last_not_of(' ', at - 1)], '\n');
}

TEST(Json, PartialDrawingsSayWhatIsMissing) {
  report::Report report;
  report.partial = {{"hiding lines", "writing"}, 500, 123, 0.75, 7};
  const Json json = parse(output::to_json({1, 1, "", {}}, 1, {}, report));
  EXPECT_EQ(json.keys(), "epura unit sheet partial views report");
  EXPECT_EQ(json["partial"].keys(), "reason stages edges undecided searched undrawn");
  EXPECT_EQ(json["partial"]["reason"].text, "time limit");
  EXPECT_EQ(json["partial"]["edges"].number(), 500);
  EXPECT_EQ(json["partial"]["undecided"].number(), 123);
  EXPECT_EQ(json["partial"]["searched"].number(), 0.75);
  EXPECT_EQ(json["partial"]["stages"].items.at(1).text, "writing");
  EXPECT_EQ(json["partial"]["undrawn"].number(), 7);
  report.partial.too_many_crossings = true;
  EXPECT_EQ(parse(output::to_json({1, 1, "", {}}, 1, {}, report))["partial"]["reason"].text, "too many crossings");
}

TEST(Json, TimesStandThereOnlyWhenAskedFor) {
  report::Report report;
  report.seconds = {{"read", 0.25}};
  const Json json = parse(output::to_json({1, 1, "", {}}, 1, {}, report));
  EXPECT_EQ(json["report"].keys(), "meshes plan time");
  EXPECT_EQ(json["report"]["time"]["read"].number(), 0.25);
  EXPECT_TRUE(json["views"].items.empty());
}

TEST(Json, StringsAreEscapedAndValid) {
  report::Report report;
  mesh::MeshReport mesh;
  mesh.name = "a\"b\\c\n\x01\x1f\x7f W\xC3\xBCrfel";
  mesh.notes = {"lone \xC3 overlong \xC0\xAF surrogate \xED\xA0\x80 high \xF4\x90\x80\x80 cut \xE2\x82"};
  report.meshes = {mesh};
  const Json json = parse(output::to_json({1, 1, "", {}}, 1, {}, report));
  const Json& read = json["report"]["meshes"].items.at(0);
  EXPECT_EQ(read["name"].text, mesh.name);
  const std::string u = "\xEF\xBF\xBD";
  EXPECT_EQ(read["notes"].items.at(0).text, "lone " + u + " overlong " + u + u + " surrogate " + u + u + u + " high " +
                                                u + u + u + u + " cut " + u + u);
}

TEST(Json, NumbersThatAreNoneAreNeverWritten) {
  drawing::ViewDrawing drawing = example();
  drawing.segments[0].to.x = std::nan("");
  EXPECT_THROW(output::to_json({1, 1, "", {}}, 1, std::array{drawing}, {}), Broken);
}

TEST(Json, TellsWhatVerificationFoundWrong) {
  report::Report report;
  report::OutlineCheck& outline = report.verification.emplace().outline;
  outline.missing = 2;
  outline.worst.push_back({"missing", {10, 20}, 3.5, 1, {7, 3}, {}});
  const Json json = parse(output::to_json({420, 297, "", {}}, 0.5, std::array{example()}, report));
  const Json& found = json["report"]["verify"]["outline"];
  EXPECT_EQ(found["missing"].number(), 2);
  ASSERT_EQ(found["worst"].items.size(), 1U);
  const Json& worst = found["worst"].items[0];
  EXPECT_EQ(worst.keys(), "what page length model edge facets");
  EXPECT_EQ(worst["what"].text, "missing");
  EXPECT_EQ(worst["length"].number(), 3.5);
}

}  // namespace
}  // namespace epura::json_test
