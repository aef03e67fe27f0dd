// SPDX-License-Identifier: Apache-2.0
// What a view shows of round features: a model without hidden lines has no centre lines where it hides them.
#pragma once

#include <array>
#include <vector>

#include "annotations/seen_circle.hpp"
#include "drawing/drawing.hpp"
#include "features/centred_features.hpp"
#include "sheet/view_lines.hpp"
#include "visibility/spans.hpp"

namespace epura::sheet {

/// The part of a turn over which a rim is seen, and its points.
struct SeenRim {
  double turn = 0;
  std::vector<Vec2> points{};
};

/// A line of the page, and how far lines extend beyond what they belong to, mm.
struct PageAxis {
  Vec2 at, along;  ///< a unit vector
  double beyond;
};

/// Decides which features have centre lines in a view.
class SeenFeatures {
 public:
  /// Refers to its arguments.
  SeenFeatures(const drawing::ViewDrawing& drawing, const BodyStyles& styles);

  /// Whether a feature is seen, or has hidden lines.
  [[nodiscard]] bool shows(const features::CentredRound& feature) const;
  /// Whether a feature is seen only through its ends, obliquely: its axis is behind the material around it.
  [[nodiscard]] bool is_inside(const features::CentredRound& feature) const;
  /// Whether parts of a feature are seen from outside: other material may lie in front of the rest.
  [[nodiscard]] bool is_in_parts(const features::CentredRound& feature) const;

  /// What is seen of the rims of a feature, by ring.
  [[nodiscard]] std::vector<SeenRim> rims(const features::CentredRound& feature) const;
  /// Adds the places along an axis at which lines of a feature are seen on either side of it.
  void add_beside(const features::CentredRound& feature, const PageAxis& axis,
                  std::array<visibility::Spans, 2>& sides) const;

 private:
  using Edge = std::array<int, 4>;  // model, vertices, segment

  [[nodiscard]] bool has_hidden_lines(const features::CentredRound& feature) const;
  template <class Visit>
  void visit_edges(const features::CentredRound& feature, const Visit& visit) const;
  [[nodiscard]] drawing::Segment in_whole_view(drawing::Segment segment) const;
  [[nodiscard]] int body_of(const features::CentredRound& feature) const;

  const drawing::ViewDrawing& drawing_;
  const BodyStyles& styles_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 3>> bodies_;  ///< model, vertex and named body
};

}  // namespace epura::sheet
