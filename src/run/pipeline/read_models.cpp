// SPDX-License-Identifier: Apache-2.0
#include "pipeline/read_models.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "composition/layout.hpp"
#include "features/unit_guess.hpp"
#include "importer/read_model.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/read.hpp"
#include "pipeline/item_names.hpp"
#include "pipeline/kept_models.hpp"
#include "scene/body_styles.hpp"
#include "scene/choices.hpp"
#include "scene/transform.hpp"
#include "sheet/paper.hpp"
#include "views/choose.hpp"
#include "world/expect_usable.hpp"

namespace epura::pipeline {

namespace {

// `mesh` without its edges and triangles, with the triangles `kept`.
mesh::Mesh with_triangles(mesh::Mesh& mesh, const std::vector<int>& kept) {
  mesh::Mesh part;
  for (const int t : kept) {
    for (const int corner : mesh.triangle(t)) part.corners.push_back(corner);
    part.polygon.push_back(mesh.polygon[t]);
    part.body.push_back(mesh.body[t]);
  }
  part.points = std::move(mesh.points);
  part.report = std::move(mesh.report);
  mesh::make_edges(part, mesh::wires_of(mesh));
  return part;
}

/// Removes the triangles of the bodies that are marked. Vertices, faces of the file and bodies keep their numbers, and
/// the report remains that of the file. Lines that bound no face belong to no body and stay.
void omit_bodies(importer::ReadModel& model, const std::vector<bool>& omitted) {
  mesh::Mesh whole = std::move(model.mesh);
  std::vector<int> kept;
  for (int t = 0; t < whole.triangle_count(); ++t)
    if (!omitted[static_cast<std::size_t>(whole.body[t])]) kept.push_back(t);
  model.mesh = with_triangles(whole, kept);
  if (model.part == nullptr) return;
  auto part = std::make_shared<surfaces::PartFaces>(*model.part);
  part->face_of_triangle.clear();
  part->border_of_edge.clear();
  for (const int t : kept) part->face_of_triangle.push_back(model.part->face_of_triangle[t]);
  for (const mesh::MeshEdge& edge : model.mesh.edges) {
    const auto number = whole.edge_between(edge.vertex) - whole.edges.data();
    part->border_of_edge.push_back(model.part->border_of_edge[static_cast<std::size_t>(number)]);
  }
  model.part = std::move(part);
}

bool is_drawn(const scene::ModelDescription& model) { return model.drawn.value_or(true); }

KeptModel without_mesh(importer::ReadModel model) {
  auto mesh = std::make_shared<const mesh::Mesh>(std::move(model.mesh));
  model.mesh = {};
  return {std::move(mesh), std::move(model)};
}

// Leaves out the bodies that are not to be drawn.
KeptModel leave_out(KeptModel model, const std::vector<scene::StyleDescription>& styles) {
  std::vector<bool> omitted;
  for (const scene::StyleDescription& style : styles) omitted.push_back(!style.drawn.value_or(true));
  if (std::find(omitted.begin(), omitted.end(), true) == omitted.end()) return model;
  model.rest.mesh = *model.mesh;
  omit_bodies(model.rest, omitted);
  return without_mesh(std::move(model.rest));
}

// Without a power of ten, if it is legible so.
std::string size_text(double size) {
  return size < 1e3 || size > 1e9 ? format_rounded(size, 4) : format_fixed(size, 0);
}

// An upper bound for the factor by which the model's transform multiplies lengths.
double enlargement_of(const scene::ModelDescription& model) {
  if (!model.transform.given()) return 1;
  const Mat3 linear(*model.transform);
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += glm::dot(linear[i], linear[i]);
  return sum > 0 ? std::sqrt(sum) : 1;
}

// If a scene file names the model, reading errors state where.
importer::ReadModel read_file(const scene::ModelDescription& model, const importer::ReadOptions& options,
                              const Progress& progress) {
  const auto read_it = [&](const std::string& file) {
    if (model.content != nullptr) return importer::read_model(*model.content, file, model.import, options, progress);
    return importer::read_model(file, model.import, options, progress);
  };
  return model.file.where == *model.file ? read_it(*model.file) : at_place(model.file, read_it);
}

const KeptModel& read(const scene::ModelDescription& model, importer::ReadOptions options, KeptModels& kept,
                      const Progress& progress) {
  options.tolerance /= enlargement_of(model);
  const ReadingKey key{*model.file, model.import, options.tolerance, options.relative_tolerance};
  const auto known = kept.models.find(key);
  if (known != kept.models.end()) return known->second;
  return kept.models.emplace(key, without_mesh(read_file(model, options, progress))).first->second;
}

// What is in memory has no name of its own by which it might be known.
KeptModel model_of(const scene::ModelDescription& model, const Reading& reading, KeptModels& kept,
                   const Progress& progress) {
  if (!is_drawn(model)) return without_mesh({});
  if (model.soup != nullptr) return without_mesh({mesh::make_mesh(*model.soup, *model.name, progress)});
  if (model.content == nullptr) return read(model, reading.options, kept, progress);
  KeptModels own;
  return read(model, reading.options, own, progress);
}

// The largest paper on which the views may be drawn. A drawing without a paper size is made as large as fits on A4.
sheet::Paper largest_paper(const scene::SheetDescription& sheet, std::size_t views) {
  scene::PaperChoice size = largest_size(sheet, views);
  if (size.kind == scene::PaperChoice::Kind::none) size = {};
  return sheet::make_paper(size, false);
}

const scene::SheetDescription& sheet_of(const scene::SceneDescription& scene, const scene::ViewDescription& view) {
  const auto number = static_cast<std::size_t>(view.sheet.value_or(1)) - 1;
  return scene.sheets[std::min(number, scene.sheets.size() - 1)];
}

scene::ScaleChoice scale_of(const scene::SceneDescription& scene, const scene::ViewDescription& view) {
  return view.scale.value_or(sheet_of(scene, view).scale.value_or({}));
}

// The diagonal of the largest paper on which a view may be drawn, mm.
double paper_for(const scene::SceneDescription& scene, const scene::ViewDescription& view) {
  const sheet::Paper paper = largest_paper(sheet_of(scene, view), scene.views.size());
  return std::hypot(paper.width, paper.height);
}

// In the units of read_model; 0 if it is unknown, as for a pipe.
std::size_t work_of(const std::vector<scene::ModelDescription>& models) {
  std::size_t bytes = 0;
  std::set<std::string> files;
  for (const scene::ModelDescription& model : models) {
    std::error_code kind;
    if (is_drawn(model) && model.content != nullptr)
      bytes += 2 * model.content->size();
    else if (is_drawn(model) && model.soup == nullptr && files.insert(*model.file).second)
      bytes += 2 * std::filesystem::file_size(*model.file, kind);
    if (kind) return 0;
  }
  return bytes;
}

// A drawing of a damaged model must not look like one of a sound model.
void warn_about(const Messages& messages, const mesh::MeshReport& report, bool says_wires) {
  const auto say = [&](int count, const std::string& one, const std::string& many) {
    if (count > 0) messages.warn(report.name + ": " + std::to_string(count) + " " + (count == 1 ? one : many));
  };
  const auto say_left_out = [&](int faces, const std::string& what) {
    say(faces, "face left out: " + what, "faces left out: " + what);
  };
  // Such a face borders its only edge twice: omitting it opens nothing.
  if (mesh::are_many(report.dropped_degenerate, report.faces + report.dropped_degenerate))
    say_left_out(report.dropped_degenerate, "fewer than three distinct corners");
  say_left_out(report.dropped_duplicates, "the corners of an earlier face");
  say_left_out(report.dropped_non_finite, "coordinates that are not finite");
  say(report.non_manifold_edges, "edge has three or more faces and is drawn",
      "edges have three or more faces; each is drawn");
  if (says_wires && report.triangles > 0) {
    say(report.wires - report.point_arms,
        "piece of a line beside the faces is drawn; --edges without wire leaves it out",
        "pieces of lines beside the faces are drawn; --edges without wire leaves them out");
    say(report.points, "point is drawn as a cross; --edges without wire leaves it out",
        "points are drawn as crosses; --edges without wire leaves them out");
  }
  for (const std::string& note : report.notes) messages.warn(report.name + ": " + note);
}

// With the ledger of what the file of a model requires, or that it is not wanted.
void take_requirements(std::vector<FileRequirements>& required, const scene::SceneDescription& scene, int model,
                       KeptModel& read, mesh::MeshReport& report) {
  std::vector<importer::ModelRequirement>& all = read.rest.requirements;
  if (all.empty()) return;
  if (wanted_requirements(scene, scene.models[static_cast<std::size_t>(model)]) == Pmi::none)
    report.notes.push_back(importer::counted_requirements(all) + " of the file " + (all.size() == 1 ? "is" : "are") +
                           " not drawn: epura requirements lists what the file requires, --pmi all draws it");
  required.push_back({model, std::move(all), read.rest.part, read.rest.standard});
  begin_ledger(required.back(), scene);
}

// Unless they are what is drawn.
void note_saved_views(const scene::SceneDescription& scene, const importer::ReadModel& read, mesh::MeshReport& report) {
  const std::size_t count = read.saved_views.size();
  const bool are_drawn = std::any_of(read.saved_views.begin(), read.saved_views.end(), [&](const auto& saved) {
    return std::any_of(scene.views.begin(), scene.views.end(), [&](const scene::ViewDescription& view) {
      return view.label.given() && *view.label == saved.name;
    });
  });
  if (count > 0 && !are_drawn)
    report.notes.push_back(std::to_string(count) + " saved view" + (count == 1 ? "" : "s") + " of the file " +
                           (count == 1 ? "is" : "are") + " not drawn: --views saved draws " +
                           (count == 1 ? "it" : "them"));
}

}  // namespace

bool wants_wires(const scene::SceneDescription& scene) {
  return std::any_of(scene.views.begin(), scene.views.end(),
                     [](const scene::ViewDescription& view) { return view.edges.value_or({}).wire; });
}

Mat4 place_of(const scene::ModelDescription& model, const importer::ReadModel& read) {
  const double unit = model.unit.given() ? scene::millimetres(*model.unit) : read.unit.value_or(1);
  Mat4 place = scene::parse_transform("scale:" + format_number(unit));
  if (model.up.value_or(read.is_y_up ? UpAxis::y : UpAxis::z) == UpAxis::y) place = scene::y_up_to_z_up() * place;
  if (model.transform.given()) place = *model.transform * place;
  return place;
}

FacetPrecision precision_of(const scene::SceneDescription& scene, double facets) {
  FacetPrecision precision;
  for (const scene::ViewDescription& view : scene.views) {
    const scene::ScaleChoice scale = scale_of(scene, view);
    const double tolerance = facets / (scale.fixed ? *scale.fixed : paper_for(scene, view));
    double& least = scale.fixed ? precision.tolerance : precision.relative_tolerance;
    least = least > 0 ? std::min(least, tolerance) : tolerance;
  }
  return precision;
}

Reading reading_of(const scene::SceneDescription& scene, const RunOptions& options, double facets) {
  const FacetPrecision precision = options.precision.value_or(precision_of(scene, facets));
  return {{.plugin_path = options.plugin_path,
           .tolerance = precision.tolerance,
           .relative_tolerance = precision.relative_tolerance,
           .threads = options.threads,
           .is_confined = options.sandbox != Sandbox::off,
           .allow_outside = options.allow_outside},
          options.kept_models};
}

double part_of_drawings(const scene::SceneDescription& scene, double error) {
  double part = 0;
  for (const scene::ViewDescription& view : scene.views) {
    const bool has_paper =
        largest_size(sheet_of(scene, view), scene.views.size()).kind != scene::PaperChoice::Kind::none;
    if (scale_of(scene, view).fixed && !has_paper) continue;
    const double of_view = error / paper_for(scene, view);
    part = part > 0 ? std::min(part, of_view) : of_view;
  }
  return part;
}

ReadWorld read_models(const scene::SceneDescription& scene, const Reading& reading,
                      std::vector<mesh::MeshReport>& reports, const Messages& messages, Progress progress) {
  const std::vector<scene::ModelDescription>& models = scene.models;
  progress.begin("reading", work_of(models));
  // Who chooses the kinds of edges knows of them.
  const bool says_wires = std::any_of(scene.views.begin(), scene.views.end(),
                                      [](const scene::ViewDescription& view) { return !view.edges.given(); });
  int without_unit = -1;
  std::vector<world::Placed> placed;
  std::vector<std::vector<scene::StyleDescription>> styles;
  std::vector<std::vector<importer::BodyPart>> parts;
  std::vector<FileRequirements> required;
  KeptModels own;
  KeptModels& kept = reading.kept == nullptr ? own : *reading.kept;
  std::vector<KeptModel> all;
  std::vector<Mat4> places;
  for (const scene::ModelDescription& description : models) {
    all.push_back(model_of(description, reading, kept, progress));
    places.push_back(place_of(description, all.back().rest));
  }
  BodyPatterns patterns = with_item_names(scene, all, places, messages);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const scene::ModelDescription& description = models[i];
    // Models that are not drawn keep their numbers.
    const bool drawn = is_drawn(description);
    KeptModel model = std::move(all[i]);
    if (drawn && description.soup == nullptr && without_unit < 0 && !description.unit.given() && !model.rest.unit)
      without_unit = static_cast<int>(placed.size());
    styles.push_back(scene::styles_of_bodies(*model.mesh, scene::name_of(description), patterns.styles));
    model = leave_out(std::move(model), styles.back());
    parts.push_back(std::move(model.rest.body_parts));
    placed.push_back({std::move(model.mesh), places[i]});
    if (!drawn) continue;
    if (description.surfaces.value_or(Surfaces::automatic) == Surfaces::automatic) placed.back().part = model.rest.part;
    reports.push_back(placed.back().mesh->report);
    take_requirements(required, scene, static_cast<int>(i), model, reports.back());
    note_saved_views(scene, model.rest, reports.back());
    warn_about(messages, reports.back(), says_wires);
  }
  world::World world = world::make_world(std::move(placed), wants_wires(scene));
  world.styles = std::move(styles);
  world::expect_usable(world);
  return {std::move(world), std::move(parts), std::move(patterns.explosions), std::move(required), without_unit};
}

