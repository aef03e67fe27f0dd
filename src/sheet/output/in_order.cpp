// SPDX-License-Identifier: Apache-2.0
#include "output/in_order.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"

namespace epura::output {

void append_in_order(std::string& text, std::size_t count, const Progress& progress,
                     const std::function<void(std::size_t, std::string& part)>& write) {
  constexpr std::size_t at_once = 16;
  std::vector<std::string> written(at_once);
  for (std::size_t done = 0; done < count; done += at_once) {
    const std::size_t more = std::min(at_once, count - done);
    parallel_for(more, 1, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) write(done + i, written[i]);
    });
    for (std::size_t i = 0; i < more; ++i) {
      text += written[i];
      written[i].clear();
    }
  }
}

}  // namespace epura::output
