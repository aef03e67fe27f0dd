// SPDX-License-Identifier: Apache-2.0
// Loads shared libraries at run time, and finds epura's own.
#pragma once

#include <filesystem>

#include "base/error.hpp"

namespace epura {

/// It stays loaded until the program ends, since unloading runs foreign code at an uncertain time. Throws
/// Error{trouble} with the reason why it cannot be loaded, without its path.
void* load_library(const std::filesystem::path& path, ErrorKind kind);

/// The address of a symbol of a loaded library; null if it has none of that name.
void* find_symbol(void* library, const char* name);

/// Waits until no other thread is loading a library. What is forked meanwhile finds the loader's tables half written,
/// and may hang in them when it loads a library itself.
void wait_for_other_loads();

/// What came with this program: its folder lib/epura, found from the program, or from the library that holds this code,
/// so that all can be moved together. Empty if the system does not provide their location.
std::filesystem::path own_folder();

}  // namespace epura
