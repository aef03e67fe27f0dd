# SPDX-License-Identifier: Apache-2.0
"""Engineering drawings of 3D meshes: any projection, exact hidden lines, SVG and PDF.

    drawing = epura.draw(vertices, faces, projection="isometric")
    drawing.save("part.pdf")
    drawing.views[0].segments  # numpy, mm on the sheet, y up

    scene = epura.Scene(models=["part.step"], views=["front", epura.View("top", hidden="none")],
                        dimensions=[epura.Dimension(type="auto")])
    epura.draw(scene).save("part.pdf")

    epura.hlr(vertices, faces, direction=(1, -1, 1)).visible  # without a sheet: arrays of points, in units of the model

`epura.projection`: projections written in Python. `epura.testing`: drawings in tests.
"""

from . import _core, projection
from ._compare import Comparison, compare
from ._draw import draw
from ._drawing import KINDS, Arc, DrawnView, Drawing, Layer
from ._errors import Error, InputError, OutputError, PluginError, TimeError
from ._hlr import Curve, Curves, EdgeArc, EdgeSpline, hlr
from ._models import Model
from ._parts import (Accepted, BrokenOut, Datum, Detail, Dimension, Explode, Note, PartsList, Requirement, Revision, Revolved,
                     Section, Sheet, Style, SurfaceTexture, Table, ToleranceFrame, View)
from ._scene import Scene

__all__ = [
    "Accepted", "Arc", "BrokenOut", "Comparison", "Curve", "Curves", "Datum", "Detail", "Dimension", "Drawing",
    "DrawnView", "EdgeArc", "EdgeSpline", "Error", "Explode", "InputError", "KINDS", "Layer", "Model", "Note", "OutputError",
    "PartsList", "PluginError", "Requirement", "Revision", "Revolved", "Scene", "Section", "Sheet", "Style", "SurfaceTexture",
    "Table", "TimeError", "ToleranceFrame", "View", "compare", "draw", "hlr", "projection",
]
__version__: str = _core.version()
