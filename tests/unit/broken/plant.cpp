// SPDX-License-Identifier: Apache-2.0
// A fault for tests, planted by the linker (--wrap): where hidden parts of an edge lie is wrong if the environment says
// so.
#include <cstdlib>

#include "visibility/spans.hpp"

namespace epura::visibility {

void sound_absorb_slivers(Spans& spans, double min) asm("__real_" EPURA_WRAPPED);
void planted_absorb_slivers(Spans& spans, double min) asm("__wrap_" EPURA_WRAPPED);

void planted_absorb_slivers(Spans& spans, double min) {
  sound_absorb_slivers(spans, min);
  if (std::getenv("EPURA_BREAK") != nullptr && !spans.empty()) spans.back()[1] = 1.5;
}

}  // namespace epura::visibility
