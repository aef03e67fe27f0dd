// SPDX-License-Identifier: Apache-2.0
#include "sizes/note_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace epura::sheet {

namespace {

using enum WordUse;

// English, German, French, Italian, Spanish.
constexpr std::array words{
    NoteWords{counterbore, "⌴|COUNTERBORE|CBORE|C'BORE|C-BORE|C BORE|SPOTFACE|SPOT FACE|FLACHSENKUNG|LAMAGE|LAMATURA"},
    NoteWords{countersink, "⌵|COUNTERSINK|CSINK|CSK|KEGELSENKUNG|FRAISURE|SVASATURA|AVELLANADO"},
    NoteWords{recess, "SENKUNG"},
    NoteWords{depth, "↧|DEPTH|DEEP|TIEFE|TIEF|PROFONDEUR|PROFONDITA|PROFUNDIDAD|PROFOND|PROF"},
    NoteWords{length,
              "LENGTH|LONG|WIDTH|WIDE|HEIGHT|HIGH|LANGE|GESAMTLANGE|LANG|BREITE|BREIT|HOHE|HOCH|LONGUEUR HORS "
              "TOUT|LONGUEUR|LARGEUR|HAUTEUR|"
              "LUNGHEZZA|LARGHEZZA|ALTEZZA|LONGITUD|ANCHURA|ANCHO|ALTURA|H=|H =|L=|L =|B=|B ="},
    NoteWords{thickness,
              "THICKNESS|THICK|THK|DICKE|DICK|BLECHDICKE|STARKE|STARK|EPAISSEUR|EPAIS|EP|SPESSORE|ESPESOR|T=|T ="},
    NoteWords{through,
              "THROUGH|THRU|DURCHGEHENDE|DURCHGEHEND|DURCH|DEBOUCHANTS|DEBOUCHANT|TRAVERSANTS|TRAVERSANT|PASSANTE|"
              "PASSANTI|PASANTES|PASANTE"},
    NoteWords{blind, "BLIND|SACKLOCHER|SACKLOCH|BORGNES|BORGNE|CIECHI|CIECO|CIEGOS|CIEGO"},
    NoteWords{diameter, "DIAMETER|DIAMETRE|DIAMETRO|DURCHMESSER|DIAM|DIA|D"},
    NoteWords{drilled, "DRILLED|DRILL|BORED|BORE|REAMED|REAM|GEBOHRT|GERIEBEN|PERCE|ALESE|ALESAGE"},
    NoteWords{radius, "RADIUS|RAYON|RAGGIO|RADIO"},
    NoteWords{square, "□|SQUARE|SQ|VIERKANT|CARRE"},
    NoteWords{times, "×|X|AT|A|BEI"},
    NoteWords{on_circle, "ON|AUF|SUR|SU"},
    NoteWords{pitch_circle, "BOLT CIRCLE|PITCH CIRCLE|B.C|BCD|BC|P.C.D|PCD|LOCHKREIS|TEILKREIS|LK|TK"},
    NoteWords{evenly,
              "EQUALLY SPACED|EVENLY SPACED|EQUISPACED|EQUI-SPACED|EQ. SP|EQ SP|EQL SP|GLEICHMASSIG "
              "VERTEILT|GLEICHMASIG VERTEILT|EQUIDISTANTS|EQUIDISTANTES|EQUIDISTANTI|EQUIDISTANT"},
    NoteWords{holes, "HOLES|HOLE|BOHRUNGEN|BOHRUNG|LOCHER|TROUS|TROU|FORI|FORO|AGUJEROS|TALADROS"},
    NoteWords{places, "PLACES|PLCS|PL|STUCK|STK|STELLEN|FOIS"},
    NoteWords{
        fillets,
        "FILLETS|FILLET|RADII|ROUNDS|RADIEN|RUNDUNGEN|RUNDUNG|CONGES|CONGE|RAYONS|ARRONDIS|RACCORDI|RAGGI|REDONDEOS"},
    NoteWords{chamfers, "CHAMFERS|CHAMFER|CHAM|FASEN|FASE|CHANFREINS|CHANFREIN|SMUSSI|SMUSSO|CHAFLANES"},
    NoteWords{threads, "THREADS|THREAD|GEWINDE|FILETAGES|FILETAGE|TARAUDAGES|FILETTATURE|FILETTATURA|ROSCAS|ROSCA"},
    NoteWords{others,
              "RIBS|RIB|WALLS|WALL|WEBS|SLOTS|GROOVES|RIPPEN|RIPPE|WANDE|STEGE|NUTEN|SCHLITZE|NERVURES|NERVURE|PAROIS|"
              "RAINURES|"
              "NERVATURE|PARETI|NERVIOS"},
    NoteWords{all, "ALL|ALLE|TOUS|TOUTES|TUTTI|TUTTE|TODOS|TODAS"},
    NoteWords{
        otherwise,
        "UNLESS OTHERWISE|NICHT ANDERS ANGEGEBEN|SAUF INDICATION CONTRAIRE|SALVO DIVERSA INDICAZIONE|SALVO INDICACION "
        "CONTRARIA|UOS|UNSPECIFIED|UNDIMENSIONED|NICHT BEMASSTE|NICHT BEMASTE|UNBEMASSTE|UNBEMASTE|NON COTES"},
    NoteWords{standard, "DIN|ISO|EN|ASME|ANSI|JIS"},
    NoteWords{silent,
              "LES|DIE|THE|PLATE|SHEET|OVERALL|PLATTE|BLECH|TOLE|PIASTRA|CHAPA|STATED|NOTED|SPECIFIED|INDICATED|SHOWN|"
              "SOFERN|SOWEIT|WENN|FALLS|ARE|TO "
              "BE|MAX|MIN|TYPICAL|TYPISCH|TYP|NOM|REF|THEO|LH|RH|TAPPED|TAP|FLAT BOTTOM|CA|APPROX|~|≈|Ⓔ|Ⓜ|Ⓛ|Ⓢ|Ⓟ"}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::span<const NoteWords> note_words() { return words; }

std::size_t word_at(std::string_view text, const NoteWords& row) {
  std::size_t longest = 0;
  for (std::string_view rest = row.words; !rest.empty();) {
    const std::size_t end = std::min(rest.size(), rest.find('|'));
    longest = std::max(longest, word_at(text, rest.substr(0, end)));
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  return longest;
}

FoldedLetter folded_letter(std::string_view text) {
  if (text.empty()) return {0, 0};
  if (is_letter(text[0])) return {static_cast<char>(std::toupper(static_cast<unsigned char>(text[0]))), 1};
  // U+00C0 to U+00FF, of which × and ÷ are no letters.
  constexpr std::string_view bases = "AAAAAAACEEEEIIIIDNOOOOO OUUUUYTS";
  static_assert(bases.size() == 32);
  if (text.size() < 2 || text[0] != '\xC3') return {0, 0};
  const char base = bases[static_cast<unsigned char>(text[1]) & 0x1FU];
  return {base == ' ' ? '\0' : base, 2};
}

std::size_t word_at(std::string_view text, std::string_view word) {
  std::size_t end = 0;
  for (const char c : word) {
    const FoldedLetter letter = folded_letter(text.substr(end));
    const bool is_it = is_letter(c) ? letter.capital == c : end < text.size() && text[end] == c;
    if (!is_it) return 0;
    end += is_letter(c) ? letter.bytes : 1;
  }
  if (!is_letter(word.back())) return end;
  if (folded_letter(text.substr(end)).capital != 0) return 0;
  const std::string_view rest = text.substr(end);
  const bool is_short = rest.starts_with(".") && (rest.size() == 1 || !is_digit(rest[1]));
  return end + (is_short ? 1 : 0);
}

}  // namespace epura::sheet
