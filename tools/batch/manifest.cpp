// SPDX-License-Identifier: Apache-2.0
#include "batch/manifest.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "compare/json_document.hpp"
#include "output/json_text.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

using compare::JsonDocument;
using JsonValue = JsonDocument::ValueType;

std::string line_of(const std::string& output, const JobRecord& record) {
  using output::json_string;
  const auto write_output = [](const WrittenFile& file) {
    return json_string(file.path) + ": " + json_string(file.hash);
  };
  std::string outputs;
  for (const WrittenFile& file : record.outputs) append_to_list(outputs, write_output(file));
  return "{\"output\": " + json_string(output) + ", \"job\": " + json_string(record.name) +
         ", \"key\": " + json_string(record.key) + ", \"code\": " + std::to_string(record.code) +
         ", \"warnings\": " + std::to_string(record.warnings) + ", \"seconds\": " + format_rounded(record.seconds, 4) +
         ", \"MB\": " + format_rounded(record.megabytes, 4) + ", \"outputs\": {" + outputs + "}" +
         (record.picture.path.empty() ? "" : ", \"picture\": {" + write_output(record.picture) + "}") +
         ", \"messages\": " +
         output::json_list(record.messages, [](const std::string& message) { return json_string(message); }) + "}\n";
}

std::string text_in(const JsonValue& object, const char* key) {
  const auto found = object.FindMember(key);
  if (found == object.MemberEnd() || !found->value.IsString()) return {};
  return {found->value.GetString(), found->value.GetStringLength()};
}

int whole_number_in(const JsonValue& object, const char* key, int otherwise) {
  const auto found = object.FindMember(key);
  return found != object.MemberEnd() && found->value.IsInt() ? found->value.GetInt() : otherwise;
}

double number_in(const JsonValue& object, const char* key) {
  const auto found = object.FindMember(key);
  return found != object.MemberEnd() && found->value.IsNumber() ? found->value.GetDouble() : 0;
}

std::vector<WrittenFile> files_in(const JsonValue& object, const char* key) {
  std::vector<WrittenFile> files;
  if (const auto found = object.FindMember(key); found != object.MemberEnd() && found->value.IsObject())
    for (const auto& file : found->value.GetObject())
      files.push_back({file.name.GetString(), file.value.IsString() ? file.value.GetString() : ""});
  return files;
}

void read_record(const JsonValue& object, JobRecords& records) {
  JobRecord record{.name = text_in(object, "job"),
                   .key = text_in(object, "key"),
                   .code = whole_number_in(object, "code", 1),  // a job with a damaged code has failed
                   .warnings = whole_number_in(object, "warnings", 0),
                   .seconds = number_in(object, "seconds"),
                   .megabytes = number_in(object, "MB")};
  record.outputs = files_in(object, "outputs");
  for (WrittenFile& file : files_in(object, "picture")) record.picture = std::move(file);
  if (const auto messages = object.FindMember("messages"); messages != object.MemberEnd() && messages->value.IsArray())
    for (const auto& message : messages->value.GetArray())
      if (message.IsString()) record.messages.emplace_back(message.GetString());
  records[text_in(object, "output")] = std::move(record);
}

[[noreturn]] void fail(const fs::path& file, const std::string& what, const std::string& hint = {}) {
  throw Error(ErrorKind::output, file.string(), what, hint);
}

// The parts beside a whole manifest, by their numbers.
std::set<std::pair<Shard, fs::path>> parts_of(const fs::path& whole) {
  std::set<std::pair<Shard, fs::path>> parts;
  const std::string stem = whole.stem().string() + ".", extension = whole.extension().string();
  const fs::path folder = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
  for (const std::string& name : names_in(folder)) {
    if (!name.starts_with(stem) || !name.ends_with(extension) || name.size() <= stem.size() + extension.size())
      continue;
    const std::string numbers = name.substr(stem.size(), name.size() - stem.size() - extension.size());
    const std::size_t of = numbers.find("-of-");
    if (of == std::string::npos) continue;
    const auto number = parse_integer(numbers.substr(0, of)), count = parse_integer(numbers.substr(of + 4));
    if (number && count) parts.insert({{static_cast<int>(*number), static_cast<int>(*count)}, folder / name});
  }
  return parts;
}

