// SPDX-License-Identifier: Apache-2.0
// Whether a sheet defines a part: what its faces can still do, by the rank of what is said of them. Which features they
// form is of no concern.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "definition/rules.hpp"

namespace epura::definition {

/// A change of the part that nothing on the sheet forbids, relative to as many faces as possible.
struct Motion {
  std::vector<int> faces;  ///< that change, ascending
  Row change;              ///< tidy: what each unknown changes by
};

enum class FaceState : unsigned char { fixed, free, uncertain, by_model };

struct Account {
  int needed = 0;                 ///< independent numbers that define the part beside the rules
  std::vector<Motion> motions;    ///< one for each that is missing
  std::vector<FaceState> states;  ///< of each face; `uncertain` where only doubtful statements hold it, or a rank is
  /// Numbers of dimensions of which the first follows from the others. It stands alone if the rules say it.
  std::vector<std::vector<int>> repeated;
  std::vector<char> follows;  ///< of each dimension: whether all that it says follows from those before it
  std::vector<std::vector<int>> contradictory;  ///< those of them whose texts cannot all be true
  bool is_certain = true;                       ///< the ranks are proved, and no statement in doubt matters

  [[nodiscard]] bool is_complete() const;
};

/// Six rows that hold the largest faces still, as datum features are chosen, those that are fixed before others:
/// whatever the part does as a whole is then nothing. Each is one unknown. `states` are those of the faces, if known.
std::vector<Row> base_rows(const Part& part, const Unknowns& unknowns, std::span<const FaceState> states = {});

/// The part has common directions (see with_common_directions); rules are certain.
Account take_account(const Part& part, const Unknowns& unknowns, std::span<const Statement> rules,
                     std::span<const Statement> dimensions);

}  // namespace epura::definition
