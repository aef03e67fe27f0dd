// SPDX-License-Identifier: Apache-2.0
// Tests for strangers' importers, on importers that pass and on one that does not.
#include "importer/check_importer.hpp"

#include "importer/catalogue.hpp"
#include "support.hpp"

namespace epura::test::check_importer_test {
namespace {

std::string fault_of(const std::vector<foreign::CheckResult>& results, const std::string& name) {
  for (const foreign::CheckResult& result : results)
    if (result.name == name) return result.verdict == foreign::Verdict::failed ? result.fault : "passed";
  return "not done";
}

TEST(CheckImporter, NamesWhatIsWrong) {
  const Folder folder;
  const auto importers = importer::importers_of(folder_of("good") / "plain.so");
  const auto results = importer::check_importer(importers.at(0), {folder.file("a.plain", "plain")}, 10);
  EXPECT_EQ(fault_of(results, "marks"), "passed");
  EXPECT_EQ(fault_of(results, "refuses"), "makes faces, wires or points of a file that holds none");
  EXPECT_EQ(fault_of(results, "reads"), "passed");
  EXPECT_EQ(fault_of(results, "repeats"), "passed");
  EXPECT_EQ(fault_of(results, "survives"), "passed");
}

TEST(CheckImporter, ACrashIsAFaultOfTheCheckInWhichItHappens) {
  const Folder folder;
  const auto importers = importer::importers_of(folder_of("crashes") / "plain.so");
  const auto results = importer::check_importer(importers.at(0), {}, 10);
  EXPECT_TRUE(contains(fault_of(results, "refuses"), "crashes (Aborted)")) << fault_of(results, "refuses");
  EXPECT_EQ(fault_of(results, "reads"), "not done");
}

TEST(CheckImporter, ThoseThatAreBuiltPass) {
  for (const importer::ImporterEntry& entry : importer::load_catalogue({EPURA_TEST_IMPORTERS}).entries) {
    SCOPED_TRACE(entry.table.name);
    const auto results = importer::check_importer(entry, {EPURA_TEST_SAMPLES "/step/clamp.step"}, 60);
    for (const foreign::CheckResult& result : results)
      EXPECT_EQ(result.verdict, foreign::Verdict::passed) << result.name << ": " << result.fault;
    EXPECT_EQ(fault_of(results, "reads"), entry.table.name == "step" ? "passed" : "not done");
  }
}

}  // namespace
}  // namespace epura::test::check_importer_test
