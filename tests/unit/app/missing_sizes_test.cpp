// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of slopes, notches, round ends and turned holes: every size once, none twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "at_length.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "crossed_parts.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "grooved_parts.hpp"
#include "program.hpp"
#include "sloped_parts.hpp"
#include "turned_parts.hpp"

namespace epura::test::missing_sizes_test {
namespace {

class MissingSizes : public testing::Test {
 protected:
  Folder folder;

  Outcome lint(const std::string& model, const std::string& view = {}) {
    Words arguments{"lint",    model, "--views", "front,top,left", "--dimensions", "auto",
                    "--sheet", "A2",  "-o",      "x.svg",          "--svg-text",   "text"};
    if (!view.empty()) arguments.insert(arguments.end(), {"--projection", view});
    return epura(arguments, folder / "");
  }
  void expect_known(const std::vector<KnownPart>& parts) {
    EXPECT_GE(parts.size(), std::size_t(20));
    for (const KnownPart& part : parts) {
      const Outcome run = lint(folder.file("part.obj", part.obj), part.view);
      EXPECT_EQ(run.code, 0) << part.name << ": " << run.out << run.err;
      const std::string svg = read_file(folder / "x.svg");
      const auto boxes = boxes_in(svg);
      Words texts;
      for (const auto& [text, box] : boxes_in(dimension_layers(svg))) texts.push_back(text);
      EXPECT_EQ(sorted(texts), sorted(part.texts)) << part.name;
      EXPECT_GE(boxes.size(), part.texts.size()) << part.name;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
          EXPECT_FALSE(sheet::overlap(boxes[i].second, boxes[j].second))
              << part.name << ": " << boxes[i].first << " on " << boxes[j].first;
    }
  }
};

// Cut through their axes, holes have the note beside them that they have seen from above.
TEST_F(MissingSizes, OfSunkHolesInSections) {
  for (const char* name : {"counterbores", "countersinks", "blind counterbores"})
    for (const KnownPart& part : plates()) {
      if (part.name != name) continue;
      const auto note = std::find_if(part.texts.begin(), part.texts.end(), [](const std::string& text) {
        return contains(text, "⌴") || contains(text, "⌵");
      });
      ASSERT_NE(note, part.texts.end()) << name;
      const Outcome run = epura({"draw", folder.file("part.obj", part.obj), "--views", "front:section=y@15",
                                 "--dimensions", "auto", "--sheet", "A3", "-o", "x.svg"},
                                folder / "");
      EXPECT_EQ(run.code, 0) << run.err;
      const Words texts = dimensions_in(read_file(folder / "x.svg"));
      EXPECT_EQ(std::count(texts.begin(), texts.end(), *note), 1) << name << run.err;
    }
}

// A notch before the plane of a section is not in it.
TEST_F(MissingSizes, AreNotOfWhatASectionRemoves) {
  Plate plate(20);
  plate.cell({{0, 0}, {12, 0}, {12, 9}, {12, 40}, {0, 40}}, {});
  plate.cell({{12, 9}, {23, 9}, {23, 40}, {12, 40}}, {});
  plate.cell({{23, 0}, {60, 0}, {60, 40}, {23, 40}, {23, 9}}, {});
  const auto texts = [&](const char* view) {
    const Outcome run = epura({"draw", folder.file("part.obj", plate.obj()), "--views", view, "--dimensions", "auto",
                               "--sheet", "A3", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return sorted(dimensions_in(read_file(folder / "x.svg")));
  };
  EXPECT_EQ(texts("front"), sorted({"60", "20", "12", "11"}));
  EXPECT_EQ(texts("front:section=y@5"), sorted({"60", "20", "12", "11"}));
  EXPECT_EQ(texts("front:section=y@20"), sorted({"60", "20"}));
}

// A plate with a hole among more parts than any view has room for.
TEST_F(MissingSizes, OfHolesAmongTooManyPartsAreTold) {
  const auto told = [&](int count) {
    std::string obj = plates()[0].obj;
    int first = static_cast<int>(std::count(obj.begin(), obj.end(), 'v'));
    for (int i = 0; i < count; ++i) {
      for (const Vec3& p : {Vec3(0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 2)}) {
        const Vec3 at = p + Vec3(60 + 3 * i, 40 + 3 * i, 10 + 3 * i);
        obj += "v " + format_number(at.x) + " " + format_number(at.y) + " " + format_number(at.z) + "\n";
      }
      for (const std::array<int, 3>& face : {std::array{1, 3, 2}, {1, 2, 4}, {1, 4, 3}, {2, 3, 4}}) {
        obj += "f";
        for (const int corner : face) obj += " " + std::to_string(first + corner);
        obj += "\n";
      }
      first += 4;
    }
    const Outcome run = epura({"draw", folder.file("part.obj", obj), "--views", "front,top,left", "--dimensions",
                               "auto", "--sheet", "A0", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return std::pair(run.err, dimensions_in(read_file(folder / "x.svg")));
  };
  const auto [few, all_texts] = told(5);
  EXPECT_EQ(std::count(all_texts.begin(), all_texts.end(), "⌀10"), 1) << few;
  const auto [many, texts] = told(30);
  EXPECT_EQ(texts.size(), 3U) << many;
  EXPECT_TRUE(contains(many, "30 places of parts along z, 1 size in the view 'top'")) << many;
}

// From all sides to one point of the axis: one note, and one angle to the axis.
TEST_F(MissingSizes, OfSlantedHolesAboutAnAxis) {
  for (int i = 0; i < variants; i += at_length() ? 1 : 5) {
    const int count = 6 + 2 * (i % 3);
    const double up = 25 + 0.5 * i, hole = 3 + 0.25 * (i % 5);
    const Outcome run = lint(folder.file("part.obj", pyramid_with_holes(count, up, 34 + 0.5 * i, 4, hole)));
    Words texts;
    for (const auto& [text, box] : boxes_in(dimension_layers(read_file(folder / "x.svg")))) texts.push_back(text);
    const std::string times = std::to_string(count) + "× ", size = "⌀" + number(hole);
    const auto told = [&](const std::string& text) {
      return std::count_if(texts.begin(), texts.end(), [&](const std::string& one) { return contains(one, text); });
    };
    EXPECT_EQ(told(times + size), 1) << count << " at " << up;
    EXPECT_EQ(told(size), 1) << count << " at " << up;
    EXPECT_EQ(told(times + number(90 - up) + "°"), 1) << count << " at " << up;
    EXPECT_FALSE(contains(run.out, "angle to the axis")) << run.out;
  }
}

// More than anyone finds in a view, and positions along no axis of a view: draw tells what lint finds.
TEST_F(MissingSizes, AreTold) {
  const auto told = [&](const std::string& obj, const char* placed) {
    const Outcome run = epura({"draw", folder.file("part.obj", obj), "--views", "front,top,left", "--transform", placed,
                               "--dimensions", "auto", "--sheet", "A0", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  const auto each_differs = [](const Vec2& centre) {
    const double radius = 2 + centre.x / 80 + centre.y / 1000;
    return stepped_hole({{radius, 6}, {radius, 0}})(centre);
  };
  const std::string many = plate({20, 24}, 7, 7, 6, each_differs), one = plates()[0].obj;
  EXPECT_TRUE(
      contains(told(many, "scale:1"), "left out, since a view has no room for so many: 9 sizes in the view 'top'"));
  EXPECT_TRUE(contains(told(one, "rotate:x,20 rotate:y,30"),
                       "no positions are given where axes are askew to faces and views: hole ⌀10"));
  for (const char* placed : {"scale:1", "rotate:x,20"}) EXPECT_FALSE(contains(told(one, placed), "askew")) << placed;
}

// A bore that is wider at both ends, and a boss, have places as holes have.
TEST_F(MissingSizes, OfAxonometricViewsAreNotThoseOfPlaces) {
  const Vec2 centre(18, 15);
  const auto ring = [&](double radius) { return circle(centre, radius, -135); };
  const auto texts = [&](const Hole& loops) {
    Plate plate(20);
    plate.cell(square({0, 0}, {60, 40}), loops);
    const Outcome run = epura({"draw", folder.file("part.obj", plate.obj()), "--projection", "isometric",
                               "--dimensions", "auto", "--sheet", "A3", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return dimensions_in(read_file(folder / "x.svg"));
  };
  const Hole bore{{ring(9), 20}, {ring(9), 15}, {ring(5), 15}, {ring(5), 6}, {ring(7), 6}, {ring(7), 0}},
      boss{{ring(9), 20}, {ring(9), 31}};
  for (const Hole& loops : {bore, boss}) {
    const Words found = texts(loops);
    for (const char* place : {"18", "15"}) EXPECT_EQ(std::count(found.begin(), found.end(), place), 1) << place;
  }
}

// Nobody counts the corners of so many teeth.
TEST_F(MissingSizes, OfManyEqualRadiiHaveNoCount) {
  const auto radius = [&](int teeth) {
    Loop comb{{0, 0}, {6.0 * teeth, 0}, {6.0 * teeth, 20}};
    std::vector<double> radii{0, 0, 0};
    for (int i = teeth - 1; i >= 0; --i)
      for (const Vec2& p : {Vec2(5, 20), Vec2(5, 30), Vec2(1, 30), Vec2(1, 20)}) {
        comb.emplace_back(6.0 * i + p.x, p.y);
        radii.push_back(p.y > 20 ? 1 : 0);
      }
    comb.emplace_back(0, 20);
    radii.push_back(0);
    lint(folder.file("part.obj", block(rounded(comb, radii), 8)));
    Words texts;
    for (const auto& [text, box] : boxes_in(dimension_layers(read_file(folder / "x.svg"))))
      if (text.ends_with("R1")) texts.push_back(text);
    return texts;
  };
  EXPECT_EQ(radius(5), Words{"10× R1"});
  EXPECT_EQ(radius(21), Words{"R1"});
}

// About an axis between those of the world, they have all sizes after the transform that lint proposes.
TEST_F(MissingSizes, OfPartsThatLieAskewAreGivenAlongTheirOwnAxes) {
  const std::vector<KnownPart> parts{plates()[0], plates()[4], plate_with_two_turned_holes(), wedges_with_pairs()[3]};
  for (const KnownPart& known : parts)
    for (const char* turned :
         {"rotate:x,20 rotate:y,-25", "rotate:z,30 rotate:x,15 rotate:z,-12", "rotate:y,35 rotate:z,1"}) {
      const std::string part = folder.file("part.obj", known.obj);
      const Words views{"lint",    part, "--views", "front,top,left", "--dimensions", "auto",
                        "--sheet", "A2", "-o",      "x.svg",          "--transform"};
      const auto run = [&](const std::string& transform) {
        Words arguments = views;
        arguments.push_back(transform);
        return epura(arguments, folder / "");
      };
      const Outcome askew = run(turned);
      EXPECT_EQ(askew.code, 1) << known.name << ": " << turned;
      const Outcome along = run(std::string(turned) + " " + proposed_transform(askew.out));
      EXPECT_EQ(along.code, 0) << known.name << ": " << turned << ": " << askew.out << along.out;
      EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(known.texts))
          << known.name << ": " << turned;
    }
}

// A part whose sides mirror each other lies straight where its middle does.
TEST_F(MissingSizes, OfPartsBetweenSlopesAreGivenAlongTheirMiddle) {
  const std::string part = folder.file("part.obj", block({{0, -10}, {60, -4}, {60, 4}, {0, 10}}, 5));
  for (const auto& [turned, proposed] : {std::pair("rotate:z,0", ""), std::pair("rotate:z,30", "rotate:z,-30")}) {
    const Outcome found =
        epura({"lint", part, "--views", "front", "--dimensions", "auto", "--transform", turned}, folder / "");
    EXPECT_EQ(found.code, 1) << found.err;
    EXPECT_EQ(proposed_transform(found.out + found.err), proposed) << found.out << found.err;
  }
}

// More of its area is in slanted slots than in its rim, which tells how it lies.
TEST_F(MissingSizes, OfPlatesWithSlantedSlotsAreGivenAlongTheirRim) {
  Plate plate(6);
  for (const double x : {0.0, 16.0, 32.0, 48.0, 64.0, 80.0}) {
    const Loop slot = turned(square({x - 4, 18.5}, {24, 3}), {x + 8, 20}, 60);
    plate.cell(square({x, 0}, {16, 40}), {{slot, 6}, {slot, 0}});
  }
  const Outcome found =
      epura({"lint", folder.file("part.obj", plate.obj()), "--views", "auto", "--dimensions", "auto"}, folder / "");
  EXPECT_FALSE(contains(found.err, "lies askew")) << found.err;
  EXPECT_EQ(proposed_transform(found.out), "") << found.out;
}

// Nobody has chosen how it lies, so it is drawn as a draughtsman would lay it.
TEST_F(MissingSizes, OfPartsThatLieAskewAreAlongTheirAxesInAutomaticViews) {
  for (const KnownPart& known : {plates()[0], plates()[4], wedges_with_pairs()[3]})
    for (const double angle : {13.0, -27.0, 40.0}) {
      const std::string part = folder.file("part.obj", turned_about_z(known.obj, angle));
      const auto run = [&](const Words& more) {
        Words arguments{"lint", part, "--dimensions", "auto", "-o", "x.svg"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return epura(arguments, folder / "");
      };
      const Outcome along = run({});
      EXPECT_EQ(along.code, 0) << known.name << ": " << along.out << along.err;
      EXPECT_TRUE(contains(along.out + along.err, "lies askew")) << along.out << along.err;
      EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(known.texts)) << known.name;
      EXPECT_TRUE(contains(run({"--tolerance", "⌀8=H7"}).err, "lies askew")) << known.name;
      for (const Words& chosen : {Words{"--transform", "rotate:z,0"}, Words{"--views", "front,top,left"}})
        EXPECT_FALSE(contains(run(chosen).err, "lies askew")) << known.name;
    }
}

// Also where only its sizes as a whole are given.
TEST_F(MissingSizes, OfPartsThatLieAskewAreAlongTheirAxesAsAWhole) {
  for (const std::string& obj : {plates()[0].obj, block({{0, 0}, {60, 0}, {60, 40}, {0, 40}}, 8)}) {
    const auto texts = [&](double angle) {
      const Outcome run = epura({"draw", folder.file("part.obj", turned_about_z(obj, angle)), "--views", "auto",
                                 "--dimensions", "overall", "-o", "x.svg"},
                                folder / "");
      EXPECT_EQ(contains(run.err, "lies askew"), angle != 0) << run.err;
      return sorted(dimensions_in(read_file(folder / "x.svg")));
    };
    EXPECT_EQ(texts(27), texts(0));
  }
}

// Two plates side by side, turned together.
TEST_F(MissingSizes, OfAssembliesThatLieAskewAreAlongTheirAxesInAutomaticViews) {
  std::string both = plates()[0].obj;
  const auto count = static_cast<int>(std::count(both.begin(), both.end(), 'v'));
  std::istringstream lines(plates()[0].obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    both += key;
    if (Vec3 p{0}; key == "v" && words >> p.x >> p.y >> p.z)
      both += " " + format_number(p.x) + " " + format_number(p.y) + " " + format_number(p.z + 200);
    for (int corner = 0; key == "f" && words >> corner;) both += " " + std::to_string(corner + count);
    both += "\n";
  }
  const auto texts = [&](double angle) {
    const Outcome run =
        epura({"draw", folder.file("two.obj", turned_about_z(both, angle)), "--dimensions", "auto", "-o", "x.svg"},
              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(contains(run.err, "lies askew"), angle != 0) << run.err;
    return sorted(dimensions_in(read_file(folder / "x.svg")));
  };
  EXPECT_EQ(texts(27), texts(0));
  EXPECT_FALSE(texts(0).empty());
}

// The older version lies as the new one does.
TEST_F(MissingSizes, OfPartsThatLieAskewAreTheSameInARevision) {
  const std::string scene = "views = [\"auto\"]\nmodel = {file = \"part.obj\"}\n[[dimension]]\ntype = \"auto\"\n";
  folder.file("part.obj", turned_about_z(plates()[4].obj, 27));
  folder.file("old.toml", scene);
  const Outcome drawn =
      epura({"draw", folder.file("new.toml", scene), "--revise", "old.toml", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "lies askew")) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "nothing differs")) << drawn.err;
}

// Two eyes, of radii at a distance along x, and the tangents to both, of some depth along y.
std::string lever(double first, double second, double distance, double depth) {
  const double tangent = std::acos((first - second) / distance) * 180 / std::numbers::pi;
  Loop outline = arc_of(first, tangent, 360 - tangent);
  for (const Vec2& point : arc_of(second, -tangent, tangent)) outline.emplace_back(point.x + distance, point.y);
  return block(outline, depth);
}

// The nose of a cam is less than half a turn, between flanks that follow from both radii and their distance; those of
// a lever that are parallel to no axis have no angle either.
TEST_F(MissingSizes, OfCamsAreRadiiAndTheDistanceOfTheirCentres) {
  std::vector<KnownPart> cams;
  for (int nose = 5; nose <= 12; ++nose)
    for (const int distance : {25, 30, 40}) {
      const Words texts{number(distance), "R" + number(nose), "(" + number(20 + distance + nose) + ")", "⌀40", "12"};
      cams.push_back({"cam R" + number(nose), lever(20, nose, distance, 12), texts});
    }
  expect_known(cams);
}

// Of a flank that lies along an axis, the other one is no slope: they meet beyond both eyes.
TEST_F(MissingSizes, OfLeversOnOneFlankAreFound) {
  for (const double sign : {1.0, -1.0}) {
    const double lean = sign * std::asin(10.0 / 92) * 180 / std::numbers::pi;
    const Outcome run = epura({"lint", folder.file("part.obj", lever(20, 10, 92, 12)), "--views", "front,top,left",
                               "--dimensions", "auto", "-o", "x.svg", "--transform", "rotate:y," + format_number(lean)},
                              folder / "");
    EXPECT_NE(run.code, 2) << run.err;
  }
}

// Corners that an offset outwards and inwards has left, of 0.12: those of one step are where others stand.
TEST_F(MissingSizes, OfFacesThatAreHardlyTurnedHaveNoPlaceTwice) {
  const Loop outline{{-15, -14.8773},
                     {-14.9943, -14.9943},
                     {-14.8773, -15},
                     {14.8773, -15},
                     {14.9943, -14.9943},
                     {15, -14.8773},
                     {15, -6},
                     {69.8773, -6},
                     {69.9943, -5.9943},
                     {70, -5.8773},
                     {70, 5.8773},
                     {69.9943, 5.9943},
                     {69.8773, 6},
                     {15, 6},
                     {15, 44.8773},
                     {14.9943, 44.9943},
                     {14.8773, 45},
                     {-14.8773, 45},
                     {-14.9943, 44.9943},
                     {-15, 44.8773}};
  for (const char* turn : {"rotate:y,0.00544", "rotate:y,-0.00544", "rotate:y,0.0055", "rotate:y,0.0052"}) {
    const Outcome run = epura({"lint", folder.file("part.obj", block(outline, 8)), "--views", "front,top,left",
                               "--dimensions", "auto", "-o", "x.svg", "--transform", turn},
                              folder / "");
    EXPECT_NE(run.code, 2) << turn << ": " << run.err;
  }
}

/// Sheets of metal, both sides of which are one line.
std::vector<KnownPart> foils() {
  std::vector<KnownPart> parts;
  for (int i = 1; i <= variants; ++i)
    parts.push_back({"foil " + number(0.01 * i),
                     block({{0, 0}, {200, 0}, {200, 150}, {0, 150}}, 0.01 * i),
                     {"200", "150", number(0.01 * i)}});
  return parts;
}

std::vector<KnownPart> turned_holes() {
  std::vector<KnownPart> parts = plates_with_turned_holes();
  parts.push_back(plate_with_two_turned_holes());
  return parts;
}

/// A kind of feature, and parts of it: each size once, none twice, and no text on another one.
struct Family {
  const char* name;
  std::vector<KnownPart> (*parts)();
};
const Family families[] = {
    {"ThinMetal", foils},
    {"Notches", v_notches},
    {"PlanesBetweenSlopes", planes_between_slopes},
    {"SlopesToRoundedCorners", slopes_to_rounded_corners},
    {"RoundedTrapezia", rounded_trapezia},
    {"SlopesOf45Degrees", slopes_of_45_degrees},
    {"SlopesOfPlainAngles", slopes_of_plain_angles},
    {"BossesOnAWeb", bosses_on_a_web},
    {"RoundEnds", round_ends},
    {"Tongues", tongues},
    {"Links", links},
    {"RadialHoles", tubes_with_radial_holes},
    {"RadialBlindHoles", shafts_with_blind_holes},
    {"HolesInSlopes", wedges_with_holes},
    {"PairsInSlopes", wedges_with_pairs},
    {"UnevenPitchCircles", uneven_pitch_circles},
    {"TurnedPlates", turned_plates_with_two_heights},
    {"TurnedPlatesInLine", turned_plates_with_one_height},
    {"TurnedRoundedPlates", turned_rounded_plates},
    {"TurnedHexagons", turned_hexagons},
    {"ConicalBosses", plates_with_conical_bosses},
    {"ConicalTubes", conical_tubes},
    {"Channels", channels},
    {"ChamferedHexagons", chamfered_hexagons},
    {"Dimples", plates_with_dimples},
    {"Grooves", blocks_with_grooves},
    {"Ribs", bases_with_ribs},
    {"Pockets", plates_with_pockets},
    {"PocketsBesideHoles", pockets_beside_holes},
    {"BossesOverBores", bosses_over_bores},
    {"RoundTopsThatAGrooveParts", parted_round_tops},
    {"BossesWithRingGrooves", bosses_with_ring_grooves},
    {"OpenSlots", blocks_with_open_slots},
    {"Lugs", bases_with_lugs},
    {"OpenKeyways", shafts_with_open_keyways},
    {"RingGrooves", plates_with_ring_grooves},
    {"TurnedBlocks", turned_blocks},
    {"TurnedHoles", turned_holes},
    {"PocketsInSlopes", wedges_with_pockets},
    {"SlotsInSlopes", wedges_with_slots},
    {"CrossHoles", shafts_with_cross_holes},
    {"HolesFromThreeSides", blocks_with_holes_from_three_sides},
    {"Domes", plates_with_domes},
    {"Beads", plates_with_beads},
    {"TurnedBosses", plates_with_turned_bosses},
    {"TwoLugs", bases_with_two_lugs},
    {"BentBars", bent_bars},
};
class MissingSizesOf : public MissingSizes, public testing::WithParamInterface<Family> {};
TEST_P(MissingSizesOf, AreThereOnce) { expect_known(GetParam().parts()); }
INSTANTIATE_TEST_SUITE_P(Families, MissingSizesOf, testing::ValuesIn(families),
                         [](const auto& family) { return family.param.name; });

}  // namespace
}  // namespace epura::test::missing_sizes_test
