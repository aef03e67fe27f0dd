// SPDX-License-Identifier: Apache-2.0
#include "app/manual.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/exit_codes.hpp"
#include "app/plugin_texts.hpp"

namespace epura {

namespace {

constexpr auto description =
    "epura reads meshes (OBJ, STL, PLY, OFF), projects them by any projection that a plugin describes, finds hidden "
    "lines exactly, and writes drawings to scale: SVG, PDF, PS, EPS, PNG, DXF and JSON. Scene files (TOML) describe "
    "whole sheets with several views, sections, dimensions and a title block.";

constexpr std::array<std::array<const char*, 2>, 4> examples{{
    {"epura draw bracket.obj --projection cabinet:angle=30 --sheet A4 --scale 1:1 -o bracket.pdf",
     "A cabinet projection in full size."},
    {"epura draw flange.obj --views front,top,isometric --dimensions overall --title Flange -o flange.pdf",
     "A sheet with three views, overall dimensions and a title block."},
    {"epura plugins two-point", "Says what the parameters of a projection are."},
    {"source <(epura completion bash)", "Completes words in a bash that has no package of epura."},
}};

/// `text` as roff prints it: no character has another meaning there.
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
/// What `tag` stands for; both are roff.
std::string item(const std::string& tag, const std::string& roff) { return ".TP\n" + tag + "\n" + roff + "\n"; }

std::string tag_of(const OptionDescription& option) {
  if (option.is_argument()) return italic(option.type);
  std::string tag;
  for (const std::string& name : option.names) tag += (tag.empty() ? "" : ", ") + bold(name);
  if (option.type.empty()) return tag;
  return tag + (option.takes_word ? " " : "") + italic(option.type);
}

std::string item(const OptionDescription& option) {
  return item(tag_of(option), escaped(option.help) + (option.usual.empty() ? "" : " [" + escaped(option.usual) + "]"));
}

bool is_help(const OptionDescription& option) { return option.names.back() == "--help"; }

/// The one of `earlier` commands all whose options `command` has, too; nothing if there is none.
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

/// A command and those inside it; `path` is what stands before its name, `siblings` the list it is in.
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

std::string projection(const ProjectionEntry& entry) {
  std::string text = item(bold(entry.name) + " (" + escaped(entry.family) + ")", escaped(entry.summary));
  if (entry.parameters.empty()) return text;
  text += ".RS\n";
  for (const Parameter& parameter : entry.parameters)
    text += item(bold(parameter.name), escaped(parameter.help) + " (" + escaped(values_text(parameter)) + ")");
  return text + ".RE\n";
}

std::string projections_section(const std::vector<ProjectionEntry>& projections) {
  std::string text = section("PROJECTIONS") + bold("--projection ") + italic("NAME[:key=value...]") +
                     " takes one of these, found when this page was made, with their parameters. More come as plugins, "
                     "and are told by " +
                     bold("epura plugins") + ".\n";
  for (const ProjectionEntry& entry : projections) text += projection(entry);
  return text;
}

std::string surroundings() {
  std::string text = section("EXIT STATUS");
  for (const ExitCode& exit : exit_codes) text += item(bold(std::to_string(exit.code)), escaped(exit.meaning));
  return text + section("ENVIRONMENT") +
         item(bold("EPURA_PLUGIN_PATH"),
              "Folders with projection plugins, with colons between. They are looked at after those of " +
                  bold("--plugin-path") + " and before those of the program.") +
         item(bold("CI"), "Where it is set, " + bold("epura snapshot --accept") + " is refused.");
}

std::string examples_section() {
  std::string text = section("EXAMPLES");
  for (const auto& [command, meaning] : examples) text += item(bold(command), escaped(meaning));
  return text;
}

}  // namespace

std::string manual_page(const CommandDescription& program, const std::vector<ProjectionEntry>& projections) {
  std::string text = ".TH EPURA 1 \"\" \"epura " EPURA_VERSION "\" \"User Commands\"\n" + section("NAME") +
                     "epura \\- 3D meshes to engineering drawings\n" + section("SYNOPSIS") + bold("epura ") +
                     italic("COMMAND") + " [" + italic("OPTION") + "...] [" + italic("ARGUMENT") + "...]\n" +
                     section("DESCRIPTION") + escaped(description) + "\n" + section("COMMANDS");
  for (const CommandDescription& command : program.commands) text += commands("epura", command, program.commands);
  return text + projections_section(projections) + surroundings() + examples_section();
}

}  // namespace epura
