/* SPDX-License-Identifier: Apache-2.0 */
/* The interface between epura and an importer: a shared library that reads model files. Plain C.
 *
 * An importer exports one function, epura_importers_v1. Structures are only ever extended at the end: each contains its
 * size, and only members known to both sides are used. Nothing is allocated on one side and freed on the other; data
 * passed to the host are copied before the call returns. An importer runs in a separate process: if that process fails,
 * the program reports an error.
 *
 * The content of a file is passed to a sink: shapes (points, faces with polygons, edges of the part, wires), and a tree
 * of nodes with the positions of the shapes. A shape may occur several times.
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
  uint32_t kind; /* kind of its surface */
  double origin[3];
  double axis[3]; /* of any length */
  double radius, minor, slope;
} epura_face;

/* How coordinates of a file are rounded. */
enum {
  EPURA_SINGLE = 1, /* to 32-bit floats */
  EPURA_PRINTED = 2 /* written as text, hence possibly rounded to decimals */
};

/* How two faces meet in an edge of the part. */
enum {
  EPURA_SHARP = 0,   /* at an angle */
  EPURA_TANGENT = 1, /* smoothly */
  EPURA_WIRE = 2,    /* no faces meet: a separate line, such as one of a sketch */
  EPURA_POINT = 3    /* a separate point, which is drawn as a cross */
};

/* An edge of the part between two faces, a wire, or a point. A seam, where a face meets itself, is not an edge. */
typedef struct epura_edge {
  uint32_t size;            /* sizeof(epura_edge) */
  uint32_t kind;            /* one of these numbers */
  double angle;             /* degrees between the normals of the faces; NaN: unknown, or a wire */
  uint64_t count;           /* number of points along it, at least two; 1 for EPURA_POINT */
  const uint32_t* vertices; /* numbers of points of the shape; a closed edge repeats the first one at its end */
} epura_edge;

/* The B-spline along which an edge or a wire runs: rational if it has weights, never periodic. */
typedef struct epura_spline {
  uint32_t size;            /* sizeof(epura_spline) */
  uint32_t degree;          /* 1 to 25 */
  uint64_t pole_count;      /* more than the degree */
  const double* poles;      /* three numbers each */
  const double* weights;    /* of the poles, positive; NULL: all are 1 */
  const double* knots;      /* pole_count + degree + 1 numbers that do not fall, each as often as it counts */
  const double* parameters; /* of the points of the edge on it; all rise, or all fall */
} epura_spline;

/* A node of the tree. */
typedef struct epura_node {
  uint32_t size;        /* sizeof(epura_node) */
  uint32_t parent;      /* number of an earlier node, from 0 in the order of calls; EPURA_NONE: none */
  uint32_t shape;       /* number of a shape, from 0 in the order of calls; EPURA_NONE: no shape */
  uint32_t unused;      /* 0 */
  const char* name;     /* UTF-8; may be NULL */
  double transform[12]; /* rows of the 3x4 matrix that maps points of the node to its parent */
} epura_node;

/* What a requirement is. */
enum {
  EPURA_DIMENSION = 0,      /* a size, distance or angle */
  EPURA_TOLERANCE = 1,      /* a geometric tolerance */
  EPURA_DATUM = 2,          /* a datum, or a target of one */
  EPURA_NOTE = 3,           /* a text of its faces, or without faces of the whole part */
  EPURA_SURFACE_TEXTURE = 4 /* of its faces, or without faces of the whole part */
};

/* What `lower` and `upper` of a requirement are. */
enum {
  EPURA_NO_BOUNDS = 0,
  EPURA_DEVIATIONS = 1, /* from the value */
  EPURA_LIMITS = 2      /* values themselves */
};

/* What the file requires of the part: product and manufacturing information with a meaning, not its picture. Texts are
 * UTF-8, or NULL: the file does not say. Lengths are in millimetres, angles in degrees, whatever unit coordinates have;
 * NaN: none. */
typedef struct epura_requirement {
  uint32_t size;         /* sizeof(epura_requirement) */
  uint32_t kind;         /* one of the numbers above */
  const char* id;        /* the same whenever the file is read, as "#120"; no other requirement has it */
  const char* type;      /* words: "diameter", "linear distance", "position", "surface profile", "datum target" */
  const char* name;      /* by which the file calls it */
  double value;          /* of the dimension, or width or diameter of the tolerance zone */
  double lower, upper;   /* see `bounds` */
  uint32_t bounds;       /* EPURA_NO_BOUNDS, EPURA_DEVIATIONS or EPURA_LIMITS */
  uint32_t is_angle;     /* not 0: the value is an angle */
  double unit;           /* in which the file states the value: millimetres or degrees; 0: not known */
  int32_t decimals;      /* that the value has in this unit; -1: the file does not say */
  uint32_t face_count;   /* number of faces that it belongs to */
  const uint32_t* faces; /* two numbers for each: that of a shape, and that of a face in it, from 0 in order of calls */
  const char* fit;       /* "H7" */
  const char* modifiers; /* words with ", " between: "maximum material requirement", "theoretical", "all around",
                            "projected 10 mm"; of a texture, "material removal required" or "... prohibited",
                            "made by grinding" */
  const char* zone;      /* shape of the tolerance zone or datum target: "cylindrical or circular" */
  const char* datums;  /* of a datum: its letter; of a tolerance, in order: "A | B-C (maximum material requirement)" */
  const char* above;   /* the id of the tolerance below whose frame this one stands: a composite tolerance */
  const char* missing; /* what of it could not be read, as "a value, its characteristic" */
  const char* text;    /* of a note; of a texture, its parameters with "; " between: "Ra 3.2", in micrometres */
  /* Coordinates of what follows are those of the shape of its first face. */
  uint64_t line_count; /* number of lines of a dimension between lines on faces */
  const double* lines; /* six numbers each: the ends */
  const double* area;  /* of a datum target, nine numbers: its middle, and from there the vectors to the ends of its
                          length and its width; those of a point are zero, the width of a line is. NULL: not known */
} epura_requirement;

