// SPDX-License-Identifier: Apache-2.0
#include <sys/mman.h>

#include <cstdio>

#include "app/study.hpp"
#include "program/define_commands.hpp"

// Cairo makes PostScript by way of a temporary file, which no sandbox allows. It finds this function before that of the
// system, and its file is in memory.
extern "C" __attribute__((visibility("default"))) std::FILE* tmpfile() {
  const int file = ::memfd_create("epura", MFD_CLOEXEC);
  return file < 0 ? nullptr : ::fdopen(file, "w+");
}

int main(int argc, char** argv) {
  using namespace epura;
  return run_program([&] {
    if (const auto arguments = study_arguments(argc, argv)) start_study(*arguments);
    return run_command_line(program_texts(), define_commands, argc, argv);
  });
}
