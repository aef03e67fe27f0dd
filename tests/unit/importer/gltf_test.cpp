// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: parts in the wrong place, size or number, and files that lie about themselves.
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "gltf_file.hpp"

namespace epura::test::gltf::gltf_test {
namespace {

TEST(Gltf, AFileSaysThatItIsInMetresAndThatYPointsUp) {
  const importer::ReadModel model = read(cube_file());
  EXPECT_EQ(model.unit, 1000);
  EXPECT_TRUE(model.is_y_up);
  EXPECT_TRUE(model.mesh.report.single_precision);
  EXPECT_EQ(model.mesh.report.triangles, 12);
  EXPECT_EQ(volume_of(model.mesh), 1);
}

TEST(Gltf, BinaryFilesAreKnownByTheirFirstBytes) {
  const Folder folder;
  for (const char* name : {"m.glb", "m.of-no-format"})
    EXPECT_EQ(volume_of(read_by_importer(folder.file(name, cube_file().binary())).mesh), 1) << name;
  EXPECT_EQ(volume_of(read_by_importer(folder.file("text", cube_file().json(true))).mesh), 1);
}

// Application-specific data that is words for people is a note; other data is not.
TEST(Gltf, WordsOfTheFileAndItsNodesAreNotes) {
  File file = cube_file();
  file.nodes = R"({"name":"plate","mesh":0,"extras":{"Note":"Break sharp edges","mass":3,"notes":["a list"]}})";
  file.rest += R"(,"extras":{"semantic text":"Heat treated","author":"somebody"})";
  const importer::ReadModel model = read(file);
  ASSERT_EQ(model.requirements.size(), 2U);
  EXPECT_EQ(model.requirements[0].text, "Heat treated");
  EXPECT_EQ(model.requirements[0].id, "file.extras.semantic text");
  EXPECT_EQ(model.requirements[1].kind, importer::RequirementKind::note);
  EXPECT_EQ(model.requirements[1].text, "Break sharp edges");
  EXPECT_EQ(model.requirements[1].id, "node 0.extras.Note");
  EXPECT_TRUE(model.requirements[1].faces.empty());
}

TEST(Gltf, NodesPlaceMeshesAsOftenAsTheyStandThere) {
  File file = cube_file();
  const std::string half = std::to_string(std::sqrt(0.5));
  // A quarter turn about z, of a cube drawn out along its own y: (x, y, z) -> (10 - 2 y, x, z).
  file.nodes = R"({"name":"machine","children":[1,2,3]},{"name":"frame","mesh":0},)"
               R"({"name":"arm","mesh":0,"translation":[10,0,0],"rotation":[0,0,)" +
               half + "," + half + R"(],"scale":[1,2,1]},)" +
               R"({"name":"mirrored","mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, -3,0,0,1]})";
  const importer::ReadModel model = read(file);
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"frame", "arm", "mirrored"}));
  EXPECT_NEAR(volume_of(model.mesh), 1 + 2 + 1, 1e-5);
  expect_extent(model.mesh, {-4, 0, 0}, {10, 1, 1}, 1e-5);
  EXPECT_EQ(model.mesh.report.misoriented_edges, 0);
}

TEST(Gltf, MeshesHaveTheColourOfTheirMaterial) {
  File file = cube_file();
  const std::string cubes = file.primitives;
  file.rest += R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0.2158605,0,1]}},{"name":"plain"}])";
  const auto colours_with = [&](int first, int second) {
    const auto with = [&](int material) {
      return R"({"attributes":{"POSITION":0},"indices":1,"material":)" + std::to_string(material) + "}";
    };
    file.primitives = with(first) + "," + with(second);
    return read(file).mesh.report.body_colours;
  };
  EXPECT_EQ(colours_with(0, 0), (std::vector{std::optional(Colour{255, 128, 0})})) << "0.2158605 is 0.5 in sRGB";
  EXPECT_TRUE(colours_with(0, 1).empty()) << "two colours";
  EXPECT_TRUE(colours_with(1, 1).empty()) << "none";
  EXPECT_TRUE(colours_with(7, 7).empty()) << "a material that is not there";
}

TEST(Gltf, ParentsMoveTheirChildren) {
  File file = cube_file();
  file.nodes = R"({"scale":[2,2,2],"children":[1]},{"translation":[1,2,3],"children":[2]},{"mesh":0})";
  expect_extent(read(file).mesh, {2, 4, 6}, {4, 6, 8});
}