/* A view that the file has stored: a camera, and planes that cut what it shows. Coordinates are those of nodes without
 * a parent. */
typedef struct epura_saved_view {
  uint32_t size;        /* sizeof(epura_saved_view) */
  uint32_t is_central;  /* not 0: rays meet where the viewer stands; 0: they are parallel */
  const char* name;     /* UTF-8; no other view has it */
  double eye[3];        /* where the viewer stands; matters only if rays meet there */
  double towards[3];    /* from the models towards the viewer; of any length but 0 */
  double up[3];         /* what is upwards in the picture; not along `towards` */
  uint64_t plane_count; /* number of planes that cut the models */
  const double* planes; /* six numbers each: a point and a normal */
} epura_saved_view;

/* The functions that the importer calls. Each returns 0, or another number if the host stops the reading: the content
 * is too large or inconsistent, or the run was cancelled. The importer must then return at once; the sentence that it
 * returns is ignored. */
typedef struct epura_sink {
  uint32_t size; /* sizeof(epura_sink) */
  uint32_t unused;
  void* host; /* the first argument of every call */
  /* The unit of length of the file in millimetres. If not called, the file states none: a user may, or it is 1. */
  int (*unit)(void* host, double millimetres);
  /* The axis of the file that points up: 'y' or 'z'; 'z' if not called. */
  int (*up)(void* host, char axis);
  /* Begins a shape, to which everything up to the next shape belongs. */
  int (*shape)(void* host, const char* name);
  /* Begins a body of the shape, to which everything up to the next body belongs. */
  int (*body)(void* host, const char* name);
  /* Adds points, three numbers each. */
  int (*points)(void* host, uint64_t count, const double* xyz);
  int (*face)(void* host, const epura_face* face);
  /* Adds polygons to the last face; before the first face they belong to none. `corners` are the numbers of points,
   * counterclockwise as seen from outside, of one polygon after the other; `ends` are the polygons' ends in it. */
  int (*polygons)(void* host, uint64_t count, const uint64_t* ends, const uint32_t* corners);
  int (*edge)(void* host, const epura_edge* edge);
  /* Without any node, each shape occurs once, untransformed. */
  int (*node)(void* host, const epura_node* node);
  /* A sentence for the user about repairs or omissions. */
  int (*note)(void* host, const char* sentence);
  /* The fraction of the work that is done, from 0 to 1. Should be called a few times a second if this is easy. */
  int (*progress)(void* host, double done);
  /* How points are rounded: the sum of the values that apply; not rounded if not called. */
  int (*rounding)(void* host, uint32_t kinds);
  /* The colour of what began last: a node, a body, or a shape and those of its bodies that have none. That of a node
   * takes precedence over all below it. sRGB, each from 0 to 1. */
  int (*colour)(void* host, double red, double green, double blue);
  /* The distance between neighbouring values of coordinates of the current shape, in its own units: of a mesh that is
   * quantised to integers, or printed with few decimals. The greatest one counts. If it is not called, the coordinates
   * themselves tell. */
  int (*step)(void* host, double distance);
  /* What the file requires of the part, after the shapes whose faces it names. Optional on both sides: epura 0.2 and
   * earlier have no such function, which `size` tells. */
  int (*requirement)(void* host, const epura_requirement* requirement);
  /* A view that the file has stored. Optional on both sides, as `requirement`. */
  int (*saved_view)(void* host, const epura_saved_view* view);
  /* By which dimensions and tolerances are to be understood: "ASME Y14.5-2018". Optional, likewise. */
  int (*standard)(void* host, const char* name);
  /* The curve of the edge or wire that was handed over last. Optional, likewise; NULL: the host has no use for it. */
  int (*spline)(void* host, const epura_spline* spline);
} epura_sink;

/* The file to read, and the required precision. */
typedef struct epura_source {
  uint32_t size;             /* sizeof(epura_source) */
  uint32_t threads;          /* greatest number of threads; at least 1 */
  const char* path;          /* path of the file; if it is in memory, that of a nameless one */
  const double* values;      /* values of the parameters in the order of the table, vectors flattened */
  double tolerance;          /* permitted deviation from curved surfaces, mm; 0: no bound */
  double relative_tolerance; /* the same as a fraction of the diagonal of the model's box; 0: no bound */
  uint32_t may_leave;        /* not 0: the file may refer to files outside its folder */
  uint32_t unused;
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
  /* Whether the importer recognises a file by its first bytes, at most 4096; NULL: its files have no signature. */
  int (*recognises)(const unsigned char* bytes, uint64_t count);
  /* Returns NULL on success, otherwise a sentence that states the error and its location in the file; it must remain
   * valid until the next call. Must not throw exceptions. */
  const char* (*read)(const epura_source* source, const epura_sink* sink);
} epura_importer;

typedef struct epura_importer_list {
  uint32_t abi;  /* EPURA_IMPORTER_ABI_VERSION; read before anything else */
  uint32_t size; /* sizeof(epura_importer_list) */
  uint64_t count;
  const epura_importer* importers; /* `count` rows, each importers[0].size bytes apart */
} epura_importer_list;

/* The only symbol of an importer, and its type for callers that look it up. */
#define EPURA_IMPORTER_ENTRY_POINT "epura_importers_v1"
EPURA_EXPORT const epura_importer_list* epura_importers_v1(void);
typedef const epura_importer_list* (*epura_importer_entry_point)(void);

#ifdef __cplusplus
}
#endif

#endif
