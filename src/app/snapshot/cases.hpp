// SPDX-License-Identifier: Apache-2.0
// Snapshot cases: folders with a scene and its expected drawing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/html_report.hpp"

namespace epura {

/// A folder with scene.toml, perhaps `options` (words for `epura draw`, with blanks between them), and expected.json,
/// expected.svg or expected.pdf, or several of them.
struct SnapshotCase {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path root;  ///< the folder that was named, without links: no link in it may lead out of it
};

/// The folders themselves, where they are cases, and all cases below them, sorted by path. A case below is named by its
/// path from there. Throws Error{input} for a folder without any.
std::vector<SnapshotCase> find_cases(const std::vector<std::string>& folders);

enum class SnapshotVerdict { as_expected, different, new_case, failed };

/// A drawing that was made for a case, and the file that it should be like.
struct SnapshotResult {
  std::string name;  ///< "cube-isometric/expected.json"
  std::filesystem::path expected;
  SnapshotVerdict verdict = SnapshotVerdict::failed;
  std::string words;     ///< what differs, or why nothing was drawn
  std::string actual{};  ///< bytes of the drawing
  compare::ReportedCase pictures{};
};

/// Draws the case and compares each expectation; a case without any is drawn for expected.svg. `pictures` are made
/// where `with_pictures` and something differs.
std::vector<SnapshotResult> run_case(const SnapshotCase& one, double tolerance, bool with_pictures);

}  // namespace epura
