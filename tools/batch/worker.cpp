// SPDX-License-Identifier: Apache-2.0
#include "batch/worker.hpp"

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "app/commands.hpp"
#include "app/confinement.hpp"
#include "app/describe.hpp"
#include "app/draw_files.hpp"
#include "app/hash.hpp"
#include "app/resource_limit.hpp"
#include "base/broken.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "batch/report.hpp"
#include "foreign/folders.hpp"
#include "foreign/messages.hpp"
#include "importer/catalogue.hpp"
#include "importer/read_model.hpp"
#include "output/write.hpp"
#include "projection/catalogue.hpp"
#include "sheet/installed_fonts.hpp"
#include "sheet/lettering.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_of_request = sizeof(std::size_t);

// The largest memory of this process since the last call of forget_peak, MB; 0 if Linux does not tell.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:" && status >> word)
      if (const auto kibibytes = parse_number(word)) return *kibibytes * 1024 / bytes_of_megabyte;
  return 0;
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::string percent_decoded(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto digit = [&](std::size_t i) {
    return i < text.size() ? digits.find(to_lower(text.substr(i, 1))) : digits.npos;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && digit(i + 1) != digits.npos && digit(i + 2) != digits.npos;
    result += is_code ? static_cast<char>(16 * digit(i + 1) + digit(i + 2)) : text[i];
    if (is_code) i += 2;
  }
  return result;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (const std::string_view line : split(text, '\n'))
    if (!line.empty()) lines.push_back(one_line(line));
  return lines;
}

// The files that a glTF file refers to by "uri": its buffers; other formats have everything in one file.
std::vector<fs::path> files_named_in(const fs::path& model, const std::string& bytes) {
  std::vector<fs::path> files;
  if (to_lower(model.extension().string()) != ".gltf") return files;
  constexpr std::string_view key = "\"uri\"";
  for (std::size_t at = bytes.find(key); at != std::string::npos; at = bytes.find(key, at + 1)) {
    const std::size_t begin = bytes.find('"', at + key.size());
    const std::size_t end = begin == std::string::npos ? begin : bytes.find('"', begin + 1);
    if (end == std::string::npos) break;
    const fs::path file = model.parent_path() / percent_decoded(bytes.substr(begin + 1, end - begin - 1));
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) files.push_back(file);
  }
  return files;
}

// Everything that a drawing depends on besides the basis.
std::string key_of(const Job& job, const DrawOptions& options, const std::string& basis) {
  std::string text = basis;
  const auto add = [&](const std::string& part) { text += '\0' + part; };
  for (const std::string& output : job.outputs) add(output);
  for (const LaterOption& setting : job.settings) {
    add(setting.flag);
    if (const std::string* value = std::get_if<std::string>(&setting.value.content)) add(*value);
    if (const double* value = std::get_if<double>(&setting.value.content)) add(format_number(*value));
    if (const bool* value = std::get_if<bool>(&setting.value.content)) add(*value ? "true" : "false");
  }
  for (const std::string& input : inputs_of(options, describe(options))) {
    const fs::path path = importer::parse_model_request(input).path;
    const std::string bytes = read_file(path);
    add(input);
    add(hash_of_bytes(bytes));
    for (const fs::path& file : files_named_in(path, bytes)) add(hash_of_file(file));
  }
  return hash_of_bytes(text);
}

bool are_unchanged(const std::vector<WrittenFile>& files) {
  for (const WrittenFile& file : files) {
    std::error_code ignored;
    if (!fs::is_regular_file(file.path, ignored) || hash_of_file(file.path) != file.hash) return false;
  }
  return !files.empty();
}

bool has_picture(const JobRecord& record, const std::string& picture) {
  return picture.empty() || (record.picture.path == picture && are_unchanged({record.picture}));
}

const JobRecord* earlier_record(const BatchPlan& plan, const Job& job) {
  const auto found = plan.records.find(job.outputs.front());
  return found != plan.records.end() ? &found->second : nullptr;
}

// The file for a small picture of a job; empty if none is wanted or an output is one.
std::string picture_of(const BatchPlan& plan, const Job& job) {
  if (plan.pictures.empty() || std::any_of(job.outputs.begin(), job.outputs.end(), is_picture)) return {};
  return (plan.pictures / (hash_of_bytes(job.outputs.front()) + ".png")).string();
}

void write_picture(const sheet::Sheet& sheet, const std::string& path) {
  constexpr double pixels = 480, millimetres_of_inch = 25.4;
  const double dpi = pixels * millimetres_of_inch / std::max(sheet.width, sheet.height);
  write_file(path, output::to_png(sheet, std::clamp(dpi, 1.0, 300.0)));
}

void draw_job(const DrawOptions& options, const std::string& picture, JobRecord& record) {
  create_folders(options.outputs);
  ProgressBoard board;
  const auto keep = [&](std::string_view text) {
    for (std::string& line : lines_of(text)) record.messages.push_back(std::move(line));
  };
  const auto keep_warning = [&](const std::string& sentence) {
    keep(sentence);
    ++record.warnings;
  };
  const pipeline::Messages messages{keep_warning, keep};
  const DrawnFiles drawn = draw_files(options, messages, Progress(board, options.run.time_limit));
  tell_the_end(messages, options, drawn);
  record.code = exit_code_of(drawn);
  for (const std::string& path : drawn.paths) record.outputs.push_back({path, hash_of_file(path)});
  if (picture.empty() || drawn.sheets.empty()) return;
  write_picture(drawn.sheets.front().sheet, picture);
  record.picture = {picture, hash_of_file(picture)};
}

