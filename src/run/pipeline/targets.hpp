// SPDX-License-Identifier: Apache-2.0
// The files to write.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "composition/finished_sheet.hpp"
#include "output/format.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"

namespace epura::pipeline {

struct Target {
  std::string path;  ///< "-" for standard output
  const output::Format* format;
};

/// Formats are determined before any work is done: a long run must not fail because of a typing error. `dash_format` is
/// the format of "-". Throws Error{input}.
std::vector<Target> targets_of(const std::vector<std::string>& paths, const std::string& dash_format);

/// The files written for a number of `sheets` (or pages, or diagrams), one for each: if there are several, x-1.svg,
/// x-2.svg for x.svg.
std::vector<std::string> one_for_each(const std::string& path, std::size_t sheets);

/// The same, but formats with pages have one file for all sheets.
std::vector<std::string> files_of(const Target& target, std::size_t sheets);
std::vector<std::string> files_of(const std::vector<Target>& targets, std::size_t sheets);

/// The model files that a scene reads.
std::vector<std::string> inputs_of(const scene::SceneDescription& scene);

/// To be called before anything is written: an output that is also an input, under whatever name, would destroy the
/// user's source; of two outputs that are the same file, the first would be lost. Throws Error{input}.
void refuse_overwriting(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

struct FileBytes {
  std::string path, bytes;
};

/// Warns of pictures that a format leaves out.
void warn_about_pictures(const Messages& messages, const std::vector<Target>& targets,
                         std::span<const FinishedSheet> sheets);

/// Encodes all files of all targets. Throws OutOfTime.
std::vector<FileBytes> encode_all(const std::vector<Target>& targets, std::span<const FinishedSheet> sheets,
                                  const output::VectorOptions& options, const report::Report& report,
                                  Progress progress);

/// Throws Error{output}.
void write(const FileBytes& file, Progress progress);

}  // namespace epura::pipeline
