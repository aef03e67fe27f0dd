// SPDX-License-Identifier: Apache-2.0
// What a sheet carries so that whoever receives it can draw it again: the options, the files that were read, what was
// found, and hashes of all (docs/reports.md).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/options.hpp"
#include "output/attachments.hpp"
#include "pipeline/draw_scene.hpp"
#include "pipeline/targets.hpp"

namespace epura {

/// Name of the attachment that describes all others.
inline constexpr const char* proof_name = "proof.toml";

/// A file that was read for a drawing.
struct ProofInput {
  std::string file;  ///< its path relative to the folder that all have in common
  std::string sha256;
  std::string attachment{};  ///< name of the attachment with its bytes; empty: the drawing does not carry it
};

/// The content of `proof_name`.
struct Proof {
  std::string version;                                         ///< of the epura that drew
  std::vector<std::string> models;                             ///< as on the command line; or one scene file
  std::vector<std::pair<std::string, std::string>> options{};  ///< as DrawOptions::given
  std::vector<ProofInput> inputs{};
  std::vector<std::pair<std::string, std::string>> results{};  ///< other attachments, and their hashes
};

/// Throws Error{input} if the drawing cannot carry its proof: no output can hold it, its inputs could not be found
/// again, or it may be incomplete.
void expect_provable(const DrawOptions& options, const std::vector<pipeline::Target>& targets);

/// The attachments of a drawing, which must have been tested, with its drawings kept. Reads the inputs again.
std::vector<output::Attachment> proof_of(const DrawOptions& options, const scene::SceneDescription& scene,
                                         const pipeline::DrawnScene& drawn);

/// Reads a proof; a stranger may have written it. Throws Error{input} for anything but what `proof_of` writes: names of
/// files lie below an empty folder, options are those of a drawing.
Proof read_proof(const std::filesystem::path& file);

/// The version of this program.
std::string own_version();

}  // namespace epura
