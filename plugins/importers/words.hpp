// SPDX-License-Identifier: Apache-2.0
// Words of model files that are for people: notes of drawings.
#pragma once

#include <algorithm>
#include <cmath>
#include <epura/importer_plugin.hpp>
#include <string>

namespace epura::plugin {

/// Whether properties, items and metadata of this name are such words, whatever they belong to.
inline bool names_words(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name == "equivalent unicode string" || name == "semantic text" || name == "note" || name == "notes" ||
         (name.size() > 5 && name.compare(name.size() - 5, 5, " note") == 0);
}

/// Words about the whole part. The id stays the same whenever the file is read.
inline void tell_words(Sink& sink, const std::string& id, const std::string& text) {
  epura_requirement note{};
  note.kind = EPURA_NOTE;
  note.id = id.c_str(), note.type = "note", note.text = text.c_str();
  note.value = note.lower = note.upper = NAN;
  note.decimals = -1;
  sink.requirement(note);
}

}  // namespace epura::plugin
