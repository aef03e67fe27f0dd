// SPDX-License-Identifier: Apache-2.0
// Assembles a document into one mesh: every shape at the positions given by its nodes, with the names of bodies and the
// faces of the part.
#pragma once

#include <string>
#include <vector>

#include "importer/document.hpp"

namespace epura::importer {

/// A node of the file's tree, or a shape in a file without nodes.
struct TreePart {
  int parent = -1;  ///< index of an earlier node; -1: none
  std::string name{};
  int bodies = 0, faces = 0;  ///< number in its own shape
};

/// The part that a body is, or belongs to.
struct BodyPart {
  std::string name;     ///< of the part, wherever it occurs; may be empty
  int occurrence = -1;  ///< number of the part in the tree; of the one above it if it has no name
};

struct Assembled {
  mesh::Soup soup;
  double step = 0;                   ///< distance between neighbouring values of coordinates; 0: they are not rounded
  std::vector<BodyPart> body_parts;  ///< by body name of the soup
  std::vector<TreePart> tree;
  /// Empty if some polygon belongs to no face: faces must then be recognised.
  surfaces::DeclaredPart part;
  /// By shape of the document: the number in `part` of its first face, wherever it stands.
  std::vector<std::vector<int>> first_faces;
  std::vector<std::vector<Mat4>> places;  ///< likewise: to the coordinates of the file
};

/// Lengths are in the unit of the file. Names of bodies combine the name of the node or its shape with that of the
/// body. `format` is the name of the importer. Throws Error{input} without a location if the nodes result in more items
/// than can be numbered.
Assembled assemble(const Document& document, const std::string& format);

}  // namespace epura::importer
