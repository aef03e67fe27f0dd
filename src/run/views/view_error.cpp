// SPDX-License-Identifier: Apache-2.0
#include "views/view_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "drawing/limits.hpp"
#include "drawing/near_lines.hpp"
#include "report/format.hpp"
#include "view/condition.hpp"
#include "views/contour_ends.hpp"
#include "views/draw_view.hpp"
#include "views/judged_view.hpp"

namespace epura::pipeline {

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

std::string millimetres(double length) { return report::rounded_up(length) + " mm"; }

// The least --max-error that a view keeps which was drawn with `max_error`, mm.
double least_max_error(const report::ViewError& error, double max_error, bool has_arcs) {
  double fixed = 0, shares = 0;
  for (std::size_t i = 0; i < error.mm.size(); ++i) {
    const auto term = static_cast<ErrorTerm>(i);
    const bool is_chosen = term == ErrorTerm::merging || term == ErrorTerm::writing ||
                           (term == ErrorTerm::curves && has_arcs);  // by max_error, unless it was given
    const double share = is_chosen ? row_of(term).share : 0;
    const bool keeps_share = is_chosen && error[term] <= share * max_error;
    fixed += keeps_share ? 0 : error[term];
    shares += keeps_share ? share : 0;
  }
  return fixed / (1 - shares);
}

}  // namespace

report::ViewError error_of_view(const ViewToJudge& judged, const drawing::CurveReport& curves, bool hides) {
  report::ViewError error{judged.drawing.name};
  const Judge judge(judged);
  judge.add_surface(error);
  judge.add_intersections(error);
  const double size = judged.view.extent * judged.paper.scale;
  const view::Condition condition =
      view::condition_of(judged.view.projection, judged.world.box, judged.world.one_rounding);
  error[ErrorTerm::contours] = off_at_ends_of_contours(judged);
  error[ErrorTerm::file] = condition.moved_by_files * size;
  error[ErrorTerm::map] = condition.number * rounding * size;
  error[ErrorTerm::grid] = judged.drawing.distances.coincident + drawing::on_line_mm;
  error[ErrorTerm::hiding] = hides ? guaranteed_part * size : 0;
  error[ErrorTerm::merging] = judged.merged;
  error[ErrorTerm::curves] = curves.deviation + curves.bulge;
  return error;
}

double join_within(double max_error, double usual) {
  return std::min(usual, row_of(ErrorTerm::merging).share * max_error / drawing::NearLines{1}.reach_in_all());
}

void expect_certain(double max_error, double part) {
  if (part <= 0 || part >= guaranteed_part) return;
  throw Error(ErrorKind::input, "--max-error",
              "is " + format_number(max_error) + " mm, but below " +
                  format_rounded(max_error * guaranteed_part / part, 1) +
                  " mm no part of a line shorter than a millionth of the drawing is certain to be visible or hidden",
              "raise --max-error well above that: the nearer to it, the longer importers take");
}

void expect_within(double max_error, bool has_arcs, std::span<const report::ViewError> errors, const Facets& facets) {
  const auto worst = std::max_element(errors.begin(), errors.end(),
                                      [](const auto& one, const auto& other) { return one.total() < other.total(); });
  if (worst == errors.end() || worst->total() <= max_error) return;
  TooFar attempt{*worst, 0, facets};
  for (const report::ViewError& error : errors)
    attempt.least = std::max(attempt.least, least_max_error(error, max_error, has_arcs));
  throw attempt;
}

bool may_be_finer(const TooFar& attempt, const std::optional<TooFar>& last, double factor) {
  constexpr double most_triangles = 250'000;
  constexpr double least_gain = 0.9;  // above, what is off is not off by facets
  const double growth = last ? attempt.facets.triangles / last->facets.triangles : factor;
  return attempt.facets.is_imported && growth * attempt.facets.triangles <= most_triangles &&
         (!last || attempt.least <= least_gain * last->least);
}

void refuse(double max_error, const TooFar& best) {
  const report::ViewError& error = best.worst;
  constexpr double above_rounding = 1.5;  // to one digit
  const ErrorTerm most = error.dominant();
  const bool by_facets = most == ErrorTerm::surface || most == ErrorTerm::intersections || most == ErrorTerm::contours;
  throw Error(ErrorKind::input, "--max-error",
              "is " + format_number(max_error) + " mm, but lines of view '" + error.view + "' may be off by " +
                  millimetres(error.total()) + "; " + millimetres(error[most]) + " of it by " + row_of(most).cause,
              "raise --max-error to " + format_rounded(above_rounding * best.least, 1) + " mm, or " +
                  (by_facets && best.facets.is_imported ? "draw at a smaller scale" : row_of(most).remedy));
}

std::string sentence_of(const report::ViewError& error) {
  const ErrorTerm most = error.dominant();
  return error.view + ": lines are within " + millimetres(error.total()) + " of the part; most of it, " +
         millimetres(error[most]) + ", by " + row_of(most).cause + " (" +
         report::evidence_names[static_cast<std::size_t>(error.evidence(most))] + ")\n";
}

}  // namespace epura::pipeline
