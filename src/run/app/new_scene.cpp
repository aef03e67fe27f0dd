// SPDX-License-Identifier: Apache-2.0
// epura new-scene MODEL: a scene file with what the model has, to be edited. Lines that begin with "# " are words,
// those that begin with "#" alone are proposals.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/run_epura.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "importer/read_model.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/recognise_parts.hpp"
#include "sizes/own_frame.hpp"
#include "surfaces/numbers.hpp"

namespace epura {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_holes = 20, max_lines = 40;  // lines that a person reads
constexpr int position_digits = 7;                     // of positions
constexpr double position_step = 1e-6;                 // mm; what is below is left by computing

/// A hole in the world, in mm, and the numbers of all that are like it.
struct EqualHoles {
  surfaces::Hole first;
  std::vector<int> numbers{};

  [[nodiscard]] std::string name() const { return "hole " + std::to_string(numbers.front()); }
};

// TOML 1.0: a basic string.
std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : one_line(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string triple(const Vec3& p) {
  const auto text_of = [](double place) {
    return format_rounded(std::round(place / position_step) * position_step, position_digits);
  };
  return "[" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + "]";
}

std::string axis_of(const surfaces::Hole& hole) {
  const Vec3 axis = glm::abs(glm::normalize(hole.to - hole.from));
  constexpr double along = 1 - 1e-9;
  for (int i = 0; i < 3; ++i)
    if (axis[i] > along) return std::string("along ") + "xyz"[i];
  return "along an axis that is none of the world";
}

// In the order of their numbers.
std::vector<surfaces::Hole> holes_in_world(const world::Placed& placed, const surfaces::PartFaces& part) {
  const auto scale = surfaces::similarity_scale(placed.to_world);
  if (!scale) return {};
  const std::vector<surfaces::Hole> found = surfaces::find_holes(*placed.mesh, part);
  std::vector<surfaces::Hole> holes;
  for (const int number : surfaces::numbered_holes(found)) holes.push_back(found[static_cast<std::size_t>(number)]);
  for (surfaces::Hole& hole : holes) {
    for (double& diameter : hole.diameters) diameter *= *scale;
    for (Vec3* end : {&hole.from, &hole.to}) *end = Vec3(placed.to_world * Vec4(*end, 1));
  }
  return holes;
}

// The most frequent ones first, then the largest.
std::vector<EqualHoles> groups_of(const std::vector<surfaces::Hole>& holes) {
  const auto text_of = [](const surfaces::Hole& hole) {
    std::string text = axis_of(hole) + (hole.through ? "t" : format_rounded(glm::distance(hole.from, hole.to), 4));
    for (const double diameter : hole.diameters) text += " " + format_rounded(diameter, 4);
    return text;
  };
  std::vector<std::pair<std::string, EqualHoles>> groups;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string text = text_of(holes[i]);
    auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == text; });
    if (same == groups.end()) same = groups.insert(groups.end(), {text, {holes[i]}});
    same->second.numbers.push_back(static_cast<int>(i) + 1);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second.numbers.size(), a.second.first.diameters.back()) >
           std::pair(b.second.numbers.size(), b.second.first.diameters.back());
  });
  std::vector<EqualHoles> equal;
  for (auto& [text, group] : groups) equal.push_back(std::move(group));
  return equal;
}

std::string hole_text(const EqualHoles& group) {
  const surfaces::Hole& hole = group.first;
  const std::size_t count = group.numbers.size();
  std::string text = "# " + surfaces::numbers_text("hole", group.numbers) + ": ";
  if (count > 1) text += std::to_string(count) + " x ";
  for (std::size_t i = 0; i < hole.diameters.size(); ++i)
    text += (i > 0 ? " and " : "") + std::string("Ø") + format_rounded(hole.diameters[i], 5);
  text += hole.through ? ", through" : ", " + format_rounded(glm::distance(hole.from, hole.to), 5) + " deep";
  text +=
      ", " + axis_of(hole) + (count > 1 ? ", the first one" : "") + " from " + triple(surfaces::mouth_of(hole)) + "\n";
  return text + "#[[dimension]]\n#type = \"diameter\"\n#at = \"" + group.name() + "\"\n#tolerance = \"H7\"\n";
}

std::string holes_text(const std::vector<EqualHoles>& groups) {
  if (groups.empty()) return "";
  std::string text =
      "\n# Holes. A tolerance belongs to a dimension of its own; a thread: [[thread]], thread = \"M6\".\n";
  for (std::size_t i = 0; i < std::min(groups.size(), max_holes); ++i) text += hole_text(groups[i]);
  if (groups.size() > max_holes)
    text += "# and " + std::to_string(groups.size() - max_holes) + " more kinds: epura info lists them\n";
  return text;
}

// Through the largest hole, or the middle of the model.
std::string section_text(const std::vector<EqualHoles>& groups, const Box& box) {
  const auto largest = std::max_element(groups.begin(), groups.end(), [](const EqualHoles& a, const EqualHoles& b) {
    return a.first.diameters.back() < b.first.diameters.back();
  });
  const bool has_hole = largest != groups.end();
  const std::string point = has_hole ? toml_text(largest->name()) : triple(box.centre());
  return std::string("\n# A section through ") + (has_hole ? "the largest hole" : "the middle") +
         ". The side to which the normal points is removed.\n#[[section]]\n#name = \"A\"\n#point = " + point +
         "\n#normal = [0, -1, 0]\n#[[view]]\n#projection = \"front\"\n#name = \"section\"\n#section = \"A\"\n";
}

