// SPDX-License-Identifier: Apache-2.0
// How much of one kind a test tries.
#pragma once

#include <cstdlib>

namespace epura::test {

/// Whether tests may take minutes: $EPURA_AT_LENGTH is set by `tests/run --nightly`. At every change, they try each
/// kind.
inline bool at_length() { return std::getenv("EPURA_AT_LENGTH") != nullptr; }

}  // namespace epura::test
