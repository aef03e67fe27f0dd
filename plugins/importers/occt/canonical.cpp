// SPDX-License-Identifier: Apache-2.0
#include "canonical.hpp"

#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Ax3.hxx>
#include <optional>
#include <vector>

#include "large_numbers.hpp"

namespace occt {

namespace {

constexpr int count = 9;  // of samples along each of u and v
constexpr int middle = count / 2;
constexpr double relative_precision = 1e-7;  // of the size of the face: precision of coordinates in text files

using Points = std::array<gp_XYZ, count>;

double distance_from_axis(const gp_Ax3& axis, const gp_XYZ& point) {
  return (point - axis.Location().XYZ()).Crossed(axis.Direction().XYZ()).Modulus();
}

double along(const gp_Ax3& axis, const gp_XYZ& point) {
  return (point - axis.Location().XYZ()).Dot(axis.Direction().XYZ());
}

/// Not from end to end, since a closed line would begin and end in one point, and not in equal steps, which could
/// coincide with the turns of a thread.
constexpr std::array<double, count> places{0.031, 0.153, 0.271, 0.402, 0.5, 0.634, 0.741, 0.859, 0.967};

/// Parameters in each of the surface's spans in this direction.
std::vector<double> parameters(const Geom_Surface& surface, bool is_along_u, double first, double last) {
  std::vector<double> bounds{first};
  if (const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(&surface)) {
    const TColStd_Array1OfReal& knots = is_along_u ? spline->UKnots() : spline->VKnots();
    for (const double knot : knots)
      if (first < knot && knot < last) bounds.push_back(knot);
  }
  bounds.push_back(last);
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
    for (const double place : {0.11, 0.37, 0.59, 0.83})
      found.push_back(bounds[i] + place * (bounds[i + 1] - bounds[i]));
  return found;
}

class Samples {
 public:
  Samples(const Geom_Surface& surface, const Range& range) : surface_(surface), range_(range) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const double u = range[0] + (range[1] - range[0]) * places[i];
        const double v = range[2] + (range[3] - range[2]) * places[j];
        points_[i][j] = surface.Value(u, v).XYZ();
      }
    }
    gp_XYZ least = points_[0][0], most = least;
    for (const Points& row : points_) {
      for (const gp_XYZ& point : row) {
        for (int axis = 1; axis <= 3; ++axis) {
          least.SetCoord(axis, std::min(least.Coord(axis), point.Coord(axis)));
          most.SetCoord(axis, std::max(most.Coord(axis), point.Coord(axis)));
        }
      }
    }
    precision_ = relative_precision * (most - least).Modulus();
  }

  /// Along u at the j-th value of v, or vice versa.
  [[nodiscard]] Points line(bool is_along_u, int j) const {
    if (!is_along_u) return points_[j];
    Points line;
    for (int i = 0; i < count; ++i) line[i] = points_[i][j];
    return line;
  }

  [[nodiscard]] bool all(const std::function<double(const gp_XYZ&)>& distance) const {
    for (const Points& row : points_)
      for (const gp_XYZ& point : row)
        if (!(std::abs(distance(point)) <= precision_)) return false;
    const std::vector<double> along_v = parameters(surface_, false, range_[2], range_[3]);
    for (const double u : parameters(surface_, true, range_[0], range_[1]))
      for (const double v : along_v)
        if (!(std::abs(distance(surface_.Value(u, v).XYZ())) <= precision_)) return false;
    return true;
  }

  [[nodiscard]] double precision() const { return precision_; }

 private:
  const Geom_Surface& surface_;
  Range range_;
  std::array<Points, count> points_;
  double precision_ = 0;
};

/// Position: centre and direction of its axis.
struct Circle {
  gp_Ax3 position;
  double radius;
};

std::optional<Circle> circle_through(const Points& line, double precision) {
  const gp_XYZ a = line[middle] - line[0], b = line[count - 1] - line[0];
  const gp_XYZ normal = a.Crossed(b);
  if (!(normal.Modulus() > 1e-6 * (a.SquareModulus() + b.SquareModulus()))) return std::nullopt;
  const gp_XYZ to_centre =
      (normal.Crossed(a) * b.SquareModulus() + b.Crossed(normal) * a.SquareModulus()) / (2 * normal.SquareModulus());
  const Circle circle{gp_Ax3(gp_Pnt(line[0] + to_centre), gp_Dir(normal)), to_centre.Modulus()};
  for (const gp_XYZ& point : line) {
    const gp_XYZ off = point - circle.position.Location().XYZ();
    if (std::abs(off.Modulus() - circle.radius) > precision || std::abs(along(circle.position, point)) > precision)
      return std::nullopt;
  }
  return circle;
}

