// SPDX-License-Identifier: Apache-2.0
// A drawing in the making, in a thread of its own: only Python's main thread runs handlers of signals, so it must not
// be the one that draws.
#pragma once

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <epura/epura.hpp>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace epura::python {

class Job {
 public:
  using Draw = std::function<Drawing(const Settings&)>;

  /// Begins. `projections` are those of epura/_projections.py; `kept` is what the drawing borrows from Python.
  Job(Draw draw, Settings settings, const pybind11::list& projections, pybind11::object kept);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  /// Waits for the end, without the interpreter's lock.
  ~Job();

  /// Returns whether it has ended, after at most so many seconds.
  bool wait(double seconds);
  /// The stage and its completed fraction, if they have changed since the last call.
  std::optional<std::pair<std::string, double>> news();
  /// Asks it to end soon, and interrupts a projection that is written in Python.
  void stop();
  /// After the end. Throws what the drawing has thrown.
  Drawing result();

 private:
  OwnProjection projection_of(const pybind11::dict& values);
  std::optional<std::string> project(pybind11::handle function, const std::vector<double>& values,
                                     const epura_scene& box, epura_view& view);
  void run(const Draw& draw);

  Settings settings_;
  pybind11::object kept_;
  std::stop_source stop_;
  unsigned long projecting_ = 0;  // the thread that runs Python code; protected by the interpreter's lock
  std::mutex mutex_;              // protects the next six
  std::condition_variable changed_;
  std::string stage_;
  double done_ = 0;
  bool has_news_ = false, has_ended_ = false;
  std::optional<Drawing> drawing_;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace epura::python
