// SPDX-License-Identifier: Apache-2.0
// The library as other programs use it: its own header, and nothing else of the project but helpers of tests.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <epura/epura.hpp>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <sstream>
#include <thread>

namespace epura::test::library_test {
namespace {

const std::string samples = EPURA_TEST_SAMPLES "/models/";

Settings settings() { return {.plugin_path = {EPURA_TEST_PLUGINS}}; }

Polygons cube(double size) {
  const double s = size;
  return {.points = {{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}, {0, 0, s}, {s, 0, s}, {s, s, s}, {0, s, s}},
          .faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

Scene in_memory() {
  return {.models = {{.polygons = cube(9)}}, .views = {{.projection = "isometric", .hidden = HiddenLines::dashed}}};
}

class FolderOfFiles {
 public:
  FolderOfFiles() : path_(std::filesystem::temp_directory_path() / ("epura-library-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~FolderOfFiles() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

Failure failure_of(const Scene& scene, const Settings& how = settings()) {
  try {
    static_cast<void>(draw(scene, how));
  } catch (const Failure& failure) {
    return failure;
  }
  return {Failure::Kind::input, "", "no failure", ""};
}

TEST(Library, DrawsFilesInMemory) {
  const std::string bytes = "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n";
  const Drawing drawing = draw({.models = {{.file = "part.obj", .content = bytes}}}, settings());
  EXPECT_EQ(drawing.views().at(0).lines.size(), 3U);
  const Failure damaged = failure_of({.models = {{.file = "no/such/part.obj", .content = "f 1 2 3"}}});
  EXPECT_EQ(damaged.place(), "models[0].file") << damaged.what();
  EXPECT_NE(std::string(damaged.what()).find("no/such/part.obj:1"), std::string::npos) << damaged.what();
  EXPECT_EQ(failure_of({.models = {{.content = bytes}}}).place(), "models[0]") << "without a name";
  EXPECT_EQ(failure_of({.models = {{.content = bytes, .polygons = cube(1)}}}).place(), "models[0]");
  EXPECT_NE(std::string(failure_of({.models = {{.file = "-"}}}).what()).find("No such file"), std::string::npos);
}

int child_processes() {
  std::istringstream all(content("/proc/self/task/" + std::to_string(::getpid()) + "/children"));
  int count = 0;
  for (int child = 0; all >> child;) ++count;
  return count;
}

TEST(Library, KeepsProcessesOfPluginsIfAsked) {
  const std::string expected = to_svg(draw(in_memory(), settings()));
  EXPECT_EQ(child_processes(), 0);
  {
    Settings keeping = settings();
    keeping.plugins = Plugins();
    const Scene other{.models = in_memory().models, .views = {{.projection = "top"}, {.projection = "iso"}}};
    EXPECT_EQ(to_svg(draw(in_memory(), keeping)), expected);
    EXPECT_EQ(child_processes(), 1);
    EXPECT_EQ(to_svg(draw(in_memory(), keeping)), expected);
    EXPECT_EQ(child_processes(), 1);
    EXPECT_EQ(to_svg(draw(other, keeping)), to_svg(draw(other, settings())));
    const Failure unknown = failure_of({.models = in_memory().models, .views = {{.projection = "isometrik"}}}, keeping);
    EXPECT_EQ(unknown.hint(), "did you mean 'isometric'?") << unknown.what();
  }
  EXPECT_EQ(child_processes(), 0);
}

// A process of a plugin ends with the thread that started it.
TEST(Library, StartsKeptPluginsAgain) {
  Settings keeping = settings();
  keeping.plugins = Plugins();
  std::string first, second;
  std::thread([&] { first = to_svg(draw(in_memory(), keeping)); }).join();
  std::thread([&] { second = to_svg(draw(in_memory(), keeping)); }).join();
  EXPECT_EQ(first, second);
}

// The side of a cylinder along z as a band of triangles, its upper rim turned by `twist` facets against the lower one.
struct Band {
  double radius, bottom, top, twist;
  int facets;
};

// Appends the band, its front outside, or inside for a bore.
void add_band(Polygons& polygons, const Band& band, bool is_bore) {
  const int first = static_cast<int>(polygons.points.size());
  for (int i = 0; i < band.facets; ++i)
    for (const int upper : {0, 1}) {
      const double angle = 2 * M_PI * (i + upper * band.twist) / band.facets + 0.001;
      polygons.points.push_back(
          {band.radius * std::cos(angle), band.radius * std::sin(angle), upper == 0 ? band.bottom : band.top});
    }
  for (int i = 0; i < band.facets; ++i) {
    const int a = first + 2 * i, b = first + 2 * ((i + 1) % band.facets);
    for (std::vector<int> face : {std::vector{a, b, a + 1}, std::vector{b, b + 1, a + 1}}) {
      if (is_bore) std::swap(face[0], face[1]);
      polygons.faces.push_back(face);
    }
  }
}

TEST(Library, APinInItsBoreHasNoTicksHoweverFineTheyAre) {
  Polygons pin, bore;
  add_band(pin, {5, -5, 25, 0, 320}, false);
  add_band(bore, {5, 0, 20, 0.5, 157}, true);
  const Drawing drawing =
      draw({.models = {{.polygons = pin}, {.polygons = bore}}, .views = {{.projection = "isometric"}}}, settings());
  for (const Line& line : drawing.views()[0].lines) EXPECT_NE(line.kind, EdgeKind::intersection);
}

// A disk at one height as a fan of triangles around its middle.
void add_cap(Polygons& polygons, const Band& band, bool is_top) {
  const int middle = static_cast<int>(polygons.points.size()), count = 2 * band.facets;
  polygons.points.push_back({0, 0, is_top ? band.top : band.bottom});
  const int first = middle - count + (is_top ? 1 : 0);
  for (int i = 0; i < count; i += 2) {
    const int one = first + i, next = first + (i + 2) % count;
    polygons.faces.push_back(is_top ? std::vector{middle, one, next} : std::vector{middle, next, one});
  }
}

// A sphere about the origin, as a net of `around` meridians.
Polygons net_of_sphere(double radius, int around) {
  Polygons polygons;
  const int rows = around / 2;
  polygons.points.push_back({0, 0, -radius});
  for (int row = 1; row < rows; ++row)
    for (int i = 0; i < around; ++i) {
      const double latitude = M_PI * (1.0 * row / rows - 0.5), angle = 2 * M_PI * i / around;
      polygons.points.push_back({radius * std::cos(latitude) * std::cos(angle),
                                 radius * std::cos(latitude) * std::sin(angle), radius * std::sin(latitude)});
    }
  polygons.points.push_back({0, 0, radius});
  const auto at = [&](int row, int i) {
    return row == 0 ? 0 : row == rows ? (rows - 1) * around + 1 : 1 + (row - 1) * around + i % around;
  };
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < around; ++i) {
      if (row > 0) polygons.faces.push_back({at(row, i), at(row, i + 1), at(row + 1, i)});
      if (row + 1 < rows) polygons.faces.push_back({at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)});
    }
  return polygons;
}

// No fold of a fine net is an edge; its surface is recognised nevertheless, for the sake of its contour.
TEST(Library, ContoursOfFineNetsLieOnTheSurface) {
  const Drawing drawing = draw({.models = {{.polygons = net_of_sphere(10, 96)}},
                                .views = {{.projection = "isometric", .name = "view"}},
                                .sheets = {{.scale = 2.0}}},
                               settings());
  const DrawnView& view = drawing.views().at(0);
  std::array<double, 4> box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Line& line : view.lines)
    for (const auto& p : {line.from, line.to})
      box = {std::min(box[0], p[0]), std::min(box[1], p[1]), std::max(box[2], p[0]), std::max(box[3], p[1])};
  ASSERT_GT(view.lines.size(), 40U);
  for (const Line& line : view.lines)
    EXPECT_NEAR(std::hypot(line.from[0] - (box[0] + box[2]) / 2, line.from[1] - (box[1] + box[3]) / 2), 20, 0.002);
}

// A mesher puts vertices between the rims, too, at any angle: seen along the axis, the facets peep out everywhere.
TEST(Library, ACylinderAlongItsAxisIsOneCircleHoweverItIsMeshed) {
  for (const double twist : {0.5, 0.31}) {
    Polygons pin;
    const Band lower{20, 0, 10, twist, 24}, upper{20, 10, 25, twist, 24};
    add_band(pin, lower, false);
    add_cap(pin, lower, false);
    const int first = static_cast<int>(pin.points.size());
    add_band(pin, upper, false);
    for (int i = 0; i < 24; ++i) {
      // Its lower rim is turned like the upper rim of the first band.
      const double angle = 2 * M_PI * (i + twist) / 24 + 0.001, higher = angle + 2 * M_PI * twist / 24;
      pin.points[first + 2 * i] = {20 * std::cos(angle), 20 * std::sin(angle), 10};
      pin.points[first + 2 * i + 1] = {20 * std::cos(higher), 20 * std::sin(higher), 25};
    }
    add_cap(pin, upper, true);
    const Drawing drawing = draw({.models = {{.polygons = pin}},
                                  .views = {{.projection = "top", .name = "view", .hidden = HiddenLines::dashed}}},
                                 settings());
    for (const SheetLayer& layer : drawing.layers()) {
      if (layer.name == "view/visible") {
        ASSERT_EQ(layer.strokes.size(), 1U) << twist;
        EXPECT_EQ(layer.strokes[0].front(), layer.strokes[0].back());
      }
      if (layer.name == "view/hidden") {
        EXPECT_TRUE(layer.strokes.empty()) << twist;
      }
    }
  }
}

TEST(Library, DrawsACubeInMemory) {
  const Drawing drawing = draw(in_memory(), settings());
  ASSERT_EQ(drawing.sheets(), 1);
  ASSERT_EQ(drawing.views().size(), 1U);
  const DrawnView& view = drawing.views()[0];
  EXPECT_EQ(view.projection, "isometric");
  EXPECT_EQ(view.sheet, 1);
  // Nine edges are seen, and three are hidden behind them.
  int visible = 0, hidden = 0;
  for (const Line& line : view.lines) {
    ++(line.visible ? visible : hidden);
    EXPECT_TRUE(line.edge[0] >= 0 && line.edge[1] < 8);
    // Edges of one length in space have one length in an isometric view.
    const double length = std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
    EXPECT_NEAR(length, 9 * view.scale * std::sqrt(2.0 / 3), 1e-9);
  }
  EXPECT_EQ(visible, 9);
  EXPECT_EQ(hidden, 3);
  EXPECT_TRUE(drawing.warnings().empty());
  EXPECT_TRUE(drawing.cut_stages().empty());
  const std::vector<SheetLayer> layers = drawing.layers();
  EXPECT_TRUE(std::any_of(layers.begin(), layers.end(),
                          [](const SheetLayer& layer) { return layer.name == "isometric/visible"; }));
}

TEST(Library, PointsOfTheWorldAreWhereTheMatrixSays) {
  const Drawing drawing = draw(in_memory(), settings());
  const DrawnView& view = drawing.views()[0];
  const Polygons polygons = cube(9);
  for (const Line& line : view.lines) {
    const auto& corner = polygons.points[static_cast<std::size_t>(line.edge[line.t[0] == 0 ? 0 : 1])];
    const auto row = [&](int r) {
      const double* m = &view.world_to_page[static_cast<std::size_t>(4 * r)];
      return m[0] * corner[0] + m[1] * corner[1] + m[2] * corner[2] + m[3];
    };
    EXPECT_NEAR(row(0) / row(3), line.from[0], 1e-9);
    EXPECT_NEAR(row(1) / row(3), line.from[1], 1e-9);
  }
}

TEST(Library, GivesTheBytesThatTheProgramWrites) {
  const FolderOfFiles folder;
  const Drawing drawing = draw_file(samples + "bracket.obj", settings());
  const std::string program = EPURA_TEST_PROGRAM;
  for (const auto& [name, bytes] :
       {std::pair("x.svg", to_svg(drawing)), std::pair("x.pdf", to_pdf(drawing)), std::pair("x.dxf", to_dxf(drawing)),
        std::pair("x.png", to_png(drawing)), std::pair("x.eps", to_eps(drawing)), std::pair("x.ps", to_ps(drawing)),
        std::pair("x.json", to_json(drawing))}) {
    const std::string file = (folder / name).string();
    ASSERT_EQ(std::system((program + " draw " + samples + "bracket.obj -o " + file + " 2>/dev/null").c_str()), 0);
    EXPECT_EQ(content(file) == bytes, true) << name;
    EXPECT_EQ(write(drawing, file), std::vector<std::filesystem::path>{file});
    EXPECT_EQ(content(file) == bytes, true) << name;
  }
}

TEST(Library, TypedValuesMeanWhatOptionsMean) {
  const FolderOfFiles folder;
  const Scene scene{.models = {{.file = samples + "bracket.obj", .unit = Unit::in}},
                    .views = {{.projection = "cabinet",
                               .parameters = {{"angle", 30.0}},
                               .hidden = HiddenLines::solid,
                               .edges = EdgeKinds{.tangent = true},
                               .crease_angle = 20,
                               .weak_crease_angle = 15,
                               .least_crease = 2,
                               .join_within = 0.2}},
                    .sheets = {{.size = "A3",
                                .orientation = Orientation::portrait,
                                .scale = 0.05,
                                .frame = FrameKind::full,
                                .title_block = {{"title", "Bracket"}, {"owner", "epura"}}}}};
  Settings how = settings();
  how.arcs = 0.01;
  how.centre_lines = true;
  const std::string file = (folder / "x.svg").string();
  const std::string options =
      " --unit in --projection cabinet:angle=30 --hidden solid --edges contour,crease,boundary,intersection,tangent"
      " --crease-angle 20 --weak-crease-angle 15 --least-crease 2 --join-within 0.2 --sheet A3 --portrait --scale 1:20 "
      "--frame full --title Bracket --owner "
      "epura --arcs "
      "--centre-lines -o ";
  ASSERT_EQ(std::system(
                (std::string(EPURA_TEST_PROGRAM) + " draw " + samples + "bracket.obj" + options + file + " 2>/dev/null")
                    .c_str()),
            0);
  EXPECT_EQ(to_svg(draw(scene, how)) == content(file), true);
}

TEST(Library, ThreadsAndArrangementsMeanWhatSceneFilesSay) {
  const FolderOfFiles folder;
  const std::string stud = EPURA_TEST_SAMPLES "/../tests/golden/models/stud.obj";
  const std::array<double, 3> begin{0, 0, 0}, end{80, 0, 0};
  const Scene scene{
      .models = {{.file = stud}},
      .views = {{.projection = "front"}},
      .dimensions = {{.type = DimensionType::linear,
                      .direction = DimensionDirection::horizontal,
                      .points = {begin, std::array<double, 3>{40, 0, 0}, end},
                      .arrangement = DimensionArrangement::ordinate}},
      .threads = {{.thread = "M12x1.25", .at = begin, .depth = 30}, {.thread = "M10", .at = end, .callout = false}},
      .sheets = {{.size = "A3", .scale = 1.0}}};
  const std::string file = (folder / "scene.toml").string(), svg = (folder / "x.svg").string();
  std::ofstream(file) << "[sheet]\nsize = 'A3'\nscale = '1:1'\n[[model]]\nfile = '" + stud +
                             "'\n[[view]]\nprojection = 'front'\n"
                             "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\narrangement = 'ordinate'\n"
                             "points = [{point = [0, 0, 0]}, {point = [40, 0, 0]}, {point = [80, 0, 0]}]\n"
                             "[[thread]]\nthread = 'M12x1.25'\nat = {point = [0, 0, 0]}\ndepth = 30\n"
                             "[[thread]]\nthread = 'M10'\nat = {point = [80, 0, 0]}\ncallout = false\n";
  const std::string command = EPURA_TEST_PROGRAM " draw --allow-outside " + file + " -o " + svg + " 2>/dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(to_svg(draw(scene, settings())) == content(svg), true);
}

// A cube whose lid is a body of its own, with a line above it.
Scene cube_with_lid() {
  Polygons polygons = cube(9);
  polygons.bodies = {0, 1, 0, 0, 0, 0};
  polygons.body_names = {"box", "lid"};
  polygons.points.insert(polygons.points.end(), {{0, 0, 12}, {9, 9, 12}});
  polygons.polylines = {{8, 9}};
  return {.models = {{.polygons = polygons}}, .views = {{.projection = "top"}}};
}

TEST(Library, StylesAreForBodies) {
  Scene scene = cube_with_lid();
  scene.styles = {{.match = "l?d", .colour = "#c80000"}};
  const Drawing drawing = draw(scene, settings());
  int wires = 0;
  for (const Line& line : drawing.views()[0].lines)
    wires += line.kind == EdgeKind::wire && line.visible && line.body < 0;
  EXPECT_EQ(wires, 1);
  EXPECT_NE(to_svg(drawing).find("stroke=\"#c80000\""), std::string::npos);
  scene.styles[0] = {.match = "box", .drawn = false};
  const Drawing lid = draw(scene, settings());
  for (const Line& line : lid.views()[0].lines) EXPECT_EQ(line.body, line.kind == EdgeKind::wire ? -1 : 1);
  EXPECT_EQ(lid.views()[0].lines.size(), 5U);
  scene.styles[0] = {.match = "lid", .colour = "#c8000"};
  EXPECT_EQ(failure_of(scene).place(), "styles[0].colour");
  scene = cube_with_lid();
  scene.models[0].polygons.bodies[3] = 2;
  EXPECT_EQ(failure_of(scene).place(), "models[0].polygons.bodies");
  scene = cube_with_lid();
  scene.models[0].polygons.polylines[0][1] = 10;
  EXPECT_EQ(failure_of(scene).place(), "models[0].polygons.polylines[0]");
}

TEST(Library, TwoThreadsDrawTwoScenes) {
  const std::string bracket = to_svg(draw_file(samples + "bracket.obj", settings()));
  const std::string gear = to_svg(draw_file(samples + "gear.stl", settings()));
  std::atomic<int> wrong = 0;
  const auto draw_often = [&](const std::string& model, const std::string& expected) {
    for (int i = 0; i < 4; ++i)
      if (to_svg(draw_file(samples + model, settings())) != expected) ++wrong;
  };
  std::thread one(draw_often, "bracket.obj", bracket), other(draw_often, "gear.stl", gear);
  one.join();
  other.join();
  EXPECT_EQ(wrong, 0);
}

// A corner of a cube in a circle with a radius of 3: two edges, each of that length.
TEST(Library, DrawsDetails) {
  Scene scene = in_memory();
  scene.views = {{.projection = "front", .hidden = HiddenLines::none},
                 {.scale = 20.0, .detail = "X", .hidden = HiddenLines::none}};
  scene.details = {{.name = "X", .centre = {{9, 0, 9}}, .radius = 3}};
  scene.sheets = {{.scale = 5.0}};
  const Drawing drawing = draw(scene, settings());
  ASSERT_EQ(drawing.views().size(), 2U);
  const DrawnView& detail = drawing.views()[1];
  EXPECT_EQ(detail.name, "detail-X");
  EXPECT_EQ(detail.projection, "front");
  EXPECT_EQ(detail.scale, 20);
  ASSERT_EQ(detail.lines.size(), 2U);
  for (const Line& line : detail.lines)
    EXPECT_NEAR(std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]), 60, 1e-9);
}

TEST(Library, FailuresNameTheMember) {
  const auto expect = [](const Scene& scene, const std::string& place, const std::string& said) {
    const Failure failure = failure_of(scene);
    EXPECT_EQ(failure.kind(), Failure::Kind::input) << failure.what();
    EXPECT_EQ(failure.place(), place) << failure.what();
    EXPECT_NE(std::string(failure.what()).find(said), std::string::npos) << failure.what();
  };
  expect({}, "models", "there is none");
  expect({.models = {{}}}, "models[0]", "neither a file nor polygons");
  expect({.models = {{.file = "missing.obj"}}}, "models[0].file", "missing.obj");
  Scene scene = in_memory();
  scene.models[0].polygons.faces[2][1] = 8;
  expect(scene, "models[0].polygons.faces[2]", "there is no point 8");
  scene = in_memory();
  scene.views[0].crease_angle = 200;
  expect(scene, "views[0].crease_angle", "allowed is 0 to 180");
  scene = in_memory();
  scene.views[0].near = std::numeric_limits<double>::quiet_NaN();
  expect(scene, "views[0].near", "finite");
  scene = in_memory();
  for (const double to : {2.0, 1.0}) {
    scene.views[0].breaks = {{.axis = 0, .from = 2, .to = to}};
    expect(scene, "views[0].breaks[0]", "the second place is not beyond the first");
  }
  scene = in_memory();
  scene.views[0].section = "A";
  expect(scene, "views[0].section", "there is no section 'A'");
  scene = in_memory();
  scene.views[0] = {.scale = 2.0, .detail = "X"};
  expect(scene, "views[0].detail", "there is no detail 'X'");
  scene = in_memory();
  scene.details = {{.name = "X", .centre = {{0, 0, 0}}, .radius = 0}};
  expect(scene, "details[0].radius", "more than 0 is wanted");
  scene = in_memory();
  scene.threads = {{.thread = "M6.5"}};
  expect(scene, "threads[0].thread", "ISO 261 has no M6.5");
  scene.threads = {{.thread = "M6", .at = std::array{0, 0}, .depth = 0}};
  expect(scene, "threads[0].depth", "more than 0 is wanted");
  scene = in_memory();
  scene.dimensions = {{.type = DimensionType::overall, .arrangement = DimensionArrangement::chain}};
  expect(scene, "dimensions[0].arrangement", "type 'overall' has no 'arrangement'");
  scene = in_memory();
  scene.views[0].parameters = {{"eye", 1.0}};
  expect(scene, "views[0].projection", "eye");
  scene = in_memory();
  scene.views[0].projection = "isometrik";
  EXPECT_EQ(failure_of(scene).kind(), Failure::Kind::input);
  scene = in_memory();
  scene.models[0].polygons.faces.clear();
  scene.models[0].polygons.points.resize(1);
  expect(scene, "models[0]", "holds no faces");
}

// Values that a cast, or a variable without a value, can have.
TEST(Library, RefusesWhatNoEnumeratorIs) {
  const auto expect = [](const Scene& scene, const std::string& place) {
    const Failure failure = failure_of(scene);
    EXPECT_EQ(failure.kind(), Failure::Kind::input) << place;
    EXPECT_EQ(failure.place(), place);
    EXPECT_NE(std::string(failure.what()).find("none of its enumerators"), std::string::npos) << failure.what();
  };
  Scene scene = in_memory();
  scene.dimensions = {{.type = static_cast<DimensionType>(-2147483648)}};
  expect(scene, "dimensions[0].type");
  scene = in_memory();
  scene.dimensions = {{.type = DimensionType::overall, .direction = static_cast<DimensionDirection>(5)}};
  expect(scene, "dimensions[0].direction");
  scene = in_memory();
  scene.views[0].hidden = static_cast<HiddenLines>(99);
  expect(scene, "views[0].hidden");
  scene = in_memory();
  scene.models[0].line = static_cast<LineRole>(-1);
  expect(scene, "models[0].line");
  scene = in_memory();
  scene.sheets = {{.frame = static_cast<FrameKind>(4)}};
  expect(scene, "sheets[0].frame");
}

TEST(Library, RefusesNumbersWhoseSquaresAreNone) {
  Scene scene = in_memory();
  for (auto& point : scene.models[0].polygons.points) point[0] = 1e155 * (point[0] + 1);
  EXPECT_EQ(failure_of(scene).kind(), Failure::Kind::input);
  EXPECT_NE(std::string(failure_of(scene).what()).find("has a vertex at "), std::string::npos)
      << failure_of(scene).what();
  scene = in_memory();
  scene.explosions = {{.move = {{1e308, 0, 0}}}};
  EXPECT_EQ(failure_of(scene).place(), "explosions[0].move");
  scene = in_memory();
  scene.dimensions = {{.type = DimensionType::aligned, .from = std::array{0, 0}, .to = std::array{1e100, 0.0, 0.0}}};
  EXPECT_EQ(failure_of(scene).place(), "dimensions[0].to");
  scene.dimensions[0].to = std::array{1e20, 0.0, 0.0};
  EXPECT_EQ(failure_of(scene).kind(), Failure::Kind::input) << failure_of(scene).what();
}

TEST(Library, ThrowsOneTypeWhateverItsProgressThrows) {
  Settings how = settings();
  how.progress = [](const std::string&, double) { throw 3; };
  EXPECT_EQ(failure_of(in_memory(), how).place(), "settings");
}

TEST(Library, TellsItsProgress) {
  Settings how = settings();
  std::vector<std::string> stages;
  std::mutex mutex;
  how.progress = [&](const std::string& stage, double done) {
    const std::lock_guard lock(mutex);
    EXPECT_TRUE(done >= 0 && done <= 1);
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  };
  static_cast<void>(draw(in_memory(), how));
  EXPECT_GE(stages.size(), 4U);
}

TEST(Library, StopsWhenAsked) {
  std::stop_source source;
  Settings how = settings();
  how.stop = source.get_token();
  how.progress = [&](const std::string& stage, double) {
    if (stage == "finding edges") source.request_stop();
  };
  EXPECT_EQ(failure_of(in_memory(), how).kind(), Failure::Kind::stopped);
}

TEST(Library, TimeThatIsOverIsAFailure) {
  Settings how = settings();
  how.time_limit = 0;
  EXPECT_EQ(failure_of(in_memory(), how).kind(), Failure::Kind::time);
}

TEST(Library, NamesTheIdsOfSvg) {
  const Drawing drawing = draw(in_memory(), settings());
  EXPECT_NE(to_svg(drawing, 1, {.id_prefix = "cube"}).find("<svg id=\"cube\""), std::string::npos);
  EXPECT_THROW(static_cast<void>(to_svg(drawing, 1, {.id_prefix = "a\"b"})), Failure);
}

TEST(Library, OverwritesNoInput) {
  const FolderOfFiles folder;
  std::ofstream(folder / "a.svg") << "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                                     "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                     "end_header\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n";
  const std::string before = content(folder / "a.svg");
  const Drawing drawing = draw_file(folder / "a.svg", settings());
  EXPECT_THROW(write(drawing, folder / "a.svg"), Failure);
  EXPECT_THROW(write(drawing, folder / "a.bmp"), Failure);
  EXPECT_THROW(static_cast<void>(to_svg(drawing, 2)), Failure);
  EXPECT_EQ(content(folder / "a.svg"), before);
}

}  // namespace
}  // namespace epura::test::library_test
