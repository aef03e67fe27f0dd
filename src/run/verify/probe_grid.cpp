// SPDX-License-Identifier: Apache-2.0
#include "verify/probe_grid.hpp"

#include <algorithm>
#include <cmath>

#include "verify/polygon.hpp"

namespace epura::verify {

namespace {

constexpr Vec2 everywhere(HUGE_VAL);

// Rounding of the few operations that follow, in addition to the error of the coordinates.
constexpr double rounding = 64 * 0x1p-53;

double largest_error_of(const Triple<Bounded>& p) {
  return p.x.error + p.y.error + p.z.error +
         rounding * std::max({std::abs(p.x.value), std::abs(p.y.value), std::abs(p.z.value)});
}

Triple<double> values(const Triple<Bounded>& p) { return {p.x.value, p.y.value, p.z.value}; }

}  // namespace

void PageFrame::add(Extent& extent, const Triple<double>& local, double error) const {
  const double k = sight_.inverse_distance.value;
  const double foreshortening = 1 - k * local.z;
  const double moved = (error + sight_.inverse_distance.error * local.z * local.z) / foreshortening;
  const Vec2 place = sight_.page / foreshortening * Vec2(local.x, local.y);
  const double depth = sight_.depth * local.z / foreshortening;
  const double page_error = 2 * moved * (sight_.page + k * (std::abs(place.x) + std::abs(place.y))) + margin_;
  const double depth_error = 2 * moved * (sight_.depth + k * std::abs(depth));
  if (!(foreshortening > 0) || !std::isfinite(page_error) || !std::isfinite(depth_error)) {
    extent = {-everywhere, everywhere, -HUGE_VAL, HUGE_VAL};
    return;
  }
  extent.min = glm::min(extent.min, place - page_error);
  extent.max = glm::max(extent.max, place + page_error);
  extent.back = std::min(extent.back, depth - depth_error);
  extent.front = std::max(extent.front, depth + depth_error);
}

Extent PageFrame::extent_of(const Triple<Bounded>& point) const {
  Extent extent;
  const Triple<Bounded> local = sight_.local(point);
  add(extent, values(local), largest_error_of(local));
  return extent;
}

std::optional<Extent> PageFrame::extent_of(const std::array<Vec3, 3>& corners) const {
  Polygon<double> polygon;
  double error = 0;
  for (const Vec3& corner : corners) {
    const Triple<Bounded> local = sight_.local(corner);
    polygon.add(values(local));
    error += largest_error_of(local);
  }
  if (sight_.eye) polygon = clip(polygon, [&](const Triple<double>& p) { return sight_.eye->value - p.z; });
  if (polygon.count == 0) return std::nullopt;
  Extent extent;
  for (std::size_t i = 0; i < polygon.count; ++i) add(extent, polygon.corner[i], error);
  return extent;
}

Vec2 PageFrame::to_page(const Triple<Bounded>& point) const {
  const Triple<double> local = values(sight_.local(point));
  return sight_.page / (1 - sight_.inverse_distance.value * local.z) * Vec2(local.x, local.y);
}

ProbeGrid::ProbeGrid(std::vector<Extent> probes) : probes_(std::move(probes)) {
  for (const Extent& probe : probes_) {
    box_ = {glm::min(box_.min, probe.min), glm::max(box_.max, probe.max), std::min(box_.back, probe.back),
            std::max(box_.front, probe.front)};
    reach_ = std::max({reach_, probe.max.x - probe.min.x, probe.max.y - probe.min.y});
  }
  side_ = std::isfinite(reach_) ? std::clamp(static_cast<int>(std::sqrt(probes_.size())), 1, 1024) : 1;
  std::vector<int> cell(probes_.size());
  first_.assign(static_cast<std::size_t>(side_) * side_ + 1, 0);
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const auto [x, y] = cell_of(0.5 * probes_[i].min + 0.5 * probes_[i].max);
    cell[i] = y * side_ + x;
    ++first_[cell[i] + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  order_.resize(probes_.size());
  std::vector<int> next = first_;
  for (std::size_t i = 0; i < probes_.size(); ++i) order_[next[cell[i]]++] = static_cast<int>(i);
}

std::array<int, 2> ProbeGrid::cell_of(const Vec2& place) const {
  if (side_ == 1) return {0, 0};
  const Vec2 part = (place - box_.min) / (box_.max - box_.min) * static_cast<double>(side_);
  const auto cell = [&](double p) { return p > 0 ? static_cast<int>(std::min(p, side_ - 1.0)) : 0; };
  return {cell(part.x), cell(part.y)};
}

}  // namespace epura::verify
