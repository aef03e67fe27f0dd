// SPDX-License-Identifier: Apache-2.0
#include "sizes/free_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "definition/words.hpp"
#include "features/tolerances.hpp"
#include "sizes/sheet_reading.hpp"
#include "surfaces/numbers.hpp"

namespace epura::sheet {

namespace {

using definition::Account;
using definition::FaceState;

std::string of_faces(std::ptrdiff_t count) { return std::to_string(count) + (count == 1 ? " face" : " faces"); }

// Of the views that show a length or an angle in its true form, the first.
std::string place_in(std::span<const DimensionsInView> views, const definition::Words& words) {
  const auto shows = [&words](const DimensionsInView& view) {
    if (!is_orthographic(view.projection) || view.turned_about) return false;
    const double along = std::abs(glm::dot(view.projection.n, words.along));
    return words.is_move ? along <= features::parallel : along >= 1 - features::parallel;
  };
  const auto view = std::find_if(views.begin(), views.end(), shows);
  return view == views.end() ? "" : " in view '" + view->view + "'";
}

// What shows where axes are, if it is not drawn.
std::string or_centre_lines(const DrawnPart& drawn, const definition::Words& words) {
  const surfaces::PartSurface& surface = drawn.part.faces[static_cast<std::size_t>(words.face)].surface;
  return drawn.marks.has_centre_lines || !surfaces::has_axis(surface.kind) ? "" : ", or centre lines";
}

// "faces 3, 5 and 8"
std::string named_faces(std::vector<int> numbers) {
  constexpr std::size_t most = 12;
  std::sort(numbers.begin(), numbers.end());
  std::string names = numbers.size() == 1 ? "face " : "faces ";
  for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i)
    names += (i == 0 ? "" : i + 1 < numbers.size() ? ", " : " and ") + std::to_string(numbers[i]);
  return names + (numbers.size() > most ? " and " + std::to_string(numbers.size() - most) + " more" : "");
}

// Of dimensions all of whose readings are certain, and follow from others; with these, each once.
std::vector<std::string> repeated_in(const Account& account, const FaceStatements& said, const DimensionNames& names) {
  check(account.follows.size() == said.of.size(), "each statement follows from others or not");
  std::vector<std::string> repeated;
  for (std::size_t first = 0, last = 0; first < said.of.size(); first = last) {
    while (last < said.of.size() && said.of[last] == said.of[first]) ++last;
    bool follows = true;
    for (std::size_t i = first; i < last; ++i)
      follows = follows && account.follows[i] != 0 && said.statements[i].is_certain;
    std::vector<DimensionPlace> from;
    for (const std::vector<int>& list : account.repeated) {
      const auto number = static_cast<std::size_t>(list.front());
      if (!follows || number < first || number >= last) continue;
      for (const int other : list) {
        const auto one = static_cast<std::size_t>(other);
        follows = follows && said.statements[one].is_certain;
        const bool is_known = std::find(from.begin(), from.end(), said.of[one]) != from.end();
        if (said.of[one] != said.of[first] && !is_known) from.push_back(said.of[one]);
      }
    }
    if (!follows) continue;
    const DimensionPlace& place = said.of[first];
    repeated.push_back(names.name_of(place) + " follows from " +
                       (from.empty() ? "what the views show; put it in brackets or remove it"
                                     : names.list_of(from, place[0]) + "; put it in brackets or remove one of them"));
  }
  return repeated;
}

// In scenes.
std::vector<int> numbers_of_faces(const world::World& world) {
  const world::Placed& placed = world.models[0];
  return surfaces::numbers_in(
      surfaces::numbered_faces(*placed.part, surfaces::middles_of_faces(placed.mesh->whole(), *placed.part)));
}

}  // namespace

