// SPDX-License-Identifier: Apache-2.0
// The report of the study of the whole way from a mesh to its drawing.
#pragma once

#include <vector>

#include "study/paper/convergence.hpp"
#include "study/study_report.hpp"

namespace epura::study {

/// For each scene a work-precision diagram, error on paper over run time with a curve for each way to draw it, and the
/// table with its numbers. Marks runs on the front.
StudyReport report_of(std::vector<PaperSeries> series);

}  // namespace epura::study
