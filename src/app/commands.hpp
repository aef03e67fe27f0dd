// The commands. Each returns the exit code.
#pragma once

#include "app/options.hpp"

namespace epura {

int draw(const DrawOptions& options);
int plugins(const PluginsOptions& options);

}  // namespace epura
