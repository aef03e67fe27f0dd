// SPDX-License-Identifier: Apache-2.0
// Labels of all constructions of all projections, and of all pictures from outside, by the outlines of their letters:
// no two touch each other, none leaves the margin of the sheet, and no line or arrow runs through one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "folder.hpp"
#include "golden.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/picture.hpp"
#include "program.hpp"
#include "scene/construction_choice.hpp"
#include "scene/line_roles.hpp"
#include "scene/scene_file.hpp"
#include "sheet/lettering.hpp"
#include "sheet/rectangle.hpp"

namespace epura::test::construction_labels_test {
namespace {

using sheet::Rectangle;

struct Ink {
  std::string text;
  Rectangle box;
};

// The box of the outlines of a text, of which a blank has none.
std::optional<Ink> ink_of(const sheet::Text& text, const sheet::Lettering& lettering) {
  Rectangle box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const sheet::GlyphOutline& outline : lettering.outlines(text.text, text.height))
    for (const auto& curve : outline.curves) box = united(box, {curve.end, curve.end});
  if (box.min.x > box.max.x) return std::nullopt;
  const double width = lettering.width(text.text, text.height);
  const double back = text.align == sheet::Align::left ? 0 : text.align == sheet::Align::middle ? width / 2 : width;
  const Vec2 origin = text.at - Vec2(back, 0);
  return Ink{text.text, {origin + box.min, origin + box.max}};
}

// Whether a line runs through the box: clipped at its four sides, something is left.
bool runs_through(const Vec2& from, const Vec2& to, const Rectangle& box) {
  double first = 0, last = 1;
  for (const int axis : {0, 1}) {
    const double step = to[axis] - from[axis];
    if (step == 0) {
      if (from[axis] <= box.min[axis] || from[axis] >= box.max[axis]) return false;
      continue;
    }
    const double a = (box.min[axis] - from[axis]) / step, b = (box.max[axis] - from[axis]) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

class SheetWithLabels {
 public:
  explicit SheetWithLabels(scene::SceneDescription scene) {
    pipeline::complete_scene(scene);
    pipeline::complete_sheets(scene);
    pipeline::RunOptions options;
    options.plugin_path = {EPURA_TEST_PLUGINS};
    options.allow_outside = true;
    const pipeline::Messages silent{[](const std::string&) {}, [](std::string_view) {}};
    pipeline::Stopwatch watch;
    pipeline::DrawnScene drawn = pipeline::draw_scene(scene, options, {silent, {}, watch});
    sheet_ = std::move(drawn.sheets.front().sheet);
    warnings_ = std::move(drawn.sheets.front().warnings);
    for (const sheet::Layer& layer : sheet_.layers)
      for (const sheet::Text& text : layer.texts)
        if (const auto ink = ink_of(text, lettering_)) {
          all_.push_back(*ink);
          if (is_construction(layer)) labels_.push_back(*ink);
        }
  }

  void expect_clear(const std::string& what) const {
    SCOPED_TRACE(what);
    EXPECT_EQ(warnings_, std::vector<std::string>{});
    EXPECT_FALSE(labels_.empty());
    expect_apart();
    expect_in_margin();
    for (const sheet::Layer& layer : sheet_.layers) {
      for (const sheet::Stroke& stroke : layer.strokes)
        for (std::size_t i = 0; i + 1 < stroke.points.size() + (stroke.closed ? 1 : 0); ++i)
          expect_no_text_on(stroke.points[i], stroke.points[(i + 1) % stroke.points.size()], layer.name);
      for (const sheet::Fill& fill : layer.fills)
        for (const std::vector<Vec2>& ring : fill.rings)
          for (std::size_t i = 0; i < ring.size(); ++i)
            expect_no_text_on(ring[i], ring[(i + 1) % ring.size()], layer.name);
    }
  }

 private:
  static bool is_construction(const sheet::Layer& layer) {
    return layer.name.ends_with(std::string("/") + scene::row_of(scene::SheetLine::construction).layer);
  }
  // With all lettering on the sheet.
  void expect_apart() const {
    for (const Ink& label : labels_)
      for (const Ink& other : all_)
        EXPECT_FALSE(label.box.min != other.box.min && label.box.overlaps(other.box))
            << label.text << " on " << other.text << " at " << label.box.min.x << ", " << label.box.min.y;
  }
  void expect_in_margin() const {
    constexpr double margin = 5;  // mm; the sheets have no frame
    const Rectangle inside{Vec2(margin), Vec2(sheet_.width, sheet_.height) - margin};
    for (const Ink& label : labels_)
      EXPECT_TRUE(inside.holds(label.box)) << label.text << " at " << label.box.min.x << ", " << label.box.min.y;
  }
  void expect_no_text_on(const Vec2& from, const Vec2& to, const std::string& layer) const {
    for (const Ink& label : labels_)
      EXPECT_FALSE(runs_through(from, to, label.box))
          << "line of " << layer << " through " << label.text << " at " << label.box.min.x << ", " << label.box.min.y;
  }

  sheet::Lettering lettering_{};
  sheet::Sheet sheet_{};
  std::vector<std::string> warnings_{};
  std::vector<Ink> all_{}, labels_{};
};

class SheetsWithConstructions : public testing::Test {
 protected:
  Folder folder;
  std::string cube = folder.file("cube.obj",
                                 "v 0 0 0\nv 40 0 0\nv 40 40 0\nv 0 40 0\nv 0 0 40\nv 40 0 40\nv 40 40 40\nv 0 40 40\n"
                                 "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n");
  std::string part = sample("bracket.obj");

  static scene::SceneDescription with_constructions(const std::string& projection, const std::string& model,
                                                    SheetFit fit) {
    scene::SceneDescription scene;
    scene.models.emplace_back().file = {model, model};
    scene::ViewDescription& view = scene.views.emplace_back();
    view.projection = {scene::parse_request(projection), "projection"};
    view.hidden = {HiddenLines::none, "view"};
    const auto item = [](const char* word) { return scene::parse_construction(word, "view"); };
    view.construction = {scene::ConstructionChoice{item("all"), item("legend")}, "view"};
    scene.sheets.emplace_back().fit = {fit, "sheet"};
    return scene;
  }
  static scene::SceneDescription from_outside(const std::string& projection, const std::string& model) {
    pipeline::PictureRequest request;
    request.model.file = {model, model};
    request.projection = {scene::parse_request(projection), "projection"};
    pipeline::RunOptions options;
    options.plugin_path = {EPURA_TEST_PLUGINS};
    return pipeline::scene_of(pipeline::make_picture(request, options, {}), request);
  }
};

class ConstructionLabels : public SheetsWithConstructions, public testing::WithParamInterface<std::string> {};

TEST_P(ConstructionLabels, AreClearOfEachOtherAndOfLines) {
  for (const std::string& model : {cube, part}) {
    SheetWithLabels(with_constructions(GetParam(), model, SheetFit::model)).expect_clear("of " + model);
    SheetWithLabels(with_constructions(GetParam(), model, SheetFit::construction)).expect_clear("fitting, " + model);
  }
}

TEST_P(ConstructionLabels, OfPicturesAreClearOfEachOtherAndOfLines) {
  for (const std::string& model : {cube, part})
    SheetWithLabels(from_outside(GetParam(), model)).expect_clear("picture of " + model);
}

TEST_F(SheetsWithConstructions, OfSeveralViewsAreClear) {
  for (const std::string& model : {cube, part}) {
    scene::SceneDescription scene = with_constructions("front", model, SheetFit::model);
    for (const char* projection : {"top", "isometric", "two-point"}) {
      scene.views.push_back(scene.views.front());
      scene.views.back().projection = {scene::parse_request(projection), "projection"};
    }
    scene.sheets.front().size = {scene::parse_paper_size("A2", "sheet"), "sheet"};
    SheetWithLabels(scene).expect_clear("four views of " + model);
  }
}

TEST_F(SheetsWithConstructions, OfGoldenSheetsAreClear) {
  int sheets = 0;
  for (const std::string& name : golden_cases()) {
    if (!name.starts_with("construction-")) continue;
    ++sheets;
    const std::filesystem::path file = golden_folder(name) / "scene.toml";
    SheetWithLabels(scene::read_scene_file(file, scene::FilesOutside::allowed)).expect_clear(name);
  }
  EXPECT_GE(sheets, 8);
}

INSTANTIATE_TEST_SUITE_P(Projections, ConstructionLabels, testing::ValuesIn(built_in_projections()),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace epura::test::construction_labels_test
