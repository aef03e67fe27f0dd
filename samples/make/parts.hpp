// SPDX-License-Identifier: Apache-2.0
// The sample parts. Millimetres, z up, the front view looks along +y.
#pragma once

#include <string>
#include <vector>

#include "solid.hpp"

namespace samples {

Model bracket();    ///< an angle bracket with slots and holes in both legs
Model flange();     ///< a welding-neck flange with eight bolt holes
Model shaft();      ///< a stepped shaft with chamfers and a keyway
Model cylinders();  ///< two cylinders through each other, as two bodies
Model gear();       ///< an involute spur gear with hub, keyway and lightening holes
Model bearing();    ///< a roller on a shaft between two pillow blocks: ten bodies in contact
Model elbow();      ///< a pipe bend with two flanges
Model house();      ///< walls with windows and a door, roof, chimney, step
Model stairs();     ///< a spiral staircase with its handrail
Model sombrero();   ///< the open surface z = sin(pi r) / (pi r)

struct Part {
  std::string file;
  Model (*make)();
  bool closed;  ///< bounds a volume
};

const std::vector<Part>& all_parts();

}  // namespace samples
