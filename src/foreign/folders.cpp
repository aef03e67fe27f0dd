// SPDX-License-Identifier: Apache-2.0
#include "foreign/folders.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "base/shared_library.hpp"
#include "base/text.hpp"

namespace epura::foreign {

namespace fs = std::filesystem;

std::vector<fs::path> plugin_folders(const std::vector<fs::path>& extra, const std::string& own) {
  std::vector<fs::path> folders = extra;
  if (const char* path = std::getenv("EPURA_PLUGIN_PATH"))
    for (const std::string_view folder : split(path, ':'))
      if (!folder.empty()) folders.emplace_back(folder);
  if (const fs::path here = own_folder(); !here.empty()) folders.push_back(here / own);
  return folders;
}

std::vector<fs::path> libraries_in(const fs::path& folder, std::vector<BadPlugin>& bad) {
  std::error_code error;
  std::vector<fs::path> libraries;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    std::error_code unreadable;
    if (file->path().extension() == ".so" && file->is_regular_file(unreadable)) libraries.push_back(file->path());
  }
  if (error) bad.push_back({folder, "is not a folder that can be read: " + error.message()});
  std::sort(libraries.begin(), libraries.end());
  return libraries;
}

}  // namespace epura::foreign
