// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "scene/scene_keys.hpp"
#include "scene/transform.hpp"

namespace epura::test::scene_file_test {
namespace {

const std::string model = "[[model]]\nfile = \"a.obj\"\n";
const std::string view = "[[view]]\nprojection = \"front\"\n";

scene::SceneDescription scene_of(const std::string& text) {
  const Folder folder;
  return scene::read_scene_file(folder.file("scene.toml", text));
}

// What stands between ```toml and ``` in the documentation.
std::string example_of(const std::string& page) {
  const std::string fence = "```toml\n";
  const std::size_t begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

std::string documentation() { return read_file(EPURA_TEST_SAMPLES "/../docs/scenes.md"); }

std::string field(const scene::SheetDescription& sheet, const std::string& name) {
  std::string texts;
  for (const auto& [key, text] : sheet.title_block)
    if (key == name) texts += *text + ";";
  return texts;
}

TEST(SceneFile, AModelIsEnough) {
  const scene::SceneDescription scene = scene_of(model);
  ASSERT_EQ(scene.models.size(), 1U);
  EXPECT_FALSE(scene.models[0].drawn.given());
  EXPECT_FALSE(scene.models[0].unit.given());
  EXPECT_TRUE(scene.views.empty());
  EXPECT_TRUE(scene.sections.empty());
  EXPECT_TRUE(scene.dimensions.empty());
  EXPECT_EQ(scene.sheets.size(), 1U);
}

TEST(SceneFile, ValuesKnowTheirPlace) {
  const Folder folder;
  const std::string path = folder.file("scene.toml", "[[model]]\nfile = \"a.obj\"\n  unit =  'IN'  # why not\n");
  const scene::ModelDescription read = scene::read_scene_file(path).models.at(0);
  EXPECT_EQ(*read.unit, Unit::in);
  EXPECT_EQ(read.unit.where, path + ":3:11");
}

TEST(SceneFile, TransformsMayBeMatrices) {
  const auto transform = [](const std::string& rows) {
    return scene_of("[[model]]\nfile = 'a.obj'\ntransform = " + rows).models.at(0).transform;
  };
  const Mat4 wanted = scene::parse_transform("scale:1,2,3 translate:4,5,6");
  EXPECT_EQ(*transform("[[1, 0, 0, 4], [0, 2, 0, 5], [0, 0, 3, 6]]"), wanted);
  EXPECT_EQ(*transform("[[1, 0, 0, 4], [0, 2, 0, 5], [0, 0, 3, 6], [0, 0, 0, 1]]"), wanted);
  EXPECT_THROW(transform("[[1, 0, 0, 4], [0, 2, 0, 5], [0, 0, 3, 6], [0, 0, 1, 1]]"), Error);
  EXPECT_THROW(transform("[[1, 0, 0, 4], [0, 2, 0, 5]]"), Error);
  EXPECT_THROW(transform("[[1, 0, 0], [0, 2, 0], [0, 0, 3]]"), Error);
}

TEST(SceneFile, ScalesMayBeNumbers) {
  EXPECT_EQ(*scene_of(model + "[[sheet]]\nscale = 0.5").sheets.at(0).scale, scene::ScaleChoice{0.5});
  EXPECT_EQ(*scene_of(model + view + "scale = 2").views.at(0).scale, scene::ScaleChoice{2.0});
  EXPECT_THROW(scene_of(model + "[[sheet]]\nscale = 0"), Error);
}

TEST(SceneFile, ModelsAreFoundFromItsFolder) {
  const Folder folder;
  const std::string path = folder.file("scene.toml", "model = [{file = 'sub/a.obj'}, {file = '/b.stl'}]");
  const scene::SceneDescription scene = scene::read_scene_file(path, scene::FilesOutside::allowed);
  EXPECT_EQ(*scene.models.at(0).file, (folder / "sub/a.obj").string());
  EXPECT_EQ(*scene.models.at(1).file, "/b.stl");
}

TEST(SceneFile, AllKeysOfAModel) {
  const scene::ModelDescription read = scene_of(model +
                                                "name = 'plate'\nunit = 'in'\nup = 'y'\ntransform = 'scale:2'\n"
                                                "line = 'narrow'\nhidden = 'none'\ndrawn = false")
                                           .models.at(0);
  EXPECT_EQ(*read.name, "plate");
  EXPECT_EQ(*read.unit, Unit::in);
  EXPECT_EQ(*read.up, UpAxis::y);
  EXPECT_EQ(*read.transform, scene::parse_transform("scale:2"));
  EXPECT_EQ(*read.line, LineRole::narrow);
  EXPECT_EQ(*read.hidden, HiddenLines::none);
  EXPECT_FALSE(*read.drawn);
}

TEST(SceneFile, AllKeysOfAView) {
  const scene::SceneDescription scene = scene_of(
      model + "[[sheet]]\n[[sheet]]\n[[section]]\nname = 'A'\npoint = [1, 2.5, 3]\nnormal = [0, 0, 1]\n" + view +
      "name = 'cut'\nscale = '2:1'\nhidden = 'none'\nedges = ['contour', 'smooth']\nsection = 'A'\n"
      "label = 'cut A'\ncrease_angle = 20\nweak_crease_angle = 15\nleast_crease = 2\njoin_within = 0.2\nnear = -1\nfar "
      "= 1e3\nat = [100, 50.5]\nsheet = 2\n");
  const scene::ViewDescription& read = scene.views.at(0);
  EXPECT_EQ(read.projection->text(), "front");
  EXPECT_EQ(*read.name, "cut");
  EXPECT_EQ(read.scale->fixed, 2);
  EXPECT_EQ(*read.hidden, HiddenLines::none);
  EXPECT_EQ(*read.edges,
            (EdgeKinds{.crease = false, .boundary = false, .intersection = false, .wire = false, .smooth = true}));
  EXPECT_EQ(*read.section, "A");
  EXPECT_EQ(*read.label, "cut A");
  EXPECT_EQ(*read.crease_angle, 20);
  EXPECT_EQ(*read.weak_crease_angle, 15);
  EXPECT_EQ(*read.least_crease, 2);
  EXPECT_EQ(*read.join_within, 0.2);
  EXPECT_EQ(*read.near, -1);
  EXPECT_EQ(*read.far, 1000);
  EXPECT_EQ(*read.at, Vec2(100, 50.5));
  EXPECT_EQ(*read.sheet, 2);
  EXPECT_EQ(scene.sections.at(0).point, Vec3(1, 2.5, 3));
  EXPECT_EQ(scene.sections.at(0).normal, Vec3(0, 0, 1));
}

TEST(SceneFile, AProjectionIsATextOrATable) {
  const auto projection = [](const std::string& value) {
    return scene_of(model + "[[view]]\nprojection = " + value).views.at(0).projection->text();
  };
  EXPECT_EQ(projection("'look-at:eye=4,-9,5'"), "look-at:eye=4,-9,5");
  EXPECT_EQ(projection("{name = 'look-at', eye = [4, -9, 5.5], fovy = 4e1}"), "look-at:eye=4,-9,5.5:fovy=40");
  EXPECT_EQ(projection("{foreshortened = false, name = 'isometric'}"), "isometric:foreshortened=false");
}

TEST(SceneFile, ViewsHaveAShortForm) {
  const scene::SceneDescription scene = scene_of("views = ['front', 'top', 'look-at:eye=4,-9,5']\n" + model + view);
  ASSERT_EQ(scene.views.size(), 4U);
  EXPECT_EQ(scene.views[1].projection->text(), "top");
  EXPECT_TRUE(scene.views[1].projection.where.ends_with("scene.toml:1:19"));
  EXPECT_EQ(scene.views[2].projection->text(), "look-at:eye=4,-9,5");
  EXPECT_EQ(*scene.views[2].name, "look-at");
  EXPECT_EQ(*scene.views[3].name, "front-2");
  EXPECT_EQ(scene_of("views = 'front,top'\n" + model).views.at(1).projection->text(), "top");
}

TEST(SceneFile, AGivenNameComesBeforeOneOfAProjection) {
  const scene::SceneDescription scene = scene_of(model + view + "[[view]]\nprojection = 'top'\nname = 'front'\n");
  EXPECT_EQ(*scene.views.at(0).name, "front-2");
  EXPECT_EQ(*scene.views.at(1).name, "front");
}

// "model:vertex", or coordinates.
std::vector<std::string> texts_of(const std::vector<scene::Anchor>& anchors) {
  std::vector<std::string> texts;
  for (const scene::Anchor& anchor : anchors)
    if (const auto* vertex = std::get_if<std::array<int, 2>>(&anchor)) {
      texts.push_back(std::to_string((*vertex)[0]) + ":" + std::to_string((*vertex)[1]));
    } else {
      const Vec3& point = std::get<Vec3>(anchor);
      texts.push_back(format_number(point.x) + " " + format_number(point.y) + " " + format_number(point.z));
    }
  return texts;
}

TEST(SceneFile, AnchorsAreVerticesOrPoints) {
  const scene::SceneDescription scene =
      scene_of(model + "[[model]]\nfile = 'b.stl'\n[[model]]\nfile = 'b.stl'\nname = 'plate'\n" + view +
               "[[dimension]]\ntype = 'angular'\nto = [2, 9]\nfrom = ['plate', 7]\ncorner = ['a', 0]\n"
               "view = 'front'\noffset = -12\ntext = '<> max.'\n"
               "[[dimension]]\ntype = 'linear'\ndirection = 'vertical'\nfrom = {point = [1, 2, 3.5]}\nto = [1, 4]\n"
               "[[dimension]]\ntype = 'radius'\nat = [0, 5]\n"
               "[[dimension]]\ntype = 'overall'\ndirection = 'width'\n");
  ASSERT_EQ(scene.dimensions.size(), 4U);
  const scene::DimensionDescription& angle = scene.dimensions[0];
  EXPECT_EQ(texts_of(angle.anchors), (std::vector<std::string>{"0:0", "2:7", "2:9"}));
  EXPECT_EQ(*angle.view, "front");
  EXPECT_EQ(*angle.offset, -12);
  EXPECT_EQ(*angle.text, "<> max.");
  EXPECT_TRUE(angle.where.ends_with("scene.toml:10:1"));
  EXPECT_EQ(texts_of(scene.dimensions[1].anchors), (std::vector<std::string>{"1 2 3.5", "1:4"}));
  EXPECT_EQ(*scene.dimensions[1].direction, DimensionDirection::vertical);
  EXPECT_EQ(texts_of(scene.dimensions[2].anchors), std::vector<std::string>{"0:5"});
  EXPECT_TRUE(scene.dimensions[3].anchors.empty());
}

TEST(SceneFile, SheetsShareWhatIsSaidForAll) {
  const scene::SceneDescription scene = scene_of(
      "[[sheet]]\nscale = '1:2'\n[[sheet]]\nframe = 'none'\n[sheet.title_block]\ntitle = 'Two'\nnumber = ''\n" + model +
      "[all_sheets]\nsize = 'A2'\nscale = '1:5'\nangle = 'third'\norientation = 'portrait'\n"
      "[title_block]\ntitle = 'One'\nnumber = '7'\ndate = 2026-11-21\n[title_block.free]\n'Surface finish' = 'Ra 3.2'");
  ASSERT_EQ(scene.sheets.size(), 2U);
  for (const scene::SheetDescription& sheet : scene.sheets) {
    EXPECT_EQ(sheet.size->number, 2);
    EXPECT_EQ(*sheet.angle, ProjectionAngle::third);
    EXPECT_EQ(*sheet.orientation, Orientation::portrait);
    EXPECT_EQ(field(sheet, "date"), "2026-11-21;");
    EXPECT_EQ(field(sheet, "Surface finish"), "Ra 3.2;");
  }
  EXPECT_EQ(scene.sheets[0].scale->fixed, 0.5);
  EXPECT_EQ(scene.sheets[1].scale->fixed, 0.2);
  EXPECT_EQ(*scene.sheets[1].frame, FrameKind::none);
  EXPECT_EQ(field(scene.sheets[0], "title"), "One;");
  EXPECT_EQ(field(scene.sheets[1], "title"), "Two;");
  EXPECT_EQ(field(scene.sheets[1], "number"), ";");
}

TEST(SceneFile, ASingleSheetMayBeATable) {
  const scene::SceneDescription scene = scene_of(model + "[sheet]\nsize = 'A3'\n");
  ASSERT_EQ(scene.sheets.size(), 1U);
  EXPECT_EQ(scene.sheets[0].size->number, 3);
  EXPECT_EQ(field(scene_of(model + "[title_block]\ntitle = 'One'\n").sheets.at(0), "title"), "One;");
}

TEST(SceneFile, DatesAreWrittenAsTheyStand) {
  for (const std::string date : {"2026-11-21", "0987-01-02"})
    EXPECT_EQ(field(scene_of(model + "[title_block]\ndate = " + date).sheets.at(0), "date"), date + ";");
}

TEST(SceneFile, LinesMayEndAsOnOtherSystems) {
  EXPECT_EQ(scene_of("\xEF\xBB\xBF[[model]]\r\nfile = 'Grüße.obj'\r\n").models.size(), 1U);
}

TEST(SceneFile, TheDocumentationListsItsKeys) {
  EXPECT_TRUE(contains(documentation(), "\n" + scene::describe_scene_keys() + "\n")) << scene::describe_scene_keys();
}

TEST(SceneFile, TheExampleOfTheDocumentationIsOne) {
  const scene::SceneDescription scene = scene_of(example_of(documentation()));
  EXPECT_FALSE(scene.views.empty());
  EXPECT_FALSE(scene.sections.empty());
  EXPECT_FALSE(scene.dimensions.empty());
}

TEST(SceneFile, SamplesFindTheirModels) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(EPURA_TEST_SAMPLES)) {
    if (entry.path().extension() != ".toml") continue;
    for (const scene::ModelDescription& read : scene::read_scene_file(entry.path()).models) {
      EXPECT_TRUE(std::filesystem::exists(*read.file)) << *read.file;
      ++count;
    }
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace epura::test::scene_file_test
