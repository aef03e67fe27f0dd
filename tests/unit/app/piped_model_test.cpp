// SPDX-License-Identifier: Apache-2.0
// Models on standard input.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "errors.hpp"
#include "program.hpp"

namespace epura::test::piped_model_test {
namespace {

struct PipedModel : ::testing::Test {
  Folder folder;

  Outcome draw(const std::string& model, const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"draw", "-", "--views", "front,top", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "", "", "exec < '" + model + "'");
  }
};

TEST_F(PipedModel, IsDrawnAsTheFile) {
  const std::string model = sample("gear.stl");
  ASSERT_EQ(epura({"draw", model, "--views", "front,top", "-o", "file.svg", "--title", "x"}, folder / "").code, 0);
  const Outcome piped = draw(model, "piped.svg", {"--title", "x"});
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(epura({"compare", "file.svg", "piped.svg"}, folder / "").code, 0);
}

TEST_F(PipedModel, MayBeOfAnyFormatThatItsContentShows) {
  const std::string obj = folder.file("m.obj", "# OBJ\no plate\nv 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
  EXPECT_EQ(draw(obj, "x.svg").code, 0);
  const Outcome none = draw(folder.file("m.txt", "whatever\n"), "x.svg");
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "standard input: has no extension, so its format is unknown")) << none.err;
  const Outcome broken = draw(folder.file("n.obj", "v 0 0 0\nf 1 2 3\n"), "x.svg");
  EXPECT_EQ(broken.code, 2);
  EXPECT_TRUE(contains(broken.err, "standard input:2: a face refers to vertex 3, but there are 1")) << broken.err;
}

TEST_F(PipedModel, IsReadOnce) {
  const Outcome twice = epura({"draw", "-", "-", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(twice.code, 2);
  EXPECT_TRUE(contains(twice.err, "-: standard input is one model, and is given twice")) << twice.err;
}

}  // namespace
}  // namespace epura::test::piped_model_test
