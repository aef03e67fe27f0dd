// SPDX-License-Identifier: Apache-2.0
// The options of sheets and their title blocks.
#include <algorithm>
#include <string>
#include <utility>

#include "scene/part_options.hpp"
#include "scene/title_fields.hpp"

namespace epura::scene {

namespace {

// Paper, and where the views stand on it.
Options<SheetDescription> layout_options() {
  using Sheet = SheetDescription;
  return {
      option<Sheet>(
          {.key = "size",
           .flag = "--sheet",
           .help = "A4 to A0, ANSI-A to ANSI-E, WIDTHxHEIGHT in mm, none, or auto: smallest of A4 to A0 that fits "
                   "at the given scale; without "
                   "a scale: the smallest of A4 at 1:1 or larger, A3 at 1:2, A2 at 1:5, A1 at 1:10, else A0; "
                   "ANSI-auto: likewise of ANSI-A to ANSI-E",
           .usual = "A4; A3 for several views"},
          &Sheet::size, paper_choice()),
      option<Sheet>({.key = "orientation",
                     .help = "orientation of the sheet",
                     .usual = "landscape",
                     .switches = {{"--portrait", "portrait", "portrait sheet"},
                                  {"--landscape", "landscape", "landscape sheet (default)"}}},
                    &Sheet::orientation, choice<Orientation>()),
      option<Sheet>({.key = "scale",
                     .flag = "--scale",
                     .help = "1:2, 5:1, ..., auto: largest ISO 5455 scale that fits, or fit: largest scale that fits",
                     .usual = "fit; auto for several views"},
                    &Sheet::scale, scale_choice()),
      option<Sheet>({.key = "angle",
                     .help = "projection method: arrangement of the views",
                     .usual = "first",
                     .switches = {{"--first-angle", "first", "arrange views as in ISO 5456-2 (default)"},
                                  {"--third-angle", "third", "arrange views as in ASME Y14.3"}}},
                    &Sheet::angle, choice<ProjectionAngle>()),
      option<Sheet>(
          {.key = "layout",
           .flag = "--layout",
           .help = "monge: plan and elevation about one ground line, as in an épura; the same as --views epura",
           .usual = "standard"},
          &Sheet::layout, choice<SheetLayout>()),
      option<Sheet>({.key = "fit",
                     .flag = "--fit",
                     .help = "what the sheet has room for; construction: also points of constructions, unless they "
                             "are farther than ten times the size of the view",
                     .usual = "model"},
                    &Sheet::fit, choice<SheetFit>().shown_as("WHAT")),
  };
}

// Relative paths start at the scene file, or at the current folder on the command line.
ValueKind<std::string> file_of_sheet() { return any_text().shown_as("FILE").completed_by(Completion::files); }

// Files that others drew or wrote.
Options<SheetDescription> sheet_files() {
  using Sheet = SheetDescription;
  return {
      option<Sheet>({.key = "template",
                     .flag = "--template",
                     .help = "SVG file with a frame and title block of your own, with texts that are fields; it also "
                             "gives the size of the sheet",
                     .usual = "frame of ISO 5457, title block of ISO 7200"},
                    &Sheet::form, file_of_sheet()),
      option<Sheet>({.key = "logo", .flag = "--logo", .help = "SVG or PNG file, drawn in the title block"},
                    &Sheet::logo, file_of_sheet()),
      option<Sheet>({.key = "style",
                     .flag = "--style",
                     .help = "TOML file with colours, widths and dashes of lines by their role",
                     .usual = "ISO 128-2, black"},
                    &Sheet::style, file_of_sheet()),
  };
}

}  // namespace

Options<SheetDescription> sheet_options() {
  using Sheet = SheetDescription;
  Options<SheetDescription> all = layout_options();
  const Options<SheetDescription> others = {
      option<Sheet>({.key = "frame",
                     .flag = "--frame",
                     .help = "frame of the sheet; full adds centring marks, grid and title block; auto: full for "
                             "several views or if a title block field other than the title is given",
                     .usual = "auto"},
                    &Sheet::frame, choice<FrameKind>().shown_as("KIND")),
      option<Sheet>({.key = "decimals",
                     .flag = "--dimension-decimals",
                     .help = "most decimals of the lengths in dimensions; in inches, their number",
                     .usual = "2; 3 in inches; more for models below 10 mm"},
                    &Sheet::decimals, whole_number(0, 8)),
      option<Sheet>({.key = "dimension_unit",
                     .flag = "--dimension-unit",
                     .help = "unit of the lengths in dimensions, whatever the unit of the models; inches as in ASME "
                             "Y14.5: .500, 1.250",
                     .usual = "mm"},
                    &Sheet::dimension_unit, choice<Unit>().shown_as("UNIT")),
      option<Sheet>({.key = "decimal_sign",
                     .flag = "--decimal-sign",
                     .help = "decimal sign of the dimensions and scales on the sheet",
                     .usual = "."},
                    &Sheet::decimal_sign, choice<DecimalSign>().shown_as("SIGN")),
      option<Sheet>({.key = "font",
                     .flag = "--font",
                     .help = "lettering font: a family that is installed, or a .ttf or .otf file; relative paths "
                             "start at the scene file",
                     .usual = "osifont"},
                    &Sheet::font, any_text().shown_as("FONT")),
  };
  all.insert(all.end(), others.begin(), others.end());
  const Options<SheetDescription> files = sheet_files();
  all.insert(all.end(), files.begin(), files.end());
  return all;
}

void set_field(TitleBlockFields& fields, const std::string& name, const LocatedText& text) {
  std::erase_if(fields, [&name](const auto& field) { return field.first == name; });
  fields.emplace_back(name, text);
}

Options<TitleBlockFields> title_block_options() {
  Options<TitleBlockFields> options;
  const ValueKind<std::string> kind = field_text();
  for (const TitleField& field : title_fields()) {
    std::string flag = "--" + field.name;
    std::replace(flag.begin(), flag.end(), '_', '-');
    // Member by member: where memory ends, GCC 12 frees the members of an aggregate twice.
    Option<TitleBlockFields> option;
    option.key = field.name;
    option.flag = flag;
    option.form = kind.form;
    option.help = field.help;
    option.read = [name = field.name, read = kind.read](TitleBlockFields& fields, const TomlValue& value) {
      set_field(fields, name, {read(value), value.where});
    };
    option.overrule = [name = field.name](TitleBlockFields& fields, const TitleBlockFields& others) {
      for (const auto& [other, text] : others)
        if (other == name) set_field(fields, name, text);
    };
    options.push_back(std::move(option));
  }
  return options;
}

}  // namespace epura::scene
