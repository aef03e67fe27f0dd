// SPDX-License-Identifier: Apache-2.0
#include "sizes/general_notes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "scene/threads.hpp"
#include "sizes/equal_lengths.hpp"
#include "sizes/stated_values.hpp"

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

void judge_fillets(Verdict& verdict, const NotedElement& size, const OtherTexts& given, const HoleWalls& walls,
                   const world::World& world, const Notation& notation) {
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

bool says(const NotedText& note, NotedRole role) {
  return std::ranges::any_of(note.all_understood(), [role](const NotedElement& one) { return one.role == role; });
}

/// What may be meant by notes of holes: the bore of a hole, or what has a thread.
struct Bore {
  WorldCircle circle;
  const scene::Thread* thread = nullptr;  // that is stated
  bool is_blind = false;

  [[nodiscard]] std::string name(const Notation& notation) const {
    return thread != nullptr ? thread->text : "⌀" + number_text(2 * circle.radius, notation);
  }
  // How far off the size is that a note says; nothing if that is another one.
  [[nodiscard]] std::optional<double> off(const NotedText& note, double slack) const {
    if (says(note, NotedRole::blind) && !is_blind) return std::nullopt;
    double off = 0;
    for (const NotedElement& one : note.all_understood()) {
      const bool is_thread = one.role == NotedRole::thread;
      if (!is_thread && (one.role != NotedRole::size || one.sign == NotedSign::none)) continue;
      const double own = is_thread && thread != nullptr ? thread->diameter : 2 * circle.radius;
      const double noted = (one.sign == NotedSign::radius ? 2 : 1) * one.least;
      const bool is_core = is_thread && thread == nullptr && own >= core_of_thread * noted && own <= noted;
      if (!is_core && !one.allows(one.sign == NotedSign::radius ? own / 2 : own, 2 * slack)) return std::nullopt;
      if (!is_core) off = std::max(off, std::abs(own - noted));
    }
    return off;
  }
};

std::vector<Bore> bores_of(const HoleWalls& walls) {
  std::vector<Bore> bores;
  for (const NotedRound& one : walls.rounds()) {
    const auto chain = one.inwards && !one.is_fillet() ? walls.chain_at(one.circle) : std::nullopt;
    if (chain && !chain->walls[chain->own].is_cone())
      bores.push_back({one.circle, nullptr, chain->ends_at(chain->own, 0) || chain->ends_at(chain->own, 1)});
  }
  return bores;
}

std::vector<Bore> threads_of(const HoleWalls& walls, const world::World& world) {
  std::vector<Bore> threads;
  for (std::size_t model = 0; model < world.models.size(); ++model)
    for (const scene::ThreadedFace& one : world.models[model].threads) {
      const surfaces::PartFace& face = walls.parts()[model]->faces[static_cast<std::size_t>(one.face)];
      const Vec3 middle = face.surface.origin + (face.from + face.to) / 2 * face.surface.axis;
      threads.push_back({{middle, face.surface.axis, face.surface.radius, {}, true}, &one.thread, true});
    }
  return threads;
}

// Which other texts may mean a hole: those of its size.
bool is_given(const Bore& bore, const OtherTexts& given, const HoleWalls& walls, bool with_depth) {
  return std::ranges::any_of(given, [&](const GivenSize& one) {
    const bool has_depth = std::ranges::any_of(one.text.elements, [](const NotedElement& element) {
      return element.role == NotedRole::depth || element.role == NotedRole::blind;
    });
    return are_equal(one.circle.radius, bore.circle.radius, walls) && (has_depth || !with_depth);
  });
}

// Each one that it means, which are those next to what it says, unless it speaks of some: then one of them. What other
// texts give may differ.
void judge_bores(Verdict& verdict, const NotedText& note, const OtherTexts& given, const std::vector<Bore>& bores,
                 const HoleWalls& walls, const Notation& notation) {
  std::optional<double> least;
  for (const Bore& one : bores)
    if (const auto off = one.off(note, walls.slack())) least = std::min(least.value_or(*off), *off);
  const bool is_of_each = note.is_of_all || (note.kind == NotedKind::holes && note.count == 1);
  const bool is_sized = note.gives_thread() || (note.size() != nullptr && note.size()->sign != NotedSign::none);
  bool any = false;
  Verdict other;
  for (const Bore& one : bores) {
    const auto off = one.off(note, walls.slack());
    if (!off || *off > *least + 2 * walls.slack()) {
      const bool is_other = note.is_of_all && is_sized && (note.gives_thread() == (one.thread != nullptr));
      if (is_other && !is_given(one, given, walls, false)) verdict.deny(one.name(notation) + ", too");
      continue;
    }
    Verdict own;
    judge_hole(own, note, one.circle, walls, notation);
    const bool is_excused = !own.has.empty() && is_given(one, given, walls, true);
    any = any || own.has.empty() || (is_excused && note.is_of_all);
    other.deny(own.has);
    if (is_of_each && !own.has.empty() && !is_excused) verdict.deny(one.name(notation) + ": " + own.has);
  }
  if (!any) verdict.deny(other.has.empty() ? "no such hole" : other.has);
}

// Threads are known where scenes or files state them.
void judge_holes(Verdict& verdict, const NotedText& note, const OtherTexts& given, const HoleWalls& walls,
                 const world::World& world, const Notation& notation) {
  const std::vector<Bore> threads = note.gives_thread() ? threads_of(walls, world) : std::vector<Bore>();
  if (threads.empty()) {
    if (note.gives_thread()) verdict.doubt("which holes have a thread");
    return judge_bores(verdict, note, given, bores_of(walls), walls, notation);
  }
  judge_bores(verdict, note, given, threads, walls, notation);
}

// Of things whose faces nobody tells, that there is such a length; the others are those of the whole.
void judge_lengths(Verdict& verdict, const NotedText& note, const NotedElement& size, const HoleWalls& walls,
                   const world::World& world, const Notation& notation) {
  const EqualLengths equal(walls.parts(), world, walls.slack());
  const Vec3 all = world.box.size();
  const auto allows = [&](double length) { return size.allows(length, walls.slack()); };
  if (note.kind == NotedKind::lengths && (allows(all.x) || allows(all.y) || allows(all.z))) return;
  if (note.kind == NotedKind::thickness && allows(equal.thickness())) return;
  if (equal.lengths(size.least) > 0) return verdict.doubt("what has a length of " + number_text(size.least, notation));
  verdict.deny("no such length");
}

}  // namespace

