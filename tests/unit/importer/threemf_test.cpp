// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: parts in the wrong unit, place or number, and archives that fill the memory.
#include <array>
#include <cstdint>
#include <string_view>

#include "archive.hpp"
#include "support.hpp"

namespace epura::test::threemf_test {
namespace {

/// A cube from the origin, of this side; `more` stands in its mesh.
std::string cube(int id, const std::string& side = "1", const std::string& attributes = "",
                 const std::string& more = "") {
  constexpr std::array<std::array<int, 3>, 12> triangles{{{0, 2, 3},
                                                          {0, 3, 1},
                                                          {4, 5, 7},
                                                          {4, 7, 6},
                                                          {0, 1, 5},
                                                          {0, 5, 4},
                                                          {2, 6, 7},
                                                          {2, 7, 3},
                                                          {0, 4, 6},
                                                          {0, 6, 2},
                                                          {1, 3, 7},
                                                          {1, 7, 5}}};
  std::string text = "<object id=\"" + std::to_string(id) + "\" type=\"model\" " + attributes + "><mesh><vertices>";
  for (int i = 0; i < 8; ++i)
    text += "<vertex x=\"" + (i % 2 == 1 ? side : "0") + "\" y=\"" + (i / 2 % 2 == 1 ? side : "0") + "\" z=\"" +
            (i / 4 == 1 ? side : "0") + "\"/>";
  text += "</vertices><triangles>";
  for (const auto& [a, b, c] : triangles)
    text += "<triangle v1=\"" + std::to_string(a) + "\" v2=\"" + std::to_string(b) + "\" v3=\"" + std::to_string(c) +
            "\"/>";
  return text + "</triangles>" + more + "</mesh></object>";
}

std::string item(int id, const std::string& more = "") {
  return "<item objectid=\"" + std::to_string(id) + "\" " + more + "/>";
}

importer::ReadModel read(const std::string& xml) {
  const Folder folder;
  return read_by_importer(folder.file("m.3mf", archive_of(entries_with(xml))));
}

std::string refusal_of_archive(const std::vector<Entry>& entries) {
  const Folder folder;
  return refusal_of(folder.file("m.3mf", archive_of(entries)));
}

std::string refusal(const std::string& xml) { return refusal_of_archive(entries_with(xml)); }

TEST(ThreeMf, FilesSayTheirUnit) {
  const std::vector<std::pair<std::string, double>> units{{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                                          {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
  for (const auto& [unit, millimetres] : units) {
    const importer::ReadModel model = read(model_of(cube(1), item(1), unit));
    EXPECT_EQ(model.unit, millimetres) << unit;
    EXPECT_FALSE(model.is_y_up);
    EXPECT_EQ(volume_of(model.mesh), 1);
    EXPECT_EQ(model.mesh.report.triangles, 12);
  }
}

TEST(ThreeMf, CoordinatesAreThoseThatAreWritten) {
  const importer::ReadModel model =
      read(model_of(cube(1, "12.345"), item(1, "transform=\"1 0 0 0 1 0 0 0 1 0.1 0 0\"")));
  EXPECT_EQ(extent_of(model.mesh).most, Vec3(12.345 + 0.1, 12.345, 12.345));
  EXPECT_TRUE(model.mesh.report.single_precision);
}

// Of 32 bits only the shortest numbers show that five decimals were printed.
TEST(ThreeMf, CoordinatesAreKnownToBeRoundedToDecimals) {
  std::string xml = model_of(cube(1), item(1));
  std::string more;
  for (int i = 0; i < 200; ++i) {
    const std::string digits = std::to_string(10007 + 397 * i);
    more += "<vertex x=\"0." + digits.substr(0, 5) + "\" y=\"1." + digits + "\" z=\"-0." + digits + "\"/>";
  }
  xml.replace(xml.find("</vertices>"), 0, more);
  more.clear();
  for (int i = 0; i < 198; ++i)
    more += "<triangle v1=\"" + std::to_string(8 + i) + "\" v2=\"" + std::to_string(9 + i) + "\" v3=\"" +
            std::to_string(10 + i) + "\"/>";
  xml.replace(xml.find("</triangles>"), 0, more);
  EXPECT_EQ(read(xml).mesh.report.resolution, 1e-5);
}

TEST(ThreeMf, ArchivesArePackedOrNotAndKnownByTheirFirstBytes) {
  const Folder folder;
  std::vector<Entry> entries = entries_with(model_of(cube(1), item(1)));
  for (Entry& entry : entries) entry.is_packed = true;
  EXPECT_EQ(volume_of(read_by_importer(folder.file("m.3mf", archive_of(entries))).mesh), 1);
  std::swap(entries.front(), entries.back());
  EXPECT_EQ(volume_of(read_by_importer(folder.file("m.zip", archive_of(entries))).mesh), 1);
}

TEST(ThreeMf, ItemsPlaceObjectsByRowVectors) {
  // (x, y, z) -> (10 - 2 y, x, z), and a mirror image at x = -4..-3.
  const importer::ReadModel model =
      read(model_of(cube(1, "1", "name=\"frame\"") + cube(2, "1", "name=\"arm\" partnumber=\"A-7\""),
                    item(1) + item(2, "transform=\"0 1 0 -2 0 0 0 0 1 10 0 0\"") +
                        item(1, "partnumber=\"M-1\" transform=\"-1 0 0 0 1 0 0 0 1 -3 0 0\"")));
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"frame", "arm", "M-1"}));
  EXPECT_EQ(volume_of(model.mesh), 1 + 2 + 1);
  expect_extent(model.mesh, {-4, 0, 0}, {10, 1, 1});
  EXPECT_EQ(model.mesh.report.misoriented_edges, 0);
}

TEST(ThreeMf, ObjectsHaveTheColourOfTheirMaterial) {
  const std::string materials =
      R"(<basematerials id="9"><base name="red" displaycolor="#CC0000"/><base name="x" displaycolor="#0000FFFF"/>)"
      "</basematerials>";
  const importer::ReadModel model = read(model_of(
      materials + cube(1, "1", "pid=\"9\" pindex=\"0\"") + cube(2, "1", "pid=\"9\" pindex=\"1\"") + cube(3),
      item(1) + item(2, "transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"") + item(3, "transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"")));
  EXPECT_EQ(model.mesh.report.body_colours,
            (std::vector<std::optional<Colour>>{Colour{204, 0, 0}, Colour{0, 0, 255}, std::nullopt}));
}

TEST(ThreeMf, ComponentsStandInComponents) {
  const std::string pair = R"(<object id="2" type="model"><components><component objectid="1"/>)"
                           R"(<component objectid="1" transform="1 0 0 0 1 0 0 0 1 2 0 0"/></components></object>)";
  const std::string turned = R"(<object id="3" type="model"><components>)"
                             R"(<component objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/></components></object>)";
  const importer::ReadModel model =
      read(model_of(cube(1) + pair + turned, item(3, "transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"")));
  EXPECT_EQ(volume_of(model.mesh), 2 * 8);
  expect_extent(model.mesh, {-2, 0, 5}, {0, 6, 7});
}

TEST(ThreeMf, PartsOfThePackageHaveNumbersOfTheirOwn) {
  std::vector<Entry> entries = entries_with(
      model_of(cube(1) + R"(<object id="2" type="model"><components><component objectid="1"/>)"
                         R"(<component p:path="/3D/other.model" objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>)"
                         "</components></object>",
               item(2)));
  entries.push_back({"3D/_rels/3dmodel.model.rels", relations_to("/3D/other.model")});
  entries.push_back({"3D/other.model", model_of(cube(1, "2"), "")});
  const Folder folder;
  const importer::ReadModel model = read_by_importer(folder.file("m.3mf", archive_of(entries)));
  EXPECT_EQ(volume_of(model.mesh), 1 + 8);
  expect_extent(model.mesh, {0, 0, 0}, {7, 2, 2});
}

// CAD programs write such triangles.
TEST(ThreeMf, TrianglesWithEqualCornersAreLeftOut) {
  std::string xml = model_of(cube(1), item(1));
  xml.replace(
      xml.find("</triangles>"), 0,
      R"(<triangle v1="1" v2="1" v3="3"/><triangle v1="1" v2="7" v3="1" pid="4"/><triangle  v3='2' v2='2' v1='0' />)");
  std::vector<Entry> entries = entries_with(xml);
  entries.back().is_packed = true;
  const Folder folder;
  const importer::ReadModel model = read_by_importer(folder.file("m.3mf", archive_of(entries)));
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.triangles, 12);
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"3 triangles with two equal corners left out"});
}

TEST(ThreeMf, AModelThatBuildsNothingIsDrawnWhole) {
  const importer::ReadModel model = read(model_of(
      cube(1) + R"(<object id="2" type="model"><components><component objectid="1"/></components></object>)", ""));
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"builds nothing: all of its objects are drawn"});
}

