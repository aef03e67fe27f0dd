// SPDX-License-Identifier: Apache-2.0
#include "app/progress_line.hpp"

#include <algorithm>
#include <cmath>

namespace epura {

namespace {

constexpr std::size_t bar_width = 20;
constexpr std::size_t name_width = 22;  // keeps the bar at the same position in all stages
constexpr double longest = 360'000;     // seconds: a hundred hours

std::string two_digits(long long number) { return (number < 10 ? "0" : "") + std::to_string(number); }

std::string bar(double part) {
  const auto full = static_cast<std::size_t>(part * bar_width);
  return "[" + std::string(full, '#') + std::string(bar_width - full, '-') + "]";
}

}  // namespace

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::min(seconds, longest)));
  const long long minutes = whole / 60;
  if (minutes < 60) return std::to_string(minutes) + ":" + two_digits(whole % 60);
  return std::to_string(minutes / 60) + ":" + two_digits(minutes % 60) + ":" + two_digits(whole % 60);
}

std::optional<double> TimeLeft::at(const Standing& standing) {
  if (standing.stage != stage_ || standing.done < done_) {
    stage_ = standing.stage;
    end_.reset();
  } else if (standing.done == done_ && end_) {
    return *end_ > standing.seconds ? std::optional(*end_ - standing.seconds) : std::nullopt;
  }
  done_ = standing.done;
  const std::optional<double> left = seconds_left(standing);
  if (left) end_ = std::min(end_.value_or(HUGE_VAL), standing.seconds + *left);
  return left && *end_ >= standing.seconds ? std::optional(*end_ - standing.seconds) : std::nullopt;
}

std::string progress_line(const Standing& standing, std::optional<double> seconds_left, std::size_t width) {
  std::string name = standing.stage;
  name.resize(std::max(name.size(), name_width), ' ');
  std::string line = "epura: " + name;
  if (standing.work == 0) {
    line += clock_text(standing.seconds);
  } else {
    const double part = std::min(static_cast<double>(standing.done) / static_cast<double>(standing.work), 1.0);
    const std::string percent = std::to_string(static_cast<int>(100 * part));
    line += bar(part) + std::string(4 - percent.size(), ' ') + percent + " %";
    if (seconds_left) line += "  " + clock_text(*seconds_left) + " left";
  }
  return line.substr(0, width);
}

}  // namespace epura
