// SPDX-License-Identifier: Apache-2.0
// Scenes through the whole pipeline: models, views, sections, annotations, sheets, and every format.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "compare/comparison.hpp"
#include "compare/read_pictures.hpp"
#include "composition/tell.hpp"
#include "mesh/read.hpp"
#include "output/format.hpp"
#include "own_file.hpp"
#include "own_projections.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/targets.hpp"
#include "report/format.hpp"
#include "scene/scene_file.hpp"
#include "solids.hpp"
#include "targets.hpp"

namespace epura::fuzz {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_sheet(const std::string& reason) { throw Error(ErrorKind::input, "scene", reason); }

/// What scenes may name, by the last part of the name: small models, forms, logos and styles of the samples and of the
/// golden drawings.
const std::map<std::string, fs::path>& known_files() {
  static const std::map<std::string, fs::path> files = [] {
    constexpr std::uintmax_t most = 110'000;  // bytes; larger models take too long
    std::map<std::string, fs::path> found;
    for (const char* folder : {"/tests/golden/models", "/tests/golden/sheet-template",
                               "/tests/golden/sheet-line-styles", "/samples/models", "/samples/frames"})
      for (const auto& file : fs::directory_iterator(EPURA_FUZZ_ROOT + std::string(folder)))
        if (file.file_size() <= most) found.emplace(file.path().filename().string(), file.path());
    return found;
  }();
  return files;
}

fs::path known_file(const std::string& name) {
  const auto found = known_files().find(fs::path(name).filename().string());
  if (found == known_files().end()) refuse_sheet("unknown file");
  return found->second;
}

// In memory: no part of the input is a path.
void find_model(scene::ModelDescription& model) {
  constexpr std::string_view made = "made:";
  if (model.file->starts_with(made)) {
    if (!model.name.given()) model.name = {"made", model.file.where};
    model.soup = std::make_shared<const mesh::Soup>(made_model(model.file->substr(made.size())));
    model.file = {};
    return;
  }
  const std::size_t name_end = std::min(model.file->find(':'), model.file->size());
  const std::string parameters = model.file->substr(name_end);
  const fs::path file = known_file(model.file->substr(0, name_end));
  // Every step of a subdivision makes four times as many triangles.
  constexpr std::uintmax_t max_to_divide = 6000;  // bytes
  if (!parameters.empty() &&
      (fs::file_size(file) > max_to_divide || parameters.find_first_of("3456789") != parameters.npos))
    refuse_sheet("too much for a fuzzer");
  if (mesh::format_named(file.extension().string().substr(1)) == nullptr) refuse_sheet("no mesh");
  model.file.value = file.string() + parameters;
  model.content = std::make_shared<const std::string>(read_file(file));
}

void find_files(scene::SheetDescription& sheet) {
  for (scene::LocatedText* file : {&sheet.form, &sheet.logo, &sheet.style})
    if (file->given()) file->value = known_file(**file).string();
  if (sheet.font.given() && scene::names_font_file(*sheet.font)) refuse_sheet("a font of its own");
}

scene::SceneDescription sheet_scene_of(const std::string& text) {
  constexpr std::size_t max_models = 6, max_views = 10, max_sheets = 4;
  const OwnFile file(text);
  scene::SceneDescription scene = scene::scene_of(scene::read_toml(file.path()));
  if (scene.models.size() > max_models || scene.sheets.size() > max_sheets) refuse_sheet("too much for a fuzzer");
  for (scene::ModelDescription& model : scene.models) find_model(model);
  for (scene::SheetDescription& sheet : scene.sheets) find_files(sheet);
  pipeline::complete_scene(scene);
  pipeline::complete_sheets(scene);
  if (scene.views.size() > max_views) refuse_sheet("too much for a fuzzer");
  const std::vector<projection::ProjectionEntry>& known = own_projections();
  for (const scene::ViewDescription& view : scene.views)
    if (view.projection.given() && std::none_of(known.begin(), known.end(),
                                                [&](const auto& entry) { return entry.name == view.projection->name; }))
      refuse_sheet("unknown projection");
  return scene;
}

/// The letters of the first line.
struct Wishes {
  std::string letters;

  [[nodiscard]] bool has(char letter) const { return letters.find(letter) != letters.npos; }

