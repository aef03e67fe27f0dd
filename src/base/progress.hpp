// What a run tells while it works, and what it asks: how far it is, and whether its time is over. Stages take a
// Progress; made from nothing, it does nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace epura {

/// How far a stage is.
struct Standing {
  std::string stage;
  std::size_t done = 0, work = 0;  ///< work 0: not known
  double seconds = 0;              ///< since it began
};

/// Seconds until a stage ends that goes on as fast as so far; nothing while that cannot be told.
std::optional<double> seconds_left(const Standing& standing);

/// Where the stages of a run write and somebody else reads, on any threads.
class ProgressBoard {
 public:
  void begin(std::string_view stage, std::size_t work);
  void advance(std::size_t done) { done_.fetch_add(done, std::memory_order_relaxed); }
  [[nodiscard]] Standing standing() const;

  /// Since the board was made.
  [[nodiscard]] double seconds() const;

  /// Whoever ends the process from outside locks it first.
  [[nodiscard]] std::timed_mutex& ending() { return ending_; }

 private:
  using Clock = std::chrono::steady_clock;

  const Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> done_ = 0;
  mutable std::mutex stage_mutex_;  // of the next three
  std::string stage_;
  std::size_t work_ = 0;
  Clock::time_point begun_ = start_;
  std::timed_mutex ending_;
};

/// A stage's way to the board, to be copied freely.
class Progress {
 public:
  Progress() = default;
  /// `time_limit` in seconds since the board was made; nothing: no limit.
  explicit Progress(ProgressBoard& board, std::optional<double> time_limit = std::nullopt)
      : board_(&board), time_limit_(time_limit) {}

  /// A stage begins; `work` is what its calls of `advance` will add up to, 0 when not known.
  void begin(std::string_view stage, std::size_t work = 0) const {
    if (board_ != nullptr) board_->begin(stage, work);
  }
  /// From any thread, but seldom: once for a batch.
  void advance(std::size_t done) const {
    if (board_ != nullptr) board_->advance(done);
  }
  [[nodiscard]] bool is_limited() const { return time_limit_.has_value(); }
  /// Whether what is not decided yet is to be left out. Without a time limit it costs nothing, with one a look at the
  /// clock.
  [[nodiscard]] bool is_out_of_time() const { return is_limited() && board_->seconds() >= *time_limit_; }
  /// For a stage that is to leave half of the time that is left to those behind it.
  [[nodiscard]] Progress with_half_the_time() const {
    return is_limited() ? Progress(*board_, (board_->seconds() + *time_limit_) / 2) : *this;
  }
  /// While it lives, the run is not cancelled: for moments that would leave files behind.
  [[nodiscard]] std::unique_lock<std::timed_mutex> undisturbed() const {
    if (board_ == nullptr) return {};
    return std::unique_lock(board_->ending());
  }

 private:
  ProgressBoard* board_ = nullptr;
  std::optional<double> time_limit_;
};

}  // namespace epura
