// SPDX-License-Identifier: Apache-2.0
#include "scene/part_options.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "scene/line_roles.hpp"

namespace epura::scene {

namespace {

// An automatic standard scale cannot be chosen for a single view.
ValueKind<ScaleChoice> scale_of_a_view() {
  const auto read = [](const TomlValue& value) {
    const ScaleChoice scale = scale_choice().read(value);
    if (scale.standard) refuse(value, "cannot be 'auto', which is for sheets", "write fit, or a scale such as 1:2");
    return scale;
  };
  return {scale_choice().form, read};
}

ValueKind<Vec2> positive_pair() {
  const auto read = [](const TomlValue& value) {
    const Vec2 pair = pair_of_numbers("").read(value);
    if (!(pair.x > 0 && pair.y > 0)) refuse(value, "has a number that is not above 0");
    return pair;
  };
  return {{"[x, y], above 0", "X,Y"}, read};
}

}  // namespace

std::string OptionInfo::meaning() const {
  if (!form.is_closed) return help;
  return help + ": " + words_as_text(form.words) + (form.is_list ? "; separate several with commas" : "");
}

Options<ModelDescription> model_options() {
  using Model = ModelDescription;
  return {
      option<Model>(
          {.key = "file",
           .help = "obj, stl, ply, off or what an importer reads, with `:key=value` for its parameters; relative paths "
                   "start at the scene file",
           .required = true},
          &Model::file, any_text()),
      option<Model>({.key = "name", .help = "name for dimensions; by default the file name without extension"},
                    &Model::name, any_text()),
      option<Model>(
          {.key = "unit", .flag = "--unit", .help = "unit of length of the file", .usual = "that of the file, or mm"},
          &Model::unit, choice<Unit>().shown_as("UNIT")),
      option<Model>(
          {.key = "up", .flag = "--up", .help = "axis of the file that points up", .usual = "that of the file, or z"},
          &Model::up, choice<UpAxis>().shown_as("AXIS")),
      option<Model>({.key = "transform", .help = "steps as in `--transform`: `rotate:z,30 translate:0,0,5`"},
                    &Model::transform, transform_steps()),
      option<Model>({.key = "line", .help = "style of its visible lines", .usual = "visible"}, &Model::line,
                    choice<LineRole>()),
      option<Model>({.key = "hidden", .help = "style of its hidden lines", .usual = "as in the view"}, &Model::hidden,
                    choice<HiddenLines>()),
      option<Model>({.key = "surfaces",
                     .flag = "--surfaces",
                     .help = "auto: edges between recognised faces of the part; mesh: folds between triangles",
                     .usual = "auto"},
                    &Model::surfaces, choice<Surfaces>().shown_as("KIND")),
      option<Model>({.key = "pmi",
                     .flag = "--pmi",
                     .help = "which requirements of the file are drawn",
                     .usual = "all on sheets with dimensions or symbols, otherwise none"},
                    &Model::pmi, choice<Pmi>().shown_as("WHICH")),
      option<Model>({.key = "drawn", .help = "`false` omits the model; the others keep their numbers"}, &Model::drawn,
                    truth()),
      option<Model>({.key = "density",
                     .flag = "--density",
                     .help = "density in kg/m³ of bodies whose style has none, for masses"},
                    &Model::density, positive_number()),
  };
}

Options<StyleDescription> style_options() {
  using Style = StyleDescription;
  return {
      option<Style>({.key = "match",
                     .help = "names of bodies or models: `*` stands for any text, `?` for one character; names as "
                             "`epura info` or the parts list shows them",
                     .required = true},
                    &Style::match, any_text()),
      option<Style>({.key = "line", .help = "style of the visible lines", .usual = "the model's"}, &Style::line,
                    choice<LineRole>()),
      option<Style>({.key = "hidden", .help = "style of the hidden lines", .usual = "the model's"}, &Style::hidden,
                    choice<HiddenLines>()),
      option<Style>({.key = "colour",
                     .help = "of all their lines; `file`: that of the file, darkened if it is light",
                     .usual = "#000"},
                    &Style::colour, colour()),
      option<Style>({.key = "cut", .help = "`false`: sections show them whole, as bolts, shafts and balls"},
                    &Style::cut, truth()),
      option<Style>(
          {.key = "hatch", .help = "pattern of their cut faces; `none` draws the outline only", .usual = "the view's"},
          &Style::hatch, choice<HatchPattern>()),
      option<Style>({.key = "hatch_angle", .help = "angle of the hatching, counterclockwise", .usual = "automatic"},
                    &Style::hatch_angle, number_between(0, 180, "degrees")),
      option<Style>({.key = "hatch_pitch", .help = "distance between lines of the hatching", .usual = "automatic"},
                    &Style::hatch_pitch, number_between(0.5, 50, "mm")),
      option<Style>({.key = "drawn", .help = "`false` omits them"}, &Style::drawn, truth()),
      option<Style>({.key = "material", .help = "material, for the parts list"}, &Style::material, any_text()),
      option<Style>({.key = "density", .help = "density in kg/m³, for the masses in the parts list"}, &Style::density,
                    positive_number()),
  };
}

namespace {

// A point of the world, or a feature instead.
template <class Part, class Member>
Option<Part> point_option(OptionInfo info, Member member) {
  Option<Part> one = option<Part>(std::move(info), member, triple_of_numbers(""));
  one.form.name += ", or a feature";
  one.read = [member, read_point = one.read](Part& part, const TomlValue& value) {
    std::optional<FeatureName> feature = read_feature(value);
    if (!feature) return read_point(part, value);
    assign(std::invoke(member, part), Vec3(0), value.where);
    part.at = {std::move(feature), value.where};
  };
  return one;
}

}  // namespace

Options<SectionDescription> section_options() {
  using Section = SectionDescription;
  return {
      option<Section>({.key = "name", .help = "name to which views refer, such as `A`", .required = true},
                      &Section::name, any_text()),
      point_option<Section>({.key = "point", .help = "point on the cutting plane", .usual = "[0, 0, 0]"},
                            &Section::point),
      option<Section>(
          {.key = "normal", .help = "normal that points to the side that is removed", .usual = "[0, -1, 0]"},
          &Section::normal, direction()),
      option<Section>({.key = "path",
                       .help = "instead of the point: corners of the cutting-plane line, whose legs are perpendicular "
                               "to the normal, or steps parallel to it; a half section begins or ends with a step"},
                      &Section::path, list_of_triples()),
      option<Section>(
          {.key = "aligned",
           .help = "`true` makes all legs of the path cutting planes, at any angle, and turns them into one"},
          &Section::aligned, truth()),
      option<Section>({.key = "beyond",
                       .help = "`false` draws only cut faces, without what is behind them, as in removed sections"},
                      &Section::beyond, truth()),
  };
}

Options<DetailDescription> detail_options() {
  using Detail = DetailDescription;
  return {
      option<Detail>({.key = "name", .help = "name to which views refer, such as `X`", .required = true}, &Detail::name,
                     any_text()),
      option<Detail>({.key = "view", .help = "name of the view that it enlarges", .usual = "first view"}, &Detail::view,
                     any_text()),
      point_option<Detail>({.key = "centre", .help = "point of the world in its middle", .required = true},
                           &Detail::centre),
      option<Detail>({.key = "radius", .help = "radius of a circle around it"}, &Detail::radius, positive_number()),
      option<Detail>({.key = "size", .help = "width and height of a rectangle around it, instead of a circle"},
                     &Detail::size, positive_pair()),
  };
}

Options<BrokenOutDescription> broken_out_options() {
  using BrokenOut = BrokenOutDescription;
  return {
      option<BrokenOut>({.key = "view", .help = "name of the view", .usual = "first view"}, &BrokenOut::view,
                        any_text()),
      point_option<BrokenOut>(
          {.key = "point", .help = "point on the cutting plane, which is parallel to the picture", .required = true},
          &BrokenOut::point),
      option<BrokenOut>({.key = "radius", .help = "radius of the freehand line around the point"}, &BrokenOut::radius,
                        positive_number()),
      option<BrokenOut>(
          {.key = "outline", .help = "instead of the radius: points around which the freehand line runs in the view"},
          &BrokenOut::outline, list_of_triples()),
  };
}

Options<RevolvedDescription> revolved_options() {
  using Revolved = RevolvedDescription;
  return {
      option<Revolved>({.key = "view", .help = "name of the view on which it is drawn", .usual = "first view"},
                       &Revolved::view, any_text()),
      point_option<Revolved>({.key = "point", .help = "point inside the cut face", .required = true}, &Revolved::point),
      option<Revolved>({.key = "normal",
                        .help = "normal of the cutting plane, such as the direction of a bar or a spoke; it is seen in "
                                "true length",
                        .required = true},
                       &Revolved::normal, direction()),
  };
}

Options<ExplodeDescription> explode_options() {
  using Explode = ExplodeDescription;
  return {
      option<Explode>({.key = "match", .help = "names of bodies or models, as in `[[style]]`", .usual = "all"},
                      &Explode::match, any_text()),
      option<Explode>({.key = "move", .help = "how far they are moved apart from the others"}, &Explode::move,
                      triple_of_numbers("")),
      option<Explode>({.key = "factor",
                       .help = "instead: moves them away from the largest body, along the axis of their largest "
                               "cylinder or an axis of the world, by this multiple of their distance"},
                      &Explode::factor, number_between(0, HUGE_VAL, "")),
      option<Explode>({.key = "view", .help = "name of the view", .usual = "all views"}, &Explode::view, any_text()),
      option<Explode>({.key = "trace",
                       .help = "a line from their places to where they are moved",
                       .usual = "along the axes of cylinders only"},
                      &Explode::trace, truth()),
  };
}

Options<ViewDescription> line_options() {
  using View = ViewDescription;
  return {
      option<View>({.key = "hidden",
                    .flag = "--hidden",
                    .help = "style of hidden lines",
                    .usual = "dashed; none in pictorial views and sections"},
                   &View::hidden, choice<HiddenLines>().shown_as("STYLE")),
      option<View>({.key = "hatch",
                    .flag = "--hatch",
                    .help = "pattern of cut faces; none draws their outlines only",
                    .usual = "general"},
                   &View::hatch, choice<HatchPattern>().shown_as("PATTERN")),
      option<View>({.key = "edges",
                    .flag = "--edges",
                    .help = "kinds of edges to draw",
                    .usual = "contour,crease,boundary,intersection,wire"},
                   &View::edges, edge_kinds()),
      option<View>({.key = "crease_angle",
                    .flag = "--crease-angle",
                    .help = "smallest angle between two faces whose common edge is a crease",
                    .usual = "5 between faces of the part, 30 in other meshes"},
                   &View::crease_angle, number_between(0, 180, "degrees").shown_as("DEG")),
      option<View>({.key = "weak_crease_angle",
                    .flag = "--weak-crease-angle",
                    .help = "the same for edges of scans and other meshes that continue a crease",
                    .usual = "crease_angle"},
                   &View::weak_crease_angle, number_between(0, 180, "degrees").shown_as("DEG")),
      option<View>({.key = "least_crease",
                    .flag = "--least-crease",
                    .help = "length on paper from which creases are drawn that meet no other line",
                    .usual = "0"},
                   &View::least_crease, number_between(0, 100, "mm")),
      option<View>({.key = "join_within",
                    .flag = "--join-within",
                    .help = "distance on paper within which parallel lines are drawn as one; 0: draw all lines",
                    .usual = "0.1"},
                   &View::join_within, number_between(0, 1, "mm")),
      option<View>({.key = "layers",
                    .flag = "--layers",
                    .help = "role: a layer for each role of lines; body: also for each body, by its name",
                    .usual = "role"},
                   &View::layers, choice<LayersBy>().shown_as("KIND")),
      option<View>({.key = "construction",
                    .flag = "--construction",
                    .help = "show how the projection is made, e.g. horizon,vp,to-vp or axes,ellipses; vp:1,1,0 and "
                            "to-vp:0-1 are for one direction or edge; all: what the projection has"},
                   &View::construction, construction_choice()),
      option<View>({.key = "centre_of_gravity",
                    .flag = "--centre-of-gravity",
                    .help = "the symbol of the centre of gravity of the models, whose bodies are closed"},
                   &View::centre_of_gravity, truth()),
      option<View>({.key = "centre_lines",
                    .help = "centre lines of bores, shafts, slots and pitch circles; drawn in any case with dimensions "
                            "of type `auto`",
                    .usual = "as for the run"},
                   &View::centre_lines, truth()),
      option<View>({.key = "near", .flag = "--near", .help = "omit what is nearer to the viewer than this depth"},
                   &View::near, any_number("")),
      option<View>({.key = "far", .flag = "--far", .help = "omit what is farther from the viewer than this depth"},
                   &View::far, any_number("")),
  };
}

Options<ViewDescription> view_options() {
  using View = ViewDescription;
  Options<View> all = {
      option<View>({.key = "projection",
                    .help = "`NAME[:key=value...]`, or `{name = NAME, key = value}`; required, except for details",
                    .usual = "that of the view that `detail` enlarges"},
                   &View::projection, projection_request()),
      option<View>(
          {.key = "name", .help = "name for layers and dimensions", .usual = "the projection's, or `detail-X`"},
          &View::name, any_text()),
      option<View>({.key = "scale", .help = "scale of this view, such as `2:1`", .usual = "the sheet's"}, &View::scale,
                   scale_of_a_view()),
      option<View>(
          {.key = "at", .help = "centre of the view, from the lower left corner of the sheet", .usual = "automatic"},
          &View::at, pair_of_numbers("mm")),
      option<View>({.key = "sheet", .help = "number of the sheet that shows it, from 1", .usual = "1"}, &View::sheet,
                   whole_number(1)),
      option<View>({.key = "section", .help = "name of the section shown"}, &View::section, any_text()),
      option<View>({.key = "detail", .help = "name of the detail shown; needs a `scale`"}, &View::detail, any_text()),
      option<View>({.key = "break",
                    .flag = "--break",
                    .help = "leave parts of long views out, between two places on an axis of the world: x:40:160; "
                            "x:40: up to the end; auto: long stretches of constant section"},
                   &View::breaks, break_choice()),
      option<View>({.key = "break_line", .help = "line at which the view is broken", .usual = "zigzag"},
                   &View::break_line, choice<BreakLine>()),
      option<View>({.key = "half", .help = "the half or quarter of a symmetric view that is drawn"}, &View::half,
                   choice<HalfView>()),
      option<View>({.key = "from", .help = "instead of a projection: direction from the models towards the viewer"},
                   &View::from, direction()),
      option<View>({.key = "of", .help = "view beside which it is placed, with an arrow and a letter; needs `from`"},
                   &View::of, any_text()),
      option<View>({.key = "label",
                    .help = "text above the view",
                    .usual = "`A-A` for section `A`, `X` for detail `X`, the next free letter beside another view"},
                   &View::label, any_text()),
  };
  const Options<View> lines = line_options();
  all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

Options<TableDescription> table_options() {
  using Table = TableDescription;
  return {
      option<Table>({.key = "title", .help = "text above the table"}, &Table::title, any_text()),
      option<Table>({.key = "header", .help = "captions of the columns"}, &Table::header, list_of_texts()),
      option<Table>({.key = "rows", .help = "rows of texts, one for each column; they may be empty", .required = true},
                    &Table::rows, rows_of_texts()),
      option<Table>({.key = "corner",
                     .help = "it stands in the free room nearest to this corner of the sheet",
                     .usual = "top-right"},
                    &Table::corner, choice<SheetCorner>()),
      option<Table>({.key = "at", .help = "upper left corner, from the lower left corner of the sheet"}, &Table::at,
                    pair_of_numbers("mm")),
      option<Table>({.key = "sheet", .help = "number of its sheet, from 1", .usual = "1"}, &Table::sheet,
                    whole_number(1)),
  };
}

Options<RevisionDescription> revision_options() {
  using Revision = RevisionDescription;
  return {
      option<Revision>({.key = "revision", .help = "revision index, such as `B`", .required = true},
                       &Revision::revision, any_text()),
      option<Revision>({.key = "text", .help = "what was changed", .required = true}, &Revision::text, any_text()),
      option<Revision>({.key = "date", .help = "date of the change, written as given"}, &Revision::date, field_text()),
      option<Revision>({.key = "author", .help = "who made it"}, &Revision::author, any_text()),
      option<Revision>({.key = "sheet", .help = "number of the sheet with the table, from 1", .usual = "1"},
                       &Revision::sheet, whole_number(1)),
  };
}

Options<PartsListDescription> parts_list_options() {
  using List = PartsListDescription;
  return {
      option<List>({.key = "view",
                    .help = "name of the view with the balloons; items that it does not show have theirs elsewhere",
                    .usual = "for each item, the view that shows most of it"},
                   &List::view, any_text()),
      option<List>({.key = "sheet", .help = "number of its sheet, from 1", .usual = "1"}, &List::sheet,
                   whole_number(1)),
      option<List>({.key = "balloons", .help = "`false`: the list only, without numbers in the views"}, &List::balloons,
                   truth()),
  };
}

}  // namespace epura::scene
