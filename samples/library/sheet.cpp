// SPDX-License-Identifier: Apache-2.0
// Draws a model from the front and in perspective:  sheet MODEL PDF
#include <epura/epura.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const epura::Result drawn = epura::draw({.models = {argv[1]},
                                             .projections = {"front", "two-point"},
                                             .options = {{"sheet", "A3"}, {"hidden", "none"}},
                                             .outputs = {argv[2]}});
    for (const std::string& warning : drawn.warnings) std::cerr << warning << '\n';
  } catch (const epura::Failure& failure) {
    std::cerr << failure.what() << '\n' << failure.hint() << '\n';
    return static_cast<int>(failure.kind());
  }
}
