// SPDX-License-Identifier: Apache-2.0
#include "pipeline/read_models.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "mesh/read.hpp"
#include "pipeline/choose.hpp"
#include "scene/transform.hpp"

namespace epura::pipeline {

namespace {

bool is_drawn(const scene::ModelDescription& model) { return model.drawn.value_or(true); }

Mat4 place_of(const scene::ModelDescription& model) {
  Mat4 place = scene::parse_transform("scale:" + format_number(scene::millimetres(model.unit.value_or(Unit::mm))));
  if (model.up.value_or(UpAxis::z) == UpAxis::y) place = scene::y_up_to_z_up() * place;
  if (model.transform.given()) place = *model.transform * place;
  return place;
}

// If a scene file names the model, a reading error states where.
mesh::Mesh read(const scene::ModelDescription& model, const Progress& progress) {
  if (model.soup != nullptr) return mesh::make_mesh(*model.soup, *model.name, progress);
  const auto read_it = [&](const std::string& file) { return mesh::read_mesh(file, progress); };
  return model.file.where == *model.file ? read_it(*model.file) : at_place(model.file, read_it);
}

// As read_mesh counts it; 0 where it is not known, as of a pipe.
std::size_t work_of(const std::vector<scene::ModelDescription>& models) {
  std::size_t bytes = 0;
  for (const scene::ModelDescription& model : models) {
    std::error_code kind;
    if (is_drawn(model) && model.soup == nullptr) bytes += 2 * std::filesystem::file_size(*model.file, kind);
    if (kind) return 0;
  }
  return bytes;
}

// A drawing of a damaged model must not look like one of a sound model.
void warn_about(const Messages& messages, const mesh::MeshReport& report) {
  const auto say = [&](int count, const std::string& one, const std::string& many) {
    if (count > 0) messages.warn(report.name + ": " + std::to_string(count) + " " + (count == 1 ? one : many));
  };
  const auto say_left_out = [&](int faces, const std::string& what) {
    say(faces, "face left out: " + what, "faces left out: " + what);
  };
  // Such a face bounds its only edge twice: leaving it out opens nothing.
  if (mesh::are_many(report.dropped_degenerate, report.faces + report.dropped_degenerate))
    say_left_out(report.dropped_degenerate, "fewer than three distinct corners");
  say_left_out(report.dropped_duplicates, "the corners of an earlier face");
  say_left_out(report.dropped_non_finite, "coordinates that are not finite");
  say(report.non_manifold_edges, "edge has three or more faces and is drawn",
      "edges have three or more faces; each is drawn");
  for (const std::string& note : report.notes) messages.warn(report.name + ": " + note);
}

}  // namespace

scene::World read_models(const std::vector<scene::ModelDescription>& models, std::vector<mesh::MeshReport>& reports,
                         const Messages& messages, Progress progress) {
  std::vector<Mat4> places;
  for (const scene::ModelDescription& model : models) places.push_back(place_of(model));
  progress.begin("reading", work_of(models));
  std::vector<scene::Placed> placed;
  for (std::size_t i = 0; i < models.size(); ++i) {
    // What is not drawn keeps its number.
    const bool drawn = is_drawn(models[i]);
    placed.push_back({std::make_shared<const mesh::Mesh>(drawn ? read(models[i], progress) : mesh::Mesh{}), places[i]});
    if (!drawn) continue;
    reports.push_back(placed.back().mesh->report);
    warn_about(messages, reports.back());
  }
  return scene::make_world(std::move(placed));
}

}  // namespace epura::pipeline
