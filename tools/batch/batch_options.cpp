// SPDX-License-Identifier: Apache-2.0
// The options of `epura batch`: those of its jobs, and its own.
#include "app/draw_options.hpp"
#include "app/jobs/placeholders.hpp"
#include "batch/batch.hpp"

namespace epura {

namespace {

using Batch = BatchOptions;

// Values with placeholders are kept until the job is known.
scene::Option<Batch> for_all_jobs(const scene::Option<DrawOptions>& row) {
  const auto read = [row](Batch& batch, const scene::TomlValue& value) {
    const std::string* text = std::get_if<std::string>(&value.content);
    const bool is_source = row.flag == "models", is_output = row.flag == "-o,--output";
    if (is_output || (!is_source && text != nullptr && has_placeholder(*text)))
      batch.sources.later.push_back({row.flag, value});
    else
      row.read(batch.sources.draw, value);
    if (!is_source && row.nature != scene::Nature::run && text != nullptr)
      batch.words.push_back(row.flag + "=" + *text);
  };
  return {row, read, {}};
}

scene::Options<Batch> selection_options() {
  return {
      scene::option<Batch>(
          {.flag = "--table",
           .help = "file with a job in each row: CSV, whose first line names options of 'epura draw' "
                   "(file, output, title, views ...), or TOML with [[job]]",
           .nature = scene::Nature::file,
           .repeatable = true},
          [](auto& batch) -> auto& { return batch.sources.tables; }, file_name("FILE")),
      scene::option<Batch>(
          {.flag = "--shard",
           .help = "do one part of several, e.g. 2/8; auto in an array of jobs of Slurm, Grid Engine or "
                   "AWS Batch, auto/8 in Kubernetes"},
          &Batch::shard, scene::any_text().shown_as("I/N")),
      scene::option<Batch>(
          {.flag = "--merge", .help = "draw nothing; join the manifests of all parts into this one, and report"},
          &Batch::merge, file_name("FILE")),
      scene::option<Batch>({.flag = "--again", .help = "draw also what has not changed"}, &Batch::again,
                           scene::truth()),
      scene::option<Batch>({.flag = "--resume",
                            .help = "continue an interrupted batch, as without this option, but refuse to begin one"},
                           &Batch::resume, scene::truth()),
  };
}

scene::Options<Batch> limit_options() {
  return {
      scene::option<Batch>(
          {.flag = "--workers", .help = "number of jobs at the same time, 0 for one per core", .usual = "0"},
          &Batch::workers, scene::whole_number(0, 1024)),
      scene::option<Batch>({.flag = "--job-time", .help = "time limit of a job, which ends it"}, &Batch::job_time,
                           scene::number_between(0, HUGE_VAL, "s").shown_as("S")),
      scene::option<Batch>({.flag = "--job-memory", .help = "memory limit of a job"}, &Batch::job_memory,
                           scene::number_between(50, 1e9, "MB").shown_as("MB")),
  };
}

scene::Options<Batch> report_options() {
  return {
      scene::option<Batch>({.flag = "--manifest",
                            .help = "file that says what was made from what; epura-batch.jsonl beside the outputs by "
                                    "default"},
                           &Batch::manifest, file_name("FILE")),
      scene::option<Batch>({.flag = "--report", .help = "page with all drawings: html"}, &Batch::report,
                           file_name("FILE")),
      scene::option<Batch>({.flag = "--junit", .help = "results for CI: JUnit XML"}, &Batch::junit, file_name("FILE")),
  };
}

}  // namespace

scene::Options<BatchOptions> batch_options() {
  scene::Options<Batch> all;
  for (const scene::Option<DrawOptions>& row : job_options()) {
    all.push_back(for_all_jobs(row));
    if (row.flag == "models") {
      all.back().help = "model files, folders, patterns such as 'parts/**/*.step', or - for a list on standard input";
      all.back().required = false;
    }
    if (row.flag == "-o,--output")
      all.back().help = "output of each job, such as 'out/{folder}/{name}.pdf'; also {number} and {hash}";
  }
  for (const auto& more : {selection_options(), limit_options(), report_options()})
    for (scene::Option<Batch> option : more) {
      option.nature = scene::Nature::run;
      all.push_back(std::move(option));
    }
  all.push_back(progress_option<Batch>(&Batch::progress));
  return all;
}

}  // namespace epura
