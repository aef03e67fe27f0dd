/* SPDX-License-Identifier: Apache-2.0 */
/* Asking it never ends. */
#include <unistd.h>

static const char* hang(void) {
  while (pause() != 0) continue;
  return 0;
}

#define SENTENCE hang()
#include "plain.c"
