// SPDX-License-Identifier: Apache-2.0
// Projections seen from outside: rays run from the points through their images to the centre, the image is the drawing,
// whatever the projection, and what is far away is said instead of drawn.
#include "pipeline/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "../output/json_reader.hpp"
#include "base/error.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/kept_models.hpp"
#include "program.hpp"
#include "projection/matrices.hpp"

namespace epura::test::picture_test {
namespace {

pipeline::PictureRequest request_for(const std::string& projection, const std::string& model) {
  pipeline::PictureRequest request;
  request.model.file = {model, model};
  request.projection = {scene::parse_request(projection), "projection"};
  return request;
}

pipeline::Picture picture_of(const pipeline::PictureRequest& request) {
  pipeline::RunOptions options;
  options.plugin_path = {EPURA_TEST_PLUGINS};
  return pipeline::make_picture(request, options, {});
}

double size_of(const pipeline::Picture& picture) {
  double size = 0;
  for (const construction::Ray& ray : picture.set_up.rays) size = std::max(size, glm::length(ray.point - ray.image));
  return std::max(size, 1.0);
}

class Picture : public testing::TestWithParam<std::string> {
 protected:
  std::string model = sample("bracket.obj");
  pipeline::Picture picture = picture_of(request_for(GetParam(), model));

