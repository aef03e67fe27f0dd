// SPDX-License-Identifier: Apache-2.0
// Reading and writing of whole files. Readers of an output see the old file or the new one, never a part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace epura {

/// Where something written to the path goes: the end of links that there are, also of those that lead to nothing yet.
/// Links in a circle stay what they are.
std::filesystem::path end_of_links(const std::filesystem::path& path);

/// The same text for two paths exactly if they are one file, by whatever links and names; also of one that is not there
/// yet. Empty for devices, pipes and folders: they may be written to twice, or not at all.
std::string identity_of_file(const std::filesystem::path& path);

/// All bytes of a regular file (or of a pipe, up to 1 GB: it may have no end). Throws Error{input} naming the path and
/// the reason: also for devices, for what is longer than `most_bytes`, and for files that Git LFS keeps elsewhere.
/// Throws OutOfTime.
std::string read_file(const std::filesystem::path& path, const Progress& progress = {},
                      std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

/// Writes next to the target, without a name where the file system can, and renames at the end. Links stay links.
/// Throws Error{output}; the old file then stays. A target that is not a regular file (a device, a pipe) is written to
/// directly.
void write_file(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

}  // namespace epura
