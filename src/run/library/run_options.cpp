// SPDX-License-Identifier: Apache-2.0
#include "library/run_options.hpp"

#include <algorithm>
#include <epura/own_projection.hpp>
#include <exception>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "foreign/parameters.hpp"
#include "pipeline/run_values.hpp"
#include "projection/answer.hpp"
#include "projection/catalogue.hpp"

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

/// Throws Error{plugin} for tables that would be wrong in a plugin, too, and for two projections with one name.
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

// The value of a member, as if it stood in a scene file.
template <class T, class Number>
T checked(const scene::ValueKind<T>& kind, Number number, const std::string& member) {
  return kind.read(scene::TomlValue{member, "settings." + member, {}, static_cast<double>(number)});
}

}  // namespace

pipeline::RunOptions run_options_of(const Settings& settings) {
  pipeline::RunOptions options;
  options.plugin_path = settings.plugin_path;
  options.projections = entries_of(settings.projections);
  options.allow_outside = settings.allow_outside;
  if (settings.wireframe) options.visibility = pipeline::Visibility::none;
  if (settings.contact) options.contact = checked(pipeline::contact_distance(), *settings.contact, "contact");
  if (settings.arcs) options.arcs = checked(pipeline::arc_tolerance(), *settings.arcs, "arcs");
  options.centre_lines = settings.centre_lines;
  if (settings.verify) {
    options.verify = true;
    options.verify_samples = checked(pipeline::verify_samples(), *settings.verify, "verify");
  }
  if (settings.time_limit) options.time_limit = checked(pipeline::time_limit(), *settings.time_limit, "time_limit");
  options.threads = checked(pipeline::thread_count(), settings.threads, "threads");
  if (settings.max_error) options.max_error = checked(pipeline::max_error(), *settings.max_error, "max_error");
  options.error_note = settings.error_note;
  options.keeps_drawings = options.judges = true;
  return options;
}

}  // namespace epura
