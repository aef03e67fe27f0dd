/* SPDX-License-Identifier: Apache-2.0 */
/* Leaves another rounding mode behind. */
#include <fenv.h>

#define SENTENCE (fesetround(FE_UPWARD), NULL)
#include "plain.c"
