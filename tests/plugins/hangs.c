/* SPDX-License-Identifier: Apache-2.0 */
/* Loading it never ends. */
#include <unistd.h>

__attribute__((constructor)) static void hang(void) {
  for (;;) pause();
}
#include "plain.c"
