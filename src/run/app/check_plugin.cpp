// SPDX-License-Identifier: Apache-2.0
// `epura plugins check`: tests a plugin, for its author.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/picture.hpp"
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

// A house far from the origin in comparison with its size: whatever a projection takes from there, it shows.
constexpr const char* house =
    "v 100 30 50\nv 140 30 50\nv 140 60 50\nv 100 60 50\nv 100 30 70\nv 140 30 70\nv 140 60 70\nv 100 60 70\n"
    "v 100 40 83\nv 140 40 83\n"
    "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 10 6\nf 3 4 8 7\nf 4 1 5 9 8\nf 5 6 10 9\nf 9 10 7 8\n";

// NAME-PROJECTION.EXTENSION if there are several.
std::string file_of(const CheckPluginOptions& options, const std::string& projection, bool is_alone) {
  if (is_alone) return options.picture;
  std::filesystem::path file = options.picture;
  return file.replace_filename(file.stem().string() + "-" + projection + file.extension().string()).string();
}

void draw_pictures(const std::vector<projection::ProjectionEntry>& entries, const CheckPluginOptions& options) {
  for (const projection::ProjectionEntry& entry : entries) {
    PictureOptions picture;
    picture.projection = {scene::ProjectionRequest{entry.name}, entry.name};
    picture.draw.models = {options.model.empty() ? "house.obj" : options.model};
    if (options.model.empty()) picture.draw.model.content = std::make_shared<const std::string>(house);
    picture.draw.outputs = {file_of(options, entry.name, entries.size() == 1)};
    picture.draw.run.projections = entries;
    draw_picture(picture);
  }
}

}  // namespace

int check_plugin(const CheckPluginOptions& options) {
  if (options.picture.empty() && !options.model.empty())
    throw Error(ErrorKind::input, "--model", "needs a picture that shows it", "name its file with --picture");
  int failed = 0;
  const std::vector<projection::ProjectionEntry> entries = entries_of(options);
  for (const projection::ProjectionEntry& entry : entries) failed += print_checks(entry);
  if (!options.picture.empty()) draw_pictures(entries, options);
  return failed > 0 ? found_wrong_exit_code : 0;
}

}  // namespace epura
