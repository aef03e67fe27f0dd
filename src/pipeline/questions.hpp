// SPDX-License-Identifier: Apache-2.0
// Questions about a drawing (--why, --dump): parsed before any work is done, answered as text.
#pragma once

#include <string>
#include <vector>

#include "pipeline/draw_view.hpp"
#include "pipeline/options.hpp"
#include "study/questions/find_subjects.hpp"

namespace epura {

struct Questions {
  std::vector<EdgeQuestion> why;
  bool edge_table = false;
  bool span_table = false;
};

Questions questions_of(const RunOptions& options);

/// The answers as text. Throws Error{input} when an edge that was asked for does not exist.
std::string answer(const Questions& questions, const World& world, const ViewOptions& wish, const ViewResult& result,
                   const Progress& progress = {});

}  // namespace epura
