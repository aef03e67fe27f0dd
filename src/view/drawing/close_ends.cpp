// SPDX-License-Identifier: Apache-2.0
#include "drawing/close_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "search/lines_at.hpp"

namespace epura::drawing {

namespace {

/// A short line from an end to the ink that is drawn for the ink that was removed there.
struct Link {
  std::array<double, 4> ends;  ///< x and y of both
  bool hidden;
  int piece;  ///< the piece that ends there
  double at;  ///< parameter of the end on that piece

  auto operator<=>(const Link&) const = default;
};

/// How an end reaches other ink.
struct Closing {
  double cut = 0;  ///< mm of the line that are cut off
  std::optional<Link> link{};
};

/// A part of a piece, and what happens at its ends.
struct ClosedPart {
  InkPart part;
  std::array<Closing, 2> ends{};
};

class EndCloser {
 public:
  EndCloser(const InkParts& kept, const TakenInk& taken, const ClosingLimits& limits)
      : kept_(kept),
        taken_(taken),
        limits_(limits),
        taken_lines_(lines_of(taken.parts)),
        kept_at_(kept.lines(), limits.touching),
        taken_at_(taken_lines_, limits.touching) {}

  [[nodiscard]] Closing closing_of(const InkPart& part, int end) const {
    const std::array<Vec2, 2> line = ends_of(part);
    const Vec2 place = line[end];
    const auto onto = drawn_for(part.piece, place);
    if (!onto) return {};
    // Dangles are removed along with the ink that they touched.
    const double length = glm::distance(line[0], line[1]);
    if (length <= limits_.touching) return {length, std::nullopt};
    if (is_held(part.piece, place)) return {};
    const auto along = way_along(line[1 - end], place, *onto);
    if (along && *along <= 0) return {-*along, std::nullopt};
    const Vec2 to = along ? place + *along / length * (place - line[1 - end]) : nearest_on(*onto, place);
    const double at = end == 0 ? part.from : part.to;
    return {0, Link{{place.x, place.y, to.x, to.y}, !kept_.pieces()[part.piece].visible, part.piece, at}};
  }

  // Appends what remains of a part, if anything.
  void append(const ClosedPart& closed, std::vector<Piece>& pieces) const {
    InkPart part = closed.part;
    const auto& [first, last] = closed.ends;
    if (first.cut > 0 || last.cut > 0) {
      const double length = length_of(kept_.pieces()[part.piece]);
      part.from += first.cut / length;
      part.to -= last.cut / length;
      if (!((part.to - part.from) * length > limits_.touching)) return;
    }
    check(part.from <= part.to, "what is left of a line goes forwards");
    const auto [from, to] = ends_of(part);
    if (from != to) pieces.push_back(drawn(part, from, to));
  }

  [[nodiscard]] Piece drawn(const Link& link) const {
    return drawn({link.piece, link.at, link.at}, {link.ends[0], link.ends[1]}, {link.ends[2], link.ends[3]});
  }

 private:
  [[nodiscard]] Piece drawn(const InkPart& part, const Vec2& from, const Vec2& to) const {
    Piece piece = kept_.pieces()[part.piece];
    const auto s = [first = piece.s[0], last = piece.s[1]](double u) {
      return u <= 0 ? first : u >= 1 ? last : first + u * (last - first);
    };
    piece.s = {s(part.from), s(part.to)};
    piece.from = from;
    piece.to = to;
    return piece;
  }

  [[nodiscard]] bool counts(int piece, int other) const {
    return kept_.pieces()[other].visible || !kept_.pieces()[piece].visible;
  }

  [[nodiscard]] bool lies_on(const Vec2& place, const std::array<Vec2, 2>& line) const {
    return may_be_within(line, place, limits_.touching) &&
           glm::distance(nearest_on(line, place), place) <= limits_.touching;
  }

  [[nodiscard]] std::array<Vec2, 2> ends_of(const InkPart& part) const {
    const Piece& piece = kept_.pieces()[part.piece];
    return {place_on(piece, part.from), place_on(piece, part.to)};
  }

