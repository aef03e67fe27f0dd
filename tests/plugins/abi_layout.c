/* SPDX-License-Identifier: Apache-2.0 */
/* What C makes of projection_abi.h. */
#include "abi_layout.h"

#include <epura/projection_abi.h>
#include <stddef.h>

#define AT(structure, member, offset) _Static_assert(offsetof(structure, member) == offset, #structure "." #member);
#define SIZE(structure, bytes) _Static_assert(sizeof(structure) == bytes, #structure);
#define VALUE(name, number) _Static_assert(name == number, #name);

EPURA_LAYOUT(AT, SIZE, VALUE)

/* A unit that declares nothing is no C. */
typedef int abi_layout_holds;
