// SPDX-License-Identifier: Apache-2.0
#include "app/define_answers.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "app/command_line_options.hpp"
#include "app/command_tree.hpp"
#include "app/completion.hpp"
#include "app/draw_options.hpp"
#include "app/manual.hpp"
#include "base/error.hpp"
#include "projection/catalogue.hpp"

namespace epura {

namespace {

struct ManualOptions {
  std::vector<std::filesystem::path> plugin_path;
};

struct WordOptions {
  std::string shell;
  std::vector<std::string> words;
};

/// A command whose answer is computed from its options.
template <class Part, class Answering>
DefinedCommand answering(CLI::App* app, const Options<Part>& options, const Answering& text) {
  for (const OptionInfo& option : options) define(*app, option);
  const auto command = [app, options, text] {
    Part part;
    read_options(*app, options, part);
    return Answer{text(part)};
  };
  return {app, command, {options.begin(), options.end()}};
}

std::string script_for(const WordOptions& options) {
  if (options.shell.empty()) throw Error(ErrorKind::input, "completion", "names no shell", joined(shells()));
  return completion_script(options.shell);
}

}  // namespace

void define_answers(CLI::App& program, std::vector<DefinedCommand>& commands) {
  // Asked when all commands are known.
  const auto tables = std::make_shared<OptionTables>();
  const auto describe = [&program, tables] { return describe_command(program, *tables); };

  CLI::App* manual = program.add_subcommand("manual", "print the manual page; to read it: epura manual | man -l -");
  commands.push_back(answering<ManualOptions>(
      manual, {plugin_path_option<ManualOptions>(&ManualOptions::plugin_path)},
      [describe](const ManualOptions& options) {
        return manual_page(describe(), load_catalogue(plugin_folders(options.plugin_path)).entries);
      }));

  CLI::App* completion = program.add_subcommand("completion", "print the script by which a shell completes words");
  const OptionInfo shell{.flag = "shell", .help = joined(shells())};
  commands.push_back(answering<WordOptions>(
      completion, {option<WordOptions>(shell, &WordOptions::shell, any_text().shown_as("SHELL").such_as(shells()))},
      script_for));

  CLI::App* words = completion->add_subcommand("words", "words that may stand last")->group("");
  const OptionInfo written{.flag = "words", .help = "what was written so far, behind --", .repeatable = true};
  commands.push_back(answering<WordOptions>(
      words, {option<WordOptions>(written, &WordOptions::words, field_text().shown_as("TEXT ..."))},
      [describe](const WordOptions& options) { return complete(describe(), options.words); }));

  for (const DefinedCommand& command : commands) tables->emplace(command.app, command.options);
}

}  // namespace epura
