// SPDX-License-Identifier: Apache-2.0
// The words that a sheet adds by itself, in several languages.
#pragma once

#include <string_view>

namespace epura::sheet {

/// The caption of a cell of the title block ("owner", "number" ...), or "mm", "in", "m" for the statement of the unit
/// of dimensions. `language` is a code such as "de" or "pt-BR"; English for languages that are not in the table. Empty
/// for unknown keys. ISO 7200 and its national editions.
std::string_view caption(std::string_view key, std::string_view language);

/// Whether a language is in the table. No language means English.
bool has_captions(std::string_view language);

}  // namespace epura::sheet
