// SPDX-License-Identifier: Apache-2.0
// `epura describe`: what a sheet shows, in words.
#include <cstdio>
#include <string>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/draw_files.hpp"

namespace epura {

namespace {

// A sentence in each line, and an empty line between sheets.
std::string text_of(const std::vector<pipeline::FinishedSheet>& sheets) {
  std::string text;
  for (const pipeline::FinishedSheet& sheet : sheets) {
    if (!text.empty()) text += '\n';
    if (!sheet.sheet.summaries.empty())
      for (const std::string& sentence : sheet.sheet.summaries.front().sentences) text += sentence + "\n";
  }
  return text;
}

}  // namespace

int describe_drawing(DrawOptions options) {
  options.run.describes = true;
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const DrawnFiles drawn = draw_files(options, messages_to(console), Progress(board, options.run.time_limit));
  console.print("");
  std::fputs((drawn.answers + text_of(drawn.sheets)).c_str(), stdout);
  tell_the_end(messages_to(console), options, drawn);
  return exit_code_of(drawn);
}

}  // namespace epura
