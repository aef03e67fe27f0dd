// SPDX-License-Identifier: Apache-2.0
// Models from the bytes of a fuzzer: parts with holes, turned parts, surfaces, bodies beside and in one another.
#pragma once

#include <string>

#include "mesh/soup.hpp"

namespace epura::fuzz {

/// Up to four of them. Throws Error{input} for none.
mesh::Soup made_model(const std::string& bytes);

}  // namespace epura::fuzz
