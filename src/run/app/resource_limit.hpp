// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>

namespace epura {

inline constexpr double bytes_of_megabyte = 1e6;

/// Limits a resource of this process that is counted in bytes, such as RLIMIT_DATA.
inline void limit_resource(__rlimit_resource resource, double megabytes) {
  const auto bytes = static_cast<rlim_t>(megabytes * bytes_of_megabyte);
  const rlimit both{bytes, bytes};
  ::setrlimit(resource, &both);
}

}  // namespace epura
