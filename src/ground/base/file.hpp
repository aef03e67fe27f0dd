// SPDX-License-Identifier: Apache-2.0
// Reads and writes whole files. Readers of an output see the old file or the new one, never a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace epura {

/// Returns where something written to the path goes: the end of existing links, including those whose target does not
/// exist yet. Links in a circle remain as they are.
std::filesystem::path end_of_links(const std::filesystem::path& path);

/// Returns the same text for two paths exactly if they are one file, whatever links and names lead to it; also for a
/// file that does not exist yet. Empty for devices, pipes and folders: they may be written to twice, or not at all.
std::string identity_of_file(const std::filesystem::path& path);

/// Returns all bytes of a regular file (or of a pipe, up to 1 GB, since it may be endless). Throws Error{input} with
/// path and reason, also for devices, for more than `max_bytes`, and for files whose contents Git LFS keeps elsewhere.
/// Throws OutOfTime.
std::string read_file(const std::filesystem::path& path, const Progress& progress = {},
                      std::uintmax_t max_bytes = std::numeric_limits<std::uintmax_t>::max());

/// Writes a file next to the target, without a name if the file system supports that, and renames it at the end. Links
/// stay links. Throws Error{output}; then the old file remains. A target that is not a regular file (a device, a pipe)
/// is written to directly.
void write_file(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

}  // namespace epura
