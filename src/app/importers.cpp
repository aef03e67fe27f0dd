// SPDX-License-Identifier: Apache-2.0
// `epura importers`: which formats are read by plugins, and `epura importers check` for their authors.
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

std::string extensions_of(const importer::ImporterEntry& entry) {
  std::string text;
  for (const std::string& extension : entry.table.extensions) text += (text.empty() ? "." : " .") + extension;
  return text;
}

void list(const importer::Catalogue& catalogue) {
  print("  " + padded("(built in)", 18) + padded(".obj .stl .ply .off", 22) + "meshes");
  for (const importer::ImporterEntry& entry : catalogue.entries)
    print("  " + padded(entry.table.name, 18) + padded(extensions_of(entry), 22) + entry.table.summary);
  for (const foreign::BadPlugin& bad : catalogue.bad)
    std::fprintf(stderr, "epura: %s: %s\n", printable(bad.path.string()).c_str(), bad.reason.c_str());
}

void show(const importer::ImporterEntry& entry) {
  print(entry.table.name + " (" + extensions_of(entry) + "): " + entry.table.summary);
  print("from " + entry.library.string());
  if (entry.table.parameters.empty()) return;
  print("\nparameters (FILE:key=value)");
  print_parameters(entry.table.parameters);
}

}  // namespace

int importers(const ImportersOptions& options) {
  const importer::Catalogue catalogue = importer::load_catalogue(importer::importer_folders(options.plugin_path));
  if (options.name.empty()) {
    list(catalogue);
    return 0;
  }
  std::vector<std::string> names;
  for (const importer::ImporterEntry& entry : catalogue.entries) {
    if (entry.table.name == options.name) {
      show(entry);
      return 0;
    }
    names.push_back(entry.table.name);
  }
  throw Error(ErrorKind::plugin, options.name, "no such importer",
              names.empty() ? "no importers were found" : did_you_mean(options.name, names));
}

int check_importer(const CheckImporterOptions& options) {
  int failed = 0;
  try {
    for (const importer::ImporterEntry& entry : importer::importers_of(options.file, options.time_limit)) {
      print(entry.table.name + " (" + extensions_of(entry) + ")");
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
