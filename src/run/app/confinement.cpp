// SPDX-License-Identifier: Apache-2.0
#include "app/confinement.hpp"

#include <link.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "importer/catalogue.hpp"
#include "importer/read_model.hpp"
#include "projection/catalogue.hpp"
#include "scene/choices.hpp"
#include "sheet/lettering.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

// The program that loads programs, such as that of importers: it is opened by name when one starts.
fs::path program_loader() {
  fs::path loader;
  const auto find = [](dl_phdr_info* info, std::size_t, void* found) {
    for (int i = 0; i < info->dlpi_phnum; ++i)
      if (info->dlpi_phdr[i].p_type == PT_INTERP)
        *static_cast<fs::path*>(found) = reinterpret_cast<const char*>(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
    return 1;  // the program is the first in the list
  };
  ::dl_iterate_phdr(find, &loader);
  return loader;
}

// Where Fontconfig looks for what this user has, beside what the system has.
std::vector<fs::path> font_folders() {
  std::vector<fs::path> folders{"/var/cache/fontconfig", sheet::Lettering::usual_font().parent_path()};
  const auto add_below = [&](const char* variable, std::initializer_list<const char*> names) {
    const char* folder = std::getenv(variable);
    if (folder == nullptr || *folder == 0) return;
    for (const char* name : names) folders.push_back(fs::path(folder) / name);
  };
  add_below("HOME", {".fonts", ".fonts.conf", ".local/share/fonts", ".config/fontconfig", ".cache/fontconfig"});
  add_below("XDG_DATA_HOME", {"fonts"});
  add_below("XDG_CONFIG_HOME", {"fontconfig"});
  add_below("XDG_CACHE_HOME", {"fontconfig"});
  return folders;
}

std::set<fs::path> folders_of(const std::vector<std::string>& files) {
  std::set<fs::path> folders;
  for (const std::string& file : files)
    if (file != "-") folders.insert(fs::absolute(file).parent_path());
  return folders;
}

}  // namespace

NamedFiles files_of(const std::vector<Job>& jobs) {
  NamedFiles files;
  for (const Job& job : jobs) {
    files.inputs.insert(files.inputs.end(), job.models.begin(), job.models.end());
    files.outputs.insert(files.outputs.end(), job.outputs.begin(), job.outputs.end());
    std::error_code missing;
    for (const LaterOption& setting : job.settings)
      if (const std::string* value = std::get_if<std::string>(&setting.value.content))
        if (fs::exists(*value, missing)) files.inputs.push_back(*value);
  }
  return files;
}

foreign::Permissions permissions_for(const NamedFiles& files, const pipeline::RunOptions& options,
                                     const scene::SheetDescription& sheet) {
  std::vector<std::string> inputs;
  for (const std::string& input : files.inputs) inputs.push_back(importer::parse_model_request(input).path);
  const std::set<fs::path> sources = folders_of(inputs), targets = folders_of(files.outputs);
  foreign::Permissions permissions{{sources.begin(), sources.end()},
                                   {targets.begin(), targets.end()},
                                   {own_folder() / "epura-importer", program_loader()}};
  // A worker sets the mark from which its memory is measured.
  permissions.writable.emplace_back("/proc/self/clear_refs");
  const auto add = [&](const std::vector<fs::path>& more) {
    permissions.readable.insert(permissions.readable.end(), more.begin(), more.end());
  };
  // Links lead out of their folders, as the user wants.
  for (const std::string& input : inputs)
    if (std::error_code missing; fs::is_symlink(input, missing)) permissions.readable.emplace_back(input);
  add(projection::plugin_folders(options.plugin_path));
  add(importer::importer_folders(options.plugin_path));
  add(font_folders());
  permissions.readable.push_back(own_folder());
  if (sheet.font.given() && scene::names_font_file(*sheet.font)) permissions.readable.emplace_back(*sheet.font);
  for (const scene::LocatedText* file : {&sheet.form, &sheet.logo, &sheet.style})
    if (file->given()) permissions.readable.emplace_back(**file);
  if (options.allow_outside) permissions.readable.emplace_back("/");
  return permissions;
}

void confine_if_asked(const DrawOptions& options, const NamedFiles& files) {
  if (options.run.sandbox != pipeline::Sandbox::on) return;
  if (const std::string reason = foreign::reason_for_no_sandbox(); !reason.empty())
    throw Error(ErrorKind::input, "--sandbox on", reason, "--sandbox auto confines what this computer can confine");
  foreign::enter_sandbox(permissions_for(files, options.run, options.sheet));
}

}  // namespace epura
