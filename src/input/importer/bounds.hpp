// SPDX-License-Identifier: Apache-2.0
// What an importer may take for a file: libraries of foreign formats hang on some damaged files, or ask for all memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "foreign/parameters.hpp"

namespace epura::importer {

// Of 60 real files in STEP, IGES, BREP, glTF and 3MF of 0.02e6 to 2e6 bytes, none took more than 0.1e9 bytes, nor more
// than 5 s for 1 % of its progress on a busy machine.

/// Bytes for a small file.
inline constexpr double usual_memory = 2e9;
/// More bytes for each byte of the file: text with its entities, faces and facets takes 30.
inline constexpr double memory_per_byte = 300;
/// Seconds without progress for a small file.
inline constexpr double usual_patience = 120;
/// More seconds for each byte of the file: text is parsed in one step, at 5e6 bytes/s or more.
inline constexpr double patience_per_byte = 2e-6;
/// The part of the work that counts as progress: who creeps does not get on.
inline constexpr double min_progress = 0.01;

/// What one reading may take.
struct Bounds {
  double memory = 0;    ///< bytes; 0: no bound
  double patience = 0;  ///< seconds without progress; 0: no bound
};

/// For a file, with the other files that it may open.
inline Bounds bounds_for(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  return {usual_memory + memory_per_byte * size, usual_patience + patience_per_byte * size};
}

/// Rows for `memory` in GB and `patience` in s, behind the parameters of each importer: FILE:memory=8 allows more.
std::vector<foreign::Parameter> parameters_of_bounds();

bool is_bound(std::string_view parameter);

/// The bounds that values for these rows, the last ones of a table, give, NaN for those that are not given; else
/// `usual`.
Bounds given_bounds(const foreign::ParameterValues& values, const Bounds& usual);

/// Triangles that copies of shapes may add to those in the file: as many as can be drawn in some minutes. A file of a
/// few kilobytes can put down one shape a hundred thousand times.
inline constexpr std::size_t max_copied_triangles = 20'000'000;

}  // namespace epura::importer
