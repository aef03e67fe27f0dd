// SPDX-License-Identifier: Apache-2.0
// Which files a run needs, and the sandbox that leaves it nothing else (foreign/sandbox.hpp).
#pragma once

#include <string>
#include <vector>

#include "app/jobs/jobs.hpp"
#include "app/options.hpp"
#include "foreign/sandbox.hpp"

namespace epura {

/// The files that a run names.
struct NamedFiles {
  std::vector<std::string> inputs;   ///< models with their parameters, scene files; "-": standard input
  std::vector<std::string> outputs;  ///< their folders must exist; "-": standard output
};

/// Returns the files of all jobs, and those that options of single jobs name.
NamedFiles files_of(const std::vector<Job>& jobs);

/// Returns what a process needs to draw: to read what lies below the folders of its inputs (everything, with
/// `allow_outside`), of plugins and of fonts, and the files that options of the sheet name, to write into the folders
/// of its outputs, and to start importers.
foreign::Permissions permissions_for(const NamedFiles& files, const pipeline::RunOptions& options,
                                     const scene::SheetDescription& sheet);

/// Confines this process to the files of all its drawings if `--sandbox on` asks for it. Called once, before the first
/// thread. Throws Error{input} where the kernel cannot do it.
void confine_if_asked(const DrawOptions& options, const NamedFiles& files);

}  // namespace epura
