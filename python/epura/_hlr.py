# SPDX-License-Identifier: Apache-2.0
"""Hidden-line removal in memory: a shape and a projection in, curves as arrays out. By the plain C functions of hlr.h."""

from __future__ import annotations

import ctypes as c
import functools
import importlib
import io
import math
import os
from pathlib import Path
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from . import _core, _importers  # loads the library beside which that of hlr.h is
from ._errors import Error, InputError, made
from ._models import Model, _geometry, _shape_in

_VERSION = 1
_NONE = 2**32 - 1
#: The kinds of lines by their numbers in hlr.h.
_KINDS = {"contour": 1, "boundary": 2, "crease": 4, "intersection": 8, "wire": 64, "tangent": 256, "smooth": 512}
_USUAL = ("contour", "boundary", "crease", "intersection", "wire")
_NAMES = {number: name for name, number in _KINDS.items()}
#: The types of curves by their numbers in hlr.h.
_TYPES = ("polyline", "ellipse", "line", "circle", "spline")


class _Sink(c.Structure):
    _fields_ = [("size", c.c_uint32), ("unused", c.c_uint32), ("host", c.c_void_p),
                ("unit", c.c_void_p), ("up", c.c_void_p),
                ("shape", c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_char_p)), ("body", c.c_void_p),
                ("points", c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_uint64, c.c_void_p)), ("face", c.c_void_p),
                ("polygons", c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_uint64, c.c_void_p, c.c_void_p)),
                ("edge", c.c_void_p), ("node", c.c_void_p), ("note", c.c_void_p), ("progress", c.c_void_p),
                ("rounding", c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_uint32))]


class _Error(c.Structure):
    _fields_ = [("size", c.c_uint32), ("code", c.c_uint32), ("place", c.c_char * 128), ("reason", c.c_char * 512),
                ("remedy", c.c_char * 384)]


class _Settings(c.Structure):
    _fields_ = [(name, c.c_uint32) for name in ("size", "is_mesh", "threads", "unused")]


class _View(c.Structure):
    _fields_ = [("size", c.c_uint32), ("projectors", c.c_uint32), ("point", c.c_double * 3), ("normal", c.c_double * 3),
                ("up", c.c_double * 3), ("projector", c.c_double * 3), ("scale", c.c_double), ("window", c.c_double * 4),
                ("front", c.c_double), ("back", c.c_double)]


_Progress = c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_char_p, c.c_double)


class _Request(c.Structure):
    _fields_ = [("size", c.c_uint32), ("kinds", c.c_uint32), ("only_visible", c.c_uint32), ("threads", c.c_uint32),
                ("view", c.POINTER(_View)), ("matrix", c.c_void_p), ("projection", c.c_void_p), ("values", c.c_void_p),
                ("crease_angle", c.c_double), ("scale", c.c_double), ("join_within", c.c_double), ("arcs", c.c_double),
                ("progress", _Progress), ("host", c.c_void_p), ("finds_error", c.c_uint32),
                ("all_types", c.c_uint32)]


class _Face(c.Structure):
    _fields_ = [(name, c.c_uint32) for name in ("node", "shape", "face", "body")]


class _Spline(c.Structure):
    _fields_ = [("size", c.c_uint32), ("degree", c.c_uint32), ("pole_count", c.c_uint64), ("poles", c.POINTER(c.c_double)),
                ("weights", c.POINTER(c.c_double)), ("knots", c.POINTER(c.c_double))]


class _Curve(c.Structure):
    _fields_ = [("type", c.c_uint32), ("kind", c.c_uint32), ("visible", c.c_uint32), ("edge", c.c_uint32),
                ("faces", _Face * 2), ("first", c.c_uint64), ("count", c.c_uint64), ("centre", c.c_double * 2),
                ("u", c.c_double * 2), ("v", c.c_double * 2), ("start", c.c_double), ("end", c.c_double), ("spline", c.POINTER(_Spline))]


