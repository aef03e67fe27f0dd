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
from ._options import Options, dimensions_of, parted, section_of
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
    dimensions: Any = None,
    arrangement: Optional[str] = None,
    section: Any = None,
    explode: Optional[float] = None,
    parts_list: bool = False,
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
    **options: Any,
) -> Drawing:
    """Draws a `Scene`, a scene file (.toml), or one model: whatever `Model` takes, or vertices (n, 3) with faces.

    Of one model: `projection` is its view, by default isometric, and "auto" with automatic dimensions or `pmi`, with
    `parameters` (`epura plugins NAME`); `views` are several instead. `hidden`: style of hidden lines; `size` of the
    paper, such as "A4"; `scale`: mm on paper per mm, or "1:2"; `title`; `sheet`: other options of the sheet;
    `dimensions`: "overall", "auto" or "hole-table", or a list, with `arrangement`; `section` of a single view:
    "0,0,10:0,-1,0", or a Section; `explode`: a factor; `parts_list`; and all options of `View`, `Sheet` and `Model`,
    and fields of the title block, by their names: `edges=["contour"]`, `angle="third"`, `unit="in"`, `owner="Works"`.

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
              "scale": scale, "title": title, "sheet": sheet, "dimensions": dimensions, "arrangement": arrangement,
              "section": section, "explode": explode, "parts_list": parts_list or None, **options}
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
        if isinstance(model, Scene):
            scene = model
        else:
            parts = parted(options, [*(name for name in of_one if name not in options), *settings])
            has_sizes = dimensions in ("auto", "hole-table") or parts.model.get("pmi", "none") != "none"
            scene = Scene(models=[_model_of(model, faces, parts)],
                          views=_views_of(projection, parameters, views, {"hidden": hidden, **parts.view},
                                          "auto" if has_sizes and section is None else "isometric"),
                          sheets=_sheets_of(sheet, {"size": size, "scale": scale, **parts.sheet},
                                            {"title": title, **parts.title_block}),
                          dimensions=dimensions_of(dimensions, arrangement),
                          explosions=[] if explode is None else [{"factor": explode}],
                          parts_list={} if parts_list else None)
            if section is not None:
                _cut(scene, section)
        value, sources, classes = described(scene)
        job = _core.begin(value, sources, settings, tables_of([*projections, *classes]))
    bar = _bar() if progress is True else None
    try:
        return _result_of(job, bar if progress is True or not progress else progress)
    finally:
        if bar is not None:
            bar.close()


def _model_of(model: Any, faces: Any, parts: Options) -> Any:
    if not parts.model:
        return model if faces is None else Model(model, faces)
    if isinstance(model, (Model, Mapping)):
        name = next(iter(parts.model))
        raise InputError(f"{name}: given with a model that has options", name, "give it to the model")
    return Model(model, faces, **parts.model)


def _given(values: Mapping[str, Any]) -> Dict[str, Any]:
    return {key: value for key, value in values.items() if value is not None}


def _views_of(projection: Any, parameters: Optional[Mapping[str, Any]], views: Optional[Sequence[Any]],
              options: Mapping[str, Any], usual: str) -> List[Any]:
    given = _given(options)
    if views is None:
        name = usual if projection is None else projection
        return [View({"name": name, **parameters} if parameters else name, **given)]
    for option, value in (("projection", projection), ("parameters", parameters)):
        if value is not None:
            raise InputError(f"{option}: given with views", option, "give it to one of the views")
    several: List[Any] = views.split(",") if isinstance(views, str) else list(views)
    if given and any(isinstance(view, (View, Mapping)) for view in several):
        name = next(iter(given))
        raise InputError(f"{name}: given with a view", name, "give it to the view")
    return [View(view, **given) for view in several] if given else several


def _cut(scene: Scene, section: Any) -> None:
    """As `--section`: of a single view."""
    if len(scene.views) != 1:
        raise InputError("section: given with several views", "section",
                         'write it to one of them, "front:section=y@20", or draw an epura.Scene')
    cut = section_of(section)
    view = scene.views[0]
    values = dict(fields_of(view) if isinstance(view, View) else view if isinstance(view, Mapping) else
                  {"projection": view})
    scene.sections, scene.views = [cut], [{**values, "section": cut["name"]}]


def _sheets_of(sheet: Union[Sheet, Mapping[str, Any], None], options: Mapping[str, Any],
               fields: Mapping[str, Any]) -> List[Mapping[str, Any]]:
    if not isinstance(sheet, (Sheet, Mapping, type(None))):
        raise InputError(f"sheet: is {sheet!r}", "sheet", 'give an epura.Sheet; size="A4" sets the size alone')
    values = {**(fields_of(sheet) if isinstance(sheet, Sheet) else sheet or {}), **_given(options)}
    if _given(fields):
        values["title_block"] = {**values.get("title_block", {}), **_given(fields)}
    return [values] if values else []
