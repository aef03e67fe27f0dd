// SPDX-License-Identifier: Apache-2.0
// A model that is read once and seen through many projections. It is in a process of its own, in which the plugins are
// asked and to which nothing of the network is open.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "foreign/child_process.hpp"
#include "serve/serve.hpp"

namespace epura {

/// What the process says first.
struct ReadyModel {
  std::string page_data;  ///< JSON: projections with their parameters, the model's box, the first view
  std::string wireframe;  ///< as of wireframe_bytes
};

/// What it says of a view: JSON, of the view or of an error.
struct ViewAnswer {
  bool is_good;
  std::string json;
};

/// Starts the process, and waits until the model is read. Throws the Error with which that fails. The options must
/// outlive the call.
ReadyModel start_model(foreign::ChildProcess& process, const ServeOptions& options);

/// Asks for the view of a projection, NAME[:key=value...].
void ask_for_view(foreign::ChildProcess& process, const std::string& projection);

/// Takes the answer if it is there. Throws Error{plugin} if the process is gone.
std::optional<ViewAnswer> take_view(foreign::ChildProcess& process);

/// {"error": ..., "hint": ...}
std::string error_json(std::string_view reason, std::string_view hint);

}  // namespace epura
