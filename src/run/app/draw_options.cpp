// SPDX-License-Identifier: Apache-2.0
#include "app/draw_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/command_line_options.hpp"
#include "base/text.hpp"
#include "output/format.hpp"
#include "pipeline/run_values.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/details.hpp"
#include "scene/part_options.hpp"

namespace epura {

namespace {

using Draw = DrawOptions;

// Returns a function that finds a member of the run's options in the options of the command.
template <class Member>
auto run(Member member) {
  return [member](auto& draw) -> auto& { return draw.run.*member; };
}

scene::ValueKind<scene::SectionDescription> cutting_plane() {
  return {{"text", "POINT:NORMAL"},
          [](const scene::TomlValue& value) { return scene::parse_section(scene::read_text(value), value.where); }};
}

scene::ValueKind<scene::DetailRequest> detail_request() {
  return {{"text", "CENTRE:RADIUS:SCALE"},
          [](const scene::TomlValue& value) { return scene::parse_detail(scene::read_text(value), value.where); }};
}

// "0,0,20", "hole 3" or "face 12"
scene::ValueKind<scene::Anchor> datum() {
  return {{"text", "POINT|FEATURE"}, [](const scene::TomlValue& value) {
            const std::string text = scene::read_text(value);
            if (const auto point = scene::parse_vector(text)) return scene::Anchor(*point);
            scene::parse_feature(text, value.where);
            return scene::Anchor(scene::FeatureName{text, -1});
          }};
}

// "⌀8=H7": the text of an automatic size, and its tolerance.
scene::ValueKind<scene::DimensionDescription> size_with_tolerance() {
  return {{"text", "SIZE=TOLERANCE"}, [](const scene::TomlValue& value) {
            const std::string text = scene::read_text(value);
            const std::size_t sign = text.rfind('=');
            if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
              scene::refuse(value, "'" + text + "' is not a size with its tolerance", "for example ⌀8=H7 or 40=±0.1");
            scene::DimensionDescription dimension;
            dimension.where = value.where + " " + text;
            dimension.match = {text.substr(0, sign), dimension.where};
            dimension.tolerance = {text.substr(sign + 1), dimension.where};
            return dimension;
          }};
}

scene::ValueKind<explain::EdgeQuestion> edge_question() {
  return {{"text", "EDGE"},
          [](const scene::TomlValue& value) { return explain::parse_edge_question(scene::read_text(value)); }};
}

scene::ValueKind<pipeline::Visibility> visibility_kind() {
  const scene::ValueKind<pipeline::Visibility> known = scene::choice<pipeline::Visibility>();
  return {known.form, [known](const scene::TomlValue& value) {
            for (const char* measured : {"float", "sampled", "item-buffer", "exact:"})
              if (scene::read_text(value).starts_with(measured))
                scene::refuse(value, "'" + scene::read_text(value) + "' cannot be used for drawings",
                              "use exact or none; 'epura study accuracy' measures other methods");
            return known.read(value);
          }};
}

scene::ValueKind<std::string> id_prefix() {
  return {{"text", "PREFIX"}, [](const scene::TomlValue& value) {
            return output::checked_id_prefix(scene::read_text(value), value.where);
          }};
}

scene::ValueKind<output::DxfEntities> dxf_entities() {
  std::vector<std::string> words;
  for (const output::DxfEntityWord& row : output::dxf_entity_words) words.emplace_back(row.word);
  scene::ValueForm form{"list of texts", "KINDS", words};
  form.is_list = form.is_closed = true;
  return {std::move(form), [words](const scene::TomlValue& value) {
            output::DxfEntities entities;
            for (const scene::LocatedText& word : scene::each_word(value)) {
              const scene::TomlValue one = scene::value_of_option(value.where, *word);
              entities.*output::dxf_entity_words[scene::read_word(one, words)].member = true;
            }
            return entities;
          }};
}

scene::ValueKind<pipeline::Shortcuts> certificate_names() {
  scene::ValueForm form{"list of texts", "NAMES", {"all", "none"}};
  for (const auto& [name, member] : pipeline::shortcut_names()) form.words.push_back(name);
  form.is_list = true;
  return {std::move(form),
          [](const scene::TomlValue& value) { return pipeline::parse_shortcuts(scene::read_text(value)); }};
}

void append(scene::Options<Draw>& all, scene::Options<Draw> more, scene::Nature nature = scene::Nature::drawing) {
  for (scene::OptionInfo& option : more) option.nature = nature;
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

scene::Options<Draw> model_file_options() {
  return {
      scene::option<Draw>({.flag = "models",
                           .help = "model files (obj stl ply off and what 'epura importers' lists), - for standard "
                                   "input, or one scene file (toml)",
                           .nature = scene::Nature::file,
                           .required = true,
                           .repeatable = true},
                          &Draw::models, file_name("MODEL...")),
      scene::option<Draw>(
          {.flag = "--transform",
           .help =
               "position of the models, e.g. \"rotate:z,30 translate:0,0,5\"; once for all models, or once for each",
           .repeatable = true},
          &Draw::transforms, scene::transform_steps()),
      scene::option<Draw>({.flag = "--revise",
                           .help = "older version of the model or scene: clouds round what differs from it, and a row "
                                   "in the table of revisions",
                           .nature = scene::Nature::file},
                          &Draw::revise, file_name("FILE")),
  };
}

scene::Options<Draw> output_options() {
  return {
      scene::option<Draw>({.flag = "-o,--output",
                           .help = "output file; its extension selects the format: " + joined(output::format_names()) +
                                   "; - for standard output",
                           .nature = scene::Nature::file,
                           .repeatable = true},
                          &Draw::outputs, file_name("FILE")),
      scene::option<Draw>({.flag = "--format", .help = "format of '-'", .nature = scene::Nature::file}, &Draw::format,
                          scene::any_text().shown_as("NAME").such_as(output::format_names())),
      plugin_path_option<Draw>(run(&pipeline::RunOptions::plugin_path)),
      allow_outside_option<Draw>(run(&pipeline::RunOptions::allow_outside)),
  };
}

scene::Options<Draw> view_options() {
  return {
      projections_option("projection of a view, NAME[:key=value...]; repeat for more views; 'epura plugins' lists them",
                         &Draw::projections),
      views_option("several views on one sheet, e.g. front,top,left,isometric; auto, the default with automatic "
                   "dimensions or --pmi: front, top, left, and those that show what these lack",
                   &Draw::views),
      scene::option<Draw>({.flag = "--section",
                           .help = "cut the models, e.g. 0,0,10:0,-1,0; removes the side that the normal points to"},
                          &Draw::section, cutting_plane()),
      scene::option<Draw>({.flag = "--detail",
                           .help = "enlarge a circle of the first view in a view of its own, e.g. 40,0,10:6:5:1; "
                                   "repeat for more",
                           .repeatable = true},
                          &Draw::details, detail_request()),
      scene::option<Draw>({.flag = "--explode",
                           .help = "move bodies apart: away from the largest one, along the axis of their largest "
                                   "cylinder or an axis of the world, by this multiple of their distance"},
                          &Draw::explode, scene::number_between(0, HUGE_VAL, "").shown_as("FACTOR")),
      scene::option<Draw>(
          {.flag = "--arcs",
           .help = "recognise circles, ellipses and their arcs whose corners lie within this tolerance"},
          run(&pipeline::RunOptions::arcs), pipeline::arc_tolerance()),
      scene::option<Draw>(
          {.flag = "--centre-lines", .help = "add centre lines of bores, shafts, slots and pitch circles"},
          run(&pipeline::RunOptions::centre_lines), scene::truth()),
  };
}

scene::Options<Draw> size_options() {
  return {
      scene::option<Draw>(
          {.flag = "--dimensions",
           .help = "overall: add width, height and depth, each in the clearest view; auto: also sizes of features; "
                   "hole-table: like auto, with the holes in a table"},
          &Draw::dimensions, scene::choice<AutomaticDimensions>().shown_as("WHICH")),
      scene::option<Draw>({.flag = "--arrangement",
                           .help = "arrangement of the positions among automatic dimensions: parallel lines, a chain, "
                                   "or one line with a common origin",
                           .usual = "single dimensions, equal distances as one"},
                          &Draw::arrangement, scene::choice<DimensionArrangement>().shown_as("KIND")),
      scene::option<Draw>({.flag = "--datum",
                           .help = "what the positions among automatic dimensions are measured from in all views: a "
                                   "corner, e.g. 0,0,20, or a plane face or a hole, e.g. 'hole 3'",
                           .usual = "the left and lower ends of the models"},
                          &Draw::datum, datum()),
      scene::option<Draw>({.flag = "--tolerance",
                           .help = "tolerance or fit of the automatic dimensions with this text, e.g. ⌀8=H7, 40=±0.1; "
                                   "repeat for more",
                           .repeatable = true},
                          &Draw::tolerances, size_with_tolerance()),
      scene::option<Draw>({.flag = "--allow-missing-requirements",
                           .help = "accept sheets that lack some of what the model files require, which is told; exit "
                                   "code 1 otherwise"},
                          run(&pipeline::RunOptions::allow_missing), scene::truth()),
      scene::option<Draw>({.flag = "--balloons",
                           .help = "characteristics: the number in an inspection beside each dimension and tolerance "
                                   "that the model files require, as in epura requirements",
                           .usual = "none"},
                          run(&pipeline::RunOptions::balloons), scene::choice<pipeline::Balloons>()),
      scene::option<Draw>({.flag = "--parts-list",
                           .help = "add a list of the parts above the title block, and their numbers in the views"},
                          &Draw::parts_list, scene::truth()),
  };
}

scene::Options<Draw> line_options() {
  return {
      scene::option<Draw>(
          {.flag = "--visibility", .help = "how hidden lines are found; none draws a wireframe", .usual = "exact"},
          run(&pipeline::RunOptions::visibility), visibility_kind()),
      scene::option<Draw>(
          {.flag = "--max-error",
           .help = "largest distance on paper between lines and those of the part: chooses facets, merging, arcs and "
                   "decimals, prints the error of each view, and refuses views that are farther off"},
          run(&pipeline::RunOptions::max_error), pipeline::max_error()),
      scene::option<Draw>(
          {.flag = "--error-note", .help = "state above the title block how far lines may be from those of the part"},
          run(&pipeline::RunOptions::error_note), scene::truth()),
      scene::option<Draw>({.flag = "--contact",
                           .help = "distance below which faces touch and do not hide each other",
                           .usual = "automatic"},
                          run(&pipeline::RunOptions::contact), pipeline::contact_distance()),
  };
}

scene::Options<Draw> format_options() {
  const auto vector = [](auto member) {
    return [member](auto& draw) -> auto& { return draw.vector.*member; };
  };
  return {
      scene::option<Draw>({.flag = "--plain", .help = "compact SVG without ids and the origin of lines"},
                          vector(&output::VectorOptions::plain), scene::truth()),
      scene::option<Draw>(
          {.flag = "--inline", .help = "SVG as an element of an HTML page, as wide as what contains it"},
          vector(&output::VectorOptions::is_inline), scene::truth()),
      scene::option<Draw>(
          {.flag = "--svg-text", .help = "lettering in SVG; text needs the font installed", .usual = "outlines"},
          vector(&output::VectorOptions::text), scene::choice<SvgText>().shown_as("HOW")),
      scene::option<Draw>({.flag = "--strokes",
                           .help = "dashes as a property of their line, or each as a stroke of its own, for plotters, "
                                   "lasers and engravers",
                           .usual = "dashed"},
                          vector(&output::VectorOptions::strokes), scene::choice<output::Strokes>().shown_as("HOW")),
      scene::option<Draw>({.flag = "--proof",
                           .help = "what SVG and PDF carry for 'epura check': data: options, scene file, lines, test "
                                   "and lint of the drawing, hashes; model: the files that are read, too",
                           .usual = "none"},
                          vector(&output::VectorOptions::proof), scene::choice<output::Proof>().shown_as("WHAT")),
      scene::option<Draw>(
          {.flag = "--pdf",
           .help = "archive: PDF/A-3b and PDF/UA-1, with the order in which it is read aloud, and words "
                   "for each view, dimension and table",
           .usual = "plain"},
          vector(&output::VectorOptions::pdf), scene::choice<output::PdfKind>().shown_as("HOW")),
      scene::option<Draw>(
          {.flag = "--svg",
           .help = "accessible: SVG as a tree of views, features, lines and dimensions with names for screen "
                   "readers, and what the sheet shows in words",
           .usual = "usual"},
          vector(&output::VectorOptions::svg), scene::choice<output::SvgKind>().shown_as("HOW")),
      scene::option<Draw>({.flag = "--decimals", .help = "decimals of coordinates in SVG", .usual = "4"},
                          vector(&output::VectorOptions::decimals), scene::whole_number(1, 5)),
      scene::option<Draw>({.flag = "--id-prefix",
                           .help = "prefix of ids and classes in SVG, for several drawings on one HTML page",
                           .usual = "derived from the drawing"},
                          vector(&output::VectorOptions::id_prefix), id_prefix()),
      scene::option<Draw>({.flag = "--dxf-version",
                           .help = "version of AutoCAD whose DXF is written; 2007: texts in UTF-8; 2000: with escapes",
                           .usual = "2007"},
                          vector(&output::VectorOptions::dxf_version),
                          scene::choice<output::DxfVersion>().shown_as("YEAR")),
      scene::option<Draw>({.flag = "--dxf-arcs",
                           .help = "arcs in DXF: bulges of polylines, or entities of their own with ellipses as "
                                   "polylines, as OpenSCAD, LibreOffice and KiCad need them",
                           .usual = "bulges"},
                          vector(&output::VectorOptions::dxf_arcs), scene::choice<output::DxfArcs>().shown_as("HOW")),
      scene::option<Draw>({.flag = "--dxf-blocks", .help = "make each view a block in DXF"},
                          vector(&output::VectorOptions::dxf_blocks), scene::truth()),
      scene::option<Draw>(
          {.flag = "--dxf-entities", .help = "what is an entity of its own in DXF, instead of lines, arrows and texts"},
          vector(&output::VectorOptions::dxf_entities), dxf_entities()),
      scene::option<Draw>({.flag = "--dpi", .help = "resolution of PNG in dots per inch", .usual = "300"},
                          vector(&output::VectorOptions::dpi), scene::number_between(1, 1200, "").shown_as("N")),
  };
}

scene::Options<Draw> question_options() {
  return {
      scene::option<Draw>({.flag = "--why",
                           .help = "explain why an edge is drawn and what hides it: [MODEL:]V0-V1 as in JSON, or @X,Y "
                                   "for the edges nearest to a point on the sheet",
                           .repeatable = true},
                          run(&pipeline::RunOptions::why), edge_question()),
      scene::option<Draw>({.flag = "--dump", .help = "print a table of all drawn edges, or of their spans"},
                          run(&pipeline::RunOptions::dump), scene::choice<pipeline::DumpTable>().shown_as("TABLE")),
      scene::option<Draw>(
          {.flag = "--verify", .help = "test the drawing by an independent exact method; exit code 1 if it is wrong"},
          run(&pipeline::RunOptions::verify), scene::truth()),
      scene::option<Draw>(
          {.flag = "--verify-samples", .help = "number of random test points for --verify", .usual = "2000"},
          run(&pipeline::RunOptions::verify_samples), pipeline::verify_samples()),
      scene::option<Draw>(
          {.flag = "--explain",
           .help = "show which stages ran and why, and how many digits each view keeps, as 'epura explain' does"},
          run(&pipeline::RunOptions::explain), scene::truth()),
  };
}

scene::Options<Draw> run_options() {
  return {
      threads_option<Draw>(run(&pipeline::RunOptions::threads)),
      scene::option<Draw>({.flag = "--timings", .help = "print the time of each stage"}, &Draw::timings,
                          scene::truth()),
      scene::option<Draw>({.flag = "--plan",
                           .help = "shortcuts that may skip stages: all, none, or some of clip intersections "
                                   "visibility hidden text, separated by commas; the drawing is the same",
                           .usual = "all"},
                          run(&pipeline::RunOptions::plan), certificate_names()),
      progress_option(&Draw::progress),
      scene::option<Draw>(
          {.flag = "--sandbox",
           .help = "auto: what reads models of strangers can open nothing else, if the kernel can see to "
                   "it; on: nor can the program; off: no process is confined",
           .usual = "auto"},
          run(&pipeline::RunOptions::sandbox), scene::choice<pipeline::Sandbox>().shown_as("WHEN")),
      scene::option<Draw>(
          {.flag = "--time-limit",
           .help = "time limit in seconds; draws the longest edges first and marks an incomplete drawing PARTIAL"},
          run(&pipeline::RunOptions::time_limit), pipeline::time_limit()),
  };
}

// As on the command line.
std::string word_of(const scene::TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
  if (const auto* number = std::get_if<double>(&value.content)) return format_number(*number);
  if (const auto* is_so = std::get_if<bool>(&value.content)) return *is_so ? "true" : "false";
  if (const auto* date = std::get_if<scene::TomlDate>(&value.content)) return date->text;
  std::string words;
  if (const auto* list = std::get_if<scene::TomlList>(&value.content))
    for (const scene::TomlValue& one : list->values) words += (words.empty() ? "" : ",") + word_of(one);
  return words;
}

std::string name_of(const scene::OptionInfo& option, const std::string& word) {
  if (!option.flag.empty()) return option.flag.substr(option.flag.rfind(',') + 1);
  for (const scene::Switch& one : option.switches)
    if (one.word == word) return one.flag;
  return {};
}

// What is read is also kept in words.
void keep_words(scene::Options<Draw>& options) {
  for (scene::Option<Draw>& option : options) {
    if (!is_of_drawing(option)) continue;
    option.read = [info = static_cast<scene::OptionInfo>(option), read = option.read](Draw& draw,
                                                                                      const scene::TomlValue& value) {
      read(draw, value);
      const std::string word = word_of(value);
      draw.given.emplace_back(name_of(info, word), word);
    };
  }
}

scene::Option<Draw> rules_option() {
  return scene::option<Draw>({.flag = "--rules",
                              .help = "what readers of the sheets take for granted without a number: the rules of a "
                                      "standard, or some rules",
                              .usual = "iso",
                              .nature = scene::Nature::run},
                             run(&pipeline::RunOptions::rules), pipeline::applied_rules());
}

scene::Options<Draw> title_options() {
  scene::Options<Draw> options;
  for (const scene::Option<scene::TitleBlockFields>& field : scene::title_block_options())
    options.push_back({field, [read = field.read](Draw& draw, const scene::TomlValue& value) {
                         read(draw.sheet.title_block, value);
                       }});
  return options;
}

}  // namespace

bool is_of_drawing(const scene::OptionInfo& option) {
  return option.nature == scene::Nature::drawing || option.flag == "--verify-samples";
}

bool names_file(const scene::OptionInfo& option, const std::string& value) {
  return option.form.completion == scene::Completion::files ||
         (option.flag == "--font" && scene::names_font_file(value));
}

const scene::Option<DrawOptions>* find_option(const scene::Options<DrawOptions>& options, const std::string& name) {
  const auto is_it = [&](const scene::OptionInfo& option) {
    const auto is_switch = [&](const scene::Switch& one) { return one.flag == name; };
    return option.flag.substr(option.flag.rfind(',') + 1) == name ||
           std::any_of(option.switches.begin(), option.switches.end(), is_switch);
  };
  const auto found = std::find_if(options.begin(), options.end(), is_it);
  return name.empty() || found == options.end() ? nullptr : &*found;
}

scene::ValueKind<std::string> file_name(const std::string& placeholder) {
  // Names may contain any characters.
  const scene::ValueKind<std::string> any{
      {"text", placeholder}, [](const scene::TomlValue& value) { return std::get<std::string>(value.content); }};
  return any.completed_by(scene::Completion::files);
}

scene::Options<DrawOptions> draw_options() {
  scene::Options<Draw> all = model_file_options();
  std::ranges::move(output_options(), std::back_inserter(all));
  scene::append_options(all, scene::model_options(), &Draw::model);
  append(all, view_options());
  append(all, size_options());
  append(all, line_options());
  scene::append_options(all, scene::view_options(), &Draw::view);
  scene::append_options(all, scene::sheet_options(), &Draw::sheet);
  append(all, title_options());
  append(all, format_options());
  append(all, question_options(), scene::Nature::run);
  append(all, run_options(), scene::Nature::run);
  keep_words(all);
  return all;
}

scene::Options<DrawOptions> one_model_options() {
  scene::Options<Draw> all = output_options();
  scene::Options<scene::ModelDescription> of_model = scene::model_options();
  std::erase_if(of_model, [](const scene::OptionInfo& option) { return option.flag == "--density"; });
  scene::append_options(all, of_model, &Draw::model);
  scene::Options<scene::SheetDescription> of_sheet = scene::sheet_options();
  // What arranges chosen views and dimensions has no meaning.
  constexpr std::array of_views{"angle", "layout", "fit", "decimals", "dimension_unit"};
  std::erase_if(of_sheet, [&of_views](const scene::OptionInfo& option) {
    return std::find(of_views.begin(), of_views.end(), option.key) != of_views.end();
  });
  scene::append_options(all, of_sheet, &Draw::sheet);
  append(all, title_options());
  append(all, format_options());
  append(all, run_options(), scene::Nature::run);
  return all;
}

scene::Options<DrawOptions> explain_options() {
  scene::Options<Draw> all = draw_options();
  all.push_back(scene::option<Draw>({.flag = "--measure",
                                     .help = "measure the saved time by runs without each shortcut",
                                     .nature = scene::Nature::run},
                                    &Draw::measure, scene::truth()));
  return all;
}

scene::Options<DrawOptions> lint_options() {
  scene::Options<Draw> all = draw_options();
  all.push_back(rules_option());
  all.push_back(scene::option<Draw>(
      {.flag = "--json", .help = "findings as JSON; - for standard output", .nature = scene::Nature::run},
      &Draw::found_json, file_name("FILE")));
  all.push_back(scene::option<Draw>({.flag = "--all",
                                     .help = "list all findings; otherwise three of those that differ in numbers alone",
                                     .nature = scene::Nature::run},
                                    &Draw::lint_all, scene::truth()));
  all.push_back(scene::option<Draw>({.flag = "--picture",
                                     .help = "the drawing, with the faces hatched that the dimensions leave free",
                                     .nature = scene::Nature::run},
                                    &Draw::lint_picture, file_name("FILE")));
  return all;
}

scene::Options<DrawOptions> define_options() {
  scene::Options<Draw> all = draw_options();
  all.push_back(rules_option());
  all.push_back(scene::option<Draw>(
      {.flag = "--json", .help = "the result as JSON; - for standard output", .nature = scene::Nature::run},
      &Draw::found_json, file_name("FILE")));
  all.push_back(
      scene::option<Draw>({.flag = "--rebuild",
                           .help = "perturb the faces of the part, and find them again from the numbers, as without it",
                           .nature = scene::Nature::run},
                          run(&pipeline::RunOptions::rebuild), scene::truth()));
  return all;
}

}  // namespace epura
