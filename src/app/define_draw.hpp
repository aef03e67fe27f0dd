// SPDX-License-Identifier: Apache-2.0
// The options of a drawing.
#pragma once

#include <CLI/CLI.hpp>

#include "app/options.hpp"

namespace epura {

/// `options` is filled when the command line is parsed, and has to live until then.
void define_drawing(CLI::App& draw, DrawOptions& options);

}  // namespace epura
