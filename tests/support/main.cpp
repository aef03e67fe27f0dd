// SPDX-License-Identifier: Apache-2.0
// Runs the tests of a program under the locale of the environment, as programs with Qt or GTK run the library.
#include <gtest/gtest.h>

#include <clocale>

int main(int argc, char** argv) {
  std::setlocale(LC_ALL, "");
  std::setlocale(LC_MESSAGES, "C");  // tests compare what the system says
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
