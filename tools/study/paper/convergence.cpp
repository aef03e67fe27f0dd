// SPDX-License-Identifier: Apache-2.0
#include "study/paper/convergence.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "base/nearest.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "scene/choices.hpp"
#include "study/accuracy/ink_distance.hpp"

namespace epura::study {

namespace {

scene::SceneDescription describe(const ClosedForm& form, int around, bool recognises) {
  scene::SceneDescription scene;
  for (const RoundBody& body : form.bodies) {
    scene::ModelDescription model;
    model.soup = std::make_shared<const mesh::Soup>(mesh_of(body, around));
    model.name = {"body " + std::to_string(scene.models.size() + 1), "study"};
    if (!recognises) model.surfaces = {Surfaces::mesh, "study"};
    scene.models.push_back(std::move(model));
  }
  scene::ViewDescription view;
  view.projection = {scene::parse_request(form.projection), "study"};
  view.hidden = {HiddenLines::none, "study"};
  view.join_within = {0, "study"};
  scene.views.push_back(std::move(view));
  pipeline::complete_scene(scene);
  pipeline::complete_sheets(scene);
  return scene;
}

Viewer viewer_of(const projection::Projection& projection) {
  return projection.central ? Viewer{true, projection.projector, {}} : Viewer{false, {}, projection.projector};
}

std::vector<InkLine> lines_on_paper(const std::vector<std::vector<Vec3>>& lines, const Mat4& world_to_page) {
  const auto page = [&](const Vec3& p) {
    const Vec4 q = Vec4(p, 1) * glm::transpose(world_to_page);
    return Vec2(q.x, q.y) / q.w;
  };
  std::vector<InkLine> ink;
  for (const std::vector<Vec3>& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) ink.push_back({page(line[i - 1]), page(line[i])});
  return ink;
}

std::vector<InkLine> drawn_lines(const drawing::ViewDrawing& drawing) {
  std::vector<InkLine> ink;
  for (const drawing::Segment& segment : drawing.segments)
    if (segment.visible) ink.push_back({segment.from, segment.to});
  return ink;
}

pipeline::RunOptions options_of(const PaperStudy& study) {
  pipeline::RunOptions options;
  options.plugin_path = study.plugin_path;
  options.keeps_drawings = true;
  return options;
}

struct TimedScene {
  pipeline::DrawnScene scene;
  double seconds;
};

TimedScene draw(const scene::SceneDescription& scene, const pipeline::RunOptions& options) {
  const pipeline::Messages silent{[](const std::string&) {}, [](std::string_view) {}};
  pipeline::Stopwatch watch;
  const auto start = std::chrono::steady_clock::now();
  pipeline::DrawnScene drawn = pipeline::draw_scene(scene, options, {silent, {}, watch});
  return {std::move(drawn), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

// The length of what is farther from the ink than `most`, piece by piece.
double length_beyond(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink, double most) {
  constexpr double piece = 0.5;  // mm
  double beyond = 0;
  for (const InkLine& line : lines) {
    const double length = glm::distance(line.from, line.to);
    const int parts = std::max(1, static_cast<int>(length / piece));
    for (int i = 0; i < parts; ++i) {
      const Vec2 place = line.from + (line.to - line.from) * ((i + 0.5) / parts);
      const bool near = std::any_of(ink.begin(), ink.end(), [&](const InkLine& one) {
        return distance_to_segment(place, one.from, one.to) <= most;
      });
      beyond += near ? 0 : length / parts;
    }
  }
  return beyond;
}

}  // namespace

double PaperSeries::order() const {
  const std::size_t half = runs.size() / 2;
  if (runs.size() < 2 || !(runs.back().error.ink() > 0)) return 0;
  const PaperRun &coarse = runs[half - (half == runs.size() - 1 ? 1 : 0)], &fine = runs.back();
  return std::log(coarse.error.ink() / fine.error.ink()) / std::log(double(fine.around) / coarse.around);
}

PaperRun draw_on_paper(const ClosedForm& form, int around, bool recognises, const PaperStudy& study,
                       std::optional<double> max_error) {
  return compare_on_paper(form, form, around, recognises, study, max_error);
}

PaperRun compare_on_paper(const ClosedForm& form, const ClosedForm& truth_of, int around, bool recognises,
                          const PaperStudy& study, std::optional<double> max_error) {
  pipeline::RunOptions options = options_of(study);
  options.judges = true;
  options.max_error = max_error;
  const pipeline::DrawnScene drawn = draw(describe(form, around, recognises), options).scene;
  PaperRun run{.around = around, .error = {}};
  for (const mesh::MeshReport& mesh : drawn.report.meshes) run.triangles += mesh.triangles;
  const drawing::ViewDrawing& drawing = drawn.sheets.front().drawings.front();
  const std::vector<InkLine> ink = drawn_lines(drawing);
  const std::vector<InkLine> truth =
      lines_on_paper(visible_lines(truth_of, viewer_of(drawing.projection), study.points), drawing.world_to_page);
  run.error.budget = drawn.report.errors.front();
  const double allowed = run.error.budget.total();
  run.error.drawn = farthest_from_ink(ink, truth);
  run.error.truth = farthest_from_ink(truth, ink);
  if (run.error.truth > allowed) run.error.missed = length_beyond(truth, ink, allowed);
  if (run.error.drawn > allowed) run.error.phantom = length_beyond(ink, truth, allowed);
  return run;
}

std::vector<PaperSeries> measure_paper(const std::vector<ClosedForm>& forms, const std::vector<int>& finenesses,
                                       int runs, const PaperStudy& study, const Progress& progress) {
  std::vector<PaperSeries> all;
  for (const ClosedForm& form : forms) {
    progress.begin("measuring " + form.name);
    const std::size_t first = all.size();
    for (const char* way : paper_ways) all.push_back({form.name, way});
    for (int turn = 0; turn < runs; ++turn)
      for (std::size_t f = 0, i = 0; f < finenesses.size(); ++f) {
        if (finenesses[f] < form.coarsest) continue;
        for (std::size_t way = 0; way < paper_ways.size(); ++way) {
          progress.expect_time();
          std::vector<PaperRun>& measured = all[first + way].runs;
          if (turn == 0) measured.push_back(draw_on_paper(form, finenesses[f], way == 0, study));
          const scene::SceneDescription scene = describe(form, finenesses[f], way == 0);
          measured[i].seconds.push_back(draw(scene, options_of(study)).seconds);
        }
        ++i;
      }
  }
  return all;
}

}  // namespace epura::study
