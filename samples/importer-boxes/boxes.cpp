// SPDX-License-Identifier: Apache-2.0
// Reads boxes: a text file with a line "name x y z width depth height" for each.
#include <epura/importer_plugin.hpp>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace epura::plugin;

struct Boxes {
  static constexpr auto name = "boxes", summary = "boxes, one a line", extensions = "boxes";

  static void read(const Source& source, Sink& sink) {
    std::ifstream file(source.path);
    std::uint32_t box = EPURA_NONE;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      if (line.empty()) continue;
      std::istringstream words(line);
      std::string called;
      double x, y, z, width, depth, height;
      if (!(words >> called >> x >> y >> z >> width >> depth >> height))
        throw std::runtime_error("line " + std::to_string(number) + ": is no 'name x y z width depth height'");
      if (box == EPURA_NONE) box = unit_box(sink);
      sink.node(called, EPURA_NONE, box, {width, 0, 0, x, 0, depth, 0, y, 0, 0, height, z});
    }
  }

  // All boxes are this one, enlarged.
  static std::uint32_t unit_box(Sink& sink) {
    const std::uint32_t shape = sink.shape("box");
    std::vector<Point> points;
    for (int i = 0; i < 8; ++i) points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    sink.points(points);
    const std::vector<std::uint32_t> corners{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    sink.polygons(std::vector<std::uint64_t>{4, 8, 12, 16, 20, 24}, corners);
    return shape;
  }
};

EPURA_IMPORTER(Boxes)
