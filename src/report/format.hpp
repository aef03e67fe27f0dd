// SPDX-License-Identifier: Apache-2.0
// Formats the findings of a run as sentences.
#pragma once

#include <string>

#include "report/report.hpp"

namespace epura::report {

/// One sentence per line.
std::string format_verification(const Verification& verification);

}  // namespace epura::report
