/* SPDX-License-Identifier: Apache-2.0 */
/* The layout of projection_abi.h on machines with pointers of 8 bytes, as docs/plugins.md promises it.
 * EPURA_LAYOUT(AT, SIZE, VALUE) calls AT(structure, member, offset), SIZE(structure, bytes), VALUE(name, number). */
#ifndef EPURA_ABI_LAYOUT_H
#define EPURA_ABI_LAYOUT_H

/* clang-format off */
#define EPURA_LAYOUT(AT, SIZE, VALUE)                                                                       \
  VALUE(EPURA_ABI_VERSION, 1)                                                                               \
  VALUE(EPURA_NUMBER, 0) VALUE(EPURA_VECTOR, 1) VALUE(EPURA_CHOICE, 2)                                      \
  VALUE(EPURA_PARALLEL, 0) VALUE(EPURA_CENTRAL, 1)                                                          \
  AT(epura_parameter, size, 0) AT(epura_parameter, type, 4) AT(epura_parameter, count, 8)                   \
  AT(epura_parameter, name, 16) AT(epura_parameter, unit, 24) AT(epura_parameter, help, 32)                 \
  AT(epura_parameter, choices, 40) AT(epura_parameter, initial, 48) AT(epura_parameter, least, 112)         \
  AT(epura_parameter, most, 120) SIZE(epura_parameter, 128)                                                 \
  AT(epura_scene, size, 0) AT(epura_scene, least, 8) AT(epura_scene, most, 32) SIZE(epura_scene, 56)        \
  AT(epura_view, size, 0) AT(epura_view, projectors, 4) AT(epura_view, point, 8) AT(epura_view, normal, 32) \
  AT(epura_view, up, 56) AT(epura_view, projector, 80) AT(epura_view, scale, 104)                           \
  AT(epura_view, window, 112) AT(epura_view, front, 144) AT(epura_view, back, 152) SIZE(epura_view, 160)    \
  AT(epura_projection, size, 0) AT(epura_projection, name, 8) AT(epura_projection, family, 16)              \
  AT(epura_projection, summary, 24) AT(epura_projection, reference, 32)                                     \
  AT(epura_projection, parameter_count, 40) AT(epura_projection, parameters, 48)                            \
  AT(epura_projection, project, 56) SIZE(epura_projection, 64)                                              \
  AT(epura_projection_list, abi, 0) AT(epura_projection_list, size, 4) AT(epura_projection_list, count, 8)  \
  AT(epura_projection_list, projections, 16) SIZE(epura_projection_list, 24)
/* clang-format on */

#endif
