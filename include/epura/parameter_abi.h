/* SPDX-License-Identifier: Apache-2.0 */
/* Common to the interfaces of projections (projection_abi.h) and importers (importer_abi.h): the table of parameters.
 */
#ifndef EPURA_PARAMETER_ABI_H
#define EPURA_PARAMETER_ABI_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EPURA_EXPORT __attribute__((visibility("default")))

enum { EPURA_NUMBER = 0, EPURA_VECTOR = 1, EPURA_CHOICE = 2 };

/* One row of the table in which a projection or an importer declares its parameters. */
typedef struct epura_parameter {
  uint32_t size;  /* sizeof(epura_parameter) */
  uint32_t type;  /* EPURA_NUMBER, EPURA_VECTOR or EPURA_CHOICE */
  uint32_t count; /* number of doubles: 1, or the length of the vector */
  const char* name;
  const char* unit;    /* "deg", "1", "model units", ... */
  const char* help;    /* one line */
  const char* choices; /* "a|b|c" for EPURA_CHOICE, otherwise NULL; the value is the index in the list, from 0 */
  double initial[8];   /* the default; NaN: determined by the plugin, for example from the model's box */
  double least, most;  /* bounds of every component, inclusive */
} epura_parameter;

#ifdef __cplusplus
}
#endif

#endif
