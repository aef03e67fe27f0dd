// SPDX-License-Identifier: Apache-2.0
#include "face_mesh.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace occt {

namespace {

constexpr int max_rounds = 40;
constexpr double worth_turning = 0.7;  // relative to its error: another diagonal must be clearly better
// Cosine of the angle between a triangle and its surface below which it is examined, and the least gain of a flip.
constexpr double askew = 0.9, min_gain = 0.01;

using Triangle = std::array<int, 3>;

/// A side of triangles, found from either of them.
struct Half {
  int low, high;
  int triangle, side;
};

/// A side between two triangles.
struct Inner {
  Half one, other;
};

/// A side that is too far from the surface.
struct Bad : Inner {
  double error;
};

/// The points of a mesh on the surface of a face.
class SurfacePoints {
 public:
  SurfacePoints(const TopoDS_Face& face, std::vector<gp_Pnt> points, std::vector<gp_Pnt2d> places)
      : surface_(face, /*Restriction=*/false), points_(std::move(points)), places_(std::move(places)) {
    for (const gp_Pnt2d& place : places_) register_place(place.XY());
  }

  [[nodiscard]] const std::vector<gp_Pnt>& points() const { return points_; }
  [[nodiscard]] const std::vector<gp_Pnt2d>& places() const { return places_; }

  /// Returns its number.
  int add(const gp_XY& place) {
    points_.push_back(surface_.Value(place.X(), place.Y()));
    places_.emplace_back(place);
    register_place(place);
    return static_cast<int>(points_.size() - 1);
  }

  /// The distance of a point from the surface near these parameters.
  [[nodiscard]] double distance(const gp_XYZ& point, const gp_XY& place) const {
    gp_Pnt on_surface;
    gp_Vec along_u, along_v;
    surface_.D1(place.X(), place.Y(), on_surface, along_u, along_v);
    const gp_Vec across = along_u.Crossed(along_v);
    const gp_Vec off(on_surface, gp_Pnt(point));
    const double size = across.Magnitude();
    return size > 0 ? std::abs(off.Dot(across)) / size : off.Magnitude();
  }

  /// The parameters in the middle of a side.
  [[nodiscard]] gp_XY middle_place(int a, int b) const {
    return (place_from(a, places_[b].XY()) + place_from(b, places_[a].XY())) / 2;
  }

  /// The distance from the surface of the middle of a side.
  [[nodiscard]] double error_of_side(int a, int b) const {
    return distance((on_surface_[a] + on_surface_[b]) / 2, middle_place(a, b));
  }

  /// The parameters in the middle of a triangle.
  [[nodiscard]] gp_XY centre_of(const Triangle& corners) const {
    gp_XY place(0, 0);
    for (int i = 0; i < 3; ++i)
      place += place_from(corners[i], middle_place(corners[(i + 1) % 3], corners[(i + 2) % 3])) / 3;
    return place;
  }

  /// The distance from the surface of the middle of a triangle, given its parameters.
  [[nodiscard]] double error_of(const Triangle& corners, const gp_XY& centre) const {
    gp_XYZ point(0, 0, 0);
    for (const int corner : corners) point += on_surface_[corner] / 3;
    return distance(point, centre);
  }

  [[nodiscard]] bool is_pole(int corner) const { return poles_[corner] != Pole::no; }

  /// Twice the area of a triangle of parameters.
  [[nodiscard]] double area(int a, int b, int c) const {
    const gp_XY& corner = places_[a].XY();
    return (places_[b].XY() - corner).Crossed(places_[c].XY() - corner);
  }

  /// The cosine of the angle between a triangle and its surface at the corner with the greatest angle.
  [[nodiscard]] double facing(const Triangle& corners) const {
    const auto& [a, b, c] = corners;
    const gp_XYZ across = (points_[b].XYZ() - points_[a].XYZ()).Crossed(points_[c].XYZ() - points_[a].XYZ());
    const double size = across.Modulus();
    if (size == 0) return 1;
    const double turn = area(a, b, c) < 0 ? -1 : 1;
    double least = 1;
    for (const int corner : corners)
      if (poles_[corner] == Pole::no) least = std::min(least, turn * across.Dot(normals_[corner]) / size);
    return least;
  }

