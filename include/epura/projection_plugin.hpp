// SPDX-License-Identifier: Apache-2.0
// C++ wrapper of projection_abi.h: header-only, compiled into the plugin, so that only C crosses the interface.
//
// A projection is a struct with name, family, summary, reference, a table `parameters`, and
//   static View project(const Scene&, one argument for each row of the table)
// where a number is passed as double, a choice as int (or as bool for "false|true"), a vector of three as Vec3 and any
// other vector as std::array<double, N>. EPURA_PROJECTION(Struct) defines the library's entry point for one projection,
// EPURA_PROJECTIONS(A, B...) for several. For invalid values, throw std::invalid_argument with a message for the user.
#pragma once

#include <epura/projection_abi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <epura/parameter_rows.hpp>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace epura::plugin {

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }
inline Vec3 unit(Vec3 a) { return (1 / length(a)) * a; }

constexpr double radians(double degrees) { return degrees / 180 * std::numbers::pi; }

/// Give the same bits on every machine: the C library has several versions of its functions for doubles, selected by
/// the instruction set of the processor, but only one version for long doubles.
inline double portable_sin(double angle) { return static_cast<double>(std::sin(static_cast<long double>(angle))); }
inline double portable_cos(double angle) { return static_cast<double>(std::cos(static_cast<long double>(angle))); }
inline double portable_tan(double angle) { return static_cast<double>(std::tan(static_cast<long double>(angle))); }

/// Unit vector towards a viewer `azimuth` degrees to the right of the front and `elevation` degrees above the horizon.
inline Vec3 towards_viewer(double azimuth, double elevation) {
  const double a = radians(azimuth), e = radians(elevation);
  return {portable_sin(a) * portable_cos(e), -portable_cos(a) * portable_cos(e), portable_sin(e)};
}

/// Bounding box of everything drawn.
struct Scene {
  Vec3 least, most;
  [[nodiscard]] Vec3 centre() const { return 0.5 * least + 0.5 * most; }
  /// Never zero, so that distances derived from it stay distinct even for a single point.
  [[nodiscard]] double diagonal() const {
    const double d = length(most - least);
    return d > 0 ? d : 1;
  }
};

/// Result of a projection; epura_view describes the members.
struct View {
  bool central = false;
  Vec3 point, normal, up, projector;
  double scale = 1;
  std::array<double, 4> window{};
  double front = unlimited, back = -unlimited;
};

namespace detail {

// Converts flat values to an argument of project(): its type in the table, its length, its value.
template <class T>
struct Argument;
template <>
struct Argument<double> {
  static constexpr uint32_t type = EPURA_NUMBER, count = 1;
  static double read(const double* values) { return values[0]; }
};
template <>
struct Argument<int> {
  static constexpr uint32_t type = EPURA_CHOICE, count = 1;
  static int read(const double* values) { return static_cast<int>(values[0]); }
};
template <>
struct Argument<bool> {
  static constexpr uint32_t type = EPURA_CHOICE, count = 1;
  static bool read(const double* values) { return values[0] != 0; }
};
template <>
struct Argument<Vec3> {
  static constexpr uint32_t type = EPURA_VECTOR, count = 3;
  static Vec3 read(const double* values) { return {values[0], values[1], values[2]}; }
};
template <std::size_t N>
struct Argument<std::array<double, N>> {
  static constexpr uint32_t type = EPURA_VECTOR, count = N;
  static std::array<double, N> read(const double* values) {
    std::array<double, N> array{};
    std::copy_n(values, N, array.begin());
    return array;
  }
};

template <class P, class... A>
constexpr bool matches(View (*)(const Scene&, A...)) {
  using Shape = std::pair<uint32_t, uint32_t>;
  constexpr std::array<Shape, sizeof...(A)> wanted{
      Shape{Argument<std::decay_t<A>>::type, Argument<std::decay_t<A>>::count}...};
  return std::equal(wanted.begin(), wanted.end(), P::parameters.begin(), P::parameters.end(),
                    [](const Shape& w, const epura_parameter& row) {
                      return w == Shape{row.type, row.count};
                    });
}

template <class P, class... A>
View apply(View (*project)(const Scene&, A...), const Scene& scene, const double* values) {
  [[maybe_unused]] const auto next = [&values](std::size_t count) { return std::exchange(values, values + count); };
  // Braces, not parentheses: they fix the order in which the values are taken.
  const std::tuple<std::decay_t<A>...> arguments{
      Argument<std::decay_t<A>>::read(next(Argument<std::decay_t<A>>::count))...};
  return std::apply([&](const auto&... a) { return project(scene, a...); }, arguments);
}

inline void store(const View& from, epura_view* to) {
  const auto copy = [](const Vec3& v, double* out) { out[0] = v.x, out[1] = v.y, out[2] = v.z; };
  epura_view view{};
  view.size = to->size;
  view.projectors = from.central ? EPURA_CENTRAL : EPURA_PARALLEL;
  copy(from.point, view.point);
  copy(from.normal, view.normal);
  copy(from.up, view.up);
  copy(from.projector, view.projector);
  view.scale = from.scale;
  std::copy(from.window.begin(), from.window.end(), view.window);
  view.front = from.front;
  view.back = from.back;
  // An older host knows a shorter structure.
  std::memcpy(to, &view, std::min<std::size_t>(to->size, sizeof view));
}

template <class P>
const char* project(const double* values, const epura_scene* scene, epura_view* view) noexcept {
  static thread_local std::string sentence;
  try {
    const Scene box{{scene->least[0], scene->least[1], scene->least[2]},
                    {scene->most[0], scene->most[1], scene->most[2]}};
    store(apply<P>(&P::project, box, values), view);
    return nullptr;
  } catch (const std::exception& error) {
    sentence = error.what();
  } catch (...) {
    sentence = "threw something other than std::exception";
  }
  return sentence.c_str();
}

template <class P>
constexpr epura_projection describe() {
  static_assert(matches<P>(&P::project),
                "project() must take const Scene& and one argument for each row of `parameters`: double for a number, "
                "int or bool for a choice, Vec3 or std::array<double, N> for a vector");
  return {sizeof(epura_projection),
          P::name,
          P::family,
          P::summary,
          P::reference,
          static_cast<uint32_t>(P::parameters.size()),
          P::parameters.data(),
          &project<P>};
}

template <class... P>
const epura_projection_list* list() {
  static constexpr std::array<epura_projection, sizeof...(P)> rows{describe<P>()...};
  static constexpr epura_projection_list all{EPURA_ABI_VERSION, sizeof(epura_projection_list), rows.size(),
                                             rows.data()};
  return &all;
}

}  // namespace detail
}  // namespace epura::plugin

#define EPURA_PROJECTIONS(...) \
  const epura_projection_list* epura_projections_v1(void) { return epura::plugin::detail::list<__VA_ARGS__>(); }
#define EPURA_PROJECTION(projection) EPURA_PROJECTIONS(projection)
