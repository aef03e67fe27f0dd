// SPDX-License-Identifier: Apache-2.0
#include "accuracy/view_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "accuracy/contour_ends.hpp"
#include "accuracy/drawn_ends.hpp"
#include "accuracy/judged_view.hpp"
#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"
#include "drawing/limits.hpp"
#include "view/condition.hpp"

namespace epura::accuracy {

namespace {

using report::ErrorTerm;

// The error of a few rounded operations, relative to their results: 2^-50.
constexpr double rounding = 8.8817841970012523e-16;
// Below the sine of a ten-thousandth of a degree, facets do not tell where two surfaces cross.
constexpr double min_sine = 2e-6;

/// What distances become on paper.
class Judge : JudgedView {
 public:
  using JudgedView::JudgedView;

  [[nodiscard]] double height_of(int triangle) const {
    return judged_.is_whole ? judged_.heights.of_triangle[static_cast<std::size_t>(triangle)]
                            : height_of_model(judged_.world.model_of_triangle(triangle));
  }

  void add_surface(report::ViewError& error) const {
    for (const view::ViewTriangle& triangle : judged_.view.triangles) {
      const double height = height_of(triangle.source);
      if (!(height > 0)) continue;
      double stretch = 0;
      for (const int vertex : triangle.vertex) stretch = std::max(stretch, stretch_at(vertex));
      if (!(height * stretch > error[ErrorTerm::surface])) continue;
      error[ErrorTerm::surface] = height * stretch;
      error.estimated = is_estimated(triangle.source);
    }
  }

  /// Faces that are off by h and k meet farther from where their facets meet, the smaller the angle between them.
  void add_intersections(report::ViewError& error) const {
    const ChordHeights chords = heights_of_chords();
    double largest = 0;
    for (const edges::FeatureEdge& edge : judged_.edges.edges) {
      const double off = off_edge(edge, chords);
      if (!(off > 0)) continue;
      largest = std::max(largest, off * std::max(stretch_at(edge.vertex[0]), stretch_at(edge.vertex[1])));
    }
    error[ErrorTerm::intersections] = std::max(0.0, largest - error[ErrorTerm::surface]);
  }

 private:
  [[nodiscard]] double height_of_model(int model) const {
    return judged_.heights.of_model[static_cast<std::size_t>(judged_.world.number_in_scene(model))];
  }

  [[nodiscard]] bool is_estimated(int triangle) const {
    if (judged_.is_whole) return judged_.heights.is_estimated[static_cast<std::size_t>(triangle)] != 0;
    const int model = judged_.world.number_in_scene(judged_.world.model_of_triangle(triangle));
    return judged_.heights.model_is_estimated[static_cast<std::size_t>(model)] != 0;
  }

  /// How far the chords of borders are from these, in world units, by model and mesh edge; empty for models without
  /// recognised faces.
  using ChordHeights = std::vector<std::vector<double>>;

  // Vertices of the border between two faces lie on both, so its edges are chords of the true one, however small the
  // angle between the faces: with a turn t from one to the next, a chord of length s is off by s t / 8. Twice that, as
  // vertices are not evenly distributed.
  [[nodiscard]] ChordHeights heights_of_chords() const {
    ChordHeights heights(judged_.world.models.size());
    for (std::size_t m = 0; m < heights.size(); ++m) {
      const world::Placed& placed = judged_.world.models[m];
      if (placed.part == nullptr || !judged_.is_whole) continue;
      heights[m].assign(placed.mesh->edges.size(), 0);
      const auto along = [&](int edge) {
        const auto& [a, b] = placed.mesh->edges[static_cast<std::size_t>(edge)].vertex;
        const int first = judged_.world.first_vertex[m];
        return judged_.world.points[first + b] - judged_.world.points[first + a];
      };
      for (const surfaces::PartBorder& border : placed.part->borders) {
        const std::size_t count = border.edges.size();
        for (std::size_t i = border.closed ? 0 : 1; i < count; ++i) {
          const std::array both{border.edges[(i + count - 1) % count], border.edges[i]};
          const Vec3 one = along(both[0]), two = along(both[1]);
          const auto& ends = placed.mesh->edges[static_cast<std::size_t>(both[0])].vertex;
          const auto& others = placed.mesh->edges[static_cast<std::size_t>(both[1])].vertex;
          const bool is_against = ends[0] == others[0] || ends[1] == others[1];
          const double turn =
              portable_atan2(glm::length(glm::cross(one, two)), (is_against ? -1 : 1) * glm::dot(one, two));
          for (const int edge : both) {
            double& height = heights[m][static_cast<std::size_t>(edge)];
            height = std::max(height, glm::length(along(edge)) * turn / 4);
          }
        }
      }
    }
    return heights;
  }

