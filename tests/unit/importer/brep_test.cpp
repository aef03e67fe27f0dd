// SPDX-License-Identifier: Apache-2.0
// BREP files that are not whole.
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>

#include "at_length.hpp"
#include "base/file.hpp"
#include "support.hpp"

namespace epura::test::brep_test {
namespace {

// Wherever it ends, the next word is nowhere to be found; it was looked for again and again.
TEST(BrepImporter, RefusesFilesThatAreCutShortAtOnce) {
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

}  // namespace
}  // namespace epura::test::brep_test
