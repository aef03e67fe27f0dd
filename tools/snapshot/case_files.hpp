// SPDX-License-Identifier: Apache-2.0
// Restricts the content and location of a case's files, since the folder may be untrusted.
#pragma once

#include <string>
#include <vector>

#include "snapshot/cases.hpp"

namespace epura {

/// Returns all files that are read for a case, including its expected drawings. Throws Error{input} for an invalid
/// scene.
std::vector<std::filesystem::path> files_of(const SnapshotCase& one);

/// Throws Error{input} if a symbolic link on the way to one of the files leads out of the given folder, and for devices
/// and pipes. A path in a scene file may lead anywhere, since it is visible there.
void refuse_links_outside(const SnapshotCase& one);

/// Returns the words in the text of `options`. Throws Error{input} with `file` as the location for a word that is not
/// an option of `epura draw`, or is an option that reads, writes, loads or runs something.
std::vector<std::string> drawing_options(const std::string& text, const std::string& file);

/// Throws Error{input} if one of the words is a link that leads out of the given folder, or a path on which one lies.
void refuse_options_outside(const std::vector<std::string>& words, const SnapshotCase& one);

}  // namespace epura
