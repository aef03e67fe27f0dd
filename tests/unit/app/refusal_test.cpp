// SPDX-License-Identifier: Apache-2.0
// What the program refuses: the exit code, one sentence that names place and reason, and nothing half-written.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::refusal_test {
namespace {

using Names = std::vector<std::string>;
using Words = std::vector<std::string>;

// A folder in which things go wrong.
class Refusal : public testing::Test {
 protected:
  Folder folder;
  std::string cube =
      folder.file("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");

  void expect_refused(const Words& arguments, int code, const Words& said) {
    const Names before = folder.names();
    const Outcome run = epura(arguments, folder / "");
    std::string shown;
    for (const std::string& word : arguments) shown += " " + word;
    EXPECT_EQ(run.code, code) << shown << "\n" << run.err;
    EXPECT_EQ(run.out, "") << shown;
    EXPECT_TRUE(run.err.starts_with("epura: ")) << shown << "\n" << run.err;
    for (const std::string& word : said)
      EXPECT_TRUE(contains(run.err, word)) << shown << "\nlacks '" << word << "': " << run.err;
    EXPECT_EQ(folder.names(), before) << shown;
  }

  // Refused, whether the target is new or holds an earlier drawing, which stays.
  void expect_draw_refused(Words arguments, const Words& said, int code = 2) {
    arguments.insert(arguments.begin(), "draw");
    arguments.insert(arguments.end(), {"-o", "out.svg"});
    expect_refused(arguments, code, said);
    const std::string old = folder.file("out.svg", "an earlier drawing");
    expect_refused(arguments, code, said);
    EXPECT_EQ(read_file(old), "an earlier drawing");
    std::filesystem::remove(old);
  }

