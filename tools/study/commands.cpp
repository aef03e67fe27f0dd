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

scene::ValueKind<Rival> any_rival() {
  return {{"text", "NAME=COMMAND", {}},
          [](const scene::TomlValue& value) { return parse_rival(scene::read_text(value)); }};
}

// The formats are those of study_report.hpp.
template <class Study>
scene::Option<Study> report_option() {
  return scene::option<Study>(
      {.flag = "-o,--output",
       .help = "output file; its extension selects the format: html csv json pdf, or svg png for each diagram",
       .required = true,
       .repeatable = true},
      &Study::outputs, file_name("FILE"));
}

scene::Options<StabilityOptions> stability_options() {
  using Study = StabilityOptions;
  return {
      scene::option<Study>(
          {.flag = "-o,--output",
           .help = "output file; its extension selects the format: html json csv svg pdf; - for standard output",
           .repeatable = true},
          &Study::outputs, file_name("FILE")),
      scene::option<Study>({.flag = "--format", .help = "format of '-'"}, &Study::format,
                           scene::any_text().shown_as("NAME").such_as({"html", "json", "csv", "svg", "pdf"})),
      scene::option<Study>({.flag = "--cases",
                            .help = "only these cases, separated by commas: P1,V4,M23; shows every step",
                            .usual = "all"},
                           &Study::cases, scene::any_text().shown_as("IDS")),
      scene::option<Study>({.flag = "--size", .help = "factor for the number of parts in large scenes", .usual = "1"},
                           &Study::size, scene::number_between(0.01, 100, "").shown_as("F")),
      scene::option<Study>(
          {.flag = "--beyond",
           .help = "continue each case until epura is wrong, refuses, or takes more than S seconds for a "
                   "step; print where it ends, and why"},
          &Study::beyond, scene::number_between(0.01, 3600, "s").shown_as("S")),
      threads_option<Study>(&Study::threads),
      scene::option<Study>({.flag = "--timings", .help = "print the time of each case"}, &Study::timings,
                           scene::truth()),
      progress_option(&Study::progress),
  };
}

scene::Options<AccuracyOptions> accuracy_options() {
  using Study = AccuracyOptions;
  return {
      scene::option<Study>({.flag = "scenes",
                            .help = "model files or scene files, each a scene of its own",
                            .required = true,
                            .repeatable = true},
                           &Study::scenes, file_name("SCENE...")),
      report_option<Study>(),
      projections_option("projection of models, NAME[:key=value...]; repeat for more views", &Study::projections),
      plugin_path_option<Study>(&Study::plugin_path),
      scene::option<Study>({.flag = "--visibility",
                            .help = "method to measure; may be repeated; by default a selection of all",
                            .repeatable = true},
                           &Study::methods, any_method()),
      scene::option<Study>({.flag = "--runs", .help = "timed runs of each method, alternating", .usual = "5"},
                           &Study::runs, scene::whole_number(1, 1000)),
      scene::option<Study>(
          {.flag = "--truth",
           .help = "number of edge-triangle pairs to test exactly; beyond that, a random sample of edges is judged",
           .usual = "2e+05"},
          &Study::pairs, scene::number_between(1, 1e9, "").shown_as("N")),
      {{.flag = "--no-maps", .help = "omit the projection maps"},
       [](Study& study, const scene::TomlValue&) { study.maps = false; }},
      threads_option<Study>(&Study::threads),
      progress_option(&Study::progress),
  };
}

scene::Options<PaperOptions> paper_options() {
  using Study = PaperOptions;
  return {
      report_option<Study>(),
      scene::option<Study>({.flag = "--body", .help = "only this body; may be repeated", .repeatable = true},
                           &Study::bodies, scene::any_text().shown_as("NAME")),
      scene::option<Study>({.flag = "--finest",
                            .help = "facets around bodies, at most; the coarsest have 12, and each next twice as many",
                            .usual = "192"},
                           &Study::finest, scene::whole_number(12, 3072)),
      scene::option<Study>(
          {.flag = "--rival",
           .help = "another program that draws isometric views, started as COMMAND MESH.off LINES.txt; "
                   "may be repeated",
           .repeatable = true},
          &Study::rivals, any_rival()),
      plugin_path_option<Study>(&Study::plugin_path),
      scene::option<Study>({.flag = "--runs", .help = "timed runs of each drawing, alternating", .usual = "5"},
                           &Study::runs, scene::whole_number(1, 1000)),
      threads_option<Study>(&Study::threads),
      progress_option(&Study::progress),
  };
}

}  // namespace

const ProgramTexts& study_texts() {
  static const ProgramTexts texts{
      .name = "epura study",
      .summary = "measure accuracy, speed and stability of epura",
      .description =
          "Draws scenes by several methods and kinds of arithmetic, and compares the results with closed forms or with "
          "exact results in rational arithmetic.",
      .exit_codes = {{0, "success"},
                     {found_wrong_exit_code, "a case is drawn wrongly (stability)"},
                     {2, "wrong input"},
                     {3, "plugin error"},
                     {4, "cannot write"},
                     {130, "cancelled"}},
      .environment = {{"EPURA_PLUGIN_PATH", "Folders with projection plugins, as in epura(1)."}},
      .examples = {
          {"epura study accuracy bracket.obj -o report.html", "The error and run time of each method for the bracket."},
          {"epura study paper -o paper.pdf", "How far lines on paper are from those of spheres, cylinders, tori ..."},
          {"epura study stability", "A table of stiff and extreme cases, and where each arithmetic fails."}}};
  return texts;
}

std::vector<DefinedCommand> define_study_commands(CLI::App& program) {
  const auto add = [&](const char* name, const char* help) { return program.add_subcommand(name, help); };
  std::vector<DefinedCommand> commands{
      define_command(add("accuracy", "error against run time of methods that find hidden lines"), accuracy_options(),
                     study_accuracy),
      define_command(
          add("paper", "error on paper against run time, from meshes of bodies with closed forms to drawings"),
          paper_options(), study_paper),
      define_command(add("stability", "draw stiff and extreme cases, and show where each arithmetic fails"),
                     stability_options(), study_stability)};
  define_answers(program, study_texts(), commands);
  return commands;
}

}  // namespace epura::study
