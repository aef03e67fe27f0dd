# SPDX-License-Identifier: Apache-2.0
"""Projections written in Python.

    class Shadow:
        name = "shadow"
        family = "sun"
        summary = "shadow on the ground, seen from above"
        parameters = [number("azimuth", "deg", "how far to the right of the front the sun stands", 30, -360, 360),
                      number("elevation", "deg", "the sun's height above the horizon", 45, 1, 90)]

        @staticmethod
        def project(scene, azimuth, elevation):
            return Plane(normal=(0, 0, 1), up=(0, 1, 0), projector=towards_viewer(azimuth, elevation))

    epura.draw(model, projection=Shadow, parameters={"elevation": 60})
    epura.draw(model, projection="shadow:elevation=60", projections=[Shadow])

The table is that of docs/plugins.md. `project` is called for one view after the other, in a thread of the drawing that
holds the interpreter's lock. A ValueError says why values are invalid; any other exception is a fault of the class.
"""

from __future__ import annotations

import math
import traceback
from dataclasses import dataclass
from typing import Any, ClassVar, Dict, List, Protocol, Sequence, Tuple

import numpy as np

__all__ = ["Box", "Parameter", "Plane", "Projection", "choice", "number", "towards_viewer", "vector"]

Triple = Tuple[float, float, float]


@dataclass(frozen=True)
class Parameter:
    """A row of the table of parameters; made by `number`, `vector` and `choice`."""

    name: str
    unit: str
    help: str
    initial: Tuple[float, ...]
    least: float = -math.inf
    most: float = math.inf
    choices: Tuple[str, ...] = ()


def number(name: str, unit: str, help: str, initial: float, least: float = -math.inf,
           most: float = math.inf) -> Parameter:
    """A number. NaN as the default: `project` determines it, for example from the box."""
    return Parameter(name, unit, help, (float(initial),), least, most)


def vector(name: str, unit: str, help: str, initial: Sequence[float]) -> Parameter:
    """One to eight numbers."""
    return Parameter(name, unit, help, tuple(float(value) for value in initial))


def choice(name: str, help: str, choices: str, initial: int = 0) -> Parameter:
    """One of the words "a|b|c"; `project` receives the word."""
    words = tuple(choices.split("|"))
    return Parameter(name, "", help, (float(initial),), 0, len(words) - 1, words)


@dataclass(frozen=True)
class Box:
    """The bounding box of everything drawn."""

    least: np.ndarray
    most: np.ndarray

    @property
    def centre(self) -> np.ndarray:
        return 0.5 * self.least + 0.5 * self.most

    @property
    def diagonal(self) -> float:
        """Never zero, so that distances derived from it stay distinct even for a single point."""
        length = float(np.linalg.norm(self.most - self.least))
        return length if length > 0 else 1.0


@dataclass
class Plane:
    """A plane, and projectors onto it.

    `projector`: towards the viewer, or the centre of projection if `central`. `point`: a point of the plane, origin of
    `window`. `scale`: length on the page of a unit length in the plane. `window`: least u, least v, most u, most v of
    what is drawn. `front`, `back`: only what lies between these distances from `point` along `normal` is drawn.
    """

    normal: Sequence[float]
    up: Sequence[float]
    projector: Sequence[float]
    point: Sequence[float] = (0, 0, 0)
    central: bool = False
    scale: float = 1
    window: Sequence[float] = (0, 0, 0, 0)
    front: float = math.inf
    back: float = -math.inf


class Projection(Protocol):
    """What a class of a projection has; `reference` (standard, book or paper) is optional."""

    name: ClassVar[str]
    family: ClassVar[str]
    summary: ClassVar[str]
    parameters: ClassVar[Sequence[Parameter]]

    def project(self, scene: Box, *values: Any) -> Plane: ...


def towards_viewer(azimuth: float, elevation: float) -> Triple:
    """Unit vector towards a viewer so many degrees to the right of the front and above the horizon."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return math.sin(a) * math.cos(e), -math.cos(a) * math.cos(e), math.sin(e)


def is_projection(value: Any) -> bool:
    return callable(getattr(value, "project", None)) and hasattr(value, "name")


def _triple(plane: Plane, member: str) -> Triple:
    value = [float(component) for component in getattr(plane, member)]
    if len(value) != 3:
        raise TypeError(f"Plane.{member} has {len(value)} components instead of 3")
    return value[0], value[1], value[2]


def _flat(plane: Any) -> Tuple[Any, ...]:
    if not isinstance(plane, Plane):
        raise TypeError(f"project() returned a {type(plane).__name__}, not an epura.projection.Plane")
    window = [float(component) for component in plane.window]
    return (bool(plane.central), _triple(plane, "point"), _triple(plane, "normal"), _triple(plane, "up"),
            _triple(plane, "projector"), float(plane.scale), window, (float(plane.front), float(plane.back)))


def _arguments(parameters: Sequence[Parameter], numbers: List[float]) -> List[Any]:
    arguments: List[Any] = []
    for parameter in parameters:
        count = len(parameter.initial)
        values, numbers = numbers[:count], numbers[count:]
        if parameter.choices:
            arguments.append(parameter.choices[int(values[0])])
        else:
            arguments.append(values[0] if count == 1 else np.array(values))
    return arguments


def _place_of(error: BaseException) -> str:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return f"({frame.filename}:{frame.lineno})"


def _told(error: BaseException) -> str:
    """The last line of the traceback, and where the error was raised."""
    return f"raised {traceback.format_exception_only(type(error), error)[-1].strip()} {_place_of(error)}"


def table_of(projection: Any) -> Dict[str, Any]:
    """The class as _core reads it."""
    owner: Any = projection if isinstance(projection, type) else type(projection)
    instance = projection() if isinstance(projection, type) else projection
    parameters = list(getattr(owner, "parameters", ()))

    def project(numbers: List[float], least: Triple, most: Triple) -> Tuple[str, Any]:
        try:
            values = _arguments(parameters, numbers)
            try:
                plane = instance.project(Box(np.array(least), np.array(most)), *values)
            except ValueError as error:
                return "refused", f"{error} {_place_of(error)}"
            return "plane", _flat(plane)
        except BaseException as error:  # the thread of the drawing must not see it
            return "failed", _told(error)

    return {
        "name": owner.name, "family": getattr(owner, "family", "own"), "summary": getattr(owner, "summary", ""),
        "reference": getattr(owner, "reference", ""), "place": f"class {owner.__module__}.{owner.__qualname__}",
        "parameters": [{"name": row.name, "initial": list(row.initial), "choices": list(row.choices), "unit": row.unit,
                        "help": row.help, "least": float(row.least), "most": float(row.most)} for row in parameters],
        "project": project,
    }


def tables_of(projections: Sequence[Any]) -> List[Dict[str, Any]]:
    """Each class once."""
    unique: List[Any] = []
    for projection in projections:
        if not any(projection is other for other in unique):
            unique.append(projection)
    return [table_of(projection) for projection in unique]
