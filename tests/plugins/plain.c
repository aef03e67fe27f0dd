/* SPDX-License-Identifier: Apache-2.0 */
/* A good plugin in plain C. Each bad one is this with a single macro set otherwise; see CMakeLists.txt. */
#include <epura/projection_abi.h>
#include <math.h>
#include <stddef.h>

#ifndef ENTRY
#define ENTRY epura_projections_v1
#endif
#ifndef LIST
#define LIST &list
#endif
#ifndef ABI
#define ABI EPURA_ABI_VERSION
#endif
#ifndef LIST_SIZE
#define LIST_SIZE sizeof(epura_projection_list)
#endif
#ifndef COUNT
#define COUNT 1
#endif
#ifndef ROW_SIZE
#define ROW_SIZE sizeof(epura_projection)
#endif
#ifndef NAME
#define NAME "plain"
#endif
#ifndef FUNCTION
#define FUNCTION project
#endif
#ifndef INITIAL
#define INITIAL 1
#endif
#ifndef POINT
#define POINT 0
#endif
#ifndef NORMAL
#define NORMAL -1
#endif
#ifndef UP
#define UP 1
#endif
#ifndef PROJECTOR
#define PROJECTOR -1
#endif
#ifndef TILT
#define TILT 0.5
#endif
#ifndef SCALE
#define SCALE values[0]
#endif
#ifndef WINDOW
#define WINDOW 0
#endif
#ifndef FRONT
#define FRONT HUGE_VAL
#endif
#ifndef SUMMARY
#define SUMMARY "a slanted view"
#endif
#ifndef SENTENCE
#define SENTENCE NULL
#endif

static const epura_parameter parameters[] = {
    {sizeof(epura_parameter), EPURA_NUMBER, 1, "scale", "1", "enlargement", NULL, {INITIAL}, 0.5, 2},
};

static int calls;

const char* project(const double* values, const epura_scene* scene, epura_view* view) {
  (void)values, (void)scene;
  ++calls;
  view->point[0] = POINT;
  view->normal[1] = NORMAL;
  view->up[1] = 1, view->up[2] = UP;
  view->projector[1] = PROJECTOR, view->projector[2] = TILT;
  view->scale = SCALE;
  view->window[2] = view->window[3] = WINDOW;
  view->front = FRONT;
  return SENTENCE;
}

static const epura_projection projections[] = {
    {ROW_SIZE, NAME, "test", SUMMARY, NULL, 1, parameters, FUNCTION},
};
const epura_projection_list list = {ABI, LIST_SIZE, COUNT, projections};

const epura_projection_list* ENTRY(void) { return LIST; }
