// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "app/console.hpp"
#include "app/describe.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "composition/annotations.hpp"
#include "composition/layout.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/targets.hpp"
#include "study/accuracy/report.hpp"
#include "study/commands.hpp"
#include "views/draw_view.hpp"
#include "views/sections.hpp"
#include "views/view_plan.hpp"

namespace epura::study {

namespace {

// The parameters of each method from coarse to fine.
const std::vector<std::string> usual_methods{"exact:bits=10",
                                             "exact:bits=14",
                                             "exact:bits=18",
                                             "exact:bits=24",
                                             "exact",
                                             "float",
                                             "sampled:density=0.1",
                                             "sampled:density=0.5",
                                             "sampled:density=2",
                                             "sampled:density=10",
                                             "sampled:density=50",
                                             "item-buffer:dpi=75",
                                             "item-buffer:dpi=150",
                                             "item-buffer:dpi=300",
                                             "item-buffer:dpi=600",
                                             "item-buffer:dpi=1200",
                                             "none"};

std::vector<Method> methods_of(const AccuracyOptions& options) {
  if (!options.methods.empty()) return options.methods;
  std::vector<Method> methods;
  for (const std::string& text : usual_methods) methods.push_back(parse_method(text, "--visibility"));
  return methods;
}

DrawOptions drawing_of(const std::string& scene, const AccuracyOptions& options) {
  DrawOptions drawing;
  drawing.models = {scene};
  const bool is_model = to_lower(std::filesystem::path(scene).extension().string()) != ".toml";
  if (is_model) drawing.projections = options.projections;
  drawing.run.plugin_path = options.plugin_path;
  return drawing;
}

/// A scene with its options parsed.
struct StudiedScene {
  std::string path;
  scene::SceneDescription description;
  std::vector<pipeline::SheetOfViews> sheets;
};

// Done first: a long run must not fail because of a typing error.
std::vector<StudiedScene> scenes_of(const AccuracyOptions& options) {
  std::vector<StudiedScene> scenes;
  for (const std::string& path : options.scenes) {
    if (!std::filesystem::exists(path)) read_file(path);  // reports the error
    const DrawOptions drawing = drawing_of(path, options);
    scene::SceneDescription scene = describe(drawing);
    std::vector<pipeline::SheetOfViews> sheets =
        pipeline::views_by_sheet(scene, pipeline::plan_views(scene, drawing.run));
    scenes.push_back({path, std::move(scene), std::move(sheets)});
  }
  return scenes;
}

std::vector<std::string> inputs_of(const std::vector<StudiedScene>& scenes, const AccuracyOptions& options) {
  std::vector<std::string> files;
  for (const StudiedScene& scene : scenes)
    for (std::string& file : inputs_of(drawing_of(scene.path, options), scene.description))
      files.push_back(std::move(file));
  return files;
}

/// Measures the views of one scene.
class Study {
 public:
  Study(const AccuracyOptions& options, const std::vector<Method>& methods, const pipeline::Messages& messages,
        Progress progress)
      : options_(options), methods_(methods), messages_(messages), progress_(progress) {}

  std::vector<ViewMeasurements> measure_scene(const StudiedScene& scene) {
    pipeline::Stopwatch watch;
    std::vector<mesh::MeshReport> reports;
    const world::World world = pipeline::read_models(scene.description, {}, reports, messages_, progress_).world;
    watch.lap("read");
    const pipeline::CutSections sections = pipeline::cut_sections(world, scene.description, messages_);
    std::vector<ViewMeasurements> measured;
    for (const pipeline::SheetOfViews& sheet : scene.sheets) measure_sheet(scene, world, sections, sheet, measured);
    for (ViewMeasurements& view : measured) view.read_seconds = watch.laps().front().second;
    return measured;
  }

 private:
  void measure_sheet(const StudiedScene& scene, const world::World& whole, const pipeline::CutSections& sections,
                     const pipeline::SheetOfViews& sheet, std::vector<ViewMeasurements>& measured) {
    const auto world = [&](std::size_t i) -> const world::World& {
      const pipeline::CutSection* section = pipeline::section_of(sections, sheet.descriptions[i]);
      return section == nullptr ? whole : section->cut.world;
    };
    std::vector<view::ProjectedScene> views;
    for (std::size_t i = 0; i < sheet.plans.size(); ++i)
      views.push_back(pipeline::project_scene(world(i), sheet.plans[i], sheet.descriptions[i]));
    pipeline::SectionSurfaces surfaces;
    pipeline::add_surfaces(surfaces, sections);
    const std::vector<pipeline::Annotations> annotations =
        pipeline::annotate(whole, scene.description, sheet, views, surfaces);
    const pipeline::SheetPlan plan = pipeline::plan_sheet(whole, scene.description, sheet, views, annotations);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const pipeline::ViewOptions& options = sheet.plans[i].options;
      const view::PaperMap paper = view::make_paper_map(views[i], plan.places[i].scale, plan.places[i].shift);
      const edges::FeatureEdges drawn = edges::find_feature_edges(world(i), views[i], options.edges, progress_);
      const StudiedView studied{std::filesystem::path(scene.path).stem().string(),
                                options.name,
                                world(i),
                                views[i],
                                options.limits,
                                drawn,
                                paper};
      measured.push_back(measure_view(studied));
    }
  }

  ViewMeasurements measure_view(const StudiedView& studied) {
    progress_.begin("measuring " + studied.scene);
    std::vector<Contender> contenders;
    for (const Method& method : methods_) contenders.push_back(contender(studied, method));
    return measure(studied, contenders, {options_.runs, {options_.pairs}});
  }

  const AccuracyOptions& options_;
  const std::vector<Method>& methods_;
  const pipeline::Messages& messages_;
  Progress progress_;
};

}  // namespace

int study_accuracy(const AccuracyOptions& options) {
  ProgressBoard board;
  Console console(board, shows_progress(options.progress));
  const Progress progress(board);
  const ThreadLimit threads(options.threads);
  const auto targets = report_targets(options.outputs);
  const std::vector<Method> methods = methods_of(options);
  const std::vector<StudiedScene> scenes = scenes_of(options);
  const std::vector<std::string> inputs = inputs_of(scenes, options);
  pipeline::refuse_overwriting(options.outputs, inputs);
  const pipeline::Messages messages = messages_to(console);
  Study study(options, methods, messages, progress);
  AccuracyReport report;
  for (const StudiedScene& scene : scenes)
    for (ViewMeasurements& view : study.measure_scene(scene)) report.views.push_back(std::move(view));
  if (options.maps) {
    progress.begin("measuring maps");
    report.maps = measure_maps(options.runs);
  }
  write_report(report_of(report), targets, inputs, progress);
  console.print("");  // clears the progress line
  return 0;
}

}  // namespace epura::study
