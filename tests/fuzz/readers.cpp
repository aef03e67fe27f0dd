// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line_options.hpp"
#include "app/draw_options.hpp"
#include "app/jobs/job_table.hpp"
#include "app/jobs/placeholders.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "batch/manifest.hpp"
#include "batch/shards.hpp"
#include "compare/comparison.hpp"
#include "compare/read_pictures.hpp"
#include "importer/assemble.hpp"
#include "importer/loader.hpp"
#include "importer/read_model.hpp"
#include "mesh/read.hpp"
#include "own_file.hpp"
#include "scene/choices.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/details.hpp"
#include "scene/role_styles.hpp"
#include "scene/scene_file.hpp"
#include "scene/transform.hpp"
#include "shapes.hpp"
#include "sheet/form.hpp"
#include "surfaces/declared_part.hpp"
#include "targets.hpp"
#include "views/shortcuts.hpp"

namespace epura::fuzz {

namespace {

void expect_sound(const mesh::Mesh& mesh) {
  const auto points = static_cast<int>(mesh.points.size());
  for (std::size_t t = 0; t < mesh.polygon.size(); ++t)
    for (const int v : mesh.triangle(static_cast<int>(t)))
      check(v >= 0 && v < points && finite(mesh.point(v)), "a triangle has a corner that is no point");
  for (const mesh::MeshEdge& edge : mesh.edges)
    check(edge.count == static_cast<int>(mesh.triangles_of(edge).size()), "an edge miscounts its triangles");
}

void read_mesh_format(const std::string& bytes, const char* format) {
  expect_sound(mesh::make_mesh(mesh::format_named(format)->read(bytes, "model", {}), "model"));
}

void read_obj(const std::string& bytes) { read_mesh_format(bytes, "obj"); }
void read_stl(const std::string& bytes) { read_mesh_format(bytes, "stl"); }
void read_ply(const std::string& bytes) { read_mesh_format(bytes, "ply"); }
void read_off(const std::string& bytes) { read_mesh_format(bytes, "off"); }

void expect_sound(const surfaces::PartFaces& part, const mesh::Mesh& mesh) {
  check(part.face_of_triangle.size() == mesh.polygon.size() && part.border_of_edge.size() == mesh.edges.size(),
        "a part has not as many triangles and edges as its mesh");
  for (const int face : part.face_of_triangle)
    check(face >= 0 && face < static_cast<int>(part.faces.size()), "a triangle has no face");
}

// Surfaces that a file declares need not be those of its facets: they are drawn all the same.
void draw_part(mesh::Mesh mesh, surfaces::PartFaces part) {
  constexpr int max_triangles = 100;
  if (mesh.triangle_count() == 0 || mesh.triangle_count() > max_triangles) return;
  std::vector<world::Placed> models(1);
  models.front().mesh = std::make_shared<const mesh::Mesh>(std::move(mesh));
  models.front().part = std::make_shared<const surfaces::PartFaces>(std::move(part));
  const test::Result drawn = test::draw(world::make_world(std::move(models)), test::orthographic({1, 2, 3}));
  for (const drawing::Segment& segment : drawn.drawing.segments)
    check(std::isfinite(segment.from.x + segment.from.y + segment.to.x + segment.to.y),
          "a line ends at a point that is not finite");
}

void build(const importer::Document& document) {
  importer::expect_sound(document);
  importer::Assembled assembled = importer::assemble(document, "fuzz");
  mesh::Mesh mesh = mesh::make_mesh(std::move(assembled.soup), "model");
  expect_sound(mesh);
  if (assembled.part.faces.empty()) return;
  surfaces::PartFaces part = surfaces::part_of(mesh, assembled.part, surfaces::RecogniseOptions().tangent_angle);
  expect_sound(part, mesh);
  draw_part(std::move(mesh), std::move(part));
}

// Importers run in this process, where their faults are seen.
void read_by(const std::vector<importer::LoadedImporter>& importers, const std::string& bytes) {
  const OwnFile file(bytes);
  const auto& [table, definition] = importers.front();
  const std::vector<double> values = foreign::flattened(foreign::default_values(table.parameters));
  build(importer::read_by(*definition, {file.path(), "model", values}, [](double) {}));
}

void read_gltf(const std::string& bytes) {
  static const auto importers = importer::load_importers(EPURA_FUZZ_IMPORTERS "/gltf.so");
  read_by(importers, bytes);
}

void read_threemf(const std::string& bytes) {
  static const auto importers = importer::load_importers(EPURA_FUZZ_IMPORTERS "/3mf.so");
  read_by(importers, bytes);
}

void read_answer(const std::string& bytes) {
  foreign::Unpacker unpack(bytes);
  build(importer::unpack_document(unpack));
}

void read_scene(const std::string& bytes) {
  const OwnFile file(bytes);
  scene::read_scene_file(file.path());
}

// The first byte selects what the other ones are a value of.
void read_words(const std::string& bytes) {
  using Read = void (*)(const std::string& text);
  static constexpr std::array<Read, 11> reads{
      [](const std::string& text) { scene::parse_scale(text, "--scale"); },
      [](const std::string& text) { scene::parse_paper_size(text, "--sheet"); },
      [](const std::string& text) { scene::parse_break(text, "--break"); },
      [](const std::string& text) {
        const std::string again = scene::parse_request(text).text();
        check(scene::parse_request(again).text() == again, "a projection is written in two ways");
      },
      [](const std::string& text) { scene::parse_section(text, "--section"); },
      [](const std::string& text) { scene::parse_detail(text, "--detail"); },
      [](const std::string& text) { scene::parse_transform(text); },
      [](const std::string& text) { importer::parse_model_request(text); },
      [](const std::string& text) { expect_known_placeholders(text, "--output"); },
      [](const std::string& text) { parse_shard(text); },
      [](const std::string& text) { pipeline::parse_shortcuts(text); }};
  if (!bytes.empty()) reads[static_cast<unsigned char>(bytes.front()) % reads.size()](bytes.substr(1));
}

// A command line of `epura draw`: words between line ends.
void read_options(const std::string& bytes) {
  CLI::App app("", "epura");
  const scene::Options<DrawOptions> options = draw_options();
  for (const scene::OptionInfo& option : options) epura::define(app, option);
  std::vector<std::string> words;
  for (const std::string_view word : split(bytes, '\n'))
    words.emplace(words.begin(), word);  // CLI11 wants them reversed
  try {
    app.parse(words);
  } catch (const CLI::CallForHelp&) {
    return;
  } catch (const CLI::ParseError& error) {
    refuse_wrong_use(app, error);
  }
  DrawOptions draw;
  epura::read_options(app, options, draw);
}

// Frames and title blocks, and the logos in them.
void read_template(const std::string& bytes) {
  static const sheet::Lettering lettering;
  const OwnFile file(bytes);
  const std::string title(60, 'W');
  const sheet::TitleBlock block{{{"title", title}, {"number", "7"}, {"owner", title}}, "1:2", "A3"};
  sheet::draw_form(*sheet::read_form({file.path(), "--template"}), block, lettering);
}

void read_logo(const std::string& bytes) {
  const OwnFile file(bytes, bytes.starts_with("\x89") ? ".png" : ".svg");
  sheet::draw_logo(*sheet::read_logo({file.path(), "--logo"}), {{0, 0}, {30, 10}});
}

void read_style(const std::string& bytes) {
  const OwnFile file(bytes);
  scene::read_role_styles({file.path(), "--style"});
}

void read_records(const std::string& bytes) {
  const OwnFile file(bytes);
  epura::read_manifest(file.path());
}

void read_jobs(const std::string& bytes) {
  const OwnFile file(bytes);
  epura::read_job_table(file.path());
}

// A drawing is equal to itself.
void read_drawing(const std::string& bytes, const char* name) {
  const compare::PictureFile file = compare::pictures_of(bytes, name);
  check(compare::compare(file, file, 0.01).differences.empty(), "a drawing differs from itself");
}

void read_json(const std::string& bytes) { read_drawing(bytes, "drawing.json"); }
void read_svg(const std::string& bytes) { read_drawing(bytes, "drawing.svg"); }
void read_pdf(const std::string& bytes) { read_drawing(bytes, "drawing.pdf"); }

}  // namespace

std::span<const Target> readers() {
  static constexpr std::array<Target, 18> all{{{"obj", read_obj},
                                               {"stl", read_stl},
                                               {"ply", read_ply},
                                               {"off", read_off},
                                               {"gltf", read_gltf},
                                               {"3mf", read_threemf},
                                               {"answer", read_answer},
                                               {"scene", read_scene},
                                               {"words", read_words},
                                               {"options", read_options},
                                               {"template", read_template},
                                               {"logo", read_logo},
                                               {"style", read_style},
                                               {"jobs", read_jobs},
                                               {"records", read_records},
                                               {"json", read_json},
                                               {"svg", read_svg},
                                               {"pdf", read_pdf}}};
  return all;
}

}  // namespace epura::fuzz
