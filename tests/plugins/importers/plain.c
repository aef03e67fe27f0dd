/* SPDX-License-Identifier: Apache-2.0 */
/* A good importer in plain C: whatever the file holds, it hands over a unit square. Each bad one is this with a single
 * macro set otherwise; see CMakeLists.txt. */
#include <epura/importer_abi.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#ifndef ENTRY
#define ENTRY epura_importers_v1
#endif
#ifndef LIST
#define LIST &list
#endif
#ifndef ABI
#define ABI EPURA_IMPORTER_ABI_VERSION
#endif
#ifndef LIST_SIZE
#define LIST_SIZE sizeof(epura_importer_list)
#endif
#ifndef COUNT
#define COUNT 1
#endif
#ifndef ROW_SIZE
#define ROW_SIZE sizeof(epura_importer)
#endif
#ifndef NAME
#define NAME "plain"
#endif
#ifndef EXTENSIONS
#define EXTENSIONS "plain|pln"
#endif
#ifndef PARAMETER
#define PARAMETER "size"
#endif
#ifndef FUNCTION
#define FUNCTION read_plain
#endif
#ifndef FIRST /* what is done before anything is handed over */
#define FIRST (void)0
#endif
#ifndef LAST /* what is done when everything is handed over */
#define LAST (void)0
#endif
#ifndef CORNER
#define CORNER 3
#endif
#ifndef RADIUS
#define RADIUS 1
#endif
#ifndef PARENT
#define PARENT EPURA_NONE
#endif
#ifndef SHAPE
#define SHAPE 0
#endif
#ifndef SCALE
#define SCALE 1
#endif
#ifndef EDGE_COUNT
#define EDGE_COUNT 2
#endif
#ifndef EDGE_KIND
#define EDGE_KIND EPURA_SHARP
#endif
#ifndef EDGE_END
#define EDGE_END 1
#endif
#ifndef UNIT
#define UNIT 1
#endif

static const epura_parameter parameters[] = {
    {sizeof(epura_parameter), EPURA_NUMBER, 1, PARAMETER, "1", "length of a side", NULL, {1}, 0.5, 2},
};

static int recognises(const unsigned char* bytes, uint64_t count) {
  return count >= 5 && memcmp(bytes, "plain", 5) == 0;
}

const char* read_plain(const epura_source* source, const epura_sink* to) {
  const double size = source->values[0];
  const double points[12] = {0, 0, 0, size, 0, 0, size, size, 0, 0, size, 0};
  const uint64_t end = 4;
  const uint32_t corners[4] = {0, 1, 2, CORNER};
  const epura_face face = {sizeof(epura_face), EPURA_SPHERE, {0, 0, 0}, {0, 0, 1}, RADIUS, 0, 0};
  const uint32_t along[2] = {0, EDGE_END};
  const epura_edge edge = {sizeof(epura_edge), EDGE_KIND, 90, EDGE_COUNT, along};
  const epura_node node = {sizeof(epura_node), PARENT, SHAPE, 0, "node", {SCALE, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  FIRST;
  if (to->unit(to->host, UNIT) || to->shape(to->host, "square") || to->points(to->host, 4, points)) return "stops";
  if (to->face(to->host, &face) || to->polygons(to->host, 1, &end, corners)) return "stops";
  if (to->edge(to->host, &edge) || to->node(to->host, &node)) return "stops";
  LAST;
  return NULL;
}

static const epura_importer importers[] = {
    {ROW_SIZE, 0, NAME, "a square", EXTENSIONS, parameters, 1, recognises, FUNCTION},
};
const epura_importer_list list = {ABI, LIST_SIZE, COUNT, importers};

const epura_importer_list* ENTRY(void) { return LIST; }
