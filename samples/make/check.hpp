// SPDX-License-Identifier: Apache-2.0
// Whether a model is what it should be: closed, turned outwards, without doubled or flat faces.
#pragma once

#include <string>
#include <vector>

#include "solid.hpp"

namespace samples {

/// Everything that is wrong, a sentence each; nothing for a sound model.
std::vector<std::string> faults(const Model& model, bool closed);

/// The volume that a closed solid encloses, in cubic millimetres; negative when it is turned inside out.
double volume(const Solid& solid);

}  // namespace samples
