/* SPDX-License-Identifier: Apache-2.0 */
/* Hidden-line removal in memory: writes the curves of a cylinder on a plate, and of a handle that is a spline, as SVG:
 * curves >curves.svg */
#include <epura/hlr.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIDES 48

/* All faces are declared: so the library knows that the sides of the cylinder are one, and which edges are its own. */
static epura_face face_of(uint32_t kind, double z) {
  epura_face face;
  memset(&face, 0, sizeof face);
  face.size = sizeof face;
  face.kind = kind;
  face.origin[2] = z;
  face.axis[2] = 1;
  return face;
}

static void add_plate(const epura_sink* sink) {
  static const double points[] = {-8, -8, -2, 8, -8, -2, 8, 8, -2, -8, 8, -2, -8, -8, 0, 8, -8, 0, 8, 8, 0, -8, 8, 0};
  static const uint32_t corners[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const uint64_t end = 4;
  sink->shape(sink->host, "plate");
  sink->points(sink->host, 8, points);
  for (int i = 0; i < 6; ++i) {
    epura_face face = face_of(EPURA_PLANE, 0);
    memcpy(face.origin, points + 3 * corners[i][0], sizeof face.origin);
    face.axis[0] = i == 3 || i == 5;
    face.axis[1] = i == 2 || i == 4;
    face.axis[2] = i < 2;
    sink->face(sink->host, &face);
    sink->polygons(sink->host, 1, &end, corners[i]);
  }
}

static void add_cylinder(const epura_sink* sink, double radius, double height) {
  sink->shape(sink->host, "cylinder");
  uint32_t rims[2][SIDES];
  for (uint32_t i = 0; i < 2 * SIDES; ++i) {
    const double angle = 8 * atan(1) * (i % SIDES) / SIDES;
    const double point[3] = {radius * cos(angle), radius * sin(angle), i < SIDES ? 0 : height};
    sink->points(sink->host, 1, point);
    rims[i / SIDES][i < SIDES ? SIDES - 1 - i : i - SIDES] = i; /* both counterclockwise as seen from outside */
  }
  const uint64_t end = SIDES, side_end = 4;
  for (int top = 0; top < 2; ++top) {
    const epura_face face = face_of(EPURA_PLANE, top ? height : 0);
    sink->face(sink->host, &face);
    sink->polygons(sink->host, 1, &end, rims[top]);
  }
  epura_face face = face_of(EPURA_CYLINDER, 0);
  face.radius = radius;
  sink->face(sink->host, &face);
  for (uint32_t i = 0; i < SIDES; ++i) {
    const uint32_t next = (i + 1) % SIDES;
    const uint32_t side[4] = {i, next, SIDES + next, SIDES + i};
    sink->polygons(sink->host, 1, &side_end, side);
  }
}

/* A cubic Bezier curve over the cylinder: a wire, and the spline along which it runs. */
static void add_handle(const epura_sink* sink) {
  static const double poles[] = {0, -12, -2, 0, -12, 17, 0, 12, 17, 0, 12, -9}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  double parameters[SIDES + 1];
  uint32_t vertices[SIDES + 1];
  sink->shape(sink->host, "handle");
  for (uint32_t i = 0; i <= SIDES; ++i) {
    const double t = parameters[i] = (double)i / SIDES, s = 1 - t;
    const double shares[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    double point[3] = {0, 0, 0};
    for (int pole = 0; pole < 4; ++pole)
      for (int axis = 0; axis < 3; ++axis) point[axis] += shares[pole] * poles[3 * pole + axis];
    sink->points(sink->host, 1, point);
    vertices[i] = i;
  }
  epura_edge edge;
  memset(&edge, 0, sizeof edge);
  edge.size = sizeof edge;
  edge.kind = EPURA_WIRE;
  edge.count = SIDES + 1;
  edge.vertices = vertices;
  sink->edge(sink->host, &edge);
  epura_spline spline;
  memset(&spline, 0, sizeof spline);
  spline.size = sizeof spline;
  spline.degree = 3;
  spline.pole_count = 4;
  spline.poles = poles;
  spline.knots = knots;
  spline.parameters = parameters;
  sink->spline(sink->host, &spline);
}

/* The part of a cubic Bezier curve between two parameters, by its blossoms. */
static void write_part(const epura_hlr_spline* spline, double from, double to) {
  for (int pole = 0; pole < 4; ++pole) {
    double place[8];
    memcpy(place, spline->poles, sizeof place);
    for (int level = 0; level < 3; ++level) {
      const double t = level < pole ? to : from;
      for (int i = 0; i < 2 * (3 - level); ++i) place[i] = (1 - t) * place[i] + t * place[i + 2];
    }
    printf("%s%.4f,%.4f", pole == 0 ? "M" : pole == 1 ? "C" : " ", place[0], -place[1]);
  }
}

static void write_curve(const epura_hlr_result* result, const epura_hlr_curve* curve) {
  const char* look = curve->visible ? "0.2\"" : "0.1\" stroke-dasharray=\"1 0.5\"";
  if (curve->type == EPURA_HLR_SPLINE) {
    printf("<path fill=\"none\" stroke=\"black\" stroke-width=\"%s d=\"", look);
    write_part(curve->spline, curve->from, curve->to);
    printf("\"/>\n");
    return;
  }
  printf("<polyline fill=\"none\" stroke=\"black\" stroke-width=\"%s points=\"", look);
  for (uint64_t i = curve->first; i < curve->first + curve->count; ++i)
    printf("%.4f,%.4f ", result->points[2 * i], -result->points[2 * i + 1]);
  printf("\"/>\n");
}

int main(void) {
  epura_hlr_error error;
  memset(&error, 0, sizeof error);
  error.size = sizeof error;
  epura_hlr_model* model = epura_hlr_model_new(EPURA_HLR_VERSION);
  epura_hlr_drawing* drawing = NULL;
  if (model != NULL) {
    const epura_sink* sink = epura_hlr_sink(model);
    add_plate(sink);
    add_cylinder(sink, 5, 9);
    add_handle(sink);
    const double s = sqrt(0.5), t = sqrt(1.0 / 6);
    const double isometric[16] = {s, s, 0, 0, -t, t, 2 * t, 0, 1, -1, 1, 0, 0, 0, 0, 1};
    epura_hlr_request request;
    memset(&request, 0, sizeof request);
    request.size = sizeof request;
    request.matrix = isometric;
    request.all_types = 1;
    if (epura_hlr_finish(model, NULL, &error) == EPURA_HLR_DONE) drawing = epura_hlr_draw(model, &request, &error);
  }
  if (drawing == NULL) {
    fprintf(stderr, "%s: %s\n%s\n", error.place, error.reason, error.remedy);
    return 1;
  }
  const epura_hlr_result* result = epura_hlr_result_of(drawing);
  printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-12 -18 24 30\">\n");
  for (uint64_t i = 0; i < result->curve_count; ++i)
    write_curve(result, (const epura_hlr_curve*)((const char*)result->curves + i * result->curve_size));
  printf("</svg>\n");
  epura_hlr_drawing_free(drawing);
  epura_hlr_model_free(model);
  return 0;
}
