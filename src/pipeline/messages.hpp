// SPDX-License-Identifier: Apache-2.0
// Destinations of messages for the user of a run.
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
