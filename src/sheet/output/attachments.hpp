// SPDX-License-Identifier: Apache-2.0
// Files that a drawing carries: what it was drawn from, and what was found out about it.
//
// Included by pdf/, which is C++17, see CMakeLists.txt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace epura::output {

/// How a file relates to the drawing. ISO 32000-2, 7.11.3, table 43: AFRelationship.
enum class Relation { source, data };

/// The names are those of PDF, and of the attribute in SVG.
inline std::string_view name_of(Relation relation) { return relation == Relation::source ? "Source" : "Data"; }

struct Attachment {
  std::string name;         ///< unique
  std::string media_type;   ///< "application/json" (RFC 6838)
  std::string description;  ///< for people
  Relation relation;
  std::string bytes;
};

/// Whether names of attachments are safe to write below an empty folder: relative, without "..", "." or empty parts,
/// control characters, or backslashes.
bool is_safe_name(std::string_view name);

/// Appends `<epura:attachment name="..." ...>base64</epura:attachment>` of each for the metadata of an SVG document.
void append_attachments(std::string& svg, const std::vector<Attachment>& attachments);

}  // namespace epura::output
