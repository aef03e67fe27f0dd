/* SPDX-License-Identifier: Apache-2.0 */
/* Hidden-line removal in memory: shapes and a projection in, curves out. Plain C; link libepura-hlr.
 *
 *   epura_hlr_model* model = epura_hlr_model_new(EPURA_HLR_VERSION);
 *   const epura_sink* sink = epura_hlr_sink(model);
 *   sink->shape(sink->host, "part"); sink->points(...); sink->face(...); sink->polygons(...); sink->edge(...);
 *   epura_hlr_error error = {sizeof error};
 *   if (epura_hlr_finish(model, NULL, &error)) ...
 *   epura_hlr_request request = {sizeof request};
 *   request.matrix = matrix;
 *   epura_hlr_drawing* drawing = epura_hlr_draw(model, &request, &error);
 *   const epura_hlr_result* result = epura_hlr_result_of(drawing);
 *   ...
 *   epura_hlr_drawing_free(drawing);
 *   epura_hlr_model_free(model);
 *
 * Nothing is read from files, printed or written, and no process is started. A model is filled by one thread; once it
 * is finished, any number of threads may draw it at once. Structures are only ever extended at the end: each contains
 * its size, and only members known to both sides are used. Members of a request that are zero are not given.
 */
#ifndef EPURA_HLR_H
#define EPURA_HLR_H

#include <epura/importer_abi.h>
#include <epura/projection_abi.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EPURA_HLR_VERSION 1u

/* What calls return. */
enum {
  EPURA_HLR_DONE = 0,
  EPURA_HLR_INPUT = 2,   /* wrong input */
  EPURA_HLR_PLUGIN = 3,  /* the projection does not answer as it must */
  EPURA_HLR_BROKEN = 70, /* the fault is in epura */
  EPURA_HLR_STOPPED = 130
};

/* An error: what is wrong where, and the remedy if there is one. UTF-8; what does not fit is cut off. */
typedef struct epura_hlr_error {
  uint32_t size; /* sizeof(epura_hlr_error) */
  uint32_t code; /* EPURA_HLR_DONE if there is none */
  char place[128];
  char reason[512];
  char remedy[384];
} epura_hlr_error;

/* Shapes and their places. */
typedef struct epura_hlr_model epura_hlr_model;

/* EPURA_HLR_VERSION of the library. */
EPURA_EXPORT uint32_t epura_hlr_version(void);

/* An empty model; NULL if there is no memory, or if the library does not know this `version` of the interface. */
EPURA_EXPORT epura_hlr_model* epura_hlr_model_new(uint32_t version);

/* Takes back all memory of a model at once. Its drawings remain. May be NULL. */
EPURA_EXPORT void epura_hlr_model_free(epura_hlr_model* model);

/* The calls that fill a model, as those of an importer: shapes with points, faces, polygons, edges and their splines,
 * and nodes with places of shapes. `unit`, `up`, `colour`, `note`, `progress` and `requirement` have no effect: lengths
 * and axes are those of the points. A call returns 0; after a wrong one, all others and epura_hlr_finish fail, and so
 * do calls after that. Valid as long as the model. NULL for NULL. */
EPURA_EXPORT const epura_sink* epura_hlr_sink(epura_hlr_model* model);

/* Exact surfaces and edges, so that facets may be coarse: those of faces that are not planes are divided until they are
 * near enough. Both functions are called by the thread that calls epura_hlr_finish, with numbers of the calls of the
 * sink, from 0. For each of `count` points near a face or an edge of a shape, three numbers each, they give the nearest
 * one of its surface or curve. Anything but 0 is an error. Where faces meet at an angle, there must be an edge. */
typedef struct epura_hlr_exact {
  uint32_t size; /* sizeof(epura_hlr_exact) */
  uint32_t unused;
  void* host; /* the first argument of both */
  int (*face)(void* host, uint32_t shape, uint32_t face, uint64_t count, const double* points, double* nearest);
  int (*edge)(void* host, uint32_t shape, uint32_t edge, uint64_t count, const double* points, double* nearest);
  double tolerance; /* greatest distance of middles of facets and of their sides, units of the points */
} epura_hlr_exact;

typedef struct epura_hlr_settings {
  uint32_t size;    /* sizeof(epura_hlr_settings) */
  uint32_t is_mesh; /* not 0: faces are not recognised where none are declared */
  uint32_t threads; /* greatest number of threads; 0: all cores */
  uint32_t unused;
  const epura_hlr_exact* exact; /* may be NULL */
} epura_hlr_settings;

/* Checks the model and finds its edges; it can be drawn, but not changed, from now on. `settings` may be NULL. Returns
 * EPURA_HLR_DONE or the code of the error; `error` may be NULL. */
EPURA_EXPORT int epura_hlr_finish(epura_hlr_model* model, const epura_hlr_settings* settings, epura_hlr_error* error);

/* Kinds of lines, which may be added. Of lines that coincide, the first kind is drawn. */
enum {
  EPURA_HLR_CONTOUR = 1,      /* where a surface turns away from the viewer */
  EPURA_HLR_BOUNDARY = 2,     /* edge with one face */
  EPURA_HLR_CREASE = 4,       /* where faces meet at an angle */
  EPURA_HLR_INTERSECTION = 8, /* where faces pass through each other */
  EPURA_HLR_WIRE = 64,        /* line or point without faces */
  EPURA_HLR_TANGENT = 256,    /* where faces meet smoothly */
  EPURA_HLR_SMOOTH = 512,     /* all other edges of the mesh */
  EPURA_HLR_USUAL = 79        /* the first five */
};

