// SPDX-License-Identifier: Apache-2.0
// Parses options of `epura draw` in the process of the test.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/command_line_options.hpp"
#include "app/draw_options.hpp"

namespace epura::test {

/// The options given by the words after "draw".
inline DrawOptions draw_options_of(std::vector<std::string> words) {
  CLI::App app;
  const scene::Options<DrawOptions> table = draw_options();
  for (const scene::OptionInfo& option : table) define(app, option);
  std::reverse(words.begin(), words.end());  // CLI11 takes them in reverse
  app.parse(words);
  DrawOptions options;
  read_options(app, table, options);
  return options;
}

}  // namespace epura::test
