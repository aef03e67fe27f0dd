// SPDX-License-Identifier: Apache-2.0
// Runs epura as a user does, in a separate process, and returns its output.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "folder.hpp"

namespace epura::test {

struct Outcome {
  int code;  ///< exit code; 128 + number if it was ended by a signal
  std::string out, err;
  double megabytes = 0;  ///< the largest memory of the process, and of those that it waited for
};

/// A process that runs in parallel to the test.
class Running {
 public:
  /// Parameters as for `epura` below, which waits for the process.
  Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          const std::string& out_path = {}, const std::string& limits = {});
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

  void signal(int number) const;
  /// Its standard error so far.
  [[nodiscard]] std::string err() const;
  [[nodiscard]] Outcome wait();

 private:
  Folder scratch_;
  bool keeps_out_;
  std::string out_, err_;
  pid_t child_ = 0;  ///< 0 after it has ended
};

/// Runs the program with `arguments` in `folder`; the environment is that of the test, without $EPURA_PLUGIN_PATH.
/// Standard output goes to `out`, or to the file `out_path` if given. `limits` are shell commands to run before the
/// program: "ulimit -n 4".
Outcome epura(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
              const std::string& out_path = {}, const std::string& limits = {});

/// The root of the repository.
inline std::filesystem::path root() { return std::filesystem::path(EPURA_TEST_SAMPLES).parent_path(); }
inline std::string sample(const std::string& name) { return EPURA_TEST_SAMPLES "/models/" + name; }

/// The names of the projections of the program, in the order of their bytes. Their files are not loaded: a program that
/// tries something with each of them lists the names whenever it starts.
std::vector<std::string> built_in_projections();

}  // namespace epura::test
