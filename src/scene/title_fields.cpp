// SPDX-License-Identifier: Apache-2.0
#include "scene/title_fields.hpp"

namespace epura::scene {

const std::vector<TitleField>& title_fields() {
  static const std::vector<TitleField> fields = {
      {"title", "title of the drawing"},
      {"supplementary_title", "second line of the title"},
      {"owner", "legal owner: firm or person"},
      {"number", "identification number of the drawing"},
      {"date", "date of issue, as it is to be written"},
      {"creator", "who made the drawing"},
      {"approver", "who approved it"},
      {"document_type", "such as: part drawing, assembly drawing"},
      {"revision", "index of the revision"},
      {"status", "such as: released, in preparation"},
      {"department", "responsible department"},
      {"technical_reference", "who answers questions"},
      {"classification", "keywords or classes"},
      {"language", "code of the language, such as en"},
      {"material", "material of the part"},
      {"mass", "mass of the part, with its unit"},
  };
  return fields;
}

}  // namespace epura::scene
