// SPDX-License-Identifier: Apache-2.0
#include "importer/catalogue.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "mesh/read.hpp"

namespace epura::importer {

namespace fs = std::filesystem;

std::vector<ImporterTable> built_in_importers() {
  std::vector<ImporterTable> tables;
  for (const mesh::Format& format : mesh::formats())
    tables.push_back({std::string(format.name), std::string(format.summary), {std::string(format.name)}, {}, 0});
  return tables;
}

std::vector<fs::path> importer_folders(const std::vector<fs::path>& extra) {
  std::vector<fs::path> folders = foreign::plugin_folders(extra, "importers");
  // Without importers, the program's installation has no such folder.
  if (std::error_code error; !folders.empty() && !fs::exists(folders.back(), error)) folders.pop_back();
  return folders;
}

Catalogue load_catalogue(const std::vector<fs::path>& folders) {
  Catalogue catalogue;
  for (const fs::path& folder : folders)
    for (const fs::path& library : foreign::libraries_in(folder, catalogue.bad)) {
      try {
        for (ImporterEntry& entry : importers_of(library))
          if (std::none_of(catalogue.entries.begin(), catalogue.entries.end(),
                           [&](const ImporterEntry& earlier) { return earlier.table.name == entry.table.name; }))
            catalogue.entries.push_back(std::move(entry));
      } catch (const Error& error) {
        catalogue.bad.push_back({library, error.what()});
      }
    }
  return catalogue;
}

std::string_view package_for(std::string_view extension) {
  struct Row {
    std::string_view extension, package;
  };
  constexpr std::array rows{Row{"step", "epura-opencascade"},
                            Row{"stp", "epura-opencascade"},
                            Row{"p21", "epura-opencascade"},
                            Row{"iges", "epura-opencascade"},
                            Row{"igs", "epura-opencascade"},
                            Row{"brep", "epura-opencascade"},
                            Row{"brp", "epura-opencascade"},
                            Row{"gltf", "epura-gltf"},
                            Row{"glb", "epura-gltf"},
                            Row{"3mf", "epura-3mf"},
                            Row{"om", "epura-om"}};
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.extension == extension; });
  return found == rows.end() ? std::string_view() : found->package;
}

}  // namespace epura::importer
