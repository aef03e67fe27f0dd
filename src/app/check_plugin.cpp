// SPDX-License-Identifier: Apache-2.0
// `epura plugins check`: what epura asks of every projection, for authors of plugins.
#include <cstdio>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "projection/check_projection.hpp"
#include "projection/plugin_process.hpp"

namespace epura {

namespace {

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::failed:
      return "FAILED";
    case Verdict::skipped:
      return "skipped";
  }
  return "";
}

/// Prints the table; the number of failures.
int print_checks(const ProjectionEntry& entry) {
  int failed = 0;
  std::printf("%s (%s)\n", entry.name.c_str(), entry.family.c_str());
  std::fflush(stdout);
  check_projection(entry, [&](const CheckResult& result) {
    failed += result.verdict == Verdict::failed ? 1 : 0;
    std::printf("  %-11s %-8s %s\n", result.name.c_str(), word(result.verdict), result.what.c_str());
    if (!result.fault.empty()) std::printf("  %-20s %s\n", "", result.fault.c_str());
    std::fflush(stdout);
  });
  return failed;
}

std::vector<ProjectionEntry> entries_of(const CheckPluginOptions& options) {
  try {
    return read_plugin_apart(options.file, Afterwards::waits, options.time_limit);
  } catch (const Error& error) {
    throw Error(ErrorKind::plugin, options.file.string(), error.what(), "docs/plugins.md tells what is expected");
  }
}

}  // namespace

int check_plugin(const CheckPluginOptions& options) {
  int failed = 0;
  for (const ProjectionEntry& entry : entries_of(options)) failed += print_checks(entry);
  return failed > 0 ? found_wrong_exit_code : 0;
}

}  // namespace epura
