# SPDX-License-Identifier: Apache-2.0
"""Models: files, bytes, arrays, and the objects of other libraries, known by their attributes."""

from __future__ import annotations

import itertools
import os
from dataclasses import KW_ONLY, dataclass
from typing import Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from ._errors import InputError
from ._parts import ModelOptions
from ._values import fields_of

#: Corners of the faces of meshio: those in the middle of edges are left out.
_CORNERS = {"triangle": 3, "triangle6": 3, "triangle7": 3, "quad": 4, "quad8": 4, "quad9": 4}
_WANTED = ("give a path, bytes with a format, vertices and faces, or an object that has them: .vertices and .faces, "
           ".points and .cells_dict, or .tessellate(tolerance)")


@dataclass(eq=False)
class Model(ModelOptions):
    """A model of a scene, with the options of `[[model]]` in scene files.

    `source`: the path of a file; the bytes of one, with its `format` ("stl"); vertices (n, 3), with `faces`; or an
    object with `.vertices` and `.faces` (trimesh), `.points` and `.cells_dict` (meshio), or `.tessellate(tolerance)`
    (build123d, CadQuery), to a tolerance in its unit; by default 1/20000 of its size. World coordinates are
    right-handed, z up, in mm; faces are counterclockwise as seen from outside.
    """

    source: Any
    faces: Any = None
    _: KW_ONLY
    format: Optional[str] = None
    tolerance: Optional[float] = None


def _points(vertices: Any, place: str) -> Tuple[np.ndarray, bool]:
    """The array itself, if it can be borrowed; and whether its numbers had 32 bits."""
    try:
        given = np.asarray(vertices)
        points = np.ascontiguousarray(given, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"{place}: {error}", place, "give an array of n rows with x, y and z") from None
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"{place}: have the shape {points.shape}", place, "give n rows with x, y and z")
    return points, given.dtype == np.float32


def _face_arrays(faces: Any, place: str) -> List[np.ndarray]:
    """Arrays of faces with the same number of corners; the array itself, if it can be borrowed."""
    hint = "give an array of n rows with the indices of vertices, or a list of faces"
    if isinstance(faces, np.ndarray) or hasattr(faces, "__array__"):
        groups: List[Any] = [np.asarray(faces)]
    else:
        groups = [list(group) for _, group in itertools.groupby(faces, key=len)]
    arrays = []
    for group in groups:
        array = np.asarray(group)
        if array.ndim != 2 or not np.issubdtype(array.dtype, np.integer):
            raise InputError(f"{place}: have shape {array.shape} of {array.dtype}", place, hint)
        if array.size and (array.max() > np.iinfo(np.int32).max or array.min() < 0):
            raise InputError(f"{place}: an index is negative or above 2147483647", place, hint)
        arrays.append(np.ascontiguousarray(array, dtype=np.int32))
    return arrays


def _coordinates(vector: Any) -> Tuple[float, float, float]:
    """Of a vector of build123d, CadQuery or another library."""
    if hasattr(vector, "toTuple"):
        return vector.toTuple()  # type: ignore[no-any-return]
    for names in ("XYZ", "xyz"):
        if all(hasattr(vector, name) for name in names):
            x, y, z = (float(getattr(vector, name)) for name in names)
            return x, y, z
    x, y, z = vector
    return x, y, z


def _tessellated(shape: Any, tolerance: Optional[float]) -> Tuple[Any, Any]:
    def at(value: float) -> Tuple[np.ndarray, Any]:
        vertices, triangles = shape.tessellate(value)
        return np.array([_coordinates(vertex) for vertex in vertices], dtype=np.float64).reshape(-1, 3), triangles

    if tolerance is not None:
        return at(tolerance)
    coarse, _ = at(1.0)
    size = float(np.linalg.norm(np.ptp(coarse, axis=0))) if len(coarse) else 0.0
    return at(size / 20000 if size > 0 else 0.05)


def _cells(mesh: Any, place: str) -> List[np.ndarray]:
    faces = []
    for name, cells in mesh.cells_dict.items():
        if name in _CORNERS or name.startswith("polygon"):
            faces += _face_arrays(np.asarray(cells)[:, :_CORNERS.get(name)], f"{place}.{name}")
        elif name not in ("vertex", "line", "line3"):
            raise InputError(f"{place}: has cells of type '{name}', which is no surface", place,
                             "give the surface of the volume")
    return faces


def _is_data(owner: Any, name: str) -> bool:
    """build123d has methods of these names."""
    return hasattr(owner, name) and not callable(getattr(owner, name))


def _shape_in(source: Any) -> Any:
    """What a Workplane of CadQuery or a BuildPart of build123d is about; others are themselves."""
    if not hasattr(source, "tessellate"):
        if callable(getattr(source, "val", None)):
            return source.val()
        if hasattr(getattr(source, "part", None), "tessellate"):
            return source.part
    return source


def _geometry(model: Model, place: str) -> Dict[str, Any]:
    """Vertices and faces of whatever the source is."""
    source, faces = model.source, model.faces
    if faces is None and hasattr(source, "geometry") and hasattr(source, "dump"):  # a scene of trimesh
        source = source.dump(concatenate=True)
    if faces is None:
        source = _shape_in(source)
    if faces is not None:
        vertices = source
    elif _is_data(source, "vertices") and (_is_data(source, "faces") or _is_data(source, "triangles")):
        vertices, faces = source.vertices, source.faces if hasattr(source, "faces") else source.triangles
    elif _is_data(source, "points") and _is_data(source, "cells_dict"):
        points, single = _points(source.points, f"{place}.points")
        return {"points": points, "faces": _cells(source, f"{place}.cells"), "single_precision": single}
    elif callable(getattr(source, "tessellate", None)):
        vertices, faces = _tessellated(source, model.tolerance)
    else:
        raise InputError(f"{place}: is of type {type(source).__name__}", place, _WANTED)
    points, single = _points(vertices, f"{place}.vertices")
    return {"points": points, "faces": _face_arrays(faces, f"{place}.faces"), "single_precision": single}


_OWN = ("source", "faces", "format", "tolerance")


def described(model: Any, number: int, count: int) -> Tuple[Dict[str, Any], Optional[Dict[str, Any]]]:
    """The model in the words of scene files, and what it has in memory."""
    place = f"models[{number}]"
    if isinstance(model, Mapping):
        if "source" not in model:
            return dict(model), None
        model = Model(**model)
    elif not isinstance(model, Model):
        model = Model(model)
    options = {key: value for key, value in fields_of(model).items() if key not in _OWN}
    source = model.source
    if isinstance(source, (str, os.PathLike)):
        if model.faces is not None:
            raise InputError(f"{place}: has both a file and faces", place, "give exactly one of them")
        return {"file": source, **options}, None
    name = model.name or ("model" if count == 1 else f"model-{number}")
    if isinstance(source, (bytes, bytearray, memoryview)):
        if not model.format:
            raise InputError(f"{place}.format: is missing", f"{place}.format", 'bytes need one: format="stl"')
        return {"file": f"{name}.{model.format}", **options}, {"model": number, "bytes": bytes(source)}
    return {"file": name, **options}, {"model": number, **_geometry(model, place)}
