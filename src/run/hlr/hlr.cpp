// SPDX-License-Identifier: Apache-2.0
// The plain C functions of hidden-line removal in memory.
#include <epura/hlr.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accuracy/view_error.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "drawing/exact_lines.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/crossing_candidates.hpp"
#include "edges/find_edges.hpp"
#include "hlr/curves.hpp"
#include "hlr/exact.hpp"
#include "hlr/limits.hpp"
#include "hlr/model.hpp"
#include "importer/sink.hpp"
#include "projection/answer.hpp"
#include "projection/matrices.hpp"
#include "refine/refine_world.hpp"
#include "visibility/folds.hpp"
#include "visibility/visibility.hpp"
#include "world/facet_heights.hpp"

using namespace epura;

struct epura_hlr_model {
  importer::DocumentSink sink{[](double) {}, /*takes_splines=*/true};
  std::optional<hlr::Model> finished;
};

struct epura_hlr_drawing {
  hlr::Curves content;
  epura_hlr_result result;
};

namespace {

template <std::size_t size>
void put(char (&to)[size], std::string_view text) {
  const std::size_t length = text.copy(to, size - 1);
  to[length] = '\0';
}

int fail(epura_hlr_error* error, int code, std::string_view place, std::string_view reason, std::string_view remedy) {
  if (error == nullptr || error->size < sizeof(epura_hlr_error)) return code;
  error->code = static_cast<std::uint32_t>(code);
  put(error->place, place);
  put(error->reason, reason);
  put(error->remedy, remedy);
  return code;
}

// Returns EPURA_HLR_DONE or the code of what `work` throws.
template <class Work>
int guarded(epura_hlr_error* error, const Work& work) noexcept {
  try {
    fail(error, EPURA_HLR_DONE, "", "", "");
    work();
    return EPURA_HLR_DONE;
  } catch (const Error& wrong) {
    std::string_view reason = wrong.what();
    if (const std::string place = wrong.where() + ": "; reason.starts_with(place)) reason.remove_prefix(place.size());
    return fail(error, static_cast<int>(wrong.kind()), wrong.where(), reason, wrong.hint());
  } catch (const Stopped&) {
    return fail(error, EPURA_HLR_STOPPED, "progress", "the call was stopped", "");
  } catch (const std::bad_alloc&) {
    return fail(error, EPURA_HLR_INPUT, "", "not enough memory for this model", "");
  } catch (const std::logic_error& broken) {
    return fail(error, EPURA_HLR_BROKEN, "", broken.what(),
                "the fault is in epura, not in the input: please report it");
  } catch (const std::exception& wrong) {
    return fail(error, EPURA_HLR_INPUT, "", wrong.what(), "");
  } catch (...) {
    return fail(error, EPURA_HLR_BROKEN, "", "an exception of no kind", "please report it");
  }
}

void expect(bool condition, const std::string& place, const std::string& reason, const std::string& remedy) {
  if (!condition) refuse_input(place, reason, remedy);
}

template <class Struct>
void expect_size(const Struct& given, const std::string& place) {
  expect(given.size >= sizeof(Struct), place, "has the size " + std::to_string(given.size),
         "set size to sizeof, at least " + std::to_string(sizeof(Struct)));
}

int threads_of(std::uint32_t threads) {
  return static_cast<int>(std::min<std::uint32_t>(threads, std::numeric_limits<int>::max()));
}

// Callers of the first version end before `exact`.
epura_hlr_settings settings_of(const epura_hlr_settings* given) {
  epura_hlr_settings settings{};
  if (given == nullptr) return settings;
  constexpr std::size_t first_size = offsetof(epura_hlr_settings, exact);
  expect(given->size >= first_size, "settings", "has the size " + std::to_string(given->size),
         "set size to sizeof, at least " + std::to_string(first_size));
  std::memcpy(&settings, given, std::min<std::size_t>(given->size, sizeof settings));
  return settings;
}

void expect_usable(const epura_hlr_exact& exact) {
  expect_size(exact, "exact");
  expect(exact.face != nullptr && exact.edge != nullptr, "exact", "lacks a function",
         "give that of faces and of edges");
  expect(exact.tolerance > 0 && std::isfinite(exact.tolerance), "exact", "its tolerance is not positive and finite",
         "");
}

void finish(epura_hlr_model& model, const epura_hlr_settings& settings) {
  expect(!model.finished, "model", "is finished already", "begin a new one");
  expect(model.sink.fault().empty(), "sink", "a call " + model.sink.fault(), "");
  const importer::ImportedFile& told = model.sink.document();
  for (const importer::Node& node : told.nodes)
    expect(node.shape < static_cast<int>(told.shapes.size()), "sink",
           "a call hands over a node of a shape that none begins", "");
  const ThreadLimit limit(threads_of(settings.threads));
  if (settings.exact != nullptr) {
    expect_usable(*settings.exact);
    hlr::follow_surfaces(model.sink.document(), *settings.exact);
  }
  model.finished = hlr::make_model(model.sink.document(), settings.is_mesh != 0);
  model.sink.document() = {};
  model.sink.end();
}

projection::Projection answered(const epura_view& view, const std::string& place) {
  const std::string fault = projection::fault_of(view);
  expect(fault.empty(), place, fault, "");
  return projection::projection_of(view);
}

projection::PluginAnswer asked(const epura_projection& row, const std::vector<double>& values, const Box& box) {
  try {
    return projection::call_plugin(row, values, box);
  } catch (const Error& error) {
    throw Error(error.kind(), "projection", error.what(), error.hint());
  }
}

projection::Projection projected(const epura_projection& row, const double* given, const Box& box) {
  expect_size(row, "projection");
  expect(row.project != nullptr && (row.parameter_count == 0 || row.parameters != nullptr), "projection",
         "has no function or no parameters", "");
  std::vector<double> values;
  for (std::uint32_t i = 0; i < row.parameter_count; ++i) {
    const auto& parameter = foreign::row_of(row.parameters, i, "the projection");
    expect(parameter.count <= std::size(parameter.initial), "projection", "has a parameter with too many numbers", "");
    values.insert(values.end(), parameter.initial, parameter.initial + parameter.count);
  }
  if (given != nullptr) std::copy_n(given, values.size(), values.begin());
  const projection::PluginAnswer answer = asked(row, values, box);
  expect(!answer.refusal, "values", answer.refusal.value_or(""), "");
  return answered(answer.view, "projection");
}

projection::Projection projection_of(const epura_hlr_request& request, const Box& box) {
  const int given = (request.view != nullptr) + (request.matrix != nullptr) + (request.projection != nullptr);
  expect(given == 1, "request", given == 0 ? "gives no projection" : "gives several projections",
         "set one of view, matrix and projection");
  if (request.projection != nullptr) return projected(*request.projection, request.values, box);
  if (request.view != nullptr) {
    expect_size(*request.view, "view");
    return answered(*request.view, "view");
  }
  const std::span<const double, 16> m(request.matrix, 16);
  return projection::projection_of_matrix(rows({m[0], m[1], m[2], m[3]}, {m[4], m[5], m[6], m[7]},
                                               {m[8], m[9], m[10], m[11]}, {m[12], m[13], m[14], m[15]}));
}

void expect_numbers(const epura_hlr_request& request) {
  const auto expect_in = [](double value, double most, const std::string& place) {
    expect(value >= 0 && value <= most, place, "is not from 0 to " + std::to_string(static_cast<int>(most)), "");
  };
  expect_in(request.crease_angle, 180, "crease_angle");
  expect_in(request.join_within, 1000, "join_within");
  expect_in(request.arcs, 1000, "arcs");
  expect(request.scale >= 0 && std::isfinite(request.scale), "scale", "is negative or not finite",
         "0 stands for: not given");
  constexpr std::uint32_t known = EPURA_HLR_USUAL | EPURA_HLR_TANGENT | EPURA_HLR_SMOOTH;
  expect((request.kinds & ~known) == 0, "kinds", "has a kind of line that is not known", "");
}

edges::EdgeOptions edges_of(const epura_hlr_request& request) {
  const std::uint32_t kinds = request.kinds == 0 ? std::uint32_t{EPURA_HLR_USUAL} : request.kinds;
  const auto has = [kinds](EdgeKind kind) { return (kinds & hlr::number_of(kind)) != 0; };
  edges::EdgeOptions options{.contour = has(EdgeKind::contour),
                             .boundary = has(EdgeKind::boundary),
                             .crease = has(EdgeKind::crease),
                             .intersection = has(EdgeKind::intersection),
                             .wire = has(EdgeKind::wire),
                             .tangent = has(EdgeKind::tangent),
                             .smooth = has(EdgeKind::smooth)};
  if (request.crease_angle > 0) options.crease_angle = options.part_angle = request.crease_angle;
  return options;
}

drawing::DrawingOptions drawing_of(const epura_hlr_request& request) {
  const bool keeps_hidden = request.only_visible == 0;
  const auto strength = [keeps_hidden](int, int, EdgeKind kind, bool visible) {
    return visible || keeps_hidden ? 2 * visible + !edges::is_within_surface(kind) : -1;
  };
  return {"view", keeps_hidden, true, {request.join_within, strength}};
}

/// A view in all its stages.
struct DrawnView {
  view::ProjectedScene view;
  edges::FeatureEdges drawn;
  visibility::HiddenSpans hidden;
  view::PaperMap paper;
  drawing::ViewDrawing drawing;
  drawing::CurveReport curves;
};

// `scale` is the length on paper of a unit of the plane.
DrawnView draw_view(const world::World& world, view::ProjectedScene view, double scale,
                    const epura_hlr_request& request, const Progress& progress) {
  // So that the origin of the plane is that of the drawing.
  const Vec2 shift = scale / view.map.normalisation * (view.map.image + view.middle);
  DrawnView made{std::move(view), {}, {}, view::make_paper_map(view, scale, shift), {}, {}};
  const edges::EdgeOptions wanted = edges_of(request);
  const edges::CrossingCandidates crossing =
      wanted.intersection
          ? edges::crossing_candidates(world, made.view.map.normalisation, made.view.contact.in_space, progress)
          : edges::CrossingCandidates();
  made.drawn = edges::find_feature_edges(world, made.view, wanted, crossing, progress);
  visibility::find_clear_contours(world, made.view, made.drawn, progress);
  made.hidden = visibility::find_hidden(world, made.view, made.drawn, progress);
  visibility::hide_folds(world, made.view, made.drawn, made.hidden, progress);
  made.drawing =
      drawing::make_drawing({world, made.view, made.drawn, made.hidden}, made.paper, drawing_of(request), progress);
  if (request.arcs > 0) made.curves = drawing::draw_exactly(world, made.drawing, {request.arcs}, progress);
  return made;
}

// On paper.
double error_of(const world::World& world, const DrawnView& drawn, const epura_hlr_request& request,
                const Progress& progress) {
  const world::FacetHeights heights = world::facet_heights(world, progress);
  return accuracy::error_of_view({world, heights, true, drawn.view, drawn.drawn, drawn.hidden, drawn.paper,
                                  drawn.drawing, drawing_of(request)},
                                 drawn.curves, true, progress)
      .total();
}

int told(const epura_hlr_request& request, const std::string& stage, double done) {
  try {
    return request.progress(request.host, stage.c_str(), done);
  } catch (...) {
    refuse_input("progress", "throws an exception across the C interface");
  }
}

std::unique_ptr<epura_hlr_drawing> draw(const epura_hlr_model& model, const epura_hlr_request& request) {
  expect_size(request, "request");
  expect_numbers(request);
  expect(model.finished.has_value(), "model", "is not finished", "call epura_hlr_finish first");
  const world::World& given = model.finished->world;
  const ThreadLimit limit(threads_of(request.threads));
  std::stop_source stop;
  ProgressBoard board;
  const auto tell = [&](const std::string& stage, double done) {
    if (request.progress != nullptr && told(request, stage, done) != 0) stop.request_stop();
  };
  board.observe({tell, stop.get_token()});
  const Progress progress(board);
  const projection::Projection projection = projection_of(request, given.box);
  const std::optional<world::World> refined = refine::refine_world(given, projection);
  const world::World& world = refined ? *refined : given;
  view::ProjectedScene seen = view::project_scene(world, projection, {});
  // A single point has no extent.
  const double side = seen.extent / seen.map.normalisation * seen.projection.scale;
  const double scale = request.scale > 0 ? request.scale : side > 0 ? hlr::usual_side_mm / side : 1;
  const DrawnView found = draw_view(world, std::move(seen), scale, request, progress);
  progress.expect_not_stopped();
  auto made = std::make_unique<epura_hlr_drawing>();
  made->content = hlr::curves_of(*model.finished, found.drawing, scale, request.all_types != 0);
  const hlr::Curves& content = made->content;
  made->result = {sizeof(epura_hlr_result),
                  sizeof(epura_hlr_curve),
                  content.curves.size(),
                  content.curves.data(),
                  content.points.size() / 2,
                  content.points.data(),
                  {},
                  std::nan("")};
  if (request.finds_error != 0) made->result.error = error_of(world, found, request, progress) / scale;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      made->result.matrix[4 * row + column] = found.drawing.world_to_page[column][row] / (row < 3 ? scale : 1);
  return made;
}

}  // namespace

