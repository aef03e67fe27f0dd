// SPDX-License-Identifier: Apache-2.0
#include "app/viewing_steps.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"
#include "output/json_text.hpp"
#include "view/viewing_model.hpp"

namespace epura {

namespace {

using output::json_number;
using output::json_string;
using output::json_vector;

constexpr double viewport_scale = 1;  // mm per unit of the model
constexpr int digits = 9;

/// The way of a vertex through the steps.
struct Trace {
  int vertex;
  Vec3 world;
  std::vector<Vec4> after;  ///< each step, homogeneous
  Vec2 page;                ///< after all steps, mm
  Vec2 drawn;               ///< where drawings have the vertex, mm
};

std::string number(double value) { return format_rounded(value, digits); }

std::string values_of(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) append_to_list(text, number(value));
  return text;
}

std::string values_of(const Vec2& p) { return values_of({p.x, p.y}); }
std::string values_of(const Vec3& p) { return values_of({p.x, p.y, p.z}); }

/// Places a vertex in affine coordinates if it has any.
std::string place_of(const Vec4& p) {
  if (p.w == 0) return values_of({p.x, p.y, p.z, p.w}) + " (at infinity)";
  return values_of(Vec3(p) / p.w) + (p.w == 1 ? "" : "   w = " + number(p.w));
}

// The document's names and equations of the numbers of a view.
struct Quantity {
  const char *symbol, *equation, *meaning;
  std::string value;
};

std::vector<Quantity> quantities_of(const projection::Projection& p, const view::ViewingModel& model) {
  const projection::ViewVolume& volume = model.volume;
  return {{"VRP", "", "view reference point", values_of(model.vrp)},
          {"VPN", "", "view plane normal", values_of(model.vpn)},
          {"VUP", "", "view up vector", values_of(model.vup)},
          {"u", "3.30", "right", values_of(p.u)},
          {"v", "3.31", "up", values_of(p.v)},
          {"n", "3.32", "towards the viewer", values_of(p.n)},
          {"PRP", "", "projection reference point, in (u, v, n)", values_of(volume.prp)},
          {"VPD", "", "view plane distance", number(volume.plane)},
          {"F", "", "front plane", number(volume.front)},
          {"B", "", "back plane", number(volume.back)},
          {"window", "", "umin, vmin, umax, vmax", values_of(volume.window.min) + ", " + values_of(volume.window.max)},
          {"viewport", "", "mm; 1 mm for a unit of the model in the view plane",
           values_of(model.viewport.min) + ", " + values_of(model.viewport.max)}};
}

std::string rows_of(const Mat4& matrix) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    std::string line = "   ";
    for (int column = 0; column < 4; ++column) line += padded(" " + number(matrix[column][row]), 18);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string latex_of(const Mat4& matrix) {
  std::string text = "\\begin{pmatrix}\n";
  for (int row = 0; row < 4; ++row) {
    text += "  ";
    for (int column = 0; column < 4; ++column) text += (column > 0 ? " & " : "") + number(matrix[column][row]);
    text += " \\\\\n";
  }
  return text + "\\end{pmatrix}";
}

std::string json_matrix(const Mat4& matrix) {
  std::string text = "[";
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      text += (row + column > 0 ? ", " : "") + json_number(matrix[column][row]);
  return text + "]";
}

std::string json_values(const std::vector<double>& values) { return output::json_list(values, json_number); }
std::string json_window(const projection::Window& w) { return json_values({w.min.x, w.min.y, w.max.x, w.max.y}); }

const char* plane_symbol(const projection::Projection& p) { return p.central ? "M_per" : "M_par"; }
const char* plane_equation(const projection::Projection& p) { return p.central ? "3.10" : "3.20"; }

void print_text(const projection::Projection& p, const view::ViewingModel& model, const Trace* trace) {
  int step = 0;
  const auto heading = [&](const std::string& text) { print("\n" + std::to_string(++step) + ". " + text); };
  heading("The view");
  for (const Quantity& q : quantities_of(p, model))
    print("   " + padded(q.symbol, 10) + padded(q.value, 44) + q.meaning +
          (*q.equation != '\0' ? std::string(" (") + q.equation + ")" : ""));
  heading(std::string(plane_symbol(p)) + " (" + plane_equation(p) + "): onto the view plane, in world coordinates");
  std::fputs(rows_of(model.plane).c_str(), stdout);
  for (const view::ViewingStep& s : model.steps) {
    heading(std::string(s.symbol) + " (" + s.equation + "): " + s.maps);
    std::fputs(rows_of(s.matrix).c_str(), stdout);
  }
  heading("The product: world -> viewport, mm");
  std::fputs(rows_of(model.product).c_str(), stdout);
  if (trace == nullptr) return;
  heading("Vertex " + std::to_string(trace->vertex));
  print("   " + padded("world", 10) + values_of(trace->world));
  for (std::size_t i = 0; i < model.steps.size(); ++i)
    print("   " + padded(model.steps[i].symbol, 10) + place_of(trace->after[i]));
  print("   " + padded("page", 10) + values_of(trace->page) + " mm");
  print("   " + padded("drawn at", 10) + values_of(trace->drawn) + " mm, " +
        format_rounded(glm::distance(trace->page, trace->drawn), 3) + " mm away");
}

// As LaTeX writes numbers: 2e-07 is a power of ten.
std::string latex_numbers(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string latex;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != 'e' || i == 0 || !is_digit(text[i - 1])) {
      latex += text[i];
      continue;
    }
    const bool is_negative = text[++i] == '-';
    while (!is_digit(text[i]) || (text[i] == '0' && i + 1 < text.size() && is_digit(text[i + 1]))) ++i;
    latex += is_negative ? "\\cdot10^{-" : "\\cdot10^{";
    while (i < text.size() && is_digit(text[i])) latex += text[i++];
    latex += '}';
    --i;
  }
  return latex;
}