void add_error(JobRecord& record, const Error& error) {
  record.code = static_cast<int>(error.kind());
  record.messages.push_back(one_line(error.what()));
  if (!error.hint().empty()) record.messages.push_back(one_line("hint: " + error.hint()));
}

void pack(foreign::Packer& message, const WrittenFile& file) {
  // As bytes, since text is made safe for display.
  message(std::vector<char>(file.path.begin(), file.path.end()));
  message(file.hash);
}

void unpack_file(foreign::Unpacker& unpack, WrittenFile& file) {
  std::vector<char> path;
  unpack(path);
  file.path.assign(path.begin(), path.end());
  unpack(file.hash);
}

foreign::Packer packed(const JobResult& result) {
  foreign::Packer message;
  const JobRecord& record = result.record;
  message(result.job);
  message(result.is_unchanged);
  message(record.key);
  message(record.code);
  message(record.warnings);
  message(record.seconds);
  message(record.megabytes);
  message(record.messages);
  message(record.outputs.size());
  for (const WrittenFile& file : record.outputs) pack(message, file);
  pack(message, record.picture);
  return message;
}

void add_libraries(std::string& text, const std::vector<fs::path>& folders) {
  std::vector<foreign::BadPlugin> bad;
  for (const fs::path& folder : folders)
    for (const fs::path& library : foreign::libraries_in(folder, bad))
      text += '\0' + library.string() + '\0' + hash_of_file(library);
}

/// Returns why it cannot be done; empty if it is.
std::string confine_to_jobs(const BatchPlan& plan) {
  try {
    NamedFiles files = files_of(plan.jobs);
    if (!plan.pictures.empty()) files.outputs.push_back((plan.pictures / "picture").string());
    foreign::enter_sandbox(permissions_for(files, plan.common.run, plan.common.sheet));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

JobResult refused(const BatchPlan& plan, std::size_t number, const std::string& reason) {
  JobResult result{number, false, {.name = plan.jobs[number].name}};
  add_error(result.record, Error(ErrorKind::plugin, result.record.name, reason, "--sandbox off does without"));
  return result;
}

}  // namespace

std::string basis_of(const BatchOptions& options) {
  std::string text = EPURA_VERSION;
  for (const std::string& word : options.words) text += '\0' + word;
  add_libraries(text, projection::plugin_folders(options.sources.draw.run.plugin_path));
  add_libraries(text, importer::importer_folders(options.sources.draw.run.plugin_path));
  std::error_code missing;
  const scene::LocatedText& font = options.sources.draw.sheet.font;
  const fs::path file = font.given() ? sheet::find_font(*font, font.where).file : sheet::Lettering::usual_font();
  if (fs::exists(file, missing)) text += '\0' + hash_of_file(file);
  return hash_of_bytes(text);
}

JobResult do_job(const BatchPlan& plan, std::size_t number) {
  const auto start = std::chrono::steady_clock::now();
  const Job& job = plan.jobs[number];
  JobResult result{number, false, {.name = job.name}};
  forget_peak();
  try {
    const DrawOptions options = options_of(job, plan.common);
    result.record.key = key_of(job, options, plan.basis);
    const std::string picture = picture_of(plan, job);
    const JobRecord* earlier = earlier_record(plan, job);
    if (earlier != nullptr && earlier->is_good() && earlier->key == result.record.key &&
        are_unchanged(earlier->outputs) && has_picture(*earlier, picture))
      return {number, true, *earlier};
    draw_job(options, picture, result.record);
  } catch (const Error& error) {
    add_error(result.record, error);
  } catch (const std::bad_alloc&) {
    const std::string limit = plan.job_memory ? "takes more than " + format_number(*plan.job_memory) + " MB"
                                              : std::string("not enough memory for this model");
    add_error(result.record, Error(ErrorKind::input, job.name, limit));
  } catch (const Broken& error) {
    result.record.code = broken_exit_code;
    result.record.messages.push_back(one_line(std::string("internal error: this does not hold: ") + error.what()));
  } catch (const std::exception& error) {
    add_error(result.record, Error(ErrorKind::input, job.name, error.what()));
  }
  result.record.megabytes = peak_megabytes();
  result.record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void serve_jobs(int socket, const BatchPlan& plan) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (plan.job_memory) limit_resource(RLIMIT_DATA, *plan.job_memory);
  const std::string reason = plan.common.run.sandbox == pipeline::Sandbox::off ? "" : confine_to_jobs(plan);
  foreign::Incoming incoming;
  while (incoming.receive(socket, std::nullopt, max_of_request) == foreign::Received::all) {
    std::size_t number = 0;
    const std::string message = incoming.take();
    foreign::Unpacker{message}(number);
    if (number >= plan.jobs.size()) return;
    const JobResult result = reason.empty() ? do_job(plan, number) : refused(plan, number, reason);
    if (!foreign::send_message(socket, packed(result))) return;
    ::malloc_trim(0);
  }
}

JobResult unpack_result(const std::string& message) {
  foreign::Unpacker unpack(message);
  JobResult result;
  JobRecord& record = result.record;
  unpack(result.job);
  unpack(result.is_unchanged);
  unpack(record.key);
  unpack(record.code);
  unpack(record.warnings);
  unpack(record.seconds);
  unpack(record.megabytes);
  unpack(record.messages);
  record.outputs.resize(unpack.count(2 * sizeof(std::size_t)));
  for (WrittenFile& file : record.outputs) unpack_file(unpack, file);
  unpack_file(unpack, record.picture);
  return result;
}

}  // namespace epura
