# SPDX-License-Identifier: Apache-2.0
"""Scenes of plain values."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from . import _models, _parts
from ._values import Node, fields_of, node
from .projection import Projection, is_projection

#: The lists of a scene whose key in scene files is not their name without s.
_SINGULAR = {"explosions": "explode", "revolved": "revolved", "accepted": "accepted"}


@dataclass
class Scene:
    """Everything that is drawn. Members are lists of the classes of this module, or of dictionaries with their options;
    docs/scenes.md describes them all.

    `models`: `Model`, or anything that is its source. `views`: `View`, or names of projections; one isometric view by
    default. `all_sheets`: options of every sheet.
    """

    models: Sequence[Any] = ()
    views: Sequence[Any] = ()
    styles: Sequence[Any] = ()
    sections: Sequence[Any] = ()
    details: Sequence[Any] = ()
    broken_outs: Sequence[Any] = ()
    revolved: Sequence[Any] = ()
    explosions: Sequence[Any] = ()
    dimensions: Sequence[Any] = ()
    threads: Sequence[Any] = ()
    notes: Sequence[Any] = ()
    tolerance_frames: Sequence[Any] = ()
    datums: Sequence[Any] = ()
    surface_textures: Sequence[Any] = ()
    requirements: Sequence[Any] = ()
    accepted: Sequence[Any] = ()
    tables: Sequence[Any] = ()
    revisions: Sequence[Any] = ()
    parts_list: Optional[Any] = None
    sheets: Sequence[Any] = ()
    all_sheets: Optional[Any] = None
    title_block: Optional[Mapping[str, Any]] = None


def _view(view: Any, classes: List[Projection]) -> Mapping[str, Any]:
    """Classes of projections become their names."""
    values: Dict[str, Any] = {}
    if isinstance(view, _parts.View):
        values = dict(fields_of(view))
    elif isinstance(view, Mapping):
        values = dict(view)
    else:
        values = {"projection": view}
    projection: Any = values.get("projection")
    if is_projection(projection):
        classes.append(projection)
        values["projection"] = projection.name
    elif isinstance(projection, Mapping) and is_projection(projection.get("name")):
        classes.append(projection["name"])
        values["projection"] = {**projection, "name": projection["name"].name}
    return values


def described(scene: Scene) -> Tuple[Node, List[Dict[str, Any]], List[Projection]]:
    """The scene in the words of scene files, models in memory, and classes of projections in it."""
    tables: List[Node] = []
    sources: List[Dict[str, Any]] = []
    classes: List[Projection] = []
    for member in fields(scene):
        value = getattr(scene, member.name)
        if value is None or (isinstance(value, Sequence) and not value):
            continue
        key = member.name
        if key == "models":
            value = []
            for number, model in enumerate(scene.models):
                values, source = _models.described(model, number, len(scene.models))
                value.append(values)
                if source is not None:
                    sources.append(source)
        elif key == "views":
            value = [_view(view, classes) for view in scene.views]
        if key not in ("parts_list", "all_sheets", "title_block"):
            key = _SINGULAR.get(key, key[:-1])
        tables.append(node(key, member.name, value))
    return ("", "scene", tuple(tables)), sources, classes


__all__ = ["Scene", "described"]
