// SPDX-License-Identifier: Apache-2.0
// A document becomes one mesh: every shape where its nodes put it, with names of bodies and faces of the part.
#pragma once

#include <string>

#include "importer/document.hpp"

namespace epura::importer {

struct Assembled {
  mesh::Soup soup;
  /// No faces where some polygon is of none: then they are to be recognised.
  features::DeclaredPart part;
};

/// In the unit of the file. Bodies are named by what tells them apart of node, shape and body. `format` is the
/// importer's name. Throws Error{input} without a place where the nodes put down more than can be numbered.
Assembled assemble(const Document& document, const std::string& format);

}  // namespace epura::importer
