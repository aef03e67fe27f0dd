// SPDX-License-Identifier: Apache-2.0
// The ZIP archive that a 3MF file is. lib3mf unpacks it without asking how much comes out.
#pragma once

#include <string>

namespace epura::plugin::threemf {

/// The bytes of the file. Throws std::runtime_error with a sentence where it is no archive, is encrypted or damaged, or
/// holds far more than archives of models do, or parts without end.
std::string read_package(const std::string& path);

}  // namespace epura::plugin::threemf
