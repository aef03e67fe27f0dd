// SPDX-License-Identifier: Apache-2.0
#include "sheet/phrases.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::sheet {

namespace {

struct PhraseRow {
  std::string_view key;
  std::array<std::string_view, languages_of_phrases.size()> words;
};

// Of `epura describe`.
constexpr PhraseRow described_rows[] = {
    {"part", {"The sheet{0} shows a part.", "Das Blatt{0} zeigt ein Teil.", "La feuille{0} montre une pièce."}},
    {"assembly",
     {"The sheet{0} shows an assembly of {1} bodies.", "Das Blatt{0} zeigt eine Baugruppe aus {1} Körpern.",
      "La feuille{0} montre un ensemble de {1} corps."}},
    {"open",
     {"The sheet{0} shows a model with open edges.", "Das Blatt{0} zeigt ein Modell mit offenen Kanten.",
      "La feuille{0} montre un modèle à arêtes libres."}},
    {"wires",
     {"The sheet{0} shows lines without faces.", "Das Blatt{0} zeigt Linien ohne Flächen.",
      "La feuille{0} montre des lignes sans faces."}},
    {"box",
     {"Overall size: {0} × {1} × {2} {3} (width × depth × height).",
      "Gesamtmaße: {0} × {1} × {2} {3} (Breite × Tiefe × Höhe).",
      "Dimensions hors tout : {0} × {1} × {2} {3} (largeur × profondeur × hauteur)."}},
    {"turned",
     {"Overall size: diameter {0} {2}, length {1} {2}.", "Gesamtmaße: Durchmesser {0} {2}, Länge {1} {2}.",
      "Dimensions hors tout : diamètre {0} {2}, longueur {1} {2}."}},
    {"ball",
     {"Overall size: diameter {0} {1} in all directions.", "Gesamtmaß: Durchmesser {0} {1} in allen Richtungen.",
      "Dimension hors tout : diamètre {0} {1} dans toutes les directions."}},
    {"faces", {"Faces: {0}.", "Flächen: {0}.", "Faces : {0}."}},
    {"plane", {"{0} plane", "{0} eben", "{0} planes"}},
    {"cylinder", {"{0} cylindrical", "{0} zylindrisch", "{0} cylindriques"}},
    {"cone", {"{0} conical", "{0} kegelig", "{0} coniques"}},
    {"sphere", {"{0} spherical", "{0} kugelig", "{0} sphériques"}},
    {"torus", {"{0} toroidal", "{0} torusförmig", "{0} toriques"}},
    {"free-form", {"{0} free-form", "{0} frei geformt", "{0} de forme libre"}},
    {"views", {"Views: {0}.", "Ansichten: {0}.", "Vues : {0}."}},
    {"sections", {"sections: {0}", "Schnitte: {0}", "coupes : {0}"}},
    {"section", {"{0} in view {1}", "{0} in Ansicht {1}", "{0} dans la vue {1}"}},
    {"details", {"details: {0}", "Einzelheiten: {0}", "détails : {0}"}},
    {"special", {"Among them {0}.", "Darunter {0}.", "Parmi elles {0}."}},
    {"holes", {"Holes: {0}.", "Bohrungen: {0}.", "Trous : {0}."}},
    {"diameter", {"diameter {0}", "Durchmesser {0}", "diamètre {0}"}},
    {"through", {", through", ", durchgehend", ", débouchant"}},
    {"thread deep", {", thread {0} deep", ", Gewinde {0} tief", ", filetage profondeur {0}"}},
    {"core deep", {", core hole {0} deep", ", Kernloch {0} tief", ", avant-trou profondeur {0}"}},
    {"deep", {", {0} deep", ", {0} tief", ", profondeur {0}"}},
    {"counterbore",
     {", counterbore diameter {0}, {1} deep", ", Flachsenkung Durchmesser {0}, {1} tief",
      ", lamage diamètre {0}, profondeur {1}"}},
    {"countersink",
     {", countersink diameter {0}, {1}", ", Kegelsenkung Durchmesser {0}, {1}", ", fraisure diamètre {0}, {1}"}},
    {"others", {"Other features: {0}.", "Weitere Formelemente: {0}.", "Autres éléments : {0}."}},
    {"shaft", {"outer cylinder {0}", "Außenzylinder {0}", "cylindre extérieur {0}"}},
    {"bore", {"inner cylinder {0}", "Innenzylinder {0}", "cylindre intérieur {0}"}},
    {"slot", {"slot {0} wide", "Langloch {0} breit", "trou oblong de largeur {0}"}},
    {"radius", {"radius {0}", "Radius {0}", "rayon {0}"}},
    {"hexagon", {"hexagon {0} across flats", "Sechskant, Schlüsselweite {0}", "hexagone {0} sur plats"}},
    {"chamfer", {"chamfer", "Fase", "chanfrein"}},
    {"annotations", {"Written on it: {0}.", "Darauf steht: {0}.", "Y figurent : {0}."}},
    {"dimensions", {"dimensions: {0}", "Maße: {0}", "cotes : {0}"}},
    {"tolerances", {"geometrical tolerances: {0}", "geometrische Toleranzen: {0}", "tolérances géométriques : {0}"}},
    {"notes", {"notes with leaders: {0}", "Hinweise mit Hinweislinien: {0}", "notes avec lignes de repère : {0}"}},
    {"rows", {"rows of tables: {0}", "Tabellenzeilen: {0}", "lignes de tableaux : {0}"}},
    {"parts", {"Parts: {0}.", "Teile: {0}.", "Pièces : {0}."}},
    {"no hidden",
     {"Views without hidden lines: {0}.", "Ansichten ohne verdeckte Kanten: {0}.", "Vues sans arêtes cachées : {0}."}},
    {"not drawn", {"Not drawn: {0}.", "Nicht gezeichnet: {0}.", "Non dessiné : {0}."}},
    {"dimensions without room", {"dimensions without room: {0}", "Maße ohne Platz: {0}", "cotes sans place : {0}"}},
    {"texts without room",
     {"notes, symbols and tables without room: {0}", "Hinweise, Symbole und Tabellen ohne Platz: {0}",
      "notes, symboles et tableaux sans place : {0}"}},
    {"requirements", {"requirements of the model: {0}", "Forderungen des Modells: {0}", "exigences du modèle : {0}"}},
    {"some lines",
     {"lines for which there was no time", "Linien, für die die Zeit fehlte",
      "lignes pour lesquelles le temps manquait"}},
};

// Of what is read aloud, element by element.
constexpr PhraseRow read_rows[] = {
    {"hole", {"hole, {0}", "Bohrung, {0}", "trou, {0}"}},
    {"more", {"and {0} more", "und {0} weitere", "et {0} autres"}},
    {"frame", {"Frame and title block", "Rahmen und Schriftfeld", "Cadre et cartouche"}},
    {"view", {"View {0}", "Ansicht {0}", "Vue {0}"}},
    {"scale", {", scale {0}", ", Maßstab {0}", ", échelle {0}"}},
    {"one visible", {"visible line{0}", "sichtbare Linie{0}", "ligne visible{0}"}},
    {"one hidden", {"hidden line{0}", "verdeckte Linie{0}", "ligne cachée{0}"}},
    {"visible line", {"{0} visible line", "{0} sichtbare Linie", "{0} ligne visible"}},
    {"visible lines", {"{0} visible lines", "{0} sichtbare Linien", "{0} lignes visibles"}},
    {"hidden line", {"{0} hidden line", "{0} verdeckte Linie", "{0} ligne cachée"}},
    {"hidden lines", {"{0} hidden lines", "{0} verdeckte Linien", "{0} lignes cachées"}},
    {"length", {"length {0}", "Länge {0}", "longueur {0}"}},
    {"angle", {"angle {0}", "Winkel {0}", "angle {0}"}},
    {"coordinate", {"coordinate {0}", "Koordinate {0}", "coordonnée {0}"}},
    {"tolerance", {"tolerance {0}", "Toleranz {0}", "tolérance {0}"}},
    {"table", {"table{0}", "Tabelle{0}", "tableau{0}"}},
    {"row", {"{0} row", "{0} Zeile", "{0} ligne"}},
    {"table rows", {"{0} rows", "{0} Zeilen", "{0} lignes"}},
    {"logo", {"logo", "Logo", "logo"}},
};

constexpr PhraseRow projection_rows[] = {
    {"front", {"front", "Vorderansicht", "vue de face"}},
    {"back", {"back", "Rückansicht", "vue d'arrière"}},
    {"left", {"left", "Seitenansicht von links", "vue de gauche"}},
    {"right", {"right", "Seitenansicht von rechts", "vue de droite"}},
    {"top", {"top", "Draufsicht", "vue de dessus"}},
    {"bottom", {"bottom", "Untersicht", "vue de dessous"}},
    {"isometric", {"isometric", "isometrisch", "isométrique"}},
    {"dimetric", {"dimetric", "dimetrisch", "dimétrique"}},
    {"trimetric", {"trimetric", "trimetrisch", "trimétrique"}},
};

constexpr PhraseRow characteristic_rows[] = {
    {"straightness", {"straightness", "Geradheit", "rectitude"}},
    {"flatness", {"flatness", "Ebenheit", "planéité"}},
    {"roundness", {"roundness", "Rundheit", "circularité"}},
    {"cylindricity", {"cylindricity", "Zylindrizität", "cylindricité"}},
    {"line-profile", {"line profile", "Linienprofil", "profil d'une ligne"}},
    {"surface-profile", {"surface profile", "Flächenprofil", "profil d'une surface"}},
    {"parallelism", {"parallelism", "Parallelität", "parallélisme"}},
    {"perpendicularity", {"perpendicularity", "Rechtwinkligkeit", "perpendicularité"}},
    {"angularity", {"angularity", "Neigung", "inclinaison"}},
    {"position", {"position", "Position", "localisation"}},
    {"concentricity", {"concentricity", "Konzentrizität", "concentricité"}},
    {"symmetry", {"symmetry", "Symmetrie", "symétrie"}},
    {"circular-run-out", {"circular run-out", "Rundlauf", "battement circulaire"}},
    {"total-run-out", {"total run-out", "Gesamtlauf", "battement total"}},
};

// A bit for each place.
constexpr unsigned places_of(std::string_view words) {
  unsigned places = 0;
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == '{') places |= 1U << static_cast<unsigned>(words[i + 1] - '0');
  return places;
}

