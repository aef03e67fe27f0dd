// SPDX-License-Identifier: Apache-2.0
#include "app/define_commands.hpp"

#include "app/command_options.hpp"
#include "app/commands.hpp"
#include "app/define_answers.hpp"
#include "app/draw_options.hpp"

namespace epura {

const ProgramTexts& program_texts() {
  static const ProgramTexts texts{
      .name = "epura",
      .summary = "3D meshes to engineering drawings with hidden lines removed",
      .description =
          "epura reads meshes (OBJ, STL, PLY, OFF) and, by importers, other models, projects them by any projection "
          "that a plugin "
          "describes, finds hidden lines exactly, and writes drawings to scale: SVG, PDF, PS, EPS, PNG, DXF "
          "and JSON. Scene files (TOML) describe whole sheets with several views, sections, dimensions and "
          "a title block.",
      .exit_codes = {{0, "done"},
                     {found_wrong_exit_code,
                      "differences (compare, snapshot) or found wrong (--verify, plugins check)"},
                     {2, "wrong input"},
                     {3, "plugin"},
                     {4, "could not write"},
                     {partial_exit_code, "partial drawing, or no time for any (--time-limit)"},
                     {130, "cancelled"}},
      .environment = {{"EPURA_PLUGIN_PATH",
                       "Folders with plugins, with colons between. They are looked at after those of "
                       "--plugin-path and before those of the program."},
                      {"CI", "Where it is set, epura snapshot --accept is refused."}},
      .examples = {{"epura draw bracket.obj --projection cabinet:angle=30 --sheet A4 --scale 1:1 -o bracket.pdf",
                    "A cabinet projection in full size."},
                   {"epura draw flange.obj --views front,top,isometric --dimensions overall --title Flange -o "
                    "flange.pdf",
                    "A sheet with three views, overall dimensions and a title block."},
                   {"epura plugins two-point", "Says what the parameters of a projection are."},
                   {"source <(epura completion bash)", "Completes words in a bash that has no package of epura."}},
      .lists_projections = true,
      .has_completion_scripts = true};
  return texts;
}

std::vector<DefinedCommand> define_commands(CLI::App& program) {
  const auto add = [&](const char* name, const char* help) { return program.add_subcommand(name, help); };
  std::vector<DefinedCommand> commands{
      define_command(add("draw", "draw models"), draw_options(), draw),
      define_command(add("explain", "draw, and tell which stages ran, which were left out, and why"), explain_options(),
                     [](DrawOptions options) {
                       options.run.explain = true;
                       return draw(options);
                     }),
      define_command(add("info", "tell what a model is: size, bodies, faces, holes, repairs"), info_options(), info),
      define_command(add("compare", "tell what a person sees that differs in two drawings"), compare_options(),
                     compare_files),
      define_command(add("snapshot", "draw cases and compare them with what is expected"), snapshot_options(),
                     snapshot)};
  CLI::App* list = add("plugins", "list projections, show one, or check a library of them");
  commands.push_back(define_command(list, plugins_options(), plugins));
  commands.push_back(define_command(add("new-projection", "begin a projection plugin: C++ source and CMake file"),
                                    new_projection_options(), new_projection));
  commands.push_back(define_command(list->add_subcommand("check", "test a library of projections"),
                                    check_plugin_options(), check_plugin));
  CLI::App* importers_list =
      add("importers", "list formats that plugins read, show one, or check a library of importers");
  commands.push_back(define_command(importers_list, importers_options(), importers));
  commands.push_back(define_command(importers_list->add_subcommand("check", "test a library of importers"),
                                    check_importer_options(), check_importer));
  add("study", "measure the program itself (a program and a package of its own: epura-study)");
  define_answers(program, program_texts(), commands);
  return commands;
}

}  // namespace epura
