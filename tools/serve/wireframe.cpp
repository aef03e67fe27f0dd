// SPDX-License-Identifier: Apache-2.0
#include "serve/wireframe.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "edges/dihedral.hpp"
#include "edges/feature_edges.hpp"

namespace epura {

namespace {

template <class Item>
void append(std::string& bytes, const std::vector<Item>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
}

}  // namespace

std::string wireframe_bytes(const world::World& world, const view::ProjectedScene& any_view,
                            const edges::EdgeOptions& edges) {
  edges::EdgeOptions of_every_view = edges;
  of_every_view.contour = false;
  std::vector<std::array<std::int32_t, 2>> lines;
  std::vector<std::array<std::int32_t, 4>> folds;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const auto kinds = edges::feature_edges(world, any_view, model, of_every_view);
    const mesh::Mesh& mesh = *world.models[model].mesh;
    const edges::EdgeSurroundings around{world, model, 1};
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
      const mesh::MeshEdge& edge = mesh.edges[i];
      const std::array<int, 2> ends{world.first_vertex[model] + edge.vertex[0],
                                    world.first_vertex[model] + edge.vertex[1]};
      if (kinds[i]) {
        lines.push_back({ends[0], ends[1]});
      } else if (edges.contour && edge.count == 2) {
        const auto triangles = mesh.triangles_of(edge);
        folds.push_back({ends[0], ends[1], around.apex(ends, triangles[0]), around.apex(ends, triangles[1])});
      }
    }
  }
  std::vector<std::uint32_t> counts;
  for (const std::size_t count : {world.points.size(), lines.size(), folds.size(), std::size_t{0}})
    counts.push_back(static_cast<std::uint32_t>(count));
  std::vector<std::array<double, 3>> points;
  for (const Vec3& p : world.points) points.push_back({p.x, p.y, p.z});
  std::string bytes;
  append(bytes, counts);
  append(bytes, points);
  append(bytes, lines);
  append(bytes, folds);
  return bytes;
}

}  // namespace epura