TEST(Gltf, OneSceneIsDrawn) {
  File file = cube_file();
  file.nodes = R"({"name":"a","mesh":0},{"name":"b","mesh":0,"translation":[2,0,0]})";
  file.rest = R"(,"scenes":[{"nodes":[0]},{"nodes":[1,0]}])";
  const importer::ReadModel first = read(file);
  expect_extent(first.mesh, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(first.mesh.report.notes,
            std::vector<std::string>{"of 2 scenes, scene 0 is drawn: 1 mesh of other scenes or of none left out"});
  file.rest = R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])";
  expect_extent(read(file).mesh, {2, 0, 0}, {3, 1, 1});
  file.rest = "";
  EXPECT_EQ(volume_of(read(file).mesh), 2);
}

// A strip around a cube, and what it leaves open as fans.
TEST(Gltf, StripsAndFansKeepTheirOutsideOutside) {
  File file = cube_file();
  const std::vector<std::uint8_t> strip{4, 0, 5, 1, 7, 3, 6, 2, 4, 0}, bottom{0, 2, 3, 1}, top{4, 5, 7, 6};
  for (const auto& numbers : {strip, bottom, top})
    file.accessors += "," + accessor(file.buffer.view(numbers), 5121, numbers.size(), "SCALAR");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":2,"mode":5},)"
                    R"({"attributes":{"POSITION":0},"indices":3,"mode":6},)"
                    R"({"attributes":{"POSITION":0},"indices":4,"mode":6})";
  const importer::ReadModel model = read(file);
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.misoriented_edges, 0);
}

TEST(Gltf, IndicesHaveThreeSizesOrAreNotThere) {
  for (const int type : {5121, 5123, 5125}) {
    File file;
    file.accessors = accessor(file.buffer.view(corners), 5126, 8, "VEC3") + ",";
    const std::vector<std::uint8_t> small(cube.begin(), cube.end());
    const std::vector<std::uint32_t> large(cube.begin(), cube.end());
    const int view = type == 5121   ? file.buffer.view(small)
                     : type == 5123 ? file.buffer.view(cube)
                                    : file.buffer.view(large);
    file.accessors += accessor(view, type, cube.size(), "SCALAR");
    EXPECT_EQ(volume_of(read(file).mesh), 1) << type;
  }
  File soup;
  std::vector<float> all;
  for (const std::uint16_t corner : cube) all.insert(all.end(), &corners[3 * corner], &corners[3 * corner] + 3);
  soup.accessors = accessor(soup.buffer.view(all), 5126, cube.size(), "VEC3");
  soup.primitives = R"({"attributes":{"POSITION":0}})";
  const importer::ReadModel model = read(soup);
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.open_edges, 0) << "equal places are one";
}

TEST(Gltf, SparseAccessorsReplaceElements) {
  File file = cube_file();
  const int places = file.buffer.view(std::vector<std::uint16_t>{4, 5, 6, 7});
  const int values = file.buffer.view(std::vector<float>{0, 0, 3, 1, 0, 3, 0, 1, 3, 1, 1, 3});
  const std::string sparse = R"(,"sparse":{"count":4,"indices":{"bufferView":)" + std::to_string(places) +
                             R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(values) + "}}";
  File over_zeros = file;
  file.accessors = accessor(0, 5126, 8, "VEC3", sparse) + "," + accessor(1, 5123, cube.size(), "SCALAR");
  EXPECT_EQ(volume_of(read(file).mesh), 3);
  // Without a view all that is not replaced is zero.
  over_zeros.accessors =
      R"({"componentType":5126,"count":8,"type":"VEC3")" + sparse + "}," + accessor(1, 5123, cube.size(), "SCALAR");
  expect_extent(read(over_zeros).mesh, {0, 0, 0}, {1, 1, 3});
}

