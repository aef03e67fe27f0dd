/* SPDX-License-Identifier: Apache-2.0 */
/* Changes arithmetic when it is loaded, as libraries built with -ffast-math do. */
#include <fenv.h>

__attribute__((constructor)) static void round_up(void) { fesetround(FE_UPWARD); }
#include "plain.c"
