// SPDX-License-Identifier: Apache-2.0
#include "projection/catalogue.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/plugin_process.hpp"

namespace epura::projection {

namespace {

namespace fs = std::filesystem;

/// Plugins known to be bad are not tried again.
std::vector<ProjectionEntry> read_or_note(const fs::path& path, Afterwards afterwards, std::vector<BadPlugin>& bad) {
  if (std::any_of(bad.begin(), bad.end(), [&](const BadPlugin& known) { return known.path == path; })) return {};
  try {
    return read_plugin_apart(path, afterwards);
  } catch (const Error& error) {
    bad.push_back({path, error.what()});
    return {};
  }
}

bool has_own_library(const ProjectionEntry& entry) { return entry.plugin.stem() == entry.name; }

/// Of projections with one name, keeps the one from the library of that name, otherwise the first one found; so a
/// lookup by name need not open any other library. Hiding plugins of later folders is the purpose of earlier ones;
/// within one folder, it is a mistake.
void drop_duplicates(Catalogue& catalogue) {
  std::vector<ProjectionEntry>& entries = catalogue.entries;
  std::stable_sort(entries.begin(), entries.end(), [](const ProjectionEntry& a, const ProjectionEntry& b) {
    return a.name != b.name ? a.name < b.name : has_own_library(a) > has_own_library(b);
  });
  std::vector<ProjectionEntry> kept;
  for (ProjectionEntry& entry : entries) {
    if (kept.empty() || kept.back().name != entry.name)
      kept.push_back(std::move(entry));
    else if (kept.back().plugin.parent_path() == entry.plugin.parent_path() && kept.back().plugin != entry.plugin)
      catalogue.bad.push_back({entry.plugin, "provides the projection '" + entry.name + "', which " +
                                                 kept.back().plugin.filename().string() + " already provides"});
  }
  entries = std::move(kept);
}

Catalogue load_all(const std::vector<fs::path>& folders, std::vector<BadPlugin> known_as_bad) {
  Catalogue catalogue{{}, std::move(known_as_bad)};
  for (const fs::path& folder : folders)
    for (const fs::path& library : foreign::libraries_in(folder, catalogue.bad))
      for (ProjectionEntry& entry : read_or_note(library, Afterwards::rests, catalogue.bad))
        catalogue.entries.push_back(std::move(entry));
  drop_duplicates(catalogue);
  std::sort(catalogue.entries.begin(), catalogue.entries.end(),
            [](const auto& a, const auto& b) { return std::tie(a.family, a.name) < std::tie(b.family, b.name); });
  return catalogue;
}

std::optional<ProjectionEntry> entry_named(std::string_view name, const std::vector<ProjectionEntry>& entries) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == name; });
  if (found == entries.end()) return std::nullopt;
  return *found;
}

[[noreturn]] void throw_unknown(std::string_view name, const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const ProjectionEntry& entry : catalogue.entries) names.push_back(entry.name);
  for (const BadPlugin& bad : catalogue.bad)
    if (bad.path.stem() == name) throw Error(ErrorKind::plugin, bad.path.string(), bad.reason);
  std::string hint = names.empty()    ? "no projections were found"
                     : name == "side" ? "write left or right"
                                      : did_you_mean(name, names);
  for (const BadPlugin& bad : catalogue.bad) hint += ('\n' + bad.path.string()) + ": " + bad.reason;
  // A misspelt word is wrong input, unless a plugin that cannot be used might have had it.
  const ErrorKind kind = names.empty() || !catalogue.bad.empty() ? ErrorKind::plugin : ErrorKind::input;
  throw Error(kind, std::string(name), "no such projection", hint);
}

// Short names for the most common projections.
std::string_view full_name(std::string_view name) {
  if (name == "iso") return "isometric";
  return name == "perspective" ? "two-point" : name;
}

}  // namespace

std::vector<fs::path> plugin_folders(const std::vector<fs::path>& extra) {
  return foreign::plugin_folders(extra, "projections");
}

Catalogue load_catalogue(const std::vector<fs::path>& folders) { return load_all(folders, {}); }

ProjectionEntry find_projection(std::string_view name, const std::vector<fs::path>& folders,
                                const std::vector<ProjectionEntry>& own) {
  if (auto entry = entry_named(name, own)) return *std::move(entry);
  std::vector<BadPlugin> bad;
  // A name with a slash must not lead out of the folders.
  for (const fs::path& folder : foreign::is_plugin_name(name) ? folders : std::vector<fs::path>{}) {
    const fs::path library = folder / (std::string(name) + ".so");
    std::error_code error;
    if (!fs::is_regular_file(library, error)) continue;
    if (auto entry = entry_named(name, read_or_note(library, Afterwards::waits, bad))) return *std::move(entry);
  }
  if (const std::string_view full = full_name(name); full != name) return find_projection(full, folders, own);
  Catalogue catalogue = load_all(folders, std::move(bad));
  if (auto entry = entry_named(name, catalogue.entries)) return *std::move(entry);
  catalogue.entries.insert(catalogue.entries.end(), own.begin(), own.end());
  throw_unknown(name, catalogue);
}

}  // namespace epura::projection
