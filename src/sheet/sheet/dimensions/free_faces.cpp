// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/free_faces.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "definition/account.hpp"
#include "definition/part_of_model.hpp"
#include "definition/words.hpp"
#include "features/assembly_features.hpp"
#include "features/engraving.hpp"
#include "sheet/dimensions/face_statements.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using definition::Account;
using definition::FaceState;

constexpr std::size_t most_faces = 2000;  // ranks take time as the cube of the faces that hang together

std::string of_faces(std::ptrdiff_t count) { return std::to_string(count) + (count == 1 ? " face" : " faces"); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) append_to_list(text, name);
  return text;
}

}  // namespace

FreeFaces find_free_faces(std::span<const DimensionsInView> views, const world::World& world,
                          const std::array<features::Extent, 3>& extents, const Notation& notation) {
  FreeFaces found;
  if (features::is_assembly(world) || world.models.size() != 1) return found;
  auto faces = definition::part_of_model(world, 0);
  if (!faces) return found;
  // Letters are given by their text.
  const std::vector<char> letters = features::walls_of_letters(world.models[0], *world::place_part(world.models[0]));
  for (std::size_t i = 0; i < faces->faces.size(); ++i)
    if (letters[i] != 0) faces->faces[i].surface.kind = surfaces::SurfaceKind::free_form;
  if (faces->faces.size() > most_faces) {
    found.undecided.push_back("whether " + of_faces(static_cast<std::ptrdiff_t>(faces->faces.size())) +
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
  const auto length = [&](double value) { return length_text(value, notation); };
  for (const definition::Motion& motion : account.motions)
    if (std::string sentence = definition::sentence_of(motion, drawn.part, unknowns, length);
        said.unread.empty() && !sentence.empty())
      found.sentences.push_back(std::move(sentence));
  if (free > 0 && !said.unread.empty())
    found.undecided.push_back("whether " + of_faces(free) +
                              " can move, for nobody can tell what this says of them: " + listed(said.unread));
  if (uncertain > 0 || !account.is_certain)
    found.undecided.push_back("whether the texts of dimensions hold " + of_faces(uncertain));
  found.untrue = said.untrue;
  for (const std::vector<int>& list : account.contradictory) {
    std::vector<std::string> names;
    for (const int number : list) names.push_back(said.statements[static_cast<std::size_t>(number)].name);
    found.contradictory.push_back(listed(names) +
                                  (names.size() == 1 ? " against what the views show" : " cannot all be true"));
  }
  found.count.given = static_cast<int>(std::count(account.states.begin(), of_model, FaceState::fixed));
  found.count.all = static_cast<int>(drawn.faces) -
                    static_cast<int>(std::count(account.states.begin(), of_model, FaceState::by_model));
  check(found.count.given <= found.count.all, "no more faces are held than there are");
  return found;
}

}  // namespace epura::sheet
