// SPDX-License-Identifier: Apache-2.0
// Snapshot cases: folders with a scene and its expected drawing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/html_report.hpp"
#include "snapshot/snapshot.hpp"

namespace epura {

/// A folder with scene.toml, optionally `options` (words for `epura draw`, separated by blanks), and one or more of
/// expected.json, expected.svg and expected.pdf.
struct SnapshotCase {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path root;  ///< the given folder, without symbolic links: no link inside may lead out of it
};

/// Returns those of the folders that are cases, and all cases below them, sorted by path. A case below a folder is
/// named by its path relative to it. Throws Error{input} for a folder without cases.
std::vector<SnapshotCase> find_cases(const std::vector<std::string>& folders);

enum class SnapshotVerdict { as_expected, different, new_case, failed };

/// A drawing made for a case, and the file with which it is compared.
struct SnapshotResult {
  std::string name;  ///< "cube-isometric/expected.json"
  std::filesystem::path expected;
  SnapshotVerdict verdict = SnapshotVerdict::failed;
  std::string words;     ///< differences, or the reason why nothing was drawn
  std::string actual{};  ///< bytes of the drawing
  compare::ReportedCase pictures{};
};

/// Draws the case and compares it with each expected drawing; a case without any is drawn for expected.svg. If a report
/// is wanted, `pictures` are made for differences.
std::vector<SnapshotResult> run_case(const SnapshotCase& one, const SnapshotOptions& options);

}  // namespace epura
