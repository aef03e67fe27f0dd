/* SPDX-License-Identifier: Apache-2.0 */
/* Prints where a drawing may go. */
#include <stdio.h>

#define SENTENCE (puts("noise"), fflush(stdout), NULL)
#include "plain.c"
