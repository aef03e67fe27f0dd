// SPDX-License-Identifier: Apache-2.0
#include "sizes/free_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "definition/account.hpp"
#include "definition/words.hpp"
#include "features/tolerances.hpp"
#include "sizes/face_statements.hpp"
#include "sizes/stated_values.hpp"
#include "surfaces/numbers.hpp"

namespace epura::sheet {

namespace {

using definition::Account;
using definition::FaceState;
using definition::Statement;

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

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) append_to_list(text, name);
  return text;
}

// Of dimensions, in words: "15, 25 in view 'top' and 40". The view is told where it is not that of the first one.
class DimensionNames {
 public:
  DimensionNames(std::span<const DimensionsInView> views, const FaceStatements& said, const Notation& notation)
      : views_(views), said_(said), notation_(notation) {}

  [[nodiscard]] std::string of_first(std::size_t statement) const {
    return text_of(statement) + in_view(said_.of[statement][0]);
  }
  [[nodiscard]] std::string of_others(std::size_t first, const std::vector<std::size_t>& statements) const {
    std::string names;
    for (std::size_t i = 0; i < statements.size(); ++i) {
      const std::size_t view = said_.of[statements[i]][0];
      names += (i == 0 ? "" : i + 1 < statements.size() ? ", " : " and ") + text_of(statements[i]);
      if (view != said_.of[first][0]) names += in_view(view);
    }
    return names;
  }

 private:
  [[nodiscard]] std::string text_of(std::size_t statement) const {
    const auto [view, number] = said_.of[statement];
    return sheet::text_of(views_[view].dimensions[number], views_[view], notation_);
  }
  [[nodiscard]] std::string in_view(std::size_t view) const { return " in view '" + views_[view].view + "'"; }

  std::span<const DimensionsInView> views_;
  const FaceStatements& said_;
  const Notation& notation_;
};

// Of dimensions all of whose readings are certain, and follow from others; with these, each once.
std::vector<std::string> repeated_in(const Account& account, const FaceStatements& said, const DimensionNames& names) {
  check(account.follows.size() == said.of.size(), "each statement follows from others or not");
  std::vector<std::string> repeated;
  for (std::size_t first = 0, last = 0; first < said.of.size(); first = last) {
    while (last < said.of.size() && said.of[last] == said.of[first]) ++last;
    bool follows = true;
    for (std::size_t i = first; i < last; ++i)
      follows = follows && account.follows[i] != 0 && said.statements[i].is_certain;
    std::vector<std::size_t> from;  // one statement of each dimension
    for (const std::vector<int>& list : account.repeated) {
      const auto number = static_cast<std::size_t>(list.front());
      if (!follows || number < first || number >= last) continue;
      for (const int other : list) {
        const auto one = static_cast<std::size_t>(other);
        follows = follows && said.statements[one].is_certain;
        const bool is_known =
            std::any_of(from.begin(), from.end(), [&](std::size_t known) { return said.of[known] == said.of[one]; });
        if (said.of[one] != said.of[first] && !is_known) from.push_back(one);
      }
    }
    if (!follows) continue;
    repeated.push_back(names.of_first(first) + " follows from " +
                       (from.empty() ? "what the views show; put it in brackets or remove it"
                                     : names.of_others(first, from) + "; put it in brackets or remove one of them"));
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
  const std::optional<DrawnPart> on_sheets = part_on_sheets(views, world, extents);
  if (!on_sheets) return found;
  const DrawnPart& drawn = *on_sheets;
  if (drawn.faces > most_faces) {
    found.undecided.push_back("whether " + of_faces(static_cast<std::ptrdiff_t>(drawn.faces)) + " are free: at most " +
                              std::to_string(most_faces) + " are looked at");
    return found;
  }
  const definition::Directions directions = definition::find_directions(drawn.part.faces);
  const definition::Unknowns unknowns(drawn.part, directions);
  const auto given = definition::state_rules(drawn.part, directions, unknowns, drawn.marks, rules);
  const FaceStatements said = state_dimensions(views, drawn, directions, unknowns, notation);
  const Account account = definition::take_account(drawn.part, unknowns, given, said.statements);
  const auto of_model = account.states.begin() + static_cast<std::ptrdiff_t>(drawn.faces);
  const auto uncertain = std::count(account.states.begin(), of_model, FaceState::uncertain);
  const auto free = std::count(account.states.begin(), of_model, FaceState::free);
  const auto length = [&](double value) { return length_text(value, notation); };
  found.numbers = numbers_of_faces(world);
  for (const definition::Motion& motion : account.motions) {
    const definition::Words words = definition::words_of(motion, drawn.part, unknowns);
    if (!said.unread.empty() || words.face < 0) continue;
    const int number = found.numbers[static_cast<std::size_t>(words.face)];
    FreeFace one{definition::sentence_of(words, drawn.part, length, number) + place_in(views, words), words.face,
                 number, motion.faces};
    std::erase_if(one.faces, [&](int face) { return static_cast<std::size_t>(face) >= drawn.faces; });
    found.free.push_back(std::move(one));
  }
  if (free > 0 && !said.unread.empty())
    found.undecided.push_back("whether " + of_faces(free) +
                              " can move, for nobody can tell what this says of them: " + listed(said.unread));
  if (uncertain > 0 || !account.is_certain)
    found.undecided.push_back("whether the texts of dimensions hold " +
                              (uncertain > 0 ? of_faces(uncertain) : "the part, a motion of which they hardly change"));
  found.untrue = said.untrue;
  found.repeated = repeated_in(account, said, {views, said, notation});
  for (const std::vector<int>& list : account.contradictory) {
    std::vector<std::string> names;
    for (const int number : list) names.push_back(said.statements[static_cast<std::size_t>(number)].name);
    found.contradictory.push_back(listed(names) +
                                  (names.size() == 1 ? " against what the views show" : " cannot all be true"));
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
  const std::optional<DrawnPart> drawn = part_on_sheets(views, world, extents);
  if (!drawn || drawn->faces > most_faces) return faces;
  const definition::Directions directions = definition::find_directions(drawn->part.faces);
  const definition::Unknowns unknowns(drawn->part, directions);
  const FaceStatements said = state_dimensions(views, *drawn, directions, unknowns, notation);
  check(said.of.size() == said.statements.size(), "each statement is that of a dimension");
  const std::vector<int> numbers = numbers_of_faces(world);
  for (std::size_t i = 0; i < said.statements.size(); ++i) {
    if (i > 0 && said.of[i] == said.of[i - 1]) continue;
    std::vector<int>& list = faces[said.of[i][0]][said.of[i][1]];
    for (const definition::Row& row : said.statements[i].rows)
      for (const definition::Term& term : row)
        if (const auto face = static_cast<std::size_t>(unknowns[term.unknown].face); face < drawn->faces)
          list.push_back(numbers[face]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return faces;
}

}  // namespace epura::sheet
