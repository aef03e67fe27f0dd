// SPDX-License-Identifier: Apache-2.0
#include "mesh/resolution.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

namespace {

/// The distance between neighbouring values of coordinates.
struct LatticeStep {
  double length = 0;  ///< 0: there is no lattice
  double doubt = 0;   ///< of the length
};

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

/// The widest lattice, the same along all axes, on which these points lie within `noise`, the error of a coordinate. It
/// is as little due to chance as a recognised surface, and has a thousand steps at least.
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

// With fewer decimals, coordinates are as likely to be chosen as rounded.
constexpr int fewest_decimals = 2;
constexpr int max_decimals = 12;
constexpr int fewest_digits = 5;
constexpr int max_digits = 8;
constexpr std::size_t points_at_once = 4096;
constexpr std::size_t max_points = 4096;  // whose numbers are looked at; all must be rounded
// A file that is rounded more coarsely, as a fraction of the size, has chosen coordinates, or nothing to be recognised.
constexpr double fewest_steps = 2000;
// Numbers that end in another digit than 0 or 5, which designers prefer. Where steps are small, fewer are enough, since
// less harm is done by chosen ones.
constexpr double many_steps = 0x1p14;
constexpr std::size_t least_telling = 4, least_telling_of_many = 2;
constexpr std::array<double, max_decimals + 1> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};

/// How exactly a file holds numbers.
struct Storage {
  double rounding;  ///< relative
  double largest;   ///< multiple of a step that can be told from other numbers
};
constexpr Storage doubles{0x1p-51, 0x1p48}, floats{0x1.01p-24, 0x1p21};

// Whether a coordinate is a multiple, but for the rounding of the largest one: what was moved has no less of it near 0.
bool is_multiple(double coordinate, int decimals, double largest, const Storage& storage) {
  const double scaled = std::abs(coordinate) * powers[decimals];
  return std::abs(scaled - std::nearbyint(scaled)) <= storage.rounding * largest * powers[decimals];
}

template <class Holds>
bool all_coordinates(const Points& points, const Holds& holds) {
  std::atomic<bool> all = true;
  parallel_for(points.size(), points_at_once, [&](std::size_t begin, std::size_t end) {
    const auto is_one = [&](const auto& p) { return std::all_of(p.begin(), p.end(), holds); };
    if (!std::all_of(points.begin() + begin, points.begin() + end, is_one)) all = false;
  });
  return all;
}

bool all_multiples(const Points& points, int decimals, double largest, const Storage& storage) {
  return largest * powers[decimals] < storage.largest &&
         all_coordinates(points, [&](double c) { return is_multiple(c, decimals, largest, storage); });
}

