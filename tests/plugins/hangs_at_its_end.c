/* SPDX-License-Identifier: Apache-2.0 */
/* Unloading it, or ending its process by exit, never ends. */
#include <unistd.h>

__attribute__((destructor)) static void hang(void) {
  for (;;) pause();
}
#include "plain.c"
