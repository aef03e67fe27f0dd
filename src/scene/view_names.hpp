// What views are called that have no name of their own.
#pragma once

#include <vector>

#include "scene/description.hpp"

namespace epura {

/// Gives the name of its projection to each view without a name; numbered where another view has it: "front-2".
void name_views(std::vector<ViewDescription>& views);

}  // namespace epura
