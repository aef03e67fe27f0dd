// SPDX-License-Identifier: Apache-2.0
// The library interface: scenes in, drawings and files out.
#include <algorithm>
#include <array>
#include <epura/epura.hpp>
#include <mutex>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "compare/comparison.hpp"
#include "compare/html_report.hpp"
#include "compare/read_pictures.hpp"
#include "drawing/drawing.hpp"
#include "library/describe_scene.hpp"
#include "library/guarded.hpp"
#include "library/kept_plugins.hpp"
#include "library/run_options.hpp"
#include "output/format.hpp"
#include "output/write.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/saved_views.hpp"
#include "pipeline/targets.hpp"
#include "report/error_budget.hpp"
#include "scene/scene_file.hpp"
#include "sheet/sheet.hpp"

namespace epura {

class Drawing::Content {
 public:
  std::vector<pipeline::FinishedSheet> sheets;
  std::vector<DrawnView> views;
  std::vector<std::string> warnings;
  std::vector<std::string> inputs;  ///< files that were read
  report::Report report;
};

namespace {

std::array<double, 2> pair_of(const Vec2& p) { return {p.x, p.y}; }

/// `sheet` counts from 1.
DrawnView drawn_view(const drawing::ViewDrawing& drawing, int sheet) {
  DrawnView view{drawing.name, drawing.projection.name, sheet, drawing.scale, {}, {}, {}, {}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      view.world_to_page[static_cast<std::size_t>(4 * row + column)] = drawing.world_to_page[column][row];
  view.lines.reserve(drawing.segments.size());
  for (const drawing::Segment& segment : drawing.segments)
    view.lines.push_back({pair_of(segment.from), pair_of(segment.to), segment.kind, segment.visible,
                          drawing.number_in_scene(segment.model), segment.body, segment.edge, segment.t});
  for (const drawing::Chain& chain : drawing.chains)
    for (const drawing::CurvePart& curve : chain.curves)
      view.arcs.push_back(
          {pair_of(curve.centre), pair_of(curve.u), pair_of(curve.v), curve.from, curve.to, chain.kind, chain.visible});
  return view;
}

/// Without the term of writing, which depends on the file.
ErrorBudget error_budget(const report::ViewError& error) {
  ErrorBudget budget;
  for (std::size_t i = 0; i < report::error_terms.size(); ++i) {
    const auto term = static_cast<report::ErrorTerm>(i);
    if (term == report::ErrorTerm::writing || error[term] == 0) continue;
    budget.total += error[term];
    budget.terms.push_back(
        {row_of(term).name, error[term], report::evidence_names[static_cast<std::size_t>(error.evidence(term))]});
  }
  std::stable_sort(budget.terms.begin(), budget.terms.end(),
                   [](const ErrorTerm& a, const ErrorTerm& b) { return a.mm > b.mm; });
  return budget;
}

std::vector<SheetLayer> layers_of(const sheet::Sheet& sheet) {
  std::vector<SheetLayer> layers;
  for (const sheet::Layer& layer : sheet.layers) {
    SheetLayer& made = layers.emplace_back(SheetLayer{layer.name, layer.style.width, {}});
    for (const sheet::Stroke& stroke : layer.strokes) {
      auto& points = made.strokes.emplace_back();
      for (const Vec2& p : stroke.points) points.push_back(pair_of(p));
      if (stroke.closed && !points.empty()) points.push_back(points.front());
    }
  }
  return layers;
}

Drawing draw_described(scene::SceneDescription scene, const Settings& settings) {
  pipeline::RunOptions options = run_options_of(settings);
  pipeline::expand_saved_views(scene, options);
  pipeline::complete_scene(scene);
  pipeline::complete_sheets(scene);
  auto content = std::make_shared<Drawing::Content>();
  content->inputs = pipeline::inputs_of(scene);
  const pipeline::Messages messages{[&](const std::string& sentence) { content->warnings.push_back(sentence); },
                                    [](std::string_view) {}};
  ProgressBoard board;
  board.observe({settings.progress, settings.stop});
  pipeline::Stopwatch watch;
  if (settings.plugins) settings.plugins->content().append_to(options.projections, scene, options.plugin_path);
  pipeline::DrawnScene drawn =
      pipeline::draw_scene(scene, options, {messages, Progress(board, settings.time_limit), watch});
  // A time belongs to a run, not to a drawing.
  for (report::PlanStep& step : drawn.report.plan) step.times = {};
  for (std::size_t i = 0; i < drawn.sheets.size(); ++i)
    for (const drawing::ViewDrawing& view : drawn.sheets[i].drawings)
      content->views.push_back(drawn_view(view, static_cast<int>(i) + 1));
  // Errors are in the order of the views, too.
  for (std::size_t i = 0; i < std::min(content->views.size(), drawn.report.errors.size()); ++i)
    content->views[i].error = error_budget(drawn.report.errors[i]);
  content->sheets = std::move(drawn.sheets);
  content->report = std::move(drawn.report);
  return Drawing(std::move(content));
}

const pipeline::FinishedSheet& sheet_of(const Drawing& drawing, int sheet) {
  if (sheet < 1 || sheet > drawing.sheets())
    throw Error(ErrorKind::input, "sheet", "is " + std::to_string(sheet) + " of " + std::to_string(drawing.sheets()),
                "sheets are numbered from 1");
  return drawing.content().sheets[static_cast<std::size_t>(sheet) - 1];
}

output::Pages pages_of(const Drawing& drawing) {
  output::Pages pages;
  for (const pipeline::FinishedSheet& sheet : drawing.content().sheets) pages.push_back(&sheet.sheet);
  return pages;
}

}  // namespace

int Drawing::sheets() const noexcept { return static_cast<int>(content_->sheets.size()); }
const std::vector<DrawnView>& Drawing::views() const noexcept { return content_->views; }
const std::vector<std::string>& Drawing::warnings() const noexcept { return content_->warnings; }
const std::vector<std::string>& Drawing::cut_stages() const noexcept { return content_->report.partial.stages; }
bool Drawing::is_wrong() const noexcept {
  const auto& verification = content_->report.verification;
  return verification && !verification->is_right();
}

std::vector<SheetLayer> Drawing::layers(int sheet) const {
  return guarded([&] { return layers_of(sheet_of(*this, sheet).sheet); });
}

Drawing draw(const Scene& scene, const Settings& settings) {
  return guarded([&] { return draw_described(describe_scene(scene), settings); });
}

Drawing draw(const SceneValue& scene, const std::vector<ModelSource>& sources, const Settings& settings) {
  return guarded([&] { return draw_described(describe_scene(scene, sources), settings); });
}

Drawing draw_file(const std::filesystem::path& file, const Settings& settings) {
  return guarded([&] {
    const auto outside = settings.allow_outside ? scene::FilesOutside::allowed : scene::FilesOutside::refused;
    if (file.extension() == ".toml") return draw_described(scene::read_scene_file(file, outside), settings);
    return draw_described(describe_scene({.models = {{.file = file.string()}}}), settings);
  });
}

std::string to_svg(const Drawing& drawing, int sheet, const SvgOptions& options) {
  return guarded([&] {
    if (!options.id_prefix.empty()) output::checked_id_prefix(options.id_prefix, "options.id_prefix");
    const output::VectorOptions vector{.plain = options.plain,
                                       .decimals = std::clamp(options.decimals, 1, 5),
                                       .text = options.text,
                                       .id_prefix = options.id_prefix};
    return output::to_svg(sheet_of(drawing, sheet).sheet, vector);
  });
}

std::string to_png(const Drawing& drawing, int sheet, double dpi) {
  return guarded([&] {
    if (!(dpi >= 1 && dpi <= 1200)) throw Error(ErrorKind::input, "dpi", "is not between 1 and 1200");
    return output::to_png(sheet_of(drawing, sheet).sheet, dpi);
  });
}

std::string to_eps(const Drawing& drawing, int sheet) {
  return guarded([&] { return output::to_eps(sheet_of(drawing, sheet).sheet); });
}

std::string to_dxf(const Drawing& drawing, int sheet, bool blocks) {
  return guarded([&] { return output::to_dxf(sheet_of(drawing, sheet).sheet, {.dxf_blocks = blocks}); });
}

std::string to_json(const Drawing& drawing, int sheet) {
  return guarded([&] {
    const pipeline::FinishedSheet& finished = sheet_of(drawing, sheet);
    return output::to_json(finished.sheet, finished.scale, finished.drawings, drawing.content().report);
  });
}

std::string to_pdf(const Drawing& drawing) {
  return guarded([&] { return output::to_pdf(pages_of(drawing)); });
}

std::string to_ps(const Drawing& drawing) {
  return guarded([&] { return output::to_ps(pages_of(drawing)); });
}

std::vector<std::filesystem::path> write(const Drawing& drawing, const std::filesystem::path& file) {
  return guarded([&] {
    if (file == "-") throw Error(ErrorKind::input, "-", "is not a file", "name a file and its extension");
    const Drawing::Content& content = drawing.content();
    const std::vector<pipeline::Target> targets = pipeline::targets_of({file.string()}, "");
    pipeline::refuse_overwriting(pipeline::files_of(targets, content.sheets.size()), content.inputs);
    std::vector<std::filesystem::path> written;
    for (const pipeline::FileBytes& bytes : pipeline::encode_all(targets, content.sheets, {}, content.report, {})) {
      write_file(bytes.path, bytes.bytes);
      written.emplace_back(bytes.path);
    }
    return written;
  });
}

Comparison compare_drawings(const DrawingFile& before, const DrawingFile& after, double tolerance) {
  return guarded([&] {
    for (const DrawingFile* file : {&before, &after}) compare::expect_drawing(file->name);
    if (!(tolerance > 0)) throw Error(ErrorKind::input, "tolerance", "is not above 0");
    const compare::PictureFile one = compare::pictures_of(before.bytes, before.name);
    const compare::PictureFile other = compare::pictures_of(after.bytes, after.name);
    const compare::Comparison found = compare::compare(one, other, tolerance);
    Comparison result;
    result.is_same = found.differences.empty();
    result.words = compare::format_comparison(found, tolerance);
    result.json = compare::to_json(found, tolerance, before.name, after.name);
    if (!result.is_same)
      result.page = compare::overlay_page(before.name + " | " + after.name, result.words, one, other, found);
    return result;
  });
}

const char* version() noexcept { return EPURA_VERSION; }

}  // namespace epura
