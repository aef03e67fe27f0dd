// SPDX-License-Identifier: Apache-2.0
#include "base/shared_library.hpp"

#include <dlfcn.h>
#include <link.h>

#include <string>

#include "base/kept_arithmetic.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

/// Returns dlerror() without the path, which the caller adds to the error.
std::string loading_error(const std::string& path) {
  const char* text = dlerror();
  std::string reason = text == nullptr ? "cannot be loaded" : text;
  if (reason.starts_with(path + ": ")) reason.erase(0, path.size() + 2);
  return reason;
}

/// Returns the absolute path of the shared library that contains this code; empty if the program itself does.
fs::path own_library() {
  Dl_info info{};
  void* map = nullptr;
  const int found = dladdr1(reinterpret_cast<const void*>(&own_library), &info, &map, RTLD_DL_LINKMAP);
  if (found == 0 || map == nullptr) return {};
  const char* name = static_cast<const link_map*>(map)->l_name;
  return *name == 0 ? fs::path() : fs::absolute(name);  // the program has no name in this list
}

}  // namespace

void* load_library(const fs::path& path, ErrorKind kind) {
  // dlopen searches the system's folders for a path without a slash.
  const std::string file = fs::absolute(path).string();
  const KeptArithmetic arithmetic;
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(kind, "", loading_error(file));
  return library;
}

void* find_symbol(void* library, const char* name) { return dlsym(library, name); }

void wait_for_other_loads() {
  Dl_info info{};  // unused: the call takes the loader's lock, which is held until a library has been loaded
  dladdr(reinterpret_cast<const void*>(&wait_for_other_loads), &info);
}

fs::path own_folder() {
  if (const fs::path library = own_library(); !library.empty()) return library.parent_path() / "epura";
  std::error_code error;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  if (prefix.empty()) return {};
  const fs::path installed = prefix / EPURA_LIBRARY_FOLDER / "epura";
  return fs::is_directory(installed, error) ? installed : prefix / "lib/epura";
}

const void* own_symbol(const std::string& file, const char* name, const std::string& purpose) {
  const fs::path path = own_folder() / file;
  try {
    const void* symbol = find_symbol(load_library(path, ErrorKind::output), name);
    if (symbol == nullptr) throw Error(ErrorKind::output, "", "is a different library");
    return symbol;
  } catch (const Error& error) {
    throw Error(error.kind(), path.string(), error.what(), purpose + ": reinstall epura");
  }
}

}  // namespace epura
