// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "app/commands.hpp"
#include "app/plugin_texts.hpp"
#include "app/viewing_steps.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "projection/catalogue.hpp"
#include "projection/matrices.hpp"
#include "view/condition.hpp"

namespace epura {

namespace {

void print_matrix(const Mat4& matrix) {
  for (int row = 0; row < 4; ++row) {
    std::string line = "   ";
    for (int column = 0; column < 4; ++column) line += padded(" " + format_fixed(matrix[column][row], 6), 14);
    print(line);
  }
}

void print_vanishing_points(const projection::Projection& projection) {
  const char* const axes[] = {"x", "y", "z"};
  const auto points = projection::vanishing_points(projection);
  int count = 0;
  for (const auto& point : points) count += point ? 1 : 0;
  print("\nprincipal vanishing points: " + std::to_string(count));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i])
      print(std::string("  ") + axes[i] + "  " + format_fixed(points[i]->x, 6) + ", " + format_fixed(points[i]->y, 6));
}

void show(const projection::ProjectionEntry& entry, const scene::ProjectionRequest& request) {
  print(entry.name + " (" + entry.family + "): " + entry.summary);
  if (!entry.reference.empty()) print("reference: " + entry.reference);
  print("plugin: " + entry.plugin.string());
  if (!entry.parameters.empty()) print("\nparameters (--projection " + entry.name + ":key=value)");
  print_parameters(entry.parameters);
  Box box;
  box.add(Vec3(0));
  box.add(Vec3(1));
  const projection::Projection projection = projection::make_projection(entry, request, box);
  print(std::string("\n") + (projection.central ? "M_per" : "M_par") +
        (request.assignments.empty() ? " with the defaults" : " with these parameters") + ", for the unit cube");
  print_matrix(projection::plane_matrix(projection));
  print_vanishing_points(projection);
  const view::Condition condition = view::condition_of(projection, box);
  print("condition of the projection: " + format_rounded(condition.number, 2) + ", " +
        format_fixed(std::floor(condition.digits_left()), 0) + " digits left");
}

int list(const std::vector<std::filesystem::path>& folders) {
  const projection::Catalogue catalogue = projection::load_catalogue(folders);
  std::string family;
  for (const projection::ProjectionEntry& entry : catalogue.entries) {
    if (entry.family != family) print((family.empty() ? "" : "\n") + entry.family);
    family = entry.family;
    print("  " + padded(entry.name, 18) + entry.summary);
  }
  for (const projection::BadPlugin& bad : catalogue.bad)
    std::fprintf(stderr, "epura: %s: %s\n", printable(bad.path.string()).c_str(), bad.reason.c_str());
  if (!catalogue.entries.empty()) return 0;
  throw Error(ErrorKind::plugin, "plugins", "none found", "name their folder with --plugin-path or $EPURA_PLUGIN_PATH");
}

}  // namespace

int plugins(const PluginsOptions& options) {
  const auto folders = projection::plugin_folders(options.plugin_path);
  if (options.name.empty()) {
    if (!options.model.empty())
      throw Error(ErrorKind::input, "--model", "needs a projection",
                  "as in 'epura plugins isometric --model part.stl'");
    return list(folders);
  }
  const scene::ProjectionRequest request = scene::parse_request(options.name);
  const projection::ProjectionEntry entry = projection::find_projection(request.name, folders);
  if (!options.model.empty()) return show_steps(entry, request, options);
  if (options.vertex) throw Error(ErrorKind::input, "--trace", "needs a model", "name its file with --model");
  show(entry, request);
  return 0;
}

}  // namespace epura
