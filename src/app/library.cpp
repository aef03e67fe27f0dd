// SPDX-License-Identifier: Apache-2.0
// The library's face: a request becomes a command line, so that both know the same options and say the same of them.
#include <epura/epura.hpp>

#include "app/command_line.hpp"
#include "app/draw_files.hpp"
#include "base/error.hpp"

namespace epura {

namespace {

std::vector<std::string> arguments_of(const Request& request) {
  std::vector<std::string> arguments{"epura", "draw"};
  for (const std::string& projection : request.projections) arguments.push_back("--projection=" + projection);
  for (const auto& [name, value] : request.options)
    arguments.push_back("--" + name + (value.empty() ? "" : "=" + value));
  for (const std::string& output : request.outputs) arguments.push_back("--output=" + output);
  arguments.emplace_back("--");
  arguments.insert(arguments.end(), request.models.begin(), request.models.end());
  return arguments;
}

DrawOptions options_of(const Request& request) {
  std::vector<std::string> arguments = arguments_of(request);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  const Command command = parse_command_line(static_cast<int>(pointers.size()), pointers.data());
  const auto* options = std::get_if<DrawOptions>(&command);
  if (options == nullptr) throw Error(ErrorKind::input, "options", "ask for help, which only the program gives");
  for (const std::string& output : options->outputs)
    if (output == "-") throw Error(ErrorKind::input, "outputs", "'-' is not a file", "name a file and its extension");
  return *options;
}

Result run(const Request& request) {
  Result result;
  const Messages messages{[&](const std::string& sentence) { result.warnings.push_back(sentence); },
                          [&](std::string_view lines) { result.report += lines; }};
  const DrawOptions options = options_of(request);
  ProgressBoard board;
  const DrawnFiles drawn = draw_files(options, messages, Progress(board, options.run.time_limit));
  result.files = drawn.paths;
  result.report += drawn.answers;
  tell_the_end(messages, options, drawn);
  result.is_partial = !drawn.report.partial.stages.empty();
  result.is_wrong = drawn.is_wrong();
  return result;
}

}  // namespace

Result draw(const Request& request) {
  try {
    return run(request);
  } catch (const Error& error) {
    throw Failure(static_cast<Failure::Kind>(error.kind()), error.what(), error.hint());
  }
}

const char* version() noexcept { return EPURA_VERSION; }

}  // namespace epura
