// SPDX-License-Identifier: Apache-2.0
#include "base/shared_library.hpp"
#include "serve/http/library.hpp"

namespace epura::http {

const Library& library() {
  return own_table<Library>(EPURA_HTTP_LIBRARY, "epura_http_library", "epura serve needs it");
}

}  // namespace epura::http
