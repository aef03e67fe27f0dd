// SPDX-License-Identifier: Apache-2.0
#include "sizes/general_notes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_lengths.hpp"

namespace epura::sheet {

namespace {

bool are_equal(double radius, double other, const HoleWalls& walls) {
  return std::abs(radius - other) <= walls.slack() + definition::same_size * other;
}

// Whether it goes on along a border without a corner.
bool is_tangent(const NotedRound& one, const world::World& world) {
  return std::ranges::any_of(world.models[static_cast<std::size_t>(one.model)].part->borders,
                             [&](const surfaces::PartBorder& border) {
                               return border.kind == surfaces::BorderKind::tangent &&
                                      (border.faces[0] == one.face) != (border.faces[1] == one.face);
                             });
}

void judge_fillets(Verdict& verdict, const NotedElement& size, const std::vector<GivenSize>& given,
                   const HoleWalls& walls, const world::World& world, const Notation& notation) {
  bool any = false;
  for (const NotedRound& one : walls.rounds()) {
    const double radius = one.circle.radius;
    if (!one.is_fillet() || !is_tangent(one, world)) continue;
    const bool is_given = std::ranges::any_of(
        given, [&](const GivenSize& other) { return are_equal(other.circle.radius, radius, walls); });
    const bool is_it = size.allows(radius, walls.slack() + definition::same_size * radius);
    any = any || is_it;
    if (!is_it && !is_given) return verdict.deny("a fillet of R" + number_text(radius, notation));
  }
  if (!any) verdict.deny("no fillet of R" + number_text(size.least, notation));
}

// Which other texts may mean a hole: those of its size.
bool is_given(const HoleChain& chain, const std::vector<GivenSize>& given, const HoleWalls& walls, bool with_depth) {
  const double radius = chain.walls[chain.own].widest();
  return std::ranges::any_of(given, [&](const GivenSize& one) {
    const bool has_depth = std::ranges::any_of(one.text.elements, [](const NotedElement& element) {
      return element.role == NotedRole::depth || element.role == NotedRole::blind;
    });
    return are_equal(one.circle.radius, radius, walls) && (has_depth || !with_depth);
  });
}

void judge_holes(Verdict& verdict, const NotedText& note, const std::vector<GivenSize>& given, const HoleWalls& walls,
                 const Notation& notation) {
  const auto elements = note.all_understood();
  const bool is_through =
      std::ranges::any_of(elements, [](const NotedElement& one) { return one.role == NotedRole::through; });
  const NotedElement* size = note.size();
  if (size != nullptr && size->sign == NotedSign::none) size = nullptr;  // "18 deep"
  bool any = false;
  for (const NotedRound& one : walls.rounds()) {
    const auto chain = one.inwards && !one.is_fillet() ? walls.chain_at(one.circle) : std::nullopt;
    if (!chain || chain->walls[chain->own].is_cone()) continue;
    const std::string name = "⌀" + number_text(2 * one.circle.radius, notation);
    const bool is_size = size == nullptr || size->allows(2 * one.circle.radius, 2 * walls.slack());
    any = any || is_size;
    if (!is_size && note.is_of_all && !is_given(*chain, given, walls, false)) verdict.deny("a hole of " + name);
    const bool is_blind = chain->ends_at(chain->own, 0) || chain->ends_at(chain->own, 1);
    if (is_size && note.count == 1 && is_through && is_blind && !is_given(*chain, given, walls, true))
      verdict.deny("a blind hole of " + name);
  }
  if (!any) verdict.deny("no such hole");
}

}  // namespace

void judge_of_kind(Verdict& verdict, const NotedText& note, const std::vector<GivenSize>& given, const HoleWalls& walls,
                   const world::World& world, const Notation& notation) {
  const NotedElement* size = note.size();
  check(note.kind != NotedKind::none, "a note speaks of something");
  if (note.kind == NotedKind::holes) return judge_holes(verdict, note, given, walls, notation);
  if (size == nullptr) return verdict.doubt("a text without a size");
  if (note.kind == NotedKind::fillets) return judge_fillets(verdict, *size, given, walls, world, notation);
  const EqualLengths equal(walls.parts(), world, walls.slack());
  if (equal.slopes(size->least) == 0) verdict.deny("no chamfer of " + number_text(size->least, notation));
}

}  // namespace epura::sheet
