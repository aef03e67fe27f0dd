// SPDX-License-Identifier: Apache-2.0
// A small file that takes long to draw: large triangles that all cross each other.
#pragma once

#include <random>
#include <string>

namespace epura::test {

/// OBJ text of `count` random triangles in the cube of side 100.
inline std::string tangle(int count) {
  std::mt19937 random(1);
  std::string text;
  for (int i = 0; i < 3 * count; ++i) {
    text += "v";
    for (int k = 0; k < 3; ++k) text += " " + std::to_string(random() % 100'000) + "e-3";
    text += "\n";
  }
  for (int i = 0; i < 3 * count; i += 3)
    text += "f " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) + "\n";
  return text;
}

}  // namespace epura::test
