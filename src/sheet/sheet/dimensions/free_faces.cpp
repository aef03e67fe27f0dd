// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/free_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "definition/account.hpp"
#include "definition/part_of_model.hpp"
#include "definition/words.hpp"
#include "features/assembly_features.hpp"
#include "features/tolerances.hpp"
#include "sheet/dimensions/face_statements.hpp"

namespace epura::sheet {

namespace {

using definition::Account;
using definition::FaceState;

constexpr std::size_t most_faces = 2000;  // ranks take time as the cube of the faces that hang together

std::string of_faces(std::ptrdiff_t count) { return std::to_string(count) + (count == 1 ? " face" : " faces"); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Three directions at 60 degrees to each other: to readers, a hexagon is regular, and no rule of the table says it.
bool has_hexagon(const definition::Directions& directions) {
  const auto are_at_60 = [&](std::size_t i, std::size_t j) {
    return std::abs(std::abs(glm::dot(directions.directions[i], directions.directions[j])) - 0.5) <= features::parallel;
  };
  const std::size_t count = directions.directions.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count && are_at_60(i, j); ++k)
        if (are_at_60(i, k) && are_at_60(j, k)) return true;
  return false;
}

}  // namespace

FreeFaces find_free_faces(std::span<const DimensionsInView> views, const world::World& world,
                          const std::array<features::Extent, 3>& extents, const Notation& notation) {
  FreeFaces found;
  if (features::is_assembly(world) || world.models.size() != 1) return found;
  auto faces = definition::part_of_model(world, 0);
  if (!faces) return found;
  if (faces->faces.size() > most_faces) {
    found.sentences.push_back("cannot tell whether " + of_faces(static_cast<std::ptrdiff_t>(faces->faces.size())) +
                              " are free: at most " + std::to_string(most_faces) + " are looked at");
    return found;
  }
  DrawnPart drawn = with_drawn_lines(std::move(*faces), views, extents);
  const definition::Directions directions = definition::find_directions(drawn.part.faces);
  drawn.part = definition::with_common_directions(std::move(drawn.part), directions);
  const definition::Unknowns unknowns(drawn.part, directions);
  const auto rules = definition::state_rules(drawn.part, directions, unknowns, drawn.marks, definition::Standard::iso);
  const FaceStatements said = state_dimensions(views, drawn, directions, unknowns, notation);
  const Account account = definition::take_account(drawn.part, unknowns, rules, said.statements);
  const auto of_model = account.states.begin() + static_cast<std::ptrdiff_t>(drawn.faces);
  const auto uncertain = std::count(account.states.begin(), of_model, FaceState::uncertain);
  const auto free = std::count(account.states.begin(), of_model, FaceState::free);
  std::vector<std::string> doubts = said.unread;
  if (has_hexagon(directions)) doubts.emplace_back("a hexagon, which may be regular");
  const auto length = [&](double value) { return length_text(value, notation); };
  for (const definition::Motion& motion : account.motions)
    if (std::string sentence = definition::sentence_of(motion, drawn.part, unknowns, length);
        doubts.empty() && !sentence.empty())
      found.sentences.push_back(std::move(sentence));
  if (free > 0 && !doubts.empty())
    found.sentences.push_back("cannot tell whether " + of_faces(free) +
                              " can move, for nobody can tell what this says of them: " + listed(doubts));
  if (uncertain > 0 || !account.is_certain)
    found.sentences.push_back("cannot tell whether the texts of dimensions hold " + of_faces(uncertain));
  found.count.given = static_cast<int>(std::count(account.states.begin(), of_model, FaceState::fixed));
  found.count.all = static_cast<int>(drawn.faces) -
                    static_cast<int>(std::count(account.states.begin(), of_model, FaceState::by_model));
  check(found.count.given <= found.count.all, "no more faces are held than there are");
  return found;
}

}  // namespace epura::sheet
