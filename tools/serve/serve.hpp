// SPDX-License-Identifier: Apache-2.0
// `epura serve`: a page on this computer, in which the parameters of projections can be tried.
#pragma once

#include <string>
#include <vector>

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

struct ServeOptions {
  DrawOptions draw;                ///< of all drawings, but for the projection that the page chooses
  std::vector<std::string> words;  ///< the same as given, for command lines
  int port = 0;                    ///< 0: any that is free
  double job_time = 60;            ///< seconds for a view or a drawing
  double job_memory = 4000;        ///< MB for a drawing
};

/// The options of drawings with one view of whole models, and its own.
scene::Options<ServeOptions> serve_options();

/// Ends by a signal only.
int serve(const ServeOptions& options);

}  // namespace epura
