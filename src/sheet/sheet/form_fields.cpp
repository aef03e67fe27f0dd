// SPDX-License-Identifier: Apache-2.0
#include "sheet/form_fields.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text.hpp"
#include "scene/title_fields.hpp"

namespace epura::sheet {

namespace {

struct UsualNames {
  std::string_view field;
  std::string_view names;  ///< in small letters, without blanks, hyphens and underscores
};

// Of the templates of FreeCAD 0.20 to 1.0 (English, French, Italian, Spanish, Russian, Chinese).
constexpr std::array<UsualNames, 16> usual_names{{
    {"title", "title drawingtitle drawingtitle1 fctitle titleline1 partname titre titolo denominacion Название"},
    {"supplementary_title", "subtitle drawingtitle2 titleline2 soustitre sottotitolo"},
    {"owner", "owner ownername companyname company organization organisation societe ditta empresa Организация2"},
    {"creator", "author authorname drawnby designedbyname nomauteur nomeprogettista nombredibujo Разработал"},
    {"approver", "approvername supervisorname approved1 nomsuperviseur supervisore nombreaprobacion Утвердил"},
    {"number", "drawingnumber dn partcodename n°plano Номер"},
    {"date", "date date1 fcdate creationdate datedecreation datadicreazione fechadedibujo Датаразработки"},
    {"revision", "revision fcrev version numerodiversione"},
    {"scale", "scale fcscale fcsc echelle scala escala Масштаб"},
    {"size", "size fcsi a3"},
    {"sheet", "sheet sheetnumber fcsh feuille foglio"},
    {"page_number", "ofsheet Лист"},
    {"page_count", "totalsheets Листов"},
    {"mass", "weight poids peso Масса"},
    {"material", "materialmark Материал2"},
    {"general_tolerance", "tolerance tolerancia"},
}};

}  // namespace

std::vector<std::string> known_fields() {
  std::vector<std::string> names = {"scale", "size", "sheet", "page_number", "page_count"};
  for (const scene::TitleField& field : scene::title_fields()) names.push_back(field.name);
  return names;
}

std::string form_name(const std::string& field) {
  std::string name = to_lower(field);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

std::string field_of(const svg::Words& words) {
  if (!words.is_field) return words.name;
  std::string plain = words.name;
  std::erase(plain, '_');
  for (const UsualNames& usual : usual_names)
    for (const std::string_view name : split(usual.names, ' '))
      if (name == plain) return std::string(usual.field);
  return words.name;
}

}  // namespace epura::sheet
