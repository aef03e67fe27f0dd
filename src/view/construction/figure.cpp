// SPDX-License-Identifier: Apache-2.0
#include "construction/figure.hpp"

#include <algorithm>

#include "base/portable_math.hpp"

namespace epura::construction {

void add_point(Figure& figure, Point point) {
  const double near = 1e-6 + 1e-12 * glm::length(point.at);  // mm
  const auto has_symbol = [&point](const Point& other) {
    return other.symbol == point.symbol ||
           std::find(other.also.begin(), other.also.end(), point.symbol) != other.also.end();
  };
  if (std::any_of(figure.points.begin(), figure.points.end(), has_symbol)) return;
  const auto is_there = [&](const Point& other) {
    return other.marked && point.marked && glm::length(other.at - point.at) <= near;
  };
  const auto there = std::find_if(figure.points.begin(), figure.points.end(), is_there);
  if (there != figure.points.end())
    there->also.push_back(std::move(point.symbol));
  else
    figure.points.push_back(std::move(point));
}

void add_term(Figure& figure, const std::string& symbol, const std::string& meaning) {
  const Term term{symbol, meaning};
  if (std::find(figure.terms.begin(), figure.terms.end(), term) == figure.terms.end()) figure.terms.push_back(term);
}

// |cos(t) p + sin(t) q|^2 is extreme where tan(2 t) = 2 p.q / (p.p - q.q).
Curve ellipse_of(const Vec2& centre, const Vec2& p, const Vec2& q) {
  const double t = 0.5 * portable_atan2(2 * glm::dot(p, q), glm::dot(p, p) - glm::dot(q, q));
  const double c = portable_cos(t), s = portable_sin(t);
  return {centre, c * p + s * q, c * q - s * p};
}

}  // namespace epura::construction
