/* SPDX-License-Identifier: Apache-2.0 */
/* Asking it ends the program. */
#include <stdlib.h>

#define SENTENCE (abort(), NULL)
#include "plain.c"