std::string latex_symbol(const std::string& name) {
  const std::size_t at = name.find('_');
  if (at == std::string::npos) return "\\mathrm{" + name + "}";
  return name.substr(0, at) + "_{\\mathrm{" + name.substr(at + 1) + "}}";
}

void print_equation(const std::string& left, const std::string& right, const std::string& number) {
  const std::string tag = number.empty() ? "" : " \\tag{" + number + "}";
  print("\\[ " + left + " = " + latex_numbers(right) + tag + " \\]");
}

// P_0 is the vertex, P_i what the i-th matrix makes of it.
void print_latex_trace(const view::ViewingModel& model, const Trace& trace) {
  print_equation("P_{0}", "(" + values_of(trace.world) + ", 1)^T", "");
  for (std::size_t i = 0; i < model.steps.size(); ++i) {
    const Vec4& p = trace.after[i];
    print_equation("P_{" + std::to_string(i + 1) + "}",
                   latex_symbol(model.steps[i].symbol) + "\\,P_{" + std::to_string(i) + "} = (" +
                       values_of({p.x, p.y, p.z, p.w}) + ")^T",
                   "");
  }
  print_equation("\\mathrm{page}", "(" + values_of(trace.page) + ")\\,\\mathrm{mm}", "");
  print_equation("\\mathrm{drawn\\ at}", "(" + values_of(trace.drawn) + ")\\,\\mathrm{mm}", "");
  print_equation("\\mathrm{residue}", format_rounded(glm::distance(trace.page, trace.drawn), 3) + "\\,\\mathrm{mm}",
                 "");
}

void print_latex(const projection::Projection& p, const view::ViewingModel& model, const Trace* trace) {
  int step = 0;
  const auto heading = [&](const std::string& text) { print("% " + std::to_string(++step) + ". " + text); };
  heading("The view");
  for (const Quantity& q : quantities_of(p, model))
    print_equation(latex_symbol(q.symbol), "(" + q.value + ")", q.equation);
  heading("Onto the view plane, in world coordinates");
  print_equation(latex_symbol(plane_symbol(p)), latex_of(model.plane), plane_equation(p));
  std::string product;
  for (const view::ViewingStep& s : model.steps) {
    heading(s.maps);
    print_equation(latex_symbol(s.symbol), latex_of(s.matrix), s.equation);
    product = latex_symbol(s.symbol) + (product.empty() ? "" : "\\,") + product;
  }
  heading("The product: world -> viewport, mm");
  print_equation("M", product + " = " + latex_of(model.product), "");
  if (trace == nullptr) return;
  heading("Vertex " + std::to_string(trace->vertex));
  print_latex_trace(model, *trace);
}