  /// Where the plane is drawn, from a point of it: along u and v, and the rest.
  Vec3 in_plane(const Vec3& shown) const { return Vec3(glm::inverse(picture.set_up.to_image) * Vec4(shown, 1)); }
};

TEST_P(Picture, RaysRunThroughTheImagesToTheCentre) {
  const projection::Projection& p = picture.projection;
  const Mat4 to_plane = projection::plane_matrix(p);
  ASSERT_GE(picture.set_up.rays.size(), 4U);
  for (const construction::Ray& ray : picture.set_up.rays) {
    const Vec3 along = glm::normalize(p.central ? p.projector - ray.point : p.projector);
    const Vec3 to_image = ray.image - ray.point;
    EXPECT_LT(glm::length(to_image - glm::dot(to_image, along) * along), 1e-9 * size_of(picture));
    // The image is that of M_per or M_par, moved with the plane.
    const Vec4 image = to_plane * Vec4(ray.point, 1);
    const Vec3 from_point = Vec3(image) / image.w - p.point, own = in_plane(ray.image);
    EXPECT_LT(glm::length(own - Vec3(glm::dot(from_point, p.u), glm::dot(from_point, p.v), 0)),
              1e-9 * size_of(picture));
  }
}

TEST_P(Picture, PlaneIsClearOfTheModel) {
  const projection::Projection& p = picture.projection;
  const Vec3 origin(picture.set_up.to_image[3]);
  EXPECT_NEAR(glm::dot(origin - p.point, p.n), picture.set_up.plane, 1e-9 * size_of(picture));
  double front = -HUGE_VAL, back = HUGE_VAL;
  for (const construction::Ray& ray : picture.set_up.rays) {
    front = std::max(front, glm::dot(ray.point - p.point, p.n));
    back = std::min(back, glm::dot(ray.point - p.point, p.n));
  }
  EXPECT_TRUE(picture.set_up.plane >= front - 1e-9 || picture.set_up.plane <= back + 1e-9);
  // In front of the centre.
  if (p.central) {
    EXPECT_LT(picture.set_up.plane, glm::dot(p.projector - p.point, p.n));
  }
}

// Compared with the drawing by its own map from the world to the page.
TEST_P(Picture, ImageIsTheDrawing) {
  const Folder folder;
  const Outcome run =
      epura({"draw", model, "--projection", GetParam(), "--hidden", "none", "-o", "x.json"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json view = JsonReader(read_file(folder / "x.json")).read()["views"].items.at(0);
  Mat4 to_page(0);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      to_page[column][row] = view["world_to_page"].items.at(static_cast<std::size_t>(4 * row + column)).number();
  std::vector<std::array<Vec2, 2>> drawn;
  for (const Json& segment : view["segments"].items)
    if (segment["visible"].type == 't')
      drawn.push_back({Vec2(segment["from"].items.at(0).number(), segment["from"].items.at(1).number()),
                       Vec2(segment["to"].items.at(0).number(), segment["to"].items.at(1).number())});
  const auto on_page = [&](const Vec3& shown) {
    const Vec3 own = in_plane(shown);
    EXPECT_NEAR(own.z, 0, 1e-9 * size_of(picture));
    const projection::Projection& p = picture.projection;
    const Vec4 page = to_page * Vec4(p.point + own.x * p.u + own.y * p.v, 1);
    return Vec2(page) / page.w;
  };
  std::vector<std::array<Vec3, 2>> image;
  for (const construction::SetUpLines& lines : picture.set_up.lines)
    if (lines.part == construction::SetUpPart::image) image = lines.segments;
  ASSERT_FALSE(image.empty());
  for (const auto& [from, to] : image) {
    const std::array<Vec2, 2> line{on_page(from), on_page(to)};
    const bool is_drawn = std::any_of(drawn.begin(), drawn.end(), [&](const auto& other) {
      return glm::length(line[0] - other[0]) < 1e-6 && glm::length(line[1] - other[1]) < 1e-6;
    });
    EXPECT_TRUE(is_drawn) << line[0].x << ", " << line[0].y;
  }
  const auto is_point = [](const std::array<Vec2, 2>& line) { return line[0] == line[1]; };
  drawn.erase(std::remove_if(drawn.begin(), drawn.end(), is_point), drawn.end());
  EXPECT_EQ(image.size(), drawn.size());
}

// The model is inside the normalised volume as it is inside the view volume.
TEST_P(Picture, NormalisedVolumeIsTheUnitCubeOrAPyramid) {
  const Mat4& map = picture.set_up.normalised;
  const projection::ViewVolume& volume = picture.viewing.volume;
  const projection::Projection& p = picture.projection;
  const auto at = [&](const Vec2& window, double depth) {
    const Vec3 on_plane = p.point + window.x * p.u + window.y * p.v;
    const Vec3 step = p.central ? (p.projector - on_plane) / volume.prp.z : p.projector / glm::dot(p.projector, p.n);
    return Vec3(map * Vec4(on_plane + depth * step, 1));
  };
  const Vec3 origin = at(volume.window.min, volume.back);
  const Vec3 r = at({volume.window.max.x, volume.window.min.y}, volume.back) - origin;
  const Vec3 s = at({volume.window.min.x, volume.window.max.y}, volume.back) - origin;
  const double side = glm::length(r);
  EXPECT_NEAR(glm::length(s), side, 1e-9 * side);
  EXPECT_NEAR(glm::dot(r, p.u), side, 1e-9 * side);
  EXPECT_NEAR(glm::dot(s, p.v), side, 1e-9 * side);
  if (p.central) {
    const Vec3 apex(map * Vec4(p.projector, 1));
    EXPECT_LT(glm::length(apex - (origin + r / 2.0 + s / 2.0 + side * p.n)), 1e-9 * side);
  } else {
    const Vec3 top = at(volume.window.min, volume.front);
    EXPECT_LT(glm::length(top - (origin + side * p.n)), 1e-9 * side);
  }
}

TEST_P(Picture, IsDrawnWithLabelsAndALegend) {
  const Folder folder;
  const Outcome run = epura({"picture", GetParam(), model, "-o", "x.svg", "--svg-text", "text"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::string svg = read_file(folder / "x.svg");
  for (const char* word : {">VRP", ">u<", ">v", ">n<", ">PRP", ">umin, vmin", ">umax, vmax", ">F", ">B",
                           ">view reference point: ", ">normalised volume "})
    EXPECT_TRUE(contains(svg, word)) << word;
  EXPECT_LT(svg.size(), 400'000U);
}

INSTANTIATE_TEST_SUITE_P(Projections, Picture, testing::ValuesIn(built_in_projections()), [](const auto& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Pictures, AreOfAllBuiltInProjections) { EXPECT_EQ(built_in_projections().size(), 22U); }

// The parameters that set a quantity are found without the plugin's help.
TEST(Pictures, NameTheParametersThatSetEachValue) {
  using projection::Quantity;
  const auto of = [](const pipeline::Picture& picture, Quantity quantity) {
    return picture.influence[static_cast<std::size_t>(quantity)];
  };
  using Names = std::vector<std::string>;
  const pipeline::Picture two_point = picture_of(request_for("two-point", sample("bracket.obj")));
  EXPECT_EQ(of(two_point, Quantity::normal), (Names{"azimuth"}));
  EXPECT_EQ(of(two_point, Quantity::projector), (Names{"distance", "azimuth", "above", "eye-height"}));
  EXPECT_EQ(of(two_point, Quantity::point), Names{});
  const pipeline::Picture phigs = picture_of(request_for("phigs", sample("bracket.obj")));
  EXPECT_EQ(of(phigs, Quantity::window), (Names{"window"}));
  EXPECT_EQ(of(phigs, Quantity::back), (Names{"b"}));
  const pipeline::Picture cabinet = picture_of(request_for("cabinet", sample("bracket.obj")));
  EXPECT_EQ(of(cabinet, Quantity::projector), (Names{"angle"}));
  EXPECT_EQ(of(cabinet, Quantity::normal), Names{});
}

TEST(Pictures, HaveRaysThroughChosenVertices) {
  pipeline::PictureRequest request = request_for("one-point", sample("bracket.obj"));
  request.vertices.value = std::vector<int>{2, 5};
  EXPECT_EQ(picture_of(request).set_up.rays.size(), 2U);
}

TEST(Pictures, KeepAPlaneThatCutsTheModelOnRequest) {
  pipeline::PictureRequest request = request_for("isometric", sample("bracket.obj"));
  EXPECT_GT(picture_of(request).set_up.plane, 0);
  request.keeps_plane = true;
  EXPECT_EQ(picture_of(request).set_up.plane, 0);
}

// From the set-up to the sheet: what is drawn does not need the file any more.
TEST(Pictures, ReadTheModelOnce) {
  const Folder folder;
  const std::string file = folder.file("box.obj", read_file(sample("bracket.obj")));
  const pipeline::PictureRequest request = request_for("cabinet", file);
  pipeline::RunOptions options;
  options.plugin_path = {EPURA_TEST_PLUGINS};
  options.kept_models = std::make_shared<pipeline::KeptModels>();
  scene::SceneDescription scene = pipeline::scene_of(pipeline::make_picture(request, options, {}), request);
  std::filesystem::remove(file);
  pipeline::complete_scene(scene);
  pipeline::complete_sheets(scene);
  const pipeline::Messages silent{[](const std::string&) {}, [](std::string_view) {}};
  pipeline::Stopwatch watch;
  EXPECT_FALSE(pipeline::draw_scene(scene, options, {silent, {}, watch}).sheets.empty());
  EXPECT_EQ(options.kept_models->models.size(), 1U);
}

class DrawnPicture : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(const std::string& projection, std::vector<std::string> options = {}) {
    options.insert(options.begin(),
                   {"picture", projection, sample("bracket.obj"), "-o", "x.svg", "--svg-text", "text"});
    return epura(options, folder / "");
  }
  std::string svg() const { return read_file(folder / "x.svg"); }
};

// An arrow with the distance stands for a centre 1e12 mm away, and everything else is as large as ever.
TEST_F(DrawnPicture, CentreFarAwayIsAnArrow) {
  ASSERT_EQ(draw("look-at:eye=0,-1000000000000,0").code, 0);
  EXPECT_TRUE(contains(svg(), "PRP: 1000000 km"));
  const std::string far = svg();
  ASSERT_EQ(draw("look-at:eye=0,-300,0").code, 0);
  EXPECT_FALSE(contains(svg(), " km"));
  EXPECT_LT(far.size(), 2 * svg().size());
}

TEST_F(DrawnPicture, PlaneOrWindowFarAwayIsNotDrawnThere) {
  ASSERT_EQ(draw("phigs:kind=parallel:vpd=-1000000000000").code, 0);
  EXPECT_TRUE(contains(svg(), "VRP'")) << "moved along the projectors";
  EXPECT_LT(svg().size(), 400'000U);
  ASSERT_EQ(draw("phigs:window=-1000000000000,-1000000000000,1000000000000,1000000000000").code, 0);
  EXPECT_TRUE(contains(svg(), "the window is too large to be drawn"));
}

TEST_F(DrawnPicture, IsWrittenInEveryFormat) {
  const Outcome run = draw("cabinet", {"-o", "x.pdf", "-o", "x.png", "-o", "x.dxf", "-o", "x.json", "-o", "x.eps", "-o",
                                       "x.ps", "-o", "x.html", "--dpi", "50"});
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* name : {"x.svg", "x.pdf", "x.png", "x.dxf", "x.json", "x.eps", "x.ps", "x.html"})
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000U) << name;
}

TEST_F(DrawnPicture, BadRequestsAreRefusedInWords) {
  const auto refusal = [&](const std::string& projection, std::vector<std::string> options) {
    const Outcome run = draw(projection, std::move(options));
    EXPECT_NE(run.code, 0) << projection;
    return run.err;
  };
  EXPECT_TRUE(contains(refusal("isometrc", {}), "did you mean 'isometric'?"));
  EXPECT_TRUE(contains(refusal("cabinet:angel=3", {}), "angel"));
  EXPECT_TRUE(contains(refusal("cabinet", {"--vertices", "0,99999"}), "--vertices: "));
  EXPECT_TRUE(contains(refusal("cabinet", {"--vertices", "a"}), "'a' is not the number of a vertex"));
  EXPECT_TRUE(contains(refusal("cabinet", {"--from", "two-point"}), "is not parallel"));
  for (const char* option : {"--layout", "--third-angle", "--fit", "--dimension-decimals", "--views"})
    EXPECT_TRUE(contains(refusal("cabinet", {option}), std::string("unknown option '") + option)) << option;
  const Outcome empty =
      epura({"picture", "cabinet", folder.file("empty.obj", "v 0 0 0\n"), "-o", "x.svg"}, folder / "");
  EXPECT_EQ(empty.code, 2);
  EXPECT_TRUE(contains(empty.err, "empty.obj: ")) << empty.err;
  const Outcome piped = epura({"picture", "cabinet", "-", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(piped.code, 2);
  EXPECT_TRUE(contains(piped.err, "write the model to a file")) << piped.err;
}

TEST(PicturesOfPlugins, ShowAWrongCentre) {
  const Folder folder;
  const std::string plugin = EPURA_TEST_BAD_PLUGINS "/wrong-centre/wrong-centre.so";
  const Outcome run = epura({"plugins", "check", plugin, "--picture", "x.json"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_FALSE(contains(run.out, "FAILED"));
  EXPECT_TRUE(std::filesystem::exists(folder / "x.json"));
  // Seen at a glance: the foot of the centre lies outside the window of a model that is away from the origin.
  const std::string box =
      folder.file("box.obj", "v 100 30 50\nv 140 30 50\nv 140 60 50\nv 120 45 80\nf 1 2 3\nf 1 2 4\n");
  pipeline::RunOptions options;
  options.plugin_path = {std::filesystem::path(plugin).parent_path(), EPURA_TEST_PLUGINS};
  const pipeline::Picture wrong = pipeline::make_picture(request_for("wrong-centre", box), options, {});
  const projection::ViewVolume& volume = wrong.viewing.volume;
  EXPECT_LT(volume.prp.x, volume.window.min.x - (volume.window.max.x - volume.window.min.x));
}

TEST(PicturesOfPlugins, HaveAFileForEachProjection) {
  const Folder folder;
  const Outcome run =
      epura({"plugins", "check", EPURA_TEST_BAD_PLUGINS "/good/every-type.so", "--picture", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Outcome alone =
      epura({"plugins", "check", EPURA_TEST_BAD_PLUGINS "/good/plain.so", "--model", "x.obj"}, folder / "");
  EXPECT_EQ(alone.code, 2);
  EXPECT_TRUE(contains(alone.err, "name its file with --picture")) << alone.err;
}

}  // namespace
}  // namespace epura::test::picture_test
