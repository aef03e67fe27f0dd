// SPDX-License-Identifier: Apache-2.0
#include "visibility/clear_contours.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/limits.hpp"
#include "visibility/visibility.hpp"

namespace epura::visibility {

namespace {

/// The facets of one model.
class FacetsOfModel {
 public:
  FacetsOfModel(const world::World& world, const view::ProjectedScene& view, int model)
      : view_(view),
        placed_(world.models[model]),
        mesh_(*placed_.mesh),
        face_of_triangle_(placed_.part->face_of_triangle),
        projector_(glm::inverse(placed_.to_world) * Vec4(view.projection.projector, view.projection.central ? 1 : 0)),
        first_(world.first_triangle[model]),
        at_vertex_(mesh_.points.size(), [&](const auto& visit) {
          for (std::size_t i = 0; i < mesh_.corners.size(); ++i)
            visit(static_cast<std::size_t>(mesh_.corners[i]), static_cast<int>(i / 3));
        }) {}

  /// Returns how a contour inside a face lies.
  [[nodiscard]] edges::ClearContour clear(const edges::FeatureEdge& contour) const {
    const auto& [a, b] = mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)].vertex;
    const Vec3 from = (mesh_.point(a) + mesh_.point(b)) / 2.0;
    const Vec3 towards = glm::normalize(view_.projection.central ? projector_ - from : projector_);
    return {contour.model, contour.mesh_edge, face_of_triangle_[own(contour).front()], from, towards, contour.clear};
  }

  /// Whether facets near a contour hide a part of it, though their surface lies behind it.
  [[nodiscard]] bool any_hides(const edges::FeatureEdge& contour) const {
    const edges::ClearContour clear_contour = clear(contour);
    const PageEdge line{contour.vertex[0], contour.vertex[1]};
    const std::span<const int> own_triangles = own(contour);
    return std::ranges::any_of(around(contour, clear_contour.face), [&](int t) {
      if (std::ranges::find(own_triangles, t) != own_triangles.end() || !is_clear(placed_, clear_contour, t))
        return false;
      const auto& all = view_.triangles;
      const auto begin = std::ranges::lower_bound(all, first_ + t, {}, &view::ViewTriangle::source);
      const auto end = std::ranges::upper_bound(begin, all.end(), first_ + t, {}, &view::ViewTriangle::source);
      return std::any_of(begin, end,
                         [&](const view::ViewTriangle& piece) { return hidden_part(view_, line, piece).has_value(); });
    });
  }

 private:
  // The facets of a face that are near a contour, ascending.
  [[nodiscard]] std::vector<int> around(const edges::FeatureEdge& contour, int face) const {
    const std::array<int, 2>& ends = mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)].vertex;
    std::vector<int> corners(ends.begin(), ends.end()), triangles;
    for (int ring = 0; ring < rings; ++ring) {
      triangles.clear();
      for (const int corner : corners)
        for (const int t : at_vertex_[static_cast<std::size_t>(corner)])
          if (face_of_triangle_[t] == face) triangles.push_back(t);
      sort_once(triangles);
      for (const int t : triangles)
        for (const int corner : mesh_.triangle(t)) corners.push_back(corner);
      sort_once(corners);
    }
    return triangles;
  }

  static void sort_once(std::vector<int>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  [[nodiscard]] std::span<const int> own(const edges::FeatureEdge& contour) const {
    return mesh_.triangles_of(mesh_.edges[static_cast<std::size_t>(contour.mesh_edge)]);
  }

  const view::ProjectedScene& view_;
  const world::Placed& placed_;
  const mesh::Mesh& mesh_;
  const std::vector<int>& face_of_triangle_;
  Vec3 projector_;  ///< the centre of projection, or a direction towards the viewer
  int first_;       ///< of its triangles in the world
  Groups<int> at_vertex_;
};

}  // namespace

void find_clear_contours(const world::World& world, const view::ProjectedScene& view, edges::FeatureEdges& drawn,
                         const Progress& progress) {
  drawn.clear_contours.clear();
  for (auto from = drawn.edges.begin(); from != drawn.edges.end();) {
    const int model = from->model;
    std::vector<const edges::FeatureEdge*> contours;
    for (; from != drawn.edges.end() && from->model == model; ++from)
      if (from->clear > 0) contours.push_back(&*from);
    if (contours.empty()) continue;
    const FacetsOfModel facets(world, view, model);
    std::vector<char> hidden(contours.size(), 0);
    parallel_for(contours.size(), 64, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) hidden[i] = facets.any_hides(*contours[i]) ? 1 : 0;
    });
    for (std::size_t i = 0; i < contours.size(); ++i)
      if (hidden[i] != 0) drawn.clear_contours.push_back(facets.clear(*contours[i]));
  }
}

}  // namespace epura::visibility
