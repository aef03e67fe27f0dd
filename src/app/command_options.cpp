// SPDX-License-Identifier: Apache-2.0
#include "app/command_options.hpp"

#include "base/error.hpp"

namespace epura {

namespace {

std::string heading_of(Nature nature) {
  switch (nature) {
    case Nature::drawing:
      return "Drawing";
    case Nature::file:
      return "Files";
    case Nature::code:
      return "Plugins";
    case Nature::run:
      return "Run";
  }
  return "";
}

std::string text_of(const Range& range) {
  if (std::isinf(range.most)) return format_number(range.least) + " or more";
  return format_number(range.least) + " to " + format_number(range.most);
}

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

}  // namespace

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

double number_of(const std::string& option, const std::string& text, const Range& range, bool whole) {
  const auto number = parse_number(text);
  if (!number || !std::isfinite(*number) || (whole && *number != std::floor(*number)))
    throw Error(Trouble::input, option, "'" + text + "' is no " + (whole ? "whole number" : "number"));
  if (*number < range.least || *number > range.most)
    throw Error(Trouble::input, option, "is " + text + ", allowed is " + text_of(range));
  return *number;
}

void add_word(CLI::App& app, const std::string& option, std::string& value, const std::string& type,
              const std::string& usual, const std::string& help) {
  app.add_option(option, value, help)->type_name(type)->default_str(usual);
}

void add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& word,
                const std::string& help) {
  app.add_flag_callback(
      option, [&value, word] { value = word; }, help);
}

void add_threads(CLI::App& app, int& threads) {
  add_number(app, "--threads", threads, {0, 1024}, "number of threads, 0 for all cores")->type_name("N");
}

void add_progress(CLI::App& app, std::string& progress) {
  app.add_option("--progress", progress, "show how far it is: auto (on a terminal), always or never")
      ->capture_default_str()
      ->type_name("WHEN");
}

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

void refuse_wrong_use(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &chosen_command(app);
  for (const std::string& extra : command->remaining(true)) {
    if (extra.starts_with("-"))
      throw Error(Trouble::input, "", "there is no option '" + extra + "'", did_you_mean(extra, long_names(*command)));
    if (command == &app)
      throw Error(Trouble::input, "", "there is no command '" + extra + "'",
                  did_you_mean(extra, names_of_commands(app)));
  }
  throw Error(Trouble::input, "command line", error.what(),
              "see 'epura " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

void define_next(CLI::App& app, Nature nature) { app.option_defaults()->group(heading_of(nature)); }

bool is_of(const CLI::Option& option, Nature nature) { return option.get_group() == heading_of(nature); }

}  // namespace epura
