// Questions about a drawing (--why, --dump): parsed before any work is done, answered on standard output.
#pragma once

#include <vector>

#include "app/options.hpp"
#include "study/drawn_view.hpp"
#include "study/find_subjects.hpp"

namespace epura {

struct Questions {
  std::vector<EdgeQuestion> why;
  bool edge_table = false;
  bool span_table = false;
};

/// Throws Error{input} for wrong questions, and where neither a question nor an output is given.
Questions parse_questions(const DrawOptions& options);

/// Throws Error{input} when an edge that was asked for does not exist.
void print_answers(const Questions& questions, const DrawnView& drawn_view);

}  // namespace epura