 private:
  /// At a pole, a parameter line collapses to a point: any parameter along it is as good as another.
  enum class Pole { no, along_u, along_v };

  void register_place(const gp_XY& place) {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_.D1(place.X(), place.Y(), point, along_u, along_v);
    on_surface_.push_back(point.XYZ());
    const double u = along_u.Magnitude(), v = along_v.Magnitude();
    const gp_Vec across = along_u.Crossed(along_v);
    normals_.push_back(across.Magnitude() > 0 ? across.Normalized().XYZ() : gp_XYZ(0, 0, 0));
    constexpr double nothing = 1e-9;
    poles_.push_back(u <= nothing * v ? Pole::along_u : v <= nothing * u ? Pole::along_v : Pole::no);
  }

  /// The parameters of a corner as seen from a point with other parameters.
  [[nodiscard]] gp_XY place_from(int corner, const gp_XY& other) const {
    gp_XY place = places_[corner].XY();
    if (poles_[corner] == Pole::along_u) place.SetX(other.X());
    if (poles_[corner] == Pole::along_v) place.SetY(other.Y());
    return place;
  }

  BRepAdaptor_Surface surface_;
  std::vector<gp_Pnt> points_;
  std::vector<gp_Pnt2d> places_;
  /// The points without the gap that files leave between edges and faces, which refinement cannot close.
  std::vector<gp_XYZ> on_surface_;
  std::vector<gp_XYZ> normals_;  // of the surface at the points, along_u x along_v; zero if there is none
  std::vector<Pole> poles_;
};

std::vector<Inner> inner_sides(const std::vector<Triangle>& triangles) {
  std::vector<Half> halves;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& corners = triangles[i];
    for (int side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(corners[side], corners[(side + 1) % 3]);
      halves.push_back({low, high, static_cast<int>(i), side});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return std::array{a.low, a.high, a.triangle, a.side} < std::array{b.low, b.high, b.triangle, b.side};
  });
  std::vector<Inner> sides;
  for (std::size_t i = 0; i + 1 < halves.size(); ++i)
    if (halves[i].low == halves[i + 1].low && halves[i].high == halves[i + 1].high) {
      sides.push_back({halves[i], halves[i + 1]});
      ++i;
    }
  return sides;
}

/// The two triangles of the other diagonal; nothing if it does not lie inside both.
std::optional<std::array<Triangle, 2>> turned(const SurfacePoints& on, const std::vector<Triangle>& triangles,
                                              const Inner& side) {
  const Triangle& one = triangles[side.one.triangle];
  const Triangle& other = triangles[side.other.triangle];
  const int a = one[side.one.side], b = one[(side.one.side + 1) % 3];
  const int c = one[(side.one.side + 2) % 3], d = other[(side.other.side + 2) % 3];
  for (const int corner : {a, b, c, d})
    if (on.is_pole(corner)) return std::nullopt;
  const double before = on.area(a, b, c), after_a = on.area(c, a, d), after_b = on.area(d, b, c);
  const double least = 1e-3 * std::abs(before);
  if (std::min(std::abs(after_a), std::abs(after_b)) < least) return std::nullopt;
  if ((after_a > 0) != (before > 0) || (after_b > 0) != (before > 0)) return std::nullopt;
  return std::array{Triangle{c, a, d}, Triangle{d, b, c}};
}

