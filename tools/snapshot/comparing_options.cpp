// SPDX-License-Identifier: Apache-2.0
// The options of `epura compare` and `epura snapshot`.
#include "app/draw_options.hpp"
#include "snapshot/compare.hpp"
#include "snapshot/snapshot.hpp"

namespace epura {

namespace {

template <class Command>
scene::Option<Command> tolerance_option(double Command::*tolerance, const std::string& help) {
  return scene::option<Command>({.flag = "--tolerance", .help = help, .usual = "0.001"}, tolerance,
                                scene::number_between(1e-6, 10, "mm").shown_as("MM"));
}

}  // namespace

scene::Options<CompareOptions> compare_options() {
  using Compare = CompareOptions;
  return {
      scene::option<Compare>({.flag = "before",
                              .help = "first drawing (json svg pdf), or a model or scene file, which is drawn",
                              .required = true},
                             &Compare::before, file_name("A")),
      scene::option<Compare>({.flag = "after", .help = "second one", .required = true}, &Compare::after,
                             file_name("B")),
      views_option("views of models, e.g. front,top,left,isometric; isometric by default", &Compare::views),
      tolerance_option(&Compare::tolerance, "distance up to which lines count as equal"),
      scene::option<Compare>(
          {.flag = "--overlay", .help = "picture of both drawings with differences in colour: svg, png, pdf or html"},
          &Compare::overlay, file_name("FILE")),
      scene::option<Compare>({.flag = "--json", .help = "differences as JSON; - for standard output"}, &Compare::json,
                             file_name("FILE")),
      scene::option<Compare>(
          {.flag = "--markdown", .help = "differences as a comment of at most 20 lines; - for standard output"},
          &Compare::markdown, file_name("FILE")),
      plugin_path_option<Compare>(&Compare::plugin_path),
      allow_outside_option<Compare>(&Compare::allow_outside),
  };
}

scene::Options<SnapshotOptions> snapshot_options() {
  using Snapshot = SnapshotOptions;
  return {
      scene::option<Snapshot>({.flag = "folders",
                               .help = "folders of cases, each with scene.toml and expected.json, .svg or .pdf",
                               .required = true,
                               .repeatable = true},
                              &Snapshot::folders, file_name("DIR...").completed_by(scene::Completion::folders)),
      scene::option<Snapshot>(
          {.flag = "--accept", .help = "make the current drawings the expected ones; refused if CI is set"},
          &Snapshot::accept, scene::truth()),
      tolerance_option(&Snapshot::tolerance, "distance up to which lines count as equal"),
      scene::option<Snapshot>({.flag = "--report", .help = "page with pictures of all cases: html"}, &Snapshot::report,
                              file_name("FILE")),
      scene::option<Snapshot>({.flag = "--junit", .help = "results for CI: JUnit XML"}, &Snapshot::junit,
                              file_name("FILE")),
      plugin_path_option<Snapshot>(&Snapshot::plugin_path),
      scene::option<Snapshot>(
          {.flag = "--threads", .help = "number of cases drawn at the same time, 0 for one per core", .usual = "0"},
          &Snapshot::threads, pipeline::thread_count()),
  };
}

}  // namespace epura
