// SPDX-License-Identifier: Apache-2.0
// Findings of a run as sentences.
#pragma once

#include <string>

#include "report/report.hpp"

namespace epura::report {

/// One sentence a line.
std::string format_verification(const Verification& verification);

}  // namespace epura::report