void print_json(const projection::Projection& p, const view::ViewingModel& model, const Trace* trace) {
  std::string more;
  if (trace != nullptr) {
    more = ",\n \"trace\": {\"vertex\": " + std::to_string(trace->vertex) +
           ", \"world\": " + json_vector(trace->world) + ", \"after\": [";
    for (const Vec4& a : trace->after)
      more += (&a == trace->after.data() ? "" : ", ") + json_values({a.x, a.y, a.z, a.w});
    more += "], \"page\": " + json_values({trace->page.x, trace->page.y}) +
            ", \"drawn\": " + json_values({trace->drawn.x, trace->drawn.y}) +
            ", \"residue\": " + json_number(glm::distance(trace->page, trace->drawn)) + "}";
  }
  std::fputs(viewing_json(p, model, more).c_str(), stdout);
}

Trace trace_of(int vertex, const std::string& file, const view::ProjectedScene& view, const world::World& world,
               const view::ViewingModel& model) {
  const int count = world.first_vertex.back();
  if (vertex >= count)
    throw Error(ErrorKind::input, "--trace", file + " has no vertex " + std::to_string(vertex),
                "numbers run from 0 to " + std::to_string(count - 1));
  Trace trace{vertex, world.points[vertex], {}, Vec2(0), Vec2(0)};
  Vec4 at(trace.world, 1);
  for (const view::ViewingStep& step : model.steps) trace.after.push_back(at = step.matrix * at);
  const view::PageVertex& drawn = view.vertices[vertex];
  if (!(drawn.w > 0))
    throw Error(ErrorKind::input, "--trace", "vertex " + std::to_string(vertex) + " is behind the viewer",
                "choose one that is drawn, or move the centre of projection");
  trace.page = Vec2(at) / at.w;
  trace.drawn = view::viewport_map(view, viewport_scale)(drawn);
  return trace;
}

}  // namespace

std::string viewing_json(const projection::Projection& p, const view::ViewingModel& model, const std::string& more) {
  const projection::ViewVolume& v = model.volume;
  std::string text = "{\"epura_viewing\": 1, \"projection\": " + json_string(p.name) +
                     ",\n \"central\": " + (p.central ? "true" : "false") + ",\n \"VRP\": " + json_vector(model.vrp) +
                     ", \"VPN\": " + json_vector(model.vpn) + ", \"VUP\": " + json_vector(model.vup) +
                     ",\n \"u\": " + json_vector(p.u) + ", \"v\": " + json_vector(p.v) +
                     ", \"n\": " + json_vector(p.n) + ",\n \"PRP\": " + json_vector(v.prp) +
                     ", \"VPD\": " + json_number(v.plane) + ", \"F\": " + json_number(v.front) +
                     ", \"B\": " + json_number(v.back) + ",\n \"window\": " + json_window(v.window) +
                     ", \"viewport\": " + json_window(model.viewport) + ",\n \"" + plane_symbol(p) +
                     "\": " + json_matrix(model.plane) + ",\n \"steps\": [";
  for (const view::ViewingStep& s : model.steps)
    text += (&s == model.steps.data() ? "\n  " : ",\n  ") + std::string("{\"symbol\": ") + json_string(s.symbol) +
            ", \"equation\": " + json_string(s.equation) + ", \"matrix\": " + json_matrix(s.matrix) + "}";
  return text + "],\n \"product\": " + json_matrix(model.product) + more + "}\n";
}

int show_steps(const projection::ProjectionEntry& entry, const scene::ProjectionRequest& request,
               const PluginsOptions& options) {
  const importer::ModelRequest file = importer::parse_model_request(options.model);
  importer::ReadModel read = importer::read_model(file.path, file.parameters, {.plugin_path = options.plugin_path});
  const world::World world = world::make_world({{std::make_shared<const mesh::Mesh>(std::move(read.mesh)), Mat4(1.0)}});
  const projection::Projection p = projection::make_projection(entry, request, world.box);
  const view::ProjectedScene view = view::project_scene(world, p, {});
  const view::ViewingModel model = view::viewing_model(view, world.box, viewport_scale);
  std::optional<Trace> trace;
  if (options.vertex) trace = trace_of(*options.vertex, file.path, view, world, model);
  const Trace* shown = trace ? &*trace : nullptr;
  switch (options.notation) {
    case MatrixNotation::text:
      print(request.text() + " of " + file.path);
      print_text(p, model, shown);
      break;
    case MatrixNotation::latex:
      print_latex(p, model, shown);
      break;
    case MatrixNotation::json:
      print_json(p, model, shown);
  }
  return 0;
}

}  // namespace epura
