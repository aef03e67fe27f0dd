// SPDX-License-Identifier: Apache-2.0
// The library: from models to files of drawings, as `epura draw` does it.
//
//   epura::draw({.models = {"bracket.obj"}, .projections = {"isometric"}, .outputs = {"bracket.pdf"}});
//
// find_package(epura COMPONENTS library) and link epura::library, or use pkg-config.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#define EPURA_PUBLIC __attribute__((visibility("default")))

namespace epura {

/// What is to be drawn. All texts are those of the command line, and are checked in the same way.
struct Request {
  std::vector<std::string> models;       ///< files in obj, stl, ply or off; or one scene file, toml
  std::vector<std::string> projections;  ///< NAME[:key=value]..., each one view; none: isometric, or as the scene says
  /// Name and value of every other option of `epura draw --help`, without the dashes: {"sheet", "A4"}. An option that
  /// takes no value has an empty one: {"portrait", ""}.
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<std::string> outputs;  ///< files to write; their extensions tell the formats
};

/// What was done.
struct Result {
  std::vector<std::string> files;     ///< that were written, several for one output where it has several sheets
  std::vector<std::string> warnings;  ///< sentences: what was repaired in models, what is not as was wished
  std::string report;                 ///< what `why`, `dump`, `verify`, `arcs` and `timings` tell
  bool is_partial = false;            ///< `time-limit` left something out
  bool is_wrong = false;              ///< `verify` found a wrong point
};

/// All trouble that the caller can mend: a file that cannot be read or written, a wrong option, a bad plugin. The
/// message names the place and the reason.
class EPURA_PUBLIC Failure : public std::runtime_error {
 public:
  /// The exit code that the program has for it. `time`: `time-limit` left nothing to show.
  enum class Kind { input = 2, plugin = 3, output = 4, time = 5 };

  Failure(Kind kind, const std::string& message, std::string hint)
      : std::runtime_error(message), kind_(kind), hint_(std::move(hint)) {}

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  /// The remedy, where there is one.
  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }

 private:
  Kind kind_;
  std::string hint_;
};

/// Draws and writes. Takes all cores unless {"threads", "N"} says otherwise; prints nothing and touches no signal. One
/// call at a time. Plugins are found beside the library, and as the program finds them; they run in processes of their
/// own, which end with the call. These are forked when no other thread is loading a library: see docs/plugins.md.
/// Throws Failure, and std::bad_alloc; what was there under the name of an output then stays.
EPURA_PUBLIC Result draw(const Request& request);

/// "0.1.0"
EPURA_PUBLIC const char* version() noexcept;

}  // namespace epura
