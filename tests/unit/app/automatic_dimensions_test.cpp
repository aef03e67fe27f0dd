// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of parts whose features are known, and what `epura lint` says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <regex>

#include "at_length.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_hexagons.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::automatic_dimensions_test {
namespace {

class AutomaticDimensions : public testing::Test {
 protected:
  Folder folder;

  Outcome lint(const std::string& model, const std::string& dimensions, const Words& more = {}) {
    Words arguments{"lint",    model, "--views", "front,top,left", "--dimensions", dimensions,
                    "--sheet", "A3",  "-o",      "x.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "");
  }
  static void expect_complete(const KnownPart& part, const Outcome& run) {
    EXPECT_EQ(run.code, part.lacks.empty() ? 0 : 1) << part.name << ": " << run.out << run.err;
    EXPECT_TRUE(contains(run.out, part.lacks)) << part.name << ": " << run.out;
  }
  void expect_known(const std::vector<KnownPart>& parts) {
    for (const KnownPart& part : parts) {
      expect_complete(part, lint(folder.file("part.obj", part.obj), "auto"));
      EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(part.texts)) << part.name;
    }
  }
};

TEST_F(AutomaticDimensions, OfPlatesAreEachThereOnce) { expect_known(plates()); }
TEST_F(AutomaticDimensions, OfRoundPartsAreEachThereOnce) { expect_known(round_parts()); }
TEST_F(AutomaticDimensions, OfBlocksAreEachThereOnce) { expect_known(blocks()); }
TEST_F(AutomaticDimensions, OfHexagonsAreEachThereOnce) { expect_known(hexagons()); }
TEST_F(AutomaticDimensions, OfInterruptedCirclesAreEachThereOnce) { expect_known(interrupted_circles()); }

// From one end of the part along each axis, each place once; of holes on a pitch circle, which axonometric views do not
// draw, none.
TEST_F(AutomaticDimensions, OfAxonometricViewsHavePlacesOfHoles) {
  const auto texts = [&](const std::string& obj, const char* view) {
    const Outcome run = epura({"draw", folder.file("part.obj", obj), "--projection", view, "--dimensions", "auto",
                               "--sheet", "A3", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return sorted(dimensions_in(read_file(folder / "x.svg")));
  };
  for (const char* view : {"isometric", "dimetric", "trimetric"}) {
    for (const int number : {0, 1, 4, 6}) {
      const KnownPart part = plates()[static_cast<std::size_t>(number)];
      EXPECT_EQ(texts(part.obj, view), sorted(part.texts)) << part.name << ", " << view;
    }
    EXPECT_EQ(texts(round_parts()[0].obj, view), sorted({"⌀100", "12", "⌀30", "4× ⌀10"})) << view;
  }
}

// In whatever arrangement, lint finds that nothing is missing, repeated or crossing.
TEST_F(AutomaticDimensions, AreCompleteInEveryArrangement) {
  const std::array arrangements{"baseline", "chain", "ordinate"};
  std::size_t number = 0;
  for (const auto& parts : {plates(), round_parts(), blocks(), hexagons(), interrupted_circles()})
    for (const KnownPart& part : parts) {
      ++number;
      for (std::size_t i = 0; i < arrangements.size(); ++i) {
        if (!at_length() && i != number % arrangements.size()) continue;
        SCOPED_TRACE(arrangements[i]);
        expect_complete(part, lint(folder.file("part.obj", part.obj), "auto", {"--arrangement", arrangements[i]}));
      }
    }
}

// Measured apart from lint: no text lies on another one.
TEST_F(AutomaticDimensions, HaveTextsThatDoNotTouch) {
  for (const auto& parts : {plates(), round_parts(), blocks(), hexagons(), interrupted_circles()})
    for (const KnownPart& part : parts) {
      expect_complete(part, lint(folder.file("part.obj", part.obj), "auto", {"--svg-text", "text"}));
      const auto boxes = boxes_in(read_file(folder / "x.svg"));
      EXPECT_GE(boxes.size(), part.texts.size()) << part.name;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
          EXPECT_FALSE(sheet::overlap(boxes[i].second, boxes[j].second))
              << part.name << ": " << boxes[i].first << " on " << boxes[j].first;
    }
}

TEST_F(AutomaticDimensions, SayTheSameInOtherArrangements) {
  const std::string holes = folder.file("part.obj", plates()[1].obj);
  const Words common{"80", "60", "10", "4× ⌀8"};
  const std::vector<std::pair<const char*, Words>> arranged{{"baseline", {"20", "60", "15", "45"}},
                                                            {"chain", {"20", "40", "15", "30"}},
                                                            {"ordinate", {"0", "20", "60", "0", "15", "45"}}};
  for (const auto& [arrangement, positions] : arranged) {
    EXPECT_EQ(lint(holes, "auto", {"--arrangement", arrangement}).code, 0);
    Words expected = common;
    expected.insert(expected.end(), positions.begin(), positions.end());
    EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(expected)) << arrangement;
  }
}

// More parallel lines than a person follows become one row.
TEST_F(AutomaticDimensions, OfManyStepsHaveACommonOrigin) {
  const Outcome run = lint(folder.file("part.obj", block(stairs(13), 30)), "auto");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  Words expected{"65", "52", "30", "0", "0"};
  for (int i = 1; i < 13; ++i) {
    expected.push_back(std::to_string(5 * i));
    expected.push_back(std::to_string(4 * i));
  }
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(expected));
}

// The shaft has a diameter of 30 there, and a collar of 50; the floor of its keyway is 11 above the axis.
TEST_F(AutomaticDimensions, OfKeywaysBeginAtTheOtherSideOfTheirShaft) {
  for (const char* turn : {"rotate:x,0", "rotate:x,90", "rotate:x,180", "rotate:x,270"})
    for (const char* arrangement : {"", "baseline", "chain", "ordinate"}) {
      Words more{"--transform", turn};
      if (*arrangement != 0) more.insert(more.end(), {"--arrangement", arrangement});
      const Outcome run = lint(sample("shaft.obj"), "auto", more);
      EXPECT_EQ(run.code, 0) << turn << " " << arrangement << ": " << run.out << run.err;
      const Words texts = dimensions_in(read_file(folder / "x.svg"));
      EXPECT_EQ(std::count(texts.begin(), texts.end(), "26"), 1) << turn << " " << arrangement;
      EXPECT_EQ(std::count(texts.begin(), texts.end(), "36"), 0) << turn << " " << arrangement;
    }
}

TEST_F(AutomaticDimensions, ArrangementsNeedThem) {
  const Outcome run = lint(folder.file("part.obj", plates()[1].obj), "overall", {"--arrangement", "chain"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--arrangement: needs automatic dimensions")) << run.err;
}

// Positions from the lower left corner, numbered from left to right and upwards; lint counts them.
TEST_F(AutomaticDimensions, OfHolesInATable) {
  const Outcome run = lint(folder.file("part.obj", plates()[1].obj), "hole-table");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Words expected{"80",   "60", "10", "A1",   "A2", "A3", "A4",        // dimensions and labels
                       "X",    "Y",                                         // at the origin
                       "Hole", "X",  "Y",  "Size",                          // captions
                       "A1",   "20", "15", "⌀8",   "A2", "20", "45", "⌀8",  // rows
                       "A3",   "60", "15", "⌀8",   "A4", "60", "45", "⌀8"};
  const Words found = dimensions_in(read_file(folder / "x.svg"));
  EXPECT_EQ(sorted(found), sorted(expected));
  const auto first = std::search(found.begin(), found.end(), expected.begin() + 13, expected.end());
  EXPECT_NE(first, found.end()) << "the rows are not in order";
}

TEST_F(AutomaticDimensions, OfBlindHolesInATable) {
  const Outcome run = lint(folder.file("part.obj", plates()[6].obj), "hole-table");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Words found = dimensions_in(read_file(folder / "x.svg"));
  EXPECT_EQ(std::count(found.begin(), found.end(), "⌀6.6 ⌴⌀11 ↧6.5"), 4);
}

// From both ends: the only view along them shows one behind the other.
TEST_F(AutomaticDimensions, OfHolesBehindOthersHaveOneNote) {
  const Loop profile{{10, 1e-9}, {10, 5}, {0, 5}, {0, 15}, {60, 15}, {60, 5}, {50, 5}, {50, 1e-9}};
  expect_known({{"two bores", shaft(profile), {"2× ⌀10 ↧10", "60", "⌀30"}}});
}

TEST_F(AutomaticDimensions, TableWithoutRoomIsReported) {
  const std::string part = folder.file("part.obj", plates()[3].obj);
  const std::vector<std::string> sheet{part,      "--projection", "top",     "--dimensions", "hole-table",
                                       "--sheet", "110x110",      "--scale", "1:1"};
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin() + 1, sheet.begin(), sheet.end());
    return epura(words, folder / "");
  };
  const Outcome drawn = run({"draw", "-o", "x.svg"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "the sheet has no room for the table of the holes")) << drawn.err;
  const Outcome judged = run({"lint"});
  EXPECT_EQ(judged.code, 1) << judged.out;
  EXPECT_TRUE(contains(judged.out, "there is no room for the table of the holes")) << judged.out;
}

TEST_F(AutomaticDimensions, HolesBelongToAutomaticOnes) {
  folder.file("part.obj", plates()[0].obj);
  const std::string scene =
      folder.file("scene.toml", "[[model]]\nfile = 'part.obj'\n[[dimension]]\ntype = 'overall'\nholes = 'table'\n");
  const Outcome run = epura({"draw", scene, "-o", "x.svg"}, folder / "");
  EXPECT_NE(run.code, 0);
  EXPECT_TRUE(contains(run.err, "5:9: a dimension of type 'overall' has no 'holes'")) << run.err;
}

// Diameters that are written as 3.17 and 3.18, as in files of single precision.
TEST_F(AutomaticDimensions, LintKnowsEqualHolesThatAreRoundedApart) {
  const auto hole = [](const Vec2& centre) {
    const double radius = centre.x < 40 ? 1.58749 : 1.58751;
    return stepped_hole({{radius, 8}, {radius, 0}})(centre);
  };
  EXPECT_EQ(lint(folder.file("part.obj", plate({40, 30}, 2, 1, 8, hole)), "auto").code, 0);
}

// Two of the holes, which have notes of their own, have one axis.
TEST_F(AutomaticDimensions, LintCountsANoteForTheFeaturesThatItDescribes) {
  const auto plate_without = [&](double cell) {
    return plate({40, 30}, 3, 1, 8, [=](const Vec2& centre) {
      return std::abs(centre.x - cell) < 1 ? Hole{} : stepped_hole({{5, 8}, {5, 0}})(centre);
    });
  };
  folder.file("lower.obj", plate_without(60));
  folder.file("upper.obj", plate_without(20));
  const Outcome run = epura(
      {"lint",
       folder.file("scene.toml",
                   "[[model]]\nfile = 'lower.obj'\n[[model]]\nfile = 'upper.obj'\ntransform = 'translate:0,0,20'\n"
                   "[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'top'\n[[dimension]]\ntype = 'auto'\n")},
      folder / "");
  EXPECT_EQ(run.code, 0) << run.out;
}

// What cannot be checked is not passed over in silence.
TEST_F(AutomaticDimensions, LintNamesWhatItCannotCheck) {
  const std::string file = folder.file("part.obj", plates()[0].obj);
  const Outcome mesh = epura({"lint", file, "--views", "front,top,left", "--dimensions", "overall", "--sheet", "A3",
                              "--surfaces", "mesh", "-o", "x.svg"},
                             folder / "");
  EXPECT_EQ(mesh.code, 1);
  EXPECT_TRUE(contains(mesh.out, "not dimensioned: model 0: nothing is recognised")) << mesh.out;
}

// The corners of a height field that no surface fits.
std::string scan() {
  constexpr int side = 24;
  std::mt19937 random(5);
  std::string obj;
  for (int i = 0; i < side * side; ++i)
    obj += "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " " +
           std::to_string(double(random() % 1000) / 1000) + "\n";
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 1; x < side; ++x) {
      const int at = y * side + x;
      obj += "f " + std::to_string(at) + " " + std::to_string(at + 1) + " " + std::to_string(at + side + 1) + "\nf " +
             std::to_string(at) + " " + std::to_string(at + side + 1) + " " + std::to_string(at + side) + "\n";
    }
  return obj;
}

