/* SPDX-License-Identifier: Apache-2.0 */
/* Loading it ends the program. */
#include <stdlib.h>

__attribute__((constructor)) static void crash(void) { abort(); }
#include "plain.c"
