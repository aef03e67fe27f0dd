// SPDX-License-Identifier: Apache-2.0
// The ZIP archive that a 3MF file is. lib3mf unpacks it without asking how much comes out.
#pragma once

#include <cstddef>
#include <string>

namespace epura::plugin::threemf {

struct Package {
  std::string bytes;
  std::size_t degenerate = 0;  ///< triangles with two equal corners: they are left out, since lib3mf refuses them
};

/// Throws std::runtime_error with a sentence where the file is no archive, is encrypted or damaged, or holds far more
/// than archives of models do, or parts without end.
Package read_package(const std::string& path);

}  // namespace epura::plugin::threemf
