/* SPDX-License-Identifier: Apache-2.0 */
/* Reads terrain: a text file with the numbers of columns and rows, the width of a cell in metres, and the heights. */
#include <epura/importer_abi.h>
#include <stdio.h>
#include <stdlib.h>

static const char* hand_over(const epura_sink* to, int columns, int rows, double* points) {
  uint32_t corners[4];
  const uint64_t end = 4;
  if (to->unit(to->host, 1000) || to->shape(to->host, "terrain")) return "is cancelled";
  if (to->points(to->host, (uint64_t)columns * (uint64_t)rows, points)) return "is cancelled";
  for (int y = 0; y + 1 < rows; ++y)
    for (int x = 0; x + 1 < columns; ++x) {
      corners[0] = (uint32_t)(y * columns + x);
      corners[1] = corners[0] + 1;
      corners[2] = corners[1] + (uint32_t)columns;
      corners[3] = corners[0] + (uint32_t)columns;
      if (to->polygons(to->host, 1, &end, corners)) return "is cancelled";
    }
  return NULL;
}

static const char* read_terrain(const epura_source* source, const epura_sink* to) {
  const char* sentence = "is no terrain: columns, rows, width of a cell, and a height for each of their points";
  int columns = 0, rows = 0;
  double cell = 0, *points = NULL;
  FILE* file = fopen(source->path, "r");
  if (file == NULL) return "cannot be opened";
  if (fscanf(file, "%d %d %lf", &columns, &rows, &cell) == 3 && columns > 1 && rows > 1 && columns < 10000 &&
      rows < 10000)
    points = malloc(sizeof(double) * 3 * (size_t)columns * (size_t)rows);
  for (int i = 0; points != NULL && i < columns * rows; ++i) {
    points[3 * i] = cell * (i % columns);
    points[3 * i + 1] = cell * (i / columns);
    if (fscanf(file, "%lf", points + 3 * i + 2) != 1) free(points), points = NULL;
  }
  if (points != NULL) sentence = hand_over(to, columns, rows, points);
  free(points);
  fclose(file);
  return sentence;
}

static const epura_importer importers[] = {
    {sizeof(epura_importer), 0, "terrain", "heights on a grid", "terrain", NULL, 0, NULL, read_terrain}};
static const epura_importer_list list = {EPURA_IMPORTER_ABI_VERSION, sizeof(epura_importer_list), 1, importers};

const epura_importer_list* epura_importers_v1(void) { return &list; }
