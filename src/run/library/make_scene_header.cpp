// SPDX-License-Identifier: Apache-2.0
// Writes epura/scene.hpp: a struct for each section of scene files, from the tables by which these are read.
//   make_scene_header FILE
#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/scene_keys.hpp"

namespace {

using namespace epura::scene;
using epura::EdgeKinds;
using epura::Mat4;
using epura::Vec2;
using epura::Vec3;

constexpr const char* head = R"(// SPDX-License-Identifier: Apache-2.0
// Description of a drawing in plain values, made from the tables by which scene files are read: docs/scenes.md. World
// coordinates are right-handed, z points up; lengths are millimetres after applying the unit of a model. What is empty
// is not given.
#pragma once

#include <array>
#include <concepts>
#include <epura/choices.hpp>
#include <epura/scene_types.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace epura {

template <class Part, class Same>
concept MaybeConst = std::same_as<std::remove_const_t<Part>, Same>;

// each_option(part, visit) calls visit(key, name, value) for each option of a part, in the order of the tables: its key
// in scene files, the name of the member, and the member.
)";

/// A section of scene files, and what it is in C++.
struct PartRow {
  std::string_view section, type, member, meaning;
};

constexpr std::array parts{
    PartRow{"model", "Model", "models", "What is drawn: a file, the bytes of one, or polygons."},
    PartRow{
        "style", "Style", "styles",
        "How bodies with certain names are drawn, whatever their models and views say. Of several styles that match "
        "a body, the last one that has a value counts."},
    PartRow{"view", "View", "views", "A view of the models through a projection plugin."},
    PartRow{"section", "Section", "sections",
            "A plane that cuts the models. The side to which the normal points is removed."},
    PartRow{"detail", "Detail", "details", "A part of a parallel view, which another view shows at a larger scale."},
    PartRow{"broken_out", "BrokenOut", "broken_outs",
            "A broken-out section: inside a freehand line of a view, a plane parallel to the picture cuts the models."},
    PartRow{"revolved", "Revolved", "revolved",
            "A revolved section: the cut face around a point of a plane that the view sees edge-on, turned into the "
            "picture."},
    PartRow{"explode", "Explode", "explosions", "Bodies moved apart in exploded views."},
    PartRow{"dimension", "Dimension", "dimensions", "A dimension in a view, attached to the model. ISO 129-1."},
    PartRow{"thread", "Thread", "threads", "A screw thread in a hole or on a shaft, drawn as in ISO 6410-1."},
    PartRow{"note", "Note", "notes", "Lines of text, with a leader or alone on the sheet."},
    PartRow{"tolerance_frame", "ToleranceFrame", "tolerance_frames", "Geometrical tolerances of a feature. ISO 1101."},
    PartRow{"datum", "Datum", "datums", "A datum feature, marked by a triangle. ISO 5459."},
    PartRow{"surface_texture", "SurfaceTexture", "surface_textures",
            "What is required of a surface, or of the whole part. ISO 21920-1."},
    PartRow{"requirement", "Requirement", "requirements",
            "What is required of faces of a model, as model files state it: drawn, and in the ledger."},
    PartRow{"accepted", "Accepted", "accepted",
            "A feature of which `epura lint` need not say what is not dimensioned."},
    PartRow{"table", "Table", "tables", "A table of texts on a sheet."},
    PartRow{"revision", "Revision", "revisions", "A row of the table of revisions of a sheet."},
    PartRow{"parts_list", "PartsList", "parts_list",
            "A list of the parts with numbers, and balloons in the views that refer to them. ISO 7573, ISO 6433."},
    PartRow{"all_sheets", "SheetOptions", "all_sheets", ""},
    PartRow{"sheet", "SheetOptions", "sheets", "A sheet: its paper, lettering, frame and title block."},
    PartRow{"title_block", "TitleBlock", "title_block", ""},
};

/// What the values of an option are in C++.
struct TypeRow {
  std::type_index of;
  const char* name;
  bool has_empty = false;  ///< an empty value stands for none
};

const std::array types{
    TypeRow{typeid(std::string), "std::string", true},
    TypeRow{typeid(bool), "bool"},
    TypeRow{typeid(int), "int"},
    TypeRow{typeid(double), "double"},
    TypeRow{typeid(Vec2), "std::array<double, 2>"},
    TypeRow{typeid(Vec3), "std::array<double, 3>"},
    TypeRow{typeid(Mat4), "Transform"},
    TypeRow{typeid(std::vector<Vec3>), "std::vector<std::array<double, 3>>", true},
    TypeRow{typeid(std::vector<std::string>), "std::vector<std::string>", true},
    TypeRow{typeid(std::vector<std::vector<std::string>>), "std::vector<std::vector<std::string>>", true},
    TypeRow{typeid(ProjectionRequest), "std::string", true},
    TypeRow{typeid(ConstructionChoice), "std::vector<std::string>", true},
    TypeRow{typeid(BreakChoice), "std::vector<Break>", true},
    TypeRow{typeid(EdgeKinds), "EdgeKinds"},
    TypeRow{typeid(ColourChoice), "std::string", true},
    TypeRow{typeid(ScaleChoice), "Scale"},
    TypeRow{typeid(PaperChoice), "PaperSize"},
    TypeRow{typeid(AnchorWords), "DimensionAnchor"},
    TypeRow{typeid(std::vector<AnchorWords>), "std::vector<DimensionAnchor>", true},
    TypeRow{typeid(LeaderWords), "LeaderTarget"},
    TypeRow{typeid(std::vector<ToleranceFrame>), "std::vector<ToleranceFrame>", true},
    TypeRow{typeid(TitleBlockFields), "TitleBlock", true},
};

/// Members that scene files say in the words of the member before them, or not at all.
struct ExtraRow {
  std::string_view section, after, declaration;
};

