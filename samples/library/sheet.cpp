// SPDX-License-Identifier: Apache-2.0
// Draws a cube that is in memory:  sheet SVG
#include <epura/epura.hpp>
#include <iostream>

int main(int argc, char** argv) try {
  epura::Polygons cube{
      .points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 9}, {9, 0, 9}, {9, 9, 9}, {0, 9, 9}},
      .faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  const epura::Drawing drawing = epura::draw({.models = {{.polygons = cube}}, .views = {{.projection = "isometric"}}});
  for (const std::string& warning : drawing.warnings()) std::cerr << warning << '\n';
  epura::write(drawing, argc > 1 ? argv[1] : "cube.svg");
} catch (const epura::Failure& failure) {
  std::cerr << failure.what() << '\n' << failure.hint() << '\n';
  return static_cast<int>(failure.kind());
}
