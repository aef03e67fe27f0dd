// SPDX-License-Identifier: Apache-2.0
#include "sheet/installed_fonts.hpp"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/choices.hpp"

namespace epura::sheet {

namespace {

template <auto Destroy>
struct FontconfigFree {
  template <class Object>
  void operator()(Object* object) const {
    Destroy(object);
  }
};
using Config = std::unique_ptr<FcConfig, FontconfigFree<FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, FontconfigFree<FcPatternDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, FontconfigFree<FcFontSetSortDestroy>>;

const FcChar8* bytes(const char* text) { return reinterpret_cast<const FcChar8*>(text); }

std::string pattern_text(FcPattern* font, const char* property) {
  FcChar8* text = nullptr;
  return FcPatternGetString(font, property, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

bool truth_of(FcPattern* font, const char* property) {
  FcBool truth = FcFalse;
  return FcPatternGetBool(font, property, 0, &truth) == FcResultMatch && truth == FcTrue;
}

int weight_number(FcPattern* font, const char* property, int otherwise) {
  int number = 0;
  return FcPatternGetInteger(font, property, 0, &number) == FcResultMatch ? number : otherwise;
}

// Higher bits of the number of a face select a variant of a variable font, which FreeType would have to be told.
bool is_usable(FcPattern* font) {
  constexpr int max_faces = 0xFFFF;
  return truth_of(font, FC_OUTLINE) && !truth_of(font, FC_COLOR) && !truth_of(font, FC_VARIABLE) &&
         weight_number(font, FC_SLANT, FC_SLANT_ROMAN) == FC_SLANT_ROMAN &&
         weight_number(font, FC_INDEX, 0) <= max_faces;
}

struct Candidate {
  std::string file, family;
  int face;
  FcCharSet* characters;  // of the sorted set
  std::unique_ptr<const FontFile> opened;
};

using FontList = std::unique_ptr<FcFontSet, FontconfigFree<FcFontSetDestroy>>;

Font font_in_file(const std::string& file, const std::string& where) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault))
    throw Error(ErrorKind::input, where, "there is no font file '" + file + "'",
                "give a .ttf or .otf file, or a family");
  int count = 0;
  const Pattern font(FcFreeTypeQuery(bytes(file.c_str()), 0, nullptr, &count));
  const FontFile opened(file);
  if (!font || !truth_of(font.get(), FC_OUTLINE) || !opened.is_open() || !(opened.capital() > 0))
    throw Error(ErrorKind::input, where, "'" + file + "' is not an outline font", "give a .ttf or .otf file");
  return {file, 0, pattern_text(font.get(), FC_FAMILY)};
}

std::vector<std::string> families_of(FcPattern* font) {
  std::vector<std::string> families;
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(font, FC_FAMILY, i, &name) == FcResultMatch; ++i)
    families.emplace_back(reinterpret_cast<const char*>(name));
  return families;
}

// In an order that does not depend on the list: weight, then width, then file.
auto rank_of(FcPattern* font) {
  return std::tuple(std::abs(weight_number(font, FC_WEIGHT, FC_WEIGHT_NORMAL) - FC_WEIGHT_NORMAL),
                    std::abs(weight_number(font, FC_WIDTH, FC_WIDTH_NORMAL) - FC_WIDTH_NORMAL),
                    pattern_text(font, FC_FILE), weight_number(font, FC_INDEX, 0));
}

Font font_of_family(const std::string& family, const std::string& where) {
  const Config config(FcInitLoadConfigAndFonts());
  const Pattern any(FcPatternCreate());
  const std::unique_ptr<FcObjectSet, FontconfigFree<FcObjectSetDestroy>> wanted(
      FcObjectSetBuild(FC_FAMILY, FC_FILE, FC_INDEX, FC_OUTLINE, FC_COLOR, FC_VARIABLE, FC_SLANT, FC_WEIGHT, FC_WIDTH,
                       static_cast<char*>(nullptr)));
  const FontList list(config ? FcFontList(config.get(), any.get(), wanted.get()) : nullptr);
  std::set<std::string> known;
  FcPattern* best = nullptr;
  for (int i = 0; list && i < list->nfont; ++i) {
    FcPattern* font = list->fonts[i];
    if (!is_usable(font)) continue;
    for (const std::string& name : families_of(font)) {
      known.insert(name);
      if (to_lower(name) == to_lower(family) && (best == nullptr || rank_of(font) < rank_of(best))) best = font;
    }
  }
  if (best != nullptr)
    return {pattern_text(best, FC_FILE), weight_number(best, FC_INDEX, 0), pattern_text(best, FC_FAMILY)};
  const std::vector<std::string> names(known.begin(), known.end());
  throw Error(ErrorKind::input, where, "no installed font family is called '" + family + "'",
              names.empty() ? "install it, or give its file" : did_you_mean(family, names));
}

}  // namespace

Font find_font(const std::string& text, const std::string& where) {
  return scene::names_font_file(text) ? font_in_file(text, where) : font_of_family(text, where);
}

struct InstalledFonts::List {
  std::mutex reading;
  bool is_read = false;
  Config config;
  FontSet sorted;
  std::vector<Candidate> candidates;

  void read();
};

void InstalledFonts::List::read() {
  if (std::exchange(is_read, true)) return;
  config.reset(FcInitLoadConfigAndFonts());
  if (!config) return;
  const Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, bytes("sans-serif"));
  FcPatternAddString(pattern.get(), FC_LANG, bytes("en"));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, FC_WEIGHT_NORMAL);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultMatch;
  sorted.reset(FcFontSort(config.get(), pattern.get(), FcTrue, nullptr, &result));
  if (!sorted) return;
  for (int i = 0; i < sorted->nfont; ++i) {
    FcPattern* font = sorted->fonts[i];
    FcCharSet* characters = nullptr;
    if (!is_usable(font) || FcPatternGetCharSet(font, FC_CHARSET, 0, &characters) != FcResultMatch) continue;
    candidates.push_back({pattern_text(font, FC_FILE), pattern_text(font, FC_FAMILY), weight_number(font, FC_INDEX, 0),
                          characters, nullptr});
  }
}

InstalledFonts::InstalledFonts() : list_(std::make_unique<List>()) {}
InstalledFonts::~InstalledFonts() = default;

const FontFile* InstalledFonts::font_with(const std::u32string& characters) const {
  const std::lock_guard lock(list_->reading);
  list_->read();
  for (Candidate& candidate : list_->candidates) {
    const bool has_all = std::all_of(characters.begin(), characters.end(), [&](char32_t c) {
      return FcCharSetHasChar(candidate.characters, static_cast<FcChar32>(c)) == FcTrue;
    });
    if (!has_all) continue;
    if (!candidate.opened)
      candidate.opened = std::make_unique<const FontFile>(candidate.file, candidate.face, candidate.family);
    if (candidate.opened->is_open()) return candidate.opened.get();
  }
  return nullptr;
}

}  // namespace epura::sheet