/// The pieces of a triangle of which some sides are halved; -1: those that are not.
std::vector<Triangle> divided(Triangle corners, Triangle middles, const std::vector<gp_Pnt>& points) {
  const auto count = 3 - std::count(middles.begin(), middles.end(), -1);
  if (count == 3)
    return {{middles[2], corners[0], middles[0]},
            {middles[0], corners[1], middles[1]},
            {middles[1], corners[2], middles[2]},
            middles};
  // Rotated so that the first side is halved and the third is not.
  while (middles[0] < 0 || middles[2] >= 0) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::rotate(middles.begin(), middles.begin() + 1, middles.end());
  }
  const auto& [a, b, c] = corners;
  const auto& [p, q, none] = middles;
  if (count == 1) return {{a, p, c}, {p, b, c}};
  if (points[a].SquareDistance(points[q]) < points[p].SquareDistance(points[c]))
    return {{p, b, q}, {a, p, q}, {a, q, c}};
  return {{p, b, q}, {a, p, c}, {p, q, c}};
}

/// Divides and flips triangles until they are close enough to the surface.
class Refinement {
 public:
  Refinement(SurfacePoints on, std::vector<Triangle> triangles, double tolerance)
      : on_(std::move(on)), triangles_(std::move(triangles)), tolerance_(tolerance), is_new_(triangles_.size(), true) {}

  FaceMesh run(std::size_t growth) {
    const std::size_t most = growth * (triangles_.size() + 10);
    for (int round = 0; round < max_rounds && triangles_.size() < most; ++round) {
      error_ = 0;
      if (!improve()) break;
    }
    for (int round = 0; round < max_rounds && straighten(); ++round) {
    }
    return {on_.points(), on_.places(), std::move(triangles_), error_};
  }

 private:
  /// Sides that are too far from the surface, the worst first.
  [[nodiscard]] std::vector<Bad> bad_sides() const {
    std::vector<Bad> found;
    for (const Inner& side : inner_sides(triangles_)) {
      // Sides of old triangles have passed before.
      if (!is_new_[side.one.triangle] && !is_new_[side.other.triangle]) continue;
      const double error = on_.error_of_side(side.one.low, side.one.high);
      const double length = on_.points()[side.one.low].Distance(on_.points()[side.one.high]);
      if (error > tolerance_ && length > tolerance_) found.push_back({side, error});
    }
    std::stable_sort(found.begin(), found.end(), [](const Bad& a, const Bad& b) { return a.error > b.error; });
    return found;
  }

  /// Flips or halves the bad sides. Returns whether there were any.
  bool improve() {
    const std::vector<Bad> bad = bad_sides();
    if (!bad.empty()) error_ = bad.front().error;
    std::vector<Triangle> middles(triangles_.size(), Triangle{-1, -1, -1});
    std::vector<bool> is_turned(triangles_.size(), false);
    for (const Bad& side : bad) {
      if (is_turned[side.one.triangle] || is_turned[side.other.triangle]) continue;
      const Triangle none{-1, -1, -1};
      if (middles[side.one.triangle] == none && middles[side.other.triangle] == none && turn(side)) {
        is_turned[side.one.triangle] = true;
        is_turned[side.other.triangle] = true;
        continue;
      }
      const int point = on_.add(on_.middle_place(side.one.low, side.one.high));
      middles[side.one.triangle][side.one.side] = point;
      middles[side.other.triangle][side.other.side] = point;
    }
    return divide_all(middles, is_turned) || !bad.empty();
  }

  void take(const Inner& side, const std::array<Triangle, 2>& triangles) {
    triangles_[side.one.triangle] = triangles[0];
    triangles_[side.other.triangle] = triangles[1];
  }

  /// Takes the other diagonal if it is closer to the surface.
  bool turn(const Bad& side) {
    const auto other = turned(on_, triangles_, side);
    if (!other || on_.error_of_side((*other)[0][0], (*other)[0][2]) > worth_turning * side.error) return false;
    take(side, *other);
    return true;
  }

