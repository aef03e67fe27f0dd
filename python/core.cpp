// SPDX-License-Identifier: Apache-2.0
// epura._core: the library for Python. Scenes in the words of scene files in, drawings out; epura/__init__.py is what
// users see.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <epura/epura.hpp>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "job.hpp"

namespace py = pybind11;

namespace {

using epura::python::Job;
using Points = py::array_t<double, py::array::c_style>;
using Faces = py::array_t<int, py::array::c_style>;

// A node of epura/_values.py: (key, place, content), where a list is a list of nodes and a table a tuple of them.
epura::SceneValue value_of(const py::handle& node) {
  const auto parts = py::cast<py::tuple>(node);
  epura::SceneValue value{py::cast<std::string>(parts[0]), py::cast<std::string>(parts[1]), {}};
  const py::object content = parts[2];
  const auto nodes = [&] {
    std::vector<epura::SceneValue> values;
    for (const py::handle& one : content) values.push_back(value_of(one));
    return values;
  };
  if (py::isinstance<py::bool_>(content))
    value.content = py::cast<bool>(content);
  else if (py::isinstance<py::float_>(content))
    value.content = py::cast<double>(content);
  else if (py::isinstance<py::list>(content))
    value.content = epura::SceneList{nodes()};
  else if (py::isinstance<py::tuple>(content))
    value.content = epura::SceneTable{nodes()};
  else
    value.content = py::cast<std::string>(content);
  return value;
}

// Borrows the arrays, which must be as epura/_models.py makes them.
epura::ModelSource source_of(const py::dict& values) {
  epura::ModelSource source;
  source.model = py::cast<int>(values["model"]);
  if (values.contains("bytes")) {
    source.bytes = py::cast<std::string>(values["bytes"]);
    return source;
  }
  const auto points = py::cast<Points>(values["points"]);
  static_assert(sizeof(std::array<double, 3>) == 3 * sizeof(double));
  source.points = {reinterpret_cast<const std::array<double, 3>*>(points.data()),
                   static_cast<std::size_t>(points.shape(0))};
  source.single_precision = py::cast<bool>(values["single_precision"]);
  for (const py::handle& group : py::cast<py::list>(values["faces"])) {
    const auto faces = py::cast<Faces>(group);
    source.faces.push_back({{faces.data(), static_cast<std::size_t>(faces.size())}, static_cast<int>(faces.shape(1))});
  }
  return source;
}

epura::Settings settings_of(const py::dict& values) {
  epura::Settings settings;
  const auto take = [&values]<class Value>(const char* name, Value& member) {
    if (values.contains(name)) member = py::cast<Value>(values[name]);
  };
  take("contact", settings.contact);
  take("wireframe", settings.wireframe);
  take("max_error", settings.max_error);
  take("error_note", settings.error_note);
  take("arcs", settings.arcs);
  take("centre_lines", settings.centre_lines);
  take("verify", settings.verify);
  take("time_limit", settings.time_limit);
  take("threads", settings.threads);
  take("allow_outside", settings.allow_outside);
  std::vector<std::string> folders;
  take("plugin_path", folders);
  settings.plugin_path = {folders.begin(), folders.end()};
  return settings;
}

std::unique_ptr<Job> begin(const py::object& scene, const py::list& sources, const py::dict& settings,
                           const py::list& projections) {
  std::vector<epura::ModelSource> models;
  for (const py::handle& source : sources) models.push_back(source_of(py::cast<py::dict>(source)));
  const auto draw = [value = value_of(scene), models = std::move(models)](const epura::Settings& all) {
    return epura::draw(value, models, all);
  };
  return std::make_unique<Job>(draw, settings_of(settings), projections, py::make_tuple(sources, projections));
}

std::unique_ptr<Job> begin_file(const std::string& file, const py::dict& settings, const py::list& projections) {
  const auto draw = [file](const epura::Settings& all) { return epura::draw_file(file, all); };
  return std::make_unique<Job>(draw, settings_of(settings), projections, py::make_tuple(projections));
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

py::dict error_of(const epura::Drawing& drawing, std::size_t number) {
  py::dict terms;
  for (const epura::ErrorTerm& term : drawing.views().at(number).error.terms)
    terms[py::str(term.term)] = py::make_tuple(term.mm, term.by);
  return terms;
}

py::list arcs_of(const epura::Drawing& drawing, std::size_t number) {
  py::list arcs;
  for (const epura::Arc& arc : drawing.views().at(number).arcs)
    arcs.append(py::make_tuple(arc.centre, arc.u, arc.v, arc.from, arc.to, static_cast<int>(arc.kind), arc.visible));
  return arcs;
}

// The strokes of all layers as arrays: (name, width, list of (n, 2)).
py::list layers_of(const epura::Drawing& drawing, int sheet) {
  py::list layers;
  for (const epura::SheetLayer& layer : drawing.layers(sheet)) {
    py::list strokes;
    for (const auto& stroke : layer.strokes)
      strokes.append(py::array_t<double>({static_cast<py::ssize_t>(stroke.size()), py::ssize_t{2}},
                                         stroke.empty() ? nullptr : stroke.front().data()));
    layers.append(py::make_tuple(layer.name, layer.width, strokes));
  }
  return layers;
}

// Released while bytes are made.
template <class Encode>
auto unlocked(const Encode& encode) {
  const py::gil_scoped_release release;
  return encode();
}

py::tuple compare(const std::string& before_name, const std::string& before, const std::string& after_name,
                  const std::string& after, double tolerance) {
  const epura::Comparison found = unlocked([&] {
    return epura::compare_drawings({before_name, before}, {after_name, after}, tolerance);
  });
  return py::make_tuple(found.is_same, found.words, found.json, found.page);
}

std::vector<std::string> save(const epura::Drawing& drawing, const std::string& file) {
  const py::gil_scoped_release release;
  std::vector<std::string> written;
  for (const auto& path : epura::write(drawing, file)) written.push_back(path.string());
  return written;
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
  module.def("begin", &begin);
  module.def("begin_file", &begin_file);
  module.def("compare", &compare);
  py::class_<Job>(module, "Job")
      .def("wait", &Job::wait)
      .def("news", &Job::news)
      .def("stop", &Job::stop)
      .def("result", &Job::result);
  py::class_<epura::Drawing>(module, "Drawing")
      .def_property_readonly("sheets", &epura::Drawing::sheets)
      .def_property_readonly("warnings", &epura::Drawing::warnings)
      .def_property_readonly("cut_stages", &epura::Drawing::cut_stages)
      .def_property_readonly("is_wrong", &epura::Drawing::is_wrong)
      .def("view_count", [](const epura::Drawing& drawing) { return drawing.views().size(); })
      .def("view_facts", &view_facts)
      .def("lines", &lines_of)
      .def("error", &error_of)
      .def("arcs", &arcs_of)
      .def("layers", &layers_of)
      .def("to_svg", [](const epura::Drawing& d, int s) { return unlocked([&] { return epura::to_svg(d, s); }); })
      .def("to_json", [](const epura::Drawing& d, int s) { return unlocked([&] { return epura::to_json(d, s); }); })
      .def("to_dxf", [](const epura::Drawing& d, int s) { return unlocked([&] { return epura::to_dxf(d, s); }); })
      .def("to_pdf", [](const epura::Drawing& d) { return py::bytes(unlocked([&] { return epura::to_pdf(d); })); })
      .def("to_png", [](const epura::Drawing& d, int s,
                        double dpi) { return py::bytes(unlocked([&] { return epura::to_png(d, s, dpi); })); })
      .def("save", &save);
}
