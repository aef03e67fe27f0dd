// SPDX-License-Identifier: Apache-2.0
#include "mesh/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace epura::mesh {

namespace {

constexpr std::size_t max_on_lattice = 4096;   // which are looked at
constexpr double fewest_lattice_steps = 1000;  // across the points: coarser lattices are those of voxels and designers
constexpr int max_divisors = 4096;             // of the shortest distance: steps between the nearest coordinates
// However exactly a distance is known: it may be a multiple by design.
constexpr double max_bits_of_one = 3;
constexpr double min_lattice_bits = 24;  // the binary logarithm of how unlikely chance is

/// A distance between two coordinates of an axis, a whole number of steps.
struct Distance {
  double length;
  bool is_new;  ///< between neighbours, and no other two neighbours have it: it does not follow from other distances

  bool operator<(const Distance& other) const { return length < other.length; }
};

// Some points, evenly distributed.
std::vector<double> coordinates_along(const Points& points, std::size_t axis) {
  std::vector<double> coordinates;
  const std::size_t stride = points.size() / max_on_lattice + 1;
  for (std::size_t i = 0; i < points.size(); i += stride)
    if (std::isfinite(points[i][axis])) coordinates.push_back(points[i][axis]);
  std::sort(coordinates.begin(), coordinates.end());
  return coordinates;
}

// Those between neighbours, and those from the first one of each axis; ascending.
std::vector<Distance> distances_in(const Points& points, double least) {
  std::vector<Distance> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double> coordinates = coordinates_along(points, axis);
    for (std::size_t i = 1; i < coordinates.size(); ++i) {
      if (const double d = coordinates[i] - coordinates[i - 1]; d > least) found.push_back({d, true});
      if (const double d = coordinates[i] - coordinates.front(); d > least) found.push_back({d, false});
    }
  }
  std::sort(found.begin(), found.end());
  double last = 0;
  for (Distance& distance : found)
    if (distance.is_new) distance.is_new = distance.length - std::exchange(last, distance.length) > least;
  return found;
}

/// Counts steps in ever longer distances, each of which tells the step more exactly.
class Counting {
 public:
  Counting(double step, double counted, double doubt) : step_(step), counted_(counted), doubt_(doubt) {}

  /// False if the distance is no whole number of steps, or it cannot be told.
  bool add(const Distance& distance) {
    constexpr double max_of_step = 0.25;
    const double count = std::nearbyint(distance.length / step_);
    const double allowed = doubt_ * (1 + count / counted_);
    if (allowed > max_of_step * step_ || std::abs(distance.length - count * step_) > allowed) return false;
    if (distance.is_new) bits_ += std::min(max_bits_of_one, std::log2(step_ / (2 * allowed)));
    if (count > counted_) {
      step_ = distance.length / count;
      counted_ = count;
    }
    return true;
  }

  [[nodiscard]] double bits() const { return bits_; }
  [[nodiscard]] double counted() const { return counted_; }
  [[nodiscard]] LatticeStep step() const { return {step_, doubt_ / counted_}; }

 private:
  double step_, counted_, doubt_, bits_ = 0;
};

// Nothing if they lie on no such lattice, or as well by chance.
std::optional<Counting> counted_in(const std::vector<Distance>& distances, int divisor, double doubt) {
  Counting counting(distances.front().length / divisor, divisor, doubt);
  for (std::size_t i = 1; i < distances.size(); ++i)
    if (!counting.add(distances[i])) return std::nullopt;
  if (counting.bits() - std::log2(divisor) < min_lattice_bits) return std::nullopt;
  return counting;
}

}  // namespace

LatticeStep lattice_of(const Points& points, double noise) {
  const double doubt = 2 * noise;
  const std::vector<Distance> distances = distances_in(points, 2 * doubt);
  const auto news = std::count_if(distances.begin(), distances.end(), [](const Distance& d) { return d.is_new; });
  if (max_bits_of_one * static_cast<double>(news) < min_lattice_bits) return {};  // too few to prove anything
  for (int divisor = 1; divisor <= max_divisors; ++divisor) {
    if (distances.front().length < 4 * doubt * divisor) break;
    // What lies on a coarse lattice lies on all of its divisions, too, which tell nothing.
    if (const auto counting = counted_in(distances, divisor, doubt))
      return counting->counted() >= fewest_lattice_steps ? counting->step() : LatticeStep{};
  }
  return {};
}

}  // namespace epura::mesh
