// SPDX-License-Identifier: Apache-2.0
// What a sheet shows, in words, for people who do not see it: in English, German and French.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace epura::sheet {

inline constexpr std::array<std::string_view, 3> languages_of_phrases{"en", "de", "fr"};

/// The one of these languages for a code such as "de" or "fr-CA"; English for all others.
std::string_view language_of_phrases(std::string_view code);

/// The phrase with the texts in place of {0}, {1} ...; `language` as of language_of_phrases. Checks that there is such
/// a phrase.
std::string phrase(std::string_view key, std::string_view language, std::span<const std::string> texts = {});

/// The name of a projection in that language; itself if it has no other name there.
std::string projection_in_words(std::string_view projection, std::string_view language);

/// The same of a geometrical characteristic of ISO 1101.
std::string characteristic_in_words(std::string_view characteristic, std::string_view language);

}  // namespace epura::sheet