FreeFaces find_free_faces(std::span<const DimensionsInView> views, const world::World& world,
                          const std::array<features::Extent, 3>& extents, const Notation& notation,
                          const definition::RuleSet& rules) {
  FreeFaces found;
  std::optional<DrawnPart> on_sheets = part_on_sheets(views, world, extents);
  if (!on_sheets) return found;
  if (on_sheets->faces > most_faces) {
    found.undecided.push_back("whether " + of_faces(static_cast<std::ptrdiff_t>(on_sheets->faces)) +
                              " are free: at most " + std::to_string(most_faces) + " are looked at");
    return found;
  }
  const SheetReading reading(std::move(*on_sheets), views, notation);
  const DrawnPart& drawn = reading.drawn;
  const FaceStatements& said = reading.said;
  const Account account = reading.account(rules);
  const DimensionNames names(views, notation);
  const auto of_model = account.states.begin() + static_cast<std::ptrdiff_t>(drawn.faces);
  const auto free = std::count(account.states.begin(), of_model, FaceState::free);
  for (std::size_t face = 0; face < drawn.faces; ++face)
    found.held.push_back(said.unread.empty() && account.states[face] == FaceState::fixed ? 1 : 0);
  const auto length = [&](double value) { return length_text(value, notation); };
  found.numbers = numbers_of_faces(world);
  std::vector<int> doubted;
  for (std::size_t face = 0; face < drawn.faces; ++face)
    if (account.states[face] == FaceState::uncertain) doubted.push_back(found.numbers[face]);
  const auto uncertain = static_cast<std::ptrdiff_t>(doubted.size());
  for (const definition::Motion& motion : account.motions) {
    const definition::Words words = definition::words_of(motion, drawn.part, reading.unknowns);
    if (!said.unread.empty() || words.face < 0) continue;
    const int number = found.numbers[static_cast<std::size_t>(words.face)];
    FreeFace one{definition::sentence_of(words, drawn.part, length, number) + place_in(views, words) +
                     or_centre_lines(drawn, words),
                 words.face, number, motion.faces};
    std::erase_if(one.faces, [&](int face) { return static_cast<std::size_t>(face) >= drawn.faces; });
    found.free.push_back(std::move(one));
  }
  if (free > 0 && !said.unread.empty())
    found.undecided.push_back("whether " + of_faces(free) +
                              " can move, for nobody can tell what this says of them: " + names.list_of(said.unread));
  if (uncertain > 0 || !account.is_certain)
    found.undecided.push_back(
        "whether the texts of dimensions hold " +
        (uncertain > 0 ? named_faces(doubted) : "the part, a motion of which they hardly change"));
  found.repeated = repeated_in(account, said, names);
  for (const std::vector<int>& list : account.contradictory) {
    std::vector<DimensionPlace> places;
    for (const int number : list)
      if (const DimensionPlace& place = said.of[static_cast<std::size_t>(number)];
          std::ranges::find(places, place) == places.end())
        places.push_back(place);
    // A text that is untrue also contradicts itself where it holds for several.
    if (places.size() == 1 && list.size() > 1) continue;
    found.contradictory.push_back(names.list_of(places) +
                                  (places.size() == 1 ? " against what the views show" : " cannot all be true"));
  }
  found.count.given = static_cast<int>(std::count(account.states.begin(), of_model, FaceState::fixed));
  found.count.all = static_cast<int>(drawn.faces) -
                    static_cast<int>(std::count(account.states.begin(), of_model, FaceState::by_model));
  found.count.unsure = static_cast<int>(uncertain + (said.unread.empty() ? 0 : free));
  check(found.count.given <= found.count.all, "no more faces are held than there are");
  return found;
}

std::vector<std::vector<std::vector<int>>> measured_faces(std::span<const DimensionsInView> views,
                                                          const world::World& world,
                                                          const std::array<features::Extent, 3>& extents,
                                                          const Notation& notation) {
  std::vector<std::vector<std::vector<int>>> faces;
  for (const DimensionsInView& view : views) faces.emplace_back(view.dimensions.size());
  std::optional<DrawnPart> drawn = part_on_sheets(views, world, extents);
  if (!drawn || drawn->faces > most_faces) return faces;
  const SheetReading reading(std::move(*drawn), views, notation);
  const FaceStatements& said = reading.said;
  const std::vector<int> numbers = numbers_of_faces(world);
  check(numbers.size() == reading.drawn.faces, "each face has a number");
  for (std::size_t i = 0; i < said.statements.size(); ++i) {
    if (i > 0 && said.of[i] == said.of[i - 1]) continue;
    std::vector<int>& list = faces[said.of[i][0]][said.of[i][1]];
    for (const definition::Row& row : said.statements[i].rows)
      for (const definition::Term& term : row)
        if (const auto face = static_cast<std::size_t>(reading.unknowns[term.unknown].face); face < reading.drawn.faces)
          list.push_back(numbers[face]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return faces;
}

}  // namespace epura::sheet
