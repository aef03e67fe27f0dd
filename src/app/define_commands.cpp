// SPDX-License-Identifier: Apache-2.0
#include "app/define_commands.hpp"

#include <memory>
#include <string>
#include <utility>

#include "app/command_options.hpp"
#include "app/define_answers.hpp"
#include "app/define_draw.hpp"

namespace epura {

namespace {

void define_stability(CLI::App& stability, StabilityOptions& options) {
  add_list(stability, "-o,--output", options.outputs,
           "file to write, by extension: html json csv svg pdf; - for standard output")
      ->type_name("FILE");
  stability.add_option("--format", options.format, "format of '-'")->type_name("NAME");
  add_word(stability, "--cases", options.cases, "IDS", "all", "only these, with commas: P1,V4,M23; shows every step");
  add_number(stability, "--size", options.size, {0.01, 100}, "factor of the numbers of parts of large scenes")
      ->type_name("F");
  add_threads(stability, options.threads);
  stability.add_flag("--timings", options.timings, "say how long each case took");
  add_progress(stability, options.progress);
}

void define_accuracy(CLI::App& accuracy, AccuracyOptions& options) {
  accuracy.add_option("scenes", options.scenes, "scenes: model files or scene files, each for itself")
      ->required()
      ->type_name("SCENE...");
  add_list(accuracy, "-o,--output", options.outputs,
           "file to write, by extension: html csv json pdf, or svg png for each diagram")
      ->type_name("FILE")
      ->required();
  add_list(accuracy, "--projection", options.projections, "NAME[:key=value...] of models; each time one more view")
      ->type_name("NAME")
      ->default_str("isometric");
  add_list(accuracy, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
  add_list(accuracy, "--visibility", options.methods, "method to measure, by default a choice of all; may be repeated")
      ->type_name("METHOD");
  add_number(accuracy, "--runs", options.runs, {1, 1000}, "timed runs of each method, in turns")->type_name("N");
  add_number(accuracy, "--truth", options.pairs, {1, 1e9},
             "pairs of edge and triangle looked at exactly; beyond, a random part of the edges is judged")
      ->type_name("N");
  accuracy.add_flag("!--no-maps", options.maps, "leave the projection maps out");
  add_threads(accuracy, options.threads);
  add_progress(accuracy, options.progress);
}

void define_compare(CLI::App& compare, CompareOptions& options) {
  compare.add_option("before", options.before, "drawing to compare with: json svg pdf")->required()->type_name("A");
  compare.add_option("after", options.after, "drawing that may differ from it")->required()->type_name("B");
  add_number(compare, "--tolerance", options.tolerance, {1e-6, 10}, "mm by which lines may lie beside each other")
      ->type_name("MM");
  add_word(compare, "--overlay", options.overlay, "FILE", "",
           "picture of both, what differs in colour: svg, png, pdf or html");
  add_word(compare, "--json", options.json, "FILE", "", "what differs, for programs; - for standard output");
}

void define_snapshot(CLI::App& snapshot, SnapshotOptions& options) {
  snapshot
      .add_option("folders", options.folders, "folders of cases: each has scene.toml and expected.json, .svg or .pdf")
      ->required()
      ->type_name("DIR...");
  snapshot.add_flag("--accept", options.accept, "make what comes the expectation; refused where CI is set");
  add_number(snapshot, "--tolerance", options.tolerance, {1e-6, 10}, "mm, as of 'epura compare'")->type_name("MM");
  add_word(snapshot, "--report", options.report, "FILE", "", "page with pictures of the cases: html");
  add_word(snapshot, "--junit", options.junit, "FILE", "", "results for CI: JUnit XML");
  add_number(snapshot, "--threads", options.threads, {0, 1024}, "cases at the same time, 0 for one a core")
      ->type_name("N");
}

void define_plugins(CLI::App& plugins, PluginsOptions& options) {
  plugins.add_option("name", options.name, "projection to show: parameters, matrix, vanishing points")
      ->type_name("NAME");
  add_list(plugins, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
}

void define_check(CLI::App& check, CheckPluginOptions& options) {
  check.add_option("file", options.file, "the library, e.g. build/mine.so")->required()->type_name("FILE.so");
  add_number(check, "--time-limit", options.time_limit, {0, 1e6},
             "seconds for loading it, and again for each answer; those built in take some milliseconds")
      ->type_name("S");
}

void define_new_projection(CLI::App& command, NewProjectionOptions& options) {
  command.add_option("name", options.name, "its name; a folder NAME is made")->required()->type_name("NAME");
}

void define_explain(CLI::App& explain, DrawOptions& options) {
  define_drawing(explain, options);
  explain.add_flag("--measure", options.measure, "measure what is saved, by runs without each certificate");
}

template <class Options>
DefinedCommand defined(CLI::App& parent, const std::string& name, const std::string& help,
                       void (*define)(CLI::App&, Options&), Options usual = {}) {
  const auto options = std::make_shared<Options>(std::move(usual));
  CLI::App* app = parent.add_subcommand(name, help);
  define(*app, *options);
  return {app, [options] { return Command(*options); }};
}

}  // namespace

std::vector<DefinedCommand> define_commands(CLI::App& program) {
  DrawOptions explaining;
  explaining.explain = true;
  std::vector<DefinedCommand> commands{
      defined(program, "draw", "draw models", define_drawing),
      defined(program, "explain", "draw, and tell which stages ran, which were left out, and why", define_explain,
              explaining),
      defined(program, "compare", "tell what a person sees that differs in two drawings", define_compare),
      defined(program, "snapshot", "draw cases and compare them with what is expected", define_snapshot),
      defined(program, "plugins", "list projections, show one, or check a library of them", define_plugins),
      defined(program, "new-projection", "begin a projection plugin: C++ source and CMake file",
              define_new_projection)};
  commands.push_back(
      defined(*program.get_subcommand("plugins"), "check", "test a library of projections", define_check));
  CLI::App& study = *program.add_subcommand("study", "measure the program itself")->require_subcommand(1);
  commands.push_back(
      defined(study, "accuracy", "error against run time of all ways to find hidden lines", define_accuracy));
  commands.push_back(
      defined(study, "stability", "draw stiff and extreme cases, and say where arithmetics break", define_stability));
  for (DefinedCommand& answer : define_answers(program)) commands.push_back(std::move(answer));
  return commands;
}

}  // namespace epura
