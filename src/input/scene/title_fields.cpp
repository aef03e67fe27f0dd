// SPDX-License-Identifier: Apache-2.0
#include "scene/title_fields.hpp"

namespace epura::scene {

const std::vector<TitleField>& title_fields() {
  static const std::vector<TitleField> fields = {
      {"title", "title of the drawing"},
      {"supplementary_title", "second line of the title"},
      {"owner", "legal owner: company or person"},
      {"number", "identification number of the drawing"},
      {"date", "date of issue, printed as given"},
      {"creator", "who made the drawing"},
      {"approver", "who approved it"},
      {"document_type", "document type, such as part drawing, assembly drawing"},
      {"revision", "revision index"},
      {"status", "document status, such as released, in preparation"},
      {"department", "responsible department"},
      {"technical_reference", "contact for technical questions"},
      {"classification", "keywords or classes"},
      {"language",
       "language code, such as en; captions are in English, German (de), French (fr), Spanish (es), Portuguese (pt) or "
       "Japanese (ja)"},
      {"material", "material of the part"},
      {"mass", "mass of the part, with unit; auto: from its volume and density"},
      {"general_tolerance", "general tolerances, such as ISO 2768-m or ISO 22081, for sizes without one of their own"},
      {"standard", "standard of dimensions and tolerances, such as ISO 8015 or ASME Y14.5"},
  };
  return fields;
}

}  // namespace epura::scene
