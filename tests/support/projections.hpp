// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/folder.hpp"

namespace epura::test {

/// The names of the projections of the program, in the order of their bytes. Their files are not loaded: a program that
/// tries something with each of them lists the names whenever it starts.
inline std::vector<std::string> built_in_projections() {
  std::vector<std::string> names = names_in(EPURA_TEST_PLUGINS);
  for (std::string& name : names) name = std::filesystem::path(name).stem();
  return names;
}

}  // namespace epura::test
