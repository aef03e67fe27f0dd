// SPDX-License-Identifier: Apache-2.0
// Restrictions on the content and location of a case's files, since the folder may be untrusted.
#pragma once

#include <string>
#include <vector>

#include "app/snapshot/cases.hpp"

namespace epura {

/// Everything that is read for a case, and what is expected of it. Throws Error{input} for a scene that is none.
std::vector<std::filesystem::path> files_of(const SnapshotCase& one);

/// Throws Error{input} where a link in the folder that was named leads out of it on the way to one of the files, and
/// for devices and pipes. A path that a scene file names may lead anywhere: it can be seen there.
void refuse_links_outside(const SnapshotCase& one);

/// The words in the text of `options`. Throws Error{input} naming `file` where one is not an option of `epura draw`, or
/// is one that reads, writes, loads or runs something.
std::vector<std::string> drawing_options(const std::string& text, const std::string& file);

}  // namespace epura
