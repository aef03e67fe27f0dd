// SPDX-License-Identifier: Apache-2.0
// Whole numbers and multiples of powers of ten as text, written where the caller has room: the inner loop of long
// files.
#pragma once

#include <cstddef>

namespace epura {

/// Room for any number that is written here.
inline constexpr std::size_t longest_decimal = 24;

/// Whether a zero is written before the point of "0.5".
enum class LeadingZero { written, omitted };

/// Writes scaled / 10^decimals without trailing zeros, never "-0"; up to 6 decimals. Returns the end.
char* write_scaled(char* at, long long scaled, int decimals, LeadingZero zero);

/// Returns the end.
char* write_whole(char* at, long long value);

/// Reads the number with which a text begins, as parse_number does. Returns its end, at which there must be a blank,
/// the end of a line or of the text; null if there is no such number.
const char* read_number(const char* at, const char* end, double& value);
const char* read_number(const char* at, const char* end, long long& value);

}  // namespace epura
