// SPDX-License-Identifier: Apache-2.0
// How options are given to CLI11, so that all of them are parsed, refused and explained alike.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "base/text.hpp"

namespace epura {

/// Words with spaces between them.
std::string joined(const std::vector<std::string>& words);

/// What a number may be, both ends included.
struct Range {
  double least, most;
};

inline constexpr Range any_number{-HUGE_VAL, HUGE_VAL};

/// CLI11 would take "nan", and its messages know neither the option nor our way to write numbers. Throws Error{input}.
double number_of(const std::string& option, const std::string& text, const Range& range, bool whole);

template <class Number>
CLI::Option* add_number(CLI::App& app, const std::string& option, Number& value, const Range& range,
                        const std::string& help) {
  constexpr bool whole = std::is_integral_v<Number>;
  CLI::Option* added = app.add_option_function<std::string>(
      option,
      [&value, option, range](const std::string& text) { value = Number(number_of(option, text, range, whole)); },
      help);
  if constexpr (std::is_arithmetic_v<Number>) added->default_str(format_number(value));
  return added;
}

/// As often as wanted, one value each time: what follows may be a model.
CLI::Option* add_list(CLI::App& app, const std::string& option, auto& values, const std::string& help) {
  return app.add_option(option, values, help)->allow_extra_args(false);
}

/// `usual` is said in the help, and is what a later stage makes of nothing.
void add_word(CLI::App& app, const std::string& option, std::string& value, const std::string& type,
              const std::string& usual, const std::string& help);

/// A flag that stands for one word of several.
void add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& word,
                const std::string& help);

/// What an option has to do with: the look of a drawing, files that are read or written, code that is loaded, or the
/// run and what it says. The help has a heading for each. In the hands of strangers only the first is harmless.
enum class Nature { drawing, file, code, run };

/// The options that are defined from here on are of this nature; those before any call are of none.
void define_next(CLI::App& app, Nature nature);

bool is_of(const CLI::Option& option, Nature nature);

/// The innermost command that was named.
const CLI::App& chosen_command(const CLI::App& app);

/// CLI11 says which arguments nobody took; this says what was perhaps meant. Throws Error{input}.
[[noreturn]] void refuse_wrong_use(const CLI::App& app, const CLI::ParseError& error);

/// --threads and --progress of commands that compute for long.
void add_threads(CLI::App& app, int& threads);
void add_progress(CLI::App& app, std::string& progress);

}  // namespace epura