void judge_of_kind(Verdict& verdict, const NotedText& note, const OtherTexts& given, const HoleWalls& walls,
                   const world::World& world, const Notation& notation) {
  const NotedElement* size = note.size();
  check(!note.elements.empty(), "a note says something");
  const bool is_round = size != nullptr && size->sign == NotedSign::diameter;
  const bool is_of_holes = is_round || std::ranges::any_of(note.elements, is_of_hole);
  if (note.kind == NotedKind::holes || note.gives_thread() || (note.kind == NotedKind::none && is_of_holes))
    return judge_holes(verdict, note, given, walls, world, notation);
  if (size == nullptr) return verdict.doubt("a text without a size");
  // "2×45°" and "2×2", but not the sides of a block.
  const auto is_second = [](const NotedElement& one) {
    return one.role == NotedRole::angle || one.role == NotedRole::length;
  };
  const auto is_other_side = [size](const NotedElement& one) {
    return one.role == NotedRole::length && one.least != size->least;
  };
  const bool is_slope = std::ranges::any_of(note.all_understood(), is_second) &&
                        std::ranges::none_of(note.all_understood(), is_other_side);
  if (note.kind == NotedKind::fillets) return judge_fillets(verdict, *size, given, walls, world, notation);
  if (note.kind == NotedKind::chamfers || (note.kind == NotedKind::none && is_slope)) {
    const EqualLengths equal(walls.parts(), world, walls.slack());
    if (equal.slopes(size->least) == 0) verdict.deny("no chamfer of " + number_text(size->least, notation));
    return;
  }
  if (note.kind == NotedKind::none) return verdict.doubt("of what it speaks");
  judge_lengths(verdict, note, *size, walls, world, notation);
}

}  // namespace epura::sheet
