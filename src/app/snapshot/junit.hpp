// SPDX-License-Identifier: Apache-2.0
// Formats results as JUnit XML for CI servers.
#pragma once

#include <string>
#include <vector>

#include "app/snapshot/cases.hpp"

namespace epura {

/// Returns JUnit XML for Jenkins and GitLab: a case that differs is a <failure>, one that could not be drawn is an
/// <error>. Times are omitted, so that equal results give equal bytes.
std::string junit_report(const std::vector<SnapshotResult>& results);

}  // namespace epura
