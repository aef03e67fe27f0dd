// Whole files in and out. A reader of an output sees the old file or the new one, never half of one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace epura {

/// All bytes of a regular file (or of a pipe). Throws Error{input} naming the path and the reason.
/// Throws OutOfTime.
std::string read_file(const std::filesystem::path& path, const Progress& progress = {});

/// Writes beside the target, without a name where the file system can, and renames at the end. Throws Error{output};
/// the old file then stays. A target that is no regular file (a device, a pipe) is written to directly.
void write_file(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

}  // namespace epura
