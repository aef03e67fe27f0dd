// SPDX-License-Identifier: Apache-2.0
// STEP, IGES and BREP files that are not whole, or have numbers beyond all drawings.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <tuple>

#include "at_length.hpp"
#include "base/file.hpp"
#include "step_box.hpp"
#include "support.hpp"

namespace epura::test::damaged_parts_test {
namespace {

struct Files {
  std::string step, iges, brep;
};

Files block_with_bore(const Folder& folder) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const TopoDS_Shape shape =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 20).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 15, 0), gp::DZ()), 5, 20).Shape())
          .Shape();
  Files files{(folder / "part.step").string(), (folder / "part.igs").string(), (folder / "part.brep").string()};
  STEPControl_Writer step;
  step.Transfer(shape, STEPControl_AsIs);
  EXPECT_EQ(step.Write(files.step.c_str()), IFSelect_RetDone);
  IGESControl_Writer iges("MM", 1);
  iges.AddShape(shape);
  EXPECT_TRUE(iges.Write(files.iges.c_str()));
  EXPECT_TRUE(BRepTools::Write(shape, files.brep.c_str()));
  return files;
}

TEST(DamagedParts, AreRefusedWithTheReason) {
  const Folder folder;
  const std::string whole = read_file(block_with_bore(folder).step);
  EXPECT_EQ(
      refusal_of(folder.file("a.step", whole.substr(0, whole.size() / 2))),
      "the file is cut off: it ends in line " +
          std::to_string(
              std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2), '\n') + 1) +
          " without END-ISO-10303-21");
  EXPECT_EQ(refusal_of(folder.file("b.step", "\xff\xd8\xff\xe0 JFIF")),
            "is not a STEP file: it does not begin with ISO-10303-21");
  EXPECT_EQ(refusal_of(folder.file("c.step", "")), "is empty");
  EXPECT_EQ(refusal_of(folder.file("d.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n")),
            "is not a valid STEP file");
  const std::size_t circle = whole.find("= CIRCLE("), line = whole.rfind('\n', circle);
  std::string missing = whole;
  missing.erase(line, whole.find('\n', circle) - line);
  EXPECT_TRUE(refusal_of(folder.file("g.step", missing)).starts_with("the file is damaged: 1 entity is wrong: #"));
  EXPECT_TRUE(contains(refusal_of(folder.file("e.brep", "not a shape")), "BREP"));
  EXPECT_FALSE(refusal_of(folder.file("f.igs", "not a drawing")).empty());
}

// Open CASCADE took gigabytes for one of them, and drew the part without a word with others.
TEST(DamagedParts, NumbersBeyondAllDrawingsAreRefusedWhereTheyStand) {
  const Folder folder;
  const std::string beyond = " has the number 1.E300, allowed is up to 1e+50: is the file whole, ";
  const std::string whole = read_file(block_with_bore(folder).step);
  for (const std::string place : {"CARTESIAN_POINT('',(", "CIRCLE('',#", "VECTOR('',#"}) {
    std::string damaged = whole;
    std::size_t number = whole.find(place) + place.size();
    if (place.back() == '#') number = whole.find(',', number) + 1;
    damaged.replace(number, whole.find_first_of(",)", number) - number, "1.E300");
    const std::size_t id = whole.rfind('#', whole.rfind(" = ", number));
    const std::string named = whole.substr(id, whole.find(' ', id) - id) + "=" + place.substr(0, place.find('('));
    EXPECT_TRUE(refusal_of(folder.file("a.step", damaged)).starts_with(named + beyond)) << place;
  }
  std::string in_a_name = whole;
  in_a_name.replace(whole.find("CARTESIAN_POINT('',("), 18, "CARTESIAN_POINT('a, 1.E300 (2.E300)'");
  EXPECT_NE(read_by_importer(folder.file("b.step", in_a_name)).part, nullptr);
  // By 2e100, Open CASCADE means that a line has no end.
  const std::string endless =
      "#9001=TRIMMED_CURVE('',#9002,(PARAMETER_VALUE(-2.E+100)),(PARAMETER_VALUE(2.E+100)),.T.,.PARAMETER.);\n"
      "#9002=LINE('',#9003,#9004);\n#9003=CARTESIAN_POINT('',(0.,0.,0.));\n#9004=VECTOR('',#9005,1.);\n"
      "#9005=DIRECTION('',(1.,0.,0.));\n";
  std::string with_line = whole;
  with_line.insert(with_line.rfind("ENDSEC;"), endless);
  EXPECT_NE(read_by_importer(folder.file("c.step", with_line)).part, nullptr);
}

