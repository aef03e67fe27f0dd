/* SPDX-License-Identifier: Apache-2.0 */
/* The interface between epura and a projection plugin: plain C, doubles in, doubles out.
 *
 * A plugin is a shared library that exports one function, epura_projections_v1. Structures are only ever extended at
 * the end: each contains its size, and only members known to both sides are used. Nothing is allocated on one side and
 * freed on the other; strings must remain valid as long as the library, which is never unloaded.
 *
 * Axes of the world: x right, y away from the viewer of the front view, z up.
 */
#ifndef EPURA_PROJECTION_ABI_H
#define EPURA_PROJECTION_ABI_H

#include <epura/parameter_abi.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EPURA_ABI_VERSION 1u

/* The input of a projection from the scene: the box of everything drawn, least corner first. */
typedef struct epura_scene {
  uint32_t size;
  double least[3];
  double most[3];
} epura_scene;

enum { EPURA_PARALLEL = 0, EPURA_CENTRAL = 1 };

/* The result: a plane, projectors, and the part of the plane that is drawn. The host presets `projectors` to
 * EPURA_PARALLEL, `scale` to 1, `window` to zeros and the two limits to infinity: only the four vectors must be set. */
typedef struct epura_view {
  uint32_t size;       /* set by the host before the call */
  uint32_t projectors; /* EPURA_PARALLEL or EPURA_CENTRAL */
  double point[3];     /* a point of the plane: origin of window coordinates */
  double normal[3];    /* view plane normal; the host normalises it and orients it to the viewer's side */
  double up[3];        /* not parallel to the normal; its image points up the page */
  double projector[3]; /* parallel: direction towards the viewer; central: the centre of projection */
  double scale;        /* length on the page of a unit length in the plane; 1 unless the projection enlarges */
  double window[4];    /* least u, least v, most u, most v of the drawn part of the plane; all zero: everything */
  double front, back;  /* only what lies between these distances from `point` along `normal` is drawn;
                          front > back; infinite: no limit */
} epura_view;

/* One projection. `values` are the parameters in the order of the table, vectors flattened; a default of NaN is passed
 * as NaN. `project` returns NULL on success, otherwise a sentence that states why the values are invalid; it must
 * remain valid until the next call from the same thread. Must not throw exceptions. */
typedef struct epura_projection {
  uint32_t size;
  const char* name;      /* lower case, digits and '-' */
  const char* family;    /* "orthographic", "axonometric", "oblique", "perspective" or your own */
  const char* summary;   /* one line */
  const char* reference; /* standard, book or paper; may be NULL */
  uint32_t parameter_count;
  const epura_parameter* parameters; /* rows parameters[0].size bytes apart */
  const char* (*project)(const double* values, const epura_scene* scene, epura_view* view);
} epura_projection;

typedef struct epura_projection_list {
  uint32_t abi;  /* EPURA_ABI_VERSION; read before anything else */
  uint32_t size; /* sizeof(epura_projection_list) */
  uint32_t count;
  const epura_projection* projections; /* `count` rows, each projections[0].size bytes apart */
} epura_projection_list;

/* The only symbol of a plugin, and its type for callers that look it up. */
#define EPURA_ENTRY_POINT "epura_projections_v1"
EPURA_EXPORT const epura_projection_list* epura_projections_v1(void);
typedef const epura_projection_list* (*epura_entry_point)(void);

#ifdef __cplusplus
}
#endif

#endif
