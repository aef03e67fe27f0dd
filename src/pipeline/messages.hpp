// SPDX-License-Identifier: Apache-2.0
// Where a run says what its user should know, while it goes on.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace epura::pipeline {

struct Messages {
  std::function<void(const std::string& sentence)> warn;
  std::function<void(std::string_view lines)> print;
};

}  // namespace epura::pipeline
