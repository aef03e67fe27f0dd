#include "app/command_line.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/write.hpp"

namespace epura {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

void define_inputs(CLI::App& draw, DrawOptions& options) {
  draw.add_option("models", options.models, "model files: obj stl ply off")->required()->type_name("MODEL...");
  draw.add_option("--transform", options.transforms,
                  "where models stand, e.g. \"rotate:z,30 translate:0,0,5\"; once for all models, or once for each")
      ->type_name("STEPS");
  draw.add_option("--unit", options.unit, "unit of the files: mm, in or m")->capture_default_str()->type_name("UNIT");
  draw.add_option("--up", options.up, "axis that points up in the files: z or y")
      ->capture_default_str()
      ->type_name("AXIS");
}

void define_view(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--projection", options.projection, "NAME[:key=value...]; 'epura plugins' lists them")
      ->capture_default_str()
      ->type_name("NAME")
      ->take_last();
  draw.add_option("--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
  draw.add_option("--near", options.near, "leave out what is nearer to the viewer")->type_name("D");
  draw.add_option("--far", options.far, "leave out what is farther from the viewer")->type_name("D");
}

void define_lines(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--hidden", options.hidden, "hidden lines: none, dashed or solid")
      ->capture_default_str()
      ->type_name("STYLE");
  draw.add_option("--edges", options.edges, "which edges: contour crease boundary intersection smooth, with commas")
      ->capture_default_str()
      ->type_name("KINDS");
  draw.add_option("--crease-angle", options.crease_angle, "degrees between faces from which their edge is a crease")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 180.0))
      ->type_name("DEG");
  draw.add_option("--visibility", options.visibility, "exact, or none for a wireframe")
      ->capture_default_str()
      ->type_name("METHOD");
  draw.add_option("--contact", options.contact, "length below which faces touch and hide nothing (by default found)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("D");
}

void define_sheet(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--sheet", options.sheet, "A4 to A0, WIDTHxHEIGHT in mm, or none")
      ->capture_default_str()
      ->type_name("SIZE");
  draw.add_flag("--portrait,!--landscape", options.portrait, "the sheet stands upright");
  draw.add_option("--scale", options.scale, "fit, 1:2, 2:1, ...")->capture_default_str()->type_name("SCALE");
  draw.add_option("--title", options.title, "title of the drawing")->type_name("TEXT");
}

void define_outputs(CLI::App& draw, DrawOptions& options) {
  draw.add_option("-o,--output", options.outputs,
                  "file to write, by extension: " + joined(format_names()) + "; - for standard output")
      ->required()
      ->type_name("FILE")
      ->take_all();
  draw.add_option("--format", options.format, "format of '-'")->type_name("NAME");
  draw.add_flag("--plain", options.plain, "SVG without the origin of lines");
  draw.add_option("--dpi", options.dpi, "resolution of PNG")
      ->capture_default_str()
      ->check(CLI::Range(1.0, 4800.0))
      ->type_name("N");
  draw.add_option("--threads", options.threads, "number of threads, 0 for all cores")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  draw.add_flag("--timings", options.timings, "say how long each stage took");
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
      throw Error(Trouble::input, "option '" + extra + "'", "is unknown", did_you_mean(extra, long_names(*command)));
    const std::vector<std::string> commands{"draw", "plugins"};
    if (command == &app)
      throw Error(Trouble::input, "command '" + extra + "'", "is unknown", did_you_mean(extra, commands));
  }
  throw Error(Trouble::input, "command line", error.what(),
              "see 'epura " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

}  // namespace

Command parse_command_line(int argc, char** argv) {
  CLI::App app("epura: 3D meshes to engineering drawings with hidden lines removed", "epura");
  app.set_version_flag("--version", "epura " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer("'epura COMMAND --help' says more. Exit codes: 0 done, 2 wrong input, 3 plugin, 4 could not write.");

  DrawOptions draw;
  CLI::App* draw_command = app.add_subcommand("draw", "draw models");
  define_inputs(*draw_command, draw);
  define_outputs(*draw_command, draw);
  define_view(*draw_command, draw);
  define_lines(*draw_command, draw);
  define_sheet(*draw_command, draw);

  PluginsOptions plugins;
  CLI::App* plugins_command = app.add_subcommand("plugins", "list projections, or show one");
  plugins_command->add_option("name", plugins.name, "projection to show: parameters, matrix, vanishing points")
      ->type_name("NAME");
  plugins_command->add_option("--plugin-path", plugins.plugin_path, "more folders with projection plugins")
      ->type_name("DIR");

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
  return plugins;
}

}  // namespace epura