// The workers of a batch that was killed have its lock until the system has ended them, a moment later.
bool locks(int descriptor) {
  constexpr std::chrono::milliseconds patience(2000), pause(20);
  const auto end = std::chrono::steady_clock::now() + patience;
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK || std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}

}  // namespace

JobRecords read_manifest(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  const std::string bytes = read_file(file);
  if (!bytes.empty() && !bytes.starts_with("{\"output\""))
    throw Error(ErrorKind::input, file.string(), "is not the manifest of a batch", "name another file by --manifest");
  JobRecords records;
  std::string_view rest = bytes;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    JsonDocument document;
    document.Parse(rest.data(), end);
    if (!document.HasParseError() && document.IsObject()) read_record(document, records);
    rest.remove_prefix(end + 1);
  }
  return records;
}

ManifestWriter::ManifestWriter(const fs::path& file) : file_(file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(file, std::string("cannot be written: ") + std::strerror(errno));
  if (locks(descriptor_)) {
    // Ends a line that a power failure cut off.
    char last = '\n';
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    if (size > 0 && ::pread(descriptor_, &last, 1, size - 1) == 1 && last != '\n' && ::write(descriptor_, "\n", 1) == 1)
      return;
    return;
  }
  ::close(descriptor_);
  fail(file, "another batch is writing to it", "wait for its end, or write to another folder or --manifest");
}

ManifestWriter::~ManifestWriter() { ::close(descriptor_); }

void ManifestWriter::append(const std::string& output, const JobRecord& record) {
  const std::string line = line_of(output, record);
  // One write, so that readers see whole lines; more only where the system takes a part.
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(file_, std::string("cannot be written: ") + std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  constexpr std::chrono::seconds at_risk(1);
  if (Clock::now() - synced_ > at_risk) sync();
}

void ManifestWriter::sync() {
  synced_ = Clock::now();
  int synced = 0;
  do synced = ::fdatasync(descriptor_);
  while (synced != 0 && errno == EINTR);
  if (synced != 0 && errno != EINVAL && errno != EROFS)
    fail(file_, std::string("cannot be written: ") + std::strerror(errno));
}

fs::path manifest_of_shard(const fs::path& whole, const Shard& shard) {
  if (shard.is_whole()) return whole;
  fs::path name = whole.stem();
  name += "." + std::to_string(shard.number) + "-of-" + std::to_string(shard.count);
  name += whole.extension();
  return whole.parent_path() / name;
}

JobRecords merge_manifests(const fs::path& whole) {
  JobRecords records = read_manifest(whole);
  const auto parts = parts_of(whole);
  if (parts.empty())
    throw Error(ErrorKind::input, whole.string(), "has no parts beside it",
                "run epura batch with --shard first, with the same outputs or --manifest");
  const int count = parts.begin()->first.count;
  for (const auto& [shard, file] : parts) {
    if (shard.count != count)
      throw Error(ErrorKind::input, file.string(),
                  "lies beside a part of a batch in " + std::to_string(count) + " parts",
                  "remove the parts of the older batch");
    for (int number = 1; number <= shard.count; ++number)
      if (!fs::exists(manifest_of_shard(whole, {number, shard.count})))
        throw Error(ErrorKind::input, whole.string(),
                    "part " + std::to_string(number) + " of " + std::to_string(shard.count) + " is missing",
                    "run epura batch with --shard " + std::to_string(number) + "/" + std::to_string(shard.count));
    for (auto& [output, record] : read_manifest(file)) records[output] = std::move(record);
  }
  std::string text;
  for (const auto& [output, record] : records) text += line_of(output, record);
  write_file(whole, text);
  return records;
}

}  // namespace epura
