// SPDX-License-Identifier: Apache-2.0
#include "app/command_line_options.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

std::string heading_of(scene::Nature nature) {
  switch (nature) {
    case scene::Nature::unsaid:
      return "Options";
    case scene::Nature::drawing:
      return "Drawing";
    case scene::Nature::file:
      return "Files";
    case scene::Nature::code:
      return "Plugins";
    case scene::Nature::run:
      return "Run";
  }
  return "";
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

// The long name in "-o,--output".
std::string name_of(const scene::OptionInfo& option) { return option.flag.substr(option.flag.rfind(',') + 1); }

bool is_argument(const scene::OptionInfo& option) { return !option.flag.starts_with('-'); }

CLI::Option* add(CLI::App& app, const scene::OptionInfo& option) {
  const scene::ValueForm& form = option.form;
  if (form.placeholder.empty()) return app.add_flag(option.flag)->description(option.meaning());
  if (!form.implied.empty())
    return app.add_flag(option.flag + "{" + form.implied + "}")
        ->description(option.meaning())
        ->type_name("[=" + form.placeholder + "]");
  CLI::Option* added = app.add_option(
                              option.flag, [](const CLI::results_t&) { return true; }, option.meaning())
                           ->type_name(form.placeholder);
  if (!option.repeatable && is_argument(option)) return added;
  if (!option.repeatable) return added->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  // An option takes one value per occurrence: the next word may be a model.
  return added->expected(1, -1)->allow_extra_args(is_argument(option));
}

// In "--dimensions -o x.pdf" a value is missing.
void refuse_option_as_value(const CLI::App& app, const std::string& name, const std::string& text) {
  if (text.size() > 1 && text.starts_with('-') && app.get_option_no_throw(text) != nullptr)
    throw Error(ErrorKind::input, name, "needs a value, but '" + text + "' is an option", "write " + name + "=VALUE");
}

}  // namespace

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

void define(CLI::App& app, const scene::OptionInfo& option) {
  const std::string heading = heading_of(option.nature);
  for (const scene::Switch& one : option.switches) app.add_flag(one.flag)->description(one.help)->group(heading);
  if (option.flag.empty()) return;
  CLI::Option* added = add(app, option)->group(heading)->required(option.required);
  if (!option.usual.empty()) added->default_str(option.usual);
}

std::vector<const scene::OptionInfo*> needed_options(const CommandWords& words,
                                                     const std::vector<const scene::OptionInfo*>& rows) {
  std::set<std::string_view> named;
  for (const std::string_view word : words)
    if (word.starts_with('-')) named.insert(word.substr(0, word.find('=')));
  std::vector<const scene::OptionInfo*> needed;
  std::size_t found = 0;
  for (const scene::OptionInfo* row : rows) {
    std::size_t times = 0;
    for (const std::string_view name : split(row->flag, ',')) times += named.count(name);
    for (const scene::Switch& one : row->switches) times += named.count(one.flag);
    if (times > 0 || row->required || (!row->flag.empty() && is_argument(*row))) needed.push_back(row);
    found += times;
  }
  return found == named.size() ? needed : rows;
}

std::vector<scene::TomlValue> given_values(const CLI::App& app, const scene::OptionInfo& option) {
  const auto given = [&app](const std::string& name) {
    const CLI::Option* found = app.get_option_no_throw(name);
    return found != nullptr && found->count() > 0 ? found : nullptr;
  };
  std::vector<scene::TomlValue> values;
  for (const scene::Switch& one : option.switches)
    if (given(one.flag) != nullptr) values.push_back(scene::value_of_option(one.flag, one.word));
  if (option.flag.empty()) return values;
  const std::string name = name_of(option);
  const CLI::Option* const found = given(name);
  if (found == nullptr) return values;
  const std::vector<std::string> texts = found->results();
  for (std::size_t i = option.repeatable ? 0 : texts.size() - 1; i < texts.size(); ++i) {
    if (!is_argument(option)) refuse_option_as_value(app, name, texts[i]);
    values.push_back(scene::value_of_option(name, texts[i]));
  }
  return values;
}

const CLI::App& chosen_command(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

namespace {

// What other programs call it.
std::string hint_for_option(const std::string& name, const CLI::App& command) {
  constexpr std::array<std::array<std::string_view, 2>, 6> others{{{"--dims", "--dimensions"},
                                                                   {"--out", "--output"},
                                                                   {"--line-width", "--style"},
                                                                   {"--colour", "--style"},
                                                                   {"--color", "--style"},
                                                                   {"--outdir", "--output"}}};
  const std::vector<std::string> names = long_names(command);
  for (const auto& [other, own] : others)
    if (name == other && std::find(names.begin(), names.end(), own) != names.end())
      return "did you mean '" + std::string(own) + "'?";
  return did_you_mean(name, names);
}

// A file in place of a command is to be drawn.
std::string hint_for_command(const std::string& word, const CLI::App& app) {
  if (!std::filesystem::path(word).has_extension()) return did_you_mean(word, names_of_commands(app));
  return "write '" + app.get_name() + " draw " + word + " -o drawing.pdf' to draw a file";
}

}  // namespace

void refuse_wrong_use(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &chosen_command(app);
  for (const std::string& extra : command->remaining(true)) {
    if (extra.starts_with("-"))
      throw Error(ErrorKind::input, "", "unknown option '" + extra + "'", hint_for_option(extra, *command));
    if (command == &app)
      throw Error(ErrorKind::input, "", "unknown command '" + extra + "'", hint_for_command(extra, app));
  }
  throw Error(ErrorKind::input, "command line", error.what(),
              "see '" + app.get_name() + " " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

}  // namespace epura
