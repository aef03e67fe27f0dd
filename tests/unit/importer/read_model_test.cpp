// SPDX-License-Identifier: Apache-2.0
// Which importer reads a file, and what reaches this process of whatever it does.
#include "importer/read_model.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <vector>

#include "importer/bounds.hpp"
#include "importer/catalogue.hpp"
#include "importer/memory.hpp"
#include "support.hpp"

namespace epura::test::read_model_test {
namespace {

TEST(ImporterProcess, HandsOverWhatTheImporterReads) {
  const Folder folder;
  const importer::ReadModel model = read_by("good", folder.file("a.plain", "plain"), {{"size", "2"}});
  EXPECT_EQ(model.mesh.report.format, "plain");
  EXPECT_EQ(model.mesh.report.triangles, 2);
  EXPECT_EQ(model.mesh.point(2), Vec3(2, 2, 0));
  EXPECT_EQ(model.unit, 1);
  EXPECT_FALSE(model.is_y_up);
  ASSERT_NE(model.part, nullptr);
  EXPECT_EQ(model.part->faces.at(0).surface.kind, surfaces::SurfaceKind::sphere);
}

TEST(ImporterProcess, HandsOverWires) {
  const Folder folder;
  const importer::ReadModel model = read_by("wire", folder.file("a.plain", "plain"));
  EXPECT_EQ(model.mesh.report.wires, 1);
  ASSERT_NE(model.mesh.edge_between({0, 2}), nullptr);
  EXPECT_TRUE(model.mesh.edge_between({0, 2})->wire);
  EXPECT_EQ(read_by("good", folder.file("a.plain", "plain")).mesh.report.wires, 0);
}

TEST(ImporterProcess, HandsOverPoints) {
  const Folder folder;
  const mesh::MeshReport report = read_by("point", folder.file("a.plain", "plain")).mesh.report;
  EXPECT_EQ(report.points, 1);
  EXPECT_EQ(report.wires, report.point_arms);
}

TEST(ImporterProcess, HandsOverColours) {
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  EXPECT_EQ(read_by("coloured", file).mesh.report.body_colours, (std::vector{std::optional(Colour{0, 128, 255})}));
  EXPECT_TRUE(read_by("good", file).mesh.report.body_colours.empty());
}

TEST(ImporterProcess, IsChosenByExtensionOrByContent) {
  const Folder folder;
  for (const char* name : {"a.plain", "A.PLN"})
    EXPECT_EQ(read_by("good", folder.file(name, "whatever")).mesh.report.format, "plain") << name;
  EXPECT_EQ(read_by("good", folder.file("a.dat", "plain text")).mesh.report.format, "plain");
  EXPECT_EQ(read_by("good", folder.file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).mesh.report.format, "obj");
  EXPECT_EQ(read_by("good", folder.file("b.dat", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).mesh.report.format,
            "off");
}

TEST(ImporterProcess, IsChosenByContentWhereTheNameIsWrong) {
  const Folder folder;
  for (const char* name : {"a.stl", "a.obj", "a.ply"}) {
    const mesh::MeshReport report = read_by("good", folder.file(name, "plain text")).mesh.report;
    EXPECT_EQ(report.format, "plain") << name;
    EXPECT_EQ(report.notes.back(), "the file is named " + std::string(name + 1) + ", but holds plain");
  }
}

TEST(ImporterProcess, IsNotUsedForAMeshThatIsNamedAsOneOfItsFiles) {
  const Folder folder;
  for (const char* extension : {"step", "iges", "brep", "3mf", "gltf", "glb"}) {
    const std::string name = std::string("a.") + extension;
    for (const auto& [format, text] :
         {std::pair("obj", "# a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
          std::pair("stl",
                    "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n")}) {
      const mesh::MeshReport report = read_by_importer(folder.file(name, text)).mesh.report;
      EXPECT_EQ(report.format, format) << name;
      EXPECT_EQ(report.notes.back(), "the file is named ." + std::string(extension) + ", but holds " + format);
    }
  }
  const std::string other = R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                            R"("nodes":[{"mesh":0}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3"}]})";
  EXPECT_TRUE(contains(refusal_of(folder.file("a.step", other)), "accessor 0 claims to have 3 elements")) << "glTF";
  EXPECT_TRUE(contains(refusal_of(folder.file("a.step", "a text")), "is not a STEP file"));
}

