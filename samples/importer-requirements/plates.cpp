// SPDX-License-Identifier: Apache-2.0
// Reads a plate with what is required of it: a text file "width depth thickness deviation flatness".
#include <cmath>
#include <epura/importer_plugin.hpp>
#include <fstream>
#include <stdexcept>

using namespace epura::plugin;

struct Plates {
  static constexpr auto name = "plates", summary = "plates with requirements", extensions = "plate";

  static void read(const Source& source, Sink& sink) {
    std::ifstream file(source.path);
    double width, depth, thickness, deviation, flatness;
    if (!(file >> width >> depth >> thickness >> deviation >> flatness))
      throw std::runtime_error("is no 'width depth thickness deviation flatness'");
    sink.unit(1);
    sink.shape("plate");
    std::vector<Point> points;
    for (int i = 0; i < 8; ++i)
      points.push_back({width * double(i & 1), depth * double(i >> 1 & 1), thickness * double(i >> 2)});
    sink.points(points);
    add_plane(sink, {0, 0, 0}, {0, 0, -1}, {0, 2, 3, 1});         // face 0: below
    add_plane(sink, {0, 0, thickness}, {0, 0, 1}, {4, 5, 7, 6});  // face 1: above
    add_plane(sink, {0, 0, 0}, {0, -1, 0}, {0, 1, 5, 4});
    add_plane(sink, {0, depth, 0}, {0, 1, 0}, {2, 6, 7, 3});
    add_plane(sink, {0, 0, 0}, {-1, 0, 0}, {0, 4, 6, 2});
    add_plane(sink, {width, 0, 0}, {1, 0, 0}, {1, 3, 7, 5});
    require(sink, thickness, deviation, flatness);
  }

  static void add_plane(Sink& sink, Point origin, Point normal, const std::array<std::uint32_t, 4>& corners) {
    sink.face({0, EPURA_PLANE, {origin[0], origin[1], origin[2]}, {normal[0], normal[1], normal[2]}, 0, 0, 0});
    sink.polygons(std::vector<std::uint64_t>{4}, corners);
  }

  // Each has an id, which is the same whenever the file is read, and names faces by shape and number.
  static void require(Sink& sink, double thickness, double deviation, double flatness) {
    const std::uint32_t below[] = {0, 0}, above[] = {0, 1}, both[] = {0, 0, 0, 1};
    epura_requirement one{};
    one.kind = EPURA_DIMENSION;
    one.id = "thickness", one.type = "linear distance";
    one.value = thickness, one.lower = -deviation, one.upper = deviation;
    one.bounds = EPURA_DEVIATIONS, one.unit = 1, one.decimals = 1;
    one.faces = both, one.face_count = 2;
    sink.requirement(one);
    one = {};
    one.kind = EPURA_DATUM;
    one.id = "A", one.type = "datum", one.datums = "A", one.value = NAN, one.decimals = -1;
    one.faces = below, one.face_count = 1;
    sink.requirement(one);
    one.kind = EPURA_TOLERANCE;
    one.id = "flat", one.type = "flatness", one.datums = nullptr, one.value = flatness, one.unit = 1;
    one.faces = above;
    sink.requirement(one);
  }
};

EPURA_IMPORTER(Plates)
