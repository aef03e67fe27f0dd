// SPDX-License-Identifier: Apache-2.0
// Reads model files into meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// Reads OBJ, STL (text, binary), PLY (text, both byte orders) or OFF. The format is determined by the content of the
/// file, then by its extension. Coordinates are the doubles nearest to those in the file. Throws Error{input} with path
/// and line (text) or byte (binary), and OutOfTime. Every byte of the file counts twice as progress: when it has been
/// read, and when the mesh is complete. `others`: extensions of further formats, for who looks for one: ".step, .glb".
Mesh read_mesh(const std::filesystem::path& path, const Progress& progress = {}, const std::string& others = {});

/// The same for a file in memory. `name` precedes the line or byte in errors; its extension counts.
Mesh read_mesh(std::string bytes, const std::string& name, const Progress& progress = {},
               const std::string& others = {});

/// A format that read_mesh reads.
struct Format {
  std::string_view name;  ///< also the extension: lower case, without a dot
  std::string_view summary;
  Soup (*read)(std::string_view bytes, std::string_view name, const Progress& progress);
};
std::span<const Format> formats();

/// Returns the format with a name; null if there is none.
const Format* format_named(std::string_view name);

/// Returns the format of a file by what it holds; null if that is none of these.
const Format* format_in(std::string_view bytes);

/// Builds a mesh from polygons in memory; `name` precedes the reason in errors. `step` as in build_mesh.
Mesh make_mesh(Soup soup, const std::string& name, const Progress& progress = {}, std::optional<double> step = {});

// One reader for each format; `name` precedes the line or byte in errors.
Soup read_obj(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_stl(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_ply(std::string_view bytes, std::string_view name, const Progress& progress = {});
Soup read_off(std::string_view bytes, std::string_view name, const Progress& progress = {});

}  // namespace epura::mesh
