// SPDX-License-Identifier: Apache-2.0
#include "snapshot/case_files.hpp"

#include <algorithm>
#include <system_error>

#include "app/command_line_options.hpp"
#include "app/draw_options.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"
#include "scene/scene_file.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

bool is_link_outside(const fs::path& path, const fs::path& root) {
  std::error_code error;
  return fs::is_symlink(path, error) && is_within(fs::weakly_canonical(path.parent_path()), root) &&
         !is_within(fs::weakly_canonical(end_of_links(path)), root);
}

void refuse_link_outside(const fs::path& file, const fs::path& root) {
  fs::path way;
  for (const fs::path& step : fs::absolute(file)) {
    way /= step;
    if (is_link_outside(way, root))
      throw Error(ErrorKind::input, way.string(), "is a link that leaves " + root.string(),
                  "put the file itself there");
  }
}

std::vector<std::string> words_of(const std::string& text) {
  std::string blanks = text;
  std::replace_if(
      blanks.begin(), blanks.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  std::vector<std::string> words;
  for (const std::string_view word : split(blanks, ' '))
    if (!word.empty()) words.emplace_back(word);
  return words;
}

}  // namespace

std::vector<fs::path> files_of(const SnapshotCase& one) {
  std::vector<fs::path> files;
  for (const char* name : {"scene.toml", "options", "expected.json", "expected.svg", "expected.pdf"})
    files.push_back(one.folder / name);
  const scene::SceneDescription scene = scene::read_scene_file(files.front(), scene::FilesOutside::allowed);
  for (fs::path& file : scene::files_named_in(scene))
    files.emplace_back(importer::parse_model_request(file.string()).path);
  return files;
}

void refuse_links_outside(const SnapshotCase& one) {
  refuse_link_outside(one.folder / "scene.toml", one.root);
  for (const fs::path& file : files_of(one)) {
    refuse_link_outside(file, one.root);
    if (fs::exists(file) && !fs::is_regular_file(file)) throw Error(ErrorKind::input, file.string(), "is not a file");
  }
}

std::vector<std::string> drawing_options(const std::string& text, const std::string& file) {
  CLI::App program("", "epura");
  CLI::App& draw = *program.add_subcommand("draw");
  const scene::Options<DrawOptions> options = draw_options();
  for (const scene::OptionInfo& option : options) define(draw, option);
  draw.get_option("models")->required(false);
  draw.set_help_flag();
  const std::vector<std::string> words = words_of(text);
  std::vector<std::string> arguments(words.rbegin(), words.rend());  // CLI11 expects them in reverse order
  arguments.emplace_back("draw");
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    refuse_wrong_use(program, error);
  }
  for (const scene::OptionInfo& option : options)
    if (option.nature != scene::Nature::drawing && !given_values(draw, option).empty())
      throw Error(ErrorKind::input, file, "'" + option.flag + "' is not an option of the drawing itself",
                  "a case must not read, write, load or run anything else");
  return words;
}

void refuse_options_outside(const std::vector<std::string>& words, const SnapshotCase& one) {
  for (const std::string_view word : words)
    for (const std::string_view file : {word, word.substr(word.find('=') + 1)})
      if (!file.empty()) refuse_link_outside(file, one.root);
}

}  // namespace epura
