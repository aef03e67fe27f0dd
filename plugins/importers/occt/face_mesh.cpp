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

constexpr int most_rounds = 40;
constexpr double worth_turning = 0.7;  // relative to its error: another diagonal must be clearly better
// Cosine of the angle between a triangle and its surface below which it is examined, and the least gain of a flip.
constexpr double askew = 0.9, least_gain = 0.01;

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

class Refinement {
 public:
  Refinement(FaceMesh& mesh, const TopoDS_Face& face, double tolerance)
      : mesh_(mesh), surface_(face, /*Restriction=*/false), tolerance_(tolerance) {
    for (const gp_Pnt2d& place : mesh.places) register_place(place.XY());
  }

  void run(std::size_t growth) {
    const std::size_t most = growth * (mesh_.triangles.size() + 10);
    is_new_.assign(mesh_.triangles.size(), true);
    for (int round = 0; round < most_rounds && mesh_.triangles.size() < most; ++round) {
      mesh_.error = 0;
      if (!improve()) break;
    }
    for (int round = 0; round < most_rounds && straighten(); ++round) {
    }
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
    gp_XY place = mesh_.places[corner].XY();
    if (poles_[corner] == Pole::along_u) place.SetX(other.X());
    if (poles_[corner] == Pole::along_v) place.SetY(other.Y());
    return place;
  }

  /// The distance of the point from the surface near these parameters.
  [[nodiscard]] double distance(const gp_XYZ& point, const gp_XY& place) const {
    gp_Pnt on_surface;
    gp_Vec along_u, along_v;
    surface_.D1(place.X(), place.Y(), on_surface, along_u, along_v);
    const gp_Vec across = along_u.Crossed(along_v);
    const gp_Vec off(on_surface, gp_Pnt(point));
    const double size = across.Magnitude();
    return size > 0 ? std::abs(off.Dot(across)) / size : off.Magnitude();
  }

  [[nodiscard]] gp_XY middle_place(int a, int b) const {
    return (place_from(a, mesh_.places[b].XY()) + place_from(b, mesh_.places[a].XY())) / 2;
  }

  [[nodiscard]] double error_of_side(int a, int b) const {
    return distance((on_surface_[a] + on_surface_[b]) / 2, middle_place(a, b));
  }

  int centre(const Triangle& corners) {
    gp_XYZ point(0, 0, 0);
    gp_XY place(0, 0);
    for (int i = 0; i < 3; ++i) {
      point += on_surface_[corners[i]] / 3;
      place += place_from(corners[i], middle_place(corners[(i + 1) % 3], corners[(i + 2) % 3])) / 3;
    }
    const double error = distance(point, place);
    if (error <= tolerance_) return -1;
    mesh_.error = std::max(mesh_.error, error);
    return add(place);
  }

  int add(const gp_XY& place) {
    mesh_.points.push_back(surface_.Value(place.X(), place.Y()));
    mesh_.places.emplace_back(place);
    register_place(place);
    return static_cast<int>(mesh_.points.size() - 1);
  }

