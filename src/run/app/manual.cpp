// SPDX-License-Identifier: Apache-2.0
#include "app/manual.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "app/plugin_texts.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

/// Escapes `text` so that roff interprets no character of it.
std::string escaped(std::string_view text) {
  std::string roff = !text.empty() && (text[0] == '.' || text[0] == '\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      roff += "\\(rs";
    else if (c == '-')
      roff += "\\-";
    else if (c == '\'')
      roff += "\\(aq";
    else if (c == '`')
      roff += "\\(ga";
    else if (c == '^')
      roff += "\\(ha";
    else if (c == '~')
      roff += "\\(ti";
    else if (c == '"')
      roff += "\\(dq";
    else
      roff += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return roff;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string section(const std::string& title) { return ".SH " + title + "\n"; }
std::string paragraph(const std::string& roff) { return ".PP\n" + roff + "\n"; }
/// A tagged paragraph; `tag` and its meaning are roff.
std::string item(const std::string& tag, const std::string& roff) { return ".TP\n" + tag + "\n" + roff + "\n"; }

std::string tag_of(const OptionDescription& option) {
  if (option.is_argument()) return italic(option.type);
  std::string tag;
  for (const std::string& name : option.names) append_to_list(tag, bold(name));
  if (option.type.empty()) return tag;
  return tag + (option.takes_word ? " " : "") + italic(option.type);
}

std::string item(const OptionDescription& option) {
  return item(tag_of(option), escaped(option.help) + (option.usual.empty() ? "" : " [" + escaped(option.usual) + "]"));
}

bool is_help(const OptionDescription& option) { return option.names.back() == "--help"; }

/// Returns the earlier command all of whose options `command` has as well; null if there is none.
const CommandDescription* extended(const CommandDescription& command, const std::vector<CommandDescription>& earlier) {
  constexpr std::size_t worth_it = 5;
  const auto has = [&](const OptionDescription& option) {
    return std::find(command.options.begin(), command.options.end(), option) != command.options.end();
  };
  for (const CommandDescription& other : earlier) {
    if (&other == &command) break;
    if (other.options.size() > worth_it && std::all_of(other.options.begin(), other.options.end(), has)) return &other;
  }
  return nullptr;
}

/// A command and its subcommands; `path` precedes its name, `siblings` is the list that contains it.
std::string commands(const std::string& path, const CommandDescription& command,
                     const std::vector<CommandDescription>& siblings) {
  const std::string name = path + " " + command.name;
  std::string text;
  if (command.options.size() > 1 || command.commands.empty()) {
    text = ".SS " + bold(name + " ") + italic(synopsis(command)) + "\n" + escaped(command.help) + ".\n";
    const CommandDescription* base = extended(command, siblings);
    if (base != nullptr) text += paragraph("Takes all options of " + bold(path + " " + base->name) + ", and:");
    for (const OptionDescription& option : command.options) {
      const bool told =
          base != nullptr && std::find(base->options.begin(), base->options.end(), option) != base->options.end();
      if (!told && !is_help(option)) text += item(option);
    }
  }
  for (const CommandDescription& inner : command.commands) text += commands(name, inner, command.commands);
  return text;
}

std::string projection(const projection::ProjectionEntry& entry) {
  std::string text = item(bold(entry.name) + " (" + escaped(entry.family) + ")", escaped(entry.summary));
  if (entry.parameters.empty()) return text;
  text += ".RS\n";
  for (const projection::Parameter& parameter : entry.parameters)
    text += item(bold(parameter.name), escaped(parameter.help) + " (" + escaped(values_text(parameter)) + ")");
  return text + ".RE\n";
}

std::string projections_section(const std::vector<projection::ProjectionEntry>& projections) {
  std::string text =
      section("PROJECTIONS") + bold("--projection ") + italic("NAME[:key=value...]") +
      " takes one of the following, found when this page was generated. Plugins can add more; all are listed by " +
      bold("epura plugins") + ".\n";
  for (const projection::ProjectionEntry& entry : projections) text += projection(entry);
  return text;
}

/// A section of words and their meanings.
std::string table(const std::string& title, const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text = section(title);
  for (const auto& [word, meaning] : rows) text += item(bold(word), escaped(meaning));
  return text;
}

/// "EPURA-STUDY", as in titles of manual pages.
std::string title_of(std::string name) {
  for (char& c : name) c = c == ' ' ? '-' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

std::string manual_page(const CommandDescription& program, const ProgramTexts& texts,
                        const std::vector<projection::ProjectionEntry>& projections) {
  const std::string title = title_of(texts.name);
  std::string text = ".TH " + title + " 1 \"\" \"epura " EPURA_VERSION "\" \"User Commands\"\n" + section("NAME") +
                     escaped(to_lower(title)) + " \\- " + escaped(texts.summary) + "\n" + section("SYNOPSIS") +
                     bold(texts.name + " ") + italic("COMMAND") + " [" + italic("OPTION") + "...] [" +
                     italic("ARGUMENT") + "...]\n" + section("DESCRIPTION") + escaped(texts.description) + "\n" +
                     section("COMMANDS");
  for (const CommandDescription& command : program.commands) text += commands(texts.name, command, program.commands);
  if (!projections.empty()) text += projections_section(projections);
  std::vector<std::pair<std::string, std::string>> codes;
  for (const ExitCode& exit : texts.exit_codes) codes.emplace_back(std::to_string(exit.code), exit.meaning);
  return text + table("EXIT STATUS", codes) + table("ENVIRONMENT", texts.environment) +
         table("EXAMPLES", texts.examples);
}

}  // namespace epura
