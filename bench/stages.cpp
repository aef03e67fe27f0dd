// SPDX-License-Identifier: Apache-2.0
// Measures every stage by Google Benchmark:  stages [KIND N]... [--benchmark_filter=sphere/ ...]
// The input of a stage is made by the stages before it, outside the measured time. Scenes: see 'scenes'.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/chains.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/find_edges.hpp"
#include "generators.hpp"
#include "mesh/build.hpp"
#include "mesh/read.hpp"
#include "output/format.hpp"
#include "output/write.hpp"
#include "sheet/view_lines.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace {

using namespace epura;
using benchmark::DoNotOptimize;

projection::Projection isometric() {
  const Vec3 n = glm::normalize(Vec3(1, -1, 1)), u = glm::normalize(glm::cross(Vec3(0, 0, 1), n));
  projection::Projection projection;
  projection.name = "isometric";
  projection.u = u;
  projection.v = glm::cross(n, u);
  projection.n = projection.projector = n;
  return projection;
}

world::World world_of(const mesh::Mesh& mesh) {
  return world::make_world({{std::make_shared<const mesh::Mesh>(mesh), Mat4(1.0)}});
}

constexpr edges::EdgeOptions mesh_edges{.intersection = false};
constexpr edges::EdgeOptions intersections{.contour = false, .boundary = false, .crease = false};

/// The data that each stage passes to the next.
struct Run {
  explicit Run(const bench::Scene& scene)
      : file(bench::ply_bytes(scene)),
        soup(mesh::read_ply(file, "scene")),
        mesh(mesh::build_mesh(soup, "scene")),
        world(world_of(mesh)),
        view(view::project_scene(world, isometric(), {})),
        seen(view),
        drawn(edges::find_feature_edges(world, seen, {})),
        hidden(visibility::find_hidden(world, seen, drawn)),
        placement(sheet::place_ink(view::drawn_box(seen).min, view::drawn_box(seen).max, {}, {})),
        paper(view::make_paper_map(seen, placement.scale, placement.shift)),
        drawing(draw()),
        sheet{placement.paper.width, placement.paper.height, {}, layers()} {}

  [[nodiscard]] drawing::ViewDrawing draw() const {
    return drawing::make_drawing({world, seen, drawn, hidden}, paper, {"isometric", true});
  }

  [[nodiscard]] std::vector<sheet::Layer> layers() const {
    return sheet::view_layers(drawing, sheet::line_widths(placement.paper), sheet::BodyStyles{{{sheet::BodyStyle()}}});
  }

  std::string file;
  mesh::Soup soup;
  mesh::Mesh mesh;
  world::World world;
  view::ProjectedScene view;  ///< before edges add their points
  view::ProjectedScene seen;
  edges::FeatureEdges drawn;
  visibility::HiddenSpans hidden;
  sheet::Placement placement;
  view::PaperMap paper;
  drawing::ViewDrawing drawing;
  sheet::Sheet sheet;
};

/// Created when the first stage of its scene is measured, and kept for the others.
struct Case {
  std::string name;
  std::function<bench::Scene()> make;
  std::unique_ptr<Run> run;

  Run& ready() {
    if (!run) run = std::make_unique<Run>(make());
    return *run;
  }
};

void find_edges(benchmark::State& state, const Run& run, const edges::EdgeOptions& options) {
  for (auto _ : state) {
    state.PauseTiming();
    view::ProjectedScene view = run.view;
    state.ResumeTiming();
    DoNotOptimize(edges::find_feature_edges(run.world, view, options));
  }
}

using Stage = std::function<void(benchmark::State&, Run&)>;

Stage timed(const std::function<void(const Run&)>& work) {
  return [work](benchmark::State& state, const Run& run) {
    for (auto _ : state) work(run);
  };
}

std::vector<std::pair<std::string, Stage>> stages() {
  return {
      {"read", timed([](const Run& r) { DoNotOptimize(mesh::read_ply(r.file, "scene")); })},
      {"mesh", timed([](const Run& r) { DoNotOptimize(mesh::build_mesh(r.soup, "scene")); })},
      {"scene", timed([](const Run& r) { DoNotOptimize(world::make_world(r.world.models)); })},
      {"view", timed([](const Run& r) { DoNotOptimize(view::project_scene(r.world, isometric(), {})); })},
      {"edges", [](benchmark::State& state, Run& r) { find_edges(state, r, mesh_edges); }},
      {"intersections", [](benchmark::State& state, Run& r) { find_edges(state, r, intersections); }},
      {"visibility", timed([](const Run& r) { DoNotOptimize(visibility::find_hidden(r.world, r.seen, r.drawn)); })},
      {"drawing", timed([](const Run& r) { DoNotOptimize(r.draw()); })},
      {"chains", timed([](const Run& r) { DoNotOptimize(drawing::chain_segments(r.drawing.segments, 1e-6)); })},
      {"sheet", timed([](const Run& r) { DoNotOptimize(r.layers()); })},
      {"svg", timed([](const Run& r) { DoNotOptimize(output::to_svg(r.sheet, {})); })},
      {"pdf", timed([](const Run& r) { DoNotOptimize(output::to_pdf({&r.sheet})); })},
      {"json", timed([](const Run& r) {
         DoNotOptimize(output::to_json(r.sheet, r.placement.scale, {&r.drawing, 1}, {}));
       })},
  };
}

void register_stages(const std::shared_ptr<Case>& scene) {
  for (const auto& [name, stage] : stages())
    benchmark::RegisterBenchmark((scene->name + "/" + name).c_str(),
                                 [scene, stage = stage](benchmark::State& state) {
                                   Run& run = scene->ready();
                                   stage(state, run);
                                   state.counters["triangles"] = double(run.world.triangles.size());
                                   state.counters["segments"] = double(run.drawing.segments.size());
                                 })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

std::shared_ptr<Case> case_of(std::string_view kind, std::string_view size) {
  const auto n = parse_integer(size);
  for (const bench::Generator& generator : bench::all_scenes())
    if (generator.name == kind && n && *n > 0)
      return std::make_shared<Case>(Case{std::string(kind) + "-" + std::string(size),
                                         [make = generator.make, n = static_cast<int>(*n)] { return make(n); },
                                         nullptr});
  throw Error(ErrorKind::input, "stages", "no scene '" + std::string(kind) + " " + std::string(size) + "'");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    benchmark::Initialize(&argc, argv);
    std::vector<std::string_view> scenes(argv + 1, argv + argc);
    if (scenes.empty()) scenes = {"sphere", "100000", "torus", "100000", "plate", "16", "gears", "6", "city", "60"};
    if (scenes.size() % 2 != 0) throw Error(ErrorKind::input, "stages", "wants pairs of KIND and N");
    for (std::size_t i = 0; i < scenes.size(); i += 2) register_stages(case_of(scenes[i], scenes[i + 1]));
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
