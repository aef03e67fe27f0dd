// SPDX-License-Identifier: Apache-2.0
// Everything that uses libmicrohttpd: requests of HTTP/1.1 in, replies out. It is a separate library, loaded by
// `epura serve` alone: libmicrohttpd brings eight more, which would double the time that a small drawing takes to
// start.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace epura::http {

using Fields = std::vector<std::pair<std::string, std::string>>;

/// A request with the method GET and without a body; all others are refused within this library.
struct Request {
  std::uint64_t number = 0;  ///< of the request, for its reply
  std::string path;          ///< decoded, without what follows '?'
  Fields arguments;          ///< decoded, in their order
  Fields headers;            ///< names in lower case
};

struct Reply {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body{};
  Fields headers{};         ///< further ones
  bool is_refusal = false;  ///< who asked does not know the token
};

class Server;

/// What the library offers; one thread uses it.
struct Library {
  /// Takes a listening socket over. Null if there is no memory for the server.
  Server* (*start)(int socket);
  /// A descriptor that becomes readable when there is something to do.
  int (*descriptor)(const Server& server);
  /// Milliseconds after which there is something to do in any case; -1: never.
  int (*wait_ms)(Server& server);
  /// Does what there is to do. Returns new requests, each of which waits for its reply.
  std::vector<Request> (*take)(Server& server);
  /// Replies to a request, once. Who asked may have gone since.
  void (*reply)(Server& server, std::uint64_t number, Reply reply);
};

/// Throws Error{output} if the library is not where it was installed.
const Library& library();

}  // namespace epura::http
