// SPDX-License-Identifier: Apache-2.0
#include "app/batch/jobs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "app/batch/job_table.hpp"
#include "app/batch/placeholders.hpp"
#include "app/batch/sources.hpp"
#include "app/draw_options.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

// "output" for "-o,--output", "models" for "models".
std::string column_of(const scene::OptionInfo& option) {
  const std::string name = option.flag.substr(option.flag.rfind(',') + 1);
  return name.starts_with("--") ? name.substr(2) : name;
}

bool is_output(const LaterOption& option) { return option.flag.ends_with("--output"); }

// Columns of a table by their names, with "file" and "model" for the models.
std::map<std::string, std::string> columns() {
  std::map<std::string, std::string> flags;
  for (const scene::OptionInfo& option : job_options())
    if (!option.flag.empty()) flags[column_of(option)] = option.flag;
  flags["file"] = flags["model"] = "models";
  return flags;
}

std::string text_of(const scene::TomlValue& value) {
  const std::string* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) scene::refuse(value, "must be text");
  return *text;
}

// Text formats take longer for a byte, and STEP has to be tessellated. Measured on the models of samples/ and on parts
// of some thousand faces; what matters is their order.
double estimate_of(const std::vector<std::string>& models) {
  static const std::map<std::string, double> microseconds_of_byte{{".step", 0.6}, {".stp", 0.6},  {".iges", 0.6},
                                                                  {".igs", 0.6},  {".brep", 0.6}, {".stl", 0.02},
                                                                  {".glb", 0.04}, {".3mf", 0.2}};
  constexpr double start = 2000, other = 0.03;
  double sum = start;
  for (const std::string& model : models) {
    const fs::path path(importer::parse_model_request(model).path);
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(path, missing);
    const auto known = microseconds_of_byte.find(to_lower(path.extension().string()));
    if (!missing) sum += static_cast<double>(size) * (known != microseconds_of_byte.end() ? known->second : other);
  }
  return sum;
}

// Replaces placeholders, and separates outputs from other options.
Job finished(std::vector<std::string> models, const std::vector<LaterOption>& options, std::size_t number) {
  Job job{models.front(), std::move(models), {}, {}, 0};
  const PlaceholderValues values = values_for(job.name, number);
  for (const LaterOption& option : options) {
    if (is_output(option)) {
      job.outputs.push_back(filled_path(text_of(option.value), values));
    } else {
      job.settings.push_back(option);
      if (std::string* text = std::get_if<std::string>(&job.settings.back().value.content))
        *text = filled(*text, values);
    }
  }
  job.estimate = estimate_of(job.models);
  return job;
}

void append_row(std::vector<Job>& jobs, const TableRow& row, const std::map<std::string, std::string>& flags,
                const BatchOptions& options) {
  // Paths in a table are relative to its folder, as in scene files.
  const fs::path folder = fs::path(row.where).parent_path();
  std::vector<std::string> models;
  std::vector<LaterOption> later;
  bool has_output = false;
  for (const auto& [column, value] : row.cells) {
    const auto known = flags.find(column);
    std::vector<std::string> names;
    for (const auto& [name, flag] : flags) names.push_back(name);
    if (known == flags.end())
      throw Error(ErrorKind::input, row.where, "unknown column '" + column + "'", did_you_mean(column, names));
    if (known->second == "models") {
      models.push_back((folder / text_of(value)).string());
    } else {
      later.push_back({known->second, value});
      if (!is_output(later.back())) continue;
      later.back().value.content = (folder / text_of(value)).string();
      has_output = true;
    }
  }
  if (models.empty()) throw Error(ErrorKind::input, row.where, "has no model", "add a column 'file'");
  std::vector<LaterOption> all;
  for (const LaterOption& common : options.later)
    if (!has_output || !is_output(common)) all.push_back(common);
  all.insert(all.end(), later.begin(), later.end());
  jobs.push_back(finished(std::move(models), all, jobs.size() + 1));
}

std::string normal(const std::string& path) { return fs::path(path).lexically_normal().string(); }

void refuse_equal_outputs(const std::vector<Job>& jobs) {
  std::map<std::string, const Job*> writers;
  std::set<std::string> models;
  for (const Job& job : jobs)
    for (const std::string& model : job.models) models.insert(normal(model));
  for (const Job& job : jobs) {
    if (job.outputs.empty())
      throw Error(ErrorKind::input, job.name, "has no output", "add -o 'out/{folder}/{name}.pdf'");
    for (const std::string& output : job.outputs) {
      if (output == "-") throw Error(ErrorKind::input, "--output -", "a batch writes to files only");
      if (models.count(normal(output)) > 0)
        throw Error(ErrorKind::input, output, "is an output and also a model", "write to another folder");
      const auto [other, is_free] = writers.insert({normal(output), &job});
      if (!is_free)
        throw Error(ErrorKind::input, output, "would be written for " + other->second->name + " and for " + job.name,
                    "write -o 'out/{folder}/{name}.pdf', or add {number} or {hash}");
    }
  }
}

}  // namespace

scene::Options<DrawOptions> job_options() {
  scene::Options<DrawOptions> options = draw_options();
  std::erase_if(options, [](const scene::OptionInfo& option) {
    const bool is_for_files = option.flag == "models" || option.flag == "-o,--output";
    return option.flag == "--format" ||
           (option.nature == scene::Nature::run && !is_for_files && option.flag != "--threads" &&
            option.flag != "--time-limit" && option.flag != "--sandbox" && option.flag != "--verify" &&
            option.flag != "--verify-samples");
  });
  return options;
}

std::vector<Job> plan_jobs(const BatchOptions& options) {
  for (const LaterOption& later : options.later)
    if (is_output(later)) expect_known_placeholders(text_of(later.value), "--output");
  std::vector<Job> jobs;
  for (const std::string& model : models_of_sources(options.draw.models, options.draw.run.plugin_path))
    jobs.push_back(finished({model}, options.later, jobs.size() + 1));
  const std::map<std::string, std::string> flags = columns();
  for (const std::string& table : options.tables)
    for (const TableRow& row : read_job_table(table)) append_row(jobs, row, flags, options);
  if (jobs.empty())
    throw Error(ErrorKind::input, "command line", "there are no jobs", "name models, folders, patterns or a --table");
  refuse_equal_outputs(jobs);
  return jobs;
}

DrawOptions options_of(const Job& job, const DrawOptions& common) {
  static const scene::Options<DrawOptions> rows = job_options();
  DrawOptions options = common;
  options.models = job.models;
  options.outputs = job.outputs;
  for (const LaterOption& setting : job.settings)
    for (const scene::Option<DrawOptions>& row : rows)
      if (row.flag == setting.flag) row.read(options, setting.value);
  return options;
}

}  // namespace epura
