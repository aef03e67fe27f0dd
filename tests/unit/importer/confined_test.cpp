// SPDX-License-Identifier: Apache-2.0
// What an importer cannot do. The files lie in a folder of the user's, where only the sandbox is in the way.
#include <cstdlib>

#include "foreign/sandbox.hpp"
#include "support.hpp"

namespace epura::test::confined_test {
namespace {

namespace fs = std::filesystem;

class ConfinedImporter : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = foreign::reason_for_no_sandbox(); !reason.empty()) GTEST_SKIP() << reason;
    fs::create_directories(fs::path(model_).parent_path());
    folder_.file("model/a.plain", "plain");
    ::setenv("EPURA_TEST_SECRET", folder_.file("secret", "x").c_str(), 1);
    ::setenv("EPURA_TEST_MARK", (folder_ / "mark").c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("EPURA_TEST_SECRET");
    ::unsetenv("EPURA_TEST_MARK");
  }

  importer::ReadModel read(importer::ReadOptions options) const {
    options.plugin_path = {folder_of("spies")};
    return importer::read_model(model_, {}, options);
  }
  /// What the importer says that it could do.
  [[nodiscard]] std::string could(const importer::ReadOptions& options) const {
    const std::string text = error_of([&] { read(options); }).what();
    return text.substr(text.rfind(": ") + 2);
  }

  const Folder folder_;
  const std::string model_ = (folder_ / "model/a.plain").string();
};

TEST_F(ConfinedImporter, ReadsItsFileAndDoesNothingElse) {
  EXPECT_EQ(read({}).mesh.report.triangles, 2);
  EXPECT_FALSE(fs::exists(folder_ / "mark"));
}

TEST_F(ConfinedImporter, ReadsWhatLiesBelowTheFolderOfItsFile) {
  ::setenv("EPURA_TEST_SECRET", folder_.file("model/other", "x").c_str(), 1);
  EXPECT_EQ(could({}), "reads other files");
}

TEST_F(ConfinedImporter, MayReadEverythingIfAsked) {
  EXPECT_EQ(could({.plugin_path = {}, .allow_outside = true}), "reads other files");
}

TEST_F(ConfinedImporter, MayDoEverythingWithoutASandbox) {
  EXPECT_EQ(could({.plugin_path = {}, .is_confined = false}), "reads other files");
  ::setenv("EPURA_TEST_SECRET", (folder_ / "missing").c_str(), 1);
  EXPECT_EQ(could({.plugin_path = {}, .is_confined = false}), "writes files");
  ::setenv("EPURA_TEST_MARK", (folder_ / "missing/mark").c_str(), 1);
  EXPECT_EQ(could({.plugin_path = {}, .is_confined = false}), "has a network");
}

TEST_F(ConfinedImporter, ReadsALinkToItsFile) {
  fs::create_directory(folder_ / "links");
  fs::create_symlink(model_, folder_ / "links/b.plain");
  importer::ReadOptions options{.plugin_path = {folder_of("spies")}};
  EXPECT_EQ(importer::read_model((folder_ / "links/b.plain").string(), {}, options).mesh.report.triangles, 2);
}

TEST_F(ConfinedImporter, ReadsSeveralFilesOneAfterTheOther) {
  fs::create_directory(folder_ / "second");
  importer::ReadOptions options{.plugin_path = {folder_of("spies")}};
  for (const char* name : {"model/b.plain", "second/c.plain", "second/d.plain"})
    EXPECT_EQ(importer::read_model(folder_.file(name, "plain"), {}, options).mesh.report.triangles, 2) << name;
}

}  // namespace
}  // namespace epura::test::confined_test
