// SPDX-License-Identifier: Apache-2.0
// Rows of the table in which a projection or an importer declares its parameters.
#pragma once

#include <epura/parameter_abi.h>

#include <array>
#include <cstddef>
#include <limits>

namespace epura::plugin {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();
/// As a default: the plugin determines the value, for example from the model's box. The value is then passed as NaN.
inline constexpr double from_box = std::numeric_limits<double>::quiet_NaN();

/// Rows of the table, with one function for each kind of parameter.
constexpr epura_parameter number(const char* name, const char* unit, const char* help, double initial, double least,
                                 double most) {
  return {sizeof(epura_parameter), EPURA_NUMBER, 1, name, unit, help, nullptr, {initial}, least, most};
}

template <std::size_t N>
constexpr epura_parameter vector(const char* name, const char* unit, const char* help,
                                 const std::array<double, N>& initial) {
  static_assert(N >= 1 && N <= 8, "a vector has one to eight components");
  epura_parameter row{sizeof(epura_parameter), EPURA_VECTOR, N, name, unit, help, nullptr, {}, -unlimited, unlimited};
  for (std::size_t i = 0; i < N; ++i) row.initial[i] = initial[i];
  return row;
}

/// A vector that is determined from the box unless it is given.
template <std::size_t N>
constexpr epura_parameter vector(const char* name, const char* unit, const char* help) {
  std::array<double, N> initial{};
  initial.fill(from_box);
  return vector(name, unit, help, initial);
}

/// `choices` has the form "a|b|c"; `initial` is an index into that list.
constexpr epura_parameter choice(const char* name, const char* help, const char* choices, int initial) {
  double most = 0;
  for (const char* c = choices; *c != 0; ++c) most += *c == '|';
  return {sizeof(epura_parameter), EPURA_CHOICE, 1, name, "", help, choices, {double(initial)}, 0, most};
}

inline constexpr std::array<epura_parameter, 0> no_parameters{};

}  // namespace epura::plugin