  [[nodiscard]] std::vector<Inner> inner_sides() const {
    std::vector<Half> halves;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Triangle& corners = mesh_.triangles[i];
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

  /// Sides that are too far from the surface, the worst first.
  [[nodiscard]] std::vector<Bad> bad_sides() const {
    std::vector<Bad> found;
    for (const Inner& side : inner_sides()) {
      // Sides of old triangles have passed before.
      if (!is_new_[side.one.triangle] && !is_new_[side.other.triangle]) continue;
      const double error = error_of_side(side.one.low, side.one.high);
      const double length = mesh_.points[side.one.low].Distance(mesh_.points[side.one.high]);
      if (error > tolerance_ && length > tolerance_) found.push_back({side, error});
    }
    std::stable_sort(found.begin(), found.end(), [](const Bad& a, const Bad& b) { return a.error > b.error; });
    return found;
  }

  /// Flips or halves the bad sides. Returns whether there were any.
  bool improve() {
    const std::vector<Bad> bad = bad_sides();
    if (!bad.empty()) mesh_.error = bad.front().error;
    std::vector<Triangle> middles(mesh_.triangles.size(), Triangle{-1, -1, -1});
    std::vector<bool> is_turned(mesh_.triangles.size(), false);
    for (const Bad& side : bad) {
      if (is_turned[side.one.triangle] || is_turned[side.other.triangle]) continue;
      const Triangle none{-1, -1, -1};
      if (middles[side.one.triangle] == none && middles[side.other.triangle] == none && turn(side)) {
        is_turned[side.one.triangle] = true;
        is_turned[side.other.triangle] = true;
        continue;
      }
      const int point = add(middle_place(side.one.low, side.one.high));
      middles[side.one.triangle][side.one.side] = point;
      middles[side.other.triangle][side.other.side] = point;
    }
    return divide_all(middles, is_turned) || !bad.empty();
  }

  [[nodiscard]] double area(int a, int b, int c) const {
    const gp_XY& corner = mesh_.places[a].XY();
    return (mesh_.places[b].XY() - corner).Crossed(mesh_.places[c].XY() - corner);
  }

  /// The two triangles of the other diagonal; nothing if it does not lie inside both.
  [[nodiscard]] std::optional<std::array<Triangle, 2>> turned(const Inner& side) const {
    const Triangle& one = mesh_.triangles[side.one.triangle];
    const Triangle& other = mesh_.triangles[side.other.triangle];
    const int a = one[side.one.side], b = one[(side.one.side + 1) % 3];
    const int c = one[(side.one.side + 2) % 3], d = other[(side.other.side + 2) % 3];
    for (const int corner : {a, b, c, d})
      if (poles_[corner] != Pole::no) return std::nullopt;
    const double before = area(a, b, c), after_a = area(c, a, d), after_b = area(d, b, c);
    const double least = 1e-3 * std::abs(before);
    if (std::min(std::abs(after_a), std::abs(after_b)) < least) return std::nullopt;
    if ((after_a > 0) != (before > 0) || (after_b > 0) != (before > 0)) return std::nullopt;
    return std::array{Triangle{c, a, d}, Triangle{d, b, c}};
  }

  void take(const Inner& side, const std::array<Triangle, 2>& triangles) {
    mesh_.triangles[side.one.triangle] = triangles[0];
    mesh_.triangles[side.other.triangle] = triangles[1];
  }

  /// Takes the other diagonal if it is closer to the surface.
  bool turn(const Bad& side) {
    const auto other = turned(side);
    if (!other || error_of_side((*other)[0][0], (*other)[0][2]) > worth_turning * side.error) return false;
    take(side, *other);
    return true;
  }

  /// The cosine of the angle between a triangle and its surface at the corner with the greatest angle.
  [[nodiscard]] double facing(const Triangle& corners) const {
    const auto& [a, b, c] = corners;
    const gp_XYZ across =
        (mesh_.points[b].XYZ() - mesh_.points[a].XYZ()).Crossed(mesh_.points[c].XYZ() - mesh_.points[a].XYZ());
    const double size = across.Modulus();
    if (size == 0) return 1;
    const double turn = area(a, b, c) < 0 ? -1 : 1;
    double least = 1;
    for (const int corner : corners)
      if (poles_[corner] == Pole::no) least = std::min(least, turn * across.Dot(normals_[corner]) / size);
    return least;
  }

  /// Flips diagonals between triangles that are tilted against the surface, as slivers are however close they are to
  /// it: a facet that faces away would get its own outline. Returns whether there were any.
  bool straighten() {
    struct Askew {
      double facing;
      Inner side;
    };
    std::vector<Askew> found;
    for (const Inner& side : inner_sides()) {
      const double least =
          std::min(facing(mesh_.triangles[side.one.triangle]), facing(mesh_.triangles[side.other.triangle]));
      if (least < askew) found.push_back({least, side});
    }
    std::stable_sort(found.begin(), found.end(), [](const Askew& a, const Askew& b) { return a.facing < b.facing; });
    std::vector<bool> is_turned(mesh_.triangles.size(), false);
    bool any = false;
    for (const auto& [least, side] : found) {
      if (is_turned[side.one.triangle] || is_turned[side.other.triangle]) continue;
      const auto other = turned(side);
      if (!other || std::min(facing((*other)[0]), facing((*other)[1])) < least + least_gain) continue;
      const double error = error_of_side((*other)[0][0], (*other)[0][2]);
      if (error > std::max(tolerance_, error_of_side(side.one.low, side.one.high))) continue;
      take(side, *other);
      is_turned[side.one.triangle] = is_turned[side.other.triangle] = any = true;
    }
    return any;
  }

  /// Returns whether a point was added inside a triangle.
  bool divide_all(const std::vector<Triangle>& middles, const std::vector<bool>& is_turned) {
    std::vector<Triangle> old;
    std::vector<bool> was_new;
    old.swap(mesh_.triangles);
    was_new.swap(is_new_);
    bool is_changed = false;
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (middles[i] != Triangle{-1, -1, -1}) {
        divide(old[i], middles[i]);
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
    mesh_.triangles.push_back(triangle);
    is_new_.push_back(is_new);
  }

  void divide(Triangle corners, Triangle points) {
    const auto count = 3 - std::count(points.begin(), points.end(), -1);
    if (count == 3) {
      for (int i = 0; i < 3; ++i) append({points[(i + 2) % 3], corners[i], points[i]}, true);
      append(points, true);
      return;
    }
    // Rotated so that the first side is halved and the third is not.
    while (points[0] < 0 || points[2] >= 0) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      std::rotate(points.begin(), points.begin() + 1, points.end());
    }
    if (count == 1) {
      append({corners[0], points[0], corners[2]}, true);
      append({points[0], corners[1], corners[2]}, true);
      return;
    }
    append({points[0], corners[1], points[1]}, true);
    const auto length = [this](int a, int b) { return mesh_.points[a].SquareDistance(mesh_.points[b]); };
    if (length(corners[0], points[1]) < length(points[0], corners[2])) {
      append({corners[0], points[0], points[1]}, true);
      append({corners[0], points[1], corners[2]}, true);
    } else {
      append({corners[0], points[0], corners[2]}, true);
      append({points[0], points[1], corners[2]}, true);
    }
  }

  FaceMesh& mesh_;
  BRepAdaptor_Surface surface_;
  double tolerance_;
  /// The points without the gap that files leave between edges and faces, which refinement cannot close.
  std::vector<gp_XYZ> on_surface_;
  std::vector<gp_XYZ> normals_;  // of the surface at the points, along_u x along_v; zero if there is none
  std::vector<Pole> poles_;
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
  Refinement(mesh, face, tolerance).run(growth);
  return mesh;
}

}  // namespace occt
