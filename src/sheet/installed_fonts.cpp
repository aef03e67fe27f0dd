// SPDX-License-Identifier: Apache-2.0
#include "sheet/installed_fonts.hpp"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

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

std::string text_of(FcPattern* font, const char* property) {
  FcChar8* text = nullptr;
  return FcPatternGetString(font, property, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

bool truth_of(FcPattern* font, const char* property) {
  FcBool truth = FcFalse;
  return FcPatternGetBool(font, property, 0, &truth) == FcResultMatch && truth == FcTrue;
}

int number_of(FcPattern* font, const char* property, int otherwise) {
  int number = 0;
  return FcPatternGetInteger(font, property, 0, &number) == FcResultMatch ? number : otherwise;
}

// Higher bits of the number of a face select a variant of a variable font, which FreeType would have to be told.
bool is_usable(FcPattern* font) {
  constexpr int most_faces = 0xFFFF;
  return truth_of(font, FC_OUTLINE) && !truth_of(font, FC_COLOR) && !truth_of(font, FC_VARIABLE) &&
         number_of(font, FC_SLANT, FC_SLANT_ROMAN) == FC_SLANT_ROMAN && number_of(font, FC_INDEX, 0) <= most_faces;
}

struct Candidate {
  std::string file, family;
  int face;
  FcCharSet* characters;  // of the sorted set
  std::unique_ptr<const FontFile> opened;
};

}  // namespace

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
    candidates.push_back(
        {text_of(font, FC_FILE), text_of(font, FC_FAMILY), number_of(font, FC_INDEX, 0), characters, nullptr});
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
