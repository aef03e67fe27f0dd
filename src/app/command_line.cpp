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
  draw.add_option("--visibility", options.visibility, "exact, or none for a wireframe")
      ->capture_default_str()
      ->type_name("METHOD");
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
  add_number(draw, "--verify-samples", options.verify_samples, {1, 1e7}, "number of points at random for --verify")
      ->type_name("N");
}

void define_draw(CLI::App& draw, DrawOptions& options) {
  define_inputs(draw, options);
  define_outputs(draw, options);
  define_view(draw, options);
  define_lines(draw, options);
  define_sheet(draw, options);
  define_title_block(draw, options);
  define_questions(draw, options);
  define_run(draw, options);
}

void define_plugins(CLI::App& plugins, PluginsOptions& options) {
  plugins.add_option("name", options.name, "projection to show: parameters, matrix, vanishing points")
      ->type_name("NAME");
  add_list(plugins, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
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

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11 says which arguments nobody took; this says what was perhaps meant.
[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  for (const CLI::App* sub : app.get_subcommands()) command = sub;
  for (const std::string& extra : command->remaining(true)) {
    if (extra.starts_with("-"))
      throw Error(Trouble::input, "", "there is no option '" + extra + "'", did_you_mean(extra, long_names(*command)));
    const std::vector<std::string> commands{"draw", "plugins", "compare", "snapshot"};
    if (command == &app)
      throw Error(Trouble::input, "", "there is no command '" + extra + "'", did_you_mean(extra, commands));
  }
  throw Error(Trouble::input, "command line", error.what(),
              "see 'epura " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

}  // namespace

Command parse_command_line(int argc, char** argv) {
  CLI::App app("epura: 3D meshes to engineering drawings with hidden lines removed", "epura");
  app.set_version_flag("--version", "epura " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer(
      "'epura COMMAND --help' says more. Exit codes: 0 done, 1 differences (compare, snapshot) or found wrong "
      "(--verify), 2 wrong input, 3 plugin, 4 could not write, 5 partial drawing (--time-limit), 130 cancelled.");

  DrawOptions draw;
  CLI::App* draw_command = app.add_subcommand("draw", "draw models");
  define_draw(*draw_command, draw);

  PluginsOptions plugins;
  CLI::App* plugins_command = app.add_subcommand("plugins", "list projections, or show one");
  define_plugins(*plugins_command, plugins);

  CompareOptions compare;
  CLI::App* compare_command = app.add_subcommand("compare", "tell what a person sees that differs in two drawings");
  define_compare(*compare_command, compare);

  SnapshotOptions snapshot;
  CLI::App* snapshot_command = app.add_subcommand("snapshot", "draw cases and compare them with what is expected");
  define_snapshot(*snapshot_command, snapshot);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    for (const CLI::App* sub : app.get_subcommands()) return Answer{sub->help()};
    return Answer{app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Answer{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  if (draw_command->parsed()) return draw;
  if (compare_command->parsed()) return compare;
  if (snapshot_command->parsed()) return snapshot;
  return plugins;
}

}  // namespace epura
