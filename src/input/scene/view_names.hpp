// SPDX-License-Identifier: Apache-2.0
// Maximum number of views, default names, and views by name.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/description.hpp"

namespace epura::scene {

/// Throws Error{input} with the location `where` for more than 1000 views.
void expect_few_views(std::size_t views, const std::string& where);

/// Names each view without a name after its detail ("detail-X") or its projection, with a number if the name is taken:
/// "front-2". Views without a detail must have a projection. Throws
/// Error{input} for more than 1000 views.
void name_views(std::vector<ViewDescription>& views);

/// Returns the view of that name; without a name, the first one that shows no detail. Views must have names. Throws
/// Error{input}, with the location of the name or else `where`, if there is none, or if it shows a detail.
const ViewDescription& whole_view(const LocatedText& name, const std::string& where,
                                  const std::vector<ViewDescription>& views);

}  // namespace epura::scene
