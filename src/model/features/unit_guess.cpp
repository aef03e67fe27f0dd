// SPDX-License-Identifier: Apache-2.0
#include "features/unit_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "surfaces/limits.hpp"

namespace epura::features {

namespace {

/// The diameters that are round in a unit, and the sizes of parts that are drawn in it.
struct Guess {
  Unit unit;
  double step, beside;  ///< round diameters are whole steps, to within `beside`
  double least, most;
  double exact_below = 0, exact = 0;  ///< diameters below are round to within this: too many others are near them
};

// Drawings in inches round sixty-fourths to three decimals: 16 mm in metres are one of them, too. Earlier units have
// precedence, as their round diameters often are those of later ones, too: these must leave at most half as many that
// are not round.
constexpr std::array guesses{Guess{Unit::mm, 0.5, 5e-4, 2, 2e4},
                             Guess{Unit::in, 1.0 / 64, 6e-4, 0.1, 400, 1.0 / 16, 1e-5},
                             Guess{Unit::m, 0.0005, 5e-7, 0.005, 100}};

struct Diameter {
  double value, doubt;  ///< by which its vertices are beside its surface
};

// Of those that are known well enough to tell.
double share_of_round(const std::vector<Diameter>& diameters, const Guess& guess) {
  const auto off = [&](double d) { return d < guess.exact_below ? guess.exact : guess.beside; };
  int known = 0, round = 0;
  for (const auto& [d, doubt] : diameters) {
    if (doubt > off(d)) continue;
    const double steps = std::nearbyint(d / guess.step);
    ++known;
    if (steps >= 1 && std::abs(d - steps * guess.step) < off(d)) ++round;
  }
  return known == 0 ? 0 : static_cast<double>(round) / known;
}

}  // namespace

Box box_of(const mesh::Mesh& mesh) {
  Box box;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int v : mesh.triangle(t)) box.add(mesh.point(v));
  for (const mesh::MeshEdge& edge : mesh.edges)
    if (edge.count == 0)
      for (const int v : edge.vertex) box.add(mesh.point(v));
  return box;
}

std::optional<Unit> guess_unit(const Box& box, const surfaces::PartFaces& part) {
  if (part.faces.empty()) return std::nullopt;
  const Vec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z});
  std::vector<Diameter> diameters;
  for (const surfaces::PartFace& face : part.faces)
    if (face.surface.kind == surfaces::SurfaceKind::cylinder && face.sweep >= surfaces::whole_turn)
      diameters.push_back({2 * face.surface.radius, face.residual});
  std::optional<Unit> best;
  double best_share = 0.5;
  for (const Guess& guess : guesses) {
    const double share = share_of_round(diameters, guess);
    if (largest < guess.least || largest > guess.most || share <= best_share) continue;
    if (best && 1 - share > (1 - best_share) / 2) continue;
    best = guess.unit;
    best_share = share;
  }
  if (best) return best;
  return largest >= 5 && largest <= 2e4 ? std::optional(Unit::mm) : std::nullopt;
}

}  // namespace epura::features
