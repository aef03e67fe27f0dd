// SPDX-License-Identifier: Apache-2.0
// The settings of a drawing as options of a run.
#pragma once

#include <epura/epura.hpp>

#include "views/options.hpp"

namespace epura {

/// Throws Error{input} for values outside their range.
pipeline::RunOptions run_options_of(const Settings& settings);

}  // namespace epura