// All of it is free form, for which a note refers to the model.
TEST_F(AutomaticDimensions, ReferToModelsInWhichNothingIsRecognised) {
  const std::string part = folder.file("scan.obj", scan());
  const Outcome noted = lint(part, "auto");
  EXPECT_EQ(noted.code, 0) << noted.out << noted.err;
  EXPECT_TRUE(contains(noted.err, "model 0: nothing is recognised, so none of its features has a size")) << noted.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"Free forms as in the 3D model scan.obj\""));
  const Outcome overall = lint(part, "overall");
  EXPECT_EQ(overall.code, 1);
  EXPECT_TRUE(contains(overall.out, "not dimensioned: model 0: nothing is recognised")) << overall.out;
}

// A drawing refers to the model for free forms: by the note of automatic dimensions, or by profile tolerances.
TEST_F(AutomaticDimensions, SayWhereFreeFormsAreDefined) {
  const std::string part = folder.file("part.obj", waves());
  const Outcome noted = lint(part, "auto");
  EXPECT_EQ(noted.code, 0) << noted.out << noted.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"Free forms as in the 3D model part.obj\""));
  const Outcome german = lint(part, "auto", {"--language", "de"});
  EXPECT_EQ(german.code, 0) << german.out << german.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "Freiformflächen nach 3D-Modell part.obj"));
  const Outcome swedish = lint(part, "auto", {"--language", "sv"});
  EXPECT_TRUE(contains(swedish.err, "there are no captions in the language 'sv': they are in English")) << swedish.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "Free forms as in"));
  const std::string fault = "not dimensioned: model 0: faces of free form, 27.";
  const Outcome overall = lint(part, "overall");
  EXPECT_EQ(overall.code, 1);
  EXPECT_TRUE(contains(overall.out, fault)) << overall.out;
  const auto with_frame = [&](const std::string& to) {
    return epura({"lint", folder.file("scene.toml",
                                      "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n[[view]]\n"
                                      "projection = 'top'\n[[dimension]]\ntype = 'overall'\n[[tolerance_frame]]\n"
                                      "characteristic = 'surface-profile'\nzone = '0.2'\nview = 'top'\n" +
                                          to)},
                 folder / "");
  };
  EXPECT_FALSE(contains(with_frame("").out, fault)) << "for all";
  EXPECT_FALSE(contains(with_frame("to = ['part', 312]\n").out, fault)) << "in the middle of the waves";
  EXPECT_TRUE(contains(with_frame("to = {point = [30, 0, 10]}\n").out, fault)) << "on another face";
}