class _Result(c.Structure):
    _fields_ = [("size", c.c_uint32), ("curve_size", c.c_uint32), ("curve_count", c.c_uint64), ("curves", c.c_void_p),
                ("point_count", c.c_uint64), ("points", c.POINTER(c.c_double)), ("matrix", c.c_double * 16),
                ("error", c.c_double)]


@functools.lru_cache(maxsize=None)
def _folder() -> Path:
    return next(Path(line.split()[-1]).parent for line in Path("/proc/self/maps").read_text().splitlines()
                if "/libepura.so." in line)


@functools.lru_cache(maxsize=None)
def _library() -> c.CDLL:
    library = c.CDLL(str(_folder() / "libepura-hlr.so.1"))
    library.epura_hlr_model_new.restype = c.c_void_p
    library.epura_hlr_sink.restype = c.POINTER(_Sink)
    library.epura_hlr_draw.restype = c.c_void_p
    library.epura_hlr_result_of.restype = c.POINTER(_Result)
    for name, arguments in {"model_new": [c.c_uint32], "model_free": [c.c_void_p], "sink": [c.c_void_p],
                            "finish": [c.c_void_p, c.POINTER(_Settings), c.POINTER(_Error)],
                            "draw": [c.c_void_p, c.POINTER(_Request), c.POINTER(_Error)],
                            "result_of": [c.c_void_p], "drawing_free": [c.c_void_p]}.items():
        getattr(library, f"epura_hlr_{name}").argtypes = arguments
    return library


class EdgeArc(NamedTuple):
    """centre + cos(a) u + sin(a) v for a between `start` and `end`, radians; u and v are perpendicular."""

    centre: Tuple[float, float]
    u: Tuple[float, float]
    v: Tuple[float, float]
    start: float
    end: float


class EdgeSpline(NamedTuple):
    """A part of a B-spline, from the parameter `start` to `end`: `poles` (n, 2), their `weights` (n), and n + degree + 1
    `knots`."""

    degree: int
    poles: np.ndarray
    weights: np.ndarray
    knots: np.ndarray
    start: float
    end: float


class Curve(NamedTuple):
    """A line of one look and one source: `points` (n, 2) in units of the model, y up; of an `arc` or a `spline`, points
    on it. `type`: "polyline", "line", "circle" or "ellipse" (those have an `arc`), or "spline".

    `kind`: "contour", "boundary", "crease", "intersection", "wire", "tangent" or "smooth". Where the shape has faces
    and edges of its own: `edge` is the number of the edge, or wire, and `faces` those of the faces that meet in the
    line, each from 0 in the order of the shape; None and (): none.
    """

    points: np.ndarray
    kind: str
    visible: bool
    arc: Optional[EdgeArc]
    edge: Optional[int] = None
    faces: Tuple[int, ...] = ()
    type: str = "polyline"
    spline: Optional[EdgeSpline] = None


class Curves(NamedTuple):
    """The curves of a view, and the matrix (4, 4) from the model to its plane, for points as columns."""

    curves: List[Curve]
    matrix: np.ndarray

    @property
    def visible(self) -> List[np.ndarray]:
        """The points of the visible curves."""
        return [curve.points for curve in self.curves if curve.visible]

    @property
    def hidden(self) -> List[np.ndarray]:
        """The points of the hidden curves."""
        return [curve.points for curve in self.curves if not curve.visible]


def _raise(error: _Error) -> None:
    place, reason, remedy = (text.decode("utf-8", "replace") for text in (error.place, error.reason, error.remedy))
    raise made(error.code, place, f"{place}: {reason}" if place else reason, remedy)


def _vector(value: Sequence[float], place: str) -> Any:
    try:
        x, y, z = (float(number) for number in value)
    except (TypeError, ValueError):
        raise InputError(f"{place}: is {value!r}", place, "give three numbers") from None
    return (c.c_double * 3)(x, y, z)


