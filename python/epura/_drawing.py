# SPDX-License-Identifier: Apache-2.0
"""Drawings: lines as arrays, and files."""

from __future__ import annotations

import base64
import html
import json
import os
from typing import Any, Dict, List, NamedTuple, Tuple, Union

import numpy as np

from . import _core

#: The kinds of edges by the numbers in `DrawnView.kind`.
KINDS = ("contour", "boundary", "crease", "intersection", "section", "wire", "tangent", "smooth")


class Arc(NamedTuple):
    """An arc in place of lines: centre + cos(a) u + sin(a) v for a between `start` and `end`, in radians."""

    centre: Tuple[float, float]
    u: Tuple[float, float]
    v: Tuple[float, float]
    start: float
    end: float
    kind: int
    visible: bool


class Layer(NamedTuple):
    """Pen strokes as they are written: arrays (n, 2) in mm; closed ones end at their first point."""

    name: str
    width: float
    strokes: List[np.ndarray]


class DrawnView:
    """A drawn view. The arrays have one row a line, borrow the memory of the drawing, and are read-only.

    `segments` (n, 2, 2): both ends in mm from the lower left corner of the sheet, y up. `kind` (n): index in KINDS.
    `visible` (n). `model`, `body` (n): numbers from 0, -1 if there is none. `edge` (n, 2): its vertices in the model,
    -1 for intersections and cuts. `t` (n, 2): parameters of both ends along that edge in space.
    `arcs`: those found within the tolerance `arcs` of `draw`.
    `error`: how far lines may be from those of the part, mm on paper; `error_terms`: what it consists of, the largest
    first, each with its mm and "bound", "measured" or "estimated".
    `world_to_page` (4, 4): for a world point as a column, rows 0 and 1 over row 3 are mm on the sheet.
    """

    def __init__(self, drawing: _core.Drawing, number: int) -> None:
        self.name: str
        self.projection: str
        self.sheet: int
        self.scale: float
        self.name, self.projection, self.sheet, self.scale, matrix = drawing.view_facts(number)
        self.world_to_page: np.ndarray = np.array(matrix).reshape(4, 4)
        lines = drawing.lines(number)
        self.segments: np.ndarray = lines["segments"]
        self.kind: np.ndarray = lines["kind"]
        self.visible: np.ndarray = lines["visible"]
        self.model: np.ndarray = lines["model"]
        self.body: np.ndarray = lines["body"]
        self.edge: np.ndarray = lines["edge"]
        self.t: np.ndarray = lines["t"]
        self._drawing, self._number = drawing, number

    @property
    def error_terms(self) -> Dict[str, Tuple[float, str]]:
        return self._drawing.error(self._number)

    @property
    def error(self) -> float:
        return sum(mm for mm, _ in self.error_terms.values())

    @property
    def arcs(self) -> List[Arc]:
        return [Arc(*arc) for arc in self._drawing.arcs(self._number)]

    def __repr__(self) -> str:
        return f"<epura.DrawnView {self.name!r}: {len(self.segments)} lines>"


class Drawing:
    """Sheets with views, as `draw` returns them."""

    def __init__(self, core: _core.Drawing) -> None:
        self._core = core
        self.views: List[DrawnView] = [DrawnView(core, i) for i in range(core.view_count())]

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

    @property
    def is_wrong(self) -> bool:
        """Whether `verify` found an error."""
        return self._core.is_wrong

    def layers(self, sheet: int = 1) -> List[Layer]:
        """The layers of a sheet in painting order."""
        return [Layer(*layer) for layer in self._core.layers(sheet)]

    def to_svg(self, sheet: int = 1) -> str:
        """The SVG of a sheet, counted from 1."""
        return self._core.to_svg(sheet)

    def to_json(self, sheet: int = 1) -> str:
        """The JSON of a sheet (docs/formats.md)."""
        return self._core.to_json(sheet)

    def annotations(self, sheet: int = 1) -> Dict[str, Any]:
        """Dimensions, notes, tolerance frames, tables, balloons and title fields of a sheet, as its JSON has them; empty
        if it has none. `share/epura/annotations.schema.json` says what they are."""
        found: Dict[str, Any] = json.loads(self.to_json(sheet)).get("annotations", {})
        return found

    def to_dxf(self, sheet: int = 1) -> str:
        """The DXF of a sheet."""
        return self._core.to_dxf(sheet)

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

    def _repr_html_(self) -> str:
        """The same as an image in itself: notebooks that become web pages drop SVG of its own."""
        title = html.escape(", ".join(view.name for view in self.views), quote=True)
        svg = base64.b64encode(self.to_svg().encode()).decode()
        return f'<img alt="{title}" style="max-width:100%" src="data:image/svg+xml;base64,{svg}">'

    def __repr__(self) -> str:
        return f"<epura.Drawing: {', '.join(view.name for view in self.views)}>"
