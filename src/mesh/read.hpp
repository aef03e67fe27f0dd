// SPDX-License-Identifier: Apache-2.0
// Model files -> meshes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// Reads OBJ, STL (text, binary), PLY (text, both byte orders) or OFF, by what the file holds and then by its
/// extension. Coordinates arrive as the file's doubles. Throws Error{input} with path and line (text) or byte (binary),
/// and OutOfTime. Every byte of the file counts twice as progress: once it is read, and once the mesh is there.
Mesh read_mesh(const std::filesystem::path& path, const Progress& progress = {});

/// Whether read_mesh reads files with an extension (lower case, without a dot).
bool is_own_extension(std::string_view extension);

/// The same from memory; `name` precedes the reason in errors.
Mesh make_mesh(Soup soup, const std::string& name, const Progress& progress = {});

// One reader for each format; `name` precedes the line or byte in errors.
Soup read_obj(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_stl(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_ply(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_off(std::string_view bytes, std::string_view name, const Progress& progress = {});

}  // namespace epura::mesh
