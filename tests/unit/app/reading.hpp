// SPDX-License-Identifier: Apache-2.0
// Runs that last as long as a test wants: they wait for their model at a pipe.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "folder.hpp"
#include "program.hpp"

namespace epura::test {

inline std::string pipe_in(const Folder& folder, const std::string& name) {
  const std::string path = (folder / name).string();
  EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
  return path;
}

/// The writing end of a pipe that a run reads; -1 if it never does.
inline int open_for_writing(const std::string& pipe) {
  for (int i = 0; i < 1000; ++i) {
    const int end = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (end >= 0) return end;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return -1;
}

/// A run that waits for its model, which comes through a pipe.
struct Reading {
  Folder folder;
  std::string model = pipe_in(folder, "model.obj");
  Running run;
  int pipe;

  explicit Reading(const std::vector<std::string>& options = {}, const std::string& limits = {})
      : run(arguments(options), folder / "", {}, limits) {
    pipe = open_for_writing(model);
    EXPECT_GE(pipe, 0);
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() { ::close(pipe); }

  /// The run goes on.
  void give_model(const std::string& text = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n") {
    ::fcntl(pipe, F_SETFL, 0);  // blocks while the pipe is full
    EXPECT_EQ(::write(pipe, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(std::exchange(pipe, -1));
  }

  /// Until the progress line is shown.
  void wait_for_line() const {
    for (int i = 0; i < 2000 && run.err().empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }

 private:
  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& options) const {
    std::vector<std::string> all{"draw", model, "-o", "x.svg"};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }
};

}  // namespace epura::test
