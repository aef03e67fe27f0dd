// SPDX-License-Identifier: Apache-2.0
#include "app/draw_options.hpp"

#include <cmath>
#include <utility>

#include "app/command_line_options.hpp"
#include "base/text.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/part_options.hpp"

namespace epura {

namespace {

using Draw = DrawOptions;

// What a member of the run's options is in those of the command.
template <class Member>
auto run(Member member) {
  return [member](auto& draw) -> auto& { return draw.run.*member; };
}

ValueKind<SectionDescription> cutting_plane() {
  return {{"text", "POINT:NORMAL"},
          [](const TomlValue& value) { return parse_section(read_text(value), value.where); }};
}

ValueKind<EdgeQuestion> edge_question() {
  return {{"text", "EDGE"}, [](const TomlValue& value) { return parse_edge_question(read_text(value)); }};
}

ValueKind<double> curve_tolerance() {
  ValueForm form{"number, mm", "MM"};
  form.implied = "0.01";
  return {form, [](const TomlValue& value) {
            const std::string text = read_text(value);
            const auto tolerance = parse_number(text);
            if (!tolerance || !(*tolerance > 0 && *tolerance <= 1))
              refuse(value, "'" + text + "' is not a tolerance", "more than 0 and at most 1 mm are possible");
            return *tolerance;
          }};
}

ValueKind<Visibility> visibility_kind() {
  const ValueKind<Visibility> known = choice<Visibility>();
  return {known.form, [known](const TomlValue& value) {
            for (const char* measured : {"float", "sampled", "item-buffer", "exact:"})
              if (read_text(value).starts_with(measured))
                refuse(value, "'" + read_text(value) + "' is not a method for drawings",
                       "'epura study accuracy' measures it; drawings take exact or none");
            return known.read(value);
          }};
}

ValueKind<std::string> id_prefix() {
  return {{"text", "PREFIX"}, [](const TomlValue& value) { return checked_id_prefix(read_text(value), value.where); }};
}

ValueKind<Shortcuts> certificate_names() {
  ValueForm form{"list of texts", "NAMES", {"all", "none"}};
  for (const auto& [name, member] : shortcut_names()) form.words.push_back(name);
  form.is_list = true;
  return {std::move(form), [](const TomlValue& value) { return parse_shortcuts(read_text(value)); }};
}

void add_views(Draw& draw, const TomlValue& value) {
  for (const LocatedText& name : each_word(value))
    draw.views.push_back({projection_request().read(value_of_option(name.where, *name)), name.where});
}

void append(Options<Draw>& all, Options<Draw> more, Nature nature = Nature::drawing) {
  for (OptionInfo& option : more) option.nature = nature;
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

Options<Draw> file_options() {
  return {
      option<Draw>({.flag = "models",
                    .help = "model files: obj stl ply off; or one scene file: toml",
                    .nature = Nature::file,
                    .required = true,
                    .repeatable = true},
                   &Draw::models, file_name("MODEL...")),
      option<Draw>({.flag = "-o,--output",
                    .help = "file to write, by extension: " + joined(format_names()) + "; - for standard output",
                    .nature = Nature::file,
                    .repeatable = true},
                   &Draw::outputs, file_name("FILE")),
      option<Draw>({.flag = "--format", .help = "format of '-'", .nature = Nature::file}, &Draw::format,
                   any_text().shown_as("NAME").such_as(format_names())),
      plugin_path_option<Draw>(run(&RunOptions::plugin_path)),
      option<Draw>(
          {.flag = "--transform",
           .help = "where models stand, e.g. \"rotate:z,30 translate:0,0,5\"; once for all models, or once for "
                   "each",
           .repeatable = true},
          &Draw::transforms, transform_steps()),
  };
}

Options<Draw> picture_options() {
  return {
      projections_option("NAME[:key=value...]; 'epura plugins' lists them; each time one more view",
                         &Draw::projections),
      {{.flag = "--views",
        .form = {.placeholder = "NAMES", .completion = Completion::projections},
        .help = "several views on one sheet: front,top,left,isometric"},
       add_views},
      option<Draw>({.flag = "--section",
                    .help = "cut through the models, e.g. 0,0,10:0,-1,0; what lies on the side to which the normal "
                            "points is taken away"},
                   &Draw::section, cutting_plane()),
      option<Draw>({.flag = "--arcs",
                    .help = "draw circles, ellipses and their arcs as such, through corners within so many mm"},
                   run(&RunOptions::arcs), curve_tolerance()),
      option<Draw>({.flag = "--centre-lines", .help = "draw centre lines and axes of circles of the models"},
                   run(&RunOptions::centre_lines), truth()),
      option<Draw>({.flag = "--dimensions", .help = "width, height and depth of the models, each in the clearest view"},
                   &Draw::dimensions, choice<AutomaticDimensions>().shown_as("WHICH")),
      option<Draw>(
          {.flag = "--visibility", .help = "how hidden lines are found, none for a wireframe", .usual = "exact"},
          run(&RunOptions::visibility), visibility_kind()),
      option<Draw>(
          {.flag = "--max-error",
           .help = "say what is guaranteed, and refuse views in which a span longer than so many mm might be wrong"},
          run(&RunOptions::max_error), number_between(1e-12, 1e6, "mm").shown_as("MM")),
      option<Draw>({.flag = "--contact", .help = "length below which faces touch and hide nothing", .usual = "found"},
                   run(&RunOptions::contact), number_between(0, HUGE_VAL, "")),
  };
}

Options<Draw> format_options() {
  const auto vector = [](auto member) {
    return [member](auto& draw) -> auto& { return draw.vector.*member; };
  };
  return {
      option<Draw>({.flag = "--plain", .help = "SVG without the origin of lines"}, vector(&VectorOptions::plain),
                   truth()),
      option<Draw>(
          {.flag = "--svg-text", .help = "lettering of SVG; text needs the font to look right", .usual = "outlines"},
          vector(&VectorOptions::text), choice<SvgText>().shown_as("HOW")),
      option<Draw>({.flag = "--decimals", .help = "digits behind the point of millimetres in SVG", .usual = "4"},
                   vector(&VectorOptions::decimals), whole_number(1, 5)),
      option<Draw>({.flag = "--id-prefix",
                    .help = "what ids and classes of SVG begin with, for drawings that share a page",
                    .usual = "made from the drawing"},
                   vector(&VectorOptions::id_prefix), id_prefix()),
      option<Draw>({.flag = "--dpi", .help = "resolution of PNG", .usual = "300"}, vector(&VectorOptions::dpi),
                   number_between(1, 1200, "").shown_as("N")),
  };
}

Options<Draw> question_options() {
  return {
      option<Draw>({.flag = "--why",
                    .help = "tell why an edge is drawn and what hides it: [MODEL:]V0-V1 as in JSON, or @X,Y for those "
                            "nearest to a place of the page",
                    .repeatable = true},
                   run(&RunOptions::why), edge_question()),
      option<Draw>({.flag = "--dump", .help = "print a table of all drawn edges, or of their spans"},
                   run(&RunOptions::dump), choice<DumpTable>().shown_as("TABLE")),
      option<Draw>(
          {.flag = "--verify", .help = "test the drawing by an independent exact method; exit code 1 if it is wrong"},
          run(&RunOptions::verify), truth()),
      option<Draw>({.flag = "--verify-samples", .help = "number of points at random for --verify", .usual = "2000"},
                   run(&RunOptions::verify_samples), whole_number(1, 10'000'000)),
      option<Draw>({.flag = "--explain",
                    .help = "tell which stages ran and why, and how many digits each view can have, as 'epura explain' "
                            "does"},
                   run(&RunOptions::explain), truth()),
  };
}

Options<Draw> run_options() {
  return {
      threads_option<Draw>(run(&RunOptions::threads)),
      option<Draw>({.flag = "--timings", .help = "say how long each stage took"}, &Draw::timings, truth()),
      option<Draw>({.flag = "--plan",
                    .help = "certificates by which stages are left out: all, none, or some of clip intersections "
                            "visibility hidden text, with commas; the drawing is the same",
                    .usual = "all"},
                   run(&RunOptions::plan), certificate_names()),
      progress_option(&Draw::progress),
      option<Draw>(
          {.flag = "--time-limit",
           .help = "seconds that a run may take: what there is no time for is left out, the longest edges come "
                   "first; marks the drawing PARTIAL"},
          run(&RunOptions::time_limit), number_between(0, HUGE_VAL, "s").shown_as("S")),
  };
}

Options<Draw> title_options() {
  Options<Draw> options;
  for (const Option<TitleBlockFields>& field : title_block_options())
    options.push_back(
        {field, [read = field.read](Draw& draw, const TomlValue& value) { read(draw.sheet.title_block, value); }});
  return options;
}

}  // namespace

ValueKind<std::string> file_name(const std::string& placeholder) {
  // Names may have any characters.
  const ValueKind<std::string> any{{"text", placeholder},
                                   [](const TomlValue& value) { return std::get<std::string>(value.content); }};
  return any.completed_by(Completion::files);
}

Options<DrawOptions> draw_options() {
  Options<Draw> all = file_options();
  append_options(all, model_options(), &Draw::model);
  append(all, picture_options());
  append_options(all, view_options(), &Draw::view);
  append_options(all, sheet_options(), &Draw::sheet);
  append(all, title_options());
  append(all, format_options());
  append(all, question_options(), Nature::run);
  append(all, run_options(), Nature::run);
  return all;
}

Options<DrawOptions> explain_options() {
  Options<Draw> all = draw_options();
  all.push_back(option<Draw>(
      {.flag = "--measure", .help = "measure what is saved, by runs without each certificate", .nature = Nature::run},
      &Draw::measure, truth()));
  return all;
}

}  // namespace epura
