// `epura plugins check`: what epura asks of every projection, for authors of plugins.
#include <cstdio>

#include "app/commands.hpp"
#include "app/contained.hpp"
#include "base/error.hpp"
#include "projection/check_projection.hpp"
#include "projection/loader.hpp"

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
    std::fflush(stdout);  // a plugin that crashes in the next check does not take this away
  });
  return failed;
}

}  // namespace

int check_plugin(const CheckPluginOptions& options) {
  const auto load = [&] { return read_plugin(options.file); };
  const auto try_to_load = [&] {
    try {
      load();
    } catch (const Error&) {
      // Will be told below: now it is safe to load.
    }
    return 0;
  };
  const std::string file = options.file.string();
  const Contained loading = run_contained(try_to_load, options.time_limit);
  if (!loading.code) throw Error(Trouble::plugin, file, loading.trouble + " when it is loaded");

  std::vector<ProjectionEntry> entries;
  try {
    entries = load();
  } catch (const Error& error) {
    throw Error(Trouble::plugin, file, error.what(), "docs/plugins.md tells what is expected");
  }
  const Contained checks = run_contained(
      [&] {
        int failed = 0;
        for (const ProjectionEntry& entry : entries) failed += print_checks(entry);
        return failed > 0 ? found_wrong_exit_code : 0;
      },
      options.time_limit);
  if (!checks.code) std::printf("FAILED: %s %s\n", file.c_str(), checks.trouble.c_str());
  return checks.code.value_or(found_wrong_exit_code);
}

}  // namespace epura
