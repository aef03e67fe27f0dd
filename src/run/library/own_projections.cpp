// SPDX-License-Identifier: Apache-2.0
#include "library/own_projections.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <set>
#include <string>

#include "base/error.hpp"
#include "foreign/parameters.hpp"
#include "projection/answer.hpp"

namespace epura {

namespace {

using foreign::require;

// The rows of a plugin's table, which are checked in one place. They refer to the texts of the parameters.
std::vector<epura_parameter> rows_of(const std::vector<OwnParameter>& parameters,
                                     const std::vector<std::string>& choices) {
  std::vector<epura_parameter> rows;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const OwnParameter& parameter = parameters[i];
    epura_parameter& row = rows.emplace_back();
    row.size = sizeof row;
    const bool is_vector = parameter.initial.size() > 1;
    row.type = !parameter.choices.empty() ? EPURA_CHOICE : is_vector ? EPURA_VECTOR : EPURA_NUMBER;
    row.count = static_cast<uint32_t>(parameter.initial.size());
    row.name = parameter.name.c_str();
    row.unit = parameter.unit.c_str();
    row.help = parameter.help.c_str();
    row.choices = parameter.choices.empty() ? nullptr : choices[i].c_str();
    std::copy_n(parameter.initial.begin(), std::min(parameter.initial.size(), std::size(row.initial)), row.initial);
    row.least = parameter.least;
    row.most = parameter.most;
  }
  return rows;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
  return text;
}

projection::ProjectionEntry entry_of(const OwnProjection& own) {
  require(foreign::is_plugin_name(own.name), "the name '" + own.name + "' is not lower case, digits and '-'");
  require(own.project != nullptr, "has no function");
  std::vector<std::string> choices;
  for (const OwnParameter& parameter : own.parameters) choices.push_back(joined(parameter.choices));
  const std::vector<epura_parameter> rows = rows_of(own.parameters, choices);
  const auto ask = [make = own.project](const std::vector<double>& values, const Box& scene) {
    try {
      return projection::call_function(make, values, scene);
    } catch (const std::exception& error) {
      throw Error(ErrorKind::plugin, "", error.what());
    }
  };
  return {.name = own.name,
          .family = own.family,
          .summary = own.summary,
          .reference = own.reference,
          .parameters = foreign::read_parameters(rows.data(), rows.size(), "projection '" + own.name + "'"),
          .plugin = own.place.empty() ? own.name : own.place,
          .ask = ask};
}

}  // namespace

std::vector<projection::ProjectionEntry> entries_of(const std::vector<OwnProjection>& projections) {
  std::vector<projection::ProjectionEntry> entries;
  std::set<std::string> names;
  for (const OwnProjection& own : projections) {
    try {
      entries.push_back(entry_of(own));
      require(names.insert(own.name).second, "there are two projections '" + own.name + "'");
    } catch (const Error& error) {
      throw Error(error.kind(), own.place.empty() ? own.name : own.place, error.what());
    }
  }
  return entries;
}

}  // namespace epura
