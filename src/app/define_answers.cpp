// SPDX-License-Identifier: Apache-2.0
#include "app/define_answers.hpp"

#include <filesystem>
#include <memory>
#include <string>

#include "app/command_options.hpp"
#include "app/command_tree.hpp"
#include "app/completion.hpp"
#include "app/manual.hpp"
#include "base/error.hpp"
#include "projection/catalogue.hpp"

namespace epura {

namespace {

DefinedCommand define_manual(CLI::App& program) {
  CLI::App* app = program.add_subcommand("manual", "print the manual page; to read it: epura manual | man -l -");
  const auto plugin_path = std::make_shared<std::vector<std::filesystem::path>>();
  add_list(*app, "--plugin-path", *plugin_path, "more folders with projection plugins")->type_name("DIR");
  return {app, [&program, plugin_path] {
            return Answer{manual_page(describe_command(program), load_catalogue(plugin_folders(*plugin_path)).entries)};
          }};
}

DefinedCommand define_completion(CLI::App& program) {
  CLI::App* app = program.add_subcommand("completion", "print the script by which a shell completes words");
  const auto shell = std::make_shared<std::string>();
  app->add_option("shell", *shell, joined(shells()))->type_name("SHELL");
  return {app, [shell] {
            if (shell->empty()) throw Error(Trouble::input, "completion", "names no shell", joined(shells()));
            return Answer{completion_script(*shell)};
          }};
}

/// What the scripts ask.
DefinedCommand define_words(CLI::App& program) {
  CLI::App* app = program.get_subcommand("completion")->add_subcommand("words", "words that may stand last")->group("");
  const auto words = std::make_shared<std::vector<std::string>>();
  app->add_option("words", *words, "what was written so far, behind --");
  return {app, [&program, words] { return Answer{complete(describe_command(program), *words)}; }};
}

}  // namespace

std::vector<DefinedCommand> define_answers(CLI::App& program) {
  return {define_manual(program), define_completion(program), define_words(program)};
}

}  // namespace epura
