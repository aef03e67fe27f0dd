#include "app/command_options.hpp"

#include "base/error.hpp"

namespace epura {

namespace {

std::string text_of(const Range& range) {
  if (std::isinf(range.most)) return format_number(range.least) + " or more";
  return format_number(range.least) + " to " + format_number(range.most);
}

}  // namespace

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

double number_of(const std::string& option, const std::string& text, const Range& range, bool whole) {
  const auto number = parse_number(text);
  if (!number || !std::isfinite(*number) || (whole && *number != std::floor(*number)))
    throw Error(Trouble::input, option, "'" + text + "' is no " + (whole ? "whole number" : "number"));
  if (*number < range.least || *number > range.most)
    throw Error(Trouble::input, option, "is " + text + ", allowed is " + text_of(range));
  return *number;
}

void add_word(CLI::App& app, const std::string& option, std::string& value, const std::string& type,
              const std::string& usual, const std::string& help) {
  app.add_option(option, value, help)->type_name(type)->default_str(usual);
}

void add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& word,
                const std::string& help) {
  app.add_flag_callback(
      option, [&value, word] { value = word; }, help);
}

void add_threads(CLI::App& app, int& threads) {
  add_number(app, "--threads", threads, {0, 1024}, "number of threads, 0 for all cores")->type_name("N");
}

void add_progress(CLI::App& app, std::string& progress) {
  app.add_option("--progress", progress, "show how far it is: auto (on a terminal), always or never")
      ->capture_default_str()
      ->type_name("WHEN");
}

}  // namespace epura
