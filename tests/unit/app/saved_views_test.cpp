// SPDX-License-Identifier: Apache-2.0
// Views that files have stored: read by the importer, listed, and drawn on request.
#include <gtest/gtest.h>

#include <cmath>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::saved_views_test {
namespace {

std::string n(int number) { return std::to_string(number); }

struct Camera {
  const char* name;
  const char *at, *axis, *right;  ///< of its placement
  const char* distance;           ///< of the view plane along the axis
  const char* projection = "PARALLEL";
};

// Takes ten numbers.
std::string camera(int number, const Camera& of, const std::string& keyword = "CAMERA_MODEL_D3",
                   const std::string& more = "") {
  return "#" + n(number) + "=" + keyword + "('" + of.name + "',#" + n(number + 1) + ",#" + n(number + 2) + more +
         ");\n#" + n(number + 1) + "=AXIS2_PLACEMENT_3D('',#" + n(number + 3) + ",#" + n(number + 4) + ",#" +
         n(number + 5) + ");\n#" + n(number + 2) + "=VIEW_VOLUME(." + of.projection + ".,#" + n(number + 6) + "," +
         of.distance + ",0.,.F.,0.,.F.,.F.,#" + n(number + 7) + ");\n#" + n(number + 3) + "=CARTESIAN_POINT('',(" +
         of.at + "));\n#" + n(number + 4) + "=DIRECTION('',(" + of.axis + "));\n#" + n(number + 5) + "=DIRECTION('',(" +
         of.right + "));\n#" + n(number + 6) + "=CARTESIAN_POINT('',(0.,0.,0.));\n#" + n(number + 7) +
         "=PLANAR_BOX('',10.,10.,#" + n(number + 1) + ");\n";
}

// From the right and above, z upwards: the axis looks at the model.
const Camera from_the_right{"MBD_A", "100.,15.,10.", "-1.,0.,0.", "0.,-1.,0.", "100."};
// From above, y upwards: the axis looks at the viewer.
const Camera from_above{"MBD_B", "20.,15.,0.", "0.,0.,1.", "1.,0.,0.", "-100."};
const Camera near_by{"near", "20.,-100.,10.", "0.,1.,0.", "-1.,0.,0.", "100.", "CENTRAL"};

class SavedViews : public testing::Test {
 protected:
  Outcome run(std::vector<std::string> words, const std::string& statements, bool in_inches = false) {
    folder_.file("box.step", step_box({40, 30, 20}, statements, in_inches));
    Outcome done = epura(words, folder_ / "");
    has_importer_ = !contains(done.err, "install the package");
    return done;
  }
  [[nodiscard]] Json views() const { return JsonReader(read_file(folder_ / "a.json")).read()["views"]; }
  // The width and height of the only view, in units of the model.
  [[nodiscard]] std::array<double, 2> size() const {
    const Json drawing = JsonReader(read_file(folder_ / "a.json")).read();
    double least[2] = {HUGE_VAL, HUGE_VAL}, most[2] = {-HUGE_VAL, -HUGE_VAL};
    for (const Json& segment : drawing["views"].items.at(0)["segments"].items)
      for (const char* end : {"from", "to"})
        for (int k = 0; k < 2; ++k) {
          const double x = segment[end].items.at(static_cast<std::size_t>(k)).number();
          least[k] = std::min(least[k], x);
          most[k] = std::max(most[k], x);
        }
    const double scale = drawing["sheet"]["scale"].number();
    return {(most[0] - least[0]) / scale, (most[1] - least[1]) / scale};
  }
  Folder folder_;
  bool has_importer_ = false;
};

#define EXPECT_IMPORTER() \
  if (!has_importer_) GTEST_SKIP() << "there is no importer of STEP"

TEST_F(SavedViews, AreListed) {
  const Outcome info =
      run({"info", "box.step", "--json", "i.json"}, camera(1000, from_the_right) + camera(1010, from_above));
  EXPECT_IMPORTER();
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_TRUE(contains(read_file(folder_ / "i.json"), "\"saved_views\": [\"MBD_A\", \"MBD_B\"]"));
  EXPECT_TRUE(contains(run({"info", "box.step"}, camera(1000, from_the_right)).out, "  saved     1 view: MBD_A\n"));
}

// The axis of a camera looks at the model in some files, and at the viewer in others.
TEST_F(SavedViews, AreSeenFromWhereTheViewerStands) {
  const std::string cameras = camera(1000, from_the_right) + camera(1010, from_above);
  const Outcome right = run({"draw", "box.step", "--projection", "saved:MBD_A", "-o", "a.json"}, cameras);
  EXPECT_IMPORTER();
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_EQ(views().items.at(0)["name"].text, "MBD_A");
  EXPECT_NEAR(size()[0], 30, 1e-9);
  EXPECT_NEAR(size()[1], 20, 1e-9);
  EXPECT_EQ(run({"draw", "box.step", "--projection", "saved:MBD_B", "-o", "a.json"}, cameras).code, 0);
  EXPECT_NEAR(size()[0], 40, 1e-9);
  EXPECT_NEAR(size()[1], 30, 1e-9);
  EXPECT_FALSE(contains(right.err, "not drawn: --views saved"));
}

TEST_F(SavedViews, AllAreOnOneSheet) {
  const Outcome drawn =
      run({"draw", "box.step", "--views", "saved,top", "-o", "a.json", "-o", "a.svg", "--svg-text", "text"},
          camera(1000, from_the_right) + camera(1010, from_above));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  std::string names;
  for (const Json& view : views().items) names += view["name"].text + " ";
  EXPECT_EQ(names, "MBD_A MBD_B top ");
  EXPECT_TRUE(contains(read_file(folder_ / "a.svg"), ">MBD_A<"));
}

TEST_F(SavedViews, APlaneThatClipsIsASection) {
  const std::string plane =
      "#1100=PLANE('',#1101);\n#1101=AXIS2_PLACEMENT_3D('',#1102,#1103,#1104);\n"
      "#1102=CARTESIAN_POINT('',(15.,0.,0.));\n#1103=DIRECTION('',(-1.,0.,0.));\n#1104=DIRECTION('',(0.,1.,0.));\n";
  const Outcome drawn = run({"draw", "box.step", "--projection", "saved:MBD_A", "-o", "a.json"},
                            camera(1000, from_the_right, "CAMERA_MODEL_D3_MULTI_CLIPPING", ",(#1100)") + plane);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  const Json drawing = JsonReader(read_file(folder_ / "a.json")).read();
  EXPECT_EQ(drawing["views"].items.at(0)["cut_faces"].items.size(), 1U);
}

TEST_F(SavedViews, RaysMeetWhereAFileSaysSo) {
  const Outcome drawn = run({"draw", "box.step", "--projection", "saved:near", "-o", "a.json"}, camera(1000, near_by));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(read_file(folder_ / "a.json"), "look-at"));
}

