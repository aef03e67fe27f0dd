// SPDX-License-Identifier: Apache-2.0
// epura._core: the library for Python. Dictionaries of plain values in, drawings out; epura/__init__.py is what users
// see. Names of members are those of include/epura/scene.hpp.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <epura/epura.hpp>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace py = pybind11;

namespace {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Faces = py::array_t<int, py::array::c_style | py::array::forcecast>;

epura::Polygons polygons_of(const Points& points, const py::list& face_arrays) {
  epura::Polygons polygons;
  const auto p = points.unchecked<2>();
  polygons.points.reserve(static_cast<std::size_t>(p.shape(0)));
  for (py::ssize_t i = 0; i < p.shape(0); ++i) polygons.points.push_back({p(i, 0), p(i, 1), p(i, 2)});
  for (const py::handle& group : face_arrays) {
    const auto faces = py::cast<Faces>(group);
    const auto f = faces.unchecked<2>();
    for (py::ssize_t i = 0; i < f.shape(0); ++i) polygons.faces.emplace_back(f.data(i, 0), f.data(i, 0) + f.shape(1));
  }
  return polygons;
}

epura::Model model_of(const py::dict& values) {
  epura::Model model;
  if (values.contains("file")) model.file = py::cast<std::string>(values["file"]);
  if (values.contains("points"))
    model.polygons = polygons_of(py::cast<Points>(values["points"]), py::cast<py::list>(values["faces"]));
  if (values.contains("name")) model.name = py::cast<std::string>(values["name"]);
  return model;
}

epura::View view_of(const py::dict& values) {
  epura::View view;
  view.projection = py::cast<std::string>(values["projection"]);
  for (const auto& [name, value] : py::cast<py::dict>(values["parameters"]))
    view.parameters.emplace_back(py::cast<std::string>(name), py::cast<epura::ParameterValue>(value));
  if (values.contains("hidden")) view.hidden = static_cast<epura::HiddenLines>(py::cast<int>(values["hidden"]));
  return view;
}

epura::SheetOptions sheet_of(const py::dict& values) {
  epura::SheetOptions sheet;
  if (values.contains("size")) sheet.size = py::cast<std::string>(values["size"]);
  if (values.contains("scale")) sheet.scale = py::cast<double>(values["scale"]);
  if (values.contains("title")) sheet.title_block.emplace_back("title", py::cast<std::string>(values["title"]));
  return sheet;
}

// What the drawing thread tells the thread that waits for it.
struct Watch {
  std::mutex mutex;
  std::condition_variable changed;
  std::string stage;
  double done = 0;
  bool news = false, ended = false;
};

void tell_news(Watch& watch, std::unique_lock<std::mutex>& lock, const py::object& progress) {
  const std::string stage = watch.stage;
  const double done = watch.done;
  const bool news = std::exchange(watch.news, false);
  lock.unlock();
  {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (news && !progress.is_none()) progress(stage, done);
  }
  lock.lock();
}

// Draws in a thread of its own: only the calling one may run the handlers of signals, and Ctrl-C must stop the drawing.
epura::Drawing draw_watched(const epura::Scene& scene, epura::Settings settings, const py::object& progress) {
  Watch watch;
  std::stop_source stop;
  std::optional<epura::Drawing> drawing;
  std::exception_ptr error;
  settings.stop = stop.get_token();
  settings.progress = [&](const std::string& stage, double done) {
    const std::lock_guard lock(watch.mutex);
    watch.stage = stage;
    watch.done = done;
    watch.news = true;
  };
  const py::gil_scoped_release release;
  std::thread worker([&] {
    try {
      drawing = epura::draw(scene, settings);
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(watch.mutex);
    watch.ended = true;
    watch.changed.notify_one();
  });
  try {
    std::unique_lock lock(watch.mutex);
    while (!watch.changed.wait_for(lock, std::chrono::milliseconds(50), [&] { return watch.ended; }))
      tell_news(watch, lock, progress);
  } catch (...) {
    stop.request_stop();
    worker.join();
    throw;
  }
  worker.join();
  if (error) std::rethrow_exception(error);
  return *drawing;
}

epura::Drawing draw(const py::list& models, const py::list& views, const py::dict& sheet, const py::dict& options,
                    const py::object& progress) {
  epura::Scene scene;
  for (const py::handle& model : models) scene.models.push_back(model_of(py::cast<py::dict>(model)));
  for (const py::handle& view : views) scene.views.push_back(view_of(py::cast<py::dict>(view)));
  if (!sheet.empty()) scene.sheets.push_back(sheet_of(sheet));
  epura::Settings settings;
  if (options.contains("centre_lines")) settings.centre_lines = py::cast<bool>(options["centre_lines"]);
  if (options.contains("arcs")) settings.arcs = py::cast<double>(options["arcs"]);
  if (options.contains("time_limit")) settings.time_limit = py::cast<double>(options["time_limit"]);
  if (options.contains("threads")) settings.threads = py::cast<int>(options["threads"]);
  return draw_watched(scene, settings, progress);
}

// One member of all lines as an array that borrows them: the drawing, which is immutable, lives as long as the array.
template <class Item>
py::array column(const py::object& drawing, const std::vector<epura::Line>& lines, const Item* first,
                 std::vector<py::ssize_t> shape) {
  shape.insert(shape.begin(), static_cast<py::ssize_t>(lines.size()));
  std::vector<py::ssize_t> strides(shape.size(), sizeof(Item));
  for (std::size_t i = shape.size() - 1; i > 1; --i) strides[i - 1] = strides[i] * shape[i];
  strides[0] = sizeof(epura::Line);
  py::array made(py::dtype::of<Item>(), shape, strides, first, drawing);
  made.attr("flags").attr("writeable") = false;
  return made;
}

py::dict lines_of(const py::object& self, std::size_t view) {
  const auto& views = py::cast<const epura::Drawing&>(self).views();
  if (view >= views.size()) throw py::index_error("there is no such view");
  const std::vector<epura::Line>& lines = views[view].lines;
  static_assert(sizeof(epura::EdgeKind) == 1 && offsetof(epura::Line, to) == 2 * sizeof(double));
  static const epura::Line nothing{};
  const epura::Line& first = lines.empty() ? nothing : lines.front();
  py::dict columns;
  columns["segments"] = column(self, lines, first.from.data(), {2, 2});
  columns["kind"] = column(self, lines, reinterpret_cast<const unsigned char*>(&first.kind), {});
  columns["visible"] = column(self, lines, &first.visible, {});
  columns["model"] = column(self, lines, &first.model, {});
  columns["body"] = column(self, lines, &first.body, {});
  columns["edge"] = column(self, lines, first.edge.data(), {2});
  columns["t"] = column(self, lines, first.t.data(), {2});
  return columns;
}

py::tuple view_facts(const epura::Drawing& drawing, std::size_t number) {
  const epura::DrawnView& view = drawing.views().at(number);
  return py::make_tuple(view.name, view.projection, view.sheet, view.scale, view.world_to_page);
}

// Released while bytes are made.
template <class Encode>
std::string encoded(const Encode& encode) {
  const py::gil_scoped_release release;
  return encode();
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const epura::Failure& failure) {
    const py::object made =
        py::module_::import("epura._errors")
            .attr("made")(static_cast<int>(failure.kind()), failure.place(), failure.what(), failure.hint());
    PyErr_SetObject(py::type::of(made).ptr(), made.ptr());
  }
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  py::register_exception_translator(translate);
  module.def("version", &epura::version);
  module.def("draw", &draw);
  py::class_<epura::Drawing>(module, "Drawing")
      .def_property_readonly("sheets", &epura::Drawing::sheets)
      .def_property_readonly("warnings", &epura::Drawing::warnings)
      .def_property_readonly("cut_stages", &epura::Drawing::cut_stages)
      .def("view_count", [](const epura::Drawing& drawing) { return drawing.views().size(); })
      .def("view_facts", &view_facts)
      .def("lines", &lines_of)
      .def("to_svg", [](const epura::Drawing& d, int s) { return encoded([&] { return epura::to_svg(d, s); }); })
      .def("to_json", [](const epura::Drawing& d, int s) { return encoded([&] { return epura::to_json(d, s); }); })
      .def("to_pdf", [](const epura::Drawing& d) { return py::bytes(encoded([&] { return epura::to_pdf(d); })); })
      .def("to_png", [](const epura::Drawing& d, int s,
                        double dpi) { return py::bytes(encoded([&] { return epura::to_png(d, s, dpi); })); })
      .def("save", [](const epura::Drawing& drawing, const std::string& file) {
        const py::gil_scoped_release release;
        std::vector<std::string> written;
        for (const auto& path : epura::write(drawing, file)) written.push_back(path.string());
        return written;
      });
}