// Points of faces, for dimensions, details and leaders.
std::string faces_text(const world::Placed& placed, const surfaces::PartFaces& part) {
  const std::vector<Vec3> middles = surfaces::middles_of_faces(*placed.mesh, part);
  const std::vector<int> order = surfaces::numbered_faces(part, middles);
  if (order.empty()) return "";
  std::string text = "\n# Faces and their middles. They are points as holes are: from = \"face 1\", to = \"hole 1\".\n";
  for (std::size_t i = 0; i < std::min(order.size(), max_lines); ++i) {
    const auto face = static_cast<std::size_t>(order[i]);
    text += "# face " + std::to_string(i + 1) + ": " +
            surfaces::surface_kind_names[static_cast<std::size_t>(part.faces[face].surface.kind)] + ", " +
            triple(Vec3(placed.to_world * Vec4(middles[face], 1))) + "\n";
  }
  if (order.size() > max_lines)
    text += "# and " + std::to_string(order.size() - max_lines) + " more: epura info --json lists them\n";
  return text;
}

std::string bodies_text(const mesh::MeshReport& report) {
  if (report.bodies < 2) return "";
  std::string text = "\n# Bodies: " + std::to_string(report.bodies) +
                     ". What is left whole in sections, such as bolts, has cut = false.\n";
  for (std::size_t i = 0; i < std::min(report.body_names.size(), max_lines); ++i)
    text += "#[[style]]\n#match = " + toml_text(report.body_names[i]) + "\n#cut = false\n";
  if (report.body_names.size() > max_lines)
    text += "# and " + std::to_string(report.body_names.size() - max_lines) + " more: epura info lists them\n";
  return text + "#[[explode]]\n#factor = 1.5\n#[parts_list]\n";
}

std::string views_text() {
  std::string text = "\n# Views: 'epura plugins' lists the projections.\n";
  for (const char* name : {"front", "top", "left", "isometric"})
    text += std::string("[[view]]\nprojection = \"") + name + "\"\n";
  return text;
}

// Of a part that lies askew: in that place all positions are along its own axes.
std::string transform_text(const scene::Located<Mat4>& turn) {
  if (!turn.given()) return "\n#transform = \"rotate:z,0\"\n";
  return "\n# It lies askew in its file.\ntransform = " + toml_text(sheet::words_of_turn(*turn)) + "\n";
}

std::string scene_text(const std::string& file, const world::World& world, const scene::Located<Mat4>& turn) {
  const world::Placed& placed = world.models.front();
  const surfaces::PartFaces part = placed.part != nullptr ? *placed.part : surfaces::recognise_faces(*placed.mesh);
  const std::vector<EqualHoles> groups = groups_of(holes_in_world(placed, part));
  const Vec3 size = world.box.size();
  const std::string name = fs::path(importer::parse_model_request(file).path).stem().string();
  return "# " + one_line(file) + ": " + format_rounded(size.x, 5) + " x " + format_rounded(size.y, 5) + " x " +
         format_rounded(size.z, 5) + " mm, from " + triple(world.box.min) + " to " + triple(world.box.max) +
         "\n# docs/scenes.md has all keys. Lines with # and no blank are proposals: remove the #.\n\n[[model]]\nfile "
         "= " +
         toml_text(file) + "\n#unit = \"mm\"" + transform_text(turn) + views_text() + section_text(groups, world.box) +
         "\n[[dimension]]\ntype = \"auto\"\n" + holes_text(groups) + faces_text(placed, part) +
         bodies_text(placed.mesh->report) +
         "\n[[sheet]]\nsize = \"A3\"\n#scale = \"auto\"\n\n[title_block]\ntitle = " + toml_text(name) +
         "\n#owner = \"\"\n#number = \"\"\n";
}

fs::path output_of(const NewSceneOptions& options, const fs::path& model) {
  fs::path output = options.output.empty() ? fs::path(model).replace_extension(".toml") : fs::path(options.output);
  std::error_code error;
  if (fs::exists(fs::symlink_status(output, error)))
    throw Error(ErrorKind::input, output.string(), "exists already", "choose another name by -o, or remove it");
  if (!lies_below(model, output.parent_path()))
    throw Error(ErrorKind::input, output.string(), "a scene file names models below its own folder alone",
                "write it into the folder of " + model.string() + ", or one above");
  return output;
}

}  // namespace

int new_scene(const NewSceneOptions& options) {
  const fs::path model = importer::parse_model_request(options.model).path;
  if (model == importer::standard_input)
    throw Error(ErrorKind::input, options.model, "has no name that a scene could have", "name a file");
  const fs::path output = output_of(options, model);
  scene::SceneDescription scene;
  scene.models.emplace_back().file = {options.model, options.model};
  scene.dimensions.emplace_back().type = {DimensionType::automatic, options.model};
  pipeline::complete_scene(scene);
  pipeline::RunOptions run;
  run.plugin_path = options.plugin_path;
  const pipeline::Messages silent = pipeline::silent_messages();
  report::Report report;
  world::World world = pipeline::read_models(scene, pipeline::reading_of(scene, run), report.meshes, silent, {}).world;
  pipeline::recognise_parts(world, scene, run, report, {});
  pipeline::turn_to_own_axes(world, scene, silent);
  const std::string parameters = options.model.substr(model.string().size());
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  const std::string file = fs::proximate(model, folder).generic_string() + parameters;
  write_file(output, scene_text(file, world, scene.models.front().transform));
  std::fputs(printable(output.string() + "\n\nTo draw it:\n  epura draw " + for_shell(output.string()) + " -o " +
                       for_shell(fs::path(output).replace_extension(".pdf").string()) + "\n")
                 .c_str(),
             stdout);
  return 0;
}

}  // namespace epura
