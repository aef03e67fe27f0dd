/* SPDX-License-Identifier: Apache-2.0 */
/* Takes half a second to load, and writes a byte before and after it where $EPURA_TEST_PIPE says. */
#include <stdlib.h>
#include <unistd.h>

static void write_byte(void) {
  const char* descriptor = getenv("EPURA_TEST_PIPE");
  if (descriptor == NULL || write(atoi(descriptor), ".", 1) != 1) abort();
}

__attribute__((constructor)) static void take_time(void) {
  write_byte();
  usleep(500000);
  write_byte();
}

#include "plain.c"
