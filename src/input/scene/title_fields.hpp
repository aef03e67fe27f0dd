// SPDX-License-Identifier: Apache-2.0
// The named fields of a title block. ISO 7200.
#pragma once

#include <string>
#include <vector>

namespace epura::scene {

struct TitleField {
  std::string name;  ///< "document_type": key of scene files, and option of the command line with "-" for "_"
  std::string help;
};

/// The table from which options, keys of scene files and the documentation are generated.
const std::vector<TitleField>& title_fields();

}  // namespace epura::scene