TEST_F(SavedViews, OnesThatAreNotThereAreRefused) {
  const Outcome other =
      run({"draw", "box.step", "--projection", "saved:MBD_C", "-o", "a.json"}, camera(1000, from_above));
  EXPECT_IMPORTER();
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(contains(other.err, "the models have no saved view 'MBD_C'")) << other.err;
  EXPECT_TRUE(contains(other.err, "did you mean 'MBD_B'?")) << other.err;
  const Outcome none = run({"draw", "box.step", "--views", "saved", "-o", "a.json"}, "");
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "the models have stored no views")) << none.err;
}

// One without a direction is told, one without a name gets one, and equal names are apart.
TEST_F(SavedViews, DamagedOnesAreTold) {
  const Camera flat{"flat", "0.,0.,0.", "0.,0.,0.", "1.,0.,0.", "1."};
  const Camera nameless{"", "0.,0.,0.", "0.,0.,-1.", "1.,0.,0.", "1."};
  const Outcome info = run({"info", "box.step"}, camera(1000, flat) + camera(1010, nameless) +
                                                     camera(1020, from_above) + camera(1030, from_above));
  EXPECT_IMPORTER();
  EXPECT_TRUE(contains(info.out, "  saved     3 views: view 1, MBD_B, MBD_B 3\n")) << info.out;
  EXPECT_TRUE(contains(info.out, "1 saved view without a camera that can be placed: not read")) << info.out;
}

TEST_F(SavedViews, ADrawingWithoutThemSaysSo) {
  const Outcome drawn = run({"draw", "box.step", "--views", "front,top", "-o", "a.json"}, camera(1000, from_above));
  EXPECT_IMPORTER();
  EXPECT_TRUE(contains(drawn.err, "1 saved view of the file is not drawn: --views saved draws it")) << drawn.err;
}

}  // namespace
}  // namespace epura::test::saved_views_test
