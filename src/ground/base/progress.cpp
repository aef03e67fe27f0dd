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
  {
    const std::lock_guard lock(stage_mutex_);
    stage_ = stage;
    work_ = work;
    begun_ = Clock::now();
    done_ = 0;
  }
  if (!observer_.tell) return;
  const std::lock_guard lock(told_mutex_);
  told_percent_ = 0;
  observer_.tell(std::string(stage), 0);
}

void ProgressBoard::advance(std::size_t done) {
  done_.fetch_add(done, std::memory_order_relaxed);
  if (!observer_.tell) return;
  const std::lock_guard lock(told_mutex_);
  const Standing now = standing();
  if (now.work == 0 || now.done > now.work) return;
  const double part = static_cast<double>(now.done) / static_cast<double>(now.work);
  const int percent = static_cast<int>(100 * part);
  if (percent <= told_percent_) return;
  told_percent_ = percent;
  observer_.tell(now.stage, part);
}

Standing ProgressBoard::standing() const {
  const std::lock_guard lock(stage_mutex_);
  return {stage_, done_.load(std::memory_order_relaxed), work_, seconds_since(begun_)};
}

double ProgressBoard::seconds() const { return clock_ ? clock_() : seconds_since(start_); }

}  // namespace epura
