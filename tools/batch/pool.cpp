// SPDX-License-Identifier: Apache-2.0
#include "batch/pool.hpp"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "foreign/child_process.hpp"

namespace epura {

namespace {

using foreign::Clock;

constexpr std::size_t max_of_answer = 1 << 28;
// A process that needed much memory for a job is not kept, since a fragmented heap keeps much of it.
constexpr double much_memory = 1000;  // MB

struct Worker {
  foreign::ChildProcess process{};
  std::optional<std::size_t> job{};
  Clock::time_point begun{};
};

class Pool {
 public:
  Pool(const BatchPlan& plan, std::vector<std::size_t> numbers, const PoolLimits& limits,
       const std::function<void(JobResult)>& take)
      : plan_(plan), limits_(limits), take_(take), waiting_(std::move(numbers)) {
    const auto is_shorter = [&](std::size_t a, std::size_t b) { return plan.jobs[a].estimate < plan.jobs[b].estimate; };
    std::reverse(waiting_.begin(), waiting_.end());
    std::stable_sort(waiting_.begin(), waiting_.end(), is_shorter);
    const auto workers = std::min(static_cast<std::size_t>(limits.workers), waiting_.size());
    for (std::size_t i = 0; i < workers; ++i) workers_.push_back(std::make_unique<Worker>());
  }

  void run() {
    while (true) {
      bool is_busy = false;
      for (const auto& worker : workers_) {
        if (!worker->job && !waiting_.empty()) give_job(*worker);
        is_busy = is_busy || worker->job;
      }
      if (!is_busy && waiting_.empty()) return;
      wait();
      for (const auto& worker : workers_)
        if (worker->job) look_at(*worker);
    }
  }

 private:
  void give_job(Worker& worker) {
    worker.job = waiting_.back();
    waiting_.pop_back();
    worker.begun = Clock::now();
    if (!worker.process.is_there()) worker.process.fork([this](int socket) { serve_jobs(socket, plan_); });
    foreign::Packer message;
    message(*worker.job);
    try {
      worker.process.send(message);
    } catch (const Error& error) {
      fail(worker, error.what());
    }
  }

  [[nodiscard]] std::optional<Clock::time_point> end_of(const Worker& worker) const {
    if (!worker.job || !limits_.job_seconds) return std::nullopt;
    return worker.begun +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*limits_.job_seconds));
  }

  // Waits for a message or for the end of the time of a job.
  void wait() const {
    std::vector<pollfd> sockets;
    constexpr int longest_wait = 1000;  // ms
    int wait_ms = longest_wait;
    for (const auto& worker : workers_) {
      if (!worker->job) continue;
      sockets.push_back({worker->process.socket(), POLLIN, 0});
      if (const auto end = end_of(*worker)) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
        wait_ms = static_cast<int>(std::clamp<long long>(left, 0, wait_ms));
      }
    }
    if (!sockets.empty()) ::poll(sockets.data(), sockets.size(), wait_ms);
  }

  void look_at(Worker& worker) {
    try {
      if (const auto message = worker.process.receive(Clock::now(), max_of_answer)) {
        JobResult result = unpack_result(*message);
        result.record.name = plan_.jobs[*worker.job].name;
        worker.job.reset();
        if (result.record.megabytes > much_memory) worker.process.end();
        take_(std::move(result));
      } else if (const auto end = end_of(worker); end && Clock::now() >= *end) {
        worker.process.end();
        fail(worker, "takes more than " + format_number(*limits_.job_seconds) + " s");
      }
    } catch (const Error& error) {
      worker.process.end();
      fail(worker, error.what());
    }
  }

  // The process is gone; the next job gets another one.
  void fail(Worker& worker, const std::string& reason) {
    const std::size_t number = *std::exchange(worker.job, std::nullopt);
    const double seconds = std::chrono::duration<double>(Clock::now() - worker.begun).count();
    const Job& job = plan_.jobs[number];
    take_({number,
           false,
           {.name = job.name, .code = crashed_exit_code, .seconds = seconds, .messages = {job.name + ": " + reason}}});
  }

  const BatchPlan& plan_;
  const PoolLimits& limits_;
  const std::function<void(JobResult)>& take_;
  std::vector<std::size_t> waiting_;  // the next one last
  std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace

void do_jobs(const BatchPlan& plan, std::vector<std::size_t> numbers, const PoolLimits& limits,
             const std::function<void(JobResult)>& take) {
  Pool(plan, std::move(numbers), limits, take).run();
}

}  // namespace epura