  /// Flips diagonals between triangles that are tilted against the surface, as slivers are however close they are to
  /// it: a facet that faces away would get its own outline. Returns whether there were any.
  bool straighten() {
    struct Askew {
      double facing;
      Inner side;
    };
    std::vector<Askew> found;
    for (const Inner& side : inner_sides(triangles_)) {
      const double least =
          std::min(on_.facing(triangles_[side.one.triangle]), on_.facing(triangles_[side.other.triangle]));
      if (least < askew) found.push_back({least, side});
    }
    std::stable_sort(found.begin(), found.end(), [](const Askew& a, const Askew& b) { return a.facing < b.facing; });
    std::vector<bool> is_turned(triangles_.size(), false);
    bool any = false;
    for (const auto& [least, side] : found) {
      if (is_turned[side.one.triangle] || is_turned[side.other.triangle]) continue;
      const auto other = turned(on_, triangles_, side);
      if (!other || std::min(on_.facing((*other)[0]), on_.facing((*other)[1])) < least + min_gain) continue;
      const double error = on_.error_of_side((*other)[0][0], (*other)[0][2]);
      if (error > std::max(tolerance_, on_.error_of_side(side.one.low, side.one.high))) continue;
      take(side, *other);
      is_turned[side.one.triangle] = is_turned[side.other.triangle] = any = true;
    }
    return any;
  }

  /// Adds a point inside a triangle whose middle is too far from the surface; -1: none.
  int centre(const Triangle& corners) {
    const gp_XY place = on_.centre_of(corners);
    const double error = on_.error_of(corners, place);
    if (error <= tolerance_) return -1;
    error_ = std::max(error_, error);
    return on_.add(place);
  }

  /// Returns whether a point was added inside a triangle.
  bool divide_all(const std::vector<Triangle>& middles, const std::vector<bool>& is_turned) {
    std::vector<Triangle> old;
    std::vector<bool> was_new;
    old.swap(triangles_);
    was_new.swap(is_new_);
    bool is_changed = false;
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (middles[i] != Triangle{-1, -1, -1}) {
        for (const Triangle& piece : divided(old[i], middles[i], on_.points())) append(piece, true);
        continue;
      }
      const int inside = was_new[i] && !is_turned[i] ? centre(old[i]) : -1;
      if (inside < 0) {
        append(old[i], is_turned[i]);
        continue;
      }
      is_changed = true;
      for (int side = 0; side < 3; ++side) append({old[i][side], old[i][(side + 1) % 3], inside}, true);
    }
    return is_changed;
  }

  void append(const Triangle& triangle, bool is_new) {
    triangles_.push_back(triangle);
    is_new_.push_back(is_new);
  }

  SurfacePoints on_;
  std::vector<Triangle> triangles_;
  double tolerance_;
  double error_ = 0;
  std::vector<bool> is_new_;  // triangles of the last round
};

}  // namespace

FaceMesh refined(const TopoDS_Face& face, double tolerance, std::size_t growth) {
  FaceMesh mesh;
  TopLoc_Location location;
  const Handle(Poly_Triangulation) given = BRep_Tool::Triangulation(face, location);
  if (given.IsNull()) return mesh;
  for (int i = 1; i <= given->NbNodes(); ++i) {
    mesh.points.push_back(given->Node(i).Transformed(location.Transformation()));
    if (given->HasUVNodes()) mesh.places.push_back(given->UVNode(i));
  }
  for (int i = 1; i <= given->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    given->Triangle(i).Get(a, b, c);
    mesh.triangles.push_back({a - 1, b - 1, c - 1});
  }
  if (!given->HasUVNodes() || BRep_Tool::Surface(face, location).IsNull()) return mesh;
  if (BRepAdaptor_Surface(face, /*Restriction=*/false).GetType() == GeomAbs_Plane) return mesh;
  SurfacePoints points(face, std::move(mesh.points), std::move(mesh.places));
  return Refinement(std::move(points), std::move(mesh.triangles), tolerance).run(growth);
}

}  // namespace occt
