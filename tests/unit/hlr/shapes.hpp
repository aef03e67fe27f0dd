// SPDX-License-Identifier: Apache-2.0
// Models and drawings of the plain C interface, freed by themselves, and shapes with known lines.
#pragma once

#include <epura/hlr.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace epura::test {

struct Free {
  void operator()(epura_hlr_model* model) const { epura_hlr_model_free(model); }
  void operator()(epura_hlr_drawing* drawing) const { epura_hlr_drawing_free(drawing); }
};

using Drawing = std::unique_ptr<epura_hlr_drawing, Free>;

inline epura_hlr_error no_error() {
  epura_hlr_error error{};
  error.size = sizeof error;
  return error;
}

inline epura_hlr_request request_for(const std::array<double, 16>& matrix) {
  epura_hlr_request request{};
  request.size = sizeof request;
  request.matrix = matrix.data();
  return request;
}

inline const double half = std::sqrt(0.5), third = std::sqrt(1.0 / 6);
/// The viewer is at (1, -1, 1).
inline const std::array isometric{half, half, 0.0, 0.0, -third, third, 2 * third, 0.0,
                                  1.0,  -1.0, 1.0, 0.0, 0.0,    0.0,   0.0,       1.0};
/// From above: x right, y up.
inline constexpr std::array<double, 16> top{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// A model that is being filled.
struct HlrModel {
  std::unique_ptr<epura_hlr_model, Free> model{epura_hlr_model_new(EPURA_HLR_VERSION)};
  const epura_sink* sink = epura_hlr_sink(model.get());

  void shape(const char* name) const { EXPECT_EQ(sink->shape(sink->host, name), 0); }
  void points(const std::vector<double>& xyz) const {
    EXPECT_EQ(sink->points(sink->host, xyz.size() / 3, xyz.data()), 0);
  }
  void face(std::uint32_t kind, std::array<double, 3> origin = {}, std::array<double, 3> axis = {0, 0, 1},
            double radius = 0) const {
    epura_face face{};
    face.size = sizeof face;
    face.kind = kind;
    std::ranges::copy(origin, face.origin);
    std::ranges::copy(axis, face.axis);
    face.radius = radius;
    EXPECT_EQ(sink->face(sink->host, &face), 0);
  }
  void polygon(const std::vector<std::uint32_t>& corners) const {
    const std::uint64_t end = corners.size();
    EXPECT_EQ(sink->polygons(sink->host, 1, &end, corners.data()), 0);
  }
  void edge(std::uint32_t kind, const std::vector<std::uint32_t>& vertices) const {
    const epura_edge edge{sizeof edge, kind, std::nan(""), vertices.size(), vertices.data()};
    EXPECT_EQ(sink->edge(sink->host, &edge), 0);
  }
  void node(std::uint32_t shape, std::array<double, 3> place) const {
    const epura_node node{sizeof node, EPURA_NONE, shape,
                          0,           nullptr,    {1, 0, 0, place[0], 0, 1, 0, place[1], 0, 0, 1, place[2]}};
    EXPECT_EQ(sink->node(sink->host, &node), 0);
  }
  void finish(bool is_mesh = false) const {
    epura_hlr_error error = no_error();
    const epura_hlr_settings settings{sizeof settings, is_mesh ? 1U : 0U, 1, 0, nullptr};
    EXPECT_EQ(epura_hlr_finish(model.get(), &settings, &error), EPURA_HLR_DONE) << error.place << error.reason;
  }
  [[nodiscard]] Drawing draw(const epura_hlr_request& request) const {
    epura_hlr_error error = no_error();
    Drawing drawing(epura_hlr_draw(model.get(), &request, &error));
    EXPECT_NE(drawing, nullptr) << error.place << ": " << error.reason << " " << error.remedy;
    return drawing;
  }
};

/// A box whose faces are numbered -x, +x, -y, +y, -z, +z.
inline void add_box(const HlrModel& model, std::array<double, 3> size) {
  const auto [x, y, z] = size;
  model.shape("box");
  model.points({0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0, 0, 0, z, x, 0, z, x, y, z, 0, y, z});
  const std::vector<std::vector<std::uint32_t>> faces{{3, 0, 4, 7}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                                      {2, 3, 7, 6}, {3, 2, 1, 0}, {4, 5, 6, 7}};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::array<double, 3> axis{};
    axis[i / 2] = i % 2 == 0 ? -1 : 1;
    model.face(EPURA_PLANE, i % 2 == 0 ? std::array{0.0, 0.0, 0.0} : size, axis);
    model.polygon(faces[i]);
  }
}

