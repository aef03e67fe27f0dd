// SPDX-License-Identifier: Apache-2.0
#include "part_drawing.hpp"

#include <cstdio>

#include "base/text.hpp"

namespace epura::bench {

Drawing drawing_of(const Model& part, const Direction& direction) {
  Scene scene;
  scene.models = {part};
  const auto& [x, y, z] = direction.viewer;
  const std::vector<double> normal{x, y, z}, up{0, x == 0 && y == 0 ? 1.0 : 0.0, x == 0 && y == 0 ? 0.0 : 1.0};
  scene.views = {{.projection = "phigs",
                  .parameters = {{"kind", "parallel"}, {"vpn", normal}, {"vup", up}},
                  .name = "view",
                  .hidden = HiddenLines::dashed}};
  scene.sheets = {{.size = "A4", .scale = AutomaticScale::standard}};
  Settings settings;
  settings.threads = 1;
  return draw(scene, settings);
}

double strokes_of(const Drawing& drawing) {
  std::size_t count = 0;
  for (const SheetLayer& layer : drawing.layers())
    if (layer.name.starts_with("view/")) count += layer.strokes.size();
  return static_cast<double>(count);
}

std::string sentence_of(const Outcome& outcome) { return *outcome.trouble + " (" + outcome.stage + ")"; }

void print(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

std::string percent(std::size_t count, std::size_t all) {
  return format_fixed(all > 0 ? 100.0 * static_cast<double>(count) / static_cast<double>(all) : 0, 0) + " %";
}

}  // namespace epura::bench
