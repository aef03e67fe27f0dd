// SPDX-License-Identifier: Apache-2.0
#include "job.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace py = pybind11;

namespace epura::python {

namespace {

using Triple = std::array<double, 3>;
/// A plane as epura/_projections.py returns it.
using PlaneValues =
    std::tuple<bool, Triple, Triple, Triple, Triple, double, std::array<double, 4>, std::pair<double, double>>;

void set_view(const PlaneValues& plane, epura_view& view) {
  const auto& [central, point, normal, up, projector, scale, window, limits] = plane;
  view.projectors = central ? EPURA_CENTRAL : EPURA_PARALLEL;
  std::copy(point.begin(), point.end(), view.point);
  std::copy(normal.begin(), normal.end(), view.normal);
  std::copy(up.begin(), up.end(), view.up);
  std::copy(projector.begin(), projector.end(), view.projector);
  view.scale = scale;
  std::copy(window.begin(), window.end(), view.window);
  view.front = limits.first;
  view.back = limits.second;
}

OwnParameter parameter_of(const py::dict& values) {
  OwnParameter parameter;
  parameter.name = py::cast<std::string>(values["name"]);
  parameter.initial = py::cast<std::vector<double>>(values["initial"]);
  parameter.choices = py::cast<std::vector<std::string>>(values["choices"]);
  parameter.unit = py::cast<std::string>(values["unit"]);
  parameter.help = py::cast<std::string>(values["help"]);
  parameter.least = py::cast<double>(values["least"]);
  parameter.most = py::cast<double>(values["most"]);
  return parameter;
}

}  // namespace

Job::Job(Draw draw, Settings settings, const py::list& projections, py::object kept)
    : settings_(std::move(settings)), kept_(std::move(kept)) {
  for (const py::handle& projection : projections)
    settings_.projections.push_back(projection_of(py::cast<py::dict>(projection)));
  settings_.stop = stop_.get_token();
  settings_.progress = [this](const std::string& stage, double done) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    done_ = done;
    has_news_ = true;
  };
  thread_ = std::thread([this, draw = std::move(draw)] { run(draw); });
}

Job::~Job() {
  const py::gil_scoped_release release;
  thread_.join();
}

void Job::run(const Draw& draw) {
  std::optional<Drawing> drawing;
  std::exception_ptr error;
  try {
    drawing = draw(settings_);
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  drawing_ = std::move(drawing);
  error_ = error;
  has_ended_ = true;
  changed_.notify_all();
}

bool Job::wait(double seconds) {
  const py::gil_scoped_release release;
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return has_ended_; });
}

std::optional<std::pair<std::string, double>> Job::news() {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(has_news_, false)) return std::nullopt;
  return std::pair(stage_, done_);
}

void Job::stop() {
  stop_.request_stop();
  if (projecting_ != 0) PyThreadState_SetAsyncExc(projecting_, PyExc_KeyboardInterrupt);
}

Drawing Job::result() {
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(error_);
  return drawing_.value();
}

OwnProjection Job::projection_of(const py::dict& values) {
  OwnProjection projection;
  projection.name = py::cast<std::string>(values["name"]);
  projection.family = py::cast<std::string>(values["family"]);
  projection.summary = py::cast<std::string>(values["summary"]);
  projection.reference = py::cast<std::string>(values["reference"]);
  projection.place = py::cast<std::string>(values["place"]);
  for (const py::handle& parameter : py::cast<py::list>(values["parameters"]))
    projection.parameters.push_back(parameter_of(py::cast<py::dict>(parameter)));
  // A borrowed reference, for copies are made and destroyed without the interpreter's lock; `kept` holds the function.
  const py::handle function = PyDict_GetItemString(values.ptr(), "project");
  projection.project = [this, function](const std::vector<double>& numbers, const epura_scene& box, epura_view& view) {
    return project(function, numbers, box, view);
  };
  return projection;
}

std::optional<std::string> Job::project(py::handle function, const std::vector<double>& values, const epura_scene& box,
                                        epura_view& view) {
  const py::gil_scoped_acquire gil;
  if (stop_.stop_requested()) throw std::runtime_error("was stopped");
  projecting_ = PyThread_get_thread_ident();
  std::string outcome;
  py::object answer;
  try {
    const py::tuple pair = function(values, Triple{box.least[0], box.least[1], box.least[2]},
                                    Triple{box.most[0], box.most[1], box.most[2]});
    projecting_ = 0;
    outcome = py::cast<std::string>(pair[0]);
    answer = pair[1];
    if (outcome == "plane") {
      set_view(py::cast<PlaneValues>(answer), view);
      return std::nullopt;
    }
  } catch (const std::exception& error) {
    projecting_ = 0;
    // Its text needs the interpreter's lock.
    throw std::runtime_error(std::string(error.what()));
  }
  const auto sentence = py::cast<std::string>(answer);
  if (outcome == "refused") return sentence;
  throw std::runtime_error(sentence);
}

}  // namespace epura::python
