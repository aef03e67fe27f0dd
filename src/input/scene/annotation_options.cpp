// SPDX-License-Identifier: Apache-2.0
// Options of what stands at views: dimensions, threads, notes and symbols.
#include <functional>
#include <utility>

#include "scene/part_options.hpp"
#include "scene/read_entries.hpp"
#include "scene/threads.hpp"

namespace epura::scene {

namespace {

Option<DimensionWords> anchor_option(const std::string& key, const std::string& help) {
  const ValueKind<AnchorWords> kind = anchor();
  // Apart: where memory ends, GCC 12 frees the members of an aggregate within an aggregate twice.
  OptionInfo info{.key = key, .form = kind.form, .help = help, .type = typeid(AnchorWords)};
  return {std::move(info), [key, read = kind.read](DimensionWords& words, const TomlValue& value) {
            words.anchors.emplace_back(key, read(value));
          }};
}

// Several anchors with one key.
Option<DimensionWords> points_option() {
  OptionInfo info{.key = "points",
                  .help = "linear with an arrangement, instead of its two ends: two or more anchors, the origin first"};
  info.form = list_of_anchors().form;
  info.type = typeid(std::vector<AnchorWords>);
  return {std::move(info), [read = list_of_anchors().read](DimensionWords& words, const TomlValue& value) {
            for (AnchorWords& one : read(value)) words.anchors.emplace_back("points", std::move(one));
          }};
}

}  // namespace

Options<DimensionWords> dimension_options() {
  using Words = DimensionWords;
  using Dimension = DimensionDescription;
  return {
      option<Words>({.key = "type", .help = "type of the dimension; required without `match`"},
                    in_description(&Dimension::type), choice<DimensionType>()),
      option<Words>(
          {.key = "match",
           .help = "automatic sizes that get the tolerance, limits, text, offset and name given here, by their "
                   "text on the sheet: `⌀8`, `4× ⌀8*`, `40`; `*` stands for any text. `view`, `type` and "
                   "`direction` choose among them"},
          in_description(&Dimension::match), any_text()),
      option<Words>({.key = "view", .help = "name of the view", .usual = "first view"},
                    in_description(&Dimension::view), any_text()),
      option<Words>({.key = "direction",
                     .help = "linear: horizontal or vertical; overall: width, height or depth, by default all three"},
                    in_description(&Dimension::direction), choice<DimensionDirection>()),
      anchor_option("corner", "angular: vertex of the angle"),
      anchor_option("from",
                    "linear, aligned: one end; angular: end of one leg; auto: what positions are measured from in all "
                    "views, a corner, a plane face or a hole"),
      anchor_option("to", "linear, aligned: the other end; angular: end of the other leg"),
      anchor_option("at", "radius, diameter, arc: a vertex on the circle"),
      points_option(),
      option<Words>({.key = "arrangement",
                     .help = "linear with `points`, and positions of auto: parallel lines from the first point or the "
                             "end of the part; a chain from point to point; or one line with a common origin",
                     .usual = "single dimensions"},
                    in_description(&Dimension::arrangement), choice<DimensionArrangement>()),
      option<Words>({.key = "name", .help = "name by which `[[datum]]` and `[[tolerance_frame]]` refer to it"},
                    in_description(&Dimension::name), any_text()),
      option<Words>({.key = "offset",
                     .help = "distance on paper from the anchors to the dimension line; its sign selects the side"},
                    in_description(&Dimension::offset), number_between(-longest_side, longest_side, "mm")),
      option<Words>({.key = "text",
                     .help = "text instead of the measured value; `<>` stands for that value, with `match` for the "
                             "text that the size has without it"},
                    in_description(&Dimension::text), any_text()),
      option<Words>({.key = "tolerance",
                     .help = "deviations, `±0.1` or `+0.2 -0.1`, in the unit of dimensions; or a class or fit of ISO "
                             "286, `H7`, `g6`, `H7/g6`, for sizes up to 500 mm"},
                    in_description(&Dimension::tolerance), any_text()),
      option<Words>({.key = "limits",
                     .help = "write the limits of size: after a fit in brackets, otherwise instead of the value",
                     .usual = "false"},
                    in_description(&Dimension::limits), truth()),
      option<Words>({.key = "holes",
                     .help = "auto: a note for equal holes and dimensions of their positions, or labels and a table",
                     .usual = "notes"},
                    in_description(&Dimension::holes), choice<HoleDimensions>()),
  };
}

Options<ThreadWords> thread_options() {
  using Words = ThreadWords;
  using Description = ThreadDescription;
  const auto read_thread = [](Words& words, const TomlValue& value) {
    const std::string text = read_text(value);
    parse_thread(text, value.where);
    words.description.thread = {text, value.where};
  };
  OptionInfo thread{.key = "thread",
                    .help = "size of ISO 261, such as `M6`, with a fine pitch `M6x0.75`, or a tolerance class `M6-6H`",
                    .required = true};
  thread.form = any_text().form;
  return {
      {thread, read_thread},
      option<Words>({.key = "at",
                     .help = "a vertex or point on the hole or shaft or on its axis, near the end where the thread "
                             "begins",
                     .required = true},
                    &Words::at, anchor()),
      option<Words>(
          {.key = "depth", .help = "useful length, from the end of the hole or shaft, in mm", .usual = "all of it"},
          in_description(&Description::depth), positive_number()),
      option<Words>({.key = "equal",
                     .help = "`true`: all equal holes or shafts of the model that are parallel to it have this thread",
                     .usual = "false"},
                    in_description(&Description::equal), truth()),
      option<Words>({.key = "callout",
                     .help = "`false`: no dimension; type `auto` and `[[dimension]]`s of the hole give it otherwise",
                     .usual = "true"},
                    in_description(&Description::callout), truth()),
      option<Words>({.key = "view",
                     .help = "name of the view with its dimension",
                     .usual = "the first one along the axis of a hole, or across that of a shaft"},
                    in_description(&Description::view), any_text()),
  };
}

namespace {

// A member of a note or symbol whose kind is known.
template <class Content, class Member>
auto in_content(Member Content::*member) {
  return [member](auto& words) -> auto& { return std::get<Content>(words.description.content).*member; };
}

// An option that is parsed from a text.
template <class Part>
Option<Part> parsed_option(OptionInfo info, std::function<void(Part&, const TomlValue&)> read) {
  info.form = any_text().form;
  return {std::move(info), std::move(read)};
}

void read_zone(ToleranceFrame& frame, const TomlValue& value) {
  frame.zone = parse_zone(read_text(value), value.where);
}

void read_datums(ToleranceFrame& frame, const TomlValue& value) {
  for (const LocatedText& datum : each_word(value))
    frame.datums.push_back(parse_datum(*datum, datum.where, frame.letters));
}

// What stands in one tolerance frame.
Options<ToleranceFrame> frame_options() {
  using Frame = ToleranceFrame;
  return {
      option<Frame>({.key = "characteristic", .help = "what is tolerated", .required = true}, &Frame::characteristic,
                    choice<Characteristic>()),
      parsed_option<Frame>({.key = "zone",
                            .help = "width of the tolerance zone, `0.1`, or its diameter, `Ø0.1`, in the unit of "
                                    "dimensions; then modifiers, `Ø0.1 M`",
                            .required = true},
                           read_zone),
      parsed_option<Frame>({.key = "datums",
                            .help = "letters of the datums in their order, as texts with commas or a list, `A, B M`; "
                                    "`A-B` is a common datum"},
                           read_datums),
  };
}

// Further frames of the same feature.
Option<ToleranceFrame> further_frames() {
  return {{.key = "also",
           .form = {"list of tables"},
           .help = "further tolerances of the same feature, each with `characteristic`, `zone` and `datums`: "
                   "`[{characteristic = \"flatness\", zone = \"0.05\"}]`",
           .type = typeid(std::vector<ToleranceFrame>)},
          [](ToleranceFrame& frame, const TomlValue& value) {
            for (const TomlValue* table : tables_of(value)) {
              ToleranceFrame& one = frame.also.emplace_back();
              read_entries(one, *table, frame_options(), "a tolerance frame");
              frame.letters.insert(frame.letters.end(), one.letters.begin(), one.letters.end());
            }
          }};
}

// In line with which dimension it stands.
Option<CalloutWords> dimension_option() {
  return option<CalloutWords>({.key = "dimension",
                               .help = "name of a straight dimension, instead of `to`: it stands in line with the "
                                       "dimension line, and means the axis or median plane"},
                              in_description(&CalloutDescription::dimension), any_text());
}

Option<CalloutWords> target_option(const std::string& of, bool required) {
  return option<CalloutWords>({.key = "to",
                               .help = of + ": a vertex or point of the models, or a position from the lower left "
                                            "corner of the sheet, in mm",
                               .usual = required ? "" : "no leader",
                               .required = required},
                              &CalloutWords::to, leader_target());
}

Option<CalloutWords> end_option() {
  return option<CalloutWords>({.key = "end",
                               .help = "how its leader ends; auto: with an arrow on a line, otherwise with a dot",
                               .usual = "auto"},
                              in_description(&CalloutDescription::end), choice<LeaderEnd>());
}

Option<CalloutWords> sheet_option() {
  return option<CalloutWords>(
      {.key = "sheet", .help = "number of its sheet, from 1, if it has no leader", .usual = "1"},
      in_description(&CalloutDescription::sheet), whole_number(1));
}

// What all notes and symbols have in common, after their own options.
Options<CalloutWords> with_position(Options<CalloutWords> options) {
  options.push_back(option<CalloutWords>(
      {.key = "view", .help = "name of the view into which its leader points", .usual = "first view"},
      in_description(&CalloutDescription::view), any_text()));
  options.push_back(option<CalloutWords>({.key = "at",
                                          .help = "upper left corner, from the lower left corner of the sheet",
                                          .usual = "a free place nearby"},
                                         in_description(&CalloutDescription::at), pair_of_numbers("mm")));
  return options;
}

}  // namespace

Options<CalloutWords> note_options() {
  return with_position({option<CalloutWords>({.key = "text", .help = "one or several lines", .required = true},
                                             in_content(&NoteText::lines), text_lines()),
                        target_option("end of its leader", false), end_option(), sheet_option()});
}

Options<CalloutWords> tolerance_frame_options() {
  using Words = CalloutWords;
  Options<ToleranceFrame> frame = frame_options();
  frame.push_back(option<ToleranceFrame>({.key = "text", .help = "text above the frame, such as `4×`"},
                                         &ToleranceFrame::above, any_text()));
  frame.push_back(further_frames());
  Options<Words> options;
  for (const Option<ToleranceFrame>& one : frame)
    options.push_back({one, [read = one.read](Words& words, const TomlValue& value) {
                         read(std::get<ToleranceFrame>(words.description.content), value);
                       }});
  for (const Option<Words>& one : {target_option("end of its leader", false), end_option(), dimension_option()})
    options.push_back(one);
  return with_position(std::move(options));
}

Options<CalloutWords> datum_options() {
  const auto read_letter = [](CalloutWords& words, const TomlValue& value) {
    const std::string letter = read_text(value);
    expect_datum_letter(letter, value.where);
    in_content (&DatumFeature::letter)(words) = letter;
  };
  return with_position(
      {parsed_option<CalloutWords>({.key = "letter", .help = "its letter, to which tolerances refer", .required = true},
                                   read_letter),
       target_option("where its triangle stands, on a line of the view", false), dimension_option()});
}

Options<CalloutWords> texture_options() {
  return with_position(
      {option<CalloutWords>({.key = "text", .help = "requirements, such as `Ra 3.2`; one or several lines"},
                            in_content(&SurfaceTexture::lines), text_lines()),
       option<CalloutWords>({.key = "removal", .help = "whether material is removed", .usual = "any"},
                            in_content(&SurfaceTexture::removal), choice<MaterialRemoval>()),
       option<CalloutWords>({.key = "process", .help = "how the surface is made, such as `ground`"},
                            in_content(&SurfaceTexture::process), any_text()),
       target_option("the surface; without it, the symbol is for the whole part and beside the title block", false),
       end_option(), sheet_option()});
}

Options<RequirementWords> requirement_options() {
  using Words = RequirementWords;
  using Description = RequirementDescription;
  const auto in_frame = [](void (*read)(ToleranceFrame&, const TomlValue&)) {
    return [read](Words& words, const TomlValue& value) { read(words.description.frame, value); };
  };
  const auto read_letter = [](Words& words, const TomlValue& value) {
    const std::string letter = read_text(value);
    expect_datum_letter(letter, value.where);
    words.description.letter = {letter, value.where};
  };
  return {
      option<Words>({.key = "type",
                     .help = "`diameter`, `radius`, `linear distance`, `angle`, `datum`, or what is tolerated, as in "
                             "`[[tolerance_frame]]`: `flatness`, `position`",
                     .required = true},
                    in_description(&Description::type), any_text()),
      option<Words>({.key = "feature", .help = "whose faces it is about, `hole 3` or `face 12`", .required = true},
                    &Words::feature, anchor()),
      option<Words>({.key = "to", .help = "feature at the other end of a length or angle"}, &Words::to, anchor()),
      option<Words>({.key = "value",
                     .help = "of a dimension, in the unit of dimensions or in degrees, with its decimals: `8.00`",
                     .usual = "that of the model"},
                    in_description(&Description::value), any_text()),
      option<Words>({.key = "tolerance", .help = "of a dimension: `±0.1`, `+0.2 -0.1`, `H7`"},
                    in_description(&Description::tolerance), any_text()),
      parsed_option<Words>({.key = "zone", .help = "of a geometrical tolerance: `0.1`, `Ø0.1 M`"}, in_frame(read_zone)),
      parsed_option<Words>({.key = "datums", .help = "letters of its datums in their order: `A, B M`"},
                           in_frame(read_datums)),
      parsed_option<Words>({.key = "letter", .help = "of a datum"}, read_letter),
      option<Words>(
          {.key = "name", .help = "its id in the ledger", .usual = "`requirement 3`, by its place in the file"},
          in_description(&Description::name), any_text()),
  };
}

Options<AcceptedWords> accepted_options() {
  return {
      option<AcceptedWords>(
          {.key = "feature", .help = "whose faces may stay free, `hole 3` or `face 12`", .required = true},
          &AcceptedWords::feature, anchor()),
      option<AcceptedWords>(
          {.key = "reason", .help = "why, for those who read what `epura lint` says", .required = true},
          in_description(&AcceptedDescription::reason), any_text()),
  };
}

}  // namespace epura::scene