void doubt_unit(const Messages& messages, const scene::SceneDescription& scene, const world::World& world,
                int without_unit) {
  constexpr double least = 1, most = 10'000;  // mm
  if (without_unit < 0) return;
  const world::Placed& model = world.models[static_cast<std::size_t>(without_unit)];
  const std::string& name = model.mesh->report.name;
  const bool is_scaled = std::abs(std::abs(glm::determinant(Mat3(model.to_world))) - 1) > 1e-6;
  const auto guess = is_scaled || model.part == nullptr
                         ? std::nullopt
                         : features::guess_unit(features::box_of(model.mesh->whole()), *model.part);
  if (guess && *guess != Unit::mm) {
    const std::string word(scene::word_of(*guess));
    return messages.warn(name + " has no unit and is drawn in millimetres, but its sizes are round in unit '" + word +
                         "'\n  hint: --unit " + word + ", or --unit mm if they are right");
  }
  const Vec3 size = world.box.max - world.box.min;
  const double largest = std::max({size.x, size.y, size.z});
  if (scene.dimensions.empty() || (largest >= least && largest <= most)) return;
  messages.warn(name + " has no unit and is dimensioned in millimetres: the largest size is " + size_text(largest) +
                " mm\n  hint: --unit m or --unit in, if that is too " + (largest < least ? "small" : "large"));
}

}  // namespace epura::pipeline
