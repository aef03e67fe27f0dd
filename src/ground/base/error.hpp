// SPDX-License-Identifier: Apache-2.0
// The only error type: errors that the user can correct. Thrown anywhere, caught once, in app.
#pragma once

#include <stdexcept>
#include <string>

namespace epura {

/// Kind of error; the value is the exit code of the program.
enum class ErrorKind { input = 2, plugin = 3, output = 4, time = 5 };

/// Gives the place (file:line, an option, a plugin), the reason and, if there is one, the remedy.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string where, std::string what, std::string hint = {});

  [[nodiscard]] ErrorKind kind() const { return trouble_; }
  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::string& hint() const { return hint_; }

 private:
  ErrorKind trouble_;
  std::string where_;
  std::string hint_;
};

/// Throws Error{input}.
[[noreturn]] void refuse_input(const std::string& where, const std::string& reason, const std::string& hint = {});

/// For programming errors: throws Broken (base/broken.hpp) with the sentence, in every build type.
void check(bool condition, const char* sentence);

}  // namespace epura
