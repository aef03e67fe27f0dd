// SPDX-License-Identifier: Apache-2.0
#include "app/command_tree.hpp"

namespace epura {

namespace {

OptionDescription describe_option(const CLI::Option& option) {
  OptionDescription described;
  for (const std::string& name : option.get_snames()) described.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) described.names.push_back("--" + name);
  if (described.names.empty()) described.names.push_back(option.get_name(true));
  described.type = option.get_type_name();
  described.help = option.get_description();
  described.usual = option.get_default_str();
  described.takes_word = option.get_expected_max() > 0 && !described.type.starts_with('[');
  described.is_required = option.get_required();
  return described;
}

void add_form(OptionDescription& described, const std::vector<scene::OptionInfo>& table) {
  for (const scene::OptionInfo& info : table)
    if (info.flag.substr(info.flag.rfind(',') + 1) == described.names.back()) described.form = info.form;
}

}  // namespace

CommandDescription describe_command(const CLI::App& command, const OptionTables& tables) {
  CommandDescription described{command.get_name(), command.get_description(), {}, {}};
  const auto table = tables.find(&command);
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    described.options.push_back(describe_option(*option));
    if (table != tables.end()) add_form(described.options.back(), table->second);
  }
  for (const CLI::App* inner : command.get_subcommands({}))
    if (!inner->get_group().empty()) described.commands.push_back(describe_command(*inner, tables));
  return described;
}

std::string synopsis(const CommandDescription& command) {
  std::string text = "[OPTION...]";
  for (const OptionDescription& option : command.options)
    if (option.is_argument()) text += option.is_required ? " " + option.type : " [" + option.type + "]";
  return text;
}

}  // namespace epura
