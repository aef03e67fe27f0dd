// SPDX-License-Identifier: Apache-2.0
#include "foreign/folders.hpp"

#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/folder.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"

namespace epura::foreign {

namespace fs = std::filesystem;

namespace {

constexpr const char* variable = "EPURA_PLUGIN_PATH";

// A relative one would mean another folder in every directory, some of which others can write to.
fs::path absolute(std::string_view folder) {
  if (!folder.starts_with('/'))
    throw Error(ErrorKind::plugin, variable, "'" + one_line(folder) + "' is not an absolute path",
                "give " + fs::absolute(folder).string() + ", or use --plugin-path");
  return folder;
}

bool everyone_can_write(const fs::path& path) {
  std::error_code missing;
  const fs::file_status status = fs::status(path, missing);
  return !missing && (status.permissions() & fs::perms::others_write) != fs::perms::none;
}

// Whoever can write there can make this program run any code. A library may be a link to a file elsewhere.
void expect_private(const fs::path& folder) {
  std::error_code failure;
  if (!fs::is_directory(folder, failure)) return;
  if (everyone_can_write(folder))
    throw Error(ErrorKind::plugin, folder.string(), "everyone can put plugins into this folder", "chmod o-w it");
  std::vector<BadPlugin> unreadable;
  for (const fs::path& library : libraries_in(folder, unreadable)) {
    const fs::path file = fs::canonical(library, failure);
    if (failure) continue;
    if (everyone_can_write(file))
      throw Error(ErrorKind::plugin, library.string(), "everyone can change this plugin", "chmod o-w it");
    if (everyone_can_write(file.parent_path()))
      throw Error(ErrorKind::plugin, library.string(),
                  "everyone can replace " + file.string() + ", to which this links",
                  "chmod o-w its folder, or copy it");
  }
}

}  // namespace

std::vector<fs::path> plugin_folders(const std::vector<fs::path>& extra, const std::string& own) {
  std::vector<fs::path> folders = extra;
  if (const char* path = std::getenv(variable))
    for (const std::string_view folder : split(path, ':'))
      if (!folder.empty()) folders.push_back(absolute(folder));
  for (const fs::path& folder : folders) expect_private(folder);
  if (const fs::path here = own_folder(); !here.empty()) folders.push_back(here / own);
  return folders;
}

std::vector<fs::path> libraries_in(const fs::path& folder, std::vector<BadPlugin>& bad) {
  std::vector<fs::path> libraries;
  std::error_code failure, unreadable;
  for (const std::string& name : names_in(folder, failure))
    if (fs::path path = folder / name; path.extension() == ".so" && fs::is_regular_file(path, unreadable))
      libraries.push_back(std::move(path));
  if (failure) bad.push_back({folder, "is not a folder that can be read: " + failure.message()});
  return libraries;
}

}  // namespace epura::foreign
