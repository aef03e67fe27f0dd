#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/write.hpp"
#include "scene/title_fields.hpp"

namespace epura {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

struct Range {
  double least, most;
};

constexpr Range any{-HUGE_VAL, HUGE_VAL};

std::string text_of(const Range& range) {
  if (std::isinf(range.most)) return format_number(range.least) + " or more";
  return format_number(range.least) + " to " + format_number(range.most);
}

// CLI11 would take "nan", and its messages know neither the option nor our way to write numbers.
double number_of(const std::string& option, const std::string& text, const Range& range, bool whole) {
  const auto number = parse_number(text);
  if (!number || !std::isfinite(*number) || (whole && *number != std::floor(*number)))
    throw Error(Trouble::input, option, "'" + text + "' is no " + (whole ? "whole number" : "number"));
  if (*number < range.least || *number > range.most)
    throw Error(Trouble::input, option, "is " + text + ", allowed is " + text_of(range));
  return *number;
}

template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& option, Number& value, const Range& range,
                        const std::string& help) {
  constexpr bool whole = std::is_integral_v<Number>;
  CLI::Option* added = app.add_option_function<std::string>(
      option,
      [&value, option, range](const std::string& text) { value = Number(number_of(option, text, range, whole)); },
      help);
  if constexpr (std::is_arithmetic_v<Number>) added->default_str(format_number(value));
  return added;
}

// As often as wanted, one value each time: what follows may be a model.
CLI::Option* add_list(CLI::App& app, const std::string& option, auto& values, const std::string& help) {
  return app.add_option(option, values, help)->allow_extra_args(false);
}

// `usual` is said in the help, and is what a later stage makes of nothing.
void add_word(CLI::App& app, const std::string& option, std::string& value, const std::string& type,
              const std::string& usual, const std::string& help) {
  app.add_option(option, value, help)->type_name(type)->default_str(usual);
}

// A flag that stands for one word of several.
void add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& word,
                const std::string& help) {
  app.add_flag_callback(
      option, [&value, word] { value = word; }, help);
}

void define_inputs(CLI::App& draw, DrawOptions& options) {
  draw.add_option("models", options.models, "model files: obj stl ply off; or one scene file: toml")
      ->required()
      ->type_name("MODEL...");
  add_list(draw, "--transform", options.transforms,
           "where models stand, e.g. \"rotate:z,30 translate:0,0,5\"; once for all models, or once for each")
      ->type_name("STEPS");
  add_word(draw, "--unit", options.unit, "UNIT", "mm", "unit of the files: mm, in or m");
  add_word(draw, "--up", options.up, "AXIS", "z", "axis that points up in the files: z or y");
}

