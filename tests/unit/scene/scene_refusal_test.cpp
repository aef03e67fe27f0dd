// SPDX-License-Identifier: Apache-2.0
// Scene files that are refused: the place, the reason and the hint, word by word.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "scene/scene_file.hpp"

namespace epura::test::scene_refusal_test {
namespace {

struct Refusal {
  std::string text;      ///< of the file
  std::string sentence;  ///< "line:column: reason"
  std::string hint;
};

void expect_refusals(const std::string& head, const std::vector<Refusal>& refusals) {
  const Folder folder;
  for (const Refusal& refusal : refusals) {
    const std::string path = folder.file("scene.toml", head + refusal.text);
    const Error error = error_of([&] { scene::read_scene_file(path); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.what(), path + ":" + refusal.sentence) << refusal.text.substr(0, 200);
    EXPECT_EQ(error.hint(), refusal.hint) << refusal.text.substr(0, 200);
  }
}

const std::string model = "[[model]]\nfile = 'a.obj'\n";                  // lines 1 and 2
const std::string view = model + "[[view]]\nprojection = 'front'\n";      // lines 3 and 4
const std::string dimension = view + "[[dimension]]\ntype = 'linear'\n";  // lines 5 and 6
const std::string quotes = "put it in quotes";
const std::string values = "values are like \"text\", 1.5, true or [1, 2]; see toml.io";
const std::string empty = "omit it, or give a value";
const std::string features = "write \"hole 3\" or \"face 12\": epura info and epura new-scene number them";
const std::string anchors = "[model, vertex], {point = [x, y, z]} or a feature, \"hole 3\"";

TEST(SceneRefusal, WhatIsMissing) {
  const std::string hint = "a scene file needs at least:  [[model]]  file = \"part.obj\"";
  expect_refusals(
      "", {
              {"", " names no model", hint},
              {"# nothing\n", " names no model", hint},
              {"[sheet]\nsize = 'A4'\n", " names no model", hint},
              {"[[model]]\nname = 'a'\n", "1:1: [[model]] lacks 'file'",
               "obj, stl, ply, off or what an importer reads, with `:key=value` for its parameters; relative paths "
               "start at the scene file"},
              {model + "[[view]]\n", "3:1: [[view]] lacks 'projection'",
               "`NAME[:key=value...]`, or `{name = NAME, key = value}`"},
              {model + "[[section]]\n", "3:1: [[section]] lacks 'name'", "name to which views refer, such as `A`"},
              {model + "[[detail]]\nname = 'X'", "3:1: [[detail]] lacks 'centre'", "point of the world in its middle"},
              {"view = [{projection = {eye = [1, 2, 3]}}]\n" + model, "1:23: 'projection' lacks 'name'",
               "{name = \"look-at\", eye = [4, -9, 5]}"},
          });
}

TEST(SceneRefusal, UnknownKeys) {
  expect_refusals(
      "",
      {
          {"[[modle]]\n", "1:3: 'modle' is not a key of a scene file", "did you mean 'model'?"},
          {model + "unti = 'mm'", "3:1: 'unti' is not a key of [[model]]", "did you mean 'unit'?"},
          {model + "views = ['front']", "3:1: 'views' is not a key of [[model]]", "it belongs above the first section"},
          {view + "crease-angle = 3", "5:1: 'crease-angle' is not a key of [[view]]", "did you mean 'crease_angle'?"},
          {model + "[sheet]\nsice = 'A4'", "4:1: 'sice' is not a key of [[sheet]]", "did you mean 'size'?"},
          {model + "[all_sheets.title_block]", "3:13: 'title_block' is not a key of [all_sheets]",
           "known: size, orientation, scale, angle, layout, fit, frame, decimals, dimension_unit, decimal_sign, font, "
           "template, "
           "logo, style"},
          {model + "[title_block]\ntitel = 'A'", "4:1: 'titel' is not a key of [title_block]", "did you mean 'title'?"},
          {model + "[sheet.title_block]\ntitel = 'A'", "4:1: 'titel' is not a key of [sheet.title_block]",
           "did you mean 'title'?"},
          {model + "[title_block.free]\n\"a\\nb\" = 'A'", "4:1: a key is empty or has a control character", ""},
          {model + "[title_block.free]\n'' = 'A'", "4:1: a key is empty or has a control character", ""},
          {model + "[title_block.free]\ntitle = 'A'", "4:1: 'title' is not a free field", "put it into [title_block]"},
      });
}

TEST(SceneRefusal, ValuesOfAnotherKind) {
  expect_refusals("", {
                          {"model = 3", "1:9: 'model' is a number, a table is wanted", ""},
                          {"model = [{file = 'a'}, 3]", "1:24: 'model' is a number, a table is wanted", ""},
                          {"[[model]]\nfile = 3", "2:8: 'file' is a number, a text is wanted", quotes},
                          {"[[model]]\nfile = true", "2:8: 'file' is true or false, a text is wanted", quotes},
                          {"[[model]]\nfile = ['a.obj']", "2:8: 'file' is a list, a text is wanted", ""},
                          {"[[model]]\nfile = {}", "2:8: 'file' is a table, a text is wanted", ""},
                          {"[[model]]\nfile = 2026-11-21", "2:8: 'file' is a date, a text is wanted", quotes},
                          {model + "drawn = 'no'", "3:9: 'drawn' is a text, true or false is wanted", ""},
                          {view + "near = '3'", "5:8: 'near' is a text, a number is wanted", ""},
                          {view + "at = 3", "5:6: 'at' is a number, a list is wanted", ""},
                          {view + "at = [3, 'x']", "5:10: 'at' is a text, a number is wanted", ""},
                          {view + "at = [3]", "5:6: 'at' has 1 elements, 2 numbers are wanted", ""},
                          {view + "edges = 7", "5:9: 'edges' is a number, a list is wanted", ""},
                          {view + "scale = true", "5:9: 'scale' is true or false, a text is wanted", quotes},
                          {model + "[title_block]\ndate = 10:20:00", "4:8: 'date' is a time, a text is wanted", quotes},
                          {model + "[title_block]\nmass = 2.5", "4:8: 'mass' is a number, a text is wanted", quotes},
                          {model + "[title_block]\nfree = 'x'", "4:8: 'free' is a text, a table is wanted", ""},
                          {model + "[[all_sheets]]", "3:1: 'all_sheets' is a list, a table is wanted", ""},
                      });
}

TEST(SceneRefusal, ValuesOutOfRange) {
  expect_refusals("", {
                          {view + "crease_angle = 180.5", "5:16: 'crease_angle' is 180.5, allowed is 0 to 180", ""},
                          {view + "near = nan", "5:8: 'near' is not a finite number", ""},
                          {view + "far = -inf", "5:7: 'far' is not a finite number", ""},
                          {view + "at = [0, inf]", "5:10: 'at' is not a finite number", ""},
                          {model + "[[detail]]\nname = 'X'\ncentre = [1, 2]",
                           "5:10: 'centre' has 2 elements, 3 numbers are wanted", ""},
                          {model + "[[detail]]\nname = 'X'\ncentre = [0, 0, 0]\nradius = 0",
                           "6:10: 'radius' is 0, more than 0 is wanted", ""},
                          {model + "[[detail]]\nname = 'X'\ncentre = [0, 0, 0]\nradius = -1.5",
                           "6:10: 'radius' is -1.5, more than 0 is wanted", ""},
                          {model + "[[detail]]\nname = 'X'\ncentre = [0, 0, 0]\nsize = [1, 0]",
                           "6:8: 'size' has a number that is not above 0", ""},
                          {view + "sheet = 0", "5:9: 'sheet' is 0, allowed is 1 or more", ""},
                          {view + "sheet = 1.5", "5:9: 'sheet' is 1.5, a whole number is wanted", ""},
                          {view + "sheet = 3000000000", "5:9: 'sheet' is 3e+09, allowed is 1 to 2147483647", ""},
                          {"[[model]]\nfile = ''", "2:8: 'file' is empty", empty},
                          {"[[model]]\nfile = 'a\tb'", "2:8: 'file' has a line break or another control character",
                           "write it on one line"},
                          {"[[model]]\nfile = \"a\\u0000b\"",
                           "2:8: 'file' has a line break or another control character", "write it on one line"},
                          {"[[model]]\nfile = '''a\nb'''", "2:8: 'file' has a line break or another control character",
                           "write it on one line"},
                          {"views = []\n" + model, "1:9: 'views' is empty", empty},
                          {"views = 'front,,top'\n" + model, "1:9: 'views' has an empty element", empty},
                          {model + "[[section]]\nname = 'A'\nnormal = [0, -0.0, 0]",
                           "5:10: 'normal' is zero and has no direction", ""},
                      });
}

TEST(SceneRefusal, NamesThatLeadNowhereOrToTwoThings) {
  const std::string detail = "[[detail]]\nname = 'X'\ncentre = [0, 0, 0]\nradius = 1\n";
  const std::string section = model + "[[section]]\nname = 'A'\n";
  const std::string one = "names must be unique";
  expect_refusals(
      "", {
              {model + "name = 'x'\n" + model + "name = 'x'", "6:8: 'x' is the name of an earlier model", one},
              {model + detail + detail, "8:8: 'X' is the name of an earlier detail", one},
              {section + "[[section]]\nname = 'A'", "6:8: 'A' is the name of an earlier section", one},
              {view + "name = 'x'\n[[view]]\nprojection = 'top'\nname = 'x'", "8:8: 'x' is the name of an earlier view",
               one},
              {view + "section = 'A'", "5:11: there is no section 'A'", "there is no [[section]]"},
              {section + "[[view]]\nprojection = 'left'\nsection = 'B'", "7:11: there is no section 'B'", "known: A"},
              {view + "sheet = 2", "4:14: the view is for sheet 2 of 1", "add a [[sheet]]"},
              {dimension + "from = [0, 1]\nto = [0, 2]\nview = 'frnt'", "9:8: there is no view 'frnt'",
               "did you mean 'front'?"},
          });
}

TEST(SceneRefusal, Anchors) {
  expect_refusals(dimension,
                  {
                      {"", "5:1: a dimension of type 'linear' lacks 'from'", anchors},
                      {"from = [0, 1]", "5:1: a dimension of type 'linear' lacks 'to'", anchors},
                      {"from = [0, 1]\nto = [0, 2]\nat = [0, 3]", "9:6: a dimension of type 'linear' has no 'at'",
                       "known: from, to"},
                      {"from = [1, 1]\nto = [0, 2]", "7:8: there is no model 1", "models are numbered from 0 to 0"},
                      {"from = ['b', 1]\nto = [0, 2]", "7:8: there is no model 'b'", "known: a"},
                      {"from = [0, -1]", "7:12: 'from' is -1, allowed is 0 or more", ""},
                      {"from = [0, 'x']", "7:12: 'x' is not a feature", features},
                      {"from = [0]", "7:8: 'from' has 1 elements instead of [model, vertex]",
                       "a point of the world is {point = [x, y, z]}"},
                      {"from = {piont = [0, 0, 0]}", "7:8: 'from' is not an anchor", anchors},
                      {"from = {point = [0, 0]}", "7:17: 'point' has 2 elements, 3 numbers are wanted", ""},
                      {"from = 'a:1'", "7:8: 'a:1' is not a feature", features},
                  });
  expect_refusals(
      view + "[[dimension]]\n",
      {
          {"type = 'diametre'", "6:8: 'type': unknown value 'diametre'", "did you mean 'diameter'?"},
          {"type = 'radius'\nfrom = [0, 1]", "5:1: a dimension of type 'radius' lacks 'at'", anchors},
          {"type = 'overall'\nat = [0, 1]", "7:6: a dimension of type 'overall' has no 'at'", "it has no anchors"},
      });
}

TEST(SceneRefusal, AnchorsOnModelsThatCannotBeMeant) {
  const std::string radius = "[[dimension]]\ntype = 'radius'\n";
  expect_refusals(
      "", {
              {model + "drawn = false\n" + radius + "at = ['a', 1]", "6:6: the model is not drawn and has no vertices",
               "give the position as {point = [x, y, z]}"},
              {model + model + radius + "at = ['a', 1]", "7:6: several models are called 'a'",
               "give them different names, or use a number"},
          });
}

TEST(SceneRefusal, WhatIsNoToml) {
  expect_refusals(
      "", {
              {"[[model]]\nfile = a.obj", "2:8: is not valid TOML: while parsing value: could not determine value type",
               values},
              {"[[model]\n", "1:9: is not valid TOML: while parsing table header: expected ']', saw '\\n'", values},
              {"[Maß]", "1:4: is not valid TOML: while parsing table header: expected ']', saw 'ß'", values},
              {"[ä]",
               "1:2: is not valid TOML: while parsing key: expected bare key starting character or string delimiter, "
               "saw 'ä'",
               values},
              {"[[+]]",
               "1:3: is not valid TOML: while parsing key: expected bare key starting character or string delimiter, "
               "saw '+'",
               values},
              {"a = i\nb", "1:6: is not valid TOML: while parsing floating-point: expected 'inf', saw 'i '", values},
              {"name 'x'", "1:6: is not valid TOML: while parsing key-value pair: expected '=', saw '''", values},
              {"a = 'x", "1:7: is not valid TOML: while parsing string: encountered end-of-file", values},
              {model + "file = 'b'",
               "3:8: is not valid TOML: while parsing key-value pair: cannot redefine existing string 'file'", values},
              {"a = \"\xff\"", "1:5: is not valid TOML: encountered invalid utf-8 sequence", values},
              {"a = " + std::string(100'000, '['),
               "1:13: is not valid TOML: while parsing value: exceeded maximum nested value depth of 8", values},
          });
}

TEST(SceneRefusal, WhatWouldExhaustMemoryOrStack) {
  std::string keys = "a";
  for (int i = 0; i < 500'000; ++i) keys += ".a";
  const std::string hint = "dots in a key nest tables; write a shorter key";
  expect_refusals("", {
                          {model + keys + " = 1", "3: has more than 100 dots in a key", hint},
                          {"\n[" + keys + "]\n", "2: has more than 100 dots in a key", hint},
                          {std::string(3'000'000, '['), " has more than 2 MB", "is it the right file?"},
                      });
}

// Behind all that may stand beside a key and hold dots or quotes itself.
TEST(SceneRefusal, KeysWithManyDotsAnywhere) {
  std::string keys = "a";
  for (int i = 0; i < 200'000; ++i) keys += i % 2 == 0 ? ".a" : " . 'b'";
  const auto refused = [](int line) { return std::to_string(line) + ": has more than 100 dots in a key"; };
  const std::string hint = "dots in a key nest tables; write a shorter key";
  expect_refusals(model, {{"name = 'a' # '\n" + keys + " = 1", refused(4), hint},
                          {"name = \"\\\"\"\n" + keys + " = 1", refused(4), hint},
                          {"name = \"\"\"\n\\\"\"\"\"\"\n" + keys + " = 1", refused(5), hint},
                          {"name = '''\n'''''\n" + keys + " = 1", refused(5), hint},
                          {"name = [[{b = '', " + keys + " = 1}]]", refused(3), hint},
                          {"name = {" + keys + " = 1}", refused(3), hint}});
}

TEST(SceneFile, DotsThatNestNothingAreFine) {
  const Folder folder;
  const auto models = [&](const std::string& text) {
    return scene::read_scene_file(folder.file("scene.toml", text)).models.size();
  };
  std::string many = "model=[";
  for (int i = 0; i < 200; ++i)
    many += "{file=\"cube.obj\",transform=\"translate:" + std::to_string(i) + ".5,0.0,0\"},";
  EXPECT_EQ(models(many + "]\nview=[{projection='front'}]\n"), 200U);
  const std::string dots(1000, '.');
  EXPECT_EQ(models("# " + dots + "\n" + model + "name = 'a' # " + dots), 1U);
  EXPECT_EQ(models(model + "name = '" + dots + "'"), 1U);
  EXPECT_EQ(models(model + "name = \"\"\"\\\n" + dots + "\"\"\""), 1U);
}

TEST(SceneRefusal, ModelsThatMayTakeMoreThanOthers) {
  const Folder folder;
  const std::string path = folder.file("scene.toml", "model = [{file = 'a.step:deflection=1:memory=100'}]");
  const Error error = error_of([&] { scene::read_scene_file(path); });
  EXPECT_STREQ(error.what(), (path + ":1:18: 'memory' changes what reading the file may take").c_str());
  EXPECT_EQ(error.hint(), "--allow-outside allows it, if you trust the scene file");
  EXPECT_NO_THROW(scene::read_scene_file(path, scene::FilesOutside::allowed));
  EXPECT_NO_THROW(scene::read_scene_file(folder.file("b.toml", "model = [{file = 'a.step:deflection=1'}]")));
}

TEST(SceneRefusal, FilesThatAreNone) {
  const Folder folder;
  const std::string missing = folder / "missing.toml";
  EXPECT_EQ(error_of([&] { scene::read_scene_file(missing); }).what(),
            missing + ": cannot read: No such file or directory");
  const std::string path = folder / "";
  EXPECT_EQ(error_of([&] { scene::read_scene_file(path); }).what(), path + ": is a directory, not a file");
}

}  // namespace
}  // namespace epura::test::scene_refusal_test
