// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/jobs.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/draw_options.hpp"
#include "app/jobs/job_table.hpp"
#include "app/jobs/placeholders.hpp"
#include "app/jobs/sources.hpp"
#include "base/error.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "importer/bounds.hpp"
#include "importer/read_model.hpp"
#include "scene/choices.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

// "output" for "-o,--output", "models" for "models".
std::string column_of(const scene::OptionInfo& option) {
  const std::string name = option.flag.substr(option.flag.rfind(',') + 1);
  return name.starts_with("--") ? name.substr(2) : name;
}

constexpr const char* output_flag = "-o,--output";

bool is_output(const LaterOption& option) { return option.flag == output_flag; }

struct Column {
  std::string flag;
  bool is_repeatable = false;
  scene::OptionInfo option{};
  bool is_left_to_user = false;  ///< no table says it: it may be a stranger's
};

// Columns of a table by their names, with "file" and "model" for the models.
std::map<std::string, Column> columns() {
  std::map<std::string, Column> all;
  for (const scene::OptionInfo& option : job_options())
    if (!option.flag.empty())
      all[column_of(option)] = {option.flag, option.repeatable, option,
                                option.nature == scene::Nature::code || option.flag == "--sandbox"};
  all["file"] = all["model"] = all["models"];
  return all;
}

// The texts of a list are those of an option that is repeated; TOML tables have lists.
std::vector<scene::TomlValue> values_of(const scene::TomlValue& value, const Column& column) {
  const auto* list = std::get_if<scene::TomlList>(&value.content);
  const auto is_text = [](const scene::TomlValue& one) { return std::holds_alternative<std::string>(one.content); };
  const bool is_repeated = list != nullptr && column.is_repeatable && !list->values.empty() &&
                           std::all_of(list->values.begin(), list->values.end(), is_text);
  return is_repeated ? list->values : std::vector{value};
}

std::string text_of(const scene::TomlValue& value) {
  const std::string* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) scene::refuse(value, "must be text");
  return *text;
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
  job.estimate = estimated_time(job.models);
  return job;
}

const Column& column_named(const std::string& name, const TableRow& row, const std::map<std::string, Column>& known) {
  if (const auto found = known.find(name); found != known.end()) {
    if (found->second.is_left_to_user)
      throw Error(ErrorKind::input, row.where, "a table must not say '" + name + "', since it may be a stranger's",
                  "write --" + name + " on the command line, for all jobs");
    return found->second;
  }
  std::vector<std::string> names;
  for (const auto& [other, column] : known) names.push_back(other);
  throw Error(ErrorKind::input, row.where, "unknown column '" + name + "'", did_you_mean(name, names));
}

// Paths in a table are relative to its folder, as in scene files.
std::string path_in_table(const scene::TomlValue& value, const TableRow& row) {
  return (fs::path(row.where).parent_path() / text_of(value)).string();
}

bool gives_file(const Column& column, const scene::TomlValue& value) {
  const std::string* text = std::get_if<std::string>(&value.content);
  return names_file(column.option, text != nullptr ? *text : "");
}

// What holds for scene files holds for tables: they name only what lies below their folders.
// Outputs and settings count if the row gives them by these flags.
void expect_files_below(const Job& job, const TableRow& row, const std::set<std::string>& flags) {
  const auto expect = [&](const std::string& file) {
    if (!lies_below(file, fs::path(row.where).parent_path()))
      throw Error(ErrorKind::input, row.where, "'" + file + "' lies outside the folder of the table",
                  "--allow-outside allows it, if you trust the table");
  };
  for (const std::string& model : job.models) {
    const importer::ModelRequest request = importer::parse_model_request(model);
    expect(request.path);
    for (const auto& [key, value] : request.parameters)
      if (importer::is_bound(key))
        throw Error(ErrorKind::input, row.where, "'" + key + "' changes what reading the file may take",
                    "--allow-outside allows it, if you trust the table");
  }
  if (flags.count(output_flag) > 0)
    for (const std::string& output : job.outputs) expect(output);
  for (const LaterOption& setting : job.settings)
    if (flags.count(setting.flag) > 0) expect(text_of(setting.value));
}

void append_row(std::vector<Job>& jobs, const TableRow& row, const std::map<std::string, Column>& known,
                const JobSources& sources) {
  std::vector<std::string> models;
  std::vector<LaterOption> later;
  std::set<std::string> flags_of_files;
  for (const auto& [name, cell] : row.cells) {
    const Column& column = column_named(name, row, known);
    for (const scene::TomlValue& value : values_of(cell, column)) {
      if (column.flag == "models") {
        models.push_back(path_in_table(value, row));
        continue;
      }
      later.push_back({column.flag, value});
      if (!gives_file(column, value)) continue;
      later.back().value.content = path_in_table(value, row);
      flags_of_files.insert(column.flag);
    }
  }
  if (models.empty()) throw Error(ErrorKind::input, row.where, "has no model", "add a column 'file'");
  std::vector<LaterOption> all;
  for (const LaterOption& common : sources.later)
    if (!is_output(common) || flags_of_files.count(output_flag) == 0) all.push_back(common);
  all.insert(all.end(), later.begin(), later.end());
  jobs.push_back(finished(std::move(models), all, jobs.size() + 1));
  if (!sources.draw.run.allow_outside) expect_files_below(jobs.back(), row, flags_of_files);
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

// Rows of a table may have the same model.
void tell_apart(std::vector<Job>& jobs) {
  std::map<std::string, int> counts;
  for (const Job& job : jobs) ++counts[job.name];
  for (Job& job : jobs)
    if (counts.at(job.name) > 1) job.name += " (" + job.outputs.front() + ")";
}

}  // namespace