std::uint32_t epura_hlr_version(void) { return EPURA_HLR_VERSION; }

epura_hlr_model* epura_hlr_model_new(std::uint32_t version) {
  if (version != EPURA_HLR_VERSION) return nullptr;
  epura_hlr_model* model = nullptr;
  guarded(nullptr, [&] { model = new epura_hlr_model; });
  return model;
}

void epura_hlr_model_free(epura_hlr_model* model) { delete model; }

const epura_sink* epura_hlr_sink(epura_hlr_model* model) { return model == nullptr ? nullptr : &model->sink.calls(); }

int epura_hlr_finish(epura_hlr_model* model, const epura_hlr_settings* settings, epura_hlr_error* error) {
  return guarded(error, [&] {
    expect(model != nullptr, "model", "is null", "make it by epura_hlr_model_new");
    finish(*model, settings_of(settings));
  });
}

epura_hlr_drawing* epura_hlr_draw(const epura_hlr_model* model, const epura_hlr_request* request,
                                  epura_hlr_error* error) {
  std::unique_ptr<epura_hlr_drawing> drawing;
  guarded(error, [&] {
    expect(model != nullptr && request != nullptr, model == nullptr ? "model" : "request", "is null", "");
    drawing = draw(*model, *request);
  });
  return drawing.release();
}

const epura_hlr_result* epura_hlr_result_of(const epura_hlr_drawing* drawing) {
  return drawing == nullptr ? nullptr : &drawing->result;
}

void epura_hlr_drawing_free(epura_hlr_drawing* drawing) { delete drawing; }
