/* SPDX-License-Identifier: Apache-2.0 */
/* Says what terminals obey: clears the screen, turns the direction of writing, begins lines; and bytes that are no
 * text. */
#define HOSTILE       \
  "a\x1b[2Jb\xc2\x9b" \
  "31mc\xe2\x80\xae"  \
  "d\nepura: e\xff"
#define SUMMARY HOSTILE
#define SENTENCE (values[0] == 2 ? HOSTILE : NULL)
#include "plain.c"