scene::Options<DrawOptions> job_options() {
  scene::Options<DrawOptions> options = draw_options();
  std::erase_if(options, [](const scene::OptionInfo& option) {
    const bool is_for_files = option.flag == "models" || option.flag == output_flag;
    return option.flag == "--format" ||
           (option.nature == scene::Nature::run && !is_for_files && option.flag != "--threads" &&
            option.flag != "--time-limit" && option.flag != "--sandbox" && option.flag != "--verify" &&
            option.flag != "--verify-samples");
  });
  return options;
}

namespace {

std::string sentence_of(const std::vector<std::string>& passed_over) {
  if (passed_over.empty()) return {};
  const std::size_t more = passed_over.size() - 1;
  return passed_over.front() + (more > 0 ? " and " + std::to_string(more) + " more are" : " is") +
         " passed over, since names that begin with a dot are drawn only where they are given themselves";
}

}  // namespace

JobPlan plan_jobs(const JobSources& sources) {
  for (const LaterOption& later : sources.later)
    if (is_output(later)) expect_known_placeholders(text_of(later.value), "--output");
  std::vector<Job> jobs;
  const FoundModels found = models_of_sources(sources.draw.models, sources.draw.run.plugin_path);
  for (const std::string& model : found.models) jobs.push_back(finished({model}, sources.later, jobs.size() + 1));
  const std::map<std::string, Column> known = columns();
  for (const std::string& table : sources.tables)
    for (const TableRow& row : read_job_table(table)) append_row(jobs, row, known, sources);
  if (jobs.empty())
    throw Error(ErrorKind::input, "command line", "there are no jobs", "name models, folders, patterns or a --table");
  refuse_equal_outputs(jobs);
  tell_apart(jobs);
  return {std::move(jobs), sentence_of(found.passed_over)};
}

void create_folders(const std::vector<std::string>& outputs) {
  for (const std::string& output : outputs) {
    const fs::path folder = fs::path(output).parent_path();
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) throw Error(ErrorKind::output, folder.string(), "cannot be created: " + error.message());
  }
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

namespace fs = std::filesystem;

namespace {

// Measured with 47 models on sheets of three views: docs/scale.md.
constexpr double start = 2000, microseconds_of_triangle = 20;
constexpr double start_of_tessellation = 100'000, microseconds_of_exact_byte = 1.2;

std::string head_of(const fs::path& file) {
  constexpr std::streamsize size = 4096;
  std::string head(size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), size);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

double triangles_of_stl(const std::string& head, std::uintmax_t size) {
  constexpr std::size_t header = 80, count_size = 4, facet_size = 50, text_size = 250;
  if (head.size() < header + count_size) return 0;
  std::uintmax_t count = 0;
  for (std::size_t i = header + count_size; i-- > header;) count = 256 * count + static_cast<unsigned char>(head[i]);
  const bool is_binary = size == header + count_size + facet_size * count;
  return static_cast<double>(is_binary ? count : size / text_size);
}

double triangles_of_ply(const std::string& head) {
  constexpr std::string_view element = "element face ";
  const std::size_t at = head.find(element);
  if (at == std::string::npos) return 0;
  const std::size_t begin = at + element.size();
  const std::size_t end = head.find_first_of("\r\n", begin);
  return static_cast<double>(parse_integer(std::string_view(head).substr(begin, end - begin)).value_or(0));
}

// OFF, the number of vertices, and that of faces; comments may stand between them.
double triangles_of_off(const std::string& head) {
  int words = 0;
  for (std::string_view line : split(head, '\n')) {
    line = line.substr(0, line.find_first_of("#\r"));
    for (const std::string_view word : split(line, ' '))
      if (!word.empty() && ++words == 3) return static_cast<double>(parse_integer(word).value_or(0));
  }
  return 0;
}

double triangles_of(const fs::path& file, const std::string& extension, std::uintmax_t size) {
  if (extension == ".stl") return triangles_of_stl(head_of(file), size);
  if (extension == ".ply") return triangles_of_ply(head_of(file));
  if (extension == ".off") return triangles_of_off(head_of(file));
  static const std::map<std::string, double> bytes_of_triangle{{".glb", 30}, {".gltf", 30}, {".3mf", 10}};
  constexpr double bytes_of_text = 35;
  const auto known = bytes_of_triangle.find(extension);
  return static_cast<double>(size) / (known != bytes_of_triangle.end() ? known->second : bytes_of_text);
}

bool is_exact(const std::string& extension) {
  return extension == ".step" || extension == ".stp" || extension == ".iges" || extension == ".igs" ||
         extension == ".brep";
}

}  // namespace

double estimated_time(const std::vector<std::string>& models) {
  double sum = start;
  for (const std::string& model : models) {
    const fs::path file(importer::parse_model_request(model).path);
    const std::string extension = to_lower(file.extension().string());
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(file, missing);
    if (missing) continue;
    sum += is_exact(extension) ? start_of_tessellation + microseconds_of_exact_byte * static_cast<double>(size)
                               : microseconds_of_triangle * triangles_of(file, extension, size);
  }
  return sum;
}

}  // namespace epura
