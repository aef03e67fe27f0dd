// SPDX-License-Identifier: Apache-2.0
#include "base/progress.hpp"

namespace epura {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::optional<double> seconds_left(const Standing& standing) {
  if (standing.done == 0 || standing.done > standing.work) return std::nullopt;
  return standing.seconds * static_cast<double>(standing.work - standing.done) / static_cast<double>(standing.done);
}

void ProgressBoard::begin(std::string_view stage, std::size_t work) {
  const std::lock_guard lock(stage_mutex_);
  stage_ = stage;
  work_ = work;
  begun_ = Clock::now();
  done_ = 0;
}

Standing ProgressBoard::standing() const {
  const std::lock_guard lock(stage_mutex_);
  return {stage_, done_.load(std::memory_order_relaxed), work_, seconds_since(begun_)};
}

double ProgressBoard::seconds() const { return clock_ ? clock_() : seconds_since(start_); }

}  // namespace epura
