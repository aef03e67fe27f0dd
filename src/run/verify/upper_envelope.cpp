// SPDX-License-Identifier: Apache-2.0
#include "verify/upper_envelope.hpp"

#include <algorithm>

namespace epura::verify {

namespace {

class Merger {
 public:
  explicit Merger(const Slice& slice) : slice_(slice) {}

  [[nodiscard]] std::vector<SeenPart> envelope(const std::vector<int>& pieces, std::size_t begin,
                                               std::size_t end) const {
    if (begin == end) return {};
    if (end - begin == 1) {
      const SlicePiece& piece = slice_.pieces[pieces[begin]];
      return {{piece.u[0], piece.u[1], pieces[begin]}};
    }
    const std::size_t middle = begin + (end - begin) / 2;
    return merge(envelope(pieces, begin, middle), envelope(pieces, middle, end));
  }

 private:
  static void add(std::vector<SeenPart>& list, double from, double to, int piece) {
    if (!(from < to)) return;
    if (!list.empty() && list.back().piece == piece && list.back().to == from)
      list.back().to = to;
    else
      list.push_back({from, to, piece});
  }

  // For an interval that both pieces cover: two straight lines, which cross at most once.
  void add_nearer(std::vector<SeenPart>& list, double from, double to, int a, int b) const {
    const SlicePiece &first = slice_.pieces[a], &second = slice_.pieces[b];
    const double at_from = first.depth_at(from) - second.depth_at(from);
    const double at_to = first.depth_at(to) - second.depth_at(to);
    if (at_from >= 0 && at_to >= 0) return add(list, from, to, a);
    if (at_from <= 0 && at_to <= 0) return add(list, from, to, b);
    const double cross = std::clamp(from + at_from / (at_from - at_to) * (to - from), from, to);
    add(list, from, cross, at_from > 0 ? a : b);
    add(list, cross, to, at_from > 0 ? b : a);
  }

  [[nodiscard]] std::vector<SeenPart> merge(const std::vector<SeenPart>& a, const std::vector<SeenPart>& b) const {
    std::vector<SeenPart> result;
    std::size_t i = 0, j = 0;
    double at = -HUGE_VAL;
    while (i < a.size() || j < b.size()) {
      const bool in_a = i < a.size() && a[i].from <= at, in_b = j < b.size() && b[j].from <= at;
      double next = HUGE_VAL;
      if (i < a.size()) next = std::min(next, in_a ? a[i].to : a[i].from);
      if (j < b.size()) next = std::min(next, in_b ? b[j].to : b[j].from);
      if (in_a && in_b)
        add_nearer(result, at, next, a[i].piece, b[j].piece);
      else if (in_a || in_b)
        add(result, at, next, in_a ? a[i].piece : b[j].piece);
      at = next;
      while (i < a.size() && a[i].to <= at) ++i;
      while (j < b.size() && b[j].to <= at) ++j;
    }
    return result;
  }

  const Slice& slice_;
};

}  // namespace

std::vector<SeenPart> upper_envelope(const Slice& slice) {
  std::vector<int> wide;
  for (std::size_t i = 0; i < slice.pieces.size(); ++i)
    if (slice.pieces[i].width() > 0) wide.push_back(static_cast<int>(i));
  // Adjacent pieces first: halves that do not overlap are merged without comparisons.
  std::ranges::stable_sort(wide, {}, [&](int i) { return slice.pieces[i].u[0]; });
  return Merger(slice).envelope(wide, 0, wide.size());
}

}  // namespace epura::verify