def _view(direction: Sequence[float], up: Sequence[float], eye: Optional[Sequence[float]],
          target: Sequence[float]) -> _View:
    view = _View(size=c.sizeof(_View), scale=1, front=math.inf, back=-math.inf, up=_vector(up, "up"))
    view.point = _vector(target, "target")
    if eye is None:
        view.normal = view.projector = _vector(direction, "direction")
        return view
    view.projectors = 1
    view.projector = _vector(eye, "eye")
    view.normal = _vector([a - b for a, b in zip(view.projector, view.point)], "eye")
    return view


def _address_of(shape: Any) -> Optional[int]:
    """Of a TopoDS_Shape: a number, or an object of SWIG, as pythonocc has them. None: the shape is something else."""
    if isinstance(shape, int):
        return shape
    wrapped: Any = getattr(shape, "this", None)
    return int(wrapped) if type(wrapped).__name__ == "SwigPyObject" else None


def _brep_of(shape: Any) -> Optional[bytes]:
    """The text of Open CASCADE for shapes of FreeCAD, and those that OCP wraps, as CadQuery and build123d have them."""
    if callable(getattr(shape, "exportBrepToString", None)):
        return shape.exportBrepToString().encode()  # type: ignore[no-any-return]
    shape = _shape_in(shape)
    shape = getattr(shape, "wrapped", shape)
    if not type(shape).__module__.startswith("OCP."):
        return None
    text = io.BytesIO()
    importlib.import_module("OCP.BRepTools").BRepTools.Write_s(shape, text)
    return text.getvalue()


def _fill(sink: _Sink, shape: Any, faces: Any, form: Optional[str], tolerance: float) -> None:
    importers = _folder() / "epura" / "importers"
    if faces is None and isinstance(shape, (str, os.PathLike)):
        path = os.fspath(shape)
        return _importers.read(importers, path, form or Path(path).suffix[1:].lower(), tolerance, sink)
    if faces is None and isinstance(shape, (bytes, bytearray, memoryview)):
        if not form:
            raise InputError("format: is missing", "format", 'bytes need one: format="glb"')
        return _importers.read_bytes(importers, bytes(shape), form, tolerance, sink)
    if faces is None and (address := _address_of(shape)) is not None:
        return _importers.read_address(importers, address, tolerance, sink)
    if faces is None and _importers.has_importer(importers, "brep") and (text := _brep_of(shape)) is not None:
        return _importers.read_bytes(importers, text, "brep", tolerance, sink)
    geometry = _geometry(Model(shape, faces, tolerance=tolerance or None), "shape")
    points: np.ndarray = geometry["points"]
    sink.shape(sink.host, b"shape")
    if geometry["single_precision"]:
        sink.rounding(sink.host, 1)
    sink.points(sink.host, len(points), points.ctypes.data)
    for array in geometry["faces"]:
        corners = np.ascontiguousarray(array, dtype=np.uint32)
        ends = np.arange(1, len(corners) + 1, dtype=np.uint64) * corners.shape[1]
        sink.polygons(sink.host, len(ends), ends.ctypes.data, corners.ctypes.data)


def _number_of(kinds: Sequence[str]) -> int:
    for kind in kinds:
        if kind not in _KINDS:
            raise InputError(f"kinds: there is no kind {kind!r}", "kinds", "known: " + ", ".join(_KINDS))
    return sum(_KINDS[kind] for kind in set(kinds))


def _pair(numbers: Any) -> Tuple[float, float]:
    return numbers[0], numbers[1]


def _array(numbers: Any, *shape: int) -> np.ndarray:
    return np.ctypeslib.as_array(numbers, shape).copy()


def _spline(curve: _Curve) -> Optional[EdgeSpline]:
    if not curve.spline:
        return None
    spline = curve.spline.contents
    count, degree = spline.pole_count, spline.degree
    weights = _array(spline.weights, count) if spline.weights else np.ones(count)
    return EdgeSpline(degree, _array(spline.poles, count, 2), weights, _array(spline.knots, count + degree + 1),
                      curve.start, curve.end)


