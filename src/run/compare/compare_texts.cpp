// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "compare/align_views.hpp"
#include "compare/page_differences.hpp"

namespace epura::compare {

namespace {

using Texts = std::vector<PictureText>;

auto by_place(const PictureText& t) { return std::tie(t.words, t.min.x, t.min.y, t.max.x, t.max.y); }

Vec2 middle(const PictureText& t) { return (t.min + t.max) / 2.0; }
Vec2 size(const PictureText& t) { return t.max - t.min; }

double apart(const PictureText& a, const PictureText& b) {
  return std::max(glm::distance(a.min, b.min), glm::distance(a.max, b.max));
}

// Whether the boxes overlap.
bool overlap(const PictureText& a, const PictureText& b) {
  return glm::all(glm::lessThan(glm::max(a.min, b.min), glm::min(a.max, b.max)));
}

class TextPairs {
 public:
  TextPairs(const Picture& before, const Picture& after, double tolerance)
      : before_(before), after_(after), old_(before.texts), new_(after.texts), tolerance_(tolerance) {
    const auto earlier = [](const PictureText& a, const PictureText& b) { return by_place(a) < by_place(b); };
    std::sort(old_.begin(), old_.end(), earlier);
    std::sort(new_.begin(), new_.end(), earlier);
  }

  TextDifferences compare() {
    const double near = std::max(tolerance_, rounding);
    each_pair(
        [&](const PictureText& a, const PictureText& b) { return pair_if(a.words == b.words, apart(a, b), near); },
        std::nullopt);
    each_pair(
        [&](const PictureText& a, const PictureText& b) {
          const bool same = a.words == b.words && glm::distance(size(a), size(b)) <= near;
          return pair_if(same, apart(a, b), overlap(a, b) ? HUGE_VAL : max_moved);
        },
        Change::moved);
    each_pair([&](const PictureText& a,
                  const PictureText& b) { return pair_if(a.words == b.words && overlap(a, b), apart(a, b), HUGE_VAL); },
              Change::restyled);
    // Notes of one kind belong together wherever they stand; plain lengths only where they do.
    each_pair(
        [&](const PictureText& a, const PictureText& b) {
          return pair_if(is_same_view(a, b) && is_note(a) && !changed_places(a, b) && is_size(a, b), apart(a, b),
                         HUGE_VAL);
        },
        Change::text);
    each_pair(
        [&](const PictureText& a, const PictureText& b) {
          return pair_if(overlap(a, b) && !changed_places(a, b), glm::distance(middle(a), middle(b)), HUGE_VAL);
        },
        Change::text);
    // In views whose sizes changed, texts move farther than they would by themselves.
    each_pair(
        [&](const PictureText& a, const PictureText& b) {
          return pair_if(is_same_view(a, b) && a.words == b.words, apart(a, b), HUGE_VAL);
        },
        Change::moved);
    each_pair([&](const PictureText& a,
                  const PictureText& b) { return pair_if(is_same_view(a, b) && is_size(a, b), apart(a, b), HUGE_VAL); },
              Change::text);
    for (const PictureText& text : old_) report(Change::removed, text, {text.words, ""});
    for (const PictureText& text : new_) report(Change::added, text, {"", text.words});
    return std::move(found_);
  }

 private:
  static constexpr double rounding = 0.01;  // mm: of files, and of PDF's thousandths of letters a centimetre high

  [[nodiscard]] bool is_same_view(const PictureText& a, const PictureText& b) const {
    const std::string& view = before_.views[static_cast<std::size_t>(a.view)];
    return !view.empty() && view != "sheet" && view == after_.views[static_cast<std::size_t>(b.view)];
  }

  // Whether each is in the other drawing, too: dimensions that are arranged anew change places.
  [[nodiscard]] bool changed_places(const PictureText& a, const PictureText& b) const {
    const auto has_words_of = [](const PictureText& text) {
      return [&text](const PictureText& other) { return other.words == text.words; };
    };
    return is_same_view(a, b) && std::ranges::any_of(new_, has_words_of(a)) &&
           std::ranges::any_of(old_, has_words_of(b));
  }

  static bool is_note(const PictureText& text) {
    return text.words.find_first_not_of("0123456789.,") != std::string::npos;
  }

  // Whether both are values of one size, in one direction.
  [[nodiscard]] bool is_size(const PictureText& a, const PictureText& b) const {
    Difference sizes;
    sizes.view = before_.views[static_cast<std::size_t>(a.view)];
    sizes.before = a.words;
    sizes.after = b.words;
    const bool is_level = size(a).x >= size(a).y;
    return is_level == (size(b).x >= size(b).y) && !measured_by(sizes).empty();
  }

  static std::optional<double> pair_if(bool alike, double distance, double max) {
    return alike && distance <= max ? std::optional(distance) : std::nullopt;
  }

  // Pairs each old text with the nearest new one for which `measure` gives a distance, and removes both from the lists.
  template <class Measure>
  void each_pair(const Measure& measure, std::optional<Change> change) {
    Texts left;
    for (const PictureText& a : old_) {
      auto nearest = new_.end();
      double min = HUGE_VAL;
      for (auto b = new_.begin(); b != new_.end(); ++b) {
        const std::optional<double> distance = measure(a, *b);
        if (distance && *distance < min) std::tie(nearest, min) = std::pair(b, *distance);
      }
      if (nearest == new_.end()) {
        left.push_back(a);
        continue;
      }
      meet(a, *nearest, change);
      new_.erase(nearest);
    }
    old_ = std::move(left);
  }

  void meet(const PictureText& a, const PictureText& b, std::optional<Change> change) {
    if (!change) {
      found_.marked.push_back({b, Mark::same});
      return;
    }
    report(*change, b, {a.words, b.words});
    if (*change != Change::moved) return;
    Difference& moved = found_.differences.back();
    moved.distance = apart(a, b);
    moved.old_from = a.min;
    moved.old_to = a.max;
  }

  // `words`: before and after.
  void report(Change change, const PictureText& text, const std::array<std::string, 2>& words) {
    const Picture& picture = change == Change::removed ? before_ : after_;
    found_.marked.push_back({text, change == Change::removed ? Mark::removed
                                   : change == Change::added ? Mark::added
                                                             : Mark::changed});
    Difference& found = found_.differences.emplace_back();
    found.change = change;
    found.view = picture.views[static_cast<std::size_t>(text.view)];
    found.before = words[0];
    found.after = words[1];
    found.from = text.min;
    found.to = text.max;
    found.is_text = true;
  }

  const Picture &before_, &after_;
  Texts old_, new_;
  double tolerance_;
  TextDifferences found_{};
};

}  // namespace

TextDifferences compare_texts(const Picture& before, const Picture& after, double tolerance) {
  return TextPairs(before, after, tolerance).compare();
}

}  // namespace epura::compare
