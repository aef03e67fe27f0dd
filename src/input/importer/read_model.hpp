// SPDX-License-Identifier: Apache-2.0
// Reads any model file into a mesh, with the faces of the part if the file has them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "foreign/parameters.hpp"
#include "importer/assemble.hpp"
#include "importer/imported_file.hpp"
#include "importer/requirements.hpp"
#include "mesh/mesh.hpp"
#include "surfaces/recognise.hpp"

namespace epura::importer {

struct ReadOptions {
  std::vector<std::filesystem::path> plugin_path;  ///< additional folders with importers
  double tolerance = 0;              ///< greatest deviation of facets from curved surfaces, mm; 0: no bound
  double relative_tolerance = 1e-4;  ///< the same as a fraction of the diagonal of the model's box; 0: no bound
  int threads = 0;                   ///< greatest number for an importer; 0: all cores
  bool is_confined = true;           ///< importers open nothing but what is below the folder of their file
  bool allow_outside = false;        ///< they may read any file
};

struct ReadModel {
  mesh::Mesh mesh;
  std::shared_ptr<const surfaces::PartFaces> part{};  ///< faces declared by the file; null if there are none
  std::optional<double> unit{};                       ///< millimetres; nothing if the file does not state it
  bool is_y_up = false;                               ///< if the file states it
  std::vector<BodyPart> body_parts{};                 ///< by body of the mesh; empty for formats without parts
  std::vector<TreePart> tree{};                       ///< parents before children; empty for formats without a tree
  std::vector<ModelRequirement> requirements{};       ///< in the order of the file
  std::vector<SavedView> saved_views{};               ///< likewise
  std::string standard{};                             ///< of dimensions and tolerances; empty: the file names none
};

/// Reads mesh formats with mesh::read_mesh, and all other files with the importer for their extension or content.
/// `parameters` are those of the importer. Throws Error{input} with the location, Error{plugin}, OutOfTime. Every byte
/// of the file counts twice as progress.
ReadModel read_model(const std::filesystem::path& path, const foreign::Assignments& parameters,
                     const ReadOptions& options = {}, const Progress& progress = {});

/// The same for a file in memory. `name` precedes the location in errors; its extension counts.
ReadModel read_model(std::string bytes, const std::string& name, const foreign::Assignments& parameters,
                     const ReadOptions& options = {}, const Progress& progress = {});

/// The path of standard input.
inline constexpr const char* standard_input = "-";

/// The path and parameters in `PATH:key=value...`. If a file with this whole name exists, all of it is the path.
struct ModelRequest {
  std::string path;
  foreign::Assignments parameters;
};
ModelRequest parse_model_request(const std::string& text);

}  // namespace epura::importer
