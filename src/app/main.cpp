// SPDX-License-Identifier: Apache-2.0
#include "app/define_commands.hpp"
#include "app/study.hpp"

int main(int argc, char** argv) {
  using namespace epura;
  return run_program([&] {
    if (const auto arguments = study_arguments(argc, argv)) start_study(*arguments);
    return run_command_line(program_texts(), define_commands, argc, argv);
  });
}
