// SPDX-License-Identifier: Apache-2.0
// Exact drawings on request, each by `epura draw` in a process of its own: a newer request of the same page, or a
// limit, ends it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/run_epura.hpp"
#include "serve/http/library.hpp"
#include "serve/serve.hpp"

namespace epura {

class Drawings {
 public:
  using Clock = std::chrono::steady_clock;
  using SendReply = std::function<void(std::uint64_t request, http::Reply reply)>;

  Drawings(const ServeOptions& options, SendReply reply);

  /// Draws as soon as fewer than two others are being drawn. `page`: who asks; empty: not said, and takes
  /// nobody's place.
  void ask(std::uint64_t request, const std::string& page, const std::string& projection);
  /// Descriptors that become readable when there is something to do.
  [[nodiscard]] std::vector<int> descriptors();
  /// When there is something to do in any case.
  [[nodiscard]] Clock::time_point deadline() const;
  /// Replies for what has ended, and starts what waits.
  void look();

 private:
  struct Job {
    std::uint64_t request;
    std::string page, projection;
    std::unique_ptr<EpuraProcess> process{};  ///< null: it waits
    Clock::time_point until{};
  };

  bool start(Job& job);
  bool has_ended(Job& job);

  const ServeOptions& options_;
  SendReply reply_;
  std::list<Job> jobs_{};  ///< in the order of their requests
};

/// The words of the command for a drawing, with standard output as SVG.
std::vector<std::string> words_of_drawing(const ServeOptions& options, const std::string& projection);

/// The same as a line for a shell up to the projection, and what follows it.
std::pair<std::string, std::string> command_around_projection(const ServeOptions& options);

}  // namespace epura
