// SPDX-License-Identifier: Apache-2.0
#include "hlr/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/nearest.hpp"
#include "base/spline.hpp"
#include "drawing/drawing.hpp"
#include "hlr/limits.hpp"

namespace epura::hlr {

namespace {

static_assert(number_of(EdgeKind::contour) == EPURA_HLR_CONTOUR &&
              number_of(EdgeKind::boundary) == EPURA_HLR_BOUNDARY && number_of(EdgeKind::crease) == EPURA_HLR_CREASE &&
              number_of(EdgeKind::intersection) == EPURA_HLR_INTERSECTION &&
              number_of(EdgeKind::wire) == EPURA_HLR_WIRE && number_of(EdgeKind::tangent) == EPURA_HLR_TANGENT &&
              number_of(EdgeKind::smooth) == EPURA_HLR_SMOOTH);

/// Everything about a line but where it is.
struct Source : epura_hlr_curve {
  const SourceEdge* piece = nullptr;  ///< of an edge with a spline that can be drawn as such; null: none
};

class CurveMaker {
 public:
  CurveMaker(const Model& model, const drawing::ViewDrawing& drawing, double scale, bool all_types)
      : model_(model), drawing_(drawing), scale_(scale), all_types_(all_types) {
    for (std::size_t i = 0; i < model.splines.size() && all_types; ++i) add_picture(static_cast<int>(i));
  }

  Curves make() {
    for (const drawing::Chain& chain : drawing_.chains)
      if (chain.points.size() > 1) add(chain);
    if (all_types_)
      for (epura_hlr_curve& curve : made_.curves) name_exactly(curve);
    return std::move(made_);
  }

 private:
  // Unless poles are behind the viewer: it is no spline there that ends.
  void add_picture(int number) {
    const Spline& spline = model_.splines[static_cast<std::size_t>(number)];
    PlaneSpline picture{};
    picture.knots = spline.knots;
    bool are_equal = true;
    for (const Vec4& pole : spline.poles) {
      const Vec4 seen = drawing_.world_to_page * pole;
      if (!(seen.w > 0)) return;
      picture.poles.insert(picture.poles.end(), {seen.x / seen.w / scale_, seen.y / seen.w / scale_});
      picture.weights.push_back(seen.w);
      are_equal = are_equal && seen.w == picture.weights.front();
    }
    PlaneSpline& kept = made_.splines[number] = std::move(picture);
    kept.told = {sizeof(epura_hlr_spline), static_cast<std::uint32_t>(spline.degree), spline.poles.size(),
                 kept.poles.data(),        are_equal ? nullptr : kept.weights.data(), kept.knots.data()};
  }

  static void name_exactly(epura_hlr_curve& curve) {
    const auto square = [](const double(&v)[2]) { return v[0] * v[0] + v[1] * v[1]; };
    if (curve.type == EPURA_HLR_POLYLINE && curve.count == 2) curve.type = EPURA_HLR_LINE;
    if (curve.type == EPURA_HLR_ELLIPSE && std::abs(square(curve.u) - square(curve.v)) <= equal_axes * square(curve.u))
      curve.type = EPURA_HLR_CIRCLE;
  }

  [[nodiscard]] Source source_of(const drawing::Segment& segment) const {
    Source source{};
    source.kind = number_of(segment.kind);
    source.visible = segment.visible ? 1 : 0;
    source.edge = EPURA_NONE;
    source.faces[0] = source.faces[1] = no_face;
    if (segment.crossing >= 0) {
      const auto& faces = drawing_.crossings[static_cast<std::size_t>(segment.crossing)].faces;
      for (const std::size_t i : {0, 1})
        if (faces[i][1] >= 0) source.faces[i] = model_.face_of_polygon[static_cast<std::size_t>(faces[i][1])];
      return source;
    }
    const auto [low, high] = std::minmax(segment.edge[0], segment.edge[1]);
    const SourceEdge* edge = edge_at(model_, {low, high});
    const auto faces = faces_at(model_, {low, high}, edge);
    source.faces[0] = faces[0];
    source.faces[1] = faces[1];
    if (edge != nullptr) source.edge = edge->number;
    if (edge != nullptr && made_.splines.contains(edge->spline)) source.piece = edge;
    return source;
  }

  static bool are_one(const Source& a, const Source& b) {
    return a.kind == b.kind && a.visible == b.visible && a.edge == b.edge && key_of(a.faces[0]) == key_of(b.faces[0]) &&
           key_of(a.faces[1]) == key_of(b.faces[1]) && are_along_one(a.piece, b.piece);
  }

  // Where a closed spline ends, it begins with another parameter.
  static bool are_along_one(const SourceEdge* a, const SourceEdge* b) {
    if (a == b || a == nullptr || b == nullptr) return a == b;
    return a->spline == b->spline && std::ranges::find_first_of(a->parameters, b->parameters) != a->parameters.end();
  }

