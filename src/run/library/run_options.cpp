// SPDX-License-Identifier: Apache-2.0
#include "library/run_options.hpp"

#include <string>

#include "library/own_projections.hpp"
#include "pipeline/run_values.hpp"

namespace epura {

namespace {

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