// The sizes of coordinates of some points, evenly distributed; each once, ascending.
std::vector<double> distinct_sizes(const Points& points) {
  std::vector<double> sizes;
  const std::size_t stride = points.size() / max_points + 1;
  for (std::size_t i = 0; i < points.size(); i += stride)
    for (const double c : points[i]) sizes.push_back(std::abs(c));
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

template <class Holds>
std::size_t count_in(const std::vector<double>& sizes, const Holds& holds) {
  return static_cast<std::size_t>(std::count_if(sizes.begin(), sizes.end(), holds));
}

// The double nearest to 10^exponent, which the powers and logarithms of the C library miss on some processors; 0 below
// the range of doubles.
double power_of_ten(int exponent) {
  constexpr int min = -323, max = 308;
  static const std::vector<double> all = [] {
    std::vector<double> powers_of_ten;
    for (int e = min; e <= max; ++e) powers_of_ten.push_back(*parse_number("1e" + std::to_string(e)));
    return powers_of_ten;
  }();
  if (exponent < min) return 0;
  return exponent > max ? HUGE_VAL : all[static_cast<std::size_t>(exponent - min)];
}

// The decimal exponent of the first digit.
int first_place(double coordinate) {
  constexpr double log10_of_2 = 0.30102999566398120;
  int place = static_cast<int>(std::floor(std::ilogb(coordinate) * log10_of_2));
  // The estimate is that of the next lower power of two.
  if (std::abs(coordinate) >= power_of_ten(place + 1)) ++place;
  return place;
}

bool has_digits(double coordinate, int digits) {
  if (coordinate == 0) return true;
  const double place = power_of_ten(first_place(coordinate) - digits + 1);
  const double scaled = coordinate / place;
  return std::abs(scaled - std::nearbyint(scaled)) <= 0x1p-48 * std::abs(scaled);
}

double decimals_of(const Points& points, const std::vector<double>& sizes, const Storage& storage) {
  int decimals = 0;
  while (decimals <= max_decimals && !all_multiples(points, decimals, sizes.back(), storage)) ++decimals;
  if (decimals < fewest_decimals || decimals > max_decimals) return 0;
  long long common = 0;
  std::size_t telling = 0, long_ones = 0;
  for (const double size : sizes) {
    const long long steps = std::llround(size * powers[decimals]);
    common = std::gcd(common, steps);
    telling += steps % 5 != 0 ? 1 : 0;
    long_ones += steps % 100 != 0 ? 1 : 0;
  }
  const double most = std::nearbyint(sizes.back() * powers[decimals]);
  const bool rounded = common == 1 && most >= fewest_steps && 4 * telling >= long_ones &&
                       telling >= (most >= many_steps ? least_telling_of_many : least_telling);
  return rounded ? 1 / powers[decimals] : 0;
}

// The place of the last digit of the largest coordinates, if all coordinates have the same number of digits: smaller
// ones then have more decimals, which the largest lack, and both need all digits.
double digits_of(const Points& points, const std::vector<double>& sizes) {
  const auto all_have = [&](int digits) {
    return all_coordinates(points, [&](double c) { return has_digits(c, digits); });
  };
  int digits = fewest_digits;
  while (digits <= max_digits && !all_have(digits)) ++digits;
  if (digits > max_digits) return 0;
  const auto needs_all = [&](double size) { return !has_digits(size, digits - 1); };
  const auto largest = std::find_if(sizes.rbegin(), sizes.rend(), needs_all);
  if (largest == sizes.rend()) return 0;
  const int place = first_place(*largest);
  const double last = power_of_ten(place - digits + 1);
  const auto is_finer = [&](double size) {
    return needs_all(size) && std::abs(size / last - std::nearbyint(size / last)) > 0x1p-10;
  };
  const auto is_telling = [&](double size) { return size >= power_of_ten(place) && needs_all(size); };
  const bool rounded =
      count_in(sizes, is_telling) >= least_telling && std::any_of(sizes.begin(), sizes.end(), is_finer);
  return rounded ? last : 0;
}

// A step of three digits, such as 0.05 or 25.4, or a binary fraction, in the unit of the file, or in another one before
// it was converted; or such a length in equal parts, since programs put vertices evenly on straight sides.
bool is_chosen(const LatticeStep& step) {
  constexpr int bits = 8;
  constexpr int most_parts = 24;
  constexpr double inch = 25.4, foot = 12;  // mm, inches
  // Millimetres in inches and feet, inches in feet, millimetres, centimetres and metres.
  constexpr std::array factors{1.0, inch, inch * foot, foot, 1 / inch, 10 / inch, 1000 / inch};
  const auto is_round = [&](double factor) {
    const double length = step.length * factor;
    const auto is_whole = [&](double unit) {
      const double count = length / unit;
      return std::abs(count - std::nearbyint(count)) <= step.doubt * factor / unit + 0x1p-40;
    };
    return is_whole(power_of_ten(first_place(length) - 2)) || is_whole(std::ldexp(1, std::ilogb(length) - bits));
  };
  std::array<double, most_parts> parts{};
  std::iota(parts.begin(), parts.end(), 1.0);
  return std::any_of(factors.begin(), factors.end(), is_round) || std::any_of(parts.begin(), parts.end(), is_round);
}

}  // namespace

double resolution_of(const Points& points, bool are_floats) {
  if (points.empty() || !all_coordinates(points, [](double c) { return std::isfinite(c); })) return 0;
  const std::vector<double> sizes = distinct_sizes(points);
  if (sizes.back() == 0) return 0;
  const Storage& storage = are_floats ? floats : doubles;
  const double digits = are_floats ? 0 : digits_of(points, sizes);
  const double written = digits > 0 ? digits : decimals_of(points, sizes, storage);
  const LatticeStep lattice = lattice_of(points, std::max(2 * storage.rounding * sizes.back(), written));
  return lattice.length > 2 * written && !is_chosen(lattice) ? lattice.length : written;
}

}  // namespace epura::mesh
