#include "sheet/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace epura {

namespace {

constexpr double touching = 1e-6;  // mm

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

// Where b meets a, as a distance along a; parallel lines do not.
std::optional<double> meeting(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Vec2 a = a1 - a0, b = b1 - b0;
  const double length = glm::length(a), other = glm::length(b), area = cross(a, b);
  constexpr double sine = 1e-3;
  if (!(std::abs(area) > sine * length * other)) return std::nullopt;
  const double s = cross(b0 - a0, b) / area, t = cross(b0 - a0, a) / area;
  if (s * length < -touching || (s - 1) * length > touching) return std::nullopt;
  if (t * other < -touching || (t - 1) * other > touching) return std::nullopt;
  return std::clamp(s, 0.0, 1.0) * length;
}

double distance(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double square = glm::dot(along, along);
  const double s = square > 0 ? std::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0;
  return glm::distance(p, from + s * along);
}

template <class Visit>
void visit_lines(const Chain& chain, const Visit& visit) {
  const std::size_t lines = chain.points.size() - (chain.closed ? 0 : 1);
  for (std::size_t i = 0; i < lines; ++i) visit(chain.points[i], chain.points[(i + 1) % chain.points.size()]);
}

}  // namespace

Crossings::Crossings(std::span<const Chain> chains) : chains_(chains) {
  Vec2 most(-HUGE_VAL);
  least_ = Vec2(HUGE_VAL);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    visit_lines(chains[i], [&](const Vec2& from, const Vec2& to) {
      lines_.push_back({from, to, i});
      least_ = glm::min(least_, glm::min(from, to));
      most = glm::max(most, glm::max(from, to));
    });
  }
  if (lines_.empty()) return;
  // About one cell for each line.
  const Vec2 size = most - least_;
  constexpr double most_cells = 2048;
  side_ =
      std::max({std::sqrt(size.x * size.y / double(lines_.size())), size.x / most_cells, size.y / most_cells, 1e-3});
  columns_ = static_cast<int>(size.x / side_) + 1;
  rows_ = static_cast<int>(size.y / side_) + 1;

  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Line& line : lines_) visit_cells(line.from, line.to, [&](int cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  lines_of_cells_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < lines_.size(); ++i)
    visit_cells(lines_[i].from, lines_[i].to, [&](int cell) { lines_of_cells_[next[cell]++] = static_cast<int>(i); });
}

int Crossings::cell_of(double at, double least, int count) const {
  return std::clamp(static_cast<int>(std::floor((at - least) / side_)), 0, count - 1);
}

template <class Visit>
void Crossings::visit_cells(const Vec2& from, const Vec2& to, const Visit& visit) const {
  const auto [left, right] = from.x < to.x ? std::pair(from, to) : std::pair(to, from);
  const int last = cell_of(right.x, least_.x, columns_);
  for (int column = cell_of(left.x, least_.x, columns_); column <= last; ++column) {
    // The part of the line over this column, a little more.
    const double begin = std::max(left.x, least_.x + (column - 0.001) * side_);
    const double end = std::min(right.x, least_.x + (column + 1.001) * side_);
    const double slope = right.x > left.x ? (right.y - left.y) / (right.x - left.x) : 0;
    const bool steep = !(right.x > left.x) || !std::isfinite(slope);
    const double y0 = steep ? left.y : left.y + (begin - left.x) * slope;
    const double y1 = steep ? right.y : left.y + (end - left.x) * slope;
    const double slack = 0.001 * side_;
    const int top = cell_of(std::max(y0, y1) + slack, least_.y, rows_);
    for (int row = cell_of(std::min(y0, y1) - slack, least_.y, rows_); row <= top; ++row)
      visit(row * columns_ + column);
  }
}

bool Crossings::has_outline_at(const Vec2& point) const {
  bool found = false;
  visit_cells(point, point, [&](int cell) {
    for (int i = first_[cell]; i < first_[cell + 1] && !found; ++i) {
      const Line& line = lines_[lines_of_cells_[i]];
      const Chain& chain = chains_[line.chain];
      found = chain.visible && !is_within_surface(chain.kind) && distance(point, line.from, line.to) < touching;
    }
  });
  return found;
}

std::vector<double> Crossings::along(std::size_t chain, double apart) const {
  std::vector<double> found;
  double travelled = 0;
  visit_lines(chains_[chain], [&](const Vec2& from, const Vec2& to) {
    visit_cells(from, to, [&](int cell) {
      for (int i = first_[cell]; i < first_[cell + 1]; ++i) {
        const Line& line = lines_[lines_of_cells_[i]];
        if (line.chain == chain || is_within_surface(chains_[line.chain].kind)) continue;
        if (const auto at = meeting(from, to, line.from, line.to)) found.push_back(travelled + *at);
      }
    });
    travelled += glm::distance(from, to);
  });
  std::sort(found.begin(), found.end());
  double last = -HUGE_VAL;
  std::erase_if(found, [&](double at) {
    if (at - last < apart) return true;
    last = at;
    return false;
  });
  return found;
}

}  // namespace epura