// Boxes along the diagonal of a larger one.
std::string machine(int boxes) {
  std::string obj;
  for (int i = 0; i < boxes; ++i) {
    for (int corner = 0; corner < 8; ++corner)
      obj += "v " + std::to_string(11 * i + 8 * (corner >> 2 & 1)) + " " +
             std::to_string(7 * i + 5 * (corner >> 1 & 1)) + " " + std::to_string(5 * i + 4 * (corner & 1)) + "\n";
    for (const auto& face :
         {std::array{1, 2, 4, 3}, {5, 7, 8, 6}, {1, 5, 6, 2}, {3, 4, 8, 7}, {1, 3, 7, 5}, {2, 6, 8, 4}}) {
      obj += "f";
      for (const int corner : face) obj += " " + std::to_string(8 * i + corner);
      obj += "\n";
    }
  }
  return obj;
}

TEST_F(AutomaticDimensions, LintAdvisesToDrawThePartsOfMachines) {
  const std::string hint = "  hint: the models have 24 bodies: draw the parts on sheets of their own";
  const std::string part = folder.file("machine.obj", machine(24));
  EXPECT_TRUE(contains(lint(part, "overall").out, hint));
  EXPECT_FALSE(contains(lint(folder.file("machine.obj", machine(12)), "overall").out, "draw the parts"));
  folder.file("machine.obj", machine(24));
  const Outcome small = epura({"lint", part, "--views", "front,top,left", "--dimensions", "auto", "--sheet", "A4",
                               "--frame", "none", "--transform", "scale:1234.5", "--scale", "1:1000"},
                              folder / "");
  static const std::regex row("left out: '[^']{40,70} and \\d+ others'");
  EXPECT_TRUE(std::regex_search(small.err, row)) << small.err;
  EXPECT_FALSE(contains(small.out, " others'")) << small.out;
}