/// A cylinder along z with faces bottom, top and side, and its two rims as edges.
inline void add_cylinder(const HlrModel& model, double radius, double height, std::uint32_t sides = 24) {
  std::vector<double> points;
  std::vector<std::uint32_t> bottom, top_face;
  for (const double z : {0.0, height})
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), z});
    }
  for (std::uint32_t i = 0; i < sides; ++i) {
    bottom.push_back(sides - 1 - i);
    top_face.push_back(sides + i);
  }
  model.shape("cylinder");
  model.points(points);
  model.face(EPURA_PLANE, {0, 0, 0}, {0, 0, -1});
  model.polygon(bottom);
  model.face(EPURA_PLANE, {0, 0, height});
  model.polygon(top_face);
  model.face(EPURA_CYLINDER, {0, 0, 0}, {0, 0, 1}, radius);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    model.polygon({i, next, sides + next, sides + i});
  }
  for (const std::uint32_t first : {0U, sides}) {
    std::vector<std::uint32_t> rim;
    for (std::uint32_t i = 0; i <= sides; ++i) rim.push_back(first + i % sides);
    model.edge(EPURA_SHARP, rim);
  }
}

/// A wire with a spline, in pieces: x = t, y = t (1 - t), z as told, for t from 0 to 1.
inline constexpr int pieces = 32;
inline const std::vector<double> bezier_knots{0, 0, 0, 1, 1, 1};

inline void add_parabola(const HlrModel& model, double z, bool backwards = false) {
  std::vector<double> points, parameters;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i <= pieces; ++i) {
    const double t = static_cast<double>(backwards ? pieces - i : i) / pieces;
    points.insert(points.end(), {t, t * (1 - t), z});
    parameters.push_back(t);
    vertices.push_back(i);
  }
  model.shape("parabola");
  model.points(points);
  model.edge(EPURA_WIRE, vertices);
  const std::vector<double> poles{0, 0, z, 0.5, 0.5, z, 1, 0, z};
  const epura_spline spline{sizeof spline, 2, 3, poles.data(), nullptr, bezier_knots.data(), parameters.data()};
  EXPECT_EQ(model.sink->spline(model.sink->host, &spline), 0);
}

inline std::span<const epura_hlr_curve> curves_of(const Drawing& drawing) {
  const epura_hlr_result& result = *epura_hlr_result_of(drawing.get());
  return {result.curves, result.curve_count};
}

/// The length of a curve, that of an arc by 1000 chords.
inline double length_of(const Drawing& drawing, const epura_hlr_curve& curve) {
  const double* points = epura_hlr_result_of(drawing.get())->points + 2 * curve.first;
  const bool is_arc = curve.type == EPURA_HLR_ELLIPSE;
  const auto place = [&](std::uint64_t i) -> std::array<double, 2> {
    if (!is_arc) return {points[2 * i], points[2 * i + 1]};
    const double a = curve.from + static_cast<double>(i) / 1000 * (curve.to - curve.from);
    return {curve.centre[0] + std::cos(a) * curve.u[0] + std::sin(a) * curve.v[0],
            curve.centre[1] + std::cos(a) * curve.u[1] + std::sin(a) * curve.v[1]};
  };
  double length = 0;
  for (std::uint64_t i = 0; i + 1 < (is_arc ? 1001 : curve.count); ++i)
    length += std::hypot(place(i + 1)[0] - place(i)[0], place(i + 1)[1] - place(i)[1]);
  return length;
}

/// The length of all curves that are `wanted`.
template <class Wanted>
double length_of_all(const Drawing& drawing, const Wanted& wanted) {
  double sum = 0;
  for (const epura_hlr_curve& curve : curves_of(drawing))
    if (wanted(curve)) sum += length_of(drawing, curve);
  return sum;
}

}  // namespace epura::test