TEST(Gltf, QuantisedPositionsAreIntegers) {
  File file;
  std::vector<std::int16_t> shorts;
  std::vector<std::int8_t> bytes;  // four of a vertex: views keep to four bytes
  for (std::size_t i = 0; i < corners.size(); ++i) {
    shorts.push_back(corners[i] > 0 ? 32767 : -32768);
    bytes.push_back(corners[i] > 0 ? 100 : -20);
    if (i % 3 == 2) {
      shorts.push_back(0);
      bytes.push_back(0);
    }
  }
  const int of_shorts = file.buffer.view(shorts, ",\"byteStride\":8");
  const int of_bytes = file.buffer.view(bytes, ",\"byteStride\":4");
  const std::string indices = "," + accessor(file.buffer.view(cube), 5123, cube.size(), "SCALAR");
  file.rest += R"(,"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"])";
  file.accessors = accessor(of_shorts, 5122, 8, "VEC3", ",\"normalized\":true") + indices;
  expect_extent(read(file).mesh, Vec3(-1), Vec3(1));
  EXPECT_DOUBLE_EQ(read(file).mesh.report.resolution, 1 / 32767.0);
  file.nodes = R"({"mesh":0,"scale":[0.5,0.5,0.5]})";
  EXPECT_DOUBLE_EQ(read(file).mesh.report.resolution, 0.5 / 32767);
  file.nodes = R"({"mesh":0})";
  file.accessors = accessor(of_bytes, 5120, 8, "VEC3") + indices;
  expect_extent(read(file).mesh, Vec3(-20), Vec3(100));
  EXPECT_EQ(read(file).mesh.report.resolution, 1);
}

TEST(Gltf, LinesAreWiresAndPointsAreCrosses) {
  File file = cube_file();
  file.accessors += "," + accessor(file.buffer.view(std::vector<std::uint16_t>{0, 6, 1, 7}), 5123, 4, "SCALAR");
  const std::string cube_alone = file.primitives;
  const auto edges = [](const mesh::Mesh& mesh) {
    std::vector<std::array<int, 2>> ends;
    for (const mesh::MeshEdge& edge : mesh.edges)
      if (edge.wire && edge.vertex[1] < mesh.report.vertices) ends.push_back(edge.vertex);
    return ends;
  };
  const std::vector<std::vector<std::array<int, 2>>> expected{
      {}, {{0, 6}, {1, 7}}, {{0, 6}, {0, 7}, {1, 6}, {1, 7}}, {{0, 6}, {1, 6}, {1, 7}}};
  for (std::size_t mode = 0; mode < expected.size(); ++mode) {
    file.primitives = cube_alone + R"(,{"attributes":{"POSITION":0},"indices":2,"mode":)" + std::to_string(mode) + "}";
    const mesh::Mesh mesh = read(file).mesh;
    EXPECT_EQ(edges(mesh), expected[mode]) << mode;
    EXPECT_EQ(volume_of(mesh), 1);
    EXPECT_EQ(mesh.report.points, mode == 0 ? 4 : 0);
    EXPECT_TRUE(mesh.report.notes.empty()) << mode;
  }
  file.primitives = R"({"attributes":{"POSITION":0},"indices":2,"mode":2})";
  const mesh::Mesh lines = read(file).mesh;
  EXPECT_EQ(lines.report.triangles, 0);
  EXPECT_EQ(lines.report.vertices, 4) << "without the points of the cube";
  EXPECT_EQ(lines.report.wires, 4);
}

// tinygltf drops them.
TEST(Gltf, PrimitivesWithoutAttributesAreTold) {
  File file = cube_file();
  file.primitives += R"(,{"indices":1})";
  const importer::ReadModel model = read(file);
  EXPECT_EQ(volume_of(model.mesh), 1);
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"'attributes' is missing in one of its tables"});
}

TEST(Gltf, BuffersBesideTheFileAreRead) {
  const Folder folder;
  File file = cube_file();
  std::filesystem::create_directory(folder / "sub");
  file.uri = "sub/with%20space.bin";
  folder.file("sub/with space.bin", file.buffer.bytes);
  EXPECT_EQ(volume_of(read_by_importer(folder.file("m.gltf", file.json(true))).mesh), 1);
  file.uri = "missing.bin";
  EXPECT_EQ(refusal_of(folder.file("m.gltf", file.json(true))), "refers to 'missing.bin', which is not there");
  file.uri = std::string(300, 'a');
  EXPECT_TRUE(
      refusal_of(folder.file("m.gltf", file.json(true))).ends_with("which cannot be opened: File name too long"));
}

