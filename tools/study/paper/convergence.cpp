// SPDX-License-Identifier: Apache-2.0
#include "study/paper/convergence.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "scene/choices.hpp"
#include "sheet/walk_stroke.hpp"
#include "study/accuracy/ink_distance.hpp"

namespace epura::study {

namespace {

scene::SceneDescription describe(const PaperScene& paper, int around, PaperWay way) {
  scene::SceneDescription scene;
  scene.models = paper.files;
  if (paper.files.empty())
    for (mesh::Soup& mesh : paper.meshes(around)) {
      scene::ModelDescription& model = scene.models.emplace_back();
      model.soup = std::make_shared<const mesh::Soup>(std::move(mesh));
      model.name = {"body " + std::to_string(scene.models.size()), "study"};
    }
  if (way == PaperWay::triangles)
    for (scene::ModelDescription& model : scene.models) model.surfaces = {Surfaces::mesh, "study"};
  scene::ViewDescription view;
  view.projection = {scene::parse_request(paper.projection), "study"};
  view.hidden = {HiddenLines::none, "study"};
  view.join_within = {0, "study"};
  scene.views.push_back(std::move(view));
  pipeline::complete_scene(scene);
  pipeline::complete_sheets(scene);
  return scene;
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

constexpr double max_of_arcs = 0.01;  // mm between arcs and their chords

// As polylines that are closer to the arcs than is measured.
void add_curve(std::vector<InkLine>& ink, const drawing::CurvePart& curve) {
  constexpr double step = 2e-3;  // radians
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(curve.to - curve.from) / step)));
  const auto at = [&](int i) {
    const double angle = curve.from + (curve.to - curve.from) * i / count;
    return curve.centre + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
  };
  for (int i = 0; i < count; ++i) ink.push_back({at(i), at(i + 1)});
}

std::vector<InkLine> drawn_lines(const sheet::Sheet& sheet) {
  std::vector<InkLine> ink;
  for (const sheet::Layer& layer : sheet.layers)
    for (const sheet::Stroke& stroke : layer.strokes) {
      if (!stroke.kind) continue;
      Vec2 at = stroke.points.front();
      const auto line = [&](const Vec2& to) { ink.push_back({std::exchange(at, to), to}); };
      const auto curve = [&](const drawing::CurvePart& part) {
        add_curve(ink, part);
        at = stroke.points[static_cast<std::size_t>(part.last) % stroke.points.size()];
      };
      sheet::walk_stroke(stroke, line, curve);
      if (stroke.closed) line(stroke.points.front());
    }
  return ink;
}

pipeline::RunOptions options_of(const PaperStudy& study, PaperWay way) {
  pipeline::RunOptions options;
  options.plugin_path = study.plugin_path;
  options.keeps_drawings = true;
  if (way == PaperWay::arcs) options.arcs = max_of_arcs;
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

// Known lines on the paper of a run.
struct Truth {
  std::vector<InkLine> drawn, all;  ///< all: with the optional ones
  double share;
};

Truth truth_on_paper(const PaperScene& scene, const PaperRun& run, int points) {
  const TrueLines lines = scene.lines(run.projection, points);
  Truth truth{lines_on_paper(lines.drawn, run.world_to_page), lines_on_paper(lines.optional, run.world_to_page),
              scene.share};
  truth.all.insert(truth.all.end(), truth.drawn.begin(), truth.drawn.end());
  return truth;
}

// Beyond the stated error, lines are missed, or phantoms.
void compare(const std::vector<InkLine>& ink, const Truth& truth, PaperError& error) {
  const auto distance = [&](const std::vector<InkLine>& lines, const std::vector<InkLine>& others) {
    return truth.share < 1 ? distance_of_share(lines, others, truth.share) : farthest_from_ink(lines, others);
  };
  error.drawn = distance(ink, truth.all);
  error.truth = distance(truth.drawn, ink);
  const double allowed = error.budget.total();
  error.missed = length_beyond(truth.drawn, ink, allowed);
  error.phantom = length_beyond(ink, truth.all, allowed);
}

// All bodies in one mesh.
mesh::Soup joined(const std::vector<mesh::Soup>& bodies) {
  mesh::Soup all;
  for (const mesh::Soup& one : bodies) {
    const int first = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), one.points.begin(), one.points.end());
    std::size_t begin = 0;
    for (const int end : one.face_ends) {
      for (; begin < static_cast<std::size_t>(end); ++begin) all.corners.push_back(first + one.corners[begin]);
      all.end_face();
    }
  }
  return all;
}

/// A way to draw a scene at a fineness.
struct Way {
  std::string name;
  std::function<PaperRun()> compare;
  std::function<double()> time;  ///< s
};

// Rivals draw isometric views: what other parallel views show of a mesh, theirs show of it in another position.
struct Pose {
  Mat3 to_rival;
  Vec3 right, up;
};

Pose pose_of(const projection::Projection& view) {
  const Vec3 n = glm::normalize(Vec3(1, -1, 1)), right = glm::normalize(Vec3(1, 1, 0)), up = glm::cross(n, right);
  const Mat3 isometric(right, up, n), own(view.u, view.v, view.n);
  return {isometric * glm::transpose(own), view.u, view.v};
}

// Lines of a rival's view are put on the paper of a run of epura.
std::vector<InkLine> on_paper_of(const PaperRun& run, const Pose& pose, const std::vector<InkLine>& lines) {
  std::vector<std::vector<Vec3>> in_space;
  for (const auto& [from, to] : lines)
    in_space.push_back({from.x * pose.right + from.y * pose.up, to.x * pose.right + to.y * pose.up});
  return lines_on_paper(in_space, run.world_to_page);
}

