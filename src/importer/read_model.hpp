// SPDX-License-Identifier: Apache-2.0
// Any model file -> mesh, and the faces of the part where the file has them.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "features/recognise.hpp"
#include "foreign/parameters.hpp"
#include "importer/assemble.hpp"
#include "mesh/mesh.hpp"

namespace epura::importer {

struct ReadOptions {
  std::vector<std::filesystem::path> plugin_path;  ///< more folders with importers
  double tolerance = 0;                            ///< mm that curved surfaces may be off by; 0: no bound
  double relative_tolerance = 1e-4;  ///< the same in parts of the diagonal of the model's box; 0: no bound
  int threads = 0;                   ///< that an importer may use; 0: all cores
};

struct ReadModel {
  mesh::Mesh mesh;
  std::shared_ptr<const features::PartFaces> part{};  ///< as the file declares them; null where it does not
  std::optional<double> unit{};                       ///< millimetres; nothing where the file does not say it
  bool is_y_up = false;                               ///< as far as the file says it
  std::vector<TreePart> tree{};                       ///< parents before children; empty for formats without parts
};

/// Reads what mesh::read_mesh reads, and all other files by the importer of their extension or content. `parameters`
/// are the importer's. Throws Error{input} with the place, Error{plugin}, OutOfTime. Every byte of the file counts
/// twice as progress.
ReadModel read_model(const std::filesystem::path& path, const foreign::Assignments& parameters,
                     const ReadOptions& options = {}, const Progress& progress = {});

/// The path and the parameters that `PATH:key=value...` stands for; a file of that very name is a path.
struct ModelRequest {
  std::string path;
  foreign::Assignments parameters;
};
ModelRequest parse_model_request(const std::string& text);

}  // namespace epura::importer
