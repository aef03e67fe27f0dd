# SPDX-License-Identifier: Apache-2.0
"""draw()."""

from __future__ import annotations

import atexit
import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Set, Union

from . import _core
from ._drawing import Drawing
from ._errors import InputError
from ._models import Model
from ._parts import Sheet, View
from ._scene import Scene, described
from ._values import fields_of
from .projection import tables_of

#: Seconds between two looks at signals, and until a stopped drawing goes on to its end by itself.
_LOOK, _GRACE = 0.03, 0.05

#: Drawings that were stopped and have not ended yet.
_stopped: Set[_core.Job] = set()


def _forget_ended() -> None:
    """Destroys them, which waits for their ends."""
    for job in list(_stopped):
        if job.wait(0):
            _stopped.discard(job)


@atexit.register
def _await_stopped() -> None:
    for job in list(_stopped):
        job.wait(3600)


class _Bar:
    """A bar of tqdm: one for each stage."""

    def __init__(self, tqdm: Any) -> None:
        self._tqdm = tqdm
        self._bar: Any = None

    def __call__(self, stage: str, done: float) -> None:
        if self._bar is None or self._bar.desc != stage:
            self.close()
            self._bar = self._tqdm(total=100, desc=stage, leave=False, bar_format="{desc}: {percentage:3.0f}%|{bar}|")
        self._bar.update(round(100 * done) - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


def _bar() -> Optional[_Bar]:
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return _Bar(tqdm)


def _result_of(job: _core.Job, progress: Optional[Callable[[str, float], None]]) -> Drawing:
    _forget_ended()
    try:
        while not job.wait(_LOOK):
            news = job.news()
            if news is not None and progress is not None:
                progress(*news)
    except BaseException:
        job.stop()
        if not job.wait(_GRACE):
            _stopped.add(job)
        raise
    return Drawing(job.result())


def _scene_file(model: Any) -> Optional[str]:
    """The path of a scene file; None for all other models."""
    if not isinstance(model, (str, os.PathLike)):
        return None
    path = os.fspath(model)
    return path if isinstance(path, str) and path.endswith(".toml") else None


def draw(
    model: Any,
    faces: Any = None,
    *,
    projection: Any = None,
    parameters: Optional[Mapping[str, Any]] = None,
    views: Optional[Sequence[Any]] = None,
    hidden: Optional[str] = None,
    size: Optional[str] = None,
    scale: Union[str, float, None] = None,
    title: Optional[str] = None,
    sheet: Union[Sheet, Mapping[str, Any], None] = None,
    contact: Optional[float] = None,
    wireframe: bool = False,
    centre_lines: bool = False,
    max_error: Optional[float] = None,
    error_note: bool = False,
    arcs: Optional[float] = None,
    verify: Optional[int] = None,
    time_limit: Optional[float] = None,
    threads: int = 0,
    plugin_path: Sequence[Union[str, "os.PathLike[str]"]] = (),
    allow_outside: bool = False,
    projections: Sequence[Any] = (),
    progress: Union[bool, Callable[[str, float], None], None] = None,
) -> Drawing:
    """Draws a `Scene`, a scene file (.toml), or one model: whatever `Model` takes, or vertices (n, 3) with faces.

    Of one model: `projection` is its view, by default isometric, with `parameters` (`epura plugins NAME`); `views` are
    several instead. `hidden`: style of hidden lines; `size` of the paper, such as "A4"; `scale`: mm on paper per mm, or
    "1:2"; `title`; `sheet`: other options of the sheet.

    Of every drawing: `contact`: distance below which faces touch; `wireframe`: no hidden lines are removed;
    `max_error`: mm on paper by which lines may be off those of the part, with facets, arcs and decimals chosen for it;
    `error_note`: the error is stated on sheets; `centre_lines` of circular features; `arcs`: tolerance in mm within
    which arcs are recognised; `verify`: points at which the drawing is tested; `time_limit`: seconds; `threads`: 0 for
    all cores; `plugin_path`: more folders with plugins; `allow_outside`: scene files and models may name files outside their folders; `projections`: classes that
    views use by name (epura.projection). `progress` is called with the name of a stage and its completed fraction;
    True shows a bar, if tqdm is installed.

    Other Python threads run meanwhile; Ctrl-C raises KeyboardInterrupt. Raises InputError, PluginError or TimeError.
    """
    of_one = {"projection": projection, "parameters": parameters, "views": views, "hidden": hidden, "size": size,
              "scale": scale, "title": title, "sheet": sheet}
    settings: Dict[str, Any] = {"wireframe": wireframe, "centre_lines": centre_lines, "error_note": error_note,
                                "threads": threads, "allow_outside": allow_outside,
                                "plugin_path": [os.fspath(folder) for folder in plugin_path]}
    settings.update({key: value for key, value in (("contact", contact), ("max_error", max_error), ("arcs", arcs),
                                                   ("verify", verify), ("time_limit", time_limit)) if value is not None})
    scene_file = _scene_file(model)
    if scene_file or isinstance(model, Scene):
        given = [name for name, value in of_one.items() if value is not None]
        if given:
            raise InputError(f"{given[0]}: given with a scene", given[0], "put it into the scene")
    if scene_file:
        job = _core.begin_file(scene_file, settings, tables_of(projections))
    else:
        scene = model if isinstance(model, Scene) else Scene(
            models=[model if faces is None else Model(model, faces)],
            views=_views_of(projection, parameters, views, hidden), sheets=_sheets_of(sheet, size, scale, title))
        value, sources, classes = described(scene)
        job = _core.begin(value, sources, settings, tables_of([*projections, *classes]))
    bar = _bar() if progress is True else None
    try:
        return _result_of(job, bar if progress is True or not progress else progress)
    finally:
        if bar is not None:
            bar.close()


def _views_of(projection: Any, parameters: Optional[Mapping[str, Any]], views: Optional[Sequence[Any]],
              hidden: Any) -> List[Any]:
    if views is None:
        name = "isometric" if projection is None else projection
        return [View({"name": name, **parameters} if parameters else name, hidden=hidden)]
    for given, value in (("projection", projection), ("parameters", parameters)):
        if value is not None:
            raise InputError(f"{given}: given with views", given, "give it to one of the views")
    several: List[Any] = [views] if isinstance(views, str) else list(views)
    if hidden is not None and any(isinstance(view, (View, Mapping)) for view in several):
        raise InputError("hidden: given with a view", "hidden", "give it to the view")
    return several if hidden is None else [View(view, hidden=hidden) for view in several]


def _sheets_of(sheet: Union[Sheet, Mapping[str, Any], None], size: Optional[str], scale: Union[str, float, None],
               title: Optional[str]) -> List[Mapping[str, Any]]:
    if not isinstance(sheet, (Sheet, Mapping, type(None))):
        raise InputError(f"sheet: is {sheet!r}", "sheet", 'give an epura.Sheet; size="A4" sets the size alone')
    values = dict(fields_of(sheet) if isinstance(sheet, Sheet) else sheet or {})
    values.update({key: value for key, value in (("size", size), ("scale", scale)) if value is not None})
    if title is not None:
        values["title_block"] = {**values.get("title_block", {}), "title": title}
    return [values] if values else []