void define_view(CLI::App& draw, DrawOptions& options) {
  add_list(draw, "--projection", options.projections,
           "NAME[:key=value...]; 'epura plugins' lists them; each time one more view")
      ->type_name("NAME")
      ->default_str("isometric");
  add_word(draw, "--views", options.views, "NAMES", "", "several views on one sheet: front,top,left,isometric");
  add_list(draw, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
  add_word(
      draw, "--section", options.section, "POINT:NORMAL", "",
      "cut through the models, e.g. 0,0,10:0,-1,0; what lies on the side to which the normal points is taken away");
  add_number(draw, "--near", options.near, any, "leave out what is nearer to the viewer")->type_name("D");
  add_number(draw, "--far", options.far, any, "leave out what is farther from the viewer")->type_name("D");
}

void define_lines(CLI::App& draw, DrawOptions& options) {
  add_word(draw, "--hidden", options.hidden, "STYLE", "dashed", "hidden lines: none, dashed or solid");
  add_word(draw, "--edges", options.edges, "KINDS", "contour,crease,boundary,intersection",
           "which edges: contour crease boundary intersection tangent smooth, with commas");
  add_number(draw, "--crease-angle", options.crease_angle, {0, 180},
             "degrees between faces from which their edge is a crease")
      ->default_str("30")
      ->type_name("DEG");
  draw.add_flag("--arcs{0.01}", options.arcs,
                "draw circles, ellipses and their arcs as such, through corners within so many mm")
      ->type_name("[=MM]");
  draw.add_flag("--centre-lines", options.centre_lines, "draw centre lines and axes of circles of the models");
  add_word(draw, "--dimensions", options.dimensions, "WHICH", "",
           "overall: width, height and depth of the models, each in the clearest view");
  draw.add_option("--visibility", options.visibility,
                  "exact, none for a wireframe, or to compare with: exact:bits=24 float sampled:density=4 "
                  "item-buffer:dpi=600")
      ->capture_default_str()
      ->type_name("METHOD");
  add_number(draw, "--max-error", options.max_error, {1e-12, 1e6},
             "find hidden lines by the cheapest method that shows no span longer than so many mm wrongly")
      ->type_name("MM");
  add_number(draw, "--contact", options.contact, {0, HUGE_VAL},
             "length below which faces touch and hide nothing (by default found)")
      ->type_name("D");
}

void define_sheet(CLI::App& draw, DrawOptions& options) {
  add_word(draw, "--sheet", options.sheet, "SIZE", "A4; A3 for several views",
           "A4 to A0, WIDTHxHEIGHT in mm, none, or auto for the smallest of A4 to A0 that takes the --scale");
  add_choice(draw, "--portrait", options.orientation, "portrait", "the sheet stands upright");
  add_choice(draw, "--landscape", options.orientation, "landscape", "the sheet lies on its side");
  add_word(draw, "--scale", options.scale, "SCALE", "fit; auto for several views",
           "1:2, 5:1, ..., auto for the largest of ISO 5455 that fits, or fit for as large as fits");
  add_choice(draw, "--first-angle", options.angle, "first", "views stand as in ISO 5456-2 (default)");
  add_choice(draw, "--third-angle", options.angle, "third", "views stand as in ASME Y14.3");
  add_word(
      draw, "--frame", options.frame, "KIND", "auto",
      "none, plain, full (centring marks, grid, title block), or auto: full for several views and where a field of "
      "the title block other than the title is given");
}

std::string option_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

void define_title_block(CLI::App& draw, DrawOptions& options) {
  for (const TitleField& field : title_fields()) {
    draw.add_option_function<std::string>(
            "--" + option_name(field.name),
            [&options, name = field.name](const std::string& text) { options.title_block.emplace_back(name, text); },
            field.help)
        ->type_name("TEXT");
  }
}

void define_outputs(CLI::App& draw, DrawOptions& options) {
  add_list(draw, "-o,--output", options.outputs,
           "file to write, by extension: " + joined(format_names()) + "; - for standard output")
      ->type_name("FILE");
  draw.add_option("--format", options.format, "format of '-'")->type_name("NAME");
  draw.add_flag("--plain", options.plain, "SVG without the origin of lines");
  draw.add_option("--svg-text", options.svg_text,
                  "lettering of SVG: outlines, or text, which needs the font to look right")
      ->capture_default_str()
      ->type_name("HOW");
  add_number(draw, "--decimals", options.decimals, {1, 5}, "digits behind the point of millimetres in SVG")
      ->type_name("N");
  add_number(draw, "--dpi", options.dpi, {1, 1200}, "resolution of PNG")->type_name("N");
}

void define_run(CLI::App& draw, DrawOptions& options) {
  add_number(draw, "--threads", options.threads, {0, 1024}, "number of threads, 0 for all cores")->type_name("N");
  draw.add_flag("--timings", options.timings, "say how long each stage took");
  draw.add_option("--plan", options.plan,
                  "certificates by which stages are left out: all, none, or some of clip intersections visibility "
                  "hidden text, with commas; the drawing is the same")
      ->capture_default_str()
      ->type_name("NAMES");
  draw.add_option("--progress", options.progress, "show how far it is: auto (on a terminal), always or never")
      ->capture_default_str()
      ->type_name("WHEN");
  add_number(draw, "--time-limit", options.time_limit, {0, HUGE_VAL},
             "seconds after which edges not decided yet are left out, longest first; marks the drawing PARTIAL")
      ->type_name("S");
}

void define_questions(CLI::App& draw, DrawOptions& options) {
  add_list(draw, "--why", options.why,
           "tell why an edge is drawn and what hides it: [MODEL:]V0-V1 as in JSON, or @X,Y for those nearest to a "
           "place of the page")
      ->type_name("EDGE");
  draw.add_option("--dump", options.dump, "print a table of all drawn edges, or of their spans: edges or spans")
      ->type_name("TABLE");
  draw.add_flag("--verify", options.verify,
                "test the drawing by an independent exact method; exit code 1 if it is wrong");
  draw.add_flag("--explain", options.explain, "tell which stages ran and why, and how many digits each view can have, as 'epura explain' does");
  add_number(draw, "--verify-samples", options.verify_samples, {1, 1e7}, "number of points at random for --verify")
      ->type_name("N");
}

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The innermost command that was named.
const CLI::App& chosen(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

// CLI11 says which arguments nobody took; this says what was perhaps meant.
[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &chosen(app);
  for (const std::string& extra : command->remaining(true)) {
    if (extra.starts_with("-"))
      throw Error(Trouble::input, "", "there is no option '" + extra + "'", did_you_mean(extra, long_names(*command)));
    const std::vector<std::string> commands{"draw", "explain", "study", "plugins", "new-projection"};
    if (command == &app)
      throw Error(Trouble::input, "", "there is no command '" + extra + "'", did_you_mean(extra, commands));
  }
  throw Error(Trouble::input, "command line", error.what(),
              "see 'epura " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

void define_drawing(CLI::App& draw, DrawOptions& options) {
  define_inputs(draw, options);
  define_outputs(draw, options);
  define_view(draw, options);
  define_lines(draw, options);
  define_sheet(draw, options);
  define_title_block(draw, options);
  define_questions(draw, options);
  define_run(draw, options);
}

CLI::App& define_draw(CLI::App& app, DrawOptions& options) {
  CLI::App& draw = *app.add_subcommand("draw", "draw models");
  define_drawing(draw, options);
  return draw;
}

CLI::App& define_explain(CLI::App& app, DrawOptions& options) {
  CLI::App& explain =
      *app.add_subcommand("explain", "draw, and tell which stages ran, which were left out, and why");
  define_drawing(explain, options);
  explain.add_flag("--measure", options.measure, "measure what is saved, by runs without each certificate");
  return explain;
}

CLI::App& define_study(CLI::App& app) {
  return *app.add_subcommand("study", "measure the program itself")->require_subcommand(1);
}

CLI::App& define_stability(CLI::App& study, StabilityOptions& options) {
  CLI::App& stability =
      *study.add_subcommand("stability", "draw stiff and extreme cases, and say where arithmetics break");
  add_list(stability, "-o,--output", options.outputs,
           "file to write, by extension: html json csv svg pdf; - for standard output")
      ->type_name("FILE");
  stability.add_option("--format", options.format, "format of '-'")->type_name("NAME");
  add_word(stability, "--cases", options.cases, "IDS", "all", "only these, with commas: P1,V4,M23; shows every step");
  add_number(stability, "--size", options.size, {0.01, 100}, "factor of the numbers of parts of large scenes")
      ->type_name("F");
  add_number(stability, "--threads", options.threads, {0, 1024}, "number of threads, 0 for all cores")->type_name("N");
  stability.add_flag("--timings", options.timings, "say how long each case took");
  stability.add_option("--progress", options.progress, "show how far it is: auto (on a terminal), always or never")
      ->capture_default_str()
      ->type_name("WHEN");
  return stability;
}

CLI::App& define_accuracy(CLI::App& study, AccuracyOptions& options) {
  CLI::App& accuracy =
      *study.add_subcommand("accuracy", "error against run time of all ways to find hidden lines");
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
  add_number(accuracy, "--threads", options.threads, {0, 1024}, "number of threads, 0 for all cores")->type_name("N");
  accuracy.add_option("--progress", options.progress, "show how far it is: auto (on a terminal), always or never")
      ->capture_default_str()
      ->type_name("WHEN");
  return accuracy;
}

CLI::App& define_plugins(CLI::App& app, PluginsOptions& options) {
  CLI::App& plugins = *app.add_subcommand("plugins", "list projections, show one, or check a library of them");
  plugins.add_option("name", options.name, "projection to show: parameters, matrix, vanishing points")
      ->type_name("NAME");
  add_list(plugins, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
  return plugins;
}

CLI::App& define_check(CLI::App& plugins, CheckPluginOptions& options) {
  CLI::App& check = *plugins.add_subcommand("check", "test a library of projections");
  check.add_option("file", options.file, "the library, e.g. build/mine.so")->required()->type_name("FILE.so");
  add_number(check, "--time-limit", options.time_limit, {0, 1e6},
             "seconds for loading it, and again for the checks; those built in take some milliseconds")
      ->type_name("S");
  return check;
}

CLI::App& define_new_projection(CLI::App& app, NewProjectionOptions& options) {
  CLI::App& command = *app.add_subcommand("new-projection", "begin a projection plugin: C++ source and CMake file");
  command.add_option("name", options.name, "its name; a folder NAME is made")->required()->type_name("NAME");
  return command;
}

}  // namespace

Command parse_command_line(int argc, char** argv) {
  CLI::App app("epura: 3D meshes to engineering drawings with hidden lines removed", "epura");
  app.set_version_flag("--version", "epura " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer(
      "'epura COMMAND --help' says more. Exit codes: 0 done, 1 found wrong (--verify, plugins check), "
      "2 wrong input, 3 plugin, 4 could not write, 5 partial drawing (--time-limit), 130 cancelled.");

  DrawOptions draw;
  StabilityOptions stability;
  DrawOptions explain;
  explain.explain = true;
  AccuracyOptions accuracy;
  PluginsOptions plugins;
  CheckPluginOptions check;
  NewProjectionOptions created;
  const CLI::App& draw_command = define_draw(app, draw);
  const CLI::App& explain_command = define_explain(app, explain);
  CLI::App& study_command = define_study(app);
  const CLI::App& accuracy_command = define_accuracy(study_command, accuracy);
  const CLI::App& stability_command = define_stability(study_command, stability);
  CLI::App& plugins_command = define_plugins(app, plugins);
  const CLI::App& check_command = define_check(plugins_command, check);
  const CLI::App& new_command = define_new_projection(app, created);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Answer{chosen(app).help()};
  } catch (const CLI::CallForVersion& version) {
    return Answer{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  if (draw_command.parsed()) return draw;
  if (explain_command.parsed()) return explain;
  if (accuracy_command.parsed()) return accuracy;
  if (stability_command.parsed()) return stability;
  if (check_command.parsed()) return check;
  if (new_command.parsed()) return created;
  return plugins;
}

}  // namespace epura
