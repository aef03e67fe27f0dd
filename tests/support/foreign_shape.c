/* SPDX-License-Identifier: Apache-2.0 */
/* What a shape of another library of Open CASCADE looks like, as modules for Python bring one: it points to an object that
 * begins with the table of functions of its class, which lies in that library. */
static const void* const functions[4];
static const void* const shared[2] = {functions, 0};
const void* const foreign_shape[3] = {shared, 0, 0};
