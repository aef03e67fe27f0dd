// SPDX-License-Identifier: Apache-2.0
// Questions about a drawing (--why, --dump), answered as text.
#pragma once

#include <string>

#include "views/draw_view.hpp"
#include "views/options.hpp"

namespace epura::pipeline {

/// The answers as text; empty if there are no questions. Throws Error{input} if a requested edge does not exist.
std::string answer(const RunOptions& questions, const ViewInput& input, const ViewResult& result,
                   const Progress& progress = {});

}  // namespace epura::pipeline
