/* SPDX-License-Identifier: Apache-2.0 */
/* The contract between epura and an importer: a shared library that reads files of models. Plain C.
 *
 * An importer exports one function, epura_importers_v1. Structures are only ever appended to: each carries its size,
 * and the reader uses what both sides know. Nothing is allocated on one side and freed on the other; what is handed to
 * the host is copied before the call returns. An importer runs in a process of its own: what it does there to the
 * process reaches the program as an error.
 *
 * What a file holds is handed over through a sink: shapes (points, faces of polygons, edges of the part, wires), and a
 * tree of nodes that says where shapes stand, as often as they do.
 */
#ifndef EPURA_IMPORTER_ABI_H
#define EPURA_IMPORTER_ABI_H

#include <epura/parameter_abi.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EPURA_IMPORTER_ABI_VERSION 1u

/* No shape, no parent, no face. */
#define EPURA_NONE UINT32_MAX

/* Surfaces of faces of a part. */
enum {
  EPURA_FREE_FORM = 0, /* any other surface */
  EPURA_PLANE = 1,     /* origin, axis: its normal */
  EPURA_CYLINDER = 2,  /* origin, axis, radius */
  EPURA_CONE = 3,      /* origin, axis, radius at the origin, slope: growth of the radius for a unit along the axis */
  EPURA_SPHERE = 4,    /* origin: its centre, radius */
  EPURA_TORUS = 5      /* origin: its centre, axis, radius of the circle, minor: radius of the tube */
};

/* A face of the part: the polygons that follow, up to the next face, belong to it. */
typedef struct epura_face {
  uint32_t size; /* sizeof(epura_face) */
  uint32_t kind; /* of its surface */
  double origin[3];
  double axis[3]; /* of any length */
  double radius, minor, slope;
} epura_face;

/* How coordinates of a file are rounded. */
enum {
  EPURA_SINGLE = 1, /* to 32 bits */
  EPURA_PRINTED = 2 /* they were written as text, so perhaps to some decimals */
};

/* How two faces meet in an edge of the part. */
enum {
  EPURA_SHARP = 0,   /* at an angle */
  EPURA_TANGENT = 1, /* without one */
  EPURA_WIRE = 2     /* no faces meet: a line of its own, such as one of a sketch */
};

/* An edge of the part between two faces, or a wire. Seams, where one face meets itself, are none. */
typedef struct epura_edge {
  uint32_t size;            /* sizeof(epura_edge) */
  uint32_t kind;            /* EPURA_SHARP, EPURA_TANGENT or EPURA_WIRE */
  double angle;             /* degrees between the normals of the faces; NaN: not known, or a wire */
  uint64_t count;           /* of points along it, at least two */
  const uint32_t* vertices; /* numbers of points of the shape; the first one again at the end of a closed edge */
} epura_edge;

/* A place in the tree. */
typedef struct epura_node {
  uint32_t size;        /* sizeof(epura_node) */
  uint32_t parent;      /* number of an earlier node, from 0 in the order of calls; EPURA_NONE: none */
  uint32_t shape;       /* number of a shape, from 0 in the order of calls; EPURA_NONE: none stands here */
  uint32_t unused;      /* 0 */
  const char* name;     /* UTF-8; may be NULL */
  double transform[12]; /* rows of the 3x4 matrix that takes a point of the node to its parent */
} epura_node;

/* What the importer calls. Every function returns 0; or another number where the host wants no more: the file holds too
 * much, the data contradict themselves, or the run was cancelled. The importer then returns at once, with whatever
 * sentence. */
typedef struct epura_sink {
  uint32_t size; /* sizeof(epura_sink) */
  uint32_t unused;
  void* host; /* the first argument of every call */
  /* Millimetres of a unit of length of the file; 1 unless told. */
  int (*unit)(void* host, double millimetres);
  /* The axis of the file that points up: 'y' or 'z', which it is unless told. */
  int (*up)(void* host, char axis);
  /* What follows, up to the next shape, belongs to a new one. */
  int (*shape)(void* host, const char* name);
  /* What follows, up to the next one, belongs to a body of the shape. */
  int (*body)(void* host, const char* name);
  /* Adds points, three numbers each. */
  int (*points)(void* host, uint64_t count, const double* xyz);
  int (*face)(void* host, const epura_face* face);
  /* Adds polygons to the face, or to none before the first one: `corners` are numbers of points, counterclockwise as
   * seen from outside, of one polygon after the other; `ends` says where each ends in it. */
  int (*polygons)(void* host, uint64_t count, const uint64_t* ends, const uint32_t* corners);
  int (*edge)(void* host, const epura_edge* edge);
  /* Without any node each shape stands once, as it is. */
  int (*node)(void* host, const epura_node* node);
  /* A sentence for the user: what was repaired or left out. */
  int (*note)(void* host, const char* sentence);
  /* How much of the work is done, from 0 to 1. To be called a few times a second where that is easy. */
  int (*progress)(void* host, double done);
  /* How points are rounded: the sum of what holds; not at all unless told. */
  int (*rounding)(void* host, uint32_t kinds);
} epura_sink;

/* What is to be read, and how precisely. */
typedef struct epura_source {
  uint32_t size;             /* sizeof(epura_source) */
  uint32_t threads;          /* that may be used; at least 1 */
  const char* path;          /* of the file */
  const double* values;      /* of the parameters in the order of the table, vectors flattened */
  double tolerance;          /* mm that curved surfaces may be off by; 0: no bound */
  double relative_tolerance; /* the same in parts of the diagonal of the box of everything; 0: no bound */
} epura_source;

/* One importer. */
typedef struct epura_importer {
  uint32_t size;                     /* sizeof(epura_importer) */
  uint32_t unused;                   /* 0 */
  const char* name;                  /* lower case, digits and '-' */
  const char* summary;               /* one line */
  const char* extensions;            /* "step|stp": lower case, without dots */
  const epura_parameter* parameters; /* rows parameters[0].size bytes apart */
  uint64_t parameter_count;
  /* Whether the file begins as its files do; NULL: files have no mark of their own. `count` is 4096 at most. */
  int (*recognises)(const unsigned char* bytes, uint64_t count);
  /* Returns NULL when done, otherwise a sentence that says what is wrong and where in the file; it stays valid until
   * the next call. No exception may leave it. */
  const char* (*read)(const epura_source* source, const epura_sink* sink);
} epura_importer;

typedef struct epura_importer_list {
  uint32_t abi;  /* EPURA_IMPORTER_ABI_VERSION; read before anything else */
  uint32_t size; /* sizeof(epura_importer_list) */
  uint64_t count;
  const epura_importer* importers; /* `count` rows, each importers[0].size bytes apart */
} epura_importer_list;

/* The one symbol of an importer, and its type for whoever looks it up. */
#define EPURA_IMPORTER_ENTRY_POINT "epura_importers_v1"
EPURA_EXPORT const epura_importer_list* epura_importers_v1(void);
typedef const epura_importer_list* (*epura_importer_entry_point)(void);

#ifdef __cplusplus
}
#endif

#endif