TEST(Gltf, NothingOutsideTheFolderIsOpened) {
  const Folder folder;
  File file = cube_file();
  std::filesystem::create_directory(folder / "inner");
  folder.file("secret.bin", file.buffer.bytes);
  std::filesystem::create_symlink(folder / "secret.bin", folder / "inner/link.bin");
  const std::string absolute = (folder / "secret.bin").string();
  const auto refusal_with = [&](const std::string& uri) {
    file.uri = uri;
    return refusal_of(folder.file("inner/m.gltf", file.json(true)));
  };
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("a/../../secret.bin"), absolute, std::string("link.bin")})
    EXPECT_EQ(refusal_with(uri), "refers to '" + uri + "', which lies outside its folder");
  EXPECT_EQ(refusal_with("%2e%2e/secret.bin"), "refers to '../secret.bin', which lies outside its folder");
  for (const std::string uri :
       {"http://127.0.0.1:1/x.bin", "https://example.invalid/x", "file:///etc/passwd", "ftp://x"})
    EXPECT_EQ(refusal_with(uri), "refers to '" + uri + "', which is not opened: only files in its own folder are");
}

TEST(Gltf, FilesOutsideTheFolderAreOpenedIfThatIsAllowed) {
  const Folder folder;
  File file = cube_file();
  file.uri = "../beside.bin";
  std::filesystem::create_directory(folder / "inner");
  folder.file("beside.bin", file.buffer.bytes);
  importer::ReadOptions options;
  options.plugin_path = {EPURA_TEST_IMPORTERS};
  options.allow_outside = true;
  const std::string path = folder.file("inner/m.gltf", file.json(true));
  EXPECT_EQ(volume_of(importer::read_model(path, {}, options).mesh), 1);
}

TEST(Gltf, ImagesAreNotOpened) {
  File file = cube_file();
  file.rest += R"(,"images":[{"uri":"../../etc/passwd"},{"uri":"http://x/y.png"},{"uri":"gone.jpg"}])";
  EXPECT_EQ(volume_of(read(file).mesh), 1);
}

TEST(Gltf, PlacesOutOfRangeAreNamed) {
  const auto refusal_with = [](const std::string& what, const std::string& by) {
    const Folder folder;
    std::string json = cube_file().json(true);
    replace(json, what, by);
    return refusal_of(folder.file("m.gltf", json));
  };
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":9"), "accessor 0 reaches beyond the end of bufferView 0");
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":7"), "mesh 0, primitive 0 has a corner 7, but only 7 positions");
  EXPECT_EQ(refusal_with("\"count\":8", "\"count\":4000000000"),
            "accessor 0 claims to have 4000000000 elements, more than there are bytes");
  EXPECT_EQ(refusal_with("\"count\":36", "\"count\":35"),
            "mesh 0, primitive 0 has 35 corners, which make no triangles");
  EXPECT_EQ(refusal_with("\"byteOffset\":96", "\"byteOffset\":100"),
            "bufferView 1 reaches beyond the end of its buffer");
  EXPECT_EQ(refusal_with("\"byteOffset\":96", "\"byteOffset\":18446744073709551615"),
            "bufferView 1 reaches beyond the end of its buffer");
  EXPECT_EQ(refusal_with("\"bufferView\":0", "\"bufferView\":7"), "bufferView 7 is not there");
  EXPECT_EQ(refusal_with("\"bufferView\":0", "\"byteOffset\":97,\"bufferView\":0"),
            "accessor 0 reaches beyond the end of bufferView 0");
  EXPECT_EQ(refusal_with("{\"buffer\":0", "{\"buffer\":5"), "bufferView 0 is of a buffer that is not there");
  EXPECT_EQ(refusal_with("\"POSITION\":0", "\"POSITION\":8"), "accessor 8 is not there");
  EXPECT_EQ(refusal_with("\"POSITION\":0", "\"NORMAL\":0"), "mesh 0, primitive 0 has no positions");
  EXPECT_EQ(refusal_with("\"indices\":1", "\"indices\":1,\"mode\":9"), "mesh 0, primitive 0 is of unknown mode 9");
  EXPECT_EQ(refusal_with("\"mesh\":0", "\"mesh\":3"), "node 0 has a mesh 3, which is not there");
  EXPECT_EQ(refusal_with("\"VEC3\"", "\"VEC2\""), "accessor 0 holds no points");
  EXPECT_EQ(refusal_with("5126", "5125"), "accessor 0 has positions of component type 5125");
}

