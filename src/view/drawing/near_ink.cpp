// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_ink.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/close_ends.hpp"
#include "drawing/limits.hpp"
#include "drawing/near_prefilter.hpp"
#include "drawing/near_search.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

namespace {

// Sorts parts by piece, merges those that continue each other, and adds whole pieces that are not ink.
std::vector<InkPart> joined_parts(std::vector<InkPart> parts, const std::vector<signed char>& strength) {
  for (std::size_t i = 0; i < strength.size(); ++i)
    if (strength[i] < 0) parts.push_back({static_cast<int>(i), 0, 1});
  parallel_sort(parts.begin(), parts.end());
  std::size_t kept = 0;
  for (const InkPart& part : parts)
    if (kept > 0 && parts[kept - 1].piece == part.piece && parts[kept - 1].to >= part.from)
      parts[kept - 1].to = std::max(parts[kept - 1].to, part.to);
    else
      parts[kept++] = part;
  parts.resize(kept);
  for (const InkPart& part : parts) check(part.from <= part.to, "a part of a line goes forwards");
  return parts;
}

}  // namespace

std::vector<Piece> join_near(std::vector<Piece> pieces, const std::vector<signed char>& strength, double distance,
                             double touching, const Progress& progress) {
  if (!(distance > touching) || pieces.empty()) return pieces;
  progress.begin("joining near lines", pieces.size());
  const AlongLimits limits{distance, touching};
  const NearPrefilter prefilter(pieces, Polylines(pieces, strength, progress), limits, progress);
  NearSearch search(pieces, prefilter, limits);
  search.add_all(progress);
  if (search.taken().parts.empty()) return pieces;
  std::vector<InkPart> left = search.kept().all();
  left.insert(left.end(), search.dangles().begin(), search.dangles().end());
  return close_ends(search.kept(), search.taken(), joined_parts(std::move(left), strength),
                    {touching, max_extension * distance}, progress);
}

}  // namespace epura::drawing