TEST(ThreeMf, BeamsOfLatticesAreCounted) {
  const importer::ReadModel model = read(model_of(
      cube(1, "1", "",
           R"(<b:beamlattice radius="0.1" minlength="0.01"><b:beams><b:beam v1="0" v2="7"/><b:beam v1="1" v2="6"/>)"
           "</b:beams></b:beamlattice>"),
      item(1)));
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"2 beams of lattices are not drawn"});
}

TEST(ThreeMf, BombsAreNotUnpacked) {
  std::vector<Entry> entries = entries_with(model_of(cube(1), item(1)));
  entries.push_back({"3D/large.model", std::string(1000, ' '), true, 300u << 20});
  const std::string refused = refusal_of_archive(entries);
  EXPECT_TRUE(refused.starts_with("unpacks to more than 256 MB, ")) << refused;
  entries.pop_back();
  entries.back().is_packed = true;
  entries.back().claimed = 10;
  EXPECT_EQ(refusal_of_archive(entries), "'3D/3dmodel.model' in it is larger than its directory says");
}

// Each holds the one before ten times: ten thousand million cubes, of which nothing says so in one place.
TEST(ThreeMf, PartsThatMultiplyAreNotPutDown) {
  std::string objects = cube(1);
  for (int id = 2; id <= 11; ++id) {
    objects += "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components>";
    for (int i = 0; i < 10; ++i) objects += "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    objects += "</components></object>";
  }
  EXPECT_EQ(refusal(model_of(objects, item(11))), "puts down more than 1000000 parts");
}