/* What is drawn of a model. Exactly one of `view`, `matrix` and `projection` is given. */
typedef struct epura_hlr_request {
  uint32_t size;          /* sizeof(epura_hlr_request) */
  uint32_t kinds;         /* sum of the kinds of lines; 0: EPURA_HLR_USUAL */
  uint32_t only_visible;  /* not 0: hidden lines are left out */
  uint32_t threads;       /* greatest number of threads; 0: all cores */
  const epura_view* view; /* plane and projectors */
  const double* matrix;   /* 16 numbers, rows first: a column vector of the model is seen at (row 0 / row 3, row 1 /
                             row 3). Row 2 of a parallel projection grows towards the viewer; row 3 of a central one is
                             positive in front of him. Neither mirrors nor, if central, stretches the picture. */
  const epura_projection* projection; /* a row of a plugin, called in this process ... */
  const double* values;               /* ... with these values of its parameters; NULL: their defaults */
  double crease_angle; /* least angle of creases, degrees; 0: 5 between faces of the part, 30 between facets */
  double scale; /* mm of paper for a unit of the plane, which says what nobody sees; 0: the drawing is 1 m large */
  double join_within; /* mm of paper within which lines along each other are drawn once; 0: each is drawn */
  double arcs;        /* mm of paper within which arcs are drawn for chords; 0: only polylines */
  /* Called as stages proceed, with the fraction that is done, 0 if unknown; from any thread, never at once from two.
   * Anything but 0 stops the call, which then fails with EPURA_HLR_STOPPED. May be NULL. */
  int (*progress)(void* host, const char* stage, double done);
  void* host;           /* its first argument */
  uint32_t finds_error; /* not 0: epura_hlr_result::error is found, which takes time */
  uint32_t all_types;   /* not 0: curves may be of all types; 0: polylines, and ellipses if `arcs` is given */
} epura_hlr_request;

/* A face of the model. Numbers are those of the calls of the sink, from 0; EPURA_NONE: none. Without nodes, `node` is
 * that of the shape. */
typedef struct epura_hlr_face {
  uint32_t node, shape, face, body;
} epura_hlr_face;

/* What a curve is, or a part of. Only with `all_types`, a polyline of two points is a line, an ellipse whose axes are
 * equal a circle, and the picture of an edge with a spline this spline, unless poles are behind the viewer. */
enum { EPURA_HLR_POLYLINE = 0, EPURA_HLR_ELLIPSE = 1, EPURA_HLR_LINE = 2, EPURA_HLR_CIRCLE = 3, EPURA_HLR_SPLINE = 4 };

/* The picture of a spline, with the parameters of the edge. */
typedef struct epura_hlr_spline {
  uint32_t size; /* sizeof(epura_hlr_spline) of the library */
  uint32_t degree;
  uint64_t pole_count;
  const double* poles;   /* two numbers each */
  const double* weights; /* of the poles, positive; NULL: all are equal */
  const double* knots;   /* pole_count + degree + 1 numbers */
} epura_hlr_spline;

/* A line of one look and one source. */
typedef struct epura_hlr_curve {
  uint32_t type;                /* EPURA_HLR_POLYLINE ... */
  uint32_t kind;                /* EPURA_HLR_CONTOUR ... */
  uint32_t visible;             /* 0: hidden */
  uint32_t edge;                /* number of the edge of faces[0].shape, from 0 in the order of calls; EPURA_NONE */
  epura_hlr_face faces[2];      /* that meet in it, cross in it, or of which it is a contour or boundary (the first) */
  uint64_t first, count;        /* its points; of an arc or a spline, points on it */
  double centre[2], u[2], v[2]; /* of an arc: centre + cos(a) u + sin(a) v ... */
  double from, to; /* ... for a between these, radians; of a spline, parameters of its first and last point */
  const epura_hlr_spline* spline; /* of a spline, which several curves may share; else NULL */
} epura_hlr_curve;

typedef struct epura_hlr_result {
  uint32_t size;       /* sizeof(epura_hlr_result) of the library */
  uint32_t curve_size; /* sizeof(epura_hlr_curve) of the library: curves are that many bytes apart */
  uint64_t curve_count;
  const epura_hlr_curve* curves;
  uint64_t point_count;
  const double* points; /* two numbers each, in the plane: those of the matrix, or the window of the view */
  double matrix[16];    /* rows first: model -> plane; row 2 / row 3 grows towards the viewer */
  double error;         /* bound of how far lines are from those of the part, plane units; NaN: not found */
} epura_hlr_result;

/* The curves of a view. */
typedef struct epura_hlr_drawing epura_hlr_drawing;

/* Draws a finished model. NULL: `error` says why; it may be NULL. */
EPURA_EXPORT epura_hlr_drawing* epura_hlr_draw(const epura_hlr_model* model, const epura_hlr_request* request,
                                               epura_hlr_error* error);

/* Valid until the drawing is freed. NULL for NULL. */
EPURA_EXPORT const epura_hlr_result* epura_hlr_result_of(const epura_hlr_drawing* drawing);

/* Takes back all memory of a drawing at once. May be NULL. */
EPURA_EXPORT void epura_hlr_drawing_free(epura_hlr_drawing* drawing);

#ifdef __cplusplus
}
#endif

#endif
