/* SPDX-License-Identifier: Apache-2.0 */
/* A plugin built with the headers of a later program, in which every structure has grown. */
#include <epura/projection_abi.h>
#include <stddef.h>

typedef struct new_parameter {
  epura_parameter known;
  const char* symbol;
  double step;
} new_parameter;

typedef struct new_projection {
  epura_projection known;
  uint64_t flags;
} new_projection;

typedef struct new_list {
  epura_projection_list known;
  const char* author;
} new_list;

#define NUMBER(name, initial) \
  { {sizeof(new_parameter), EPURA_NUMBER, 1, name, "1", "a number", NULL, {initial}, 0.5, 8}, "?", 0.25 }

static const new_parameter parameters[] = {NUMBER("slant", 0.5), NUMBER("scale", 2)};

static const char* project(const double* values, const epura_scene* scene, epura_view* view) {
  (void)scene;
  view->normal[1] = -1;
  view->up[2] = 1;
  view->projector[0] = values[0], view->projector[1] = -1;
  view->scale = values[1];
  return NULL;
}

#define PROJECTION(name) \
  { {sizeof(new_projection), name, "test", "from the future", NULL, 2, &parameters[0].known, project}, ~0ull }

static const new_projection projections[] = {PROJECTION("newer"), PROJECTION("newest")};
static const new_list list = {{EPURA_ABI_VERSION, sizeof(new_list), 2, &projections[0].known}, "nobody"};

const epura_projection_list* epura_projections_v1(void) { return &list.known; }
