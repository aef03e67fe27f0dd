// SPDX-License-Identifier: Apache-2.0
// The program epura-importer: loads one library of importers and answers the program that started it over descriptor 3.
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "importer/process.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("epura-importer: is started by epura where it reads models\n", stderr);
    return 2;
  }
  constexpr int socket = 3;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Libraries without memory throw where nothing expects it. The program that started this one says which file it was.
  std::set_terminate([] { ::_exit(1); });
  try {
    epura::importer::serve(argv[1], socket);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "epura-importer: %s\n", error.what());
    ::_exit(1);
  }
  ::_exit(0);  // skips exit handlers of the library
}
