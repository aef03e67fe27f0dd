// SPDX-License-Identifier: Apache-2.0
// `epura importers` lists the formats that can be read; `epura importers check` tests importers for their authors.
#include <algorithm>
#include <cstdio>
#include <string>

#include "app/commands.hpp"
#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "importer/catalogue.hpp"
#include "importer/check_importer.hpp"

namespace epura {

namespace {

std::string extensions_of(const importer::ImporterTable& table) {
  std::string text;
  for (const std::string& extension : table.extensions) text += (text.empty() ? "." : " .") + extension;
  return text;
}

std::string heading_of(const importer::ImporterTable& table) { return table.name + " (" + extensions_of(table) + ")"; }

void list(const importer::Catalogue& catalogue) {
  const auto row = [](const importer::ImporterTable& table) {
    print("  " + padded(table.name, 10) + padded(extensions_of(table), 18) + table.summary);
  };
  print("built in");
  for (const importer::ImporterTable& table : importer::built_in_importers()) row(table);
  if (!catalogue.entries.empty()) print("\nplugins");
  for (const importer::ImporterEntry& entry : catalogue.entries) row(entry.table);
  for (const foreign::BadPlugin& bad : catalogue.bad)
    std::fprintf(stderr, "epura: %s: %s\n", printable(bad.path.string()).c_str(), bad.reason.c_str());
}

void show(const importer::ImporterTable& table, const std::string& origin) {
  print(heading_of(table) + ": " + table.summary);
  print(origin);
  if (table.parameters.empty()) return;
  print("\nparameters (FILE:key=value)");
  print_parameters(table.parameters);
}

}  // namespace

int importers(const ImportersOptions& options) {
  const importer::Catalogue catalogue = importer::load_catalogue(importer::importer_folders(options.plugin_path));
  if (options.name.empty()) {
    list(catalogue);
    return 0;
  }
  std::vector<std::string> names;
  const auto is_asked = [&](const importer::ImporterTable& table) {
    names.push_back(table.name);
    for (const std::string& extension : table.extensions)
      if (extension != table.name) names.push_back(extension);
    return table.name == options.name || std::count(table.extensions.begin(), table.extensions.end(), options.name) > 0;
  };
  for (const importer::ImporterTable& table : importer::built_in_importers())
    if (is_asked(table)) return show(table, "built in"), 0;
  for (const importer::ImporterEntry& entry : catalogue.entries)
    if (is_asked(entry.table)) return show(entry.table, "from " + entry.library.string()), 0;
  throw Error(ErrorKind::plugin, options.name, "no such importer", did_you_mean(options.name, names));
}

int check_importer(const CheckImporterOptions& options) {
  int failed = 0;
  try {
    for (const importer::ImporterEntry& entry : importer::importers_of(options.file, options.time_limit)) {
      print(heading_of(entry.table));
      std::fflush(stdout);
      importer::check_importer(entry, options.models, options.time_limit, [&](const foreign::CheckResult& result) {
        failed += result.verdict == foreign::Verdict::failed ? 1 : 0;
        print_check(result);
      });
    }
  } catch (const Error& error) {
    if (!error.where().empty()) throw;
    throw Error(error.kind(), options.file.string(), error.what(), "docs/importers.md tells what is expected");
  }
  return failed > 0 ? found_wrong_exit_code : 0;
}

}  // namespace epura
