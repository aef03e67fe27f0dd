// SPDX-License-Identifier: Apache-2.0
// Files -> documents of Open CASCADE: shapes with names, in a tree of assemblies.
#pragma once

#include <TDocStd_Document.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <string>
#include <vector>

#include "watch.hpp"

namespace epura_occt {

struct ModelFile {
  Handle(TDocStd_Document) document;
  Handle(XCAFDoc_ShapeTool) shapes;
  std::vector<std::string> notes;
};

// Lengths are millimetres, whatever the file has. Throw std::runtime_error with a sentence.
ModelFile read_step(const std::string& path, Watch& watch);
ModelFile read_iges(const std::string& path, Watch& watch);
ModelFile read_brep(const std::string& path, Watch& watch);

}  // namespace epura_occt