constexpr bool say_the_same(std::span<const PhraseRow> table) {
  for (const PhraseRow& row : table)
    for (const std::string_view words : row.words)
      if (words.empty() || places_of(words) != places_of(row.words.front())) return false;
  return true;
}
static_assert(say_the_same(described_rows) && say_the_same(read_rows), "a phrase tells the same in all languages");

std::size_t phrase_column(std::string_view language) {
  const auto* found = std::find(languages_of_phrases.begin(), languages_of_phrases.end(), language);
  check(found != languages_of_phrases.end(), "phrases are in this language");
  return static_cast<std::size_t>(found - languages_of_phrases.begin());
}

const PhraseRow* find_row(std::span<const PhraseRow> table, std::string_view key) {
  const auto row = std::find_if(table.begin(), table.end(), [key](const PhraseRow& one) { return one.key == key; });
  return row == table.end() ? nullptr : &*row;
}

// What is not in the table has the same name in all languages.
std::string word_for(std::span<const PhraseRow> table, std::string_view key, std::string_view language) {
  const PhraseRow* row = find_row(table, key);
  return std::string(row == nullptr ? key : row->words[phrase_column(language)]);
}

}  // namespace

std::string_view language_of_phrases(std::string_view code) {
  const std::string base = to_lower(code.substr(0, code.find_first_of("-_")));
  const auto* found = std::find(languages_of_phrases.begin(), languages_of_phrases.end(), base);
  return found == languages_of_phrases.end() ? languages_of_phrases.front() : *found;
}

std::string phrase(std::string_view key, std::string_view language, std::span<const std::string> texts) {
  const PhraseRow* row = find_row(described_rows, key);
  if (row == nullptr) row = find_row(read_rows, key);
  check(row != nullptr, "there is such a phrase");
  std::string_view rest = row->words[phrase_column(language)];
  std::string words;
  for (std::size_t open = 0; (open = rest.find('{')) != std::string_view::npos; rest.remove_prefix(open + 3)) {
    const auto number = static_cast<std::size_t>(rest[open + 1] - '0');
    check(number < texts.size(), "a phrase has a text for each of its places");
    words.append(rest.substr(0, open)).append(texts[number]);
  }
  return words.append(rest);
}

std::string projection_in_words(std::string_view projection, std::string_view language) {
  return word_for(projection_rows, projection, language);
}

std::string characteristic_in_words(std::string_view characteristic, std::string_view language) {
  return word_for(characteristic_rows, characteristic, language);
}

}  // namespace epura::sheet
