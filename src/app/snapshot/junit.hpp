// SPDX-License-Identifier: Apache-2.0
// Results as JUnit XML for CI servers.
#pragma once

#include <string>
#include <vector>

#include "app/snapshot/cases.hpp"

namespace epura {

/// JUnit XML as Jenkins and GitLab take it: a case that differs is a <failure>, one that could not be drawn an <error>.
/// No times: the same results give the same bytes.
std::string junit_report(const std::vector<SnapshotResult>& results);

}  // namespace epura
