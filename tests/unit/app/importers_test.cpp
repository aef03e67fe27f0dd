// SPDX-License-Identifier: Apache-2.0
// epura importers, as users run it.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::importers_test {
namespace {

Outcome importers(std::vector<std::string> options) {
  options.insert(options.begin(), "importers");
  return epura(options, Folder() / "");
}

TEST(ImportersCommand, ListsWhatIsBuiltInAndThePlugins) {
  const Outcome run = importers({});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* words : {"built in\n  obj       .obj              Wavefront OBJ", "\n  stl       .stl ",
                            "\n  ply       .ply ", "\n  off       .off "})
    EXPECT_TRUE(contains(run.out, words)) << words << "\n" << run.out;
}

TEST(ImportersCommand, ShowsOneByNameOrExtension) {
  EXPECT_EQ(importers({"ply"}).out, "ply (.ply): PLY, text and binary: polygons\nbuilt in\n");
  const Outcome unknown = importers({"plyy"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_EQ(unknown.err, "epura: plyy: no such importer\n  hint: did you mean 'ply'?\n");
}

}  // namespace
}  // namespace epura::test::importers_test
