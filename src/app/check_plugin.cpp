// SPDX-License-Identifier: Apache-2.0
// `epura plugins check`: tests a plugin, for its author.
#include <cstdio>

#include "app/commands.hpp"
#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "projection/check_projection.hpp"
#include "projection/plugin_process.hpp"

namespace epura {

namespace {

/// Prints the results; returns the number of failures.
int print_checks(const projection::ProjectionEntry& entry) {
  int failed = 0;
  std::printf("%s (%s)\n", entry.name.c_str(), entry.family.c_str());
  std::fflush(stdout);
  projection::check_projection(entry, [&](const projection::CheckResult& result) {
    failed += result.verdict == projection::Verdict::failed ? 1 : 0;
    print_check(result);
  });
  return failed;
}

std::vector<projection::ProjectionEntry> entries_of(const CheckPluginOptions& options) {
  try {
    return projection::read_plugin_apart(options.file, projection::Afterwards::waits, options.time_limit,
                                         projection::Confinement::sandbox);
  } catch (const Error& error) {
    throw Error(ErrorKind::plugin, options.file.string(), error.what(), "see docs/plugins.md for the requirements");
  }
}

}  // namespace

int check_plugin(const CheckPluginOptions& options) {
  int failed = 0;
  for (const projection::ProjectionEntry& entry : entries_of(options)) failed += print_checks(entry);
  return failed > 0 ? found_wrong_exit_code : 0;
}

}  // namespace epura
