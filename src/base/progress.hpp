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
  /// `time_limit` in seconds from now.
  explicit ProgressBoard(std::optional<double> time_limit = std::nullopt) : time_limit_(time_limit) {}

  void begin(std::string_view stage, std::size_t work);
  void advance(std::size_t done) { done_.fetch_add(done, std::memory_order_relaxed); }
  [[nodiscard]] Standing standing() const;

  [[nodiscard]] bool is_limited() const { return time_limit_.has_value(); }
  [[nodiscard]] bool is_out_of_time();

  /// Whoever ends the process from outside locks it first.
  [[nodiscard]] std::timed_mutex& ending() { return ending_; }

 private:
  using Clock = std::chrono::steady_clock;

  const Clock::time_point start_ = Clock::now();
  const std::optional<double> time_limit_;
  std::atomic<bool> over_ = false;
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
  explicit Progress(ProgressBoard& board) : board_(&board) {}

  /// A stage begins; `work` is what its calls of `advance` will add up to, 0 when not known.
  void begin(std::string_view stage, std::size_t work = 0) const {
    if (board_ != nullptr) board_->begin(stage, work);
  }
  /// From any thread, but seldom: once for a batch.
  void advance(std::size_t done) const {
    if (board_ != nullptr) board_->advance(done);
  }
  [[nodiscard]] bool is_limited() const { return board_ != nullptr && board_->is_limited(); }
  /// Whether what is not decided yet is to be left out. Without a time limit it costs nothing, with one a look at the
  /// clock.
  [[nodiscard]] bool is_out_of_time() const { return is_limited() && board_->is_out_of_time(); }
  /// While it lives, the run is not cancelled: for moments that would leave files behind.
  [[nodiscard]] std::unique_lock<std::timed_mutex> undisturbed() const {
    if (board_ == nullptr) return {};
    return std::unique_lock(board_->ending());
  }

 private:
  ProgressBoard* board_ = nullptr;
};

}  // namespace epura
