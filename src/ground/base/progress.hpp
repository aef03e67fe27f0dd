// SPDX-License-Identifier: Apache-2.0
// Progress of a run, and its deadline. Stages receive a Progress, report how much is done, and ask whether time is up;
// a default-constructed one does nothing. When time is up, a stage either returns what it has, if that is right, or
// throws OutOfTime.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

namespace epura {

/// Thrown by a stage whose partial result is useless. The caller decides how the run continues.
struct OutOfTime {
  std::string stage;
};

/// Thrown when the observer of the run asks it to end.
struct Stopped {};

/// Observes a run.
struct Observer {
  /// Called when a stage begins, and at each further percent of it; from any thread, never concurrently.
  std::function<void(const std::string& stage, double done)> tell{};
  std::stop_token stop{};
};

/// The state of a stage.
struct Standing {
  std::string stage;
  std::size_t done = 0, work = 0;  ///< work 0: unknown
  double seconds = 0;              ///< since the stage began
};

/// Estimated seconds until a stage ends at its current speed; empty while unknown.
std::optional<double> seconds_left(const Standing& standing);

/// Stages of a run write here, and others read, on any threads.
class ProgressBoard {
 public:
  ProgressBoard() = default;
  /// With its own clock, which returns seconds since the board was made and is usable from any thread: a test can let
  /// time run out where it likes.
  explicit ProgressBoard(std::function<double()> clock) : clock_(std::move(clock)) {}

  void begin(std::string_view stage, std::size_t work);
  void advance(std::size_t done);
  /// To be called before the run begins.
  void observe(Observer observer) { observer_ = std::move(observer); }
  [[nodiscard]] bool is_stopped() const { return observer_.stop.stop_requested(); }
  [[nodiscard]] Standing standing() const;

  /// Seconds since the board was made.
  [[nodiscard]] double seconds() const;

  /// Only output remains to be written: how long that takes depends on its destination.
  void lift_limit() { has_limit_ = false; }
  [[nodiscard]] bool has_limit() const { return has_limit_; }

  /// To be locked by whoever ends the process from outside.
  [[nodiscard]] std::timed_mutex& ending() { return ending_; }

 private:
  using Clock = std::chrono::steady_clock;

  const Clock::time_point start_ = Clock::now();
  std::function<double()> clock_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> has_limit_ = true;
  mutable std::mutex stage_mutex_;  // protects the next three
  std::string stage_;
  std::size_t work_ = 0;
  Clock::time_point begun_ = start_;
  std::timed_mutex ending_;
  Observer observer_;
  std::mutex told_mutex_;  // protects the next one
  int told_percent_ = 0;
};

/// A stage's access to the board; may be copied freely.
class Progress {
 public:
  Progress() = default;
  /// `time_limit` in seconds since the board was made; nothing: no limit.
  explicit Progress(ProgressBoard& board, std::optional<double> time_limit = std::nullopt)
      : board_(&board), time_limit_(time_limit) {}

  /// Begins a stage; `work` is the sum of its calls of `advance`, 0 if unknown.
  void begin(std::string_view stage, std::size_t work = 0) const {
    if (board_ != nullptr) board_->begin(stage, work);
  }
  /// May be called from any thread, but rarely: once for a batch.
  void advance(std::size_t done) const {
    if (board_ != nullptr) board_->advance(done);
  }
  [[nodiscard]] bool is_limited() const { return time_limit_.has_value(); }
  /// Whether everything not decided yet is to be left out. Free of cost without a time limit; with one, it checks the
  /// clock.
  [[nodiscard]] bool is_out_of_time() const {
    return (is_limited() && board_->seconds() >= *time_limit_) || is_stopped();
  }
  /// Throws Stopped.
  void expect_not_stopped() const {
    if (is_stopped()) throw Stopped{};
  }
  /// For stages whose partial results are useless. Throws OutOfTime and Stopped.
  void expect_time() const {
    expect_not_stopped();
    if (is_out_of_time()) throw OutOfTime{board_->standing().stage};
  }
  /// For a stage that must leave the rest of the remaining time to those after it.
  [[nodiscard]] Progress with_part_of_the_time(double part) const {
    if (!is_limited()) return *this;
    const double now = board_->seconds();
    return Progress(*board_, now + part * (*time_limit_ - now));
  }
  /// For work that begins when time is up and completes what was begun before.
  [[nodiscard]] Progress with_more_time(double seconds) const {
    return is_limited() ? Progress(*board_, *time_limit_ + seconds) : *this;
  }
  /// For work that takes hardly any time and has to be done.
  [[nodiscard]] Progress without_limit() const { return board_ == nullptr ? *this : Progress(*board_); }
  [[nodiscard]] std::optional<double> time_limit() const { return time_limit_; }
  /// Only output remains to be written.
  void lift_limit() const {
    if (board_ != nullptr) board_->lift_limit();
  }
  /// During its lifetime, the run is not cancelled: for moments in which files would be left behind.
  [[nodiscard]] std::unique_lock<std::timed_mutex> undisturbed() const {
    if (board_ == nullptr) return {};
    return std::unique_lock(board_->ending());
  }

 private:
  [[nodiscard]] bool is_stopped() const { return board_ != nullptr && board_->is_stopped(); }

  ProgressBoard* board_ = nullptr;
  std::optional<double> time_limit_;
};

/// For loops over very many small items: reports progress and checks the clock at intervals.
class Pace {
 public:
  /// `work` is the remaining work of the stage.
  Pace(const Progress& progress, std::size_t work) : progress_(progress), left_(work) {}
  Pace(const Pace&) = delete;
  Pace& operator=(const Pace&) = delete;

  /// Reports how much work remains. Throws OutOfTime.
  void left(std::size_t work) {
    if (++calls_ % calls_a_look != 0) return;
    progress_.advance(left_ - work);
    left_ = work;
    progress_.expect_time();
  }

 private:
  static constexpr std::size_t calls_a_look = 1024;

  const Progress& progress_;
  std::size_t left_, calls_ = 0;
};

/// Returns what `make(progress)` returns. If it runs out of time, `leave_out(stage)` removes most of its input, and
/// `make` is called again, each time with half of the time that `last` has left; without a limit once `leave_out`
/// returns that next to nothing is left.
template <class Make, class LeaveOut>
auto make_in_time(const Progress& first, const Progress& last, const Make& make, const LeaveOut& leave_out) {
  Progress progress = first;
  while (true) {
    try {
      return make(progress);
    } catch (const OutOfTime& cut) {
      const bool is_little = leave_out(cut.stage);
      progress = is_little ? last.without_limit() : last.with_part_of_the_time(0.5);
    }
  }
}

}  // namespace epura
