// SPDX-License-Identifier: Apache-2.0
#include "batch/batch.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/jobs/placeholders.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/utf8.hpp"
#include "batch/manifest.hpp"
#include "batch/pool.hpp"
#include "batch/report.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_name = "epura-batch.jsonl";

// Beside the outputs: in the part of the first output's folder that all jobs share.
fs::path manifest_beside_outputs(const BatchOptions& options, const std::vector<Job>& jobs) {
  for (const LaterOption& later : options.sources.later) {
    if (!later.flag.ends_with("--output")) continue;
    const std::string& text = std::get<std::string>(later.value.content);
    fs::path folder;
    for (const fs::path& step : fs::path(text).parent_path()) {
      if (has_placeholder(step.string())) break;
      folder /= step;
    }
    return folder / manifest_name;
  }
  return fs::path(jobs.front().outputs.front()).parent_path() / manifest_name;
}

fs::path whole_manifest(const BatchOptions& options, const std::vector<Job>& jobs) {
  if (!options.manifest.empty()) return options.manifest;
  fs::path manifest = manifest_beside_outputs(options, jobs);
  if (!lies_below(manifest, manifest.parent_path()))
    throw Error(ErrorKind::input, manifest.string(), "is a link that leaves its folder",
                "remove it, or name a file by --manifest");
  return manifest;
}

struct Counts {
  std::size_t drawn = 0, unchanged = 0, failed = 0, with_warnings = 0;

  void add(const JobResult& result) {
    ++(!result.record.is_good() ? failed : result.is_unchanged ? unchanged : drawn);
    if (result.record.is_good() && result.record.warnings > 0) ++with_warnings;
  }
  /// `page`: that shows the warnings; empty: none.
  [[nodiscard]] std::string words(const std::string& page) const {
    std::string text = std::to_string(drawn) + " drawn";
    if (unchanged > 0) text += ", " + std::to_string(unchanged) + " unchanged";
    text += ", " + std::to_string(failed) + " failed";
    if (with_warnings == 0) return text;
    return text + ", " + std::to_string(with_warnings) + " with warnings (" +
           (page.empty() ? "--report FILE.html shows them" : "see " + printable(page)) + ")";
  }
};

// In the order of the jobs, so that equal results are told equally. Warnings are in the manifest and the report.
void tell_failures(Console& console, const std::vector<JobRecord>& records) {
  for (const JobRecord& record : records) {
    if (record.is_good()) continue;
    std::string text = "FAILED " + one_line(record.name) + "\n";
    for (const std::string& message : record.messages) text += "  " + message + "\n";
    console.print(text);
  }
}

void write_reports(const BatchOptions& options, const std::vector<JobRecord>& records) {
  if (!options.report.empty()) write_file(options.report, batch_page(records, options.report));
  if (!options.junit.empty()) write_file(options.junit, batch_junit(records));
}

int merge(const BatchOptions& options) {
  std::error_code ignored;
  const fs::path given(options.merge);
  const fs::path whole = fs::is_directory(given, ignored) ? given / manifest_name : given;
  Counts counts;
  std::vector<JobRecord> records;
  for (auto& [output, record] : merge_manifests(whole)) {
    counts.add({0, false, record});
    records.push_back(record);
  }
  write_reports(options, records);
  std::fputs((printable(whole.string()) + ": " + counts.words(options.report) + "\n").c_str(), stdout);
  return counts.failed == 0 ? 0 : found_wrong_exit_code;
}

// An interrupted batch is continued by its manifest, whether --resume is given or not.
void expect_earlier_batch(const BatchOptions& options, const fs::path& whole, const Shard& shard) {
  if (options.again) throw Error(ErrorKind::input, "--resume", "conflicts with --again", "omit one of them");
  const fs::path part = manifest_of_shard(whole, shard);
  std::error_code ignored;
  if (!fs::exists(part, ignored) && !fs::exists(whole, ignored))
    throw Error(ErrorKind::input, part.string(), "there is no batch to continue",
                "omit --resume, or name its manifest by --manifest");
}

// "out/index-pictures" for "out/index.html"; empty if no page is wanted, or all jobs write what it can show.
fs::path folder_of_pictures(const BatchOptions& options, const std::vector<Job>& jobs) {
  if (options.report.empty() || std::all_of(jobs.begin(), jobs.end(), [](const Job& job) {
        return std::any_of(job.outputs.begin(), job.outputs.end(), is_picture);
      }))
    return {};
  const fs::path page(options.report);
  return page.parent_path() / (page.stem().string() + "-pictures");
}

// Now, since a confined process can write only into folders that exist. What cannot be created is told with its job.
void create_folders_of(const std::vector<Job>& jobs, const std::vector<std::size_t>& numbers) {
  for (const std::size_t number : numbers) {
    try {
      create_folders(jobs[number].outputs);
    } catch (const Error&) {
    }
  }
}

int workers_of(const BatchOptions& options) {
  return options.workers > 0 ? options.workers : static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
}

}  // namespace

int batch(const BatchOptions& options) {
  if (!options.merge.empty()) return merge(options);
  const Shard shard = parse_shard(options.shard);
  auto [jobs, passed_over] = plan_jobs(options.sources);
  BatchPlan plan{options.sources.draw, std::move(jobs), {}, basis_of(options), options.job_memory, {}};
  plan.pictures = folder_of_pictures(options, plan.jobs);
  // Several jobs use the cores better than several threads in each.
  if (plan.common.run.threads == 0) plan.common.run.threads = 1;
  std::vector<std::size_t> numbers;
  const std::vector<int> shards = shards_of(plan.jobs, shard.count);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job)
    if (shards[job] == shard.number) numbers.push_back(job);

  const fs::path whole = whole_manifest(options, plan.jobs);
  if (options.resume) expect_earlier_batch(options, whole, shard);
  ManifestWriter manifest(manifest_of_shard(whole, shard));
  std::vector<JobRecord> records(plan.jobs.size());
  if (!options.again) {
    plan.records = read_manifest(whole);
    for (auto& [output, record] : read_manifest(manifest_of_shard(whole, shard)))
      plan.records[output] = std::move(record);
  }

  create_folders_of(plan.jobs, numbers);
  if (!plan.pictures.empty()) create_folders({(plan.pictures / "picture").string()});
  ProgressBoard board;
  Console console(board, shows_progress(options.progress));
  if (!passed_over.empty()) console.warn(passed_over);
  board.begin("drawing", numbers.size());
  Counts counts;
  do_jobs(plan, numbers, {workers_of(options), options.job_time}, [&](JobResult result) {
    if (!result.is_unchanged) manifest.append(plan.jobs[result.job].outputs.front(), result.record);
    counts.add(result);
    records[result.job] = std::move(result.record);
    board.advance(1);
  });
  manifest.sync();
  console.print("");

  std::vector<JobRecord> done;
  for (const std::size_t number : numbers) done.push_back(std::move(records[number]));
  tell_failures(console, done);
  write_reports(options, done);
  std::fputs((counts.words(options.report) + "\n").c_str(), stdout);
  return counts.failed == 0 ? 0 : found_wrong_exit_code;
}

}  // namespace epura