TEST(ThreeMf, ComponentsDoNotHoldThemselves) {
  const auto holding = [](int id, int other) {
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components><component objectid=\"" +
           std::to_string(other) + "\"/></components></object>";
  };
  const std::string circle = "has components in more than 500 levels, or in a circle";
  EXPECT_EQ(refusal(model_of(holding(1, 1), item(1))), circle);
  EXPECT_EQ(refusal(model_of(holding(1, 2) + holding(2, 1), item(1))), circle);
  std::string chain = cube(1);
  for (int id = 2; id <= 100'000; ++id) chain += holding(id, id - 1);
  EXPECT_EQ(refusal(model_of(chain, item(100'000))), circle);
  EXPECT_EQ(refusal(model_of(holding(1, 3) + cube(2), item(1))),
            "is not a valid 3MF file: a component is of an object that is missing");
}

TEST(ThreeMf, WhatIsWrongWithAnArchiveIsTold) {
  const Folder folder;
  const std::vector<Entry> entries = entries_with(model_of(cube(1), item(1)));
  const std::string whole = archive_of(entries);
  const auto refusal_with = [&](std::string_view bytes) { return refusal_of(folder.file("m.3mf", bytes)); };
  const std::string no_archive = "is not a ZIP archive, as 3MF files are, or is cut short: ";
  EXPECT_TRUE(refusal_with(std::string_view(whole).substr(0, whole.size() / 2)).starts_with(no_archive));
  EXPECT_TRUE(refusal_with("no archive, and no mesh\n").starts_with(no_archive));
  std::string damaged = whole;
  damaged[damaged.find("<vertices>") + 3] = 'X';
  EXPECT_EQ(refusal_with(damaged), "'3D/3dmodel.model' in it is damaged: CRC error");
  std::vector<Entry> encrypted = entries;
  encrypted.back().flags = 1;
  EXPECT_EQ(refusal_of_archive(encrypted), "is encrypted: '3D/3dmodel.model' cannot be read");
  EXPECT_EQ(refusal_of_archive({{"readme.txt", "Hello"}}), "is a ZIP archive, but no 3MF: '_rels/.rels' is missing");
  std::vector<Entry> without = entries;
  without.pop_back();
  EXPECT_EQ(refusal_of_archive(without), "'3D/3dmodel.model', to which it refers, is missing in it");
}

TEST(ThreeMf, WhatIsWrongWithAModelIsTold) {
  EXPECT_EQ(refusal("<model>"), "'3D/3dmodel.model' in it is damaged: line 1 of it ends within <model>");
  EXPECT_EQ(refusal("<model/>"), "is not a valid 3MF file: it has no object");
  EXPECT_EQ(refusal(model_of(cube(1), item(7))), "is not a valid 3MF file: an object that is to be built is missing");
  std::string wrong = model_of(cube(1), item(1));
  wrong.replace(wrong.find("v1=\"0\""), 6, "v1=\"8\"");
  EXPECT_EQ(refusal(wrong), "is not a valid 3MF file: a triangle has a corner that is no vertex");
  for (const char* side : {"nan", "1e40", "-inf"})
    EXPECT_EQ(refusal(model_of(cube(1, side), item(1))),
              "is not a valid 3MF file: a vertex has a coordinate that is no number, or is too large");
}

std::string moved(int id, int x) { return item(id, "transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(x) + " 0 0\""); }

// As PrusaSlicer writes it from the command line.
TEST(ThreeMf, PicturesThatAreMissingAreNotNeeded) {
  std::vector<Entry> entries = entries_with(model_of(cube(1), item(1)));
  std::string& relations = entries[1].bytes;
  const std::string picture =
      R"(<Relationship Target="/Metadata/thumbnail.png" Id="t" Type="http://x/metadata/thumbnail"/>)";
  relations.insert(relations.find("<Relationship "), picture);
  const Folder folder;
  const importer::ReadModel model = read_by_importer(folder.file("m.3mf", archive_of(entries)));
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_TRUE(model.mesh.report.notes.empty());
}

// Metadata that is words for people is a note, of programs, too; other metadata is not.
TEST(ThreeMf, MetadataThatIsANoteIsOne) {
  std::string xml = model_of(cube(1), item(1));
  xml.insert(
      xml.find("<resources"),
      R"(<metadata name="Application">a slicer</metadata><metadata name="Note">Break sharp edges &amp; clean)"
      R"(</metadata><metadata name="cad:semantic text">Heat treated</metadata><metadata name="note"> </metadata>)");
  const importer::ReadModel model = read(xml);
  ASSERT_EQ(model.requirements.size(), 2U);
  EXPECT_EQ(model.requirements[0].kind, importer::RequirementKind::note);
  EXPECT_EQ(model.requirements[0].text, "Break sharp edges & clean");
  EXPECT_EQ(model.requirements[0].id, "metadata");
  EXPECT_EQ(model.requirements[1].text, "Heat treated");
  EXPECT_EQ(model.requirements[1].id, "metadata, 2");
}

TEST(ThreeMf, SupportsAndOtherObjectsAreLeftOutAndTold) {
  const auto typed = [](int id, const std::string& type) {
    std::string text = cube(id);
    text.replace(text.find("type=\"model\""), 12, "type=\"" + type + "\"");
    return text;
  };
  const importer::ReadModel model =
      read(model_of(cube(1) + typed(2, "support") + typed(3, "solidsupport") + typed(4, "other") + typed(5, "surface"),
                    item(1) + moved(2, 2) + moved(3, 4) + moved(4, 6) + moved(5, 8)));
  EXPECT_EQ(volume_of(model.mesh), 2) << "a surface is drawn";
  EXPECT_EQ(model.mesh.report.notes,
            std::vector<std::string>{"2 supports, 1 object of type 'other' are no parts of what is printed: left out"});
}

/// Two cubes in one mesh: the second one stands at x = 5.
std::string two_cubes() {
  std::string one = cube(1), other = cube(1);
  const auto inside = [](const std::string& text, const std::string& tag) {
    const std::size_t begin = text.find("<" + tag + ">") + tag.size() + 2;
    return text.substr(begin, text.find("</" + tag + ">") - begin);
  };
  std::string vertices = inside(other, "vertices"), triangles;
  for (std::size_t at = 0; (at = vertices.find("x=\"", at)) != std::string::npos; at += 3)
    vertices[at + 3] = vertices[at + 3] == '0' ? '5' : '6';
  const std::string first = inside(one, "triangles");
  for (std::size_t i = 0; i < first.size(); ++i) {
    const bool is_corner = i > 1 && first[i - 1] == '"' && first[i] >= '0' && first[i] <= '7';
    triangles += is_corner ? std::to_string(first[i] - '0' + 8) : std::string(1, first[i]);
  }
  one.insert(one.find("</vertices>"), vertices);
  one.insert(one.find("</triangles>"), triangles);
  return one;
}

std::string volume(int first, int last, const std::string& name, const std::string& type) {
  return "<volume firstid=\"" + std::to_string(first) + "\" lastid=\"" + std::to_string(last) +
         "\"><metadata type=\"volume\" key=\"name\" value=\"" + name +
         "\"/><metadata type=\"volume\" key=\"volume_type\" value=\"" + type + "\"/></volume>";
}

importer::ReadModel read_with_settings(const std::string& xml, const std::string& part, const std::string& objects) {
  std::vector<Entry> entries = entries_with(xml);
  entries.push_back({part, "<config>" + objects + "</config>"});
  const Folder folder;
  return read_by_importer(folder.file("m.3mf", archive_of(entries)));
}

TEST(ThreeMf, VolumesOfSlicersArePartsOrLeftOut) {
  const std::string xml = model_of(two_cubes(), item(1));
  const auto with = [&](const std::string& type) {
    return read_with_settings(xml, "Metadata/Slic3r_PE_model.config",
                              R"(<object id="1"><metadata type="object" key="name" value="whole"/>)" +
                                  volume(0, 11, "Body", "ModelPart") + volume(12, 23, "Lid &amp; seal", type) +
                                  "</object>");
  };
  const importer::ReadModel both = with("ModelPart");
  EXPECT_EQ(both.mesh.report.body_names, (std::vector<std::string>{"Body", "Lid & seal"}));
  EXPECT_EQ(volume_of(both.mesh), 2);
  const importer::ReadModel one = with("SupportBlocker");
  EXPECT_EQ(volume_of(one.mesh), 1);
  expect_extent(one.mesh, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(one.mesh.report.notes,
            std::vector<std::string>{"1 support blocker is no part of what is printed: left out"});
  EXPECT_EQ(with("NegativeVolume").mesh.report.notes,
            std::vector<std::string>{"1 negative volume is left out: the slicer would cut such out of the parts, which "
                                     "are drawn whole"});
}

// As Bambu Studio and OrcaSlicer write it, with the objects in parts of the package of their own.
TEST(ThreeMf, ComponentsOfSlicersArePartsOrLeftOut) {
  std::vector<Entry> entries = entries_with(
      model_of(R"(<object id="3" type="model"><components>)"
               R"(<component p:path="/3D/Objects/object_1.model" objectid="1"/>)"
               R"(<component p:path="/3D/Objects/object_1.model" objectid="2" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>)"
               "</components></object>",
               item(3)));
  entries.push_back({"3D/Objects/object_1.model", model_of(cube(1) + cube(2), "")});
  entries.push_back({"Metadata/model_settings.config",
                     R"(<config><object id="3"><metadata key="name" value="Assembly"/><part id="1" )"
                     R"(subtype="normal_part"><metadata key="name" value="Body"/></part><part id="2" )"
                     R"(subtype="modifier_part"><metadata key="name" value="Infill"/></part></object></config>)"});
  const Folder folder;
  const importer::ReadModel model = read_by_importer(folder.file("m.3mf", archive_of(entries)));
  EXPECT_EQ(volume_of(model.mesh), 1);
  ASSERT_FALSE(model.body_parts.empty());
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"1 modifier is no part of what is printed: left out"});
}

// manifold3d and others name the objects that hold a mesh as their only component.
TEST(ThreeMf, NamesOfComponentsAreThoseOfTheMeshesBelow) {
  const auto named = [](int id, const std::string& name, const std::string& components) {
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\" name=\"" + name + "\"><components>" + components +
           "</components></object>";
  };
  const importer::ReadModel model = read(model_of(
      cube(1) + named(2, "Pin0", "<component objectid=\"1\"/>") + named(3, "Pin1", "<component objectid=\"1\"/>") +
          named(4, "all", R"(<component objectid="2"/><component objectid="3" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>)"),
      item(4)));
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"Pin0", "Pin1"}));
}

TEST(ThreeMf, PartsInOnePlaceAreDrawnOnce) {
  std::string items;
  for (int i = 0; i < 100'000; ++i) items += item(1);
  const importer::ReadModel model = read(model_of(cube(1), items));
  EXPECT_EQ(model.mesh.report.triangles, 12);
  EXPECT_EQ(model.mesh.report.notes,
            std::vector<std::string>{"99999 parts stand in the place of the same part: drawn once"});
}

}  // namespace
}  // namespace epura::test::threemf_test
