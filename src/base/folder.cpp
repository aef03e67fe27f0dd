// SPDX-License-Identifier: Apache-2.0
#include "base/folder.hpp"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>

#include "base/error.hpp"

namespace epura {

std::vector<std::string> names_in(const std::filesystem::path& folder, std::error_code& failure) {
  struct Close {
    void operator()(DIR* open) const { ::closedir(open); }
  };
  const auto last_failure = [] { return std::error_code(errno, std::generic_category()); };
  std::vector<std::string> names;
  const std::unique_ptr<DIR, Close> open(::opendir(folder.c_str()));
  if (open == nullptr) {
    failure = last_failure();
    return names;
  }
  // Only errno tells a failure from the end.
  for (errno = 0; const dirent* const entry = ::readdir(open.get()); errno = 0)
    if (const std::string_view name = entry->d_name; name != "." && name != "..") names.emplace_back(name);
  failure = last_failure();
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::string> names = names_in(folder, failure);
  if (failure) throw Error(ErrorKind::input, folder.string(), "cannot be listed: " + failure.message());
  return names;
}

}  // namespace epura
