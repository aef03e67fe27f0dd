// SPDX-License-Identifier: Apache-2.0
#include "base/folder.hpp"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>

#include "base/error.hpp"
#include "base/file.hpp"

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

bool is_within(const std::filesystem::path& path, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  // Of a file that does not exist, only the absolute path is complete. What the system cannot follow, such as a name
  // that is too long, it cannot open either.
  const auto followed = [](const fs::path& path) {
    std::error_code error;
    fs::path way = fs::weakly_canonical(path, error);
    return error ? path.lexically_normal() : way;
  };
  return is_within(followed(end_of_links(fs::absolute(file))), followed(fs::absolute(folder.empty() ? "." : folder)));
}

}  // namespace epura
