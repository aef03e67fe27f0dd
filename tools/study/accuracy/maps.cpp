// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/maps.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <glm/vec4.hpp>
#include <span>

#include "projection/matrices.hpp"
#include "study/accuracy/measure.hpp"
#include "verify/numbers.hpp"
#include "view/view_map.hpp"

namespace epura::study {

namespace {

constexpr int greatest_power = 12;
constexpr std::size_t timed_points = 1 << 16;

struct MapScene {
  projection::Projection projection;
  std::vector<Vec3> points;
  Box box;
};

// Points of a cube of size 1 at arbitrary coordinates. The plane passes through its middle; the centre of projection is
// five sizes away.
MapScene scene_at(double offset, bool central) {
  MapScene scene;
  const Vec3 place = offset * Vec3(0.8, 0.48, 0.36);
  for (int i = 0; i < 64; ++i) {
    scene.points.push_back(place + Vec3(i % 4, i / 4 % 4, i / 16) / 3.0);
    scene.box.add(scene.points.back());
  }
  const Vec3 towards = glm::normalize(Vec3(1, -1.3, 0.8));
  projection::Projection& p = scene.projection;
  p.point = scene.box.centre();
  p.n = towards;
  p.u = glm::normalize(glm::cross(Vec3(0, 0, 1), p.n));
  p.v = glm::cross(p.n, p.u);
  p.central = central;
  p.projector = central ? p.point + 5.0 * towards : glm::normalize(towards + 0.3 * p.u);
  return scene;
}

using Map = std::function<void(std::span<const Vec3>, std::vector<Vec2>&)>;

// The loop is inside, so that the speed measured is that of the map.
template <class Place>
Map map_of(Place place) {
  return [place](std::span<const Vec3> points, std::vector<Vec2>& places) {
    for (std::size_t i = 0; i < points.size(); ++i) places[i] = place(points[i]);
  };
}

Map float_matrix(const MapScene& scene) {
  const glm::mat4 m(projection::view_matrix(scene.projection));
  return map_of([m](const Vec3& p) {
    const glm::vec4 h = m * glm::vec4(glm::vec3(p), 1.0F);
    return Vec2(h.x / h.w, h.y / h.w);
  });
}

Map double_matrix(const MapScene& scene) {
  const Mat4 m = projection::view_matrix(scene.projection);
  return map_of([m](const Vec3& p) {
    const Vec4 h = m * Vec4(p, 1);
    return Vec2(h.x / h.w, h.y / h.w);
  });
}

Map staged(const MapScene& scene) {
  const projection::Projection& p = scene.projection;
  const auto into_axes = [u = p.u, v = p.v, n = p.n](const Vec3& l) {
    return Vec3(glm::dot(u, l), glm::dot(v, l), glm::dot(n, l));
  };
  const Vec3 projector = into_axes(p.central ? p.projector - p.point : p.projector);
  const Vec2 side(projector);
  if (p.central)
    return map_of([into_axes, projector, side, origin = p.point](const Vec3& point) {
      const Vec3 l = into_axes(point - origin);
      return side + (Vec2(l) - side) * (projector.z / (projector.z - l.z));
    });
  return map_of([into_axes, slope = side / projector.z, origin = p.point](const Vec3& point) {
    const Vec3 l = into_axes(point - origin);
    return Vec2(l) - l.z * slope;
  });
}

Map recentred(const MapScene& scene) {
  const view::ViewMap map = view::make_view_map(scene.projection, scene.box);
  return map_of([map](const Vec3& point) {
    const view::Mapped h = map(point);
    return Vec2(h.x / h.w, h.y / h.w) / map.normalisation;
  });
}

const std::array<std::pair<const char*, Map (*)(const MapScene&)>, 4> ways{
    {{"float matrix", float_matrix}, {"double matrix", double_matrix}, {"staged", staged}, {"re-centred", recentred}}};

std::array<verify::Exact, 2> exact_place(const projection::Projection& p, const Vec3& point) {
  const auto axis = [&](const Vec3& of) { return verify::triple<verify::Exact>(of); };
  const verify::Triple<verify::Exact> n = axis(p.n), projector = axis(p.projector), x = axis(point);
  const verify::Triple<verify::Exact> ray = p.central ? projector - x : projector;
  const verify::Triple<verify::Exact> foot =
      verify::along<verify::Exact>(x, verify::Exact(verify::dot(n, axis(p.point) - x) / verify::dot(n, ray)), ray) -
      axis(p.point);
  return {verify::dot(axis(p.u), foot), verify::dot(axis(p.v), foot)};
}

// Positions are compared relative to the first one in both sets.
double error_of_map(const Map& map, const MapScene& scene) {
  std::vector<Vec2> places(scene.points.size());
  map(scene.points, places);
  for (const Vec2& place : places)
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return HUGE_VAL;
  const std::array<verify::Exact, 2> first = exact_place(scene.projection, scene.points[0]);
  double greatest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const std::array<verify::Exact, 2> exact = exact_place(scene.projection, scene.points[i]);
    const auto off = [&](int axis) {
      const auto k = static_cast<std::size_t>(axis);
      return verify::Exact(verify::Exact(places[i][axis]) - verify::Exact(places[0][axis]) - (exact[k] - first[k]))
          .get_d();
    };
    greatest = std::max(greatest, std::hypot(off(0), off(1)));
  }
  return greatest;
}

double seconds_of_map(const Map& map, const MapScene& scene, int runs) {
  std::vector<Vec3> points;
  while (points.size() < timed_points) points.insert(points.end(), scene.points.begin(), scene.points.end());
  std::vector<Vec2> places(points.size());
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    map(points, places);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    seconds.push_back(taken.count() / static_cast<double>(points.size()));
  }
  return median_of(seconds);
}

}  // namespace

std::vector<MapMeasurement> measure_maps(int runs) {
  std::vector<MapMeasurement> measured;
  for (const bool central : {true, false})
    for (const auto& way : ways)
      for (int power = 0; power <= greatest_power; ++power) {
        const MapScene scene = scene_at(std::pow(10, power), central);
        const Map map = way.second(scene);
        measured.push_back({central ? "M_per" : "M_par", way.first, std::pow(10, power), error_of_map(map, scene),
                            seconds_of_map(map, scene, runs)});
      }
  return measured;
}

}  // namespace epura::study
