// SPDX-License-Identifier: Apache-2.0
#include "compare/align_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/angle.hpp"
#include "base/text.hpp"
#include "compare/ink_parts.hpp"
#include "scene/line_roles.hpp"

namespace epura::compare {

namespace {

// What lines of two drawings have in common that stand at different places: style, and the way from end to end.
using Form = std::tuple<long long, bool, bool, long long, long long>;

constexpr double step = 0.01;  // mm: forms and shifts that differ by less are the same

std::pair<Form, Vec2> form_of(const PicturePiece& piece, const PictureLook& look) {
  Vec2 from = piece.from, to = piece.to;
  if (std::pair(from.x, from.y) > std::pair(to.x, to.y)) std::swap(from, to);
  const Vec2 way = to - from;
  return {{std::llround(look.width / step), look.visible, look.dashes.empty(), std::llround(way.x / step),
           std::llround(way.y / step)},
          from};
}

using Places = std::map<Form, std::vector<Vec2>>;

std::map<std::string, Places> places_by_view(const Picture& picture) {
  std::map<std::string, Places> places;
  for (const PicturePiece& piece : picture.pieces) {
    const PictureLook& look = picture.looks[static_cast<std::size_t>(piece.look)];
    if (look.filled) continue;
    const auto [form, from] = form_of(piece, look);
    places[picture.views[static_cast<std::size_t>(piece.view)]][form].push_back(from);
  }
  return places;
}

struct Votes {
  double length = 0;
  Vec2 sum{0, 0};  // of the shifts, each times the length of its line
};

double length_of_form(const Form& form) {
  return step * std::hypot(static_cast<double>(std::get<3>(form)), static_cast<double>(std::get<4>(form)));
}

// The shift on which most of the ink agrees: of lines in pairs that look alike, so that lines beside each other, or
// pieces of circles, may vote for a shift that brings nothing together.
Vec2 common_shift(const Places& before, const Places& after) {
  constexpr std::size_t max_alike = 12;  // of which nothing tells which is which
  std::map<std::pair<long long, long long>, Votes> votes;
  for (const auto& [form, places] : before) {
    const auto others = after.find(form);
    if (others == after.end() || std::max(places.size(), others->second.size()) > max_alike) continue;
    const double length = length_of_form(form);
    for (const Vec2& a : places)
      for (const Vec2& b : others->second) {
        Votes& vote = votes[{std::llround((b.x - a.x) / step), std::llround((b.y - a.y) / step)}];
        vote.length += length;
        vote.sum += (b - a) * length;
      }
  }
  // Of shifts with the same ink, the shortest: the sides of a rectangle look alike.
  const auto key = [](const auto& vote) {
    const auto [x, y] = vote.first;
    return std::pair(std::llround(vote.second.length / step), -(x * x + y * y));
  };
  const auto best =
      std::max_element(votes.begin(), votes.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return best == votes.end() ? Vec2(0) : best->second.sum / best->second.length;
}

Picture one_view(const Picture& picture, const std::string& name) {
  Picture view = picture;
  std::erase_if(view.pieces,
                [&](const PicturePiece& piece) { return picture.views[static_cast<std::size_t>(piece.view)] != name; });
  return view;
}

// Whether more ink of a view lies on the other's once it is shifted, however its lines are cut.
bool brings_together(const Picture& before, const Picture& after, const Vec2& shift, double tolerance) {
  const CommonLooks table = common_looks(before, after);
  std::vector<InkPart> parts = seen_parts(before, table, table.of_before, false);
  const std::vector<InkPart> others = seen_parts(after, table, table.of_after, false);
  const auto length_in_common = [&] {
    double length = 0;
    for (const InkPart& part : divide(parts, others, tolerance).met) length += length_of(part);
    return length;
  };
  const double here = length_in_common();
  for (InkPart& part : parts) part.from += shift, part.to += shift;
  return length_in_common() > here;
}

bool is_same(double a, double b, double tolerance) { return std::abs(a - b) <= 2 * tolerance + 1e-3; }

/// A line by its ends; along it, it may be longer than from one to the other.
struct Ends {
  Vec2 from, to;
  double length;
};

// Of a closed line, the place at which a circle of its length begins: chords may begin anywhere.
Ends ends_of(const Difference& d) {
  if (d.from != d.to) return {d.from, d.to, d.length};
  const Vec2 begin = d.centre - Vec2(d.length / full_turn, 0);
  return {begin, begin, d.length};
}

// How the ends of a line moved along one axis, in either order; nothing if they moved otherwise, or if the line changed
// its form besides.
std::optional<std::array<double, 2>> moves_along(int axis, const Ends& was, const Ends& is, double tolerance) {
  for (const Ends& end : {is, Ends{is.to, is.from, is.length}}) {
    if (!is_same(was.from[1 - axis], end.from[1 - axis], tolerance) ||
        !is_same(was.to[1 - axis], end.to[1 - axis], tolerance))
      continue;
    const std::array<double, 2> moves{end.from[axis] - was.from[axis], end.to[axis] - was.to[axis]};
    const double longer = std::abs(end.length - was.length);
    // In one direction, if both moved. A circle whose only end moved may be larger.
    const double around = was.from == was.to && is.from == is.to ? full_turn * std::abs(moves[0]) : 0;
    if (moves[0] * moves[1] >= 0 && longer <= std::max(std::abs(moves[1] - moves[0]), around) + 2 * tolerance + 1e-3)
      return moves;
  }
  return std::nullopt;
}

bool is_size(const Difference& d) { return d.change == Change::text && !measured_by(d).empty(); }

bool is_round(const Difference& d) {
  const std::string size = is_size(d) ? measured_by(d) : "";
  return size == "diameter" || size == "radius";
}

// Dimension lines, centre lines and what stands at them are placed anew where sizes changed; a text that is another one
// is told.
bool is_placed(const Difference& d) {
  const auto is_name = [](std::string_view name) {
    const scene::SheetLineRow* row = scene::find_line(name);
    return row != nullptr && (row->line == scene::SheetLine::dimension || row->line == scene::SheetLine::centre);
  };
  return d.is_text ? d.change == Change::moved : is_name(d.before) || is_name(d.after);
}

bool touch(const Difference& a, const Difference& b) {
  const auto has_end = [&](const Vec2& p) {
    return glm::distance(p, b.from) <= step || glm::distance(p, b.to) <= step;
  };
  return has_end(a.from) || has_end(a.to);
}

bool is_of_view(const Difference& d) { return !d.view.empty() && d.view != "sheet" && !d.is_view; }

// A text of a view that the other drawing lacks: its dimension is told by it alone.
bool is_other_size(const Difference& d) {
  return d.is_text && is_of_view(d) && (d.change == Change::added || d.change == Change::removed);
}

/// Finds, of the differences of one view, those whose lines moved along one axis; of a round size, either way.
class Followers {
 public:
  Followers(const std::vector<Difference>& all, std::vector<std::size_t> of_view, int axis, double tolerance)
      : all_(all),
        of_view_(std::move(of_view)),
        axis_(axis),
        tolerance_(tolerance),
        is_round_(std::any_of(all.begin(), all.end(), is_round)),
        is_paired_(all.size()) {}

  std::vector<std::size_t> find() {
    pair_lines();
    const double most = most_common();
    if (most == 0) return {};
    std::vector<std::size_t> found;
    const auto is_within = [&](double move) {
      return (is_round_ || move * most >= 0) && std::abs(move) <= std::abs(most) + slack();
    };
    std::set<long long> lengths;
    for (const Pair& pair : pairs_) {
      const bool follows = is_within(pair.moves[0]) && is_within(pair.moves[1]);
      if (follows) found.insert(found.end(), pair.differences.begin(), pair.differences.end());
      if (follows)
        for (const double move : pair.moves) lengths.insert(std::llround(std::abs(move) / step));
      else  // two ends of one line that moved along itself, perhaps
        for (const std::size_t i : pair.differences) is_paired_[i] = false;
    }
    for (const std::size_t i : of_view_)
      if (!is_paired_[i] && is_rest(all_[i], lengths)) found.push_back(i);
    return found;
  }

 private:
  using Moves = std::array<double, 2>;
  struct Pair {
    std::vector<std::size_t> differences;
    Moves moves;
    double length;
  };

  [[nodiscard]] double slack() const { return 2 * tolerance_ + 1e-3; }

  void pair_lines() {
    std::vector<std::size_t> added;
    for (const std::size_t i : of_view_) {
      const Difference& d = all_[i];
      if (d.change == Change::added && !d.is_text) added.push_back(i);
      if (d.change != Change::moved) continue;
      const Ends was{d.old_from, d.old_to, d.old_length}, is{d.from, d.to, d.length};
      if (const auto moves = moves_along(axis_, was, is, tolerance_)) add({i}, *moves, d.length);
    }
    for (const std::size_t i : of_view_)
      if (all_[i].change == Change::removed && !all_[i].is_text) pair_with_nearest(i, added);
  }

  // Removes it from those that are left.
  void pair_with_nearest(std::size_t removed, std::vector<std::size_t>& added) {
    const Difference& gone = all_[removed];
    auto nearest = added.end();
    std::optional<Moves> least;
    for (auto k = added.begin(); k != added.end(); ++k) {
      const Difference& come = all_[*k];
      if (come.after != gone.before) continue;
      if (!is_round_ && gone.from == gone.to) continue;
      const auto moves = moves_along(axis_, ends_of(gone), ends_of(come), tolerance_);
      if (!moves || (least && largest(*least) <= largest(*moves))) continue;
      nearest = k;
      least = moves;
    }
    if (!least) return;
    add({removed, *nearest}, *least, gone.length);
    added.erase(nearest);
  }

  static double largest(const Moves& moves) { return std::max(std::abs(moves[0]), std::abs(moves[1])); }

  void add(std::vector<std::size_t> differences, const Moves& moves, double length) {
    for (const std::size_t i : differences) is_paired_[i] = true;
    pairs_.push_back({std::move(differences), moves, length});
  }

  // By the length of lines that moved as wholes.
  [[nodiscard]] double most_common() const {
    std::map<long long, double> votes;
    for (const Pair& pair : pairs_)
      for (const double move : pair.moves)
        if (std::abs(move) > slack()) votes[std::llround(move / step)] += pair.length;
    const auto best =
        std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == votes.end() ? 0 : step * static_cast<double>(best->first);
  }

  // What a line along the axis is longer or shorter than before: as much as other lines moved. Where a dimension line
  // was or is on the rest of it, that has another style.
  [[nodiscard]] bool is_rest(const Difference& d, const std::set<long long>& lengths) const {
    const bool is_one_sided = d.change == Change::added || d.change == Change::removed;
    const bool is_along = is_same(d.from[1 - axis_], d.to[1 - axis_], tolerance_) &&
                          is_same(d.length, std::abs(d.to[axis_] - d.from[axis_]), tolerance_);
    double whole = d.length;
    for (const Difference& rest : all_)
      if (rest.change == Change::restyled && rest.view == d.view && is_placed(rest) && touch(rest, d))
        whole += rest.length;
    const long long length = std::llround(whole / step);
    return is_one_sided && !d.is_text && is_along &&
           (lengths.contains(length) || lengths.contains(length - 1) || lengths.contains(length + 1));
  }

  const std::vector<Difference>& all_;
  std::vector<std::size_t> of_view_;
  int axis_;
  double tolerance_;
  bool is_round_;
  std::vector<char> is_paired_;
  std::vector<Pair> pairs_{};
};

}  // namespace

std::vector<Difference> align_views(Picture& before, const Picture& after, double tolerance) {
  const auto old_places = places_by_view(before), new_places = places_by_view(after);
  std::map<std::string, Vec2> shifts;
  std::vector<Difference> found;
  for (const auto& [view, places] : old_places) {
    const auto others = new_places.find(view);
    if (view.empty() || view == "sheet" || others == new_places.end()) continue;
    const Vec2 shift = common_shift(places, others->second);
    const double same = std::max(step, tolerance);
    if (glm::length(shift) <= same || !brings_together(one_view(before, view), one_view(after, view), shift, same))
      continue;
    shifts[view] = shift;
    const auto with_it = std::find_if(found.begin(), found.end(),
                                      [&](const Difference& other) { return glm::distance(other.to, shift) <= same; });
    if (with_it != found.end()) {
      with_it->view += ", " + view;
      continue;
    }
    Difference& moved = found.emplace_back();
    moved.change = Change::moved;
    moved.view = view;
    moved.is_view = true;
    moved.to = shift;
    moved.distance = glm::length(shift);
  }
  const auto shift_of = [&](int view) {
    const auto shift = shifts.find(before.views[static_cast<std::size_t>(view)]);
    return shift == shifts.end() ? Vec2(0) : shift->second;
  };
  for (PicturePiece& piece : before.pieces) {
    piece.from += shift_of(piece.view);
    piece.to += shift_of(piece.view);
  }
  for (PictureText& text : before.texts) {
    text.min += shift_of(text.view);
    text.max += shift_of(text.view);
  }
  return found;
}

std::size_t take_followers(std::vector<Difference>& differences, double tolerance) {
  const bool any_size = std::ranges::any_of(differences, is_size);
  if (!any_size && std::ranges::none_of(differences, is_other_size)) return 0;
  std::map<std::string, std::vector<std::size_t>> by_view;
  for (std::size_t i = 0; i < differences.size(); ++i)
    if (is_of_view(differences[i])) by_view[differences[i].view].push_back(i);
  std::vector<char> follows(differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i)
    follows[i] = is_of_view(differences[i]) && is_placed(differences[i]);
  constexpr std::size_t max_read = 5000;  // each is compared with each, and a view with more of them is another one
  for (const auto& [view, numbers] : by_view)
    for (const int axis : {0, 1}) {
      if (!any_size || numbers.size() > max_read) break;
      std::vector<std::size_t> left;
      std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(left),
                   [&](std::size_t i) { return !follows[i]; });
      for (const std::size_t i : Followers(differences, std::move(left), axis, tolerance).find()) follows[i] = true;
    }
  std::size_t next = 0;
  std::erase_if(differences, [&](const Difference&) { return follows[next++] != 0; });
  return static_cast<std::size_t>(std::count(follows.begin(), follows.end(), 1));
}

std::string measured_by(const Difference& text) {
  constexpr std::string_view digits = "0123456789.,";
  const auto differ = std::mismatch(text.before.begin(), text.before.end(), text.after.begin(), text.after.end()).first;
  std::string_view sign(text.before.data(), static_cast<std::size_t>(differ - text.before.begin()));
  sign = sign.substr(0, sign.find_last_not_of(digits) + 1);
  // The number after the sign, and the rest.
  const auto split = [&](std::string_view words) {
    words.remove_prefix(sign.size());
    const std::size_t end = std::min(words.find_first_not_of(digits), words.size());
    return std::pair(words.substr(0, end), words.substr(end));
  };
  const auto [was, rest] = split(text.before);
  const auto [is, same_rest] = split(text.after);
  if (was.empty() || is.empty() || was == is || rest != same_rest || text.view == "sheet") return {};
  if (sign.ends_with("⌀") || sign.ends_with("Ø")) return "diameter";
  if (sign.ends_with("R")) return "radius";
  if (sign.empty() && rest == "°") return "angle";
  if (!sign.empty() || !rest.empty()) return "size";
  constexpr std::array<std::tuple<std::string_view, const char*, const char*>, 7> views{{{"front", "width", "height"},
                                                                                         {"rear", "width", "height"},
                                                                                         {"back", "width", "height"},
                                                                                         {"top", "width", "depth"},
                                                                                         {"bottom", "width", "depth"},
                                                                                         {"left", "depth", "height"},
                                                                                         {"right", "depth", "height"}}};
  // A single digit is as tall as it is wide.
  const Vec2 box = text.to - text.from;
  for (const auto& [view, along, up] : views)
    if (text.view == view && was.size() > 1 && is.size() > 1) return box.x > box.y ? along : up;
  return "size";
}

}  // namespace epura::compare