bool is_straight(const Points& line, double precision) {
  const gp_XYZ run = line[count - 1] - line[0];
  const double length = run.Modulus();
  if (!(length > precision)) return false;
  return std::all_of(line.begin(), line.end(), [&](const gp_XYZ& point) {
    return (point - line[0]).Crossed(run).Modulus() <= precision * length;
  });
}

Handle(Geom_Surface) plane(const Samples& samples) {
  const Points one = samples.line(true, middle), other = samples.line(false, middle);
  const gp_XYZ normal = (one[count - 1] - one[0]).Crossed(other[count - 1] - other[0]);
  if (!(normal.Modulus() > 0)) return {};
  const gp_Ax3 position{gp_Pnt(one[middle]), gp_Dir(normal)};
  if (!samples.all([&](const gp_XYZ& point) { return along(position, point); })) return {};
  return new Geom_Plane(position);
}

/// Circles along one parameter, straight lines along the other.
Handle(Geom_Surface) cylinder_or_cone(const Samples& samples, bool is_round_along_u) {
  if (!is_straight(samples.line(!is_round_along_u, middle), samples.precision())) return {};
  const auto first = circle_through(samples.line(is_round_along_u, 0), samples.precision());
  const auto last = circle_through(samples.line(is_round_along_u, count - 1), samples.precision());
  if (!first || !last) return {};
  const gp_XYZ run = last->position.Location().XYZ() - first->position.Location().XYZ();
  if (!(run.Modulus() > 100 * samples.precision())) return {};
  const gp_Ax3 position(first->position.Location(), gp_Dir(run));
  const double slope = (last->radius - first->radius) / run.Modulus();
  const double slant = std::sqrt(1 + slope * slope);
  const auto off = [&](const gp_XYZ& point) {
    return (distance_from_axis(position, point) - first->radius - slope * along(position, point)) / slant;
  };
  if (!samples.all(off)) return {};
  if (std::abs(last->radius - first->radius) <= samples.precision())
    return new Geom_CylindricalSurface(position, (first->radius + last->radius) / 2);
  return new Geom_ConicalSurface(position, std::atan(slope), first->radius);
}

/// The centre is where the axes of two circles meet.
Handle(Geom_Surface) sphere(const Samples& samples, const Circle& one, const Circle& other) {
  const gp_XYZ a = one.position.Direction().XYZ(), b = other.position.Direction().XYZ();
  const gp_XYZ across = a.Crossed(b);
  if (!(across.SquareModulus() > 1e-6)) return {};
  const gp_XYZ run = other.position.Location().XYZ() - one.position.Location().XYZ();
  const double step = run.Crossed(b).Dot(across) / across.SquareModulus();
  const gp_XYZ centre = one.position.Location().XYZ() + a * step;
  const double radius = std::hypot(one.radius, step);
  if (!samples.all([&](const gp_XYZ& point) { return (point - centre).Modulus() - radius; })) return {};
  return new Geom_SphericalSurface(gp_Ax3(gp_Pnt(centre), one.position.Direction()), radius);
}

Handle(Geom_Surface) torus(const Samples& samples, const Circle& round, const Circle& tube) {
  const double height = along(round.position, tube.position.Location().XYZ());
  const gp_Pnt centre(round.position.Location().XYZ() + height * round.position.Direction().XYZ());
  const gp_Ax3 position(centre, round.position.Direction());
  const double major = distance_from_axis(position, tube.position.Location().XYZ());
  const auto off = [&](const gp_XYZ& point) {
    return std::hypot(distance_from_axis(position, point) - major, along(position, point)) - tube.radius;
  };
  if (!(major > samples.precision()) || !samples.all(off)) return {};
  return new Geom_ToroidalSurface(position, major, tube.radius);
}

}  // namespace

Handle(Geom_Surface) canonical(const Geom_Surface& surface, const Range& range) {
  if (std::any_of(range.begin(), range.end(), [](double bound) { return !(std::abs(bound) < largest_number); }))
    return {};
  const Samples samples(surface, range);
  if (!(samples.precision() > 0)) return {};
  Handle(Geom_Surface) found = plane(samples);
  for (const bool is_round_along_u : {true, false})
    if (found.IsNull()) found = cylinder_or_cone(samples, is_round_along_u);
  if (!found.IsNull()) return found;
  const auto along_u = circle_through(samples.line(true, middle / 2), samples.precision());
  const auto along_v = circle_through(samples.line(false, middle / 2), samples.precision());
  if (!along_u || !along_v) return {};
  found = sphere(samples, *along_u, *along_v);
  if (found.IsNull()) found = torus(samples, *along_u, *along_v);
  if (found.IsNull()) found = torus(samples, *along_v, *along_u);
  return found;
}

}  // namespace occt
