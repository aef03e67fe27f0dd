// SPDX-License-Identifier: Apache-2.0
// Finds the edges that a question is about: by vertices, by faces, or by a position on the sheet.
#pragma once

#include <vector>

#include "explain/edge_question.hpp"
#include "explain/subject.hpp"

namespace epura::explain {

/// Returns one edge, all intersection lines of two faces, or the three drawn edges nearest to a place, nearest first.
/// Throws Error{input} if there is none, with a hint at what there is instead.
std::vector<Subject> find_subjects(const ExplainInput& drawn_view, const EdgeQuestion& question);

}  // namespace epura::explain