constexpr std::array extras{
    ExtraRow{"model", "file",
             "  /// bytes of the file, which is then not read: `file` gives its name and format\n"
             "  std::string content{};\n"
             "  /// instead of a file\n"
             "  Polygons polygons{};\n"},
    ExtraRow{"view", "projection",
             "  /// names and values of the projection's parameters, see `epura plugins NAME`\n"
             "  std::vector<std::pair<std::string, ParameterValue>> parameters{};\n"},
    ExtraRow{"view", "break",
             "  /// long stretches of constant section are left out\n"
             "  bool automatic_breaks = false;\n"},
};

// Words of the language cannot be names.
std::string member_of(const std::string& key) {
  if (key == "break") return "breaks";
  if (key == "template") return "sheet_template";
  return key;
}

// "epura::HiddenLines" -> "HiddenLines", if programs see it: none of epura::scene.
std::optional<std::string> public_enum(const OptionInfo& key) {
  constexpr std::string_view space = "epura::";
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(key.type.name(), nullptr, nullptr, &status), &std::free);
  if (!key.form.is_closed || status != 0 || !std::string_view(name.get()).starts_with(space)) return std::nullopt;
  const std::string rest(name.get() + space.size());
  return rest.find(':') == std::string::npos ? std::optional(rest) : std::nullopt;
}

/// The type of a member; empty, with a message, if there is none.
std::string type_of(const OptionInfo& key) {
  const auto row = std::find_if(types.begin(), types.end(), [&key](const TypeRow& one) { return one.of == key.type; });
  if (row != types.end()) return row->has_empty ? row->name : "std::optional<" + std::string(row->name) + ">";
  if (const std::optional<std::string> name = public_enum(key)) return "std::optional<" + *name + ">";
  std::fprintf(stderr, "make_scene_header: '%s' is a '%s', which has no type in C++\n", key.key.c_str(),
               key.form.name.c_str());
  return {};
}

// A comment of lines that are not too long.
std::string comment(const std::string& margin, const std::string& text) {
  constexpr std::size_t width = 120;
  std::string lines, line = margin + "///";
  for (const std::string_view word : epura::split(text, ' ')) {
    if (line.size() + 1 + word.size() > width) {
      lines += line + "\n";
      line = margin + "///";
    }
    line += " " + std::string(word);
  }
  return lines + line + "\n";
}

// Numbers have units and ranges.
std::string meaning_of(const OptionInfo& key, const std::string& type) {
  const bool is_number = type.find("<double") != std::string::npos || type.find("<int") != std::string::npos;
  return key.help + (is_number ? "; " + key.form.name : "") + (key.required ? "; required" : "") +
         (key.usual.empty() ? "" : "; by default: " + key.usual);
}

/// A member that is an option.
struct Member {
  std::string key, name;
};

std::string visitor_of(std::string_view type, const std::vector<Member>& members) {
  std::string text = "\ntemplate <MaybeConst<" + std::string(type) + "> Part, class Visit>\n" +
                     "void each_option(Part& part, const Visit& visit) {\n";
  for (const auto& [key, name] : members) text += "  visit(\"" + key + "\", \"" + name + "\", part." + name + ");\n";
  return text + "}\n";
}

bool append_struct(std::string& header, const PartRow& part, const std::vector<OptionInfo>& keys) {
  std::vector<Member> members;
  header += "\n" + comment("", std::string(part.meaning)) + "struct " + std::string(part.type) + " {\n";
  bool is_sound = true;
  for (const OptionInfo& key : keys) {
    const std::string type = type_of(key);
    is_sound = is_sound && !type.empty();
    header += comment("  ", meaning_of(key, type));
    header += "  " + type + " " + members.emplace_back(Member{key.key, member_of(key.key)}).name + "{};\n";
    for (const ExtraRow& extra : extras)
      if (extra.section == part.section && extra.after == key.key) header += extra.declaration;
  }
  header += "};\n" + visitor_of(part.type, members);
  return is_sound;
}

void append_scene(std::string& header, const std::vector<SceneSection>& sections) {
  std::vector<Member> members;
  header += "\n/// Everything that is drawn. Without views: one isometric view.\nstruct Scene {\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string type(parts[i].type), name(parts[i].member);
    header += "  " +
              (sections[i].is_list    ? "std::vector<" + type + ">"
               : type == "TitleBlock" ? type
                                      : "std::optional<" + type + ">") +
              " " + name + "{};\n";
    members.push_back({sections[i].name, name});
  }
  header += "};\n" + visitor_of("Scene", members);
}

/// Whether the sections are those of the table, in its order.
bool are_in_table(const std::vector<SceneSection>& sections) {
  const bool same = std::equal(sections.begin(), sections.end(), parts.begin(), parts.end(),
                               [](const SceneSection& one, const PartRow& part) { return one.name == part.section; });
  if (!same) std::fputs("make_scene_header: its table of parts is not that of the sections of scene files\n", stderr);
  return same;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::vector<SceneSection> sections = scene_sections();
  if (!are_in_table(sections)) return 1;
  std::string header = head;
  bool is_sound = true;
  for (std::size_t i = 0; i < sections.size(); ++i)
    if (!parts[i].meaning.empty()) is_sound = append_struct(header, parts[i], sections[i].keys) && is_sound;
  append_scene(header, sections);
  header += "\n}  // namespace epura\n";
  if (!is_sound) return 1;
  std::filesystem::create_directories(std::filesystem::path(arguments[1]).parent_path());
  // An equal file keeps its time, so that nothing is compiled anew.
  if (!std::filesystem::exists(arguments[1]) || epura::read_file(arguments[1]) != header)
    epura::write_file(arguments[1], header);
  return 0;
}