TEST(Gltf, SparsePartsOutOfRangeAreNamed) {
  File file = cube_file();
  const int places = file.buffer.view(std::vector<std::uint16_t>{8});
  const int values = file.buffer.view(std::vector<float>{0, 0, 3});
  const auto with = [&](const std::string& count, int of_values) {
    File sparse = file;
    sparse.accessors =
        accessor(0, 5126, 8, "VEC3",
                 R"(,"sparse":{"count":)" + count + R"(,"indices":{"bufferView":)" + std::to_string(places) +
                     R"(,"componentType":5123},"values":{"bufferView":)" + std::to_string(of_values) + "}}") +
        "," + accessor(1, 5123, cube.size(), "SCALAR");
    return refusal(sparse);
  };
  EXPECT_EQ(with("1", values), "accessor 0: its sparse part replaces element 8 of 8");
  EXPECT_EQ(with("2", values), "accessor 0 reaches beyond the end of bufferView 2");
  EXPECT_EQ(with("-1", values), "accessor 0: its sparse part has negative places");
  EXPECT_EQ(with("1", 9), "bufferView 9 is not there");
}

TEST(Gltf, NodesAreATree) {
  File file = cube_file();
  const auto refusal_with = [&](const std::string& nodes) {
    file.nodes = nodes;
    return refusal(file);
  };
  EXPECT_EQ(refusal_with(R"({"mesh":0,"children":[1]},{"children":[0]})"),
            "node 0 stands in two places, or below itself");
  EXPECT_EQ(refusal_with(R"({"mesh":0,"children":[0]})"), "node 0 stands in two places, or below itself");
  EXPECT_EQ(refusal_with(R"({"children":[1,1]},{"mesh":0})"), "node 1 stands in two places, or below itself");
  EXPECT_EQ(refusal_with(R"({"children":[4]})"), "node 0 has a node 4, which is not there");
  EXPECT_EQ(refusal_with(R"({"mesh":0,"matrix":[1,2,3]})"), "node 0 has a matrix of 3 numbers");
  EXPECT_EQ(refusal_with(R"({"mesh":0,"matrix":[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]})"),
            "node 0 has a matrix that is not affine");
  EXPECT_EQ(refusal_with(R"({"mesh":0,"rotation":[0,0,0,0]})"), "node 0 has a rotation that is none");
  file.rest = "";
  EXPECT_EQ(refusal_with(R"({"mesh":0,"children":[1]},{"children":[0]})"), "its nodes stand in a circle");
}

TEST(Gltf, ALongChainOfNodesIsNoTrouble) {
  File file = cube_file();
  constexpr int count = 100'000;
  file.nodes.clear();
  for (int i = 1; i < count; ++i) file.nodes += R"({"children":[)" + std::to_string(i) + "]},";
  file.nodes += R"({"mesh":0})";
  EXPECT_EQ(volume_of(read(file).mesh), 1);
}

TEST(Gltf, PositionsAreFinite) {
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    File file;
    std::vector<float> damaged = corners;
    damaged[10] = wrong;
    file.accessors = accessor(file.buffer.view(damaged), 5126, 8, "VEC3");
    file.accessors += "," + accessor(file.buffer.view(cube), 5123, cube.size(), "SCALAR");
    EXPECT_EQ(refusal(file), "accessor 0: position 3 is not finite");
  }
}

TEST(Gltf, UnknownExtensionsAreNamedWhereTheyAreNeeded) {
  File file = cube_file();
  file.rest += R"(,"extensionsUsed":["EXT_unknown_shape"])";
  EXPECT_EQ(volume_of(read(file).mesh), 1);
  file.rest += R"(,"extensionsRequired":["KHR_materials_unlit","EXT_unknown_shape"])";
  EXPECT_EQ(refusal(file), "needs the extension EXT_unknown_shape, which is not read");
}

// Their accessors have no views, which tinygltf takes for damage.
TEST(Gltf, CompressionByDracoIsNamed) {
  File file = cube_file();
  file.accessors =
      R"({"componentType":5126,"count":8,"type":"VEC3"},{"componentType":5123,"count":36,"type":"SCALAR"})";
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":)"
                    R"({"bufferView":0,"attributes":{"POSITION":0}}}})";
  file.rest +=
      R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])";
  EXPECT_EQ(refusal(file), EPURA_TEST_HAS_DRACO
                               ? "mesh 0, primitive 0: its Draco data has no header"
                               : "needs the extension KHR_draco_mesh_compression, which is not read: this importer was "
                                 "built without libdraco-dev");
}

