// SPDX-License-Identifier: Apache-2.0
// Small drawings through the library, one after the other:  small [COUNT]
// The first is not counted: it loads what all others use.
#include <algorithm>
#include <cstdio>
#include <epura/epura.hpp>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "say.hpp"

namespace {

using namespace epura;

Polygons cube() {
  return {
      .points = {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 0, 20}, {20, 0, 20}, {20, 20, 20}, {0, 20, 20}},
      .faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

OwnProjection own_projection() {
  return {.name = "own-isometric", .project = [](const std::vector<double>&, const epura_scene&, epura_view& view) {
            constexpr double to_viewer[3] = {0.57735026918962584, -0.57735026918962584, 0.57735026918962584};
            std::copy_n(to_viewer, 3, view.normal);
            std::copy_n(to_viewer, 3, view.projector);
            view.up[2] = 1;
            return std::optional<std::string>();
          }};
}

void measure(const char* what, int count, const std::string& projection, const Settings& settings) {
  std::vector<double> seconds;
  std::size_t bytes = 0;
  const Scene scene{.models = {{.polygons = cube()}}, .views = {{.projection = projection}}};
  for (int i = 0; i <= count; ++i) {
    const double begin = bench::now();
    bytes += to_svg(draw(scene, settings)).size();
    if (i > 0) seconds.push_back(bench::now() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf("| %s | %d | %.3f | %.3f |\n", what, count, 1e3 * seconds.front(), 1e3 * seconds[seconds.size() / 2]);
  if (bytes == 0) std::puts("nothing was drawn");
}

}  // namespace

int main(int argc, char** argv) {
  const auto count = argc > 1 ? parse_integer(argv[1]) : 1000;
  if (!count || *count < 1) {
    std::fputs("usage: small [COUNT]\n", stderr);
    return 2;
  }
  std::puts("| cubes through the library | drawn | least, ms | median, ms |\n|---|---|---|---|");
  const int n = static_cast<int>(*count);
  measure("projection of a plugin", n, "isometric", {});
  measure("the same, one thread", n, "isometric", {.threads = 1});
  measure("plugin kept", n, "isometric", {.plugins = Plugins()});
  measure("plugin kept, one thread", n, "isometric", {.threads = 1, .plugins = Plugins()});
  measure("projection of this program, one thread", n, "own-isometric",
          {.threads = 1, .projections = {own_projection()}});
}
