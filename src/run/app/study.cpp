// SPDX-License-Identifier: Apache-2.0
#include "app/study.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "base/error.hpp"

namespace epura {

std::optional<std::vector<std::string>> study_arguments(int argc, char** argv) {
  using namespace std::string_view_literals;
  constexpr std::array asks_for_words{"completion"sv, "words"sv, "--"sv};
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (!words.empty() && words[0] == "study") return std::vector(words.begin() + 1, words.end());
  const std::size_t asked = asks_for_words.size();
  // If the word "study" itself is last, epura completes it.
  if (words.size() <= asked + 1 || words[asked] != "study" ||
      !std::equal(asks_for_words.begin(), asks_for_words.end(), words.begin()))
    return std::nullopt;
  std::vector<std::string> rest = words;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(asked));
  return rest;
}

void start_study(std::vector<std::string> arguments) {
  std::error_code unknown;
  std::string program =
      (std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "epura-study").string();
  std::vector<char*> words{program.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  const int reason = errno;
  if (reason == ENOENT)
    throw Error(ErrorKind::input, "study", "is a separate program, which is missing: " + program,
                "install the package epura-study");
  throw Error(ErrorKind::input, program, std::string("cannot be started: ") + std::strerror(reason));
}

}  // namespace epura