  [[nodiscard]] std::vector<std::array<Vec2, 2>> lines_of(const std::vector<InkPart>& parts) const {
    std::vector<std::array<Vec2, 2>> lines;
    lines.reserve(parts.size());
    for (const InkPart& part : parts) lines.push_back(ends_of(part));
    return lines;
  }

  // Returns the nearest of the lines that are drawn for taken ink at an end of a piece, or nothing if the end already
  // lies on one.
  [[nodiscard]] std::optional<std::array<Vec2, 2>> drawn_for(int piece, const Vec2& place) const {
    std::optional<std::array<Vec2, 2>> best;
    double least = HUGE_VAL;
    for (const int number : taken_at_(place)) {
      if (!lies_on(place, taken_lines_[number]) || !counts(piece, taken_.parts[number].piece)) continue;
      for (const int by : taken_.kept_for(number)) {
        const std::array<Vec2, 2>& line = kept_.line(by);
        if (!may_be_within(line, place, least)) continue;
        const double distance = glm::distance(nearest_on(line, place), place);
        if (!(distance < least)) continue;
        least = distance;
        best = line;
      }
      if (least <= limits_.touching) return std::nullopt;
    }
    return best;
  }

  // Whether an end of a piece lies on other ink that stays, but not at an end of that ink, which may itself move.
  [[nodiscard]] bool is_held(int piece, const Vec2& place) const {
    const std::span<const int> others = kept_at_(place);
    return std::any_of(others.begin(), others.end(), [&](int number) {
      const int other = kept_[number].piece;
      if (!lies_on(place, kept_.line(number)) || other == piece || !counts(piece, other)) return false;
      const auto [from, to] = kept_.line(number);
      return glm::distance(from, place) > limits_.touching && glm::distance(to, place) > limits_.touching;
    });
  }

  // Returns how far beyond its end a line meets another one.
  [[nodiscard]] std::optional<double> way_along(const Vec2& start, const Vec2& end,
                                                const std::array<Vec2, 2>& onto) const {
    const Ruler line(start, end);
    const Vec2 a = line.local(onto[0]), b = line.local(onto[1]);
    // The point of the other line that is nearest to this one.
    const double part = a.y == b.y ? 0 : std::clamp(a.y / (a.y - b.y), 0.0, 1.0);
    const Vec2 meeting = a + part * (b - a);
    check(part >= 0 && part <= 1, "a line ends on the line that is drawn instead");
    const double along = meeting.x - line.length;
    if (std::abs(meeting.y) > limits_.touching || std::abs(along) > limits_.along) return std::nullopt;
    return along;
  }

  const InkParts& kept_;
  const TakenInk& taken_;
  const ClosingLimits& limits_;
  std::vector<std::array<Vec2, 2>> taken_lines_;  ///< by taken part
  search::LinesAt kept_at_, taken_at_;            ///< numbers of parts
};

}  // namespace

std::vector<Piece> close_ends(const InkParts& kept, const TakenInk& taken, const std::vector<InkPart>& left,
                              const ClosingLimits& limits, const Progress& progress) {
  const EndCloser closer(kept, taken, limits);
  std::vector<ClosedPart> closed(left.size());
  parallel_for(left.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      closed[i] = {left[i], {closer.closing_of(left[i], 0), closer.closing_of(left[i], 1)}};
  });
  std::vector<Piece> pieces;
  pieces.reserve(left.size());
  std::vector<Link> links;
  for (const ClosedPart& one : closed) {
    closer.append(one, pieces);
    for (const Closing& end : one.ends)
      if (end.link) links.push_back(*end.link);
  }
  // Lines that end at the same place share one link.
  std::sort(links.begin(), links.end());
  const auto same = [](const Link& a, const Link& b) { return a.ends == b.ends; };
  links.erase(std::unique(links.begin(), links.end(), same), links.end());
  for (const Link& link : links) pieces.push_back(closer.drawn(link));
  check(pieces.size() <= left.size() + links.size() && links.size() <= 2 * left.size(), "an end has one link at most");
  return pieces;
}

}  // namespace epura::drawing
