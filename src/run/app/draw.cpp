// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "app/explain.hpp"
#include "app/proof.hpp"
#include "app/revise.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "composition/tell.hpp"
#include "output/format.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/writing_error.hpp"
#include "report/format.hpp"

namespace epura {

namespace {

bool want_drawings(const std::vector<pipeline::Target>& targets) {
  return std::any_of(targets.begin(), targets.end(),
                     [](const pipeline::Target& target) { return target.format->has_drawings; });
}

bool want_facts(const std::vector<pipeline::Target>& targets) {
  return std::any_of(targets.begin(), targets.end(),
                     [](const pipeline::Target& target) { return target.format->has_facts; });
}

void expect_outputs(const DrawOptions& options) {
  const bool asked = !options.run.why.empty() || options.run.dump || options.run.explain || options.run.lint ||
                     options.run.rebuild || options.run.describes;
  if (!asked && options.outputs.empty())
    throw Error(ErrorKind::input, "command line", "--output is required",
                "write where to draw, such as -o drawing.pdf; see 'epura draw --help'");
  if (asked && std::find(options.outputs.begin(), options.outputs.end(), "-") != options.outputs.end())
    throw Error(ErrorKind::input, "--output -",
                "conflicts with the answers of --why, --dump and explain on standard output",
                "write the drawing to a file");
  if (options.measure && options.run.time_limit)
    throw Error(ErrorKind::input, "--measure", "draws several times and cannot be combined with --time-limit",
                "omit one of them");
  if (options.vector.plain && options.vector.svg == output::SvgKind::accessible)
    throw Error(ErrorKind::input, "--svg accessible", "names lines, of which --plain omits the origin",
                "omit one of them");
  const output::DxfEntities& entities = options.vector.dxf_entities;
  if ((entities.leaders || entities.tables) && options.vector.dxf_version == output::DxfVersion::r2000)
    throw Error(ErrorKind::input, "--dxf-entities", "DXF 2000 has no entities for leaders and tables",
                "omit --dxf-version, or draw them as lines and texts");
}

// Repeats the whole run, including reading, with other shortcuts.
std::string draw_again(const DrawOptions& options, const scene::SceneDescription& scene,
                       std::vector<pipeline::Target> targets, const pipeline::Shortcuts& leave_out) {
  pipeline::RunOptions again = options.run;
  again.plan = leave_out;
  again.verify = again.explain = false;
  again.why.clear();
  again.dump.reset();
  if (targets.empty()) targets.push_back({"explain.svg", output::find_format("svg")});
  again.keeps_drawings = want_drawings(targets);
  again.line_facts = want_facts(targets);
  pipeline::Stopwatch watch;
  const pipeline::Messages silent = pipeline::silent_messages();
  const pipeline::DrawnScene drawn = pipeline::draw_scene(scene, again, {silent, {}, watch});
  std::string bytes;
  for (const pipeline::FileBytes& file : pipeline::encode_all(targets, drawn.sheets, options.vector, {}, {}))
    bytes += file.bytes;
  return bytes;
}

report::PlanStep formats_step(const std::vector<pipeline::Target>& targets) {
  std::set<const output::Format*> wanted;
  for (const pipeline::Target& target : targets) wanted.insert(target.format);
  return {"formats", false, "only those of outputs are made", static_cast<long long>(output::formats().size()),
          static_cast<long long>(wanted.size())};
}

// The formats of a run are only printed, not written to files: the content of a file must not depend on other outputs.
std::string explanation(const report::Report& report, const report::PlanStep& formats) {
  std::vector<report::PlanStep> plan = report.plan;
  plan.push_back(formats);
  std::string text = plan_table(plan);
  for (const report::ViewCondition& view : report.conditions) text += pipeline::format_condition(view);
  if (!report.errors.empty()) text += report::format_errors(report.errors);
  return text;
}

// Keeps only the longest lines if there is not enough time to write all.
std::vector<pipeline::FileBytes> encode_in_time(const std::vector<pipeline::Target>& targets,
                                                std::vector<pipeline::FinishedSheet>& sheets,
                                                const output::VectorOptions& vector_options, report::Report& report,
                                                const Progress& progress) {
  const auto make = [&](const Progress& until) {
    return pipeline::encode_all(targets, sheets, vector_options, report, until);
  };
  const auto leave_out = [&](const std::string& stage) {
    report.partial.add_stage(stage);
    for (pipeline::FinishedSheet& sheet : sheets) pipeline::mark_partial(sheet, report.partial.stages.front());
    return pipeline::keep_longest_lines(sheets, report.partial);
  };
  return make_in_time(progress, pipeline::Budget{progress, progress, report.partial}.last(), make, leave_out);
}

std::vector<std::string> paths_of(const std::vector<pipeline::FileBytes>& files) {
  std::vector<std::string> paths;
  for (const pipeline::FileBytes& file : files) paths.push_back(file.path);
  return paths;
}

void forget_times(std::vector<report::PlanStep>& plan) {
  for (report::PlanStep& step : plan) step.times = {};
}

DrawnFiles draw_within(const DrawOptions& options, const DescribeScene& describe_scene,
                       const pipeline::Messages& messages, Progress progress) {
  pipeline::Stopwatch watch;
  progress.begin("preparing");
  const ThreadLimit threads(options.run.threads);
  const std::vector<pipeline::Target> targets = pipeline::targets_of(options.outputs, options.format);
  expect_outputs(options);
  if (options.vector.proof != output::Proof::none) expect_provable(options, targets);
  scene::SceneDescription scene = describe_scene(progress);
  pipeline::refuse_overwriting(pipeline::files_of(targets, scene.sheets.size()), inputs_of(options, scene));
  std::optional<Revising> revising;
  if (options.revise.given()) revising = begin_revision(options, scene);

  pipeline::RunOptions run = options.run;
  const bool proves = options.vector.proof != output::Proof::none;
  const bool is_accessible = options.vector.svg == output::SvgKind::accessible;
  run.keeps_drawings = proves || is_accessible || run.hatch_free || want_drawings(targets);
  run.describes = run.describes || is_accessible || options.vector.pdf == output::PdfKind::archive;
  run.names_features = is_accessible;
  run.verify = run.verify || proves;
  run.lint = run.lint || proves;
  run.line_facts = is_accessible || want_facts(targets);
  run.judges = run.keeps_drawings || run.explain;
  output::VectorOptions vector = options.vector;
  if (run.max_error) pipeline::choose_writing(vector, targets, *run.max_error, run.arcs.has_value());
  run.writing_error = pipeline::error_of_writing(targets, vector, run.arcs.has_value());
  if (run.max_error) messages.print(pipeline::sentence_of_choices(*run.max_error, run.arcs.has_value(), vector));
  pipeline::DrawnScene drawn = pipeline::draw_scene(scene, run, {messages, progress, watch});
  if (revising && !mark_revision(std::move(*revising), options.run, scene, drawn, messages))
    drawn = pipeline::draw_scene(scene, run, {pipeline::silent_messages(), progress, watch});
  report::Report& report = drawn.report;
  estimate_savings(report.plan);
  if (options.measure) {
    const auto again = [&](const pipeline::Shortcuts& other) { return draw_again(options, scene, targets, other); };
    measure_savings(report.plan, run.plan, again);
  }
  if (run.explain) drawn.answers += explanation(report, formats_step(targets));

  if (options.timings) report.seconds = watch.laps();
  if (!options.timings && !options.measure) forget_times(report.plan);
  pipeline::warn_about_pictures(messages, targets, drawn.sheets);
  if (proves) vector.attachments = proof_of(options, scene, drawn);
  const std::vector<pipeline::FileBytes> files = encode_in_time(targets, drawn.sheets, vector, report, progress);
  progress.lift_limit();
  for (const pipeline::FileBytes& file : files) pipeline::write(file, progress);
  watch.lap("write");
  return {paths_of(files), std::move(report),       std::move(drawn.answers),
          watch,           std::move(drawn.sheets), std::move(drawn.rebuilt)};
}

}  // namespace

DrawnFiles draw_files(const DrawOptions& options, const pipeline::Messages& messages, Progress progress) {
  return draw_files(
      options, [&options](const Progress&) { return describe(options); }, messages, progress);
}

DrawnFiles draw_files(const DrawOptions& options, const DescribeScene& describe_scene,
                      const pipeline::Messages& messages, Progress progress) {
  try {
    return draw_within(options, describe_scene, messages, progress);
  } catch (const OutOfTime& cut) {
    throw pipeline::nothing_drawn(cut.stage);
  }
}

void tell_the_end(const pipeline::Messages& messages, const DrawOptions& options, const DrawnFiles& drawn) {
  if (options.timings) pipeline::tell_timings(messages, drawn.watch);
  if (!drawn.report.partial.stages.empty()) pipeline::warn_about(messages, drawn.report.partial);
}

}  // namespace epura
