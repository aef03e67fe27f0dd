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

std::vector<ProjectionEntry> entries_of(const std::filesystem::path& file) {
  try {
    return read_plugin(file);
  } catch (const Error& error) {
    throw Error(Trouble::plugin, file.string(), error.what(), "docs/plugins.md tells what is expected");
  }
}

}  // namespace

int check_plugin(const CheckPluginOptions& options) {
  const std::string file = options.file.string();
  const std::string trouble = trouble_with_loading(options.file, options.time_limit);
  if (!trouble.empty()) throw Error(Trouble::plugin, file, trouble);
  const std::vector<ProjectionEntry> entries = entries_of(options.file);
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
