/* SPDX-License-Identifier: Apache-2.0 */
/* Closes what it has not opened, and goes on. */
#include <unistd.h>

static const char* hang_up(void) {
  for (int file = 3; file < 1024; ++file) close(file);
  while (pause() != 0) continue;
  return 0;
}

#define SENTENCE hang_up()
#include "plain.c"
