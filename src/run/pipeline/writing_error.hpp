// SPDX-License-Identifier: Apache-2.0
// How exactly files are written, as --max-error asks.
#pragma once

#include <span>
#include <string>

#include "output/vector_options.hpp"
#include "pipeline/targets.hpp"

namespace epura::pipeline {

/// Chooses decimals and resolution, unless they are given, as low as the formats of the targets allow.
void choose_writing(output::VectorOptions& options, std::span<const Target> targets, double max_error, bool has_arcs);
/// Returns the largest error of the formats of the targets, mm.
double error_of_writing(std::span<const Target> targets, const output::VectorOptions& options, bool has_arcs);

/// What is chosen for --max-error, for people.
std::string sentence_of_choices(double max_error, bool has_arcs, const output::VectorOptions& options);

}  // namespace epura::pipeline
