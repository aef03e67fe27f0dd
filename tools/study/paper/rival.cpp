// SPDX-License-Identifier: Apache-2.0
#include "study/paper/rival.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "base/text.hpp"

namespace epura::study {

namespace {

namespace fs = std::filesystem;

std::string to_off(const mesh::Soup& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.face_ends.size()) + " 0\n";
  for (const auto& p : mesh.points)
    text += format_number(p[0]) + ' ' + format_number(p[1]) + ' ' + format_number(p[2]) + '\n';
  std::size_t begin = 0;
  for (const int end : mesh.face_ends) {
    text += std::to_string(static_cast<std::size_t>(end) - begin);
    for (; begin < static_cast<std::size_t>(end); ++begin) text += ' ' + std::to_string(mesh.corners[begin]);
    text += '\n';
  }
  return text;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (const std::string_view word : split(line, ' '))
    if (!word.empty()) words.push_back(word);
  return words;
}

std::vector<InkLine> parse_lines(const std::string& text, const std::string& name) {
  std::vector<InkLine> lines;
  std::size_t row = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++row;
    std::vector<double> numbers;
    for (const std::string_view word : words_of(line)) numbers.push_back(parse_number(word).value_or(NAN));
    if (numbers.empty()) continue;
    if (numbers.size() != 4 || !std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
      throw Error(ErrorKind::input, name, "row " + std::to_string(row) + " of its lines is not four numbers");
    lines.push_back({Vec2(numbers[0], numbers[1]), Vec2(numbers[2], numbers[3])});
  }
  return lines;
}

double seconds_in(const std::string& text) {
  double seconds = 0;
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() == 3 && words[2] == "s" && words[0] != "read" && words[0] != "write")
      seconds += parse_number(words[1]).value_or(0);
  }
  return seconds;
}

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

}  // namespace

Rival parse_rival(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    throw Error(ErrorKind::input, "--rival", "'" + text + "' is not NAME=COMMAND",
                "for example: --rival 'Open CASCADE=build/bench/bin/occ'");
  return {text.substr(0, at), text.substr(at + 1)};
}

RivalDrawing draw_by(const Rival& rival, const mesh::Soup& mesh, const std::string& bodies) {
  const TemporaryFolder scratch;
  const fs::path model = scratch / "mesh.off", lines = scratch / "lines.txt", messages = scratch / "messages.txt";
  write_file(model, to_off(mesh));
  write_file(scratch / "bodies.txt", bodies);
  const std::string command =
      rival.command + ' ' + in_quotes(model) + ' ' + in_quotes(lines) + " >/dev/null 2>" + in_quotes(messages);
  const int status = std::system(command.c_str());
  const std::string said = read_file(messages);
  constexpr int cannot_draw = 77;
  if (WIFEXITED(status) && WEXITSTATUS(status) == cannot_draw) return {{}, 0, false};
  if (status != 0 || !fs::exists(lines))
    throw Error(ErrorKind::input, "--rival", rival.name + " failed: " + said, "run it by hand: " + rival.command);
  return {parse_lines(read_file(lines), rival.name), seconds_in(said)};
}

}  // namespace epura::study
