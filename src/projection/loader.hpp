// One plugin: opens the library, checks everything it says, and copies its tables.
#pragma once

#include <filesystem>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura {

/// What the library offers. A library is used whole or not at all: Error{plugin} says what is wrong with it, without
/// its path. It stays loaded until the program ends, since unloading runs foreign code at an uncertain time.
std::vector<ProjectionEntry> read_plugin(const std::filesystem::path& path);

/// The shared library that holds this code, absolute; empty if the program itself does.
std::filesystem::path own_library();

/// Lower case, digits and '-'.
bool is_projection_name(std::string_view name);

}  // namespace epura
