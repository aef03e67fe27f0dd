// SPDX-License-Identifier: Apache-2.0
#include "visibility/choose_method.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

constexpr double guaranteed_part = 1e-6;
constexpr double points_a_span = 2;
// Up to here looking at points takes less time than the exact method (docs/accuracy.md).
constexpr double worthwhile_points = 1.25;
constexpr double least_density = 1e-6, most_density = 1e6;

double points_an_edge(const ProjectedScene& view, const FeatureEdges& drawn, double density) {
  double points = 0;
  for (const FeatureEdge& edge : drawn.edges) {
    const PageVertex& p = view.vertices[edge.vertex[0]];
    const PageVertex& q = view.vertices[edge.vertex[1]];
    points += std::max(1.0, std::ceil(std::hypot(q.x - p.x, q.y - p.y) * density));
  }
  return points / static_cast<double>(std::max<std::size_t>(drawn.edges.size(), 1));
}

}  // namespace

MethodChoice choose_method(const ProjectedScene& view, const FeatureEdges& drawn, double mm, double allowed) {
  const double guaranteed = guaranteed_part * view.extent * mm;
  if (!(guaranteed <= allowed))
    throw Error(ErrorKind::input, "--max-error", "is " + format_number(allowed) + " mm, and no method guarantees that",
                "the exact method guarantees " + format_rounded(guaranteed, 3) +
                    " mm, a millionth of the drawing, in this view");
  Method sampled;
  sampled.way = Way::sampled;
  sampled.density = std::clamp(points_a_span / allowed, least_density, most_density);
  const double points = points_an_edge(view, drawn, sampled.density * mm);
  const std::string wanted = format_rounded(points, 3) + " points an edge";
  if (points > worthwhile_points) return {{}, guaranteed, "sampling would want " + wanted + ", which takes longer"};
  return {sampled, 1 / sampled.density, wanted + " are enough, which takes less time than exact"};
}

}  // namespace epura
