// SPDX-License-Identifier: Apache-2.0
#include "library/run_options.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"
#include "library/own_projections.hpp"

namespace epura {

namespace {

double checked(double number, const std::string& where, double min, double max = largest_number) {
  if (!std::isfinite(number)) throw Error(ErrorKind::input, where, "is not a finite number");
  if (number < min || number > max)
    throw Error(ErrorKind::input, where,
                "is " + format_number(number) + ", allowed is " + format_number(min) + " to " + format_number(max));
  return number;
}

}  // namespace

pipeline::RunOptions run_options_of(const Settings& settings) {
  pipeline::RunOptions options;
  options.plugin_path = settings.plugin_path;
  options.projections = entries_of(settings.projections);
  options.allow_outside = settings.allow_outside;
  if (settings.wireframe) options.visibility = pipeline::Visibility::none;
  if (settings.contact) options.contact = checked(*settings.contact, "settings.contact", 0);
  if (settings.arcs) options.arcs = checked(*settings.arcs, "settings.arcs", 1e-6, 1);
  options.centre_lines = settings.centre_lines;
  if (settings.verify) {
    options.verify = true;
    options.verify_samples = static_cast<int>(checked(*settings.verify, "settings.verify", 1, 1e7));
  }
  if (settings.time_limit) options.time_limit = checked(*settings.time_limit, "settings.time_limit", 0);
  options.threads = static_cast<int>(checked(settings.threads, "settings.threads", 0, 1024));
  if (settings.max_error) options.max_error = checked(*settings.max_error, "settings.max_error", 1e-12, 1e6);
  options.error_note = settings.error_note;
  options.keeps_drawings = options.judges = true;
  return options;
}

}  // namespace epura
