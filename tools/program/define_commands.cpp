// SPDX-License-Identifier: Apache-2.0
#include "program/define_commands.hpp"

#include "app/command_options.hpp"
#include "app/commands.hpp"
#include "app/define_answers.hpp"
#include "app/draw_options.hpp"
#include "base/broken.hpp"
#include "batch/batch.hpp"
#include "serve/serve.hpp"
#include "snapshot/check.hpp"
#include "snapshot/compare.hpp"
#include "snapshot/snapshot.hpp"

namespace epura {

const ProgramTexts& program_texts() {
  static const ProgramTexts texts{
      .name = "epura",
      .summary = "turn 3D meshes into engineering drawings with hidden lines removed",
      .description =
          "epura reads meshes (OBJ, STL, PLY, OFF) and, through importers, other models, projects them with any "
          "projection that a plugin provides, finds "
          "hidden lines exactly, and writes drawings to scale: SVG, PDF, PS, EPS, PNG, DXF, HTML "
          "and JSON. Scene files (TOML) describe whole sheets with several views, sections, dimensions and "
          "a title block.",
      .exit_codes =
          {{0, "success"},
           {found_wrong_exit_code,
            "differences found (compare, snapshot, check) or errors found (lint, define, --verify, plugins check, "
            "views "
            "beyond their sheet), requirements that are not drawn (draw) or not read whole (requirements), or jobs "
            "failed (batch)"},
           {2, "wrong input"},
           {3, "plugin error"},
           {4, "cannot write"},
           {partial_exit_code, "partial drawing, or no drawing in time (--time-limit)"},
           {broken_exit_code, "epura itself is wrong"},
           {130, "cancelled"}},
      .environment = {{"EPURA_PLUGIN_PATH",
                       "Folders with plugins, separated by colons. They are searched after those of "
                       "--plugin-path and before those of the program."},
                      {"CI", "If set, epura snapshot --accept is refused."}},
      .examples = {{"epura draw bracket.obj --projection cabinet:angle=30 --sheet A4 --scale 1:1 -o bracket.pdf",
                    "A cabinet projection at full size."},
                   {"epura draw flange.obj --views front,top,isometric --dimensions overall --title Flange -o "
                    "flange.pdf",
                    "A sheet with three views, overall dimensions and a title block."},
                   {"epura plugins two-point", "Show the parameters of a projection."},
                   {"source <(epura completion bash)", "Enable completion in bash without the epura package."}},
      .lists_projections = true,
      .has_completion_scripts = true};
  return texts;
}

std::vector<DefinedCommand> define_commands(CLI::App& program) {
  const auto add = [&](const char* name, const char* help) { return program.add_subcommand(name, help); };
  std::vector<DefinedCommand> commands{
      define_command(add("draw", "draw models as SVG, PDF, PNG, DXF, JSON"), draw_options, draw),
      define_command(add("explain", "draw, and show which stages ran or were skipped, and why"), explain_options,
                     [](DrawOptions options) {
                       options.run.explain = true;
                       return draw(options);
                     }),
      define_command(add("lint", "draw, and say which sizes have no dimension or several, and which dimensions cross"),
                     lint_options, lint),
      define_command(add("define", "draw, and prove that the numbers on the sheets define the part"), define_options,
                     [](const DrawOptions& options) { return define(options); }),
      define_command(add("describe", "draw, and say in at most twelve sentences what a sheet shows"), draw_options,
                     describe_drawing),
      define_command(add("batch", "draw many models, each in a process of its own, and only those that changed"),
                     batch_options, batch),
      define_command(add("info", "describe a model: size, bodies, faces, holes, repairs"), info_options, info),
      define_command(
          add("requirements",
              "list what a model requires: dimensions, tolerances and datums of STEP AP242, with their faces"),
          requirements_options, requirements),
      define_command(add("compare", "report the visible differences between two drawings, models or scenes"),
                     compare_options, compare_files),
      define_command(add("check", "draw a drawing again that carries its proof, and say whether it is the same"),
                     check_options, check_drawing),
      define_command(add("snapshot", "draw cases and compare them with expected drawings"), snapshot_options, snapshot),
      define_command(
          add("serve", "show a page in which projections are tried: sliders for their parameters, exact drawings"),
          serve_options, serve)};
  CLI::App* list = add("plugins", "list projections, show one, or check a plugin");
  commands.push_back(define_command(list, plugins_options, plugins));
  commands.push_back(
      define_command(add("picture", "draw a projection seen from outside: picture plane, projectors, volumes"),
                     picture_options, picture));
  commands.push_back(define_command(add("new-projection", "create a projection plugin: C++ source and CMake file"),
                                    new_projection_options, new_projection));
  commands.push_back(
      define_command(add("new-scene", "create a scene file for a model, with its views, holes and bodies"),
                     new_scene_options, new_scene));
  commands.push_back(
      define_command(list->add_subcommand("check", "test a projection plugin"), check_plugin_options, check_plugin));
  CLI::App* importers_list = add("importers", "list formats that plugins read, show one, or test an importer");
  commands.push_back(define_command(importers_list, importers_options, importers));
  commands.push_back(define_command(importers_list->add_subcommand("check", "test an importer plugin"),
                                    check_importer_options, check_importer));
  add("study", "measure accuracy and stability of epura (separate package: epura-study)");
  define_answers(program, program_texts(), commands);
  return commands;
}

}  // namespace epura