TEST(DamagedParts, NumbersBeyondAllDrawingsAreRefusedInOtherFormatsToo) {
  const Folder folder;
  const Files files = block_with_bore(folder);
  for (const auto& [path, before, number] :
       {std::tuple(files.iges, "\n110,", "1.D300"), std::tuple(files.brep, "\n1 0 0 0 0 0 1 ", "1e300")}) {
    std::string text = read_file(path);
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << path;
    const std::size_t begin = text.find_first_of(", ", at + 1) + 1, end = text.find_first_of(", ", begin);
    const bool has_width = path == files.iges;  // of its lines
    text.replace(begin, end - begin, number);
    if (has_width) text.erase(text.find("          ", begin), std::string(number).size() - (end - begin));
    const std::string line =
        std::to_string(std::count(text.begin(), text.begin() + static_cast<long>(begin), '\n') + 1);
    EXPECT_TRUE(refusal_of(folder.file(std::filesystem::path(path).filename().string(), text))
                    .starts_with("line " + line + " has the number " + number + ", allowed is up to 1e+50: "))
        << path;
  }
}

// Wherever it ends, the next word is nowhere to be found; it was looked for again and again.
TEST(DamagedParts, BrepThatIsCutShortIsRefusedAtOnce) {
  const Folder folder;
  const std::string path = (folder / "whole.brep").string();
  ASSERT_TRUE(BRepTools::Write(BRepPrimAPI_MakeCylinder(5, 20).Shape(), path.c_str()));
  EXPECT_NEAR(volume_of(read_by_importer(path).mesh), 25 * 20 * 3.14159, 10);
  const std::string whole = read_file(path);
  for (std::size_t length = 100; length + 10 < whole.size(); length += at_length() ? 97 : 277) {
    const std::string cut = folder.file("cut.brep", whole.substr(0, length));
    EXPECT_EQ(refusal_of(cut), "the file is cut off or damaged: no shape could be read") << length;
  }
}

// Open CASCADE leaves the scale out, and turns what is mirrored.
TEST(DamagedParts, PlacesThatScaleOrMirrorAreRefused) {
  const Folder folder;
  const auto placed_by = [&folder](const std::string& target) {
    std::string text = step_box({40, 30, 20},
                                "#1000=MAPPED_ITEM('',#1001,#1002);\n"
                                "#1001=REPRESENTATION_MAP(#1003,#50);\n"
                                "#1002=" +
                                    target +
                                    ";\n#1003=AXIS2_PLACEMENT_3D('',#1004,#1007,#1005);\n"
                                    "#1004=CARTESIAN_POINT('',(0.,0.,0.));\n"
                                    "#1005=DIRECTION('',(1.,0.,0.));\n"
                                    "#1006=DIRECTION('',(0.,1.,0.));\n"
                                    "#1007=DIRECTION('',(0.,0.,1.));\n"
                                    "#1008=DIRECTION('',(0.,0.,-1.));\n"
                                    "#1009=SHAPE_REPRESENTATION('',(#1000),#30);\n");
    const std::string shape = "SHAPE_DEFINITION_REPRESENTATION(#10,#50)";
    text.replace(text.find(shape), shape.size(), "SHAPE_DEFINITION_REPRESENTATION(#10,#1009)");
    return folder.file("part.step", text);
  };
  const auto placed = [&placed_by](const std::string& axis, const std::string& scale) {
    return placed_by("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#1005,#1006,#1004," + scale + "," + axis + ")");
  };
  EXPECT_NEAR(volume_of(read_by_importer(placed("#1007", "1.")).mesh), 24000, 1e-6);
  EXPECT_NEAR(volume_of(read_by_importer(placed("$", "$")).mesh), 24000, 1e-6);
  EXPECT_TRUE(refusal_of(placed("#1007", "2.")).starts_with("the mapped item #1000 scales the shape that it places"));
  EXPECT_TRUE(refusal_of(placed("#1008", "1.")).starts_with("the mapped item #1000 mirrors the shape that it places"));
  EXPECT_TRUE(refusal_of(placed_by("(CARTESIAN_TRANSFORMATION_OPERATOR(#1005,#1006,#1004,2.)"
                                   "CARTESIAN_TRANSFORMATION_OPERATOR_3D(#1007)GEOMETRIC_REPRESENTATION_ITEM()"
                                   "REPRESENTATION_ITEM('')FUNCTIONALLY_DEFINED_TRANSFORMATION('',''))"))
                  .starts_with("the mapped item #1000 is placed by an entity that Open CASCADE does not read"));
}

}  // namespace
}  // namespace epura::test::damaged_parts_test
