// SPDX-License-Identifier: Apache-2.0
// Drawings stored as text: each folder of tests/golden is a case of `epura snapshot` (docs/reports.md), drawn from the
// root of the repository, whose expected files must match byte by byte.
#pragma once

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.hpp"

namespace epura::test {

inline std::filesystem::path golden_folder(const std::string& name) {
  return std::filesystem::path(EPURA_TEST_GOLDEN) / name;
}

/// Names of all cases, sorted.
inline std::vector<std::string> golden_cases() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(EPURA_TEST_GOLDEN))
    if (std::filesystem::exists(entry.path() / "expected.json")) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// "draw" and the arguments of a case.
inline std::vector<std::string> golden_arguments(const std::string& name) {
  std::vector<std::string> words{"draw", "--allow-outside", "tests/golden/" + name + "/scene.toml"};
  const std::filesystem::path options = golden_folder(name) / "options";
  std::istringstream text(std::filesystem::exists(options) ? read_file(options) : std::string());
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// The name of a case in the form that GoogleTest accepts.
inline std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace epura::test
