// SPDX-License-Identifier: Apache-2.0
// Importers at arm's length: their library is loaded by a program of its own (importer/host.cpp). What it does there -
// crash, hang, end the program, print - reaches this process as a sentence.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "importer/loader.hpp"

namespace epura::importer {

/// Seconds that a library may take to load. Reading may take as long as the run.
inline constexpr double loading_seconds = 10;

/// The library's process.
class Process;

/// An importer that a library offers. Copies share the process, which ends with the last.
struct ImporterEntry {
  ImporterTable table;
  std::filesystem::path library;
  std::shared_ptr<Process> process;

  /// Whether a file with these first bytes is one of its own. Throws Error{plugin} with the library.
  [[nodiscard]] bool recognises(std::string_view first_bytes) const;
  /// `tell` is told how much is done, from 0 to 1. Throws Error{input} with the path for what is wrong with the file,
  /// Error{plugin} with the library for what is wrong with the importer; OutOfTime, Stopped.
  [[nodiscard]] Document read(const Reading& reading, const std::function<void(double)>& tell,
                              const Progress& progress) const;
};

/// What the library offers; nothing where it is one of projections. Throws Error{plugin} without its path.
std::vector<ImporterEntry> importers_of(const std::filesystem::path& library, double seconds = loading_seconds);

/// What the program in importer/host.cpp does: loads the library and answers over the socket until that is closed.
void serve(const std::filesystem::path& library, int socket);

}  // namespace epura::importer
