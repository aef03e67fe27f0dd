// SPDX-License-Identifier: Apache-2.0
// How long a job may take, before anything is read.
#pragma once

#include <string>
#include <vector>

namespace epura {

/// An estimate in microseconds, from the number of triangles: that in the header of STL, PLY and OFF, otherwise from
/// the size of the file. What matters is the order of jobs, and that it is the same on all machines.
double estimated_time(const std::vector<std::string>& models);

}  // namespace epura