// What the sheet has no room for is left out and told; only leaders cross, which is told, too.
TEST_F(AutomaticDimensions, WithoutRoomAreLeftOut) {
  const auto each_differs = [](const Vec2& centre) {
    const double radius = 2 + centre.x / 40 + centre.y / 100;
    return stepped_hole({{radius, 6}, {radius, 0}})(centre);
  };
  const std::string part = folder.file("part.obj", plate({20, 24}, 3, 3, 6, each_differs));
  const Words small{"--projection", "top",     "--dimensions", "auto",       "--sheet", "75x75", "--frame",
                    "none",         "--scale", "1:2",          "--svg-text", "text",    "-o",    "x.svg"};
  const auto run = [&](Words arguments) {
    arguments.push_back(part);
    arguments.insert(arguments.end(), small.begin(), small.end());
    return epura(arguments, folder / "");
  };
  const Outcome drawn = run({"draw"});
  EXPECT_TRUE(contains(drawn.err, "the sheet has no room for ")) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, ", which are left out: '")) << drawn.err;
  const auto boxes = boxes_in(read_file(folder / "x.svg"));
  EXPECT_GE(boxes.size(), 3);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const sheet::Rectangle around = sheet::around(boxes[i].second);
    EXPECT_TRUE((sheet::Rectangle{{0, 0}, {75, 75}}.holds(around))) << boxes[i].first;
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      EXPECT_FALSE(sheet::overlap(boxes[i].second, boxes[j].second)) << boxes[i].first << " on " << boxes[j].first;
  }
  const Outcome checked = run({"lint", "--all"});
  EXPECT_EQ(checked.code, 1);
  EXPECT_TRUE(contains(checked.out, "not dimensioned: there is no room for '")) << checked.out;
  static const std::regex crossing("crossing: (?!'⌀[0-9.]+' and '⌀[0-9.]+' )");
  EXPECT_FALSE(std::regex_search(checked.out, crossing)) << checked.out;
}