TEST(Gltf, FilesCutShortAndOtherVersionsAreTold) {
  const Folder folder;
  const std::string bytes = cube_file().binary();
  const auto refusal_with = [&](std::string_view text) { return refusal_of(folder.file("m.glb", text)); };
  EXPECT_EQ(refusal_with(std::string_view(bytes).substr(0, bytes.size() - 1)),
            "ends after " + std::to_string(bytes.size() - 1) + " of " + std::to_string(bytes.size()) + " bytes");
  EXPECT_EQ(refusal_with("glTF"), "ends within its header");
  EXPECT_EQ(refusal_with(std::string("glTF\1\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0", 20)),
            "is GLB of version 1; version 2 is read");
  EXPECT_EQ(refusal_with(R"({"asset":{"version":"1.0"},"nodes":{}})"), "is glTF of version 1.0; version 2 is read");
  EXPECT_TRUE(contains(refusal_with(R"({"asset":{"version":"2.0"},"buffers":[)"), "is not a valid glTF file: "))
      << "cut short";
  EXPECT_EQ(refusal_with(std::string(100'000, '[')), "holds JSON of more than 200 levels");
  const std::string extras = R"({"asset":{"version":"2.0","extras":)" + std::string(100'000, '[');
  EXPECT_EQ(refusal_with(extras), "holds JSON of more than 200 levels");
}

TEST(Gltf, HiddenNodesAreLeftOutAndTold) {
  File file = cube_file();
  file.nodes = R"({"mesh":0},{"extensions":{"KHR_node_visibility":{"visible":false}},"children":[2]},)"
               R"({"mesh":0,"translation":[5,0,0]})";
  file.rest = R"(,"scene":0,"scenes":[{"nodes":[0,1]}],"extensionsUsed":["KHR_node_visibility"])";
  const importer::ReadModel model = read(file);
  expect_extent(model.mesh, {0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(model.mesh.report.notes, std::vector<std::string>{"1 mesh hidden by the file left out"});
}

// A quarter turn about z maps (x, y) to (-y, x): the second copy is twice as large and lies from x = 8 to 10.
TEST(Gltf, InstancesAreScaledTurnedAndMovedBelowTheirNode) {
  File file = cube_file();
  const float half = 0.70710678f;
  file.accessors += "," + accessor(file.buffer.view(std::vector<float>{0, 0, 0, 10, 0, 0}), 5126, 2, "VEC3") + "," +
                    accessor(file.buffer.view(std::vector<float>{0, 0, 0, 1, 0, 0, half, half}), 5126, 2, "VEC4") +
                    "," + accessor(file.buffer.view(std::vector<float>{1, 1, 1, 2, 2, 2}), 5126, 2, "VEC3");
  file.nodes = R"({"name":"pin","mesh":0,"translation":[0,0,3],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)"
               R"({"TRANSLATION":2,"ROTATION":3,"SCALE":4}}}})";
  file.rest += R"(,"extensionsUsed":["EXT_mesh_gpu_instancing"],"extensionsRequired":["EXT_mesh_gpu_instancing"])";
  const importer::ReadModel model = read(file);
  EXPECT_NEAR(volume_of(model.mesh), 1 + 8, 1e-5);
  expect_extent(model.mesh, {0, 0, 3}, {10, 2, 5}, 1e-6);
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"pin", "pin"}));
  replace(file.nodes, R"("SCALE":4)", R"("SCALE":0)");
  EXPECT_EQ(refusal(file), "node 0 has instances whose attributes differ in number");
}

TEST(Gltf, NamesOfNodesComeBeforeThoseOfMeshes) {
  File file = cube_file();
  file.nodes = R"({"name":"Pin","mesh":0},{"name":"Pin.001","mesh":0,"translation":[5,0,0]})";
  file.rest = R"(,"scene":0,"scenes":[{"nodes":[0,1]}])";
  const importer::ReadModel model = read(file);
  EXPECT_EQ(model.mesh.report.body_names, (std::vector<std::string>{"Pin", "Pin.001"}));
  for (const importer::BodyPart& part : model.body_parts) EXPECT_EQ(part.name, "Pin");
}

TEST(Gltf, AnEmptyChunkOfBytesIsNoDamage) {
  File file;
  std::string bytes = "glTF";
  std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":0}],"nodes":[{"name":"a"}]})";
  while (text.size() % 4 != 0) text += ' ';
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(28 + text.size()));
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += "JSON" + text;
  append(bytes, std::uint32_t{0});
  bytes += std::string("BIN\0", 4);
  const Folder folder;
  EXPECT_EQ(refusal_of(folder.file("m.glb", bytes)), "holds no mesh to draw");
}

}  // namespace
}  // namespace epura::test::gltf::gltf_test
