// SPDX-License-Identifier: Apache-2.0
#include "app/define_answers.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

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

/// A command that prints the result of `text` for its options.
template <class Part, class Text>
DefinedCommand answering(CLI::App* app, const scene::Options<Part>& options, const Text& text) {
  return define_command(app, options, [text](const Part& part) {
    std::fputs(text(part).c_str(), stdout);
    return 0;
  });
}

std::string script_for(const WordOptions& options) {
  if (options.shell.empty()) throw Error(ErrorKind::input, "completion", "needs the name of a shell", joined(shells()));
  return completion_script(options.shell);
}

}  // namespace

void define_answers(CLI::App& program, const ProgramTexts& texts, std::vector<DefinedCommand>& commands) {
  // Evaluated when all commands are defined.
  const auto tables = std::make_shared<OptionTables>();
  const auto later = std::make_shared<std::vector<DefinedCommand>>();
  const auto describe = [&program, tables, later] {
    for (const DefinedCommand& command : *later) tables->emplace(command.app, command.define_later(nullptr));
    return describe_command(program, *tables);
  };

  CLI::App* manual =
      program.add_subcommand("manual", "print the manual page; to read it: " + texts.name + " manual | man -l -");
  commands.push_back(answering<ManualOptions>(
      manual, {plugin_path_option<ManualOptions>(&ManualOptions::plugin_path)},
      [describe, &texts](const ManualOptions& options) {
        const auto found = [&] {
          return projection::load_catalogue(projection::plugin_folders(options.plugin_path)).entries;
        };
        return manual_page(describe(), texts,
                           texts.lists_projections ? found() : std::vector<projection::ProjectionEntry>());
      }));

  CLI::App* completion = program.add_subcommand("completion", "print a completion script for a shell");
  if (texts.has_completion_scripts) {
    const scene::OptionInfo shell{.flag = "shell", .help = joined(shells())};
    commands.push_back(answering<WordOptions>(
        completion,
        {scene::option<WordOptions>(shell, &WordOptions::shell, scene::any_text().shown_as("SHELL").such_as(shells()))},
        script_for));
  } else {
    completion->group("")->require_subcommand(1);
  }

  CLI::App* words = completion->add_subcommand("words", "possible last words")->group("");
  const scene::OptionInfo written{.flag = "words", .help = "words typed so far, after --", .repeatable = true};
  commands.push_back(answering<WordOptions>(
      words, {scene::option<WordOptions>(written, &WordOptions::words, scene::field_text().shown_as("TEXT ..."))},
      [describe](const WordOptions& options) { return complete(describe(), options.words); }));

  for (const DefinedCommand& command : commands)
    if (command.define_later)
      later->push_back(command);
    else
      tables->emplace(command.app, command.options);
}

}  // namespace epura
