# SPDX-License-Identifier: Apache-2.0
"""Importers, called in this process: the content of a file goes to the calls of hlr.h, with its faces and edges."""

from __future__ import annotations

import ctypes as c
import functools
import os
import tempfile
from pathlib import Path
from typing import Any, Dict, List, Optional

from ._errors import InputError

_ABI = 1


class _Parameter(c.Structure):
    _fields_ = [("size", c.c_uint32), ("type", c.c_uint32), ("count", c.c_uint32), ("name", c.c_char_p),
                ("unit", c.c_char_p), ("help", c.c_char_p), ("choices", c.c_char_p), ("initial", c.c_double * 8),
                ("least", c.c_double), ("most", c.c_double)]


class _Source(c.Structure):
    _fields_ = [("size", c.c_uint32), ("threads", c.c_uint32), ("path", c.c_char_p), ("values", c.POINTER(c.c_double)),
                ("tolerance", c.c_double), ("relative_tolerance", c.c_double), ("may_leave", c.c_uint32),
                ("unused", c.c_uint32)]


class _Importer(c.Structure):
    _fields_ = [("size", c.c_uint32), ("unused", c.c_uint32), ("name", c.c_char_p), ("summary", c.c_char_p),
                ("extensions", c.c_char_p), ("parameters", c.c_void_p), ("parameter_count", c.c_uint64),
                ("recognises", c.c_void_p), ("read", c.CFUNCTYPE(c.c_char_p, c.POINTER(_Source), c.c_void_p))]


class _List(c.Structure):
    _fields_ = [("abi", c.c_uint32), ("size", c.c_uint32), ("count", c.c_uint64), ("importers", c.c_void_p)]


@functools.lru_cache(maxsize=None)
def _importers(folder: Path) -> Dict[str, _Importer]:
    """By the endings of the files that they read."""
    known: Dict[str, _Importer] = {}
    for file in sorted(folder.glob("*.so")):
        library = c.CDLL(str(file))
        library.epura_importers_v1.restype = c.POINTER(_List)
        rows = library.epura_importers_v1().contents
        if rows.abi != _ABI or rows.count == 0:
            continue
        size = _Importer.from_address(rows.importers).size
        for i in range(rows.count):
            row = _Importer.from_address(rows.importers + i * size)
            for extension in row.extensions.decode().split("|"):
                known.setdefault(extension, row)
    return known


def _values(row: _Importer) -> Any:
    values: List[float] = []
    size = _Parameter.from_address(row.parameters).size if row.parameter_count else 0
    for i in range(row.parameter_count):
        parameter = _Parameter.from_address(row.parameters + i * size)
        values += parameter.initial[:parameter.count]
    return (c.c_double * max(1, len(values)))(*values)


def has_importer(folder: Path, ending: str) -> bool:
    return ending in _importers(folder)


def _importer_of(folder: Path, ending: str) -> _Importer:
    row = _importers(folder).get(ending)
    if row is None:
        raise InputError(f"shape: there is no importer for .{ending}", "shape",
                         "known: " + ", ".join(sorted(_importers(folder))) + "; others are read by trimesh or meshio")
    return row


def _source(row: _Importer, path: Optional[bytes], tolerance: float) -> _Source:
    return _Source(c.sizeof(_Source), os.cpu_count() or 1, path, _values(row), tolerance, 0 if tolerance > 0 else 1 / 20000, 0, 0)


def _expect(wrong: Optional[bytes]) -> None:
    if wrong is not None:
        raise InputError(f"shape: {wrong.decode('utf-8', 'replace')}", "shape")


def read(folder: Path, path: str, ending: str, tolerance: float, sink: Any) -> None:
    """`tolerance`: permitted deviation of facets in mm; 0: 1/20000 of the size."""
    row = _importer_of(folder, ending)
    _expect(row.read(_source(row, os.fsencode(path), tolerance), c.addressof(sink)))


def read_bytes(folder: Path, content: bytes, ending: str, tolerance: float, sink: Any) -> None:
    _importer_of(folder, ending)  # by which the name of the file is no path
    with tempfile.TemporaryDirectory() as place:
        file = os.path.join(place, "shape." + ending)
        Path(file).write_bytes(content)
        read(folder, file, ending, tolerance, sink)


def read_address(folder: Path, address: int, tolerance: float, sink: Any) -> None:
    """Of a TopoDS_Shape in this process, of the same library of Open CASCADE as the importer's."""
    row = _importer_of(folder, "brep")
    hand_over = c.CDLL(str(folder / "opencascade.so")).epura_opencascade_shape_v1
    hand_over.restype, hand_over.argtypes = c.c_char_p, [c.c_void_p, c.POINTER(_Source), c.c_void_p]
    _expect(hand_over(address, _source(row, None, tolerance), c.addressof(sink)))
