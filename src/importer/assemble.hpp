// SPDX-License-Identifier: Apache-2.0
// A document becomes one mesh: every shape where its nodes put it, with names of bodies and faces of the part.
#pragma once

#include <string>
#include <vector>

#include "importer/document.hpp"

namespace epura::importer {

/// A node of the file's tree, or a shape that stands by itself.
struct TreePart {
  int parent = -1;  ///< number of an earlier one
  std::string name{};
  int bodies = 0, faces = 0;  ///< of its own shape
};

struct Assembled {
  mesh::Soup soup;
  std::vector<TreePart> tree;
  /// No faces where some polygon is of none: then they are to be recognised.
  features::DeclaredPart part;
};

/// In the unit of the file. Bodies are named by what tells them apart of node, shape and body. `format` is the
/// importer's name. Throws Error{input} without a place where the nodes put down more than can be numbered.
Assembled assemble(const Document& document, const std::string& format);

}  // namespace epura::importer
