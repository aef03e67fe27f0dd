// SPDX-License-Identifier: Apache-2.0
// Views that stand elsewhere on their sheet, and what follows from sizes that changed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace epura::compare {

/// Moves the content of each view of `before` to where most of its lines stand in `after`, if more of them stand there
/// than where they are, by more than the tolerance. Returns a difference for each move, with the views that have it in
/// common. The sheet itself stays.
std::vector<Difference> align_views(Picture& before, const Picture& after, double tolerance);

/// If sizes changed, removes the differences that follow from them: of lines of one view whose ends moved along one
/// axis only, by no more than most of the lines did, of dimension and centre lines, and of texts that only moved. If
/// texts were added or removed, those of dimension and centre lines, and of texts that only moved.
/// Returns how many there were.
std::size_t take_followers(std::vector<Difference>& differences, double tolerance);

/// What a changed text of a view measures: "height", "diameter" ...; empty if it is not known to be a size.
std::string measured_by(const Difference& text);

}  // namespace epura::compare
