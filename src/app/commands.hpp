// The commands. Each returns the exit code.
#pragma once

#include "app/options.hpp"

namespace epura {

/// The drawing was written, but --time-limit left edges out.
inline constexpr int partial_exit_code = 5;

int draw(const DrawOptions& options);
int plugins(const PluginsOptions& options);
int compare(const CompareOptions& options);
int snapshot(const SnapshotOptions& options);

}  // namespace epura
