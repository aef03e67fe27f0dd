// SPDX-License-Identifier: Apache-2.0
// The same drawing by Open CASCADE's polygonal hidden-line removal, for comparison:  occ MODEL FILE.svg|FILE.txt
//
// Isometric, visible and hidden lines, creases from 30 degrees. Reads with epura's readers and pairs edges with epura's
// table, so that only Open CASCADE's work differs. Prints the time of each stage and the number of segments found. As
// text, it writes the visible segments in units of the model, for `epura study paper --rival`.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "mesh/read.hpp"
#include "mesh/weld.hpp"
#include "occ_hlr.hpp"
#include "rows.hpp"
#include "say.hpp"

namespace {

using namespace epura;
using namespace epura::mesh;
using bench::Segment;

bench::TriangleMesh read_triangles(const std::filesystem::path& path) {
  const std::string bytes = read_file(path), extension = to_lower(path.extension().string());
  Soup soup = extension == ".stl"   ? read_stl(bytes, path.string())
              : extension == ".obj" ? read_obj(bytes, path.string())
              : extension == ".off" ? read_off(bytes, path.string())
                                    : read_ply(bytes, path.string());
  if (soup.corners_repeat_points) renumber(soup.points, soup.corners, same_places(soup.points));

  bench::TriangleMesh mesh;
  mesh.points.reserve(soup.points.size());
  for (const auto& p : soup.points) mesh.points.emplace_back(p[0], p[1], p[2]);
  int begin = 0;
  for (const int end : soup.face_ends) {
    for (int k = begin + 2; k < end; ++k) {
      const std::array<int, 3> t{soup.corners[begin], soup.corners[k - 1], soup.corners[k]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.corners.insert(mesh.corners.end(), t.begin(), t.end());
    }
    begin = end;
  }
  return mesh;
}

// The points are rotated in advance: without surfaces, a projector would rotate outlines twice.
void turn_to_isometric_view(std::vector<Vec3>& points) {
  const Vec3 viewer = glm::normalize(Vec3(1, -1, 1)), right = glm::normalize(glm::cross(Vec3(0, 0, 1), viewer));
  const Vec3 up = glm::cross(viewer, right);
  for (Vec3& p : points) p = {glm::dot(p, right), glm::dot(p, up), glm::dot(p, viewer)};
}

std::string path_of(const std::vector<Segment>& segments, const Vec2& min, double scale, double height) {
  std::string d;
  const auto add = [&](char command, const Vec2& p) {
    d += command + format_fixed((p.x - min.x) * scale, 3) + ' ' + format_fixed(height - (p.y - min.y) * scale, 3);
  };
  for (const Segment& segment : segments) {
    add('M', segment[0]);
    add('L', segment[1]);
  }
  return d;
}

std::string svg_of(const bench::Drawn& drawn) {
  constexpr double width = 277;
  Vec2 min(HUGE_VAL, HUGE_VAL), max(-HUGE_VAL, -HUGE_VAL);
  for (const auto* segments : {&drawn.visible, &drawn.hidden})
    for (const Segment& segment : *segments)
      for (const Vec2& p : segment) {
        min = glm::min(min, p);
        max = glm::max(max, p);
      }
  const double scale = width / (max.x - min.x), height = (max.y - min.y) * scale;
  const auto layer = [&](const char* style, const std::vector<Segment>& segments) {
    return "<path fill='none' stroke='black' " + std::string(style) + " d='" + path_of(segments, min, scale, height) +
           "'/>\n";
  };
  return "<svg xmlns='http://www.w3.org/2000/svg' width='277mm' height='" + format_fixed(height, 3) +
         "mm' viewBox='0 0 277 " + format_fixed(height, 3) + "'>\n" +
         layer("stroke-width='0.25' stroke-dasharray='3 0.75'", drawn.hidden) +
         layer("stroke-width='0.5'", drawn.visible) + "</svg>\n";
}

void draw(const char* model, const char* file) {
  const double start = bench::now();
  bench::TriangleMesh mesh = read_triangles(model);
  const double read = bench::now();
  turn_to_isometric_view(mesh.points);
  const bench::Drawn drawn = bench::remove_hidden_lines(mesh, 30);
  const double done = bench::now();
  write_file(file, std::filesystem::path(file).extension() == ".txt" ? bench::rows_of(drawn.visible) : svg_of(drawn));
  const double written = bench::now();

  bench::say_seconds("read", read - start);
  bench::say_seconds("hlr", done - read);
  bench::say_seconds("write", written - done);
  bench::say_count("visible", drawn.visible.size());
  bench::say_count("hidden", drawn.hidden.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: occ MODEL FILE.svg|FILE.txt\n", stderr);
    return static_cast<int>(ErrorKind::input);
  }
  try {
    draw(argv[1], argv[2]);
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "occ: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
