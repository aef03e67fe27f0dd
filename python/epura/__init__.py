# SPDX-License-Identifier: Apache-2.0
"""Engineering drawings of 3D meshes: any projection, exact hidden lines, SVG and PDF.

    drawing = epura.draw(vertices, faces, projection="isometric")
    drawing.save("part.pdf")
    drawing.views[0].segments  # numpy, mm on the sheet, y up
"""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from . import _core
from ._errors import Error, InputError, OutputError, PluginError, TimeError

__all__ = ["Drawing", "Error", "InputError", "KINDS", "OutputError", "PluginError", "TimeError", "View", "draw"]
__version__: str = _core.version()

#: The kinds of edges by the numbers in `View.kind`.
KINDS = ("contour", "boundary", "crease", "intersection", "section", "wire", "tangent", "smooth")

_HIDDEN = ("none", "dashed", "solid")


class View:
    """A drawn view. The arrays have one row a line, borrow the memory of the drawing, and are read-only.

    `segments` (n, 2, 2): both ends in mm from the lower left corner of the sheet, y up. `kind` (n): index in KINDS.
    `visible` (n). `model`, `body` (n): numbers from 0, -1 if there is none. `edge` (n, 2): its vertices in the model,
    -1 for intersections and cuts. `t` (n, 2): parameters of both ends along that edge in space.
    `world_to_page` (4, 4): for a world point as a column, rows 0 and 1 over row 3 are mm on the sheet.
    """

    def __init__(self, drawing: _core.Drawing, number: int) -> None:
        self.name, self.projection, self.sheet, self.scale, matrix = drawing.view_facts(number)
        self.world_to_page = np.array(matrix).reshape(4, 4)
        lines = drawing.lines(number)
        self.segments = lines["segments"]
        self.kind = lines["kind"]
        self.visible = lines["visible"]
        self.model = lines["model"]
        self.body = lines["body"]
        self.edge = lines["edge"]
        self.t = lines["t"]

    def __repr__(self) -> str:
        return f"<epura.View {self.name!r}: {len(self.segments)} lines>"


class Drawing:
    """Sheets with views, as `draw` returns them."""

    def __init__(self, core: _core.Drawing) -> None:
        self._core = core
        self.views: List[View] = [View(core, i) for i in range(core.view_count())]

    @property
    def sheets(self) -> int:
        """The number of sheets."""
        return self._core.sheets

    @property
    def warnings(self) -> List[str]:
        """One sentence each: repairs of models, and requests that could not be met."""
        return self._core.warnings

    @property
    def cut_stages(self) -> List[str]:
        """The stages that `time_limit` cut short; empty if the drawing is complete."""
        return self._core.cut_stages

    def to_svg(self, sheet: int = 1) -> str:
        """The SVG of a sheet, counted from 1."""
        return self._core.to_svg(sheet)

    def to_json(self, sheet: int = 1) -> str:
        """The JSON of a sheet (docs/formats.md)."""
        return self._core.to_json(sheet)

    def to_pdf(self) -> bytes:
        """All sheets as one PDF."""
        return self._core.to_pdf()

    def to_png(self, sheet: int = 1, dpi: float = 300) -> bytes:
        """A sheet as PNG, with 1 to 1200 dots per inch."""
        return self._core.to_png(sheet, dpi)

    def save(self, file: Union[str, "os.PathLike[str]"]) -> List[str]:
        """Writes a file in the format of its extension; returns the paths written. Raises OutputError."""
        return self._core.save(os.fspath(file))

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def __repr__(self) -> str:
        return f"<epura.Drawing: {', '.join(view.name for view in self.views)}>"


def _points(vertices: Any) -> np.ndarray:
    try:
        points = np.asarray(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"vertices: {error}", "vertices", "give an array of n rows with x, y and z") from None
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"vertices: have the shape {points.shape}", "vertices", "give n rows with x, y and z")
    return points


def _face_arrays(faces: Any) -> List[np.ndarray]:
    hint = "give an array of n rows with the indices of vertices, or a list of faces"
    equal = isinstance(faces, np.ndarray) or len({len(face) for face in faces}) == 1
    groups: List[Any] = [faces] if equal else [[face] for face in faces]
    arrays = []
    for group in groups:
        array = np.asarray(group)
        if array.ndim != 2 or not np.issubdtype(array.dtype, np.integer):
            raise InputError(f"faces: have shape {array.shape} of {array.dtype}", "faces", hint)
        if array.size and (array.max() > np.iinfo(np.int32).max or array.min() < 0):
            raise InputError("faces: an index is negative or above 2147483647", "faces", hint)
        arrays.append(array.astype(np.int32, copy=False))
    return arrays


def _view(projection: str, parameters: Mapping[str, Any], hidden: Optional[str]) -> Dict[str, Any]:
    view: Dict[str, Any] = {"projection": projection, "parameters": dict(parameters)}
    if hidden is not None:
        if hidden not in _HIDDEN:
            raise InputError(f"hidden: is {hidden!r}", "hidden", "allowed: " + ", ".join(_HIDDEN))
        view["hidden"] = _HIDDEN.index(hidden)
    return view


def draw(
    model: Any,
    faces: Any = None,
    *,
    projection: str = "isometric",
    views: Optional[Sequence[str]] = None,
    parameters: Optional[Mapping[str, Union[float, Sequence[float], str]]] = None,
    hidden: Optional[str] = None,
    size: Optional[str] = None,
    scale: Optional[float] = None,
    title: Optional[str] = None,
    centre_lines: bool = False,
    arcs: Optional[float] = None,
    time_limit: Optional[float] = None,
    threads: int = 0,
    progress: Optional[Callable[[str, float], None]] = None,
) -> Drawing:
    """Draws a model: the path of a file, vertices (n, 3) with faces, or an object with `.vertices` and `.faces`.

    World coordinates are right-handed, z up, in mm; faces are counterclockwise as seen from outside. `projection` is
    one view, with `parameters` (`epura plugins NAME`); `views` are several instead. `hidden`: none, dashed or solid.
    `size`: of the paper, such as "A4"; `scale`: mm on paper per mm; `arcs`: tolerance in mm within which arcs are
    recognised; `time_limit`: seconds; `threads`: 0 for all cores. `progress` is called with the name of a stage and its
    completed fraction. Other Python threads run meanwhile; Ctrl-C raises KeyboardInterrupt.
    Raises InputError, PluginError or TimeError.
    """
    if faces is None and hasattr(model, "vertices") and hasattr(model, "faces"):
        model, faces = model.vertices, model.faces
    if faces is not None:
        values: Dict[str, Any] = {"points": _points(model), "faces": _face_arrays(faces), "name": "model"}
    elif isinstance(model, (str, os.PathLike)):
        values = {"file": os.fspath(model)}
    else:
        raise InputError(f"model: is a {type(model).__name__}", "model",
                         "give a path, vertices and faces, or an object with both")
    names = [projection] if views is None else list(views)
    if views is not None and parameters:
        raise InputError("parameters: given with views", "parameters", "parameters belong to one projection")
    sheet = {key: value for key, value in (("size", size), ("scale", scale), ("title", title)) if value is not None}
    options: Dict[str, Any] = {"centre_lines": centre_lines, "threads": threads}
    options.update({key: v for key, v in (("arcs", arcs), ("time_limit", time_limit)) if v is not None})
    return Drawing(_core.draw([values], [_view(name, parameters or {}, hidden) for name in names], sheet, options,
                              progress))
