// SPDX-License-Identifier: Apache-2.0
#include "app/value_words.hpp"

#include <algorithm>
#include <string_view>

#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

using Folders = std::vector<std::filesystem::path>;

/// Returns `text` up to and including the last `separator`.
std::string before_last(const std::string& text, char separator) { return text.substr(0, text.rfind(separator) + 1); }

/// Suggestions for the next word of a comma-separated list: words that are not yet in it.
std::vector<Suggestion> continue_list(const std::string& text, const std::vector<Suggestion>& words) {
  const std::string before = before_last(text, ',');
  const auto given = split(before, ',');
  std::vector<Suggestion> suggestions;
  for (const Suggestion& suggestion : words)
    if (std::find(given.begin(), given.end(), suggestion.word) == given.end())
      suggestions.push_back({before + suggestion.word, suggestion.help});
  return suggestions;
}

std::vector<Suggestion> projections(const Folders& folders) {
  std::vector<Suggestion> suggestions;
  for (const projection::ProjectionEntry& entry : projection::load_catalogue(folders).entries)
    suggestions.push_back({entry.name, entry.summary});
  return suggestions;
}

std::vector<Suggestion> values_of(const projection::Parameter& parameter, const std::string& before) {
  std::vector<Suggestion> suggestions;
  for (const std::string& choice : parameter.choices) suggestions.push_back({before + choice, parameter.help});
  if (suggestions.empty() && !usual_value(parameter).empty())
    suggestions.push_back({before + usual_value(parameter), values_text(parameter)});
  return suggestions;
}

/// Parameters without a value, or values of the last parameter.
std::vector<Suggestion> parameters(const projection::ProjectionEntry& entry, const std::string& text) {
  const std::string before = before_last(text, ':');
  const std::string last = text.substr(before.size());
  std::vector<Suggestion> suggestions;
  for (const projection::Parameter& parameter : entry.parameters) {
    const std::string key = parameter.name + "=";
    if (last.starts_with(key)) return values_of(parameter, before + key);
    if (before.find(":" + key) == std::string::npos)
      suggestions.push_back({before + key, parameter.help + "; " + values_text(parameter)});
  }
  return suggestions;
}

/// NAME[:key=value...]
std::vector<Suggestion> continue_request(const std::string& text, const Folders& folders) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return projections(folders);
  try {
    return parameters(projection::find_projection(text.substr(0, colon), folders), text);
  } catch (const Error&) {
    return {};  // an unknown projection has no parameters
  }
}

}  // namespace

std::vector<Suggestion> value_suggestions(const scene::ValueForm& form, const std::string& text,
                                          const Folders& folders) {
  if (form.completion == scene::Completion::projection) return continue_request(text, folders);
  if (form.completion == scene::Completion::projections) return continue_list(text, projections(folders));
  std::vector<Suggestion> words;
  for (const std::string& word : form.words) words.push_back({word, ""});
  return form.is_list ? continue_list(text, words) : words;
}

}  // namespace epura
