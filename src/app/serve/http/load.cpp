// SPDX-License-Identifier: Apache-2.0
#include "app/serve/http/library.hpp"
#include "base/error.hpp"
#include "base/shared_library.hpp"

namespace epura::http {

const Library& library() {
  const std::filesystem::path path = own_folder() / EPURA_HTTP_LIBRARY;
  try {
    const void* found = find_symbol(load_library(path, ErrorKind::output), "epura_http_library");
    if (found == nullptr) throw Error(ErrorKind::output, "", "is a different library");
    return *static_cast<const Library*>(found);
  } catch (const Error& error) {
    throw Error(error.kind(), path.string(), error.what(), "epura serve needs it: reinstall epura");
  }
}

}  // namespace epura::http