  // Refused with a sound model and these words.
  void expect_option_refused(Words options, const Words& said, int code = 2) {
    options.insert(options.begin(), cube);
    expect_draw_refused(options, said, code);
  }
};

TEST_F(Refusal, ModelsWithAFaultAreNamedWithTheLine) {
  const auto model = [&](const std::string& bytes) { return folder.file("m.obj", bytes); };
  const std::string m = (folder / "m.obj").string();
  expect_draw_refused({model("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")}, {m + ":4", "vertex 4"});
  expect_draw_refused({model("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 0\n")}, {m + ":5"});
  expect_draw_refused({model("v 0 0 0\nv 1 0 zero\n")}, {m + ":2", "'zero'"});
  expect_draw_refused({model("v 0 0 0\nv 1e400 0 0\n")}, {m + ":2", "1e400"});
  expect_draw_refused({model("v 0 0 0\nv 1 0\n")}, {m + ":2", "missing"});
  expect_draw_refused({model("v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n")}, {m, "not finite"});
  expect_draw_refused({model("v 1 0 0\nv 1 0 0\n")}, {m, "no faces"});
  expect_draw_refused({model("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n")}, {m, "fewer than three distinct corners"});
  expect_draw_refused({model("")}, {m, "is empty"});
}

TEST_F(Refusal, TruncatedAndBinaryFilesAreNamedWithLineOrByte) {
  const std::string gear = read_file(sample("gear.stl"));
  expect_draw_refused({folder.file("cut.stl", gear.substr(0, 5000))}, {"cut.stl", "byte 5000"});
  const std::string bracket = read_file(sample("bracket.obj"));
  expect_draw_refused({folder.file("cut.obj", bracket.substr(0, bracket.find("f ") + 3))}, {"cut.obj:"});
  std::string junk(3000, '\0');
  for (std::size_t i = 0; i < junk.size(); ++i) junk[i] = static_cast<char>(i * i * 7 + i / 11);
  for (const char* name : {"junk.obj", "junk.stl", "junk.ply", "junk.off", "junk"})
    expect_draw_refused({folder.file(name, junk)}, {name});
}

TEST_F(Refusal, WhatIsNoModelFile) {
  std::filesystem::create_directory(folder / "folder.obj");
  expect_draw_refused({"missing.obj"}, {"missing.obj", "No such file", "check the path"});
  expect_draw_refused({"folder.obj"}, {"folder.obj", "directory"});
  expect_draw_refused({folder.file("a.xyz", "0 0 0")}, {"a.xyz", "'.xyz'", ".obj, .stl, .ply, .off"});
  expect_draw_refused({cube, "missing.obj"}, {"missing.obj"});
}

TEST_F(Refusal, SceneFilesNameThePlaceOnce) {
  const auto scene = [&](const std::string& text) {
    return folder.file("s.toml", "[[model]]\nfile = '" + cube + "'\n" + text);
  };
  const std::string at = "epura: " + (folder / "s.toml").string();
  expect_draw_refused({scene("[[view]]\nprojection = 'front'\nhidden = 'dotted'\n")},
                      {at + ":5:10: 'hidden': unknown value 'dotted'"});
  expect_draw_refused({scene("[[view]]\nprojection = 'front'\n"), "--visibility", "exakt"},
                      {"epura: --visibility: unknown value 'exakt'"});
  expect_draw_refused(
      {cube, "--projection", "front", "--hidden", "front:hidden=dashed"},
      {"epura: --hidden: unknown value 'front:hidden=dashed'", "stand in --views: front:hidden=dashed"});
  expect_draw_refused({folder.file("s.toml", "[[model]]\nfile = 'missing.obj'\n")},
                      {at + ":2:8: " + (folder / "missing.obj").string() + ": cannot read", "check the path"});
  expect_draw_refused({scene("[[sheet]]\n[[sheet]]\n[[view]]\nprojection = 'front'\n")},
                      {at + ":4:1: sheet 2 shows no view", "sheet = 2"});
}

// Each with the line of the scene file, and what would do.
TEST_F(Refusal, WhatAScenesSheetsCannotHave) {
  const auto refused = [&](const std::string& scene, const Words& said) {
    folder.file("plain.svg", "<svg><rect width=\"9\" height=\"9\"/></svg>");
    folder.file("roles.toml", "\n[hiden]\nwidth = 1\n");
    folder.file("s.toml", "[[model]]\nfile = \"cube.obj\"\n" + scene);
    expect_draw_refused({"s.toml"}, said);
  };
  const std::string section = "[[view]]\nprojection = \"left\"\nsection = \"A\"\n[[section]]\nname = \"A\"\n";
  refused(section + "point = [5, 0, 0]\nnormal = [-1, 0, 0]\n",
          {"s.toml:7:8: the cutting plane removes everything", "the models reach from 4 to 5 of its point"});
  refused(section + "point = [5, 0, 0]\nnormal = [1, 0, 0]\n",
          {"s.toml:7:8: the plane cuts nothing", "the models reach from -5 to -4 of its point"});
  const std::string dimension = "[[view]]\nprojection = \"front\"\n[[dimension]]\ntype = \"overall\"\n";
  refused(dimension + "tolerance = \"H99\"\n",
          {"s.toml:7:13: 'H99' has no standard tolerance grade", "the grades of ISO 286-1 are 1 to 18"});
  refused(dimension + "tolerance = \"H7/b99\"\n", {"s.toml:7:13: ", "hint: "});
  const std::string view = "[[view]]\nprojection = \"front\"\n[sheet]\n";
  refused(view + "template = \"plain.svg\"\n", {"s.toml:6:12: ", "plain.svg:1: the drawing has no size", "hint: give"});
  refused(view + "style = \"roles.toml\"\n", {"s.toml:6:9: ", "roles.toml:2:2: 'hiden'", "did you mean 'hidden'?"});
  refused(view + "logo = \"none.svg\"\n", {"s.toml:6:8: ", "none.svg", "check the path"});
}

TEST_F(Refusal, TargetsThatCannotBeWritten) {
  std::filesystem::create_directory(folder / "folder.svg");
  expect_refused({"draw", cube, "-o", "folder.svg"}, 4, {"folder.svg", "directory"});
  expect_refused({"draw", cube, "-o", "cube.obj/x.svg"}, 4, {"cube.obj/x.svg"});
  expect_refused({"draw", cube, "-o", "missing/x.svg"}, 4, {"missing/x.svg", "create the folder"});
  expect_refused({"draw", cube, "-o", "/proc/x.svg"}, 4, {"/proc/x.svg"});
}

TEST_F(Refusal, StandardOutputThatCannotBeWritten) {
  for (const Words& arguments : {Words{"draw", cube, "-o", "-", "--format", "svg"}, Words{"plugins"},
                                 Words{"plugins", "front"}, Words{"--help"}}) {
    const Outcome run = epura(arguments, folder / "", "/dev/full");
    EXPECT_EQ(run.code, 4) << arguments[0];
    EXPECT_TRUE(contains(run.err, "standard output")) << run.err;
  }
}

TEST_F(Refusal, Formats) {
  expect_refused({"draw", cube, "-o", "x.qqq"}, 2,
                 {"x.qqq", "unknown format", "known: svg, pdf, ps, eps, png, dxf, json"});
  expect_refused({"draw", cube, "-o", "x.bmp"}, 2, {"x.bmp", "unknown format", "write png instead"});
  expect_refused({"draw", cube, "-o", "x.DWG"}, 2, {"x.DWG", "unknown format", "write dxf instead"});
  expect_refused({"draw", cube, "-o", "x.svgg"}, 2, {"x.svgg", "did you mean 'svg'?"});
  expect_refused({"draw", cube, "-o", "x"}, 2, {"x", "no extension", "known: svg"});
  expect_refused({"draw", cube, "-o", "-"}, 2, {"--format"});
  expect_refused({"draw", cube, "-o", "x.svg", "--format", "pdf"}, 2, {"--format", "standard output", "extension"});
  expect_refused({"draw", cube, "-o", "-", "--format", "jsn"}, 2, {"--format", "did you mean 'json'?"});
  expect_refused({"draw", cube, "-o", "x.svg", "-o", "y.pdf", "-o", "x.svg"}, 2, {"x.svg", "twice"});
  expect_refused({"draw", cube, "-o", "-", "-o", "-", "--format", "svg"}, 2, {"twice"});
}

TEST_F(Refusal, WordsThatNobodyKnows) {
  expect_refused({}, 2, {"epura --help"});
  expect_refused({"drwa", cube}, 2, {"'drwa'", "did you mean 'draw'?"});
  expect_refused({"frobnicate"}, 2,
                 {"known: draw, explain, lint, define, describe, batch, info, requirements, compare"});
  expect_refused({"--verison"}, 2, {"'--verison'", "did you mean '--version'?"});
  expect_refused({"draw", cube, "-o", "x.svg", "--projecton", "front"}, 2,
                 {"'--projecton'", "did you mean '--projection'?"});
  expect_refused({"draw", cube, "-o", "x.svg", "-q"}, 2, {"'-q'"});
  expect_refused({"draw", cube}, 2, {"--output", "epura draw --help"});
  expect_refused({"draw", "-o", "x.svg"}, 2, {"models"});
  expect_refused({"draw", cube, "-o"}, 2, {"--output"});
  expect_refused({"plugins", "front", "top"}, 2, {"top", "epura plugins --help"});
}

TEST_F(Refusal, Projections) {
  expect_option_refused({"--projection", "isometrc"}, {"isometrc", "did you mean 'isometric'?"});
  expect_option_refused({"--projection", "../front"}, {"../front"});
  expect_refused({"plugins", "isometrc"}, 2, {"isometrc", "did you mean 'isometric'?"});
  expect_option_refused({"--projection", "cavalier:agle=30"}, {"cavalier:agle", "did you mean 'angle'?"});
  expect_option_refused({"--projection", "front:angle=30"}, {"front:angle", "no parameters"});
  expect_option_refused({"--projection", "cavalier:angle=steep"}, {"cavalier:angle", "'steep' is not a number"});
  expect_option_refused({"--projection", "cavalier:angle=30,5"}, {"cavalier:angle"});
  expect_option_refused({"--projection", "cavalier:angle=1e3"}, {"cavalier:angle", "1000", "-360 to 360"});
  expect_option_refused({"--projection", "cavalier:angle=nan"}, {"cavalier:angle", "finite"});
  expect_option_refused({"--projection", "cavalier:angle"}, {"'angle' is not a key=value"});
  expect_option_refused({"--projection", "cavalier:angle=1:angle=2"}, {"cavalier:angle", "twice"});
  expect_option_refused({"--projection", "isometric:foreshortened=yes"}, {"'yes'", "false, true"});
  expect_option_refused({"--projection", "look-at:eye=1,2"}, {"look-at:eye", "3 numbers"});
  expect_option_refused({"--projection", "look-at:eye=1,2,3:ref=1,2,3"}, {"look-at", "the same"});
}

TEST_F(Refusal, PluginsThatAreNone) {
  folder.file("mine.so", "this is not a library");
  expect_option_refused({"--plugin-path", ".", "--projection", "mine"}, {"mine", "mine.so"}, 3);
}

TEST_F(Refusal, Numbers) {
  for (const char* option : {"--near", "--far", "--contact", "--crease-angle", "--dpi", "--threads"})
    for (const char* junk : {"many", "nan", "inf", "1,5", "", "1e400", "2mm"})
      expect_option_refused({option, junk}, {option, std::string("'") + junk + "'"});
  expect_option_refused({"--contact", "-1"}, {"--contact", "0 or more"});
  expect_option_refused({"--crease-angle", "181"}, {"--crease-angle", "181", "0 to 180"});
  expect_option_refused({"--dpi", "0"}, {"--dpi", "1 to 1200"});
  expect_option_refused({"--threads", "-1"}, {"--threads", "0 to 1024"});
  expect_option_refused({"--threads", "1.5"}, {"--threads", "whole number"});
}

TEST_F(Refusal, Words) {
  expect_option_refused({"--unit", "km"}, {"--unit", "'km'", "did you mean 'mm'?"});
  expect_option_refused({"--unit", "yards"}, {"--unit", "'yards'", "known: mm, in, m"});
  expect_option_refused({"--up", "x"}, {"--up", "'x'", "known: z, y"});
  expect_option_refused({"--scale", "0"}, {"--scale", "'0'"});
  expect_option_refused({"--scale", "1:0"}, {"--scale", "'1:0'"});
  expect_option_refused({"--scale", "1e9"}, {"--scale", "m long"});
  expect_option_refused({"--sheet", "A7"}, {"--sheet", "A0 to A4"});
  expect_option_refused({"--sheet", "0x100"}, {"--sheet", "0x100"});
  expect_option_refused({"--edges", "contour,creases"}, {"--edges", "'creases'", "did you mean 'crease'?"});
  expect_option_refused({"--edges", "contour,"}, {"--edges", "has an empty element"});
  expect_option_refused({"--hidden", "dotted"}, {"--hidden", "'dotted'"});
  expect_option_refused({"--visibility", "exactly"}, {"--visibility", "'exactly'", "did you mean 'exact'?"});
  expect_option_refused({"--transform", "scale:0"}, {"'scale:0'", "flattens"});
  expect_option_refused({"--transform", "turn:z,3"}, {"'turn:z,3'", "not a known step", "steps:"});
  expect_option_refused({"--transform", "scale:1", "--transform", "scale:2"}, {"--transform"});
  expect_option_refused({"--transform", "scale:1e300"}, {"'scale:1e300'", "beyond 1e+50"});
  expect_option_refused({"--transform", "scale:1e50 scale:1e50"}, {cube, "has a vertex at", "allowed is up to 1e+50"});
  expect_option_refused({"--section", "0,0,1e60:0,-1,0"}, {"--section", "is not a cutting plane"});
  expect_option_refused({"--detail", "1e60,0,0:1:5:1"}, {"--detail", "is not a detail"});
  expect_option_refused({"--explode", "1e60"}, {"--explode", "allowed is"});
  expect_option_refused({"--scale", "1e-300"}, {"--scale", "is not a scale"});
  expect_option_refused({"--projection", "look-at:eye=0,-1e300,0"}, {"look-at:eye", "allowed is up to 1e+50"});
}

TEST_F(Refusal, ViewsInWhichNothingIsLeft) {
  expect_option_refused({"--near", "5", "--far", "5"}, {"near and far", "near must be less than far"});
  expect_option_refused({"--near", "6", "--far", "5"}, {"near and far"});
  expect_option_refused({"--projection", "look-at:eye=0,-9,0:ref=0,-20,0"},
                        {"look-at", "nothing of the model lies in front"});
  expect_option_refused({"--projection", "look-at", "--near", "1e6"}, {"nothing of the model lies in front"});
  expect_option_refused({"--projection", "look-at:window=100,100,101,101"}, {"nothing of the model", "window"});
}

TEST_F(Refusal, AFullDiskLeavesTheOldDrawing) {
  const std::string old = folder.file("out.svg", "an earlier drawing");
  // The shell limits the size of files for the program that it becomes.
  const std::string command = std::string("trap '' XFSZ; ulimit -f 1; exec ") + EPURA_TEST_PROGRAM + " draw " +
                              sample("bracket.obj") + " -o out.svg 2>err";
  const int status = std::system(
      ("cd " + (folder / "").string() + " && env -u EPURA_PLUGIN_PATH bash -c \"" + command + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
  EXPECT_EQ(read_file(old), "an earlier drawing");
  EXPECT_TRUE(contains(read_file(folder / "err"), "out.svg"));
  EXPECT_EQ(folder.names(), (Names{"cube.obj", "err", "out.svg"}));
}

// Only PDF files need the library that writes them.
TEST_F(Refusal, AnInstallationWithoutTheLibraryForPdf) {
  const std::filesystem::path program = folder / "moved/bin/epura", library = folder / "moved/lib/epura";
  std::filesystem::create_directories(program.parent_path());
  std::filesystem::create_directories(library);
  std::filesystem::copy_file(EPURA_TEST_PROGRAM, program);
  std::filesystem::copy(EPURA_TEST_PLUGINS, library / "projections");
  const std::string old = folder.file("out.pdf", "an earlier drawing");
  const auto draw = [&](const std::string& output) {
    const int status = std::system(("cd " + (folder / "").string() + " && env -u EPURA_PLUGIN_PATH " +
                                    program.string() + " draw cube.obj -o " + output + " 2>err")
                                       .c_str());
    return WEXITSTATUS(status);
  };
  EXPECT_EQ(draw("out.svg"), 0);
  EXPECT_EQ(draw("out.pdf"), 4);
  EXPECT_EQ(read_file(old), "an earlier drawing");
  EXPECT_TRUE(contains(read_file(folder / "err"), (library / "pdf-").string()));
  EXPECT_TRUE(contains(read_file(folder / "err"), "reinstall epura"));
}

TEST_F(Refusal, DevicesInPlaceOfFiles) {
  for (const char* name : {"z.obj", "z.toml", "z.svg", "z.json", "z.pdf"})
    std::filesystem::create_symlink("/dev/zero", folder / name);
  const Words said = {"is a device, not a file"};
  for (const char* name : {"/dev/zero", "z.obj", "z.toml"}) expect_draw_refused({name}, said);
  for (const char* name : {"z.svg", "z.json", "z.pdf"}) expect_refused({"compare", name, name}, 2, said);
}

TEST_F(Refusal, MoreViewsThanADrawingHas) {
  std::string list = "front", scene = "[[model]]\nfile = 'cube.obj'\n";
  for (int i = 0; i < 1000; ++i) list += ",top";
  expect_option_refused({"--views", list}, {"--views", "requests 1001 views; a drawing can have at most 1000"});
  for (int i = 0; i < 1200; ++i) scene += "[[view]]\nprojection='top'\n";
  expect_draw_refused({folder.file("scene.toml", scene)}, {"scene.toml:2402:12", "requests 1200 views"});
  expect_draw_refused({folder.file("scene.toml", "views = '" + list + "'\n[[model]]\nfile = 'cube.obj'\n")},
                      {"scene.toml:1:9", "requests 1001 views"});
}

}  // namespace
}  // namespace epura::test::refusal_test
