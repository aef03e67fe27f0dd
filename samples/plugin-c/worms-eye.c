/* SPDX-License-Identifier: Apache-2.0 */
/* Worm's-eye planometric projection, after Choisy: the plan from below, heights straight up from it. */
#include <epura/projection_abi.h>
#include <stddef.h>

static const epura_parameter parameters[] = {
    {sizeof(epura_parameter),
     EPURA_NUMBER,
     1,
     "height",
     "1",
     "length on the page of a unit of height",
     NULL,
     {1},
     0,
     10},
};

static const char* project(const double* values, const epura_scene* scene, epura_view* view) {
  for (int i = 0; i < 3; ++i) view->point[i] = scene->least[i];
  view->normal[2] = -1;
  view->up[0] = view->up[1] = 1; /* the plan stands on its corner */
  view->projector[0] = view->projector[1] = values[0] / 1.4142135623730951;
  view->projector[2] = -1;
  return NULL;
}

static const epura_projection projections[] = {
    {sizeof(epura_projection), "worms-eye", "oblique", "plan from below, heights straight up",
     "A. Choisy, Histoire de l'architecture, 1899", 1, parameters, project},
};
static const epura_projection_list list = {EPURA_ABI_VERSION, sizeof(epura_projection_list), 1, projections};

const epura_projection_list* epura_projections_v1(void) { return &list; }
