// SPDX-License-Identifier: Apache-2.0
// Runs epura as a user does: a process of its own, and what it answers.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "folder.hpp"

namespace epura::test {

struct Outcome {
  int code;  ///< exit code; 128 + number when a signal ended it
  std::string out, err;
};

/// A run that goes on beside the test.
class Running {
 public:
  /// As `epura` below, which waits for it.
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
  pid_t child_ = 0;  ///< 0 when it has ended
};

/// Runs the program with `arguments` in `folder`; the environment is that of the test, without $EPURA_PLUGIN_PATH.
/// Standard output goes into `out`, or to the file `out_path` if one is named.
/// `limits` are commands of the shell before it: "ulimit -n 4".
Outcome epura(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
              const std::string& out_path = {}, const std::string& limits = {});

/// The root of the repository.
inline std::filesystem::path root() { return std::filesystem::path(EPURA_TEST_SAMPLES).parent_path(); }
inline std::string sample(const std::string& name) { return EPURA_TEST_SAMPLES "/models/" + name; }

}  // namespace epura::test
