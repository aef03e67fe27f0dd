# SPDX-License-Identifier: Apache-2.0
"""The options of draw() for one model: the words of the command line, each of which belongs to a part of a scene."""

from __future__ import annotations

import difflib
from dataclasses import dataclass, field, fields
from typing import Any, Dict, List, Mapping, Tuple

from ._errors import InputError
from ._parts import TITLE_FIELDS, ModelOptions, Section, Sheet, View
from ._values import fields_of

#: What draw() takes by itself, or what only a scene can have.
_NOT_OF_VIEW = {"projection", "name", "sheet", "section", "detail"}
_NOT_OF_MODEL = {"name", "drawn"}
_NOT_OF_SHEET = {"title_block"}

#: `--dimensions` in the words of scene files.
_DIMENSIONS: Dict[str, Dict[str, Any]] = {"overall": {"type": "overall"}, "auto": {"type": "auto"},
                                          "hole-table": {"type": "auto", "holes": "table"}}


def _names(part: Any, without: set) -> List[str]:
    return [one.name for one in fields(part) if one.name not in without]


_VIEW = _names(View, _NOT_OF_VIEW)
_MODEL = [name for name in _names(ModelOptions, _NOT_OF_MODEL) if name not in _VIEW]
_SHEET = [name for name in _names(Sheet, _NOT_OF_SHEET) if name not in _VIEW]


@dataclass
class Options:
    """What is given of each part."""

    model: Dict[str, Any] = field(default_factory=dict)
    view: Dict[str, Any] = field(default_factory=dict)
    sheet: Dict[str, Any] = field(default_factory=dict)
    title_block: Dict[str, Any] = field(default_factory=dict)


def known() -> List[str]:
    """All further options, sorted."""
    return sorted({*_VIEW, *_MODEL, *_SHEET, *TITLE_FIELDS})


def parted(options: Mapping[str, Any], others: List[str]) -> Options:
    """Each option with its part. `others` are the names that draw() takes besides. Raises InputError."""
    result = Options()
    parts: List[Tuple[List[str], Dict[str, Any]]] = [(_VIEW, result.view), (_MODEL, result.model),
                                                     (_SHEET, result.sheet), (list(TITLE_FIELDS), result.title_block)]
    for name, value in options.items():
        for names, given in parts:
            if name in names:
                given[name] = value
                break
        else:
            all_names = sorted({*known(), *others})
            near = difflib.get_close_matches(name, all_names, 1)
            raise InputError(f"{name}: is no option of draw()", name,
                             f"did you mean {near[0]!r}?" if near else "known are " + ", ".join(all_names))
    return result


def dimensions_of(dimensions: Any, arrangement: Any) -> List[Any]:
    """The list of a scene for a word of `--dimensions`, or for dimensions."""
    if isinstance(dimensions, str):
        if dimensions not in _DIMENSIONS:
            raise InputError(f"dimensions: is {dimensions!r}", "dimensions",
                             "known are " + ", ".join(_DIMENSIONS) + ", or a list of epura.Dimension")
        return [{**_DIMENSIONS[dimensions], **({} if arrangement is None else {"arrangement": arrangement})}]
    if arrangement is not None:
        raise InputError("arrangement: needs automatic dimensions", "arrangement", 'give dimensions="auto", too')
    if dimensions is None:
        return []
    return list(dimensions) if isinstance(dimensions, (list, tuple)) else [dimensions]


def section_of(section: Any) -> Mapping[str, Any]:
    """A section for "X,Y,Z:NX,NY,NZ", as of `--section`, or for one of a scene."""
    if isinstance(section, Section):
        values = dict(fields_of(section))
    elif isinstance(section, Mapping):
        values = dict(section)
    else:
        try:
            point, normal = ([float(number) for number in part.split(",")] for part in section.split(":"))
            assert len(point) == len(normal) == 3
        except (AttributeError, AssertionError, ValueError):
            raise InputError(f"section: is {section!r}", "section",
                             'give a point and a normal, such as "0,0,10:0,-1,0", or an epura.Section') from None
        values = {"point": point, "normal": normal}
    return {"name": "A", **values}
