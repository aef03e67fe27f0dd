// SPDX-License-Identifier: Apache-2.0
#include "study/commands.hpp"

#include "app/commands.hpp"
#include "app/define_answers.hpp"
#include "app/draw_options.hpp"

namespace epura::study {

namespace {

scene::ValueKind<Method> any_method() {
  const scene::ValueForm form{
      "text", "METHOD", {"exact", "exact:bits=", "float", "sampled:density=", "item-buffer:dpi=", "none"}};
  return {form, [](const scene::TomlValue& value) { return parse_method(scene::read_text(value), value.where); }};
}

scene::Options<StabilityOptions> stability_options() {
  using Study = StabilityOptions;
  return {
      scene::option<Study>({.flag = "-o,--output",
                            .help = "file to write, by extension: html json csv svg pdf; - for standard output",
                            .repeatable = true},
                           &Study::outputs, file_name("FILE")),
      scene::option<Study>({.flag = "--format", .help = "format of '-'"}, &Study::format,
                           scene::any_text().shown_as("NAME").such_as({"html", "json", "csv", "svg", "pdf"})),
      scene::option<Study>(
          {.flag = "--cases", .help = "only these, with commas: P1,V4,M23; shows every step", .usual = "all"},
          &Study::cases, scene::any_text().shown_as("IDS")),
      scene::option<Study>({.flag = "--size", .help = "factor of the numbers of parts of large scenes", .usual = "1"},
                           &Study::size, scene::number_between(0.01, 100, "").shown_as("F")),
      threads_option<Study>(&Study::threads),
      scene::option<Study>({.flag = "--timings", .help = "say how long each case took"}, &Study::timings,
                           scene::truth()),
      progress_option(&Study::progress),
  };
}

scene::Options<AccuracyOptions> accuracy_options() {
  using Study = AccuracyOptions;
  return {
      scene::option<Study>({.flag = "scenes",
                            .help = "scenes: model files or scene files, each for itself",
                            .required = true,
                            .repeatable = true},
                           &Study::scenes, file_name("SCENE...")),
      scene::option<Study>({.flag = "-o,--output",
                            .help = "file to write, by extension: html csv json pdf, or svg png for each diagram",
                            .required = true,
                            .repeatable = true},
                           &Study::outputs, file_name("FILE")),
      projections_option("NAME[:key=value...] of models; each time one more view", &Study::projections),
      plugin_path_option<Study>(&Study::plugin_path),
      scene::option<Study>({.flag = "--visibility",
                            .help = "method to measure, by default a choice of all; may be repeated",
                            .repeatable = true},
                           &Study::methods, any_method()),
      scene::option<Study>({.flag = "--runs", .help = "timed runs of each method, in turns", .usual = "5"},
                           &Study::runs, scene::whole_number(1, 1000)),
      scene::option<Study>(
          {.flag = "--truth",
           .help = "pairs of edge and triangle looked at exactly; beyond, a random part of the edges is judged",
           .usual = "2e+05"},
          &Study::pairs, scene::number_between(1, 1e9, "").shown_as("N")),
      {{.flag = "--no-maps", .help = "leave the projection maps out"},
       [](Study& study, const scene::TomlValue&) { study.maps = false; }},
      threads_option<Study>(&Study::threads),
      progress_option(&Study::progress),
  };
}

}  // namespace

const ProgramTexts& study_texts() {
  static const ProgramTexts texts{
      .name = "epura study",
      .summary = "measure how right and how fast epura draws",
      .description =
          "Draws scenes by several methods and arithmetics, and compares what comes out with what is known in "
          "closed form or found in rational numbers.",
      .exit_codes = {{0, "done"},
                     {found_wrong_exit_code, "a case is drawn wrongly (stability)"},
                     {2, "wrong input"},
                     {3, "plugin"},
                     {4, "could not write"},
                     {130, "cancelled"}},
      .environment = {{"EPURA_PLUGIN_PATH", "Folders with projection plugins, as of epura(1)."}},
      .examples = {{"epura study accuracy bracket.obj -o report.html",
                    "How wrong each method draws the bracket, and how long it takes."},
                   {"epura study stability", "A table of stiff and extreme cases, and where each arithmetic breaks."}}};
  return texts;
}

std::vector<DefinedCommand> define_study_commands(CLI::App& program) {
  const auto add = [&](const char* name, const char* help) { return program.add_subcommand(name, help); };
  std::vector<DefinedCommand> commands{
      define_command(add("accuracy", "error against run time of all methods that find hidden lines"),
                     accuracy_options(), study_accuracy),
      define_command(add("stability", "draw stiff and extreme cases, and say where arithmetics break"),
                     stability_options(), study_stability)};
  define_answers(program, study_texts(), commands);
  return commands;
}

}  // namespace epura::study
