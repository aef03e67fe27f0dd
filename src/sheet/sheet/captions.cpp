// SPDX-License-Identifier: Apache-2.0
#include "sheet/captions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "base/text.hpp"

namespace epura::sheet {

namespace {

constexpr std::array<std::string_view, 6> languages{"en", "de", "fr", "es", "pt", "ja"};

struct CaptionRow {
  std::string_view key;
  std::array<std::string_view, languages.size()> words;
};

constexpr std::array<CaptionRow, 33> rows{{
    {"owner",
     {"Legal owner", "Gesetzlicher Eigentümer", "Propriétaire légal", "Propietario legal", "Proprietário legal",
      "法的所有者"}},
    {"title",
     {"Title, supplementary title", "Titel, zusätzlicher Titel", "Titre, titre complémentaire",
      "Título, título suplementario", "Título, título suplementar", "表題、補足表題"}},
    {"revision", {"Rev.", "Änd.", "Rév.", "Rev.", "Rev.", "改訂"}},
    {"date", {"Date of issue", "Ausgabedatum", "Date d'édition", "Fecha de edición", "Data de emissão", "発行日"}},
    {"language", {"Lang.", "Spr.", "Lang.", "Id.", "Id.", "言語"}},
    {"sheet", {"Sheet", "Blatt", "Feuille", "Hoja", "Folha", "葉番"}},
    {"number",
     {"Identification number", "Identifikationsnummer", "Numéro d'identification", "Número de identificación",
      "Número de identificação", "識別番号"}},
    {"document_type",
     {"Document type", "Dokumentenart", "Type de document", "Tipo de documento", "Tipo de documento", "文書の種類"}},
    {"status",
     {"Document status", "Dokumentenstatus", "Statut du document", "Estado del documento", "Estado do documento",
      "文書の状態"}},
    {"department",
     {"Responsible department", "Verantwortliche Abteilung", "Service responsable", "Departamento responsable",
      "Departamento responsável", "担当部門"}},
    {"technical_reference",
     {"Technical reference", "Technische Referenz", "Référence technique", "Referencia técnica", "Referência técnica",
      "技術照会先"}},
    {"creator", {"Created by", "Erstellt durch", "Établi par", "Creado por", "Criado por", "作成者"}},
    {"approver", {"Approved by", "Genehmigt von", "Approuvé par", "Aprobado por", "Aprovado por", "承認者"}},
    {"material", {"Material", "Werkstoff", "Matière", "Material", "Material", "材料"}},
    {"mass", {"Mass", "Masse", "Masse", "Masa", "Massa", "質量"}},
    {"general_tolerance",
     {"General tolerances", "Allgemeintoleranzen", "Tolérances générales", "Tolerancias generales",
      "Tolerâncias gerais", "普通公差"}},
    {"standard", {"Standard", "Norm", "Norme", "Norma", "Norma", "規格"}},
    {"scale", {"Scale", "Maßstab", "Échelle", "Escala", "Escala", "尺度"}},
    {"size", {"Size", "Format", "Format", "Formato", "Formato", "用紙"}},
    {"hole", {"Hole", "Bohrung", "Trou", "Agujero", "Furo", "穴"}},
    {"hole_size", {"Size", "Größe", "Dimension", "Medida", "Medida", "寸法"}},
    {"item", {"Item", "Pos.", "Rep.", "Marca", "Item", "照合番号"}},
    {"quantity", {"Qty", "Menge", "Qté", "Cant.", "Qtd.", "個数"}},
    {"name", {"Name", "Benennung", "Désignation", "Denominación", "Denominação", "品名"}},
    {"change", {"Change", "Änderung", "Modification", "Modificación", "Alteração", "変更内容"}},
    {"change_date", {"Date", "Datum", "Date", "Fecha", "Data", "日付"}},
    {"changed_by", {"By", "Name", "Par", "Por", "Por", "担当"}},
    {"notes", {"Notes", "Hinweise", "Notes", "Notas", "Notas", "注記"}},
    {"free_forms",
     {"Free forms as in the 3D model", "Freiformflächen nach 3D-Modell", "Formes libres selon le modèle 3D",
      "Formas libres según el modelo 3D", "Formas livres conforme o modelo 3D", "自由曲面は3Dモデルによる"}},
    {"error",
     {"Lines on paper within", "Linien auf Papier auf", "Traits sur papier à moins de", "Líneas en papel dentro de",
      "Linhas no papel dentro de", "紙面上の線の誤差"}},
    {"mm", {"Dimensions in mm", "Maße in mm", "Cotes en mm", "Cotas en mm", "Cotas em mm", "寸法単位 mm"}},
    {"in",
     {"Dimensions in inches", "Maße in Zoll", "Cotes en pouces", "Cotas en pulgadas", "Cotas em polegadas",
      "寸法単位 インチ"}},
    {"m", {"Dimensions in m", "Maße in m", "Cotes en m", "Cotas en m", "Cotas em m", "寸法単位 m"}},
}};

// The end of `languages` for those that are not among them.
const std::string_view* find_language(std::string_view code) {
  return std::find(languages.begin(), languages.end(), to_lower(code.substr(0, code.find_first_of("-_"))));
}

}  // namespace

bool has_captions(std::string_view language) { return language.empty() || find_language(language) != languages.end(); }

std::string_view caption(std::string_view key, std::string_view language) {
  const auto* found = find_language(language);
  const std::size_t column = found == languages.end() ? 0 : static_cast<std::size_t>(found - languages.begin());
  const auto* row = std::find_if(rows.begin(), rows.end(), [key](const CaptionRow& one) { return one.key == key; });
  return row == rows.end() ? std::string_view() : row->words[column];
}

}  // namespace epura::sheet
