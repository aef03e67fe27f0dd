// SPDX-License-Identifier: Apache-2.0
#include "study/commands.hpp"

int main(int argc, char** argv) {
  using namespace epura::study;
  return epura::run_program([&] { return epura::run_command_line(study_texts(), define_study_commands, argc, argv); });
}
