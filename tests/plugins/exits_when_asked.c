/* SPDX-License-Identifier: Apache-2.0 */
/* Asking it ends the program as if all were well. */
#include <stdlib.h>

#define SENTENCE (exit(0), NULL)
#include "plain.c"