  [[nodiscard]] pipeline::RunOptions run() const {
    pipeline::RunOptions run;
    run.projections = own_projections();
    run.threads = 1;
    run.keeps_drawings = true;
    run.verify = has('v');
    constexpr int samples = 100;
    run.verify_samples = samples;
    if (has('a')) run.arcs = 0.1;
    run.centre_lines = has('c');
    run.judges = has('j');
    run.error_note = has('n');
    run.lint = has('l');
    run.line_facts = has('f');
    run.explain = has('x');
    if (has('w')) run.visibility = pipeline::Visibility::none;
    if (has('t')) run.contact = 1e-3;
    if (has('m')) run.max_error = 0.05;
    if (has('L')) run.time_limit = 0.04;
    if (has('e')) run.dump = pipeline::DumpTable::edges;
    if (has('s')) run.dump = pipeline::DumpTable::spans;
    for (const char* const question : {"@100,100", "@150,80"})
      if (has('q')) run.why.push_back(explain::parse_edge_question(question));
    return run;
  }

  [[nodiscard]] output::VectorOptions vector() const {
    output::VectorOptions vector;
    vector.plain = has('p');
    constexpr double coarse = 20;
    vector.dpi = coarse;
    if (has('d')) vector.decimals = 2;
    if (has('g')) vector.text = SvgText::text;
    vector.dxf_blocks = has('b');
    vector.dxf_entities = {has('D'), has('H'), has('D'), has('H'), has('D')};
    if (has('E')) vector.dxf_arcs = output::DxfArcs::entities;
    if (has('O')) vector.dxf_version = output::DxfVersion::r2000;
    return vector;
  }
};

pipeline::DrawnScene draw(const scene::SceneDescription& scene, const pipeline::RunOptions& run) {
  const pipeline::Messages silent = pipeline::silent_messages();
  pipeline::Stopwatch watch;
  ProgressBoard board;
  try {
    return pipeline::draw_scene(scene, run, {silent, Progress(board, run.time_limit), watch});
  } catch (const OutOfTime& cut) {
    throw pipeline::nothing_drawn(cut.stage);
  }
}

// What is drawn can be written; a picture of pixels may be too large.
std::vector<pipeline::FileBytes> files_of(const pipeline::DrawnScene& drawn, std::string_view format,
                                          const output::VectorOptions& options) {
  const std::string path = "drawing." + std::string(format);
  try {
    return pipeline::encode_all({{path, output::find_format(format)}}, drawn.sheets, options, drawn.report, {});
  } catch (const Error& error) {
    check(format == "png", error.what());
    return {};
  }
}

std::string encoded(const pipeline::DrawnScene& drawn, std::string_view format, const output::VectorOptions& options) {
  std::string bytes;
  for (const pipeline::FileBytes& file : files_of(drawn, format, options)) bytes += file.bytes;
  return bytes;
}

// What is written can be read, and is equal to itself.
void expect_readable(const pipeline::DrawnScene& drawn, std::string_view format, const output::VectorOptions& options) {
  for (const pipeline::FileBytes& file : files_of(drawn, format, options)) {
    try {
      const compare::PictureFile picture = compare::pictures_of(file.bytes, file.path);
      check(compare::compare(picture, picture, 0.01).differences.empty(), "a drawing differs from itself");
    } catch (const Error& error) {
      check(false, error.what());
    }
  }
}

// A first line of letters, and a scene file.
void draw_sheets(const std::string& bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size());
  const Wishes wishes{bytes.substr(0, end)};
  const scene::SceneDescription scene = sheet_scene_of(bytes.substr(end));
  const pipeline::RunOptions run = wishes.run();
  const output::VectorOptions vector = wishes.vector();
  const pipeline::DrawnScene drawn = draw(scene, run);
  if (const auto& found = drawn.report.verification; found)
    check(found->is_right(), report::format_verification(*found).c_str());
  for (const std::string_view format : {"svg", "json", "pdf"}) expect_readable(drawn, format, vector);
  if (wishes.has('F'))
    for (const std::string_view format : {"ps", "eps", "png", "dxf", "html"}) encoded(drawn, format, vector);

  pipeline::RunOptions other = run;
  other.verify = false;
  if (wishes.has('T')) other.threads = 3;
  if (wishes.has('S')) other.plan = pipeline::parse_shortcuts("none");
  if (!wishes.has('L') && (wishes.has('T') || wishes.has('S')))
    check(encoded(draw(scene, other), "svg", vector) == encoded(drawn, "svg", vector),
          "threads or shortcuts change the drawing");
}

}  // namespace

std::span<const Target> sheets() {
  static constexpr std::array<Target, 1> all{{{"sheets", draw_sheets}}};
  return all;
}

}  // namespace epura::fuzz
