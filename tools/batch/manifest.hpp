// SPDX-License-Identifier: Apache-2.0
// What a batch made from what: a file with a line of JSON for each job, to which finished jobs are appended.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch/shards.hpp"

namespace epura {

/// A file that was written, and the hash of its contents.
struct WrittenFile {
  std::string path, hash;
};

/// A finished job.
struct JobRecord {
  std::string name{};
  std::string key{};  ///< hash of all that the drawing depends on
  std::vector<WrittenFile> outputs{};
  WrittenFile picture{};  ///< of the first sheet, for the report; without a path: none was needed
  int code = 0;           ///< exit code, as of `epura draw`
  int warnings = 0;       ///< their number among the messages
  double seconds = 0, megabytes = 0;
  std::vector<std::string> messages{};  ///< of the run, with its warnings and errors

  [[nodiscard]] bool is_good() const { return code == 0; }
};

/// Records by the first output of their jobs: of several for one output, the last one counts.
using JobRecords = std::map<std::string, JobRecord>;

/// The records of a file; none if there is no such file. A last line without its end, as after a power failure, and
/// damaged lines count as not written. Throws Error{input} for a file that is no manifest.
JobRecords read_manifest(const std::filesystem::path& file);

/// Appends records to a file. Only one batch can write to it.
class ManifestWriter {
 public:
  /// Throws Error{output} if the file cannot be written, or another batch is writing to it.
  explicit ManifestWriter(const std::filesystem::path& file);
  ManifestWriter(const ManifestWriter&) = delete;
  ManifestWriter& operator=(const ManifestWriter&) = delete;
  ~ManifestWriter();

  /// Survives the end of this process, and, except for the last second, a power failure. `output` is the first one of
  /// the job. Throws Error{output}.
  void append(const std::string& output, const JobRecord& record);
  /// Makes the last second survive a power failure, too. Throws Error{output}.
  void sync();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path file_;
  int descriptor_;
  Clock::time_point synced_ = Clock::now();
};

/// "out/epura-batch.jsonl", and "out/epura-batch.2-of-8.jsonl" for a part.
std::filesystem::path manifest_of_shard(const std::filesystem::path& whole, const Shard& shard);

/// Writes the records of the whole manifest and of all its parts to the whole one, sorted by output, and returns them.
/// Throws Error{input} if a part is missing.
JobRecords merge_manifests(const std::filesystem::path& whole);

}  // namespace epura
