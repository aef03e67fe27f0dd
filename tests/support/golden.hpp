// The drawings that are kept as text: each folder of tests/golden has `arguments`, what follows `epura draw` with paths
// from the root of the repository, and `expected.json`, what must come of it, to the byte; cases of whole sheets have
// `expected.svg`, too.
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
    if (std::filesystem::exists(entry.path() / "arguments")) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// "draw" and the arguments of a case.
inline std::vector<std::string> golden_arguments(const std::string& name) {
  std::istringstream text(read_file(golden_folder(name) / "arguments"));
  std::vector<std::string> words{"draw"};
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

/// The name of a case as GoogleTest takes it.
inline std::string test_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace epura::test
