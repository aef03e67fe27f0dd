// SPDX-License-Identifier: Apache-2.0
// Runs importers in a separate process: their library is loaded by another program (importer/host.cpp). Whatever the
// library does there - crash, hang, exit, print - reaches this process only as an error message.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "importer/loader.hpp"

namespace epura::importer {

/// Time limit for loading a library, in seconds. Reading is limited only by the time of the run.
inline constexpr double loading_seconds = 10;

/// The library's process.
class Process;

/// An importer provided by a library. Copies share the process, which ends with the last of them.
struct ImporterEntry {
  ImporterTable table;
  std::filesystem::path library;
  std::shared_ptr<Process> process;

  /// Whether the importer recognises a file by its first bytes. Throws Error{plugin} with the path of the library.
  [[nodiscard]] bool recognises(std::string_view first_bytes) const;
  /// `tell` receives the fraction that is done, from 0 to 1. Throws Error{input} with the path of the file if it is
  /// invalid, Error{plugin} with the path of the library if the importer fails; OutOfTime, Stopped.
  [[nodiscard]] ImportedFile read(const Reading& reading, const std::function<void(double)>& tell,
                                  const Progress& progress) const;
};

/// Returns what a process may open that is confined for a file: what lies below its folder, and what the file itself,
/// if it is a link, stands for; or everything.
std::vector<std::filesystem::path> readable_for(const std::filesystem::path& file, bool allow_outside);

/// Returns the importers of a library; nothing for a library of projections. Throws Error{plugin} without its path.
std::vector<ImporterEntry> importers_of(const std::filesystem::path& library, double seconds = loading_seconds);

/// The main function of importer/host.cpp: loads the library and answers over the socket until it is closed.
void serve(const std::filesystem::path& library, int socket);

}  // namespace epura::importer
