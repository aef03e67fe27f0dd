// SPDX-License-Identifier: Apache-2.0
#include "pipeline/targets.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "output/format.hpp"
#include "sheet/real_dashes.hpp"

namespace epura::pipeline {

namespace {

std::string encode(const output::Format& format, std::span<const FinishedSheet> sheets,
                   const output::VectorOptions& options, const report::Report& report, const Progress& progress) {
  output::FileContent content{{}, options, report};
  std::vector<sheet::Sheet> real;
  if (options.strokes == output::Strokes::real)
    for (const FinishedSheet& sheet : sheets) real.push_back(sheet::with_real_dashes(sheet.sheet));
  for (std::size_t i = 0; i < sheets.size(); ++i)
    content.sheets.push_back(
        {real.empty() ? sheets[i].sheet : real[i], sheets[i].scale, sheets[i].drawings, sheets[i].answers});
  return format.encode(content, progress);
}

// Sheets of one run may be embedded in one page.
output::VectorOptions options_of_sheet(output::VectorOptions options, std::size_t number) {
  if (!options.id_prefix.empty()) options.id_prefix += "-" + std::to_string(number);
  return options;
}

std::size_t lines_of(std::span<const FinishedSheet> sheets) {
  std::size_t lines = 0;
  for (const FinishedSheet& sheet : sheets)
    for (const sheet::Layer& layer : sheet.sheet.layers) lines += layer.strokes.size();
  return lines;
}

}  // namespace

std::vector<std::string> one_for_each(const std::string& path, std::size_t sheets) {
  if (sheets == 1) return {path};
  const std::filesystem::path file(path);
  const std::string stem = (file.parent_path() / file.stem()).string() + "-";
  std::vector<std::string> paths;
  for (std::size_t i = 1; i <= sheets; ++i) paths.push_back(stem + std::to_string(i) + file.extension().string());
  return paths;
}

std::vector<std::string> files_of(const Target& target, std::size_t sheets) {
  return one_for_each(target.path, target.format->has_pages || target.path == "-" ? 1 : sheets);
}

std::vector<std::string> files_of(const std::vector<Target>& targets, std::size_t sheets) {
  std::vector<std::string> all;
  for (const Target& target : targets)
    for (std::string& file : files_of(target, sheets)) all.push_back(std::move(file));
  return all;
}

std::vector<std::string> inputs_of(const scene::SceneDescription& scene) {
  std::vector<std::string> files;
  for (const scene::ModelDescription& model : scene.models)
    if (model.file.given()) files.push_back(*model.file);
  for (const scene::SheetDescription& sheet : scene.sheets)
    for (const scene::LocatedText* file : {&sheet.form, &sheet.logo, &sheet.style})
      if (file->given()) files.push_back(**file);
  return files;
}

void refuse_overwriting(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  struct Taken {
    std::string name, role;
  };
  std::map<std::string, Taken> taken;  // by identity of the file
  for (const std::string& input : inputs) taken.insert({identity_of_file(input), {input, "input"}});
  for (const std::string& output : outputs) {
    const std::string identity = output == "-" ? output : identity_of_file(output);
    if (identity.empty()) continue;
    const auto [other, is_free] = taken.insert({identity, {output, "output"}});
    const auto& [name, role] = other->second;
    if (!is_free)
      throw Error(ErrorKind::input, output,
                  name != output ? "is the " + role + " " + name + " under another name"
                                 : "is given twice, the other time as " + role,
                  "write to another file");
  }
}

std::vector<Target> targets_of(const std::vector<std::string>& paths, const std::string& dash_format) {
  if (!dash_format.empty() && std::find(paths.begin(), paths.end(), "-") == paths.end())
    throw Error(ErrorKind::input, "--format", "applies to standard output, and nothing is written there",
                "add '-o -'; files get their format from the extension");
  std::vector<Target> targets;
  for (const std::string& path : paths) {
    std::string extension = path == "-" ? dash_format : std::filesystem::path(path).extension().string();
    if (extension.starts_with(".")) extension.erase(0, 1);
    const output::Format* format = output::find_format(extension);
    if (!format && path == "-")
      throw Error(ErrorKind::input, "--output -", "needs --format", output::format_hint(extension));
    if (!format)
      throw Error(ErrorKind::input, path,
                  extension.empty() ? "has no extension, so its format is unknown" : "has an unknown format",
                  output::format_hint(extension));
    targets.push_back({path, format});
  }
  return targets;
}

void warn_about_pictures(const Messages& messages, const std::vector<Target>& targets,
                         std::span<const FinishedSheet> sheets) {
  std::vector<std::string> names;
  for (const FinishedSheet& sheet : sheets)
    for (const sheet::Layer& layer : sheet.sheet.layers)
      for (const sheet::Picture& picture : layer.pictures)
        if (std::find(names.begin(), names.end(), picture.name) == names.end()) names.push_back(picture.name);
  for (const Target& target : targets) {
    if (target.format->has_pictures) continue;
    for (const std::string& name : names)
      messages.warn(target.path + ": the picture " + name + " is missing, as " + std::string(target.format->name) +
                    " has no pictures of pixels\n  hint: use a logo in SVG");
  }
}

std::vector<FileBytes> encode_all(const std::vector<Target>& targets, std::span<const FinishedSheet> sheets,
                                  const output::VectorOptions& options, const report::Report& report,
                                  Progress progress) {
  progress.begin("writing", targets.size() * lines_of(sheets));
  std::vector<FileBytes> files;
  for (const Target& target : targets) {
    const bool one_each = sheets.size() > 1 && !target.format->has_pages;
    if (one_each && target.path == "-")
      throw Error(ErrorKind::input, "--output -",
                  "can hold one sheet only, and there are " + std::to_string(sheets.size()),
                  "write PDF, or write to a file");
    const std::vector<std::string> paths = files_of(target, sheets.size());
    const auto encoded = [&](std::size_t i) {
      if (!one_each) return encode(*target.format, sheets, options, report, progress);
      return encode(*target.format, sheets.subspan(i, 1), options_of_sheet(options, i + 1), report, progress);
    };
    for (std::size_t i = 0; i < paths.size(); ++i) files.push_back({paths[i], encoded(i)});
    progress.expect_time();
  }
  return files;
}

void write(const FileBytes& file, Progress progress) {
  if (file.path != "-") return write_file(file.path, file.bytes, progress);
  if (std::fwrite(file.bytes.data(), 1, file.bytes.size(), stdout) != file.bytes.size() || std::fflush(stdout) != 0)
    throw Error(ErrorKind::output, "standard output", "cannot be written");
}

}  // namespace epura::pipeline