TEST(ImporterProcess, FormatsOfLibrariesAreListedForAnUnknownName) {
  const Folder folder;
  try {
    read_by("good", folder.file("a.amf", "<amf>"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint().rfind("supported: .obj, .stl, .ply, .off, .plain, .pln", 0), 0U) << error.hint();
  }
}

TEST(ImporterProcess, LibrariesOfProjectionsAreNoMistake) {
  const importer::Catalogue catalogue = importer::load_catalogue({EPURA_TEST_PLUGINS});
  EXPECT_TRUE(catalogue.entries.empty());
  EXPECT_TRUE(catalogue.bad.empty()) << catalogue.bad.at(0).reason;
}

struct Mistake {
  const char* importer;
  const char* sentence;
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.importer; }

class BadLibrary : public testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(
    Importers, BadLibrary,
    testing::Values(Mistake{"missing-symbol", "is not a library of importers: it has no function epura_importers_v1"},
                    Mistake{"no-list", "epura_importers_v1 returns nothing"},
                    Mistake{"other-abi", "is built for importer ABI 9, this program has 1"},
                    Mistake{"short-list", "its list is too short: 8 of 24 bytes"},
                    Mistake{"empty-list", "offers no importer"},
                    Mistake{"short-row", "its list has rows of 8 bytes, at least 64 are needed"},
                    Mistake{"bad-name", "importer 1: the name 'Plain' is not lower case, digits and '-'"},
                    Mistake{
                        "bad-extension",
                        "importer 'plain' has an extension that is not lower case, digits and '-' with '|' between"},
                    Mistake{"no-function", "importer 'plain' has no function"}));

TEST_P(BadLibrary, IsNamedWithTheReason) {
  const importer::Catalogue catalogue = importer::load_catalogue({folder_of(GetParam().importer)});
  EXPECT_TRUE(catalogue.entries.empty());
  ASSERT_EQ(catalogue.bad.size(), 1U);
  EXPECT_EQ(catalogue.bad[0].path, folder_of(GetParam().importer) / "plain.so");
  EXPECT_EQ(catalogue.bad[0].reason, GetParam().sentence);
}

class BadAnswer : public testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(
    Importers, BadAnswer,
    testing::Values(Mistake{"wrong-corner", "hands over a polygon with a corner that is no point of the shape"},
                    Mistake{"no-radius", "hands over a round face whose radius is not positive"},
                    Mistake{"short-edge", "hands over an edge of fewer than two points"},
                    Mistake{"wrong-edge", "hands over an edge with a corner that is no point of the shape"},
                    Mistake{"wrong-wire", "hands over a wire with a corner that is no point of the shape"},
                    Mistake{"other-edge", "hands over an edge of unknown kind 4"},
                    Mistake{"wrong-point", "hands over a point that is not one"},
                    Mistake{"parent-to-come", "hands over a node whose parent is not an earlier one"},
                    Mistake{"missing-shape", "hands over a node with a shape that it does not hand over"},
                    Mistake{"infinite", "hands over a node whose transform is not finite"},
                    Mistake{"no-unit", "hands over a unit of length that is not positive"},
                    Mistake{"no-colour", "hands over a colour that is not between 0 and 1"},
                    Mistake{"colour-of-nothing", "hands over a colour of nothing"},
                    Mistake{"crosses", "threw an exception across the C interface"},
                    Mistake{"crashes", "crashes (Aborted)"}, Mistake{"exits", "exits"},
                    Mistake{"cuts-the-line", "exits"}));

TEST_P(BadAnswer, IsToldWithTheLibraryTheNameAndTheFile) {
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  const Error error = error_of([&] { read_by(GetParam().importer, file); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_EQ(error.what(), (folder_of(GetParam().importer) / "plain.so").string() + ": 'plain' " + GetParam().sentence +
                              " at " + file);
}

TEST(ImporterProcess, OneThatHangsEndsWithTheTime) {
  const Folder folder;
  ProgressBoard board;
  board.begin("reading", 0);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(importer::read_model(folder.file("a.plain", "plain"), {}, {.plugin_path = {folder_of("hangs")}},
                                    Progress(board, 0.5)),
               OutOfTime);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

// The place and the reason.
std::string refusal_within(const foreign::Assignments& bounds, const std::string& importer, const std::string& file) {
  const Error error = error_of([&] { read_by(importer, file, bounds); });
  EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
  EXPECT_TRUE(contains(error.hint(), "is the file whole?")) << error.hint();
  EXPECT_TRUE(contains(error.hint(), file + ":" + bounds.front().first + "=")) << error.hint();
  return error.what();
}

TEST(ImporterProcess, OneThatHangsOrCreepsEndsWithThePatienceForItsFile) {
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  for (const char* importer : {"hangs", "creeps"}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(refusal_within({{"patience", "0.4"}}, importer, file), file + ": reading it makes no progress for 0.4 s");
    EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(400));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  }
}

// Processes that keep the first processor of this one busy, and this one on it.
class Rivals {
 public:
  explicit Rivals(int count) {
    ::sched_getaffinity(0, sizeof before_, &before_);
    int first = 0;
    while (!CPU_ISSET(first, &before_)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ::sched_setaffinity(0, sizeof one, &one);
    for (int i = 0; i < count; ++i) {
      const pid_t rival = ::fork();
      if (rival == 0)
        for (std::atomic<unsigned> turns = 0;;) ++turns;
      rivals_.push_back(rival);
    }
  }
  Rivals(const Rivals&) = delete;
  Rivals& operator=(const Rivals&) = delete;
  ~Rivals() {
    for (const pid_t rival : rivals_) {
      ::kill(rival, SIGKILL);
      ::waitpid(rival, nullptr, 0);
    }
    ::sched_setaffinity(0, sizeof before_, &before_);
  }

 private:
  cpu_set_t before_{};
  std::vector<pid_t> rivals_;
};

// Of those that have ended.
double processor_seconds_of_children() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// It has a quarter of a processor, and must have been at work for most of the time that was allowed.
TEST(ImporterProcess, TimeInWhichOthersHaveTheProcessorDoesNotCount) {
  if (!std::filesystem::exists("/proc/self/schedstat")) GTEST_SKIP();
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  const Rivals rivals(3);
  const double begun = processor_seconds_of_children();
  error_of([&] { read_by("exits", file); });
  const double started = processor_seconds_of_children();
  EXPECT_EQ(refusal_within({{"patience", "0.3"}}, "spins", file), file + ": reading it makes no progress for 0.3 s");
  EXPECT_GE(processor_seconds_of_children() - started, started - begun + 0.2);
}

// 2^28 bytes, where 0.1e9 are allowed.
TEST(ImporterProcess, OneThatTakesMoreMemoryThanItsFileMayIsEnded) {
  if (!importer::has_own_memory) GTEST_SKIP();
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  EXPECT_EQ(refusal_within({{"memory", "0.1"}}, "hungry", file),
            file + ": reading it runs out of memory: it may take 0.1 GB");
  EXPECT_EQ(read_by("hungry", file).mesh.report.triangles, 2);
}

TEST(ImporterProcess, MayTakeByItselfWhatItsFileIsLarge) {
  EXPECT_EQ(importer::bounds_for(0).memory, 2e9);
  EXPECT_EQ(importer::bounds_for(0).patience, 120);
  EXPECT_EQ(importer::bounds_for(10'000'000).memory, 5e9);
  EXPECT_EQ(importer::bounds_for(10'000'000).patience, 140);
}

TEST(ImporterProcess, ParametersOfBoundsAreThoseOfEpura) {
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  EXPECT_STREQ(error_of([&] {
                 read_by("good", file, {{"memory", "0"}});
               }).what(),
               "plain:memory: is 0, allowed is 0.1 to 1000 GB");
  const importer::Catalogue catalogue = importer::load_catalogue({folder_of("own-memory")});
  ASSERT_EQ(catalogue.bad.size(), 1U);
  EXPECT_EQ(catalogue.bad.front().reason, "has a parameter 'memory', a name that epura uses itself");
}

TEST(ImporterProcess, WhatItPrintsGoesToStandardError) {
  const Folder folder;
  testing::internal::CaptureStdout();
  read_by("prints", folder.file("a.plain", "plain"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(ImporterProcess, WrongFilesAndParametersAreToldWithTheirPlace) {
  const Folder folder;
  const std::string file = folder.file("a.plain", "plain");
  const auto told = [](const auto& action) {
    const Error error = error_of(action);
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return std::string(error.what());
  };
  EXPECT_EQ(told([&] { read_by("good", file, {{"size", "3"}}); }), "plain:size: is 3, allowed is 0.5 to 2");
  EXPECT_EQ(told([&] { read_by("good", file, {{"colour", "3"}}); }), "plain:colour: no such parameter");
  EXPECT_EQ(told([&] { read_by("good", folder.file("e.dat", "")); }), (folder / "e.dat").string() + ": is empty");
  EXPECT_TRUE(contains(told([&] { read_by("good", folder / "none.plain"); }), "none.plain: cannot read"));
  EXPECT_TRUE(
      contains(told([&] { read_by("good", folder / (std::string(300, 'a') + ".obj")); }), "a.obj: cannot read"));
  if (!std::filesystem::exists(EPURA_TEST_IMPORTERS "/opencascade.so")) {
    EXPECT_EQ(told([&] { read_by("good", folder.file("a.step", "x"), {}); }),
              (folder / "a.step").string() + ": no importer for '.step' is installed");
  }
  const std::string obj = folder.file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(told([&] {
              read_by("good", obj, {{"size", "3"}});
            }),
            obj + ":size: mesh files have no parameter of this name");
  EXPECT_EQ(told([&] {
              read_by("good", obj, {{"subdivide", "1.5"}});
            }),
            obj + ":subdivide: is '1.5', allowed is a whole number from 0 to 5");
  EXPECT_EQ(told([&] {
              read_by("good", obj, {{"sharp", "200"}});
            }),
            obj + ":sharp: is '200', allowed is 0 to 180, degrees");
  EXPECT_EQ(importer::read_model(obj, {{"subdivide", "2"}}).mesh.triangle_count(), 16);
}

TEST(ModelRequest, HasParametersBehindThePath) {
  const auto request = importer::parse_model_request("some/part.step:deflection=0.01:angle=20");
  EXPECT_EQ(request.path, "some/part.step");
  EXPECT_EQ(request.parameters, (foreign::Assignments{{"deflection", "0.01"}, {"angle", "20"}}));
  for (const char* path : {"part.step", "a:b/part.step", "part:1.step", "part:.step", "C=1:x.step"})
    EXPECT_EQ(importer::parse_model_request(path).path, path);
  const Folder folder;
  const std::string odd = folder.file("odd.stl:x=1", "");
  EXPECT_EQ(importer::parse_model_request(odd).path, odd);
  EXPECT_EQ(std::string(error_of([] { importer::parse_model_request("a.step:x=1:x=2"); }).what()),
            "a.step:x: is given twice");
}

}  // namespace
}  // namespace epura::test::read_model_test