  // Where ends were moved, a line may have been lost: then that of the chain which is nearest to it is its source.
  [[nodiscard]] const drawing::Segment& segment_of(const drawing::Chain& chain, std::size_t line,
                                                   std::size_t lines) const {
    const auto segment = [&](std::size_t i) -> const drawing::Segment& {
      return drawing_.segments[static_cast<std::size_t>(chain.segments[i])];
    };
    if (chain.segments.size() == lines) return segment(line);
    const Vec2 middle = (chain.points[line] + chain.points[(line + 1) % chain.points.size()]) / 2.0;
    const auto distance = [&](std::size_t i) {
      return glm::distance(nearest_on_segment(middle, segment(i).from, segment(i).to), middle);
    };
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < chain.segments.size(); ++i)
      if (distance(i) < distance(nearest)) nearest = i;
    return segment(nearest);
  }

  static const drawing::CurvePart* curve_at(const drawing::Chain& chain, std::size_t line) {
    for (const drawing::CurvePart& curve : chain.curves)
      if (curve.first <= static_cast<int>(line) && static_cast<int>(line) < curve.last) return &curve;
    return nullptr;
  }

  void add(const drawing::Chain& chain) {
    const std::size_t lines = chain.points.size() - (chain.closed ? 0 : 1);
    std::size_t begin = 0;
    Source source = source_of(segment_of(chain, 0, lines));
    const SourceEdge* first_piece = source.piece;
    const drawing::CurvePart* curve = curve_at(chain, 0);
    const auto angles_of = [&](const drawing::CurvePart* part) {
      return part == nullptr ? std::vector<double>() : drawing::corner_angles(*part, chain.points);
    };
    std::vector<double> angles = angles_of(curve);
    for (std::size_t i = 1; i <= lines; ++i) {
      const Source next = i < lines ? source_of(segment_of(chain, i, lines)) : source;
      const drawing::CurvePart* next_curve = i < lines ? curve_at(chain, i) : curve;
      if (i < lines && are_one(source, next) && (next_curve == curve || source.piece != nullptr)) {
        source.piece = next.piece;
        continue;
      }
      add_points(source, chain, begin, i);
      if (source.piece != nullptr) {
        add_spline(source, *first_piece);
      } else if (curve != nullptr) {
        const auto angle = [&](std::size_t point) { return angles[point - static_cast<std::size_t>(curve->first)]; };
        add_arc(source, *curve, angle(begin), angle(i));
      }
      made_.curves.push_back(source);
      begin = i;
      source = next;
      first_piece = next.piece;
      if (next_curve != curve) angles = angles_of(next_curve);
      curve = next_curve;
    }
  }

  // Lines begin ... end - 1 of a chain.
  void add_points(epura_hlr_curve& curve, const drawing::Chain& chain, std::size_t begin, std::size_t end) {
    curve.first = made_.points.size() / 2;
    curve.count = end - begin + 1;
    for (std::size_t i = begin; i <= end; ++i) {
      const Vec2 p = chain.points[i % chain.points.size()] / scale_;
      made_.points.insert(made_.points.end(), {p.x, p.y});
    }
  }

  // From its first piece to the last one, which is `piece`.
  void add_spline(Source& curve, const SourceEdge& first) const {
    curve.type = EPURA_HLR_SPLINE;
    curve.spline = &made_.splines.at(curve.piece->spline).told;
    const double* points = made_.points.data() + 2 * curve.first;
    curve.from = parameter_at(first, points);
    curve.to = parameter_at(*curve.piece, points + 2 * (curve.count - 1));
  }

  [[nodiscard]] double parameter_at(const SourceEdge& piece, const double* point) const {
    const auto distance = [&](const Vec4& on_it) {
      const Vec4 seen = drawing_.world_to_page * on_it;
      return std::hypot(seen.x / seen.w / scale_ - point[0], seen.y / seen.w / scale_ - point[1]);
    };
    return nearest_parameter(model_.splines[static_cast<std::size_t>(piece.spline)], piece.parameters[0],
                             piece.parameters[1], distance);
  }

  void add_arc(epura_hlr_curve& curve, const drawing::CurvePart& arc, double from, double to) const {
    curve.type = EPURA_HLR_ELLIPSE;
    for (const int axis : {0, 1}) {
      curve.centre[axis] = arc.centre[axis] / scale_;
      curve.u[axis] = arc.u[axis] / scale_;
      curve.v[axis] = arc.v[axis] / scale_;
    }
    curve.from = from;
    curve.to = to;
  }

  const Model& model_;
  const drawing::ViewDrawing& drawing_;
  double scale_;
  bool all_types_;
  Curves made_;
};

}  // namespace

Curves curves_of(const Model& model, const drawing::ViewDrawing& drawing, double scale, bool all_types) {
  return CurveMaker(model, drawing, scale, all_types).make();
}

}  // namespace epura::hlr
