// SPDX-License-Identifier: Apache-2.0
// Expects that a scene of the stability study is drawn correctly.
#pragma once

#include <gtest/gtest.h>

#include "study/stability/forms.hpp"

namespace epura::test {

/// Errors are at most `part` times what the study allows; counts are exact.
inline void expect_right(const stability::Measured& measured, double part = 5e-4) {
  for (const stability::Quantity& q : measured)
    EXPECT_LE(q.error(), part * q.allowed) << q.name << ": " << q.got << " for " << q.expected;
}

}  // namespace epura::test
