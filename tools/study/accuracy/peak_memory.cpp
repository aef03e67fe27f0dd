// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/peak_memory.hpp"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "base/text.hpp"

namespace epura::study {

namespace {

// A line such as "VmHWM:     1234 kB".
std::optional<double> bytes_in_status(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_of("0123456789");
    const auto number = begin == std::string::npos
                            ? std::nullopt
                            : parse_number(std::string_view(line).substr(begin, line.find(' ', begin) - begin));
    if (number) return *number * 1024;
  }
  return std::nullopt;
}

bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  return file.good();
}

}  // namespace

std::optional<double> peak_memory_of(const std::function<void()>& work) {
  malloc_trim(0);  // otherwise memory freed by earlier work would be reused without being counted
  const bool told = forget_peak();
  const std::optional<double> before = bytes_in_status("VmRSS:");
  work();
  const std::optional<double> peak = bytes_in_status("VmHWM:");
  if (!told || !before || !peak) return std::nullopt;
  return std::max(*peak - *before, 0.0);
}

}  // namespace epura::study
