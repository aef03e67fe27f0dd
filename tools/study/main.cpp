// SPDX-License-Identifier: Apache-2.0
#include "study/commands.hpp"

int main(int argc, char** argv) {
  using namespace epura;
  return run_program([&] { return run_command_line(study_texts(), define_study_commands, argc, argv); });
}
