// SPDX-License-Identifier: Apache-2.0
// Reads the ZIP archive of a 3MF file. lib3mf would unpack it without a limit on the size.
#pragma once

#include <cstddef>
#include <string>

namespace epura::plugin::threemf {

struct Package {
  std::string bytes;
  std::size_t degenerate = 0;  ///< triangles with two equal corners: they are omitted, because lib3mf refuses them
};

/// Throws std::runtime_error with a sentence if the file is not an archive, is encrypted or damaged, has far more
/// content than archives of models do, or nests parts endlessly.
Package read_package(const std::string& path);

}  // namespace epura::plugin::threemf
