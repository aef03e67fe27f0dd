// SPDX-License-Identifier: Apache-2.0
// `epura check`: a drawing that carries its proof is drawn again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/option.hpp"

namespace epura {

struct CheckOptions {
  std::string drawing;  ///< SVG or PDF
  std::string inputs;   ///< folder of the files that the drawing does not carry; empty: its own
  std::vector<std::filesystem::path> plugin_path;
};

scene::Options<CheckOptions> check_options();

/// Returns the exit code: 0 if the drawing is, to the byte, what its models and options give, and tests find it right.
/// Throws Error{input} for drawings without a proof, and for models that cannot be found or drawn.
int check_drawing(const CheckOptions& options);

}  // namespace epura