  // Two planes that are off by h and k cross within sqrt(h^2 + k^2 + 2 h k |cosine|) / sine.
  [[nodiscard]] double off_between(int one, int other, double h, double k) const {
    const Vec3 a = normal_of(one), b = normal_of(other);
    const double lengths = glm::length(a) * glm::length(b);
    if (!(lengths > 0) || (h == 0 && k == 0)) return 0;
    const double sine = std::max(min_sine, glm::length(glm::cross(a, b)) / lengths);
    return std::sqrt(h * h + k * k + 2 * h * k * std::abs(glm::dot(a, b)) / lengths) / sine;
  }

  // The lines of a thread have one triangle twice.
  [[nodiscard]] double off_edge(const edges::FeatureEdge& edge, const ChordHeights& chords) const {
    if (edge.crossing < 0) return edge.mesh_edge < 0 ? 0 : off_border(edge, chords);
    const auto [one, other] = judged_.edges.crossings[static_cast<std::size_t>(edge.crossing)].triangles;
    if (one == other) return 0;
    // Farther away, other facets meet.
    return std::min(off_between(one, other, height_of(one), height_of(other)),
                    std::max(longest_side(one), longest_side(other)));
  }

  // Where two faces of the part meet; or at the outline of a section, what is left of a face, and the cut face.
  [[nodiscard]] double off_border(const edges::FeatureEdge& edge, const ChordHeights& chords) const {
    const world::Placed& placed = judged_.world.models[static_cast<std::size_t>(edge.model)];
    const std::span<const int> beside =
        placed.mesh->triangles_of(placed.mesh->edges[static_cast<std::size_t>(edge.mesh_edge)]);
    if (beside.size() != 2) return 0;
    const int first = judged_.world.first_triangle[static_cast<std::size_t>(edge.model)];
    const std::array both{first + beside[0], first + beside[1]};
    if (edge.kind == EdgeKind::section) return off_between(both[0], both[1], height_of_model(edge.model), 0);
    if (!judged_.is_whole || is_inside(placed, edge.mesh_edge, both)) return 0;
    const double h = height_of(both[0]), k = height_of(both[1]);
    const double off = off_between(both[0], both[1], h, k);
    if (placed.part == nullptr || placed.part->border_at(edge.mesh_edge) == nullptr) return off;
    const double chord = chords[static_cast<std::size_t>(edge.model)][static_cast<std::size_t>(edge.mesh_edge)];
    return std::min(off, std::max(h, k) + chord);
  }
};

/// How far it is, mm, from where it would be.
struct MeasuredInk {
  double merged;        ///< drawing::merged_by
  double contour_ends;  ///< off_at_drawn_ends
};

MeasuredInk measured_ink(const ViewToJudge& judged, const Progress& progress) {
  MeasuredInk ink{judged.drawing.distances.joined_within, longest_drawn(judged)};
  try {
    const visibility::ResolvedView lines{judged.world, judged.view, judged.edges, judged.hidden};
    ink.merged = drawing::merged_by(lines, judged.paper, judged.options, judged.drawing, progress);
    ink.contour_ends = off_at_drawn_ends(judged, progress);
  } catch (const OutOfTime&) {  // the bounds stay
  }
  return ink;
}

}  // namespace

report::ViewError error_of_view(const ViewToJudge& judged, const drawing::CurveReport& curves, bool hides,
                                const Progress& progress) {
  report::ViewError error{judged.drawing.name};
  const Judge judge(judged);
  judge.add_surface(error);
  judge.add_intersections(error);
  const double size = judged.view.extent * judged.paper.scale;
  const view::Condition condition =
      view::condition_of(judged.view.projection, judged.world.box, judged.world.one_rounding);
  const MeasuredInk ink = measured_ink(judged, progress);
  error[ErrorTerm::contours] = std::max(ink.contour_ends, off_at_cusps(judged));
  error[ErrorTerm::file] = condition.moved_by_files * size;
  error[ErrorTerm::map] = condition.number * rounding * size;
  error[ErrorTerm::grid] = judged.drawing.distances.coincident + drawing::on_line_mm;
  error[ErrorTerm::hiding] = hides ? guaranteed_part * size : 0;
  error[ErrorTerm::merging] = ink.merged;
  error[ErrorTerm::curves] = curves.deviation + curves.bulge;
  return error;
}

}  // namespace epura::accuracy