def _curves(library: c.CDLL, drawing: c.c_void_p) -> Curves:
    result = library.epura_hlr_result_of(drawing).contents
    points = _array(result.points, result.point_count, 2) if result.point_count else np.empty((0, 2))
    curves = []
    for i in range(result.curve_count):
        curve = _Curve.from_address(result.curves + i * result.curve_size)
        kind = _TYPES[curve.type]
        arc = (EdgeArc(_pair(curve.centre), _pair(curve.u), _pair(curve.v), curve.start, curve.end)
               if kind in ("ellipse", "circle") else None)
        faces = tuple(face.face for face in curve.faces if face.face != _NONE)
        curves.append(Curve(points[curve.first:curve.first + curve.count], _NAMES[curve.kind], bool(curve.visible), arc,
                            None if curve.edge == _NONE else curve.edge, faces, kind, _spline(curve)))
    return Curves(curves, np.array(result.matrix).reshape(4, 4))


def hlr(shape: Any, faces: Any = None, *, direction: Sequence[float] = (1, -1, 1), up: Sequence[float] = (0, 0, 1),
        eye: Optional[Sequence[float]] = None, target: Sequence[float] = (0, 0, 0), matrix: Any = None,
        kinds: Sequence[str] = _USUAL, hidden: bool = True, surfaces: str = "auto", arcs: float = 0,
        crease_angle: float = 0, scale: float = 0, join_within: float = 0, threads: int = 0,
        format: Optional[str] = None, tolerance: float = 0) -> Curves:
    """The visible and hidden curves of a shape, without a sheet: nothing is written, and no process is started.

    `shape`: vertices (n, 3) with `faces`, or an object of trimesh, meshio, CadQuery, build123d or FreeCAD, as for
    `Model`; a TopoDS_Shape of OCP or pythonocc, or the address of one in this process, which must be of the library of
    Open CASCADE that the importer uses. Or a file that an importer reads (glTF, STEP, BREP ...), or its bytes with its `format`, in the unit and the
    axes of the file; importers run in this process. `tolerance`: of facets, in mm; 0: 1/20000 of the size. Parallel projection along `direction`, which points to the viewer, onto the plane through `target`; or from
    `eye` onto the plane through `target` that is perpendicular to the line between both. `up` points up the page.
    `matrix` (4, 4) instead of all these: a point as a column is seen at rows 0 and 1 over row 3; row 2 of a parallel
    projection grows towards the viewer, row 3 of a central one is positive in front of him.
    `surfaces="mesh"`: no faces are recognised. `scale`: mm of paper for a unit, by which `join_within` and the
    tolerance `arcs` are measured; 0: the drawing is 1 m large. Throws InputError.
    """
    if surfaces not in ("auto", "mesh"):
        raise InputError(f"surfaces: is {surfaces!r}", "surfaces", "write 'auto' or 'mesh'")
    library = _library()
    error = _Error(size=c.sizeof(_Error))
    model = library.epura_hlr_model_new(_VERSION)
    if not model:
        raise Error(f"the library of epura {_core.version()} has another version of its interface", "libepura-hlr.so.1")
    drawing = None
    try:
        _fill(library.epura_hlr_sink(model).contents, shape, faces, format, tolerance)
        settings = _Settings(c.sizeof(_Settings), surfaces == "mesh", threads, 0)
        if library.epura_hlr_finish(model, settings, error):
            _raise(error)
        request = _Request(size=c.sizeof(_Request), kinds=_number_of(kinds), only_visible=not hidden, threads=threads,
                           crease_angle=crease_angle, scale=scale, join_within=join_within, arcs=arcs, all_types=1)
        if matrix is None:
            request.view = c.pointer(_view(direction, up, eye, target))
        else:
            numbers = np.ascontiguousarray(matrix, dtype=np.float64)
            if numbers.shape != (4, 4):
                raise InputError(f"matrix: has the shape {numbers.shape}", "matrix", "give four rows of four numbers")
            request.matrix = numbers.ctypes.data
        drawing = library.epura_hlr_draw(model, request, error)
        if not drawing:
            _raise(error)
        return _curves(library, drawing)
    finally:
        library.epura_hlr_drawing_free(drawing)
        library.epura_hlr_model_free(model)
