// SPDX-License-Identifier: Apache-2.0
// Destinations of messages for the user of a run.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace epura::pipeline {

struct Messages {
  std::function<void(const std::string& sentence)> warn;
  std::function<void(std::string_view lines)> print;
};

inline Messages silent_messages() {
  return {[](const std::string&) {}, [](std::string_view) {}};
}

/// Messages of an attempt, told when it is known to be the last.
class HeldMessages {
 public:
  Messages messages() {
    return {[this](const std::string& sentence) { held_.emplace_back(true, sentence); },
            [this](std::string_view lines) { held_.emplace_back(false, lines); }};
  }
  void tell(const Messages& messages) const {
    for (const auto& [warns, text] : held_) warns ? messages.warn(text) : messages.print(text);
  }

 private:
  std::vector<std::pair<bool, std::string>> held_;
};

}  // namespace epura::pipeline
