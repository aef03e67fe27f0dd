// SPDX-License-Identifier: Apache-2.0
// What stands on a sheet beside its views, in JSON: dimensions with what they measure, notes, frames, tables, title.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "schema.hpp"

namespace epura::test::annotations_json_test {
namespace {

class AnnotationsJson : public testing::Test {
 protected:
  // 60 x 40 x 10; its upper edge is cut off from (50, 10) to (60, 4).
  static constexpr const char* block =
      "v 0 0 0\nv 60 0 0\nv 60 0 4\nv 50 0 10\nv 0 0 10\nv 0 40 0\nv 60 40 0\nv 60 40 4\nv 50 40 10\nv 0 40 10\n"
      "f 1 2 3 4 5\nf 10 9 8 7 6\nf 1 6 7 2\nf 2 7 8 3\nf 3 8 9 4\nf 4 9 10 5\nf 5 10 6 1\n";
  // The same with its faces and corners in other places of the file.
  static constexpr const char* other_block =
      "v 0 40 10\nv 50 40 10\nv 60 40 4\nv 60 40 0\nv 0 40 0\nv 0 0 10\nv 50 0 10\nv 60 0 4\nv 60 0 0\nv 0 0 0\n"
      "f 6 1 5 10\nf 7 2 1 6\nf 8 3 2 7\nf 9 4 3 8\nf 10 5 4 9\nf 1 2 3 4 5\nf 10 9 8 7 6\n";

  Json drawn(const char* obj, const std::string& more = "") {
    folder_.file("block.obj", obj);
    folder_.file(
        "a.toml",
        "[[model]]\nfile = 'block.obj'\n[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'top'\n"
        "[[view]]\nprojection = 'left'\n[[sheet]]\nsize = 'A3'\nscale = '1:1'\n[title_block]\ntitle = 'Block'\n"
        "creator = 'N. N.'\n[[dimension]]\ntype = 'auto'\n" +
            more);
    const Outcome run = epura({"draw", "a.toml", "-o", "a.json"}, folder_ / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return JsonReader(read_file(folder_ / "a.json")).read()["annotations"];
  }
  static std::set<std::string> ids(const Json& annotations) {
    std::set<std::string> all;
    for (const Json& one : annotations["dimensions"].items) all.insert(one["id"].text);
    return all;
  }
  static const Json& with_text(const Json& annotations, const std::string& text) {
    const auto& list = annotations["dimensions"].items;
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Json& one) { return one["text"].text == text; });
    if (found == list.end()) throw std::runtime_error("no dimension " + text);
    return *found;
  }

  Folder folder_;
};

const std::string extras =
    "[[dimension]]\nmatch = '40'\nview = 'left'\ntolerance = '+0.2 -0.1'\nname = 'depth'\n[[note]]\ntext = "
    "['deburred', 'all edges']\n"
    "to = {point = [30, 0, 10]}\n[[tolerance_frame]]\ncharacteristic = 'flatness'\nzone = '0.05'\nview = 'front'\n"
    "to = {point = [20, 0, 10]}\n[[table]]\nrows = [['a', 'b'], ['1', '2']]\n";

TEST_F(AnnotationsJson, IsAsTheSchemaSays) {
  const Json annotations = drawn(block, extras);
  EXPECT_EQ(Schema(read_file(root() / "src/sheet/output/annotations.schema.json")).fault_of(annotations), "");
  EXPECT_EQ(annotations["dimensions"].items.size(), 5U);
  const Json& note = annotations["notes"].items.at(1);
  EXPECT_EQ(note["lines"].items.at(0).text, "deburred");
  EXPECT_EQ(note["leader"].items.size(), 3U);
  EXPECT_EQ(annotations["frames"].items.at(0)["rows"].items.at(0)["characteristic"].text, "flatness");
  EXPECT_EQ(annotations["frames"].items.at(0)["rows"].items.at(0)["cells"].items.at(0).text, "0.05");
  EXPECT_EQ(annotations["tables"].items.at(0)["rows"].items.at(1).items.at(1).text, "2");
  EXPECT_EQ(annotations["title"]["title"].text, "Block");
  EXPECT_EQ(annotations["title"]["author"].text, "N. N.");
}

// Numbers of faces are by kind and place: left, front, bottom ... as `epura info` has them.
TEST_F(AnnotationsJson, TellsWhatDimensionsMeasure) {
  const Json annotations = drawn(block, extras);
  const Json& depth = with_text(annotations, "40 +0.2/-0.1");
  EXPECT_EQ(depth["id"].text, "depth");
  EXPECT_EQ(depth["tolerance"].text, "+0.2 -0.1");
  EXPECT_EQ(depth["value"].text, "40");
  EXPECT_EQ(depth["faces"].items.size(), 2U);
  const Json& width = with_text(annotations, "60");
  EXPECT_EQ(width["view"].text, "front");
  EXPECT_EQ(width["type"].text, "linear");
  EXPECT_EQ(width["points"].items.size(), 3U);
  const double from = width["points"].items[0].items[0].number(), to = width["points"].items[1].items[0].number();
  EXPECT_NEAR(std::abs(to - from), 60, 1e-6) << "at 1:1";
}

TEST_F(AnnotationsJson, HasIdsThatStayWhenAPartIsExportedAgain) {
  const std::set<std::string> first = ids(drawn(block)), again = ids(drawn(other_block));
  EXPECT_EQ(first.size(), 5U);
  EXPECT_EQ(first, again);
}

}  // namespace
}  // namespace epura::test::annotations_json_test
