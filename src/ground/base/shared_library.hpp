// SPDX-License-Identifier: Apache-2.0
// Loads shared libraries at run time, and finds epura's own.
#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace epura {

/// The library stays loaded until the program ends, since unloading runs foreign code at an unpredictable time. Throws
/// Error{kind} with the reason why it cannot be loaded, without its path.
void* load_library(const std::filesystem::path& path, ErrorKind kind);

/// Returns the address of a symbol in a loaded library; null if there is none of that name.
void* find_symbol(void* library, const char* name);

/// Waits until no other thread is loading a library. A process that is forked during that time finds the loader's
/// tables half written, and may hang when it loads a library itself.
void wait_for_other_loads();

/// Returns the folder lib/epura that came with this program. It is found relative to the program, or to the library
/// that contains this code, so that everything can be moved together. Empty if the system does not provide their
/// location.
std::filesystem::path own_folder();

/// Returns a symbol of a library in that folder. Throws Error{output} with its path, and `purpose` in the hint.
const void* own_symbol(const std::string& file, const char* name, const std::string& purpose);

/// The same as a table of the library's functions.
template <class Table>
const Table& own_table(const std::string& file, const char* name, const std::string& purpose) {
  return *static_cast<const Table*>(own_symbol(file, name, purpose));
}

}  // namespace epura
