// SPDX-License-Identifier: Apache-2.0
// Scene files drawn by the program.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "../output/json_reader.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test {

class DrawnScenes : public testing::Test {
 protected:
  Folder folder;

  /// Draws the text of a scene file, whose models may lie anywhere, into x.json and x.svg.
  Outcome draw(const std::string& scene, std::vector<std::string> options = {}) {
    options.insert(options.begin(),
                   {"draw", "--allow-outside", folder.file("scene.toml", scene), "-o", "x.json", "-o", "x.svg"});
    return epura(options, folder / "");
  }
  Json drawing() const { return JsonReader(read_file(folder / "x.json")).read(); }
  /// What is said of a scene that is refused.
  std::string error(const std::string& scene) {
    const Outcome run = draw(scene);
    EXPECT_EQ(run.code, 2) << scene;
    return run.err;
  }
};

}  // namespace epura::test