// An estimate of the room for dimensions would take 1:5 for both.
TEST_F(AutomaticDimensions, ChooseTheLargestScaleAtWhichTheyFit) {
  const auto scale_on = [&](const char* size, const char* frame, const char* model) {
    const Outcome run = epura({"lint", sample(model), "--views", "front,top,left", "--dimensions", "auto", "--sheet",
                               size, "--frame", frame, "--scale", "auto", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    const std::string key = "the scale is ";
    const std::size_t begin = run.err.find(key) + key.size();
    return run.err.substr(begin, run.err.find(',', begin) - begin);
  };
  EXPECT_EQ(scale_on("250x180", "plain", "bracket.obj"), "1:2");
  EXPECT_EQ(scale_on("A4", "full", "flange.obj"), "1:5") << "at 1:2, the title block is in the way";
}

// A better layout is tried first: what is wrong with any is told.
TEST_F(AutomaticDimensions, TellWhatIsWrongOnAnySheet) {
  for (const char* size : {"auto", "A3"}) {
    const Outcome run = epura({"draw", sample("elbow.obj"), "--views", "front,top,left", "--dimensions", "auto",
                               "--sheet", size, "--max-error", "0.01", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_TRUE(contains(run.err, "--max-error: is 0.01 mm, but lines of view")) << run.err;
  }
}

// An estimate of the room would take A2 for the first. On A4, a length of the second would stand among those of another
// view. With half of the room, the third would be on A1, without some of its dimensions.
TEST_F(AutomaticDimensions, ChooseTheSmallestSheetOnWhichTheyFit) {
  const auto chosen = [&](const std::string& model, const Words& more) {
    Words arguments{"draw",    model,  "--views", "front,top,left", "--dimensions", "auto",
                    "--sheet", "auto", "-o",      "x.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 0) << model << ": " << run.err;
    EXPECT_FALSE(contains(run.err, "no room")) << model << ": " << run.err;
    const std::string json = read_file(folder / "x.json"), key = "\"sheet\": ";
    const std::size_t begin = json.find(key) + key.size();
    return json.substr(begin, json.find('}', begin) + 1 - begin);
  };
  EXPECT_EQ(chosen(sample("elbow.obj"), {}), R"({"size": [420, 297], "scale": 0.5})");
  EXPECT_EQ(chosen(sample("bracket.obj"), {"--scale", "1:2"}), R"({"size": [420, 297], "scale": 0.5})");
  EXPECT_EQ(chosen(sample("house.obj"), {}), R"({"size": [1189, 841], "scale": 0.02})");
  for (const auto& parts : {plates(), round_parts(), blocks()})
    for (const KnownPart& part : parts) chosen(folder.file("part.obj", part.obj), {});
}

// Notes cover nearly all of an A4 sheet, so that "auto" takes the next one.
TEST_F(AutomaticDimensions, ChooseTheSheetThatHasRoom) {
  folder.file("part.obj", plates()[3].obj);
  std::string notes;
  for (int y = 12; y < 205; y += 8)
    notes += "[[note]]\ntext = '" + std::string(60, 'W') + "'\nat = [12, " + std::to_string(y) + "]\n";
  const auto size_and_warning = [&](const std::string& size) {
    folder.file("scene.toml", "[[model]]\nfile = 'part.obj'\n[sheet]\nframe = 'plain'\nsize = '" + size +
                                  "'\n[[view]]\nprojection = 'top'\n[[dimension]]\ntype = 'auto'\n" + notes);
    const Outcome run = epura({"draw", "scene.toml", "-o", "x.svg"}, folder / "");
    const std::string svg = read_file(folder / "x.svg"), key = "viewBox=\"0 0 ";
    const std::size_t begin = svg.find(key) + key.size();
    return std::pair(svg.substr(begin, svg.find('"', begin) - begin), contains(run.err, "no room for"));
  };
  EXPECT_EQ(size_and_warning("A4"), std::pair(std::string("297 210"), true));
  EXPECT_EQ(size_and_warning("auto"), std::pair(std::string("420 297"), false));
}

TEST_F(AutomaticDimensions, LintFindsTextsOnLines) {
  folder.file("part.obj", blocks()[2].obj);
  const auto run = [&](const char* offset) {
    return epura({"lint", folder.file("scene.toml",
                                      "[[model]]\nfile = 'part.obj'\n[sheet]\nsize = 'A3'\nscale = '1:1'\n[[view]]\n"
                                      "projection = 'front'\n[[dimension]]\ntype = 'linear'\n"
                                      "direction = 'horizontal'\nfrom = {point = [20, 0, 0]}\n"
                                      "to = {point = [50, 0, 0]}\noffset = " +
                                          std::string(offset) + "\n")},
                 folder / "")
        .out;
  };
  EXPECT_TRUE(contains(run("21"), "crossing: '30' and a visible line (view 'front')"));  // an edge is at 24
  EXPECT_FALSE(contains(run("-12"), "crossing"));
}

TEST_F(AutomaticDimensions, LintFindsDimensionsOutsideADetail) {
  folder.file("part.obj", plates()[0].obj);
  const auto run = [&](const std::string& end) {
    const std::string scene =
        folder.file("scene.toml",
                    "[[model]]\nfile = 'part.obj'\n[[detail]]\nname = 'X'\ncentre = [25, 15, 8]\nradius = 12\n"
                    "[[view]]\nprojection = 'top'\n[[view]]\ndetail = 'X'\nscale = '2:1'\n[sheet]\nscale = '1:1'\n"
                    "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\nview = 'detail-X'\n"
                    "from = {point = [20, 15, 8]}\nto = {point = " +
                        end + "}\n");
    return epura({"lint", scene}, folder / "").out;
  };
  const std::string sentence = "ends outside the boundary of detail X (view 'detail-X')";
  EXPECT_TRUE(contains(run("[38, 15, 8]"), sentence)) << "13 mm from the centre";
  EXPECT_FALSE(contains(run("[36, 15, 8]"), sentence)) << "11 mm from the centre";
}

TEST_F(AutomaticDimensions, LintMissesChamfersAndSlopes) {
  const auto missing = [&](const std::string& name) {
    for (const KnownPart& part : blocks())
      if (part.name == name) return lint(folder.file("part.obj", part.obj), "overall").out;
    return std::string();
  };
  const std::string chamfer = missing("a chamfer"), slope = missing("a slope");
  EXPECT_TRUE(contains(chamfer, "not dimensioned: chamfer: position along x (55)\n")) << chamfer;
  EXPECT_TRUE(contains(chamfer, "not dimensioned: chamfer: position along z (25)\n")) << chamfer;
  EXPECT_TRUE(contains(slope, "not dimensioned: slope: position along x (40)\n")) << slope;
  EXPECT_TRUE(contains(slope, "not dimensioned: slope: position along z (20)\n")) << slope;
}

TEST_F(AutomaticDimensions, LintSaysWhatIsMissing) {
  const std::string part = folder.file("part.obj", plates()[4].obj);
  const Outcome run = lint(part, "overall");
  EXPECT_EQ(run.code, 1);
  for (const char* sentence : {"not dimensioned: 2× hole ⌀8 ↧18\n", "hole ⌀8: position along x (20)",
                               "hole ⌀8: position along x (60)", "hole ⌀8: position along y (20)"})
    EXPECT_TRUE(contains(run.out, sentence)) << sentence << "\n" << run.out;
  const Outcome json =
      epura({"lint", part, "--views", "front,top,left", "--dimensions", "overall", "--json", "-"}, folder / "");
  EXPECT_TRUE(contains(json.out, "\"fault\": true, \"what\": \"2× hole ⌀8 ↧18\"}")) << json.out;
}

// Turned in the plane of the front view, it has its diameters there; turned out of it, all its sizes after the
// transform that lint proposes.
TEST_F(AutomaticDimensions, OfShaftsThatLieAskew) {
  const std::string part =
      folder.file("part.obj", shaft({{0, 1e-9}, {0, 10}, {40, 10}, {40, 15}, {100, 15}, {100, 1e-9}}));
  const Outcome in_plane = lint(part, "auto", {"--transform", "rotate:y,30"});
  const std::string no_lengths = "completeness: 0 of 3 plane faces, 2 of 2 cylindrical faces, ";
  EXPECT_TRUE(contains(in_plane.out, no_lengths) && !contains(in_plane.out, "⌀")) << in_plane.out << in_plane.err;
  const std::vector<std::string> texts = dimensions_in(read_file(folder / "x.svg"));
  for (const char* diameter : {"⌀20", "⌀30"})
    EXPECT_EQ(std::count(texts.begin(), texts.end(), diameter), 1) << diameter;

  const std::string turned = "rotate:y,30 rotate:z,20";
  const Outcome askew = lint(part, "auto", {"--transform", turned});
  EXPECT_EQ(askew.code, 1);
  EXPECT_TRUE(contains(askew.out, "cylinder ⌀20, which no view shows in its true form\n")) << askew.out;
  const Outcome along = lint(part, "auto", {"--transform", turned + " " + proposed_transform(askew.out)});
  EXPECT_EQ(along.code, 0) << along.out;
  EXPECT_TRUE(contains(along.out, "completeness: 3 of 3 plane faces, 2 of 2 cylindrical faces, ")) << along.out;
  // Where a view beside its axis could have them, none need be added.
  const Outcome beside = epura({"lint", part, "--projection", "front", "--dimensions", "overall"}, folder / "");
  EXPECT_TRUE(contains(beside.out, "not dimensioned: cylinder ⌀20\n")) << beside.out;
}

// With its middle on the x axis; vertices are numbered from `first`.
std::string ball(double x, double radius, int first) {
  constexpr int around = 24, across = 12;
  std::string text;
  for (int i = 0; i <= across; ++i)
    for (int j = 0; j < around; ++j) {
      const double r = radius * sine(180.0 * i / across), angle = 360.0 * j / around;
      text += "v " + format_number(x + r * cosine(angle)) + " " + format_number(r * sine(angle)) + " " +
              format_number(-radius * cosine(180.0 * i / across)) + "\n";
    }
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < around; ++j) {
      if (i == 0 && j == 0) continue;  // a gap: several balls that are closed would be an assembly
      const auto at = [&](int row, int column) {
        return " " + std::to_string(first + row * around + (row % across == 0 ? 0 : column % around));
      };
      text += i == 0            ? "f" + at(0, 0) + at(1, j + 1) + at(1, j) + "\n"
              : i + 1 == across ? "f" + at(i, j) + at(i, j + 1) + at(across, 0) + "\n"
                                : "f" + at(i, j) + at(i, j + 1) + at(i + 1, j + 1) + at(i + 1, j) + "\n";
    }
  return text;
}

// 0.004 mm apart, beyond what is equal otherwise.
TEST_F(AutomaticDimensions, OfBallsThatAreEqualOnPaperAreOne) {
  constexpr int corners = 13 * 24;
  const std::string balls =
      ball(0, 15, 1) + ball(60, 15.004, 1 + corners) + ball(150, 40, 1 + 2 * corners);  // the last gives overall sizes
  const Outcome run = lint(folder.file("part.obj", balls), "auto");
  EXPECT_FALSE(contains(run.out, "sphere SR")) << run.out << run.err;
  const std::vector<std::string> texts = dimensions_in(read_file(folder / "x.svg"));
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "2× SR15"), 1);
  for (const std::string& text : texts) EXPECT_NE(text, "SR15");
}

// Twelve steps along each of two axes: without their positions, three of either are named.
TEST_F(AutomaticDimensions, LintCountsFindingsThatAreAlike) {
  const std::string part = folder.file("part.obj", block(stairs(13), 30));
  const auto lines = [&](const Words& more) {
    Words arguments{"lint", part, "--views", "front,top,left", "--dimensions", "overall"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 1) << run.err;
    return std::pair(std::count(run.out.begin(), run.out.end(), '\n'), run.out);
  };
  const auto [all, named] = lines({"--all"});
  const auto [few, counted] = lines({});
  EXPECT_EQ(std::pair(all, few), std::pair(53L, 21L)) << named << counted;
  EXPECT_TRUE(
      contains(counted, "\ncompleteness: 6 of 30 plane faces, 6 of 30 faces held by dimensions; 48 have none, "))
      << counted;
  for (const char* axis : {"x", "z"})
    EXPECT_TRUE(contains(counted, "9 more that differ in numbers from: step: position along " + std::string(axis)))
        << counted;
  EXPECT_FALSE(contains(named, "more that differ"));
  EXPECT_TRUE(named.starts_with(counted.substr(0, counted.find('\n')))) << named;
  const std::string json = lines({"--json", "-"}).second;
  EXPECT_TRUE(contains(json, "\"sizes\": [{\"kind\": \"plane faces\", \"given\": 6, \"unsure\": 0, \"all\": 30}, "))
      << json;
}

TEST_F(AutomaticDimensions, LintFindsWhatIsThereTwice) {
  folder.file("part.obj", blocks()[1].obj);
  const std::string linear = "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\n";
  const std::string scene =
      folder.file("scene.toml",
                  "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'left'\n"
                  "[[dimension]]\ntype = 'auto'\n" +
                      linear + "from = {point = [35, 0, 40]}\nto = {point = [60, 0, 15]}\n");
  const Outcome run = epura({"lint", scene}, folder / "");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "dimensioned twice: 25 along x")) << run.out;
}

TEST_F(AutomaticDimensions, LintFindsCrossingsAndTheEndOfTheSheet) {
  folder.file("part.obj", blocks()[0].obj);
  const std::string wide = "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\noffset = -10\n";
  const std::string scene = folder.file(
      "scene.toml",
      "[sheet]\nsize = '60x40'\nscale = '1:1'\n[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n" + wide +
          "from = {point = [0, 0, 0]}\nto = {point = [30, 0, 0]}\n" + wide +
          "from = {point = [20, 0, 0]}\nto = {point = [50, 0, 0]}\n");
  const Outcome run = epura({"lint", scene}, folder / "");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "crossing: '30' and '30' (view 'front')")) << run.out;
  EXPECT_TRUE(contains(run.out, "off the sheet: dimensions extend beyond the sheet (view 'front')")) << run.out;
}

}  // namespace
}  // namespace epura::test::automatic_dimensions_test
