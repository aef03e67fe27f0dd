// SPDX-License-Identifier: Apache-2.0
// Tables of what tests of plugins found.
#pragma once

#include "foreign/check_result.hpp"

namespace epura {

/// Prints a line for a result, and one for its fault.
void print_check(const foreign::CheckResult& result);

}  // namespace epura
