// SPDX-License-Identifier: Apache-2.0
#include "app/define_draw.hpp"

#include <cmath>

#include "app/command_options.hpp"
#include "output/write.hpp"
#include "scene/title_fields.hpp"

namespace epura {

namespace {

void define_files(CLI::App& draw, DrawOptions& options) {
  draw.add_option("models", options.models, "model files: obj stl ply off; or one scene file: toml")
      ->required()
      ->type_name("MODEL...");
  add_list(draw, "-o,--output", options.outputs,
           "file to write, by extension: " + joined(format_names()) + "; - for standard output")
      ->type_name("FILE");
  draw.add_option("--format", options.format, "format of '-'")->type_name("NAME");
}

void define_places(CLI::App& draw, DrawOptions& options) {
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
  add_word(
      draw, "--section", options.section, "POINT:NORMAL", "",
      "cut through the models, e.g. 0,0,10:0,-1,0; what lies on the side to which the normal points is taken away");
  add_number(draw, "--near", options.near, any_number, "leave out what is nearer to the viewer")->type_name("D");
  add_number(draw, "--far", options.far, any_number, "leave out what is farther from the viewer")->type_name("D");
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

void define_formats(CLI::App& draw, DrawOptions& options) {
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
  add_threads(draw, options.threads);
  draw.add_flag("--timings", options.timings, "say how long each stage took");
  draw.add_option("--plan", options.plan,
                  "certificates by which stages are left out: all, none, or some of clip intersections visibility "
                  "hidden text, with commas; the drawing is the same")
      ->capture_default_str()
      ->type_name("NAMES");
  add_progress(draw, options.progress);
  add_number(
      draw, "--time-limit", options.time_limit, {0, HUGE_VAL},
      "seconds that a run may take: what there is no time for is left out, the longest edges come first; marks the "
      "drawing PARTIAL")
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
  draw.add_flag("--explain", options.explain,
                "tell which stages ran and why, and how many digits each view can have, as 'epura explain' does");
  add_number(draw, "--verify-samples", options.verify_samples, {1, 1e7}, "number of points at random for --verify")
      ->type_name("N");
}

}  // namespace

void define_drawing(CLI::App& draw, DrawOptions& options) {
  define_next(draw, Nature::file);
  define_files(draw, options);
  define_next(draw, Nature::code);
  add_list(draw, "--plugin-path", options.plugin_path, "more folders with projection plugins")->type_name("DIR");
  define_next(draw, Nature::drawing);
  define_places(draw, options);
  define_view(draw, options);
  define_lines(draw, options);
  define_sheet(draw, options);
  define_title_block(draw, options);
  define_formats(draw, options);
  define_next(draw, Nature::run);
  define_questions(draw, options);
  define_run(draw, options);
}

}  // namespace epura