RivalDrawing draw_by(const Rival& rival, const PaperScene& scene, int around, const Mat3& to_rival) {
  mesh::Soup mesh = joined(scene.meshes(around));
  for (auto& p : mesh.points) {
    const Vec3 q = to_rival * Vec3(p[0], p[1], p[2]);
    p = {q.x, q.y, q.z};
  }
  return draw_by(rival, mesh, scene.describe ? scene.describe(to_rival) : "");
}

// Nothing if the rival cannot draw the bodies.
std::optional<Way> way_of(const Rival& rival, const PaperScene& scene, int around, const PaperStudy& study) {
  const PaperRun own = draw_on_paper(scene, around, PaperWay::triangles, study);
  const Pose pose = pose_of(own.projection);
  const RivalDrawing drawing = draw_by(rival, scene, around, pose.to_rival);
  if (!drawing.can) return std::nullopt;
  const auto compare_lines = [&scene, &study, own, pose, lines = drawing.lines] {
    PaperRun run = own;
    run.error = {};
    compare(on_paper_of(run, pose, lines), truth_on_paper(scene, run, study.points), run.error);
    return run;
  };
  const auto time = [&scene, &rival, around, pose] { return draw_by(rival, scene, around, pose.to_rival).seconds; };
  return Way{rival.name, compare_lines, time};
}

std::vector<Way> ways_of(const PaperScene& scene, int around, const PaperStudy& study) {
  std::vector<Way> ways;
  for (const PaperWay way : {PaperWay::recognised, PaperWay::triangles, PaperWay::arcs})
    ways.push_back(
        {paper_ways[static_cast<std::size_t>(way)],
         [&scene, &study, around, way] { return draw_on_paper(scene, around, way, study); },
         [&scene, &study, around, way] { return draw(describe(scene, around, way), options_of(study, way)).seconds; }});
  if (scene.is_central()) return ways;
  for (const Rival& rival : study.rivals)
    if (auto way = way_of(rival, scene, around, study)) ways.push_back(std::move(*way));
  return ways;
}

}  // namespace

PaperScene scene_of(const ClosedForm& form) {
  PaperScene scene{form.name, form.projection, {}, {}};
  scene.meshes = [form](int around) {
    std::vector<mesh::Soup> meshes;
    for (const RoundBody& body : form.bodies) meshes.push_back(mesh_of(body, around));
    return meshes;
  };
  scene.lines = [form](const projection::Projection& view, int points) {
    const Viewer viewer = view.central ? Viewer{true, view.projector, {}} : Viewer{false, {}, view.projector};
    return TrueLines{visible_lines(form, viewer, points)};
  };
  scene.describe = [form](const Mat3& turn) { return describe_bodies(form, turn); };
  scene.coarsest = form.coarsest;
  scene.has_cusps = form.has_cusps;
  return scene;
}

double PaperSeries::order() const {
  const std::size_t half = runs.size() / 2;
  if (runs.size() < 2 || !(runs.back().error.ink() > 0)) return 0;
  const PaperRun &coarse = runs[half - (half == runs.size() - 1 ? 1 : 0)], &fine = runs.back();
  return std::log(coarse.error.ink() / fine.error.ink()) / std::log(double(fine.around) / coarse.around);
}

PaperRun draw_on_paper(const PaperScene& scene, int around, PaperWay way, const PaperStudy& study,
                       std::optional<double> max_error) {
  return compare_on_paper(scene, scene, around, way, study, max_error);
}

PaperRun compare_on_paper(const PaperScene& scene, const PaperScene& truth_of, int around, PaperWay way,
                          const PaperStudy& study, std::optional<double> max_error) {
  pipeline::RunOptions options = options_of(study, way);
  options.judges = true;
  options.max_error = max_error;
  const pipeline::DrawnScene drawn = draw(describe(scene, around, way), options).scene;
  PaperRun run{.around = around, .error = {}};
  for (const mesh::MeshReport& mesh : drawn.report.meshes) run.triangles += mesh.triangles;
  const drawing::ViewDrawing& drawing = drawn.sheets.front().drawings.front();
  run.world_to_page = drawing.world_to_page;
  run.projection = drawing.projection;
  run.error.budget = drawn.report.errors.front();
  compare(drawn_lines(drawn.sheets.front().sheet), truth_on_paper(truth_of, run, study.points), run.error);
  return run;
}

std::vector<PaperSeries> measure_paper(const std::vector<PaperScene>& scenes, const std::vector<int>& finenesses,
                                       int runs, const PaperStudy& study, const Progress& progress) {
  std::vector<PaperSeries> all;
  for (const PaperScene& scene : scenes) {
    progress.begin("measuring " + scene.name);
    std::vector<PaperSeries> series;
    std::vector<std::vector<Way>> ways;  // by fineness
    for (const int around : finenesses)
      if (around >= scene.coarsest) ways.push_back(ways_of(scene, around, study));
    if (ways.empty()) continue;
    for (const Way& way : ways.front()) series.push_back({scene.name, way.name, {}, scene.share});
    for (int turn = 0; turn < runs; ++turn)
      for (std::size_t f = 0; f < ways.size(); ++f)
        for (std::size_t way = 0; way < series.size(); ++way) {
          progress.expect_time();
          if (turn == 0) series[way].runs.push_back(ways[f][way].compare());
          series[way].runs[f].seconds.push_back(ways[f][way].time());
        }
    all.insert(all.end(), series.begin(), series.end());
  }
  return all;
}

}  // namespace epura::study
