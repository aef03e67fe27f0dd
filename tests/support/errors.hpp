// SPDX-License-Identifier: Apache-2.0
// Checks for expected errors.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace epura::test {

/// The error that `action` throws; fails if there is none.
template <class Action>
Error error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error was thrown";
  return {ErrorKind::input, "", ""};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace epura::test
