// SPDX-License-Identifier: Apache-2.0
// Formats results as JUnit XML for CI servers.
#pragma once

#include <string>
#include <vector>

namespace epura {

/// `failure`: the result is not as expected; `error`: there is no result.
enum class TestVerdict { passed, failure, error };

struct TestCase {
  std::string name;
  TestVerdict verdict;
  std::string words;  ///< reasons, one a line; the first one is the summary
};

/// Returns JUnit XML for Jenkins and GitLab. Times are omitted, so that equal results give equal bytes.
std::string junit_report(const std::string& suite, const std::string& class_name, const std::vector<TestCase>& cases);

}  // namespace epura
